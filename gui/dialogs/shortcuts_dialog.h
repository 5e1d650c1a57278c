// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The cheat sheet: every shortcut of the window's menus, and what the mouse does.
#pragma once

#include <QDialog>

class QMenuBar;

namespace ameco::gui {

class ShortcutsDialog : public QDialog {
    Q_OBJECT
public:
    /// \param menus  whose actions are listed
    explicit ShortcutsDialog(const QMenuBar& menus, QWidget* parent = nullptr);
};

/// The shortcuts of all actions in the menus, as a table in HTML.
[[nodiscard]] QString shortcuts_html(const QMenuBar& menus);

} // namespace ameco::gui
