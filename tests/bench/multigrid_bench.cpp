// SPDX-License-Identifier: AGPL-3.0-or-later
/// Makes a hierarchy and prints how well multigrid converges on it:
///
///     multigrid_bench CASE [name=value ...] [levels=5] [dirichlet=1,2] [worst=5] [full=1]
///     multigrid_bench mesh=FILE [levels=5] ...
///     multigrid_bench cube n=32 nested=1 [levels=2] ...
///
/// `nested=1` makes no hierarchy but takes every other node of the cube in all directions: what an
/// ideal isotropic coarsening reaches. `worst` is the number of nodes printed of the slowest error
/// of each two-grid cycle, `full=1` adds smoothers, W-cycles and convection, `pairs=0` leaves the
/// two-grid cycles out. `skip=2` makes cycles of every second level only; `factor` is that of the
/// sizes from level to level. The rules of the coarsening are changed by nodes, mean, slack,
/// dominance, continuation, passes, reach, later-reach, coupling-bound, layer-bound,
/// direction-bound, held, stiffening, line-stiffening and least-stiffness.
#include "core/base/stopwatch.h"
#include "core/cases/cases.h"
#include "core/coarsen/coarsen.h"
#include "core/io/io.h"
#include "core/mesh/boundary.h"
#include "core/multigrid/study.h"

#include <cstdio>
#include <sstream>

using namespace ameco;

namespace {

template <int D>
struct Grids {
    std::vector<Mesh<D>> meshes;
    std::vector<Transfer> transfers;
    std::vector<LevelStructure> structures;
};

long long whole(std::int64_t value) {
    return value;
}

template <int D>
std::string place(const Vec<D>& x) {
    char text[128];
    if constexpr (D == 3) {
        std::snprintf(text, sizeof text, "(%.6g %.6g %.6g)", x[0], x[1], x[2]);
    } else {
        std::snprintf(text, sizeof text, "(%.6g %.6g)", x[0], x[1]);
    }
    return text;
}

template <int D>
Grids<D> make_grids(Mesh<D> mesh, int levels, const CoarsenOptions& options) {
    Grids<D> grids;
    Stopwatch watch;
    Level<D> fine = finest_level(std::move(mesh), options);
    for (int k = 1; k <= levels; ++k) {
        CoarsenReport report;
        watch.lap();
        Level<D> coarse = coarsen(fine, options, report);
        const double coarsen_seconds = watch.lap();
        grids.transfers.push_back(make_transfer(fine.mesh, coarse.mesh, coarse.parent));
        const double locate_seconds = watch.lap();
        const TransferCheck c = check(grids.transfers.back(), fine.mesh, coarse.mesh);
        std::printf("  level %d: %lld -> %lld nodes, ratio %.3f, %.3f of predicted, in band %.1f "
                    "%%, line nodes "
                    "%lld; coarsen %.2f s, locate %.2f s; projected %lld (farthest %.2g), linear "
                    "error %.1e%s%s\n",
                    k, whole(report.nodes_before), whole(report.nodes_after),
                    static_cast<double>(report.nodes_before) /
                        static_cast<double>(report.nodes_after),
                    static_cast<double>(report.nodes_after) / report.predicted_nodes,
                    100 * report.conformity.in_band, whole(report.line_nodes), coarsen_seconds,
                    locate_seconds, whole(c.projected), c.largest_projection, c.linear_error,
                    c.passed() ? "" : "; TRANSFER CHECK FAILED: ", c.failures().c_str());
        std::fflush(stdout);
        grids.meshes.push_back(std::move(fine.mesh));
        grids.structures.push_back(level_structure(grids.meshes.back()));
        fine = std::move(coarse);
    }
    grids.meshes.push_back(std::move(fine.mesh));
    grids.structures.push_back(level_structure(grids.meshes.back()));
    return grids;
}

template <int D>
void print_invariants(const Grids<D>& g, const LevelEquations& equations, std::size_t k) {
    const auto& unknowns = equations.unknowns[k + 1];
    Vector ratios(static_cast<Eigen::Index>(unknowns.size()));
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        ratios[static_cast<Eigen::Index>(i)] = equations.ratios[k][unknowns[i]];
    }
    const auto v = pair_invariants(g.meshes[k], g.structures[k], g.meshes[k + 1],
                                   g.structures[k + 1], g.transfers[k], ratios, unknowns);
    std::printf("    %zu-%zu  gaps %lld (%lld at ends, longest %.0f at %s), three kept in a row "
                "%lld, lineless %lld (%.4f %%), FF %.2f at %s, K %.1f at %s (%lld above 5), G/A "
                "%.2f at %s (%lld above 2)\n",
                k, k + 1, whole(v.gaps), whole(v.gaps_at_ends), v.longest_gap.value,
                place<D>(v.longest_gap.point).c_str(), whole(v.stuck), whole(v.lineless_elements),
                100 * v.lineless_share, v.ff.value, place<D>(v.ff.point).c_str(),
                v.interpolation.value, place<D>(v.interpolation.point).c_str(),
                whole(v.interpolation_exceeded), v.galerkin_ratio.value,
                place<D>(v.galerkin_ratio.point).c_str(), whole(v.galerkin_exceeded));
}

