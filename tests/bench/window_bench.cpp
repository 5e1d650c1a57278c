// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How long the window takes: from the start of the process to the first picture of a mesh, and
/// from picture to picture while the mesh is turned and the clip plane is dragged. To be run on a
/// screen, or under xvfb-run: window_bench MESH
#include "core/hierarchy/build_hierarchy.h"
#include "gui/main_window.h"
#include "gui/view/compare_view.h"
#include "gui/view/vtk_widget.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <cstdio>
#include <functional>

#include <time.h>
#include <unistd.h>

using namespace ameco;
using namespace ameco::gui;

namespace {

/// Since the kernel started the process [s].
double process_age() {
    std::FILE* const file = std::fopen("/proc/self/stat", "r");
    char text[2048] = {};
    const std::size_t length = std::fread(text, 1, sizeof text - 1, file);
    std::fclose(file);
    std::string_view rest(text, length);
    rest.remove_prefix(rest.rfind(')') + 2); // now at field 3; the start time is field 22
    for (int field = 3; field < 22; ++field) {
        rest.remove_prefix(rest.find(' ') + 1);
    }
    const double start = std::atof(rest.data()) / static_cast<double>(::sysconf(_SC_CLK_TCK));
    timespec now{};
    ::clock_gettime(CLOCK_BOOTTIME, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - start;
}

/// Seconds per frame of `frames` changes, each drawn before the next one.
double seconds_per_frame(MeshView& view, int frames, const std::function<void(int)>& change) {
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; i < frames; ++i) {
        const int before = view.renderCount();
        change(i);
        (void)QTest::qWaitFor([&] { return view.renderCount() > before; }, 60'000);
    }
    return static_cast<double>(timer.elapsed()) / 1000 / frames;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: window_bench MESH\n");
        return 2;
    }
    VtkWidget::setDefaultFormat();
    QApplication application(argc, argv);
    MainWindow window;
    window.resize(1440, 900);
    window.show();
    window.openPath(argv[1]);
    MeshView& view = window.views().view(0);
    (void)QTest::qWaitFor([&] { return view.renderCount() > 0; }, 600'000);
    const double empty = process_age();
    bool shown = false;
    QObject::connect(&view, &MeshView::rendered, &view,
                     [&] { shown = shown || view.scene().data() != nullptr; });
    (void)QTest::qWaitFor([&] { return shown; }, 600'000);
    std::printf("empty window %.2f s, first picture %.2f s, peak memory %.0f MB\n", empty,
                process_age(), static_cast<double>(peak_memory()) / 1e6);

    (void)QTest::qWaitFor([&] { return !window.jobs().isRunning(); }, 600'000);
    QTest::qWait(2000); // predictions
    const double turning = seconds_per_frame(view, 20, [&](int i) {
        Camera camera = view.camera();
        camera.sight = {std::cos(0.1 * i), std::sin(0.1 * i), -0.5};
        view.setCamera(camera);
    });
    SceneOptions options = view.options();
    options.clip.enabled = true;
    const Vec3 low = view.scene().data()->focus_low;
    const Vec3 high = view.scene().data()->focus_high;
    view.setInteractive(true);
    const double dragging = seconds_per_frame(view, 20, [&](int i) {
        options.clip.origin = low + (high - low) * (0.2 + 0.03 * i);
        view.setOptions(options);
    });
    view.setInteractive(false);
    std::printf("turning %.1f frames/s, dragging the clip plane %.1f frames/s\n", 1 / turning,
                1 / dragging);
    return 0;
}
