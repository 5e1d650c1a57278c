// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The command that makes on a terminal what the window shows.
#pragma once

#include <QWidget>

class QPlainTextEdit;
class QToolButton;

namespace ameco::gui {

class CommandPanel : public QWidget {
    Q_OBJECT
public:
    explicit CommandPanel(QWidget* parent = nullptr);

    [[nodiscard]] QString command() const;
    void setCommand(const QString& command);

public slots:
    void copy() const;

private:
    QPlainTextEdit* text_;
    QToolButton* copy_;
};

} // namespace ameco::gui
