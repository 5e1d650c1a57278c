// SPDX-License-Identifier: AGPL-3.0-or-later
/// Multigrid on our hierarchy beside BoomerAMG, on the same matrix in the same run:
///
///     amg_bench CASE [name=value ...] [levels=5]
///     amg_bench mesh=FILE [levels=5]
///
/// Poisson's equation with f = 1 and Dirichlet conditions on the whole boundary; the same conjugate
/// gradients to |b - A x| <= 1e-8 |b|, only the preconditioner differs. One process, and one thread
/// from the preconditioner's set-up on.
#include "core/base/stopwatch.h"
#include "core/cases/cases.h"
#include "core/io/io.h"
#include "core/mesh/boundary.h"
#include "core/multigrid/study.h"
#include "tests/core/multigrid/grids.h"

#include <cstdio>
#include <map>
#include <numeric>
#include <string>

#include <HYPRE.h>
#include <HYPRE_parcsr_ls.h>
#include <_hypre_parcsr_ls.h>

using namespace ameco;

namespace {

struct Row {
    std::string coarse, smoothing;
    std::size_t levels = 0;
    double complexity = 0, setup_seconds = 0, solve_seconds = 0;
    KrylovResult krylov;
};

/// \throws std::runtime_error
void demand(HYPRE_Int error, const char* call) {
    if (error != 0) {
        throw std::runtime_error(std::string("hypre: ") + call + " fails with error " +
                                 std::to_string(error));
    }
}

void print_header() {
    std::printf("| coarse levels | smoothing | levels | operator complexity | CG iterations | "
                "set-up [s] | solve [s] |\n|---|---|---|---|---|---|---|\n");
}

void print(const Row& row) {
    std::printf("| %s | %s | %zu | %.2f | %d%s | %.2f | %.2f |\n", row.coarse.c_str(),
                row.smoothing.c_str(), row.levels, row.complexity, row.krylov.iterations,
                row.krylov.converged ? "" : " (not converged)", row.setup_seconds,
                row.solve_seconds);
    std::fflush(stdout);
}

/// What the smoother of BoomerAMG does in one visit before, and again after the coarse correction.
enum class Relaxation {
    one_way,  ///< Gauss-Seidel forward before, backward after, as in our V(1,1)
    symmetric ///< hybrid symmetric Gauss-Seidel: forward and backward, before and after
};

struct BoomerOptions {
    double threshold = 0.25;
    Relaxation relaxation = Relaxation::symmetric;
    int sweeps = 1;
};

/// One V-cycle of BoomerAMG from zero, as a preconditioner.
class Boomer {
public:
    Boomer(const SparseMatrix& A, const BoomerOptions& options) : n_(A.rows()) {
        const int last = static_cast<int>(n_) - 1;
        HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, last, 0, last, &A_);
        HYPRE_IJMatrixSetObjectType(A_, HYPRE_PARCSR);
        std::vector<int> rows(static_cast<std::size_t>(n_)), lengths(rows.size());
        std::iota(rows.begin(), rows.end(), 0);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            lengths[i] = A.outerIndexPtr()[i + 1] - A.outerIndexPtr()[i];
        }
        HYPRE_IJMatrixSetRowSizes(A_, lengths.data());
        HYPRE_IJMatrixInitialize(A_);
        HYPRE_IJMatrixSetValues(A_, static_cast<int>(n_), lengths.data(), rows.data(),
                                A.innerIndexPtr(), A.valuePtr());
        HYPRE_IJMatrixAssemble(A_);
        demand(HYPRE_IJMatrixGetObject(A_, reinterpret_cast<void**>(&csr_)), "the matrix");
        for (auto* v : {&b_, &x_}) {
            HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, last, v);
            HYPRE_IJVectorSetObjectType(*v, HYPRE_PARCSR);
            HYPRE_IJVectorInitialize(*v);
            HYPRE_IJVectorAssemble(*v);
        }
        demand(HYPRE_IJVectorGetObject(b_, reinterpret_cast<void**>(&b_csr_)), "a vector");
        demand(HYPRE_IJVectorGetObject(x_, reinterpret_cast<void**>(&x_csr_)), "a vector");
        configure(options);
    }
    Boomer(const Boomer&) = delete;
    Boomer& operator=(const Boomer&) = delete;
    ~Boomer() {
        HYPRE_BoomerAMGDestroy(solver_);
        HYPRE_IJVectorDestroy(x_);
        HYPRE_IJVectorDestroy(b_);
        HYPRE_IJMatrixDestroy(A_);
    }

    /// \throws std::runtime_error
    void set_up() { demand(HYPRE_BoomerAMGSetup(solver_, csr_, b_csr_, x_csr_), "set-up"); }

    /// \throws std::runtime_error
    [[nodiscard]] Vector cycle(const Vector& r) const {
        std::copy_n(r.data(), n_, values(b_csr_));
        std::fill_n(values(x_csr_), n_, 0.0);
        demand(HYPRE_BoomerAMGSolve(solver_, csr_, b_csr_, x_csr_), "the cycle");
        return Vector::Map(values(x_csr_), n_);
    }

    [[nodiscard]] std::size_t levels() const {
        return static_cast<std::size_t>(hypre_ParAMGDataNumLevels(data()));
    }
    [[nodiscard]] double operator_complexity() const {
        double entries = 0;
        for (std::size_t k = 0; k < levels(); ++k) {
            entries += hypre_CSRMatrixNumNonzeros(
                hypre_ParCSRMatrixDiag(hypre_ParAMGDataAArray(data())[k]));
        }
        return entries / hypre_CSRMatrixNumNonzeros(hypre_ParCSRMatrixDiag(csr_));
    }

