// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/render/render_picture.h"

#include "gui/bridge/headless_gl.h"
#include "gui/scene/mesh_scene.h"
#include "gui/scene/scene_values.h"

#include <Eigen/Geometry>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ameco::gui {
namespace {

/// Pixels that are rendered per pixel of the picture and direction; their mean smooths edges.
constexpr int finer = 2;

using Scenes = std::vector<std::unique_ptr<MeshScene>>;

Scenes make_scenes(const RenderJob& job, Monitor& monitor) {
    Scenes scenes;
    const AbsentMetric absent =
        has_scale(job.scene.colour) ? AbsentMetric::make : AbsentMetric::leave_out;
    for (std::size_t k = 0; k < job.levels.size(); ++k) {
        const auto share = [&](std::size_t n) {
            return 0.8 * static_cast<double>(n) / static_cast<double>(job.levels.size());
        };
        MonitorPart part(monitor, share(k), share(k + 1));
        auto data = std::visit(
            [&](const auto& input) { return make_scene_data(input, part, absent); }, job.levels[k]);
        SceneOptions options = job.scene;
        if (job.hide_outer) {
            options.hidden_patches.merge(patches_hidden_at_first(*data));
        }
        for (std::size_t m = 0; m < std::max<std::size_t>(1, job.means.size()); ++m) {
            if (!job.means.empty()) {
                options.ellipsoids.mean = job.means[m];
            }
            scenes.push_back(std::make_unique<MeshScene>());
            scenes.back()->set_data(data);
            scenes.back()->set_options(options);
            if (job.means.size() > 1) {
                const std::string& level = data->name();
                scenes.back()->set_caption((level.empty() ? "" : level + ", ") +
                                           std::string(name(job.means[m])) + " mean");
            }
        }
        if (monitor.stop_requested()) {
            throw Cancelled();
        }
    }
    return scenes;
}

/// Panels of the same size, the last one with a margin beside it for the legend.
void place_side_by_side(const Scenes& scenes, vtkRenderWindow* window, double margin) {
    const double all = window->GetSize()[0];
    const double width = (all - margin) / static_cast<double>(scenes.size());
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const double left = std::round(static_cast<double>(k) * width);
        const double right = k + 1 == scenes.size() ? all : std::round(left + width);
        scenes[k]->attach(window, {left / all, 0, right / all, 1});
    }
}

/// The same colours mean the same in all panels; the last one has the legend.
void share_range(const Scenes& scenes) {
    std::optional<Range> all;
    for (const auto& scene : scenes) {
        scene->prepare();
        if (const auto range = scene->shown_range()) {
            all = all ? Range{std::min(all->first, range->first),
                              std::max(all->second, range->second)}
                      : *range;
        }
    }
    scenes.back()->set_legend_data(scenes.front()->data());
    for (const auto& scene : scenes) {
        SceneOptions options = scene->options();
        options.range = all;
        options.legend = options.legend && scene == scenes.back();
        scene->set_options(options);
    }
}

/// The camera of the first panel, which all of them have.
Camera look(MeshScene& scene, const LookOptions& options) {
    const bool flat = scene.data()->dimension == 2;
    scene.standard_view(flat && !options.view_given ? StandardView::plus_z : options.view);
    Camera camera = scene.camera();
    if (options.from) {
        camera.sight = -*options.from;
    }
    if (options.up) {
        camera.up = *options.up;
    }
    if (camera.sight.cross(camera.up).norm() < 1e-9 * camera.sight.norm() * camera.up.norm()) {
        camera.up = Vec3(0, 1, 0); // straight from above, say
        if (camera.sight.cross(camera.up).norm() < 1e-9 * camera.sight.norm()) {
            camera.up = Vec3(0, 0, 1);
        }
    }
    scene.set_camera(camera);
    scene.reset_camera();
    camera = scene.camera();
    camera.focus = options.focus.value_or(camera.focus);
    camera.height = options.height.value_or(camera.height) / options.zoom;
    return camera;
}

NodeId nearest_node(const SceneData& data, const Vec3& x) {
    NodeId nearest;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < data.node_count; ++i) {
        const double distance = (data.position(NodeId(i)) - x).squaredNorm();
        if (distance < best) {
            best = distance;
            nearest = NodeId(i);
        }
    }
    return nearest;
}

