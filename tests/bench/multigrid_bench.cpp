// SPDX-License-Identifier: AGPL-3.0-or-later
/// Makes a hierarchy and prints how well multigrid converges on it:
///
///     multigrid_bench CASE [name=value ...] [levels=5] [dirichlet=1,2]
///     multigrid_bench mesh=FILE [levels=5]
#include "core/cases/cases.h"
#include "core/coarsen/coarsen.h"
#include "core/io/io.h"
#include "core/mesh/boundary.h"
#include "core/multigrid/cycle.h"
#include "core/multigrid/model_problem.h"
#include "core/multigrid/random_vector.h"
#include "core/multigrid/transfer.h"

#include <chrono>
#include <cstdio>
#include <sstream>

using namespace ameco;

namespace {

class Stopwatch {
public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return seconds;
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Exact up to roundings: direct where that is cheap, else conjugate gradients with V(2,2).
Solver exact_solver(const MultigridMatrices& m, std::size_t level) {
    constexpr Eigen::Index direct_limit = 15000;
    if (m.A[level].rows() <= direct_limit || level + 1 == m.A.size()) {
        return direct_solver(m.A[level]);
    }
    CycleOptions options;
    options.before = options.after = 2;
    const auto inner =
        std::make_shared<Multigrid>(m, level, m.A.size() - 1, options, direct_solver(m.A.back()));
    return [&m, level, inner](const Vector& b) {
        return conjugate_gradients(m.A[level], b, as_preconditioner(*inner), 1e-11).x;
    };
}

double two_grid(const MultigridMatrices& m, std::size_t k, SmootherKind kind,
                const Solver& coarse) {
    CycleOptions options;
    options.smoother.kind = kind;
    return convergence_factor(m.A[k], Multigrid(m, k, k + 1, options, coarse)).value;
}

void print_hierarchy(const MultigridMatrices& m, const Vector& load, const char* title) {
    for (const int steps : {1, 2}) {
        CycleOptions options;
        options.before = options.after = steps;
        const Multigrid solver(m, 0, m.A.size() - 1, options, direct_solver(m.A.back()));
        const double factor = convergence_factor(m.A[0], solver).value;
        const auto on_load = conjugate_gradients(m.A[0], load, as_preconditioner(solver));
        const auto on_random =
            conjugate_gradients(m.A[0], random_vector(load.size(), 7), as_preconditioner(solver));
        std::printf("  %s GS V(%d,%d): factor %.3f, CG %d (f = 1), %d (random f)\n", title, steps,
                    steps, factor, on_load.iterations, on_random.iterations);
        std::fflush(stdout);
    }
}

template <int D>
void run(Mesh<D> mesh, int levels, const ModelProblem<D>& problem) {
    Stopwatch watch;
    CoarsenOptions options;
    std::vector<Level<D>> hierarchy;
    std::vector<Transfer> transfers;
    hierarchy.push_back(finest_level(std::move(mesh), options));
    for (int k = 1; k <= levels; ++k) {
        CoarsenReport report;
        watch.lap();
        hierarchy.push_back(coarsen(hierarchy.back(), options, report));
        const double coarsen_seconds = watch.lap();
        const auto& fine = hierarchy[hierarchy.size() - 2];
        const auto& coarse = hierarchy.back();
        transfers.push_back(make_transfer(fine.mesh, coarse.mesh, coarse.parent));
        const double locate_seconds = watch.lap();
        const TransferCheck c = check(transfers.back(), fine.mesh, coarse.mesh);
        std::printf("  level %d: %lld -> %lld nodes, ratio %.3f, line nodes %lld; coarsen %.2f s, "
                    "locate %.2f s; projected %lld (farthest %.2g), linear error %.1e%s%s\n",
                    k, static_cast<long long>(report.nodes_before),
                    static_cast<long long>(report.nodes_after),
                    static_cast<double>(report.nodes_before) / report.nodes_after,
                    static_cast<long long>(report.line_nodes), coarsen_seconds, locate_seconds,
                    static_cast<long long>(c.projected), c.largest_projection, c.linear_error,
                    c.passed() ? "" : "; TRANSFER CHECK FAILED: ", c.failures().c_str());
        std::fflush(stdout);
    }
    MultigridMatrices m;
    std::vector<std::vector<NodeId>> unknowns;
    for (const auto& level : hierarchy) {
        unknowns.push_back(free_nodes(level.mesh, problem));
        m.A.push_back(restricted(assemble(level.mesh, problem), unknowns.back(), unknowns.back()));
    }
    for (std::size_t k = 0; k + 1 < hierarchy.size(); ++k) {
        m.P.push_back(restricted(transfers[k].P, unknowns[k], unknowns[k + 1]));
    }
    std::printf("  two-grid, rediscretised: levels, Jacobi(1,1), GS(1,1)\n");
    for (std::size_t k = 0; k + 1 < m.A.size(); ++k) {
        const Solver coarse = exact_solver(m, k + 1);
        std::printf("    %zu-%zu  %.3f  %.3f\n", k, k + 1,
                    two_grid(m, k, SmootherKind::jacobi, coarse),
                    two_grid(m, k, SmootherKind::gauss_seidel, coarse));
        std::fflush(stdout);
    }
    const Vector load = restricted(unit_load(hierarchy[0].mesh), unknowns[0]);
    print_hierarchy(m, load, "rediscretised");
    MultigridMatrices galerkin;
    galerkin.A.push_back(m.A[0]);
    galerkin.P = m.P;
    double entries = static_cast<double>(m.A[0].nonZeros());
    for (const SparseMatrix& P : m.P) {
        const SparseMatrix AP = galerkin.A.back() * P;
        galerkin.A.emplace_back(SparseMatrix(P.transpose()) * AP);
        entries += static_cast<double>(galerkin.A.back().nonZeros());
    }
    print_hierarchy(galerkin, load, "Galerkin");
    std::printf("  Galerkin operator complexity %.2f\n",
                entries / static_cast<double>(m.A[0].nonZeros()));
}

} // namespace

int main(int argc, char** argv) {
    std::map<std::string, std::string> parameters;
    std::string name, file;
    int levels = 5;
    std::vector<int> dirichlet;
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
            levels = std::stoi(value);
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
                run(std::move(m), levels, problem);
            },
            mesh);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "multigrid_bench: %s\n", e.what());
        return 1;
    }
    return 0;
}
