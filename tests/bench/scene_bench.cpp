// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Time of pictures and memory, without a screen. Prints a table:
///
///     scene_bench [MESH...]      default: the ONERA M6 wing with 67k and 500k nodes
///
/// prepare: natural metric, elements behind the faces; first: first picture; rotate: a frame while
/// turning, with edges; clip: a frame while a plane that cuts the wing is dragged, whole elements
/// with edges (each as wall clock / CPU time of all threads); held: the picture after the mouse let
/// go. All at 1000 x 700 pixels, the means of some frames, in milliseconds; memory is the process'
/// peak.
#include "core/base/stopwatch.h"
#include "core/cases/cases.h"
#include "core/hierarchy/build_hierarchy.h"
#include "core/io/io.h"
#include "gui/bridge/headless_gl.h"
#include "gui/scene/mesh_scene.h"

#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

using namespace ameco;
using namespace ameco::gui;

namespace {

constexpr int frames = 12;

struct Times {
    double first = 0, rotate = 0, clip = 0, held = 0; ///< wall clock [ms]
    double rotate_cpu = 0, clip_cpu = 0;              ///< of all threads [ms]
    std::size_t triangles = 0, clipped_triangles = 0;
};

double cpu_time() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double draw(HeadlessGL& gl, MeshScene& scene) {
    const Stopwatch watch;
    scene.prepare();
    gl.window()->Render();
    gl.window()->WaitForCompletion();
    return 1000 * watch.seconds();
}

Times measure(std::shared_ptr<const SceneData> data) {
    Times times;
    HeadlessGL gl(1000, 700);
    MeshScene scene;
    scene.attach(gl.window());
    const Stopwatch watch;
    scene.set_data(data);
    draw(gl, scene);
    times.first = 1000 * watch.seconds();
    times.triangles = scene.shown_triangles();
    scene.set_interactive(true);
    double start = cpu_time();
    for (int k = 0; k < frames; ++k) {
        scene.turn(5, 1);
        times.rotate += draw(gl, scene) / frames;
    }
    times.rotate_cpu = (cpu_time() - start) / frames;
    SceneOptions options = scene.options();
    const Vec3 middle = (data->focus_low + data->focus_high) / 2;
    const Vec3 step = (data->focus_high - data->focus_low) / 100;
    options.clip = {true, middle, {0, 1, 0}, true, false};
    start = cpu_time();
    for (int k = 0; k < frames; ++k) {
        options.clip.origin += Vec3(0, step[1], 0);
        scene.set_options(options);
        times.clip += draw(gl, scene) / frames;
    }
    times.clip_cpu = (cpu_time() - start) / frames;
    scene.set_interactive(false);
    times.held = draw(gl, scene);
    times.clipped_triangles = scene.shown_triangles();
    scene.attach(nullptr);
    return times;
}

template <int D>
void bench(const std::string& name, Mesh<D> mesh) {
    const auto nodes = mesh.points.size();
    const auto elements = mesh.elements.size();
    SceneInput<D> input;
    input.mesh = std::make_shared<const Mesh<D>>(std::move(mesh));
    const Stopwatch watch;
    auto data = make_scene_data(std::move(input));
    const double prepare = 1000 * watch.seconds();
    const Times t = measure(std::move(data));
    std::printf("%-24s %9zu %9zu %9.0f %8.0f %10zu %6.0f/%-4.0f %10zu %6.0f/%-4.0f %8.0f %8.0f\n",
                name.c_str(), nodes, elements, prepare, t.first, t.triangles, t.rotate,
                t.rotate_cpu, t.clipped_triangles, t.clip, t.clip_cpu, t.held,
                static_cast<double>(peak_memory()) / 1e6);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    std::printf("%-24s %9s %9s %9s %8s %10s %11s %10s %11s %8s %8s\n", "mesh", "nodes", "elements",
                "prepare", "first", "triangles", "rotate", "clipped", "clip", "held", "MB");
    try {
        for (int k = 1; k < argc; ++k) {
            std::visit([&]<int D>(Mesh<D>&& mesh) { bench(argv[k], std::move(mesh)); },
                       read_mesh(argv[k]).mesh);
        }
        for (const char* const preset : {"m6-67k", "m6-500k"}) {
            if (argc == 1) {
                bench(preset, std::get<Mesh<3>>(make_case("onera-m6", {{"preset", preset}})));
            }
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "scene_bench: %s\n", error.what());
        return static_cast<int>(error.code());
    }
    return 0;
}
