// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// One call of TetGen, as plain data.
#pragma once

#include "core/recovery/boundary_recovery.h"

#include <vector>

namespace ameco {

/// What TetGen made of a surface. Face markers are the number of the given face + 1, others are of
/// no given face.
struct TetgenMesh {
    std::vector<double> points; ///< [3 n]
    std::vector<int> tets;      ///< [4 m]
    std::vector<int> regions;   ///< [m] or empty
    std::vector<int> faces;     ///< [3 k]
    std::vector<int> markers;   ///< [k]
};

/// TetGen's words for the options.
[[nodiscard]] std::string tetgen_switches(const RecoveryOptions& options);

/// Calls TetGen in this very process: it may throw an int, print, crash, or abort.
[[nodiscard]] TetgenMesh run_tetgen(const Mesh<3>& surface, const RecoveryOptions& options,
                                    const std::string& switches);

} // namespace ameco
