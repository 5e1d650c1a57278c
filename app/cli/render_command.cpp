// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/render_options.h"
#include "app/cli/report.h"
#include "app/module.h"
#include "core/base/parallel.h"
#include "core/geometry/distance.h"
#include "core/hierarchy/hierarchy_folder.h"
#include "core/hierarchy/statistics_json.h"
#include "core/io/atomic_file.h"

#include <CLI/CLI.hpp>

#include <Eigen/Geometry>

#include <limits>

namespace ameco::cli {
namespace {

namespace fs = std::filesystem;

using Levels = std::vector<std::variant<gui::SceneInput<3>, gui::SceneInput<2>>>;

template <int D>
std::string caption(const std::string& what, const Mesh<D>& mesh) {
    return what + ": " + count_text(static_cast<std::int64_t>(mesh.points.size())) + " nodes";
}

template <int D>
gui::SceneInput<D> scene_input(Mesh<D> mesh, const std::string& what) {
    gui::SceneInput<D> input;
    input.name = caption(what, mesh);
    input.mesh = std::make_shared<const Mesh<D>>(std::move(mesh));
    return input;
}

/// On which of the levels of a folder the nodes of one level go.
template <int D>
std::vector<int> removed_at(const fs::path& folder, const Hierarchy& hierarchy, int level,
                            std::size_t nodes) {
    std::vector<IdVector<NodeId, NodeId>> parents;
    for (int k = level + 1; k < static_cast<int>(hierarchy.levels.size()); ++k) {
        parents.push_back(read_level<D>(folder, hierarchy, k).parent);
    }
    std::vector<const IdVector<NodeId, NodeId>*> pointers;
    for (const auto& parent : parents) {
        pointers.push_back(&parent);
    }
    return gui::removal_levels(nodes, level, pointers);
}

template <int D>
void add_levels_of(const fs::path& folder, const Hierarchy& hierarchy, const RenderOptions& options,
                   Levels& levels) {
    for (const int level : options.levels) {
        const auto count = static_cast<int>(hierarchy.levels.size());
        if (level < 0 || level >= count) {
            throw UsageError("--levels " + std::to_string(level) + ": " + folder.string() +
                             " has the levels 0 to " + std::to_string(count - 1));
        }
        auto input = scene_input(read_level_mesh<D>(folder, hierarchy, level),
                                 "level " + std::to_string(level));
        if (options.colour == gui::name(gui::ColourBy::removed_at)) {
            input.removed_at = removed_at<D>(folder, hierarchy, level, input.mesh->points.size());
        }
        levels.emplace_back(std::move(input));
    }
}

/// Remembers the normal of the nearest face; of equally near ones that of the largest. At the foot
/// of a layer's edge this is the wall, and not the thin side of the domain.
struct NearestFace {
    double distance = std::numeric_limits<double>::infinity();
    double size = 0;
    Vec<3> normal = Vec<3>::UnitZ();

    /// \param scaled_normal  its length is a measure of the face
    void offer(double d, const Vec<3>& scaled_normal) {
        const double length = scaled_normal.norm();
        const bool equal = std::abs(d - distance) <= 1e-12 * std::max(d, distance);
        if (length > 0 && (equal ? length > size : d < distance)) {
            distance = d;
            size = length;
            normal = scaled_normal / length;
        }
    }
};

/// Unit normal, out of the domain, of the boundary at the place nearest to `place`.
Vec<3> wall_normal(const Mesh<3>& mesh, const Vec<3>& place) {
    NearestFace nearest;
    for (const Facet<3>& face : mesh.faces) {
        const std::array<Vec<3>, 3> x{mesh.points[face[0]], mesh.points[face[1]],
                                      mesh.points[face[2]]};
        nearest.offer(distance(place, x), (x[1] - x[0]).cross(x[2] - x[0]));
    }
    return nearest.normal;
}

Vec<3> wall_normal(const Mesh<2>& mesh, const Vec<3>& place) {
    NearestFace nearest;
    for (const Facet<2>& face : mesh.faces) {
        const std::array<Vec<2>, 2> x{mesh.points[face[0]], mesh.points[face[1]]};
        const Vec<2> along = x[1] - x[0];
        nearest.offer(distance(Vec<2>(place.head<2>()), x), {along[1], -along[0], 0});
    }
    return nearest.normal;
}

Vec<3> position(const gui::SceneInput<3>& input, NodeId node) {
    return input.mesh->points[node];
}

Vec<3> position(const gui::SceneInput<2>& input, NodeId node) {
    const Vec<2>& x = input.mesh->points[node];
    return {x[0], x[1], 0};
}

class RenderCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {
            "render",
            "Make a picture of meshes and levels; needs no screen.",
            "render MESH|DIR... -o PNG [options]",
            {{"render wing.meshb -o wing.png", "the walls, by patch"},
             {"render coarse --levels 0,2 -o layers.png --zoom 40", "two levels beside each other"},
             {"render wing.meshb -o clip.png --clip 0.4,0,0 --colour-by aspect-ratio",
              "what a plane lays open"},
             {"render wing.meshb -o lens.png --node 17 --zoom 100 --lens 1000",
              "a layer, stretched along the wall's normal"},
             {"render wing.meshb -o balls.png --ellipsoids sample --as surface",
              "unit balls of the natural metric"}},
            "In an external flow the far field is left out, and the walls fill the picture.\n"
            "A picture whose scales are not those of the mesh says VIEW SCALED. Exit code 8\n"
            "when there is no OpenGL, or the program was built without it."};
    }

