// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/hierarchy_panel.h"

#include "gui/model/document.h"
#include "gui/model/level_table_model.h"
#include "gui/theme.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

namespace ameco::gui {

HierarchyPanel::HierarchyPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
    model_ = new LevelTableModel(document, this);
    table_ = new QTableView;
    table_->setModel(model_);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    style_table(*table_);
    table_->setAlternatingRowColors(true);
    table_->setAccessibleName(tr("Levels"));
    remove_ = new QToolButton;
    remove_->setText(tr("&Delete level"));
    remove_->setToolTip(tr("Delete the level and all made from it"));
    auto* const copy = new QToolButton;
    copy->setText(tr("Cop&y table"));
    auto* const tools = new QHBoxLayout;
    tools->setContentsMargins(8, 2, 8, 4);
    tools->addWidget(remove_);
    tools->addWidget(copy);
    tools->addStretch(1);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(table_, 1);
    column->addLayout(tools);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& row) {
                if (row.isValid()) {
                    document_.setCurrent(model_->idOf(row.row()));
                }
            });
    connect(model_, &QAbstractItemModel::modelReset, this, &HierarchyPanel::showCurrent);
    connect(&document, &Document::currentChanged, this, &HierarchyPanel::showCurrent);
    connect(remove_, &QToolButton::clicked, this, &HierarchyPanel::removeCurrent);
    connect(copy, &QToolButton::clicked, this, &HierarchyPanel::copy);
    showCurrent();
}

void HierarchyPanel::showCurrent() {
    const CaseLevel* const current = document_.current();
    remove_->setEnabled(current != nullptr && current->number > 0);
    const int row = current != nullptr ? model_->rowOf(current->id) : -1;
    if (row >= 0 && table_->currentIndex().row() != row) {
        table_->selectRow(row);
    }
}

void HierarchyPanel::removeCurrent() {
    if (const CaseLevel* const current = document_.current()) {
        document_.remove(current->id);
    }
}

void HierarchyPanel::copy() const {
    QString text;
    const auto add = [&](int column, const QVariant& cell) {
        text += cell.toString().trimmed();
        text += column + 1 < model_->columnCount() ? QLatin1Char('\t') : QLatin1Char('\n');
    };
    for (int c = 0; c < model_->columnCount(); ++c) {
        add(c, model_->headerData(c, Qt::Horizontal, Qt::DisplayRole));
    }
    for (int r = 0; r < model_->rowCount(); ++r) {
        for (int c = 0; c < model_->columnCount(); ++c) {
            add(c, model_->data(model_->index(r, c), Qt::DisplayRole));
        }
    }
    QGuiApplication::clipboard()->setText(text);
}

} // namespace ameco::gui
