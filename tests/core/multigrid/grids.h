// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Small hierarchies for the tests of multigrid.
#pragma once

#include "core/cases/cases.h"
#include "core/coarsen/coarsen.h"
#include "core/multigrid/transfer.h"

#include <vector>

namespace ameco::grids {

template <int D>
struct Grids {
    std::vector<Mesh<D>> meshes;
    std::vector<Transfer> transfers;
    std::vector<IdVector<NodeId, NodeId>> parents; ///< of the coarser level's nodes
};

/// The case "layer" with values by parameter name.
template <int D>
Mesh<D> layer(std::map<std::string, std::string> parameters) {
    parameters["dim"] = std::to_string(D);
    return std::get<Mesh<D>>(make_case("layer", parameters));
}

template <int D>
Grids<D> coarsened(Mesh<D> mesh, int levels, const CoarsenOptions& options = {}) {
    Grids<D> grids;
    Level<D> fine = finest_level(std::move(mesh), options);
    for (int k = 0; k < levels; ++k) {
        CoarsenReport report;
        Level<D> coarse = coarsen(fine, options, report);
        grids.transfers.push_back(make_transfer(fine.mesh, coarse.mesh, coarse.parent));
        grids.parents.push_back(coarse.parent);
        grids.meshes.push_back(std::move(fine.mesh));
        fine = std::move(coarse);
    }
    grids.meshes.push_back(std::move(fine.mesh));
    return grids;
}

} // namespace ameco::grids
