// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "core/coarsen/coarsen.h"
#include "core/hierarchy/statistics_json.h"
#include "core/mesh/check_surface.h"

#include <CLI/CLI.hpp>

#include <optional>

namespace ameco::cli {
namespace {

/// All that `check` found out about a mesh.
struct Verification {
    int dimension = 0;
    std::int64_t nodes = 0, elements = 0, faces = 0;
    std::vector<std::string> remarks;
    CheckReport report;
    std::optional<Conformity> natural; ///< absent when the mesh is not valid
    std::optional<Conformity> given;   ///< to the metric of `--metric`
};

Json verification_json(const std::string& file, const Verification& v) {
    Json json = {{"file", file},
                 {"valid", v.report.valid()},
                 {"dimension", v.dimension},
                 {"nodes", v.nodes},
                 {"elements", v.elements},
                 {"boundary_faces", v.faces},
                 {"volume", v.report.volume},
                 {"boundary_flux", v.report.boundary_flux},
                 {"interior_faces", v.report.interior_faces},
                 {"mended", v.remarks},
                 {"errors", to_json(v.report.errors)},
                 {"warnings", to_json(v.report.warnings)}};
    if (v.natural) {
        json["conformity_to_natural_metric"] = to_json(*v.natural);
    }
    if (v.given) {
        json["conformity_to_given_metric"] = to_json(*v.given);
    }
    return json;
}

void print_findings(std::ostream& out, const std::vector<Finding>& findings, const char* kind) {
    for (const Finding& f : findings) {
        out << "  " << kind << ": " << name(f.defect) << ", " << count_text(f.count)
            << (f.count == 1 ? " time: " : " times, first: ") << f.example << '\n';
    }
}

void print_verification(std::ostream& out, const std::string& file, const Verification& v) {
    out << file << ": " << (v.report.valid() ? "valid" : "NOT VALID") << '\n';
    print_findings(out, v.report.errors, "error");
    print_findings(out, v.report.warnings, "warning");
    for (const std::string& remark : v.remarks) {
        out << "  mended: " << remark << '\n';
    }
    Facts facts{{"nodes", count_text(v.nodes)},
                {element_word(v.dimension),
                 v.elements > 0 ? count_text(v.elements) : "none: it is a surface"},
                {"boundary faces", count_text(v.faces)}};
    if (v.report.valid()) {
        facts.emplace_back(v.dimension == 3 ? "volume" : "area", number_text(v.report.volume, 6));
    }
    print_facts(out, facts);
    if (v.natural) {
        out << "in its natural metric\n";
        print_facts(out, conformity_facts(*v.natural));
    }
    if (v.given) {
        out << "in the given metric\n";
        print_facts(out, conformity_facts(*v.given));
    }
}

class CheckCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {"check",
                "Test whether a mesh is valid, and how good it is.",
                "check MESH [--metric METRIC] [options]",
                {{"check wing.meshb", "test every invariant, with exact orientations"},
                 {"check wing.meshb --metric wing.solb", "also measure it in a metric"},
                 {"check wing.meshb -q && echo good", "use the exit code in a script"}},
                "Exit code 3 when the mesh is not valid. Boundary faces that point inwards or are "
                "missing, elements that are all turned, and unused nodes are mended first, as "
                "ameco coarsen does; --strict counts them as errors. A surface without elements is "
                "tested for "
                "being closed, manifold and turned outwards."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("MESH", mesh_, "mesh to test (ameco formats lists the formats)")->required();
        app.add_option("--metric", metric_, "metric at the nodes to measure the mesh in (.solb)")
            ->type_name("METRIC");
        app.add_flag("--strict", strict_, "mend nothing before testing");
    }

    ExitCode run(Session& session) override {
        MeshFile file = load_mesh(mesh_, session, {.surfaces = true});
        const Verification v =
            std::visit([&](auto& mesh) { return verify(mesh, session); }, file.mesh);
        session.monitor.clear_line();
        if (session.json) {
            session.out << verification_json(mesh_, v).dump(2) << '\n';
        } else if (session.verbosity >= 0) {
            print_verification(session.out, mesh_, v);
        } else {
            session.out << mesh_ << ": " << (v.report.valid() ? "valid" : v.report.summary())
                        << '\n';
        }
        return v.report.valid() ? ExitCode::ok : ExitCode::check_failed;
    }

private:
    template <int D>
    Verification verify(Mesh<D>& mesh, Session& session) const {
        Verification v;
        v.dimension = D;
        if constexpr (D == 3) {
            if (mesh.elements.empty()) {
                return verify_surface(mesh);
            }
        }
        if (!strict_) {
            v.remarks = repair_remarks(complete_boundary(mesh, FeatureOptions{}.ridge_angle_deg));
        }
        v.nodes = static_cast<std::int64_t>(mesh.points.size());
        v.elements = static_cast<std::int64_t>(mesh.elements.size());
        v.faces = static_cast<std::int64_t>(mesh.faces.size());
        session.monitor.progress(0.2, "testing");
        v.report = check(mesh);
        if (!v.report.valid()) {
            return v;
        }
        session.monitor.progress(0.5, "measuring");
        v.natural = conformity(mesh, nodal_metric(mesh, CoarsenOptions{}.mean));
        if (!metric_.empty()) {
            v.given = conformity(mesh, load_metric(metric_, mesh, mesh_));
        }
        return v;
    }

    /// A surface without elements.
    static Verification verify_surface(const Mesh<3>& mesh) {
        Verification v;
        v.dimension = 3;
        v.nodes = static_cast<std::int64_t>(mesh.points.size());
        v.faces = static_cast<std::int64_t>(mesh.faces.size());
        v.report = check_surface(mesh);
        return v;
    }

    std::string mesh_;
    std::string metric_;
    bool strict_ = false;
};

} // namespace

std::unique_ptr<Command> make_check_command() {
    return std::make_unique<CheckCommand>();
}

} // namespace ameco::cli
