// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/multigrid_pairs.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "core/base/stop_check.h"
#include "core/hierarchy/hierarchy_folder.h"
#include "core/hierarchy/statistics_json.h"
#include "core/io/atomic_file.h"
#include "core/multigrid/convergence_plot.h"
#include "core/multigrid/matrix_file.h"
#include "core/multigrid/study.h"

#include <CLI/CLI.hpp>
#include <Eigen/Cholesky>

#include <algorithm>

namespace ameco::cli {
namespace {

namespace fs = std::filesystem;

class MultigridCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {"multigrid",
                "Measure how well multigrid converges on a hierarchy.",
                "multigrid DIR [options]",
                {{"multigrid levels", "Poisson's equation, Dirichlet conditions all around"},
                 {"multigrid levels --dirichlet 1 --smoother jacobi", "a wall, another smoother"},
                 {"multigrid levels --velocity 1 0 0", "upwinded convection, with GMRES"},
                 {"multigrid levels --plot convergence.svg --matrices ./petsc",
                  "a picture; matrices for other solvers"}},
                "For each pair of levels: the factor of a two-grid cycle with an exact coarse "
                "solve, what the levels have in common, and the nodes where the error stays. For "
                "the whole hierarchy: the factor of the cycle by itself, and iterations of CG (or "
                "GMRES) to 1e-8 with the cycle as preconditioner."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("DIR", folder_, "folder of the hierarchy")->required();
        app.add_option("--dirichlet", dirichlet_, "patches with Dirichlet conditions [all]")
            ->type_name("PATCH");
        app.add_option("--diffusion", diffusion_,
                       "diffusion along x, y (and z), or the tensor xx xy xz yy yz zz (xx xy yy); "
                       "[1 in every direction]")
            ->type_name("K");
        app.add_option("--velocity", velocity_, "velocity of convection, per unit of diffusion")
            ->type_name("X");
        app.add_option("--smoother", smoother_,
                       "jacobi, gauss-seidel, chebyshev or line [gauss-seidel]")
            ->type_name("NAME")
            ->check(one_of({"jacobi", "gauss-seidel", "chebyshev", "line"}));
        app.add_option(
               "--operator", operator_,
               "coarse matrices: rediscretised, stiffened, local-galerkin (Galerkin's where the "
               "rediscretised ones are too soft) or galerkin [rediscretised]")
            ->type_name("NAME")
            ->check(one_of({"rediscretised", "stiffened", "local-galerkin", "galerkin"}));
        app.add_option("--steps", steps_, "smoothing steps before, and after [1]")
            ->type_name("N")
            ->check(whole_number(1, 20));
        app.add_flag("--w-cycle", w_cycle_, "W-cycle instead of V-cycle");
        app.add_option("--plot", plot_, "picture of the residuals to write (.svg)")
            ->type_name("FILE");
        app.add_option("--matrices", matrices_,
                       "folder for P_k.mtx, and A_k.petsc, P_k.petsc and b.petsc of the unknowns")
            ->type_name("DIR");
        app.add_option("--modes", modes_,
                       "folder for mode_k.vtu: the slowest error of the levels k and k + 1, at the "
                       "nodes of level k")
            ->type_name("DIR");
    }

    ExitCode run(Session& session) override {
        if (!plot_.empty()) {
            require_suffix(plot_, {".svg"});
        }
        const Hierarchy hierarchy = read_hierarchy(folder_);
        if (hierarchy.levels.size() < 2) {
            throw InputError(folder_ + ": has no coarse level: make some with ameco coarsen");
        }
        for (const std::string& folder : {matrices_, modes_}) {
            if (!folder.empty()) {
                create_folder(folder);
            }
        }
        const Json result =
            hierarchy.dimension == 3 ? study<3>(hierarchy, session) : study<2>(hierarchy, session);
        session.monitor.clear_line();
        if (session.json) {
            session.out << result.dump(2) << '\n';
        } else {
            print(session.out, result);
        }
        return ExitCode::ok;
    }

private:
    template <int D>
    [[nodiscard]] ModelProblem<D> problem() const {
        ModelProblem<D> p;
        p.dirichlet_patches = dirichlet_;
        if (!diffusion_.empty()) {
            p.diffusion = diffusion_tensor<D>();
        }
        if (!velocity_.empty()) {
            if (velocity_.size() != D) {
                throw UsageError("--velocity: this hierarchy needs " + std::to_string(D) +
                                 " numbers");
            }
            for (int i = 0; i < D; ++i) {
                p.velocity[i] = velocity_[static_cast<std::size_t>(i)];
            }
        }
        return p;
    }