private:
    static double* values(HYPRE_ParVector v) {
        return hypre_VectorData(hypre_ParVectorLocalVector(v));
    }
    [[nodiscard]] hypre_ParAMGData* data() const {
        return reinterpret_cast<hypre_ParAMGData*>(solver_);
    }

    void configure(const BoomerOptions& options) {
        constexpr int hmis = 10, extended_plus_i = 6, entries_per_row = 4;
        constexpr int forward = 3, backward = 4, hybrid_symmetric = 6, elimination = 9;
        HYPRE_BoomerAMGCreate(&solver_);
        HYPRE_BoomerAMGSetCoarsenType(solver_, hmis);
        HYPRE_BoomerAMGSetInterpType(solver_, extended_plus_i);
        HYPRE_BoomerAMGSetPMaxElmts(solver_, entries_per_row);
        HYPRE_BoomerAMGSetStrongThreshold(solver_, options.threshold);
        HYPRE_BoomerAMGSetNumSweeps(solver_, options.sweeps);
        HYPRE_BoomerAMGSetRelaxOrder(solver_, 0);
        const bool both = options.relaxation == Relaxation::symmetric;
        HYPRE_BoomerAMGSetCycleRelaxType(solver_, both ? hybrid_symmetric : forward, 1);
        HYPRE_BoomerAMGSetCycleRelaxType(solver_, both ? hybrid_symmetric : backward, 2);
        // Where coarsening ends with many rows (on layers, which are then diagonally dominant),
        // hypre smooths instead.
        HYPRE_BoomerAMGSetCycleRelaxType(solver_, elimination, 3);
        HYPRE_BoomerAMGSetTol(solver_, 0);
        HYPRE_BoomerAMGSetMaxIter(solver_, 1);
        HYPRE_BoomerAMGSetPrintLevel(solver_, 0);
    }

    Eigen::Index n_ = 0;
    HYPRE_IJMatrix A_ = nullptr;
    HYPRE_IJVector b_ = nullptr, x_ = nullptr;
    HYPRE_ParCSRMatrix csr_ = nullptr;
    HYPRE_ParVector b_csr_ = nullptr, x_csr_ = nullptr;
    HYPRE_Solver solver_ = nullptr;
};

