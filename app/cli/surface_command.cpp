// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "app/cli/surface_words.h"
#include "core/base/stopwatch.h"
#include "core/surface/boundary_surface.h"
#include "core/surface/surface_distance.h"
#include "core/surface/surface_features.h"
#include "core/surface/surface_repair.h"

#include <CLI/CLI.hpp>

#include <optional>

namespace ameco::cli {
namespace {

Json distance_json(const DirectedDistance& d) {
    return {{"at_least", d.lower},
            {"at_most", d.upper},
            {"at", {d.at[0], d.at[1], d.at[2]}},
            {"converged", d.converged}};
}

std::string distance_text(const DirectedDistance& d) {
    std::string at;
    for (int i = 0; i < 3; ++i) {
        at += (i == 0 ? "" : " ") + number_text(d.at[i], 6);
    }
    return number_text(d.lower, 6) + " .. " + number_text(d.upper, 6) + ", at " + at +
           (d.converged ? "" : " (stopped before the tolerance was reached)");
}

class SurfaceCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {
            "surface",
            "Describe a surface, test whether it bounds a volume, mend it.",
            "surface FILE [--repair -o OUT] [options]",
            {{"surface wing.stl", "parts, genus, features, and every defect with its place"},
             {"surface wing.stl --repair -o wing.mesh", "mend what can be mended without loss"},
             {"surface wing.stl --segment -o wing.mesh", "patches from sharp edges"},
             {"surface coarse.mesh --distance wing.stl", "two-sided Hausdorff distance"}},
            "Exit code 3 when the surface is not closed, not manifold, not turned outwards, or "
            "intersects itself. Nodes and faces are numbered from 0. Of a mesh with elements the "
            "boundary is taken. --repair merges nodes at the same point, leaves out faces that are "
            "there twice, flips edges at faces without area, and turns faces; holes, edges of more "
            "than two faces and intersections are refused with exit code 5."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("FILE", file_, "surface, or mesh whose boundary is meant")->required();
        app.add_flag("--repair", repair_, "mend without moving a point; needs -o");
        app.add_flag("--segment", segment_,
                     "give each part between sharp edges a patch of its own; needs -o");
        app.add_option("-o,--output", output_, "surface to write")->type_name("OUT");
        app.add_option("--distance", other_, "measure the distance to this surface, both ways")
            ->type_name("OTHER");
        app.add_option("--tolerance", tolerance_,
                       "error allowed in the distance, over the diagonal of the box around FILE")
            ->check(greater_than(0))
            ->capture_default_str();
        app.add_option("--ridge-angle", features_.ridge_angle_deg,
                       "edges whose faces turn by more are ridges [deg]")
            ->check(number_within(0, 180))
            ->capture_default_str();
        app.add_flag("!--no-intersections", intersections_, "do not look for faces that intersect");
    }

    ExitCode run(Session& session) override {
        check_usage();
        Mesh<3> surface = load_surface(file_, session);
        Json json = {{"file", file_}};
        std::vector<std::string> remarks;
        if (repair_) {
            session.monitor.progress(0.1, "mending");
            remarks = repair_remarks(repair_surface(surface));
            json["mended"] = remarks;
        }
        if (segment_) {
            segment_by_angle(surface, features_.ridge_angle_deg);
        }
        session.monitor.progress(0.2, "testing");
        const SurfaceReport report = inspect_surface(surface, intersections_);
        json.update(surface_json(report));
        const SurfaceFeatures features = find_surface_features(surface, features_);
        json["features"] = features_json(surface, features);
        std::optional<SurfaceDistance> distance;
        if (!other_.empty()) {
            distance = measure_distance(surface, report, session);
            json["distance"] = {{"there", distance_json(distance->there)},
                                {"back", distance_json(distance->back)}};
        }
        if (!output_.empty()) {
            if (repair_) {
                require_sound_surface(report, file_);
            }
            session.monitor.progress(0.9, "writing " + output_);
            for (const std::string& loss : write_mesh(output_, surface)) {
                session.monitor.message(Severity::warning, output_ + ": " + loss);
            }
        }
        session.monitor.clear_line();
        if (session.json) {
            session.out << json.dump(2) << '\n';
        } else if (session.verbosity >= 0) {
            print_surface(session.out, file_, report, remarks);
            print_facts(session.out, features_facts(surface, features));
            if (distance) {
                print_facts(session.out, {{"distance to " + other_, distance_text(distance->there)},
                                          {"and back", distance_text(distance->back)}});
            }
        } else {
            session.out << file_ << ": " << (report.sound() ? "sound" : "NOT SOUND") << '\n';
        }
        return report.sound() ? ExitCode::ok : ExitCode::check_failed;
    }

private:
    void check_usage() const {
        if ((repair_ || segment_) == output_.empty()) {
            throw UsageError(output_.empty()
                                 ? "--repair and --segment make a surface: name it with -o OUT"
                                 : "-o: nothing to write without --repair or --segment (ameco "
                                   "convert changes the format)");
        }
        if (!output_.empty()) {
            refuse_overwriting(file_, output_);
        }
    }

    SurfaceDistance measure_distance(const Mesh<3>& surface, const SurfaceReport& report,
                                     Session& session) const {
        const Mesh<3> other = load_surface(other_, session);
        static_cast<void>(inspect_surface(other, false)); // refuses numbers that make no sense
        session.monitor.progress(0.5, "measuring the distance");
        return surface_distance(surface, other, tolerance_ * report.diagonal());
    }

    std::string file_, output_, other_;
    bool repair_ = false, segment_ = false, intersections_ = true;
    double tolerance_ = 1e-5;
    SurfaceFeatureOptions features_;
};

} // namespace

std::unique_ptr<Command> make_surface_command() {
    return std::make_unique<SurfaceCommand>();
}

} // namespace ameco::cli