    template <int D>
    [[nodiscard]] Mat<D> diffusion_tensor() const {
        const std::size_t given = diffusion_.size();
        if (given != D && given != D * (D + 1) / 2) {
            throw UsageError("--diffusion: this hierarchy needs " + std::to_string(D) +
                             " numbers, or " + std::to_string(D * (D + 1) / 2));
        }
        Mat<D> K = Mat<D>::Zero();
        std::size_t next = 0;
        for (int i = 0; i < D; ++i) {
            for (int j = i; j < (given == D ? i + 1 : D); ++j) {
                K(i, j) = K(j, i) = diffusion_[next++];
            }
        }
        if (!K.allFinite() || Eigen::LLT<Mat<D>>(K).info() != Eigen::Success) {
            throw UsageError("--diffusion: the tensor must be positive definite");
        }
        return K;
    }

    [[nodiscard]] CycleOptions cycle() const {
        CycleOptions options;
        for (const SmootherKind kind : {SmootherKind::jacobi, SmootherKind::gauss_seidel,
                                        SmootherKind::chebyshev, SmootherKind::line}) {
            if (name(kind) == smoother_) {
                options.smoother.kind = kind;
            }
        }
        options.before = options.after = steps_;
        options.gamma = w_cycle_ ? 2 : 1;
        return options;
    }

    [[nodiscard]] CoarseOperator coarse_operator() const {
        return *std::find_if(all_coarse_operators.begin(), all_coarse_operators.end(),
                             [&](CoarseOperator kind) { return name(kind) == operator_; });
    }

    template <int D>
    Json study(const Hierarchy& hierarchy, Session& session) const {
        const StudyGrids<D> grids = read_study_grids<D>(hierarchy, folder_, session.monitor);
        LevelEquations equations =
            level_equations(grids.meshes, grids.transfers, problem<D>(), coarse_operator());
        for (std::size_t k = 0; k < grids.meshes.size(); ++k) {
            equations.matrices.lines.push_back(smoother_lines(
                grids.meshes[k], grids.structures[k].couplings, equations.unknowns[k]));
        }
        Json pairs = Json::array();
        for (std::size_t k = 0; k + 1 < grids.meshes.size(); ++k) {
            stop_if_asked(session.monitor);
            session.monitor.progress(0.3 + 0.5 * static_cast<double>(k) /
                                               static_cast<double>(grids.meshes.size()),
                                     "two-grid cycles");
            pairs.push_back(pair_json(grids, equations, k, modes_));
        }
        const Vector load = restricted(unit_load(grids.meshes[0]), equations.unknowns[0]);
        const CycleStudy whole = study_cycle(equations, cycle(), load);
        write_files(equations, grids.transfers, load, whole);
        return {{"folder", folder_},
                {"operator", operator_},
                {"smoother", smoother_},
                {"cycle", (w_cycle_ ? "W(" : "V(") + std::to_string(steps_) + "," +
                              std::to_string(steps_) + ")"},
                {"pairs", pairs},
                {"factor", whole.factor},
                {"krylov", equations.symmetric ? "CG" : "GMRES"},
                {"iterations", whole.krylov.iterations},
                {"converged", whole.krylov.converged},
                {"iterations_random", whole.random_iterations},
                {"residuals", whole.krylov.residuals},
                {"operator_complexity", equations.operator_complexity},
                {"grid_complexity", equations.grid_complexity},
                {"work_per_cycle", whole.work_per_cycle},
                {"assembly_seconds", equations.seconds},
                {"setup_seconds", whole.setup_seconds},
                {"solve_seconds", whole.solve_seconds}};
    }

