// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How fast multigrid converges on wings of one family, whose meshes differ in size alone.
#pragma once

#include "core/cases/onera_m6.h"
#include "core/coarsen/coarsen.h"
#include "core/mesh/boundary.h"
#include "core/multigrid/study.h"

namespace ameco {

/// The default wing with half the numbers of cells, and twice the heights.
[[nodiscard]] inline OneraM6Options half_as_fine() {
    OneraM6Options half;
    half.chord_cells /= 2;
    half.span_cells /= 2;
    half.cap_cells /= 2;
    half.layers /= 2;
    half.growth_layers /= 2;
    half.first_height = 8.9e-4;
    half.growth *= half.growth;
    return half;
}

/// With twice the numbers of cells, and half the heights: 528,749 nodes.
[[nodiscard]] inline OneraM6Options twice_as_fine() {
    OneraM6Options twice;
    twice.chord_cells *= 2;
    twice.span_cells *= 2;
    twice.cap_cells *= 2;
    twice.layers *= 2;
    twice.growth_layers *= 2;
    twice.first_height = 1.9e-4;
    twice.growth = 1.1045;
    return twice;
}

/// Iterations of CG with V(2,2) and locally Galerkin matrices, on five coarse levels.
[[nodiscard]] inline int iterations(Mesh<3> mesh) {
    (void)complete_boundary(mesh);
    Level<3> fine = finest_level(std::move(mesh), {});
    std::vector<Mesh<3>> meshes;
    std::vector<Transfer> transfers;
    for (int k = 1; k <= 5; ++k) {
        CoarsenReport report;
        Level<3> coarse = coarsen(fine, {}, report);
        transfers.push_back(make_transfer(fine.mesh, coarse.mesh, coarse.parent));
        meshes.push_back(std::move(fine.mesh));
        fine = std::move(coarse);
    }
    meshes.push_back(std::move(fine.mesh));
    const LevelEquations equations =
        level_equations(meshes, transfers, ModelProblem<3>(), CoarseOperator::local_galerkin);
    CycleOptions options;
    options.before = options.after = 2;
    const Vector load = restricted(unit_load(meshes[0]), equations.unknowns[0]);
    return study_cycle(equations, options, load).krylov.iterations;
}

} // namespace ameco
