// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/multigrid_pairs.h"

#include "core/base/stop_check.h"
#include "core/hierarchy/hierarchy_folder.h"
#include "core/io/io.h"

namespace ameco::cli {
namespace {

template <int D>
Json place(const WorstPlace<D>& worst) {
    return {{"worst", worst.value},
            {"node", worst.node.value()},
            {"point", std::vector<double>(worst.point.begin(), worst.point.end())}};
}

template <int D>
Json invariants_json(const StudyGrids<D>& grids, const LevelEquations& equations, std::size_t k) {
    const auto& unknowns = equations.unknowns[k + 1];
    Vector ratios(static_cast<Eigen::Index>(unknowns.size()));
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        ratios[static_cast<Eigen::Index>(i)] = equations.ratios[k][unknowns[i]];
    }
    const auto v = pair_invariants(grids.meshes[k], grids.structures[k], grids.meshes[k + 1],
                                   grids.structures[k + 1], grids.transfers[k], ratios, unknowns);
    return {{"line_nodes", v.line_nodes},
            {"gaps", v.gaps},
            {"longest_gap", place(v.longest_gap)},
            {"three_kept_in_a_row", v.stuck},
            {"lineless_elements", v.lineless_elements},
            {"lineless_share", v.lineless_share},
            {"removed_coupling", place(v.ff)},
            {"interpolation_constant", place(v.interpolation)},
            {"galerkin_ratio", place(v.galerkin_ratio)},
            {"galerkin_ratios_above_2", v.galerkin_exceeded}};
}

/// The error, and which nodes the coarse level keeps, for ParaView.
template <int D>
void write_mode(const std::filesystem::path& folder, std::size_t k, const StudyGrids<D>& grids,
                const ErrorMode<D>& mode) {
    std::vector<double> kept(grids.meshes[k].points.size(), 0.0);
    for (const NodeId parent : grids.transfers[k].parent) {
        if (parent.valid()) {
            kept[parent.index()] = 1;
        }
    }
    WriteOptions options;
    options.fields = {{"slowest_error", mode.field.raw()}, {"kept", std::move(kept)}};
    write_mesh(folder / ("mode_" + std::to_string(k) + ".vtu"), grids.meshes[k], options);
}

template <int D>
Json mode_json(const ErrorMode<D>& mode) {
    Json worst = Json::array();
    for (const SlowNode<D>& n : mode.worst) {
        worst.push_back({{"node", n.node.value()},
                         {"point", std::vector<double>(n.point.begin(), n.point.end())},
                         {"share", n.share},
                         {"findings", n.findings}});
    }
    return {{"nodes_with_90_percent", mode.carriers}, {"worst_nodes", worst}};
}

} // namespace

template <int D>
StudyGrids<D> read_study_grids(const Hierarchy& hierarchy, const std::filesystem::path& folder,
                               Monitor& monitor) {
    StudyGrids<D> grids;
    const auto count = hierarchy.levels.size();
    for (std::size_t k = 0; k < count; ++k) {
        monitor.progress(0.3 * static_cast<double>(k) / static_cast<double>(count),
                         "reading levels, locating nodes");
        grids.meshes.push_back(read_level_mesh<D>(folder, hierarchy, static_cast<int>(k)));
        grids.structures.push_back(level_structure(grids.meshes[k]));
        if (k > 0) {
            grids.transfers.push_back(make_transfer(grids.meshes[k - 1], grids.meshes[k]));
        }
        stop_if_asked(monitor);
    }
    return grids;
}

template <int D>
Json pair_json(const StudyGrids<D>& grids, const LevelEquations& equations, std::size_t k,
               const std::filesystem::path& modes) {
    const Solver coarse = exact_solver(equations, k + 1);
    CycleOptions options;
    const double gauss_seidel = two_grid(equations, k, options, coarse).value;
    options.smoother.kind = SmootherKind::jacobi;
    const ConvergenceFactor jacobi = two_grid(equations, k, options, coarse);
    Json json = {{"fine_level", k},
                 {"two_grid_jacobi", jacobi.value},
                 {"two_grid_gauss_seidel", gauss_seidel},
                 {"invariants", invariants_json(grids, equations, k)}};
    if (jacobi.slowest.size() > 0) {
        const ErrorMode<D> mode = examine_error(
            grids.meshes[k], grids.structures[k], grids.transfers[k], jacobi.slowest,
            Vector(equations.matrices.A[k].diagonal()), equations.unknowns[k], equations.ratios[k]);
        json["slowest_error"] = mode_json(mode);
        if (!modes.empty()) {
            write_mode(modes, k, grids, mode);
        }
    }
    return json;
}

template StudyGrids<2> read_study_grids(const Hierarchy&, const std::filesystem::path&, Monitor&);
template StudyGrids<3> read_study_grids(const Hierarchy&, const std::filesystem::path&, Monitor&);
template Json pair_json(const StudyGrids<2>&, const LevelEquations&, std::size_t,
                        const std::filesystem::path&);
template Json pair_json(const StudyGrids<3>&, const LevelEquations&, std::size_t,
                        const std::filesystem::path&);

} // namespace ameco::cli
