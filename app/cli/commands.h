// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The makers of the subcommands, one per *_command.cpp.
#pragma once

#include "app/cli/command.h"

namespace ameco::cli {

[[nodiscard]] std::unique_ptr<Command> make_info_command();
[[nodiscard]] std::unique_ptr<Command> make_check_command();
[[nodiscard]] std::unique_ptr<Command> make_surface_command();
[[nodiscard]] std::unique_ptr<Command> make_metric_command();
[[nodiscard]] std::unique_ptr<Command> make_coarsen_command();
[[nodiscard]] std::unique_ptr<Command> make_remesh_command();
[[nodiscard]] std::unique_ptr<Command> make_fill_command();
[[nodiscard]] std::unique_ptr<Command> make_transfer_command();
[[nodiscard]] std::unique_ptr<Command> make_multigrid_command();
[[nodiscard]] std::unique_ptr<Command> make_render_command();
[[nodiscard]] std::unique_ptr<Command> make_report_command();
[[nodiscard]] std::unique_ptr<Command> make_convert_command();
[[nodiscard]] std::unique_ptr<Command> make_formats_command();
[[nodiscard]] std::unique_ptr<Command> make_case_command();
[[nodiscard]] std::unique_ptr<Command> make_window_command();

/// Whether there is a screen to open a window on, as far as the environment tells.
[[nodiscard]] bool has_display();

} // namespace ameco::cli