template <int D>
void print_worst(const Grids<D>& g, const LevelEquations& equations, std::size_t k,
                 const ConvergenceFactor& slow, int count) {
    const Vector diagonal = equations.matrices.A[k].diagonal();
    const auto mode = examine_error(g.meshes[k], g.structures[k], g.transfers[k], slow.slowest,
                                    diagonal, equations.unknowns[k], equations.ratios[k], count);
    std::printf("         slowest error: %lld nodes carry 90 %%\n", whole(mode.carriers));
    for (const auto& n : mode.worst) {
        std::printf("         node %d %s %.1f %% %s%s: gap %d, FF %.2f, interpolated coupling "
                    "%.2f (largest weight %.2f), K %.2f, G/A %.2f: %s\n",
                    n.node.value(), place<D>(n.point).c_str(), 100 * n.share,
                    n.kept ? "kept" : "removed", n.on_line ? ", on a line" : "", n.gap,
                    n.removed_coupling, n.interpolated_coupling, n.largest_weight, n.interpolation,
                    n.galerkin_ratio, n.findings.c_str());
    }
}

/// Two-grid factors of one pair with every kind of coarse matrix, the fine one rediscretised:
/// GS(1,1), the same with steps of least energy, and GS(2,2). Galerkin's is what the coarse space
/// allows.
template <int D>
void print_factors(const Grids<D>& g, LevelEquations equations, const ModelProblem<D>& problem,
                   std::size_t k) {
    const SparseMatrix fine_A = assemble(g.meshes[k], problem);
    const SparseMatrix coarse_A = assemble(g.meshes[k + 1], problem);
    const SparseMatrix& P = g.transfers[k].P;
    const Vector ratios = galerkin_ratios(fine_A, P, coarse_A);
    const std::vector<NodeId>& unknowns = equations.unknowns[k + 1];
    std::printf("         two-grid GS(1,1), with steps of least energy, GS(2,2):");
    for (const CoarseOperator kind : all_coarse_operators) {
        equations.matrices.A[k + 1] = restricted(
            coarse_matrix(kind, g.meshes[k], g.meshes[k + 1], P, fine_A, coarse_A, ratios, problem),
            unknowns, unknowns);
        const Solver coarse = exact_solver(equations, k + 1);
        const CycleOptions once, twice{{}, 2, 2};
        std::printf("  %s %.3f %.3f %.3f", std::string(name(kind)).c_str(),
                    two_grid(equations, k, once, coarse).value,
                    two_grid(equations, k, once, coarse, StepLength::least_energy).value,
                    two_grid(equations, k, twice, coarse).value);
        std::fflush(stdout);
    }
    std::printf("\n");
}

template <int D>
void print_pairs(const Grids<D>& g, const LevelEquations& equations, const ModelProblem<D>& problem,
                 int worst) {
    std::printf("  invariants, and two-grid factors (exact coarse solve)\n");
    for (std::size_t k = 0; k + 1 < g.meshes.size(); ++k) {
        print_invariants(g, equations, k);
        print_factors(g, equations, problem, k);
        CycleOptions options;
        options.smoother.kind = SmootherKind::jacobi;
        const ConvergenceFactor jacobi =
            two_grid(equations, k, options, exact_solver(equations, k + 1));
        std::printf("         two-grid Jacobi(1,1), rediscretised: %.3f\n", jacobi.value);
        if (worst > 0 && jacobi.value > 0.115 && jacobi.slowest.size() > 0) {
            print_worst(g, equations, k, jacobi, worst);
        }
        std::fflush(stdout);
    }
}

