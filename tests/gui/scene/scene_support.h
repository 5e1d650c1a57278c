// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Levels and pictures for the tests of scenes.
#pragma once

#include "core/cases/cases.h"
#include "gui/bridge/headless_gl.h"
#include "gui/scene/mesh_scene.h"
#include "tests/support/picture.h"

#include <map>
#include <memory>
#include <string>

namespace ameco::gui::test {

/// A case as a level. \param turn  applied to its nodes
inline std::shared_ptr<const SceneData>
make_level(const std::string& name, const std::map<std::string, std::string>& parameters = {}) {
    return std::visit(
        []<int D>(const Mesh<D>& mesh) {
            SceneInput<D> input;
            input.mesh = std::make_shared<const Mesh<D>>(mesh);
            return make_scene_data(std::move(input));
        },
        make_case(name, parameters));
}

/// A scene in a window without a screen.
class Studio {
public:
    explicit Studio(std::shared_ptr<const SceneData> data, int width = 480, int height = 360)
        : gl_(width, height) {
        scene.attach(gl_.window());
        scene.set_data(std::move(data));
    }
    ~Studio() { scene.attach(nullptr); }
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    QImage picture() {
        scene.prepare();
        gl_.window()->Render();
        const auto pixels = gl_.window()->readPixels(false);
        const int* const size = gl_.window()->GetSize();
        return QImage(pixels.data(), size[0], size[1], QImage::Format_RGBA8888).copy();
    }
    /// Without everything that is not the mesh.
    void bare() {
        SceneOptions options = scene.options();
        options.axes = options.scale_bar = options.legend = false;
        options.representation = Representation::surface;
        scene.set_options(options);
    }

private:
    HeadlessGL gl_;

public:
    MeshScene scene;
};

inline QColor colour_at(const QImage& image, std::pair<double, double> pixel) {
    return image.pixelColor(static_cast<int>(std::lround(pixel.first)),
                            image.height() - 1 - static_cast<int>(std::lround(pixel.second)));
}

} // namespace ameco::gui::test