/// The mean of `finer` x `finer` pixels each, weighted with their opacity.
Picture averaged(const std::vector<unsigned char>& pixels, int width, int height) {
    Picture picture{width, height, std::vector<unsigned char>(4UL * width * height)};
    const std::size_t row = 4UL * finer * width;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::array<unsigned, 4> sum{};
            for (int k = 0; k < finer * finer; ++k) {
                const unsigned char* const p =
                    &pixels[row * static_cast<std::size_t>(finer * y + k / finer) +
                            4UL * static_cast<std::size_t>(finer * x + k % finer)];
                for (std::size_t c = 0; c < 3; ++c) {
                    sum[c] += p[c] * p[3];
                }
                sum[3] += p[3];
            }
            unsigned char* const to =
                &picture.rgba[4 * (static_cast<std::size_t>(y) * width + static_cast<unsigned>(x))];
            for (std::size_t c = 0; c < 3 && sum[3] > 0; ++c) {
                to[c] = static_cast<unsigned char>((sum[c] + sum[3] / 2) / sum[3]);
            }
            to[3] = static_cast<unsigned char>(sum[3] / (finer * finer));
        }
    }
    return picture;
}

} // namespace

Picture render_picture(const RenderJob& job, RenderResult& result) {
    Monitor& monitor = job.monitor != nullptr ? *job.monitor : Monitor::silent();
    const HeadlessGL gl(finer * job.width, finer * job.height);
    const Scenes scenes = make_scenes(job, monitor);
    place_side_by_side(scenes, gl.window(), 0);
    const double pixel_ratio = finer * job.text_scale;
    share_range(scenes);
    for (const auto& scene : scenes) {
        scene->prepare(pixel_ratio);
    }
    place_side_by_side(scenes, gl.window(), scenes.back()->legend_pixels());
    scenes.front()->prepare(pixel_ratio);
    const Camera camera = look(*scenes.front(), job.look);
    if (job.node && job.node->index() >= scenes.front()->data()->node_count) {
        throw Error(ExitCode::usage,
                    "--node " + std::to_string(job.node->value()) + ": the mesh has only " +
                        std::to_string(scenes.front()->data()->node_count) + " nodes");
    }
    for (const auto& scene : scenes) {
        scene->set_camera(camera);
        scene->set_transparent(job.transparent);
        if (job.node) {
            scene->mark(nearest_node(*scene->data(), scenes.front()->data()->position(*job.node)));
        }
        scene->prepare(pixel_ratio);
        result.triangles += scene->shown_triangles();
        result.ellipsoids += scene->shown_ellipsoids();
    }
    result.range = scenes.front()->shown_range();
    result.scale_label = scenes.front()->scale_label();
    monitor.progress(0.9, "drawing");
    gl.window()->Render();
    Picture picture = averaged(gl.window()->readPixels(!job.transparent), job.width, job.height);
    for (const auto& scene : scenes) {
        scene->attach(nullptr);
    }
    return picture;
}

std::string to_png(const Picture& picture) {
    const std::size_t pixels = picture.rgba.size() / 4;
    bool opaque = true;
    for (std::size_t p = 0; p < pixels; ++p) {
        opaque = opaque && picture.rgba[4 * p + 3] == 255;
    }
    const std::size_t channels = opaque ? 3 : 4;
    vtkNew<vtkImageData> image;
    image->SetDimensions(picture.width, picture.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, static_cast<int>(channels));
    const auto width = static_cast<std::size_t>(picture.width);
    for (int y = 0; y < picture.height; ++y) {
        const unsigned char* from =
            &picture.rgba[4 * width * static_cast<std::size_t>(picture.height - 1 - y)];
        auto* to = static_cast<unsigned char*>(image->GetScalarPointer(0, y, 0));
        for (std::size_t x = 0; x < width; ++x, from += 4) {
            to = std::copy_n(from, channels, to);
        }
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetCompressionLevel(9);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* const bytes = writer->GetResult();
    const unsigned char* const begin = bytes->GetPointer(0);
    return {begin, begin + bytes->GetNumberOfTuples()};
}

} // namespace ameco::gui
