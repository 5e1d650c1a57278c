// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// One level in one part of a window: the same pictures in the program's window and off screen.
#pragma once

#include "gui/scene/camera.h"
#include "gui/scene/pick.h"
#include "gui/scene/scene_data.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkRenderer;
class vtkRenderWindow;

namespace ameco::gui {

/// Part of a window, from 0 to 1, y upwards.
struct Viewport {
    double left = 0, bottom = 0, right = 1, top = 1;
};

/// Parts of the clip plane's handle, which is drawn in the middle of the plane.
enum class ClipHandle {
    shift, ///< its shaft: moves the plane along its normal
    turn   ///< its tip: turns the normal
};

/// Shows one level. Belongs to the thread that renders.
class MeshScene {
public:
    MeshScene();
    ~MeshScene();
    MeshScene(const MeshScene&) = delete;
    MeshScene& operator=(const MeshScene&) = delete;

    /// Shows itself in (a part of) a window; null: in none.
    void attach(vtkRenderWindow* window, const Viewport& viewport = {});
    [[nodiscard]] vtkRenderer* renderer() const; ///< the one with the mesh, for an interactor

    /// The first data fit the camera and hide what would hide the wall; later ones leave options
    /// and camera as they are. Null: an empty view.
    void set_data(std::shared_ptr<const SceneData> data);
    [[nodiscard]] const std::shared_ptr<const SceneData>& data() const;

    /// Text in the upper left corner; empty: the name of the data.
    void set_caption(const std::string& caption);

    /// The legend explains the colours of another scene's data; null: of our own.
    void set_legend_data(std::shared_ptr<const SceneData> data);

    void set_options(const SceneOptions& options);
    [[nodiscard]] const SceneOptions& options() const;

    /// Nodes that light up; those out of range are left out.
    void highlight(std::vector<NodeId> nodes);
    /// The node that carries the mark, and the ellipsoid of EllipsoidOptions::Where::picked.
    void mark(std::optional<NodeId> node);

    /// What is seen at a pixel of the window [device pixels, y up]; nothing for the background.
    [[nodiscard]] std::optional<Pick> pick(double x, double y) const;
    /// Where a place is seen [device pixels of the window, y up].
    [[nodiscard]] std::pair<double, double> pixel_of(const Vec3& position) const;

    /// Whether the clip plane has a handle to be dragged; off at first.
    void set_handles(bool shown);
    [[nodiscard]] std::optional<ClipHandle> clip_handle_at(double x, double y) const;
    /// The clip plane after its handle was dragged from one pixel to another.
    [[nodiscard]] ClipPlane dragged_clip(ClipHandle handle, double from_x, double from_y,
                                         double to_x, double to_y) const;

    [[nodiscard]] Camera camera() const;
    void set_camera(const Camera& camera);
    void reset_camera(); ///< fits what is shown, direction as it is
    void standard_view(StandardView view);
    void turn(double dx, double dy);  ///< by a drag of so many device pixels, y up
    void shift(double dx, double dy); ///< so that what is under the mouse stays under it
    /// Multiplies the size of things by `factor`; what is at the pixel stays there.
    void zoom_at(double x, double y, double factor);

    /// While true (a drag is going on) large meshes are shown in a simpler way.
    void set_interactive(bool interactive);

    /// No background, for pictures to be put on something.
    void set_transparent(bool transparent);

    /// Brings everything up to date with camera and window; to be called before each Render().
    /// \param pixel_ratio  device pixels per unit of text and line widths
    void prepare(double pixel_ratio = 1);

    /// Range of the colours shown: that of the options, else of the data; nothing without a scale.
    [[nodiscard]] std::optional<std::pair<double, double>> shown_range() const;
    /// What the picture says about its scale, e.g. "VIEW SCALED  y x 1000"; "" for a true view.
    [[nodiscard]] std::string scale_label() const;
    [[nodiscard]] double legend_pixels() const; ///< width of the legend's margin [device pixels]
    [[nodiscard]] std::size_t shown_triangles() const;
    [[nodiscard]] std::size_t shown_ellipsoids() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace ameco::gui
