// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Small domains with curved walls, for the tests of nodes that are put or move on them.
#pragma once

#include "core/cases/shell.h"
#include "tests/support/layered_cases.h"

namespace ameco::adapt_test {

[[nodiscard]] inline Mesh<3> between_spheres() {
    ShellOptions shell;
    shell.frequency = 4;
    shell.aspect_ratio = 1;
    shell.growth = 1.5;
    shell.far_field = 2;
    shell.displace = 0.2;
    return make_shell(shell);
}

/// Whose ends are planes across the y axis, with circles around them.
[[nodiscard]] inline Mesh<3> between_cylinders() {
    return layered_cases::cylinder(16, 4, {0, 0.4, 0.8});
}

} // namespace ameco::adapt_test