void print_cycle(const LevelEquations& equations, const Vector& load, const CycleOptions& options,
                 CoarseOperator kind) {
    const CycleStudy s = study_cycle(equations, options, load);
    // Each iteration of the Krylov method has a product with the finest matrix besides the cycle.
    std::printf("  %-13s %-12s %s(%d,%d)  factor %.3f, %s %2d (f = 1), %2d (random f), operator "
                "complexity %.2f, work %.1f a cycle, %.0f to 1e-8, set-up %.2f s, solve %.2f s\n",
                std::string(name(kind)).c_str(), std::string(name(options.smoother.kind)).c_str(),
                options.gamma == 1 ? "V" : "W", options.before, options.after, s.factor,
                equations.symmetric ? "CG" : "GMRES", s.krylov.iterations, s.random_iterations,
                equations.operator_complexity, s.work_per_cycle,
                s.krylov.iterations * (s.work_per_cycle + 1), s.setup_seconds, s.solve_seconds);
    std::fflush(stdout);
}

template <int D>
void print_cycles(const Grids<D>& g, const ModelProblem<D>& problem, bool full) {
    for (const CoarseOperator kind : all_coarse_operators) {
        LevelEquations equations = level_equations(g.meshes, g.transfers, problem, kind);
        for (std::size_t k = 0; k < g.meshes.size(); ++k) {
            equations.matrices.lines.push_back(
                smoother_lines(g.meshes[k], g.structures[k].couplings, equations.unknowns[k]));
        }
        const Vector load = restricted(unit_load(g.meshes[0]), equations.unknowns[0]);
        for (const SmootherKind smoother : {SmootherKind::gauss_seidel, SmootherKind::jacobi,
                                            SmootherKind::chebyshev, SmootherKind::line}) {
            for (const int gamma : {1, 2}) {
                for (const int steps : {1, 2}) {
                    CycleOptions options{{smoother}, steps, steps, gamma};
                    if (full || (smoother == SmootherKind::gauss_seidel && gamma == 1)) {
                        print_cycle(equations, load, options, kind);
                    }
                }
            }
        }
    }
}

/// The levels 0, n, 2n ..., with the products of the transfers between them.
template <int D>
Grids<D> every(Grids<D> g, std::size_t n) {
    Grids<D> some;
    for (std::size_t k = 0; k < g.meshes.size(); k += n) {
        some.meshes.push_back(std::move(g.meshes[k]));
        some.structures.push_back(std::move(g.structures[k]));
        if (k + n < g.meshes.size()) {
            Transfer transfer = std::move(g.transfers[k]);
            for (std::size_t i = 1; i < n; ++i) {
                transfer.P = SparseMatrix(transfer.P * g.transfers[k + i].P);
            }
            some.transfers.push_back(std::move(transfer));
        }
    }
    return some;
}

/// Cubes of n, n/2, n/4 ... cells a side, each with every other node of the one before in all
/// directions.
template <int D>
Grids<D> every_other_node(std::map<std::string, std::string> parameters, int levels) {
    Grids<D> grids;
    grids.meshes.push_back(std::get<Mesh<D>>(make_case("cube", parameters)));
    parameters["displace"] = "0";
    Mesh<D> regular = std::get<Mesh<D>>(make_case("cube", parameters));
    int n = std::stoi(parameters.at("n"));
    for (int k = 0; k < levels; ++k) {
        n /= 2;
        parameters["n"] = std::to_string(n);
        Mesh<D> coarse = std::get<Mesh<D>>(make_case("cube", parameters));
        const auto parent = match_nodes(regular, coarse);
        regular = coarse;
        const Mesh<D>& fine = grids.meshes.back();
        for (const NodeId v : coarse.points.ids()) {
            coarse.points[v] = fine.points[parent[v]];
        }
        grids.transfers.push_back(make_transfer(fine, coarse, parent));
        std::printf("  level %d: %lld -> %lld nodes\n", k + 1,
                    whole(static_cast<std::int64_t>(fine.points.size())),
                    whole(static_cast<std::int64_t>(coarse.points.size())));
        grids.meshes.push_back(std::move(coarse));
    }
    for (const Mesh<D>& mesh : grids.meshes) {
        grids.structures.push_back(level_structure(mesh));
    }
    return grids;
}