    void add_options(CLI::App& app) override { add_render_options(app, options_); }

    ExitCode run(Session& session) override {
        require_suffix(options_.output, {".png"});
        auto* const render =
            load_function<gui::RenderFunction>(gui::render_module, gui::render_symbol);
        gui::RenderJob job = render_job(options_);
        load_levels(session, job.levels);
        set_what_needs_meshes(job);
        split_by_means(job);
        job.threads = thread_count();
        job.monitor = &session.monitor;
        gui::RenderResult result;
        render(job, result);
        if (!result.error.empty()) {
            throw Error(result.code, result.error);
        }
        AtomicFile file(options_.output);
        file.write(result.png.data(), result.png.size());
        file.commit();
        print(session, job, result);
        return ExitCode::ok;
    }

private:
    void load_levels(Session& session, Levels& levels) const {
        for (const std::string& path : options_.inputs) {
            refuse_overwriting(path, options_.output);
            if (fs::is_directory(path)) {
                const Hierarchy hierarchy = read_hierarchy(path);
                session.monitor.progress(0, "reading " + path);
                hierarchy.dimension == 3 ? add_levels_of<3>(path, hierarchy, options_, levels)
                                         : add_levels_of<2>(path, hierarchy, options_, levels);
                continue;
            }
            if (options_.colour == gui::name(gui::ColourBy::removed_at)) {
                throw UsageError("--colour-by removed-at: " + path +
                                 " is a mesh: name the folder of its levels");
            }
            ReadyMesh ready = load_valid_mesh(path, FeatureOptions{}.ridge_angle_deg, session);
            const std::string name =
                options_.inputs.size() > 1 ? fs::path(path).filename().string() : "";
            std::visit(
                [&]<int D>(Mesh<D>& mesh) {
                    levels.emplace_back(scene_input(std::move(mesh), name));
                },
                ready.file.mesh);
        }
        if (levels.size() == 1) {
            std::visit([](auto& input) { input.name.clear(); }, levels.front());
        }
    }

    void set_what_needs_meshes(gui::RenderJob& job) const {
        std::visit(
            [&](const auto& first) {
                const auto hidden = find_patches(*first.mesh, "--hide", options_.hide);
                job.scene.hidden_patches = {hidden.begin(), hidden.end()};
                if (job.node) {
                    if (!first.mesh->points.contains(*job.node)) {
                        throw UsageError(
                            "--node " + std::to_string(options_.node) + ": the mesh has " +
                            std::to_string(first.mesh->points.size()) + " nodes, numbered from 0");
                    }
                    job.look.focus = job.look.focus.value_or(position(first, *job.node));
                }
                if (options_.lens == 1) {
                    return;
                }
                if (options_.lens_at.empty() && !job.look.focus) {
                    throw UsageError("--lens: say where, with --lens-at, --node or --focus");
                }
                gui::Lens& lens = job.scene.lens;
                lens.enabled = true;
                lens.factor = options_.lens;
                lens.origin =
                    options_.lens_at.empty() ? *job.look.focus : vector_from(options_.lens_at);
                lens.normal = options_.lens_normal.empty() ? wall_normal(*first.mesh, lens.origin)
                                                           : vector_from(options_.lens_normal);
            },
            job.levels.front());
    }

    /// With several means, each level has a panel for each of them.
    void split_by_means(gui::RenderJob& job) const {
        for (const std::string& mean : options_.means) {
            job.means.push_back(*mean_from_name(mean));
        }
        if (job.levels.size() * std::max<std::size_t>(1, job.means.size()) > 8) {
            throw UsageError("at most 8 panels fit in a picture: ask for fewer levels or means");
        }
    }

    void print(Session& session, const gui::RenderJob& job, const gui::RenderResult& result) const {
        session.monitor.clear_line();
        if (session.json) {
            Json json{{"file", options_.output},
                      {"width", job.width},
                      {"height", job.height},
                      {"triangles", result.triangles},
                      {"ellipsoids", result.ellipsoids},
                      {"view_scaled", result.scale_label}};
            if (result.range) {
                json["range"] = {result.range->first, result.range->second};
            }
            session.out << json.dump(2) << '\n';
        } else if (session.verbosity >= 0) {
            session.out << options_.output << ": " << job.width << " x " << job.height << ", "
                        << count_text(static_cast<std::int64_t>(result.triangles)) << " triangles"
                        << (result.ellipsoids > 0
                                ? ", " + count_text(static_cast<std::int64_t>(result.ellipsoids)) +
                                      " ellipsoids"
                                : "")
                        << (result.scale_label.empty() ? "" : ", " + result.scale_label) << '\n';
        }
    }

    RenderOptions options_;
};

} // namespace

std::unique_ptr<Command> make_render_command() {
    return std::make_unique<RenderCommand>();
}

} // namespace ameco::cli
