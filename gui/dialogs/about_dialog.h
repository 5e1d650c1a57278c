// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the program is, whose it is, and what it is made with.
#pragma once

#include <QDialog>

namespace ameco::gui {

class AboutDialog : public QDialog {
    Q_OBJECT
public:
    explicit AboutDialog(QWidget* parent = nullptr);
};

} // namespace ameco::gui
