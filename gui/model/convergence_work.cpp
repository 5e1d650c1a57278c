// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/model/convergence_work.h"

#include "core/base/stop_check.h"
#include "core/multigrid/invariants.h"
#include "core/multigrid/study.h"
#include "core/multigrid/transfer.h"

namespace ameco::gui {
namespace {

void go_on(Monitor& monitor, double fraction, const std::string& step) {
    stop_if_asked(monitor);
    monitor.progress(fraction, step);
}

template <int D>
LevelEquations equations_of(const std::vector<CaseLevel>& branch, Monitor& monitor, Vector& load) {
    std::vector<Mesh<D>> meshes;
    std::vector<Transfer> transfers;
    for (const CaseLevel& l : branch) {
        const Level<D>& level = std::get<Level<D>>(*l.level);
        go_on(monitor, 0.4 * l.number / static_cast<double>(branch.size()), "locating nodes");
        if (!meshes.empty()) {
            transfers.push_back(make_transfer(meshes.back(), level.mesh, level.parent, monitor));
        }
        meshes.push_back(level.mesh);
    }
    go_on(monitor, 0.4, "assembling matrices");
    LevelEquations equations =
        level_equations(meshes, transfers, ModelProblem<D>(), CoarseOperator::rediscretised);
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        equations.matrices.lines.push_back(
            smoother_lines(meshes[k], make_couplings(meshes[k]), equations.unknowns[k]));
    }
    load = restricted(unit_load(meshes[0]), equations.unknowns[0]);
    return equations;
}

} // namespace

std::vector<ConvergenceCurve> measure_convergence(const std::vector<CaseLevel>& branch,
                                                  Monitor& monitor) {
    Vector load;
    const LevelEquations equations = std::holds_alternative<Level<3>>(*branch.front().level)
                                         ? equations_of<3>(branch, monitor, load)
                                         : equations_of<2>(branch, monitor, load);
    std::vector<ConvergenceCurve> curves;
    for (const SmootherKind kind : {SmootherKind::jacobi, SmootherKind::gauss_seidel}) {
        go_on(monitor, kind == SmootherKind::jacobi ? 0.6 : 0.8,
              "solving with " + std::string(name(kind)));
        CycleOptions options;
        options.smoother.kind = kind;
        curves.push_back({"CG, V(1,1), " + std::string(name(kind)),
                          study_cycle(equations, options, load).krylov.residuals});
    }
    return curves;
}

} // namespace ameco::gui
