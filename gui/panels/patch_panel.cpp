// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/patch_panel.h"

#include "gui/model/patch_model.h"
#include "gui/theme.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

namespace ameco::gui {

PatchPanel::PatchPanel(PatchModel& model, QWidget* parent) : QWidget(parent), model_(model) {
    table_ = new QTableView;
    table_->setModel(&model);
    style_table(*table_);
    table_->horizontalHeader()->setSectionResizeMode(PatchModel::name, QHeaderView::Stretch);
    table_->setAccessibleName(tr("Patches"));
    auto* const all = new QToolButton;
    all->setText(tr("Show &all"));
    auto* const isolate = new QToolButton;
    isolate->setText(tr("&Isolate"));
    isolate->setToolTip(tr("Show the selected patches only"));
    auto* const tools = new QHBoxLayout;
    tools->setContentsMargins(8, 2, 8, 4);
    tools->addWidget(all);
    tools->addWidget(isolate);
    tools->addStretch(1);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(table_, 1);
    column->addLayout(tools);
    connect(all, &QToolButton::clicked, this, &PatchPanel::showAll);
    connect(isolate, &QToolButton::clicked, this, &PatchPanel::isolateSelected);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &PatchPanel::selectionChanged);
}

std::set<int> PatchPanel::selectedPatches() const {
    std::set<int> patches;
    for (const QModelIndex& row : table_->selectionModel()->selectedRows()) {
        patches.insert(model_.patchOf(row.row()));
    }
    return patches;
}

void PatchPanel::isolateSelected() {
    if (const std::set<int> patches = selectedPatches(); !patches.empty()) {
        model_.isolate(patches);
    }
}

void PatchPanel::showAll() {
    model_.setHidden({});
}

void PatchPanel::selectPatch(int patch) {
    if (const int row = model_.rowOf(patch); row >= 0) {
        table_->selectRow(row);
    }
}

} // namespace ameco::gui