    void write_files(const LevelEquations& equations, const std::vector<Transfer>& transfers,
                     const Vector& load, const CycleStudy& whole) const {
        if (!plot_.empty()) {
            write_whole_file(
                plot_, convergence_plot({{folder_ + ", " + smoother_, whole.krylov.residuals}}));
        }
        if (matrices_.empty()) {
            return;
        }
        const fs::path folder(matrices_);
        for (std::size_t k = 0; k < equations.matrices.A.size(); ++k) {
            const std::string suffix = "_" + std::to_string(k);
            write_petsc_matrix(folder / ("A" + suffix + ".petsc"), equations.matrices.A[k]);
            if (k < transfers.size()) {
                write_matrix_market(folder / ("P" + suffix + ".mtx"), transfers[k].P);
                write_petsc_matrix(folder / ("P" + suffix + ".petsc"), equations.matrices.P[k]);
            }
        }
        write_petsc_vector(folder / "b.petsc", load);
    }

    static std::string place_text(const Json& point) {
        std::string text;
        for (const Json& x : point) {
            text += (text.empty() ? "(" : ", ") + number_text(x, 6);
        }
        return text + ")";
    }

    static void print(std::ostream& out, const Json& r) {
        Table table(
            {{"levels"}, {"Jacobi(1,1)"}, {"GS(1,1)"}, {"gaps"}, {"lineless"}, {"FF"}, {"G/A"}});
        for (const Json& p : r["pairs"]) {
            const int k = p["fine_level"];
            const Json& v = p["invariants"];
            table.add_row({std::to_string(k) + "-" + std::to_string(k + 1),
                           number_text(p["two_grid_jacobi"], 3),
                           number_text(p["two_grid_gauss_seidel"], 3), count_text(v["gaps"]),
                           count_text(v["lineless_elements"]),
                           number_text(v["removed_coupling"]["worst"], 2),
                           number_text(v["galerkin_ratio"]["worst"], 3)});
        }
        table.print(out);
        out << '\n';
        for (const Json& p : r["pairs"]) {
            // 0.12 is the theoretical 1/9 of layers, and a little.
            if (p["two_grid_jacobi"].get<double>() > 0.12 && p.contains("slowest_error")) {
                const int k = p["fine_level"];
                out << "level " << k << ": "
                    << count_text(p["slowest_error"]["nodes_with_90_percent"])
                    << " nodes carry 90 % of the slowest error\n";
                for (const Json& n : p["slowest_error"]["worst_nodes"]) {
                    out << "  node " << n["node"] << " at " << place_text(n["point"]) << ", "
                        << percent_text(n["share"]) << ": " << n["findings"].get<std::string>()
                        << '\n';
                }
            }
        }
        print_facts(
            out,
            {{"cycle", r["cycle"].get<std::string>() + ", " + r["smoother"].get<std::string>() +
                           ", " + r["operator"].get<std::string>()},
             {"factor", number_text(r["factor"], 3)},
             {"iterations", std::to_string(r["iterations"].get<int>()) + " of " +
                                r["krylov"].get<std::string>() + " to 1e-8" +
                                (r["converged"].get<bool>() ? "" : " (NOT CONVERGED)")},
             {"operator complexity", number_text(r["operator_complexity"], 3)},
             {"grid complexity", number_text(r["grid_complexity"], 3)},
             {"work of a cycle",
              number_text(r["work_per_cycle"], 3) + " products with the finest matrix"},
             {"assembly, set-up, solve", number_text(r["assembly_seconds"], 3) + " s, " +
                                             number_text(r["setup_seconds"], 3) + " s, " +
                                             number_text(r["solve_seconds"], 3) + " s"}});
    }

    std::string folder_;
    std::vector<int> dirichlet_;
    std::vector<double> diffusion_, velocity_;
    std::string smoother_ = "gauss-seidel";
    std::string operator_ = "rediscretised";
    int steps_ = 1;
    bool w_cycle_ = false;
    std::string plot_;
    std::string matrices_, modes_;
};

} // namespace

std::unique_ptr<Command> make_multigrid_command() {
    return std::make_unique<MultigridCommand>();
}

} // namespace ameco::cli
