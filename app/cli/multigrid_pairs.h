// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What `ameco multigrid` measures between the levels of a hierarchy, as JSON.
#pragma once

#include "core/hierarchy/hierarchy.h"
#include "core/hierarchy/statistics_json.h"
#include "core/multigrid/study.h"

#include <filesystem>

namespace ameco::cli {

/// All levels of a hierarchy, and what connects them.
template <int D>
struct StudyGrids {
    std::vector<Mesh<D>> meshes;
    std::vector<Transfer> transfers;
    std::vector<LevelStructure> structures;
};

/// \throws FileError, InputError, Cancelled
template <int D>
[[nodiscard]] StudyGrids<D> read_study_grids(const Hierarchy& hierarchy,
                                             const std::filesystem::path& folder, Monitor& monitor);

/// Two-grid factors, invariants and the slowest error of the levels k and k + 1.
///
/// \param modes  folder for mode_k.vtu, the slowest error of damped Jacobi; empty: none is written
template <int D>
[[nodiscard]] Json pair_json(const StudyGrids<D>& grids, const LevelEquations& equations,
                             std::size_t k, const std::filesystem::path& modes);

} // namespace ameco::cli
