// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// VTK actors made from our arrays.
#pragma once

#include "gui/bridge/to_vtk.h"
#include "gui/scene/scene_options.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPolyData.h>

#include <vector>

namespace ameco::gui {

/// Some geometry with colours. Positions reach the graphics card as they are given.
class SceneActor {
public:
    SceneActor();

    [[nodiscard]] vtkActor* actor() const { return actor_; }
    [[nodiscard]] vtkPolyData* data() const { return data_; }

    void clear();
    void set_points(const std::vector<Vec3>& places);
    /// Flat shading, the same from both sides. Needs points and polygons.
    void set_polygons(const std::vector<std::array<std::int32_t, 4>>& polygons);
    void set_flat_normals(const std::vector<std::array<std::int32_t, 4>>& polygons,
                          const std::vector<Vec3>& places);
    void set_normals(const std::vector<Vec3>& normals); ///< at points
    void set_lines(const std::vector<std::array<std::int32_t, 2>>& lines);
    void set_vertices(std::size_t count);

    void colour_cells(const std::vector<Rgb>& colours);
    void colour_points(const std::vector<Rgb>& colours);
    void colour_points_by_scale(const std::vector<float>& places); ///< in sequential_colour
    void colour_all(const Rgb& colour);

private:
    vtkNew<vtkPolyData> data_;
    vtkNew<vtkOpenGLPolyDataMapper> mapper_;
    vtkNew<vtkActor> actor_;
};

} // namespace ameco::gui