struct RunOptions {
    int levels = 5, worst = 5;
    int skip = 1;
    bool full = false, pairs = true, nested = false;
};

template <int D>
void run(const Grids<D>& g, const ModelProblem<D>& problem, const RunOptions& options) {
    if (options.pairs) {
        const LevelEquations equations =
            level_equations(g.meshes, g.transfers, problem, CoarseOperator::rediscretised);
        std::printf("  grid complexity %.2f\n", equations.grid_complexity);
        print_pairs(g, equations, problem, options.worst);
    }
    print_cycles(g, problem, options.full);
    if (options.full) {
        std::printf("  convection-diffusion, velocity (50, 0 ...)\n");
        ModelProblem<D> convection = problem;
        convection.velocity[0] = 50;
        print_cycles(g, convection, false);
    }
}

} // namespace

int main(int argc, char** argv) {
    std::map<std::string, std::string> parameters;
    std::string name, file;
    RunOptions options;
    std::vector<int> dirichlet;
    CoarsenOptions coarsening;
    const std::map<std::string, double*> number{
        {"factor", &coarsening.target.factor},
        {"slack", &coarsening.target.slack},
        {"dominance", &coarsening.lines.dominance},
        {"continuation", &coarsening.lines.continuation},
        {"least-stiffness", &coarsening.least_stiffness},
        {"held", &coarsening.removal.interpolation.held},
        {"stiffening", &coarsening.lengths.stiffening},
        {"line-stiffening", &coarsening.lengths.line_stiffening},
        {"reach", &coarsening.removal.reach},
        {"later-reach", &coarsening.removal.later_reach},
        {"coupling-bound", &coarsening.removal.coupling_bound},
        {"isotropic-below", &coarsening.target.isotropic_below},
        {"isotropic-coupling", &coarsening.removal.isotropic_coupling},
        {"isotropic-bound", &coarsening.removal.interpolation.isotropic},
        {"crowded", &coarsening.removal.crowded},
        {"deviation", &coarsening.removal.surface.relative_distance},
        {"layer-bound", &coarsening.removal.interpolation.layer},
        {"direction-bound", &coarsening.removal.interpolation.per_direction}};
    for (int i = 1; i < argc; ++i) {
        const std::string arg = argv[i];
        const auto eq = arg.find('=');
        const std::string key = arg.substr(0, eq);
        const std::string value = eq == std::string::npos ? "" : arg.substr(eq + 1);
        if (eq == std::string::npos) {
            name = arg;
        } else if (key == "mesh") {
            file = value;
        } else if (key == "levels") {
            options.levels = std::stoi(value);
        } else if (key == "worst") {
            options.worst = std::stoi(value);
        } else if (key == "full") {
            options.full = value != "0";
        } else if (key == "nested") {
            options.nested = value != "0";
        } else if (key == "pairs") {
            options.pairs = value != "0";
        } else if (key == "skip") {
            options.skip = std::max(1, std::stoi(value));
        } else if (key == "mean") {
            coarsening.mean = mean_from_name(value).value_or(coarsening.mean);
        } else if (key == "nodes") {
            coarsening.nodes = coarse_nodes_from_name(value).value_or(coarsening.nodes);
        } else if (key == "passes") {
            coarsening.passes = std::stoi(value);
        } else if (number.contains(key)) {
            *number.at(key) = std::stod(value);
        } else if (key == "dirichlet") {
            std::stringstream list(value);
            for (std::string item; std::getline(list, item, ',');) {
                dirichlet.push_back(std::stoi(item));
            }
        } else {
            parameters[key] = value;
        }
    }
    try {
        auto mesh = file.empty() ? make_case(name, parameters) : read_mesh(file).mesh;
        std::visit(
            [&]<int D>(Mesh<D>& m) {
                complete_boundary(m);
                ModelProblem<D> problem;
                problem.dirichlet_patches = dirichlet;
                run(options.nested ? every_other_node<D>(parameters, options.levels)
                                   : every(make_grids(std::move(m), options.levels, coarsening),
                                           static_cast<std::size_t>(options.skip)),
                    problem, options);
            },
            mesh);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "multigrid_bench: %s\n", e.what());
        return 1;
    }
    return 0;
}