void run_boomer(const SparseMatrix& A, const Vector& load) {
    for (const Relaxation relaxation : {Relaxation::one_way, Relaxation::symmetric}) {
        for (const double threshold : {0.25, 0.5}) {
            for (const int sweeps : {1, 2}) {
                Boomer boomer(A, {threshold, relaxation, sweeps});
                Row row;
                Stopwatch watch;
                boomer.set_up();
                row.setup_seconds = watch.lap();
                row.krylov = conjugate_gradients(
                    A, load, [&boomer](const Vector& r) { return boomer.cycle(r); });
                row.solve_seconds = watch.lap();
                char text[64];
                std::snprintf(text, sizeof text, "BoomerAMG, threshold %g", threshold);
                row.coarse = text;
                row.smoothing =
                    relaxation == Relaxation::one_way ? "V(n,n), n = " : "symmetric, n = ";
                row.smoothing += std::to_string(sweeps);
                row.levels = boomer.levels();
                row.complexity = boomer.operator_complexity();
                print(row);
            }
        }
    }
}

template <int D>
void run_ours(const grids::Grids<D>& g, const Vector& load, double assembly_seconds) {
    for (const CoarseOperator kind : all_coarse_operators) {
        Stopwatch watch;
        const LevelEquations equations =
            level_equations(g.meshes, g.transfers, ModelProblem<D>(), kind);
        const MultigridMatrices& m = equations.matrices;
        const double equations_seconds = watch.lap();
        for (const int steps : {1, 2}) {
            Row row;
            watch.lap();
            CycleOptions options;
            options.before = options.after = steps;
            const Multigrid solver(m, 0, m.A.size() - 1, options, direct_solver(m.A.back()));
            row.setup_seconds = equations_seconds - assembly_seconds + watch.lap();
            row.krylov = conjugate_gradients(m.A[0], load, as_preconditioner(solver));
            row.solve_seconds = watch.lap();
            row.coarse = name(kind);
            row.smoothing = "V(n,n), n = " + std::to_string(steps);
            row.levels = m.A.size();
            row.complexity = equations.operator_complexity;
            print(row);
        }
    }
}

template <int D>
void run(Mesh<D> mesh, int levels) {
    Stopwatch watch;
    const auto g = grids::coarsened(std::move(mesh), levels);
    const double hierarchy_seconds = watch.lap();
    const auto unknowns = free_nodes(g.meshes[0], ModelProblem<D>());
    const SparseMatrix A = restricted(assemble(g.meshes[0], ModelProblem<D>()), unknowns, unknowns);
    const double assembly_seconds = watch.lap();
    const Vector load = restricted(unit_load(g.meshes[0]), unknowns);
    std::printf("%lld unknowns, %lld entries; hierarchy and prolongations made in %.2f s (not in "
                "the set-up), finest matrix in %.2f s (in no set-up)\n\n",
                static_cast<long long>(A.rows()), static_cast<long long>(A.nonZeros()),
                hierarchy_seconds, assembly_seconds);
    print_header();
    run_ours(g, load, assembly_seconds);
    run_boomer(A, load);
}

int run(const std::map<std::string, std::string>& given) {
    auto parameters = given;
    const auto take = [&](const char* key) {
        const auto node = parameters.extract(key);
        return node ? node.mapped() : std::string();
    };
    const std::string levels = take("levels"), file = take("mesh"), name = take("case");
    auto mesh = file.empty() ? make_case(name, parameters) : read_mesh(file).mesh;
    std::visit(
        [&]<int D>(Mesh<D>& m) {
            complete_boundary(m);
            run(std::move(m), levels.empty() ? 5 : std::stoi(levels));
        },
        mesh);
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    std::map<std::string, std::string> parameters;
    for (int i = 1; i < argc; ++i) {
        const std::string arg = argv[i];
        const auto eq = arg.find('=');
        if (eq == std::string::npos) {
            parameters["case"] = arg;
        } else {
            parameters[arg.substr(0, eq)] = arg.substr(eq + 1);
        }
    }
    MPI_Init(&argc, &argv);
    HYPRE_Init();
    int code = 1;
    try {
        code = run(parameters);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "amg_bench: %s\n", e.what());
    }
    HYPRE_Finalize();
    MPI_Finalize();
    return code;
}
