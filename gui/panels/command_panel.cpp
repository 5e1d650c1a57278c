// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/command_panel.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QToolButton>

namespace ameco::gui {

CommandPanel::CommandPanel(QWidget* parent) : QWidget(parent) {
    text_ = new QPlainTextEdit;
    text_->setReadOnly(true);
    text_->setFrameShape(QFrame::NoFrame);
    text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    text_->setTabChangesFocus(true);
    copy_ = new QToolButton;
    copy_->setText(tr("&Copy"));
    copy_->setToolTip(tr("Copy the command; in a terminal it makes the same levels, byte by byte"));
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(4, 4, 8, 4);
    row->addWidget(text_, 1);
    row->addWidget(copy_, 0, Qt::AlignTop);
    connect(copy_, &QToolButton::clicked, this, &CommandPanel::copy);
}

QString CommandPanel::command() const {
    return text_->toPlainText();
}

void CommandPanel::setCommand(const QString& command) {
    if (command != text_->toPlainText()) {
        text_->setPlainText(command);
    }
    copy_->setEnabled(!command.startsWith(QLatin1Char('#')));
}

void CommandPanel::copy() const {
    QGuiApplication::clipboard()->setText(command());
}

} // namespace ameco::gui
