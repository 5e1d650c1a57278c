// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/metric_fill.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "app/cli/surface_words.h"
#include "core/hierarchy/statistics_json.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace ameco::cli {
namespace {

class FillCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {
            "fill",
            "Fill a closed surface, or the space around it, with tets.",
            "fill SURFACE -o MESH [options]",
            {{"fill wing.stl -o wing.meshb", "the volume inside"},
             {"fill wing.stl -o wing.meshb --size 0.1", "with tets of at most this size"},
             {"fill wing.stl -o air.meshb --farfield sphere:20", "the space around"},
             {"fill two.mesh -o two.meshb --region 0,0,0:2", "a part that is no hole"}},
            "The outermost parts of the surface hold the volume, parts directly inside them are "
            "walls of cavities, and so on. With --farfield the space around the surface is filled; "
            "the radius is the distance from the middle of the surface (ten times its diagonal if "
            "it is not given). TetGen fills, in a process of its own; its result is checked. A "
            "surface that has open edges, edges of more than two faces, or that intersects itself "
            "is refused with the places named (ameco surface lists all).\n"
            "Numbers: faces closer together than about 1e-14 of the size of the whole are refused "
            "or lost; layers of 1e-9 at coordinates of 1 are not."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("SURFACE", surface_, "closed surface, or mesh whose boundary is meant")
            ->required();
        app.add_option("-o,--output", output_, "mesh to write")->required()->type_name("MESH");
        app.add_option("--size", size_, "largest edge length wanted in the volume")
            ->check(greater_than(0))
            ->type_name("H");
        app.add_option("--metric", metric_,
                       "metric at the surface's nodes; the volume is adapted to it, sizes growing "
                       "with the distance")
            ->type_name("FILE");
        app.add_option("--growth", growth_,
                       "with --metric: how much sizes grow per distance; layers grow by 1 + G")
            ->check(number_within(0, 10))
            ->type_name("G")
            ->capture_default_str();
        app.add_option("--farfield", farfield_,
                       "fill the space around, up to a box or a sphere: box, sphere, box:R, "
                       "sphere:R")
            ->type_name("SHAPE");
        app.add_option("--hole", holes_, "a point in a part that is to stay empty, x,y,z")
            ->type_name("POINT");
        app.add_option("--region", regions_,
                       "a point in a part that is to be filled, and its region: x,y,z:ID or "
                       "x,y,z:ID:H with a size of its own")
            ->type_name("SEED");
        app.add_option("--boundary", boundary_,
                       "keep: the faces are faces of the mesh; split: nodes may be put on them")
            ->check(one_of({"keep", "split"}))
            ->capture_default_str();
        app.add_option("--radius-edge", radius_edge_,
                       "largest circumradius over shortest edge of a tet; 0: only the nodes that "
                       "the boundary needs")
            ->check(number_within(0, 100))
            ->capture_default_str();
    }

    ExitCode run(Session& session) override {
        refuse_overwriting(surface_, output_);
        if (radius_edge_ > 0 && radius_edge_ < least_radius_edge) {
            throw UsageError("--radius-edge: below 1.1 no end of refining is in sight");
        }
        const Mesh<3> surface = load_surface(surface_, session);
        MetricField<3> field;
        if (!metric_.empty()) {
            field = load_metric(metric_, surface, surface_);
        }
        const MetricFill made =
            fill_to_metric(surface, field, growth_, fill_options(), surface_, session.monitor);
        session.monitor.progress(0.9, "writing " + output_);
        for (const std::string& loss : write_mesh(output_, made.fill.mesh)) {
            session.monitor.message(Severity::warning, output_ + ": " + loss);
        }
        session.monitor.clear_line();
        show(made, session);
        return ExitCode::ok;
    }

private:
    [[nodiscard]] FillOptions fill_options() const {
        FillOptions options;
        RecoveryOptions& recovery = options.recovery;
        recovery.faces = boundary_ == "keep" ? GivenFaces::keep : GivenFaces::split;
        recovery.size = size_;
        recovery.radius_edge = radius_edge_;
        for (const std::string& text : holes_) {
            recovery.holes.push_back(point_from("--hole", text));
        }
        for (const std::string& text : regions_) {
            recovery.regions.push_back(region_from(text));
        }
        if (!farfield_.empty()) {
            options.farfield = farfield_from(farfield_);
        }
        return options;
    }

    static Vec<3> point_from(const std::string& option, const std::string& text) {
        const std::vector<double> x = numbers_from(text);
        if (x.size() != 3) {
            throw UsageError(option + ": " + text + " is not a point like 0,0.5,1");
        }
        return {x[0], x[1], x[2]};
    }

    /// x,y,z:ID or x,y,z:ID:H.
    static RegionSeed region_from(const std::string& text) {
        RegionSeed seed;
        const std::size_t colon = text.find(':');
        const std::size_t second = colon == std::string::npos ? colon : text.find(':', colon + 1);
        const std::string wrong = "--region: " + text + " is not x,y,z:ID or x,y,z:ID:H";
        if (colon == std::string::npos) {
            throw UsageError(wrong);
        }
        seed.inside = point_from("--region", text.substr(0, colon));
        const auto id = numbers_from(text.substr(colon + 1, second - colon - 1));
        if (id.size() != 1 || id[0] != std::floor(id[0]) || id[0] < 1 || id[0] > 1e6) {
            throw UsageError(wrong + "; ID is a whole number from 1 to 1000000");
        }
        seed.region = static_cast<int>(id[0]);
        if (second != std::string::npos) {
            const auto size = numbers_from(text.substr(second + 1));
            if (size.size() != 1 || !(size[0] > 0)) {
                throw UsageError(wrong + "; H is a length");
            }
            seed.size = size[0];
        }
        return seed;
    }

    void show(const MetricFill& made, Session& session) const {
        const Fill& fill = made.fill;
        if (session.json) {
            Json json{{"file", output_}};
            json.update(fill_json(made));
            session.out << json.dump(2) << '\n';
        } else if (session.verbosity >= 0) {
            const auto tets = static_cast<std::int64_t>(fill.mesh.elements.size());
            session.out << output_ << ": "
                        << plural(static_cast<std::int64_t>(fill.mesh.points.size()), "node")
                        << ", "
                        << (made.conformity
                                ? ""
                                : count_text(fill.recovery.added_nodes) + " of them new, ")
                        << count_text(tets) << " tets, "
                        << plural(static_cast<std::int64_t>(fill.empty.size()), "part")
                        << " left empty; " << number_text(fill.recovery.seconds, 3) << " s\n";
            if (made.conformity) {
                print_facts(session.out, conformity_facts(*made.conformity));
            }
        }
    }

    std::string surface_, output_, metric_, farfield_;
    std::string boundary_ = "keep";
    std::vector<std::string> holes_, regions_;
    double size_ = 0;
    double growth_ = 0.2;
    double radius_edge_ = RecoveryOptions{}.radius_edge;
};

} // namespace

std::unique_ptr<Command> make_fill_command() {
    return std::make_unique<FillCommand>();
}

} // namespace ameco::cli
