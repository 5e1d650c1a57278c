// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Light and dark.
#pragma once

class QApplication;

namespace ameco::gui {

/// The colours of all widgets; applies at once.
void apply_theme(QApplication& application, bool dark);

} // namespace ameco::gui
