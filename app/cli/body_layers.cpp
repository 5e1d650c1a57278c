// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/body_layers.h"

#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "app/cli/surface_words.h"
#ifdef AMECO_WITH_HALF_EDGES
#include "core/cases/surface_layers.h"
#endif

#include <CLI/CLI.hpp>

namespace ameco::cli {

void BodyLayers::add_options(CLI::App& app) {
    const std::string group = "On a surface from a file";
    app.add_option("--surface", surface,
                   "closed surface to put the layers on, instead of a plate; of the parameters "
                   "above only growth applies")
        ->type_name("FILE")
        ->group(group);
    app.add_option("--first-height", first_height, "distance of the first layer from the surface")
        ->check(greater_than(0))
        ->type_name("H")
        ->group(group);
    app.add_option("--layers", layers, "number of layers")
        ->check(whole_number(1, 1000))
        ->capture_default_str()
        ->group(group);
    app.add_option("--farfield", farfield, "what bounds the space: box, sphere, box:R, sphere:R")
        ->type_name("SHAPE")
        ->capture_default_str()
        ->group(group);
}

#ifdef AMECO_WITH_HALF_EDGES

namespace {

std::string point_text(const Vec<3>& x) {
    return number_text(x[0]) + " " + number_text(x[1]) + " " + number_text(x[2]);
}

void show(const SurfaceLayers& made, const std::string& output, Session& session) {
    const auto nodes = static_cast<std::int64_t>(made.mesh.points.size());
    const auto tets = static_cast<std::int64_t>(made.mesh.elements.size());
    if (session.json) {
        Json shrunk = Json::array(), collapsed = Json::array(); // wall nodes keep their numbers
        for (const NodeId v : made.share.ids()) {
            if (made.share[v] == 0) {
                collapsed.push_back(v.value());
            } else if (made.share[v] < 1) {
                shrunk.push_back({v.value(), made.share[v]});
            }
        }
        session.out << Json{{"case", "layer"},
                            {"file", output},
                            {"dimension", 3},
                            {"nodes", nodes},
                            {"elements", tets},
                            {"boundary_faces", made.mesh.faces.size()},
                            {"layer_nodes", made.layer_nodes},
                            {"layer_elements", made.layer_elements},
                            {"columns", made.columns},
                            {"shrunk_columns", made.shrunk},
                            {"collapsed_columns", made.collapsed},
                            {"shrunk", shrunk},
                            {"collapsed", collapsed},
                            {"least_share", made.least_share},
                            {"least_share_at", {made.at[0], made.at[1], made.at[2]}},
                            {"layer_height", made.height}}
                           .dump(2)
                    << '\n';
        return;
    }
    if (session.verbosity < 0) {
        return;
    }
    session.out << output << ": layers on a surface, " << count_text(nodes) << " nodes, "
                << count_text(tets) << " tets\n";
    print_facts(session.out,
                {{"in the layers", count_text(made.layer_nodes) + " nodes, " +
                                       count_text(made.layer_elements) + " tets; together " +
                                       number_text(made.height) + " high"},
                 {"columns", count_text(made.columns) + ", of which " + count_text(made.shrunk) +
                                 " shortened, " + count_text(made.collapsed) + " without layers"},
                 {"shortest",
                  percent_text(made.least_share) + " of the height, at " + point_text(made.at)}});
}

} // namespace

void BodyLayers::run(double growth, const std::string& output, Session& session) const {
    if (first_height <= 0) {
        throw UsageError("case layer --surface: --first-height is missing");
    }
    refuse_overwriting(surface, output);
    SurfaceLayerOptions options;
    options.first_height = first_height;
    options.growth = growth;
    options.layers = layers;
    options.farfield = farfield_from(farfield);
    const Mesh<3> body = load_surface(surface, session);
    const SurfaceLayers made = make_surface_layers(body, options, surface, session.monitor);
    for (const std::string& remark : made.recovery.remarks) {
        session.monitor.message(Severity::warning, remark);
    }
    session.monitor.progress(0.9, "writing " + output);
    for (const std::string& loss : write_mesh(output, made.mesh)) {
        session.monitor.message(Severity::warning, output + ": " + loss);
    }
    session.monitor.clear_line();
    show(made, output, session);
}

#else

void BodyLayers::run(double, const std::string&, Session&) const {
    throw Error(ExitCode::not_built,
                "case layer --surface: this build has no OpenMesh (Debian: libopenmesh-dev)");
}

#endif

} // namespace ameco::cli
