// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"

namespace ameco::cli {

std::vector<std::unique_ptr<Command>> all_commands() {
    std::vector<std::unique_ptr<Command>> commands;
    commands.push_back(make_info_command());
    commands.push_back(make_check_command());
    commands.push_back(make_surface_command());
    commands.push_back(make_metric_command());
    commands.push_back(make_coarsen_command());
    commands.push_back(make_remesh_command());
    commands.push_back(make_fill_command());
    commands.push_back(make_transfer_command());
    commands.push_back(make_multigrid_command());
    commands.push_back(make_render_command());
    commands.push_back(make_report_command());
    commands.push_back(make_convert_command());
    commands.push_back(make_formats_command());
    commands.push_back(make_case_command());
    commands.push_back(make_window_command());
    return commands;
}

} // namespace ameco::cli
