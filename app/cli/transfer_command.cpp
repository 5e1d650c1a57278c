// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/report.h"
#include "core/hierarchy/statistics_json.h"
#include "core/multigrid/matrix_file.h"
#include "core/multigrid/transfer.h"

#include <CLI/CLI.hpp>

namespace ameco::cli {
namespace {

Json check_json(const TransferCheck& c) {
    return {{"passed", c.passed()},
            {"nested", c.nested},
            {"interpolated", c.interpolated},
            {"projected", c.projected},
            {"row_sum_error", c.row_sum_error},
            {"linear_error", c.linear_error},
            {"smallest_weight", c.smallest_weight},
            {"largest_weight", c.largest_weight},
            {"empty_columns", c.empty_columns},
            {"restriction_sum_error", c.sum_error},
            {"largest_projection", c.largest_projection}};
}

Facts check_facts(const TransferCheck& c) {
    return {{"nodes", count_text(c.nested) + " injected, " + count_text(c.interpolated) +
                          " interpolated, " + count_text(c.projected) + " projected"},
            {"farthest projected", number_text(c.largest_projection)},
            {"row sums", "1 to " + number_text(c.row_sum_error)},
            {"linear functions", "reproduced to " + number_text(c.linear_error)},
            {"weights", number_text(c.smallest_weight) + " to " + number_text(c.largest_weight)},
            {"unused coarse nodes", count_text(c.empty_columns)}};
}

class TransferCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {"transfer",
                "Make the prolongation from a coarse mesh to a fine one.",
                "transfer FINE COARSE -o P",
                {{"transfer wing.meshb coarse/level_1.meshb -o P_0.mtx", "as MatrixMarket text"},
                 {"transfer wing.meshb other.meshb -o P_0.petsc", "for PETSc's MatLoad"}},
                "Row i holds the weights of fine node i at the coarse nodes: linear interpolation "
                "in the coarse element that holds it. Nodes that both meshes have are injected, "
                "nodes outside the coarse domain projected on its boundary. The restriction is the "
                "transpose. Exit code 3 when a check fails: row sums, linear functions, weights, "
                "coarse nodes nobody refers to."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("FINE", fine_, "fine mesh")->required();
        app.add_option("COARSE", coarse_, "coarse mesh of the same domain")->required();
        app.add_option("-o,--output", output_, "matrix to write (.mtx or .petsc)")
            ->required()
            ->type_name("P");
    }

    ExitCode run(Session& session) override {
        require_suffix(output_, {".mtx", ".petsc"});
        refuse_overwriting(fine_, output_);
        refuse_overwriting(coarse_, output_);
        constexpr double ridge_angle_deg = FeatureOptions{}.ridge_angle_deg;
        const ReadyMesh fine = load_valid_mesh(fine_, ridge_angle_deg, session);
        const ReadyMesh coarse = load_valid_mesh(coarse_, ridge_angle_deg, session);
        if (fine.file.mesh.index() != coarse.file.mesh.index()) {
            throw UsageError(coarse_ + ": has another dimension than " + fine_);
        }
        const TransferCheck result = std::visit(
            [&]<int D>(const Mesh<D>& mesh) {
                return write_transfer(mesh, std::get<Mesh<D>>(coarse.file.mesh), session);
            },
            fine.file.mesh);
        session.monitor.clear_line();
        if (session.json) {
            session.out << Json{{"output", output_}, {"check", check_json(result)}}.dump(2) << '\n';
        } else if (session.verbosity >= 0) {
            print_facts(session.out, check_facts(result));
        }
        if (!result.passed()) {
            session.monitor.message(Severity::error, output_ + ": " + result.failures());
        }
        return result.passed() ? ExitCode::ok : ExitCode::check_failed;
    }

private:
    template <int D>
    TransferCheck write_transfer(const Mesh<D>& fine, const Mesh<D>& coarse,
                                 Session& session) const {
        const Transfer transfer = make_transfer(fine, coarse, {}, session.monitor);
        session.monitor.progress(0.8, "writing " + output_);
        write_matrix(output_, transfer.P);
        return ameco::check(transfer, fine, coarse);
    }

    std::string fine_, coarse_, output_;
};

} // namespace

std::unique_ptr<Command> make_transfer_command() {
    return std::make_unique<TransferCommand>();
}

} // namespace ameco::cli
