// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Light and dark, and what all tables have in common.
#pragma once

class QApplication;
class QTableView;

namespace ameco::gui {

/// The colours of all widgets; applies at once.
void apply_theme(QApplication& application, bool dark);

/// Rows are selected whole; no frame, no grid, no row numbers; Tab leaves the table.
void style_table(QTableView& table);

} // namespace ameco::gui
