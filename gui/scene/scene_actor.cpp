// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/scene_actor.h"

#include "gui/scene/colour_map.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include <Eigen/Geometry>

namespace ameco::gui {
namespace {

vtkSmartPointer<vtkLookupTable> sequential_table() {
    auto table = vtkSmartPointer<vtkLookupTable>::New();
    constexpr vtkIdType entries = 256;
    table->SetNumberOfTableValues(entries);
    for (vtkIdType k = 0; k < entries; ++k) {
        const Rgb c = sequential_colour(static_cast<double>(k) / (entries - 1));
        table->SetTableValue(k, c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
    }
    table->SetTableRange(0, 1);
    return table;
}

} // namespace

SceneActor::SceneActor() {
    mapper_->SetInputData(data_);
    mapper_->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    actor_->SetMapper(mapper_);
    actor_->SetPickable(false);
}

void SceneActor::clear() {
    data_->Initialize();
}

void SceneActor::set_points(const std::vector<Vec3>& places) {
    data_->SetPoints(to_vtk_points(places));
}

void SceneActor::set_polygons(const std::vector<std::array<std::int32_t, 4>>& polygons) {
    data_->SetPolys(to_vtk(polygons));
}

void SceneActor::set_flat_normals(const std::vector<std::array<std::int32_t, 4>>& polygons,
                                  const std::vector<Vec3>& places) {
    std::vector<Vec3> normals;
    normals.reserve(polygons.size());
    for (const auto& p : polygons) {
        const Vec3& a = places[static_cast<std::size_t>(p[0])];
        normals.push_back((places[static_cast<std::size_t>(p[1])] - a)
                              .cross(places[static_cast<std::size_t>(p[2])] - a)
                              .normalized());
    }
    data_->GetCellData()->SetNormals(to_vtk(normals));
}

void SceneActor::set_normals(const std::vector<Vec3>& normals) {
    data_->GetPointData()->SetNormals(to_vtk(normals));
}

void SceneActor::set_lines(const std::vector<std::array<std::int32_t, 2>>& lines) {
    data_->SetLines(to_vtk(lines));
}

void SceneActor::set_vertices(std::size_t count) {
    data_->SetVerts(vertices(count));
    // In front of the surface that the points lie on.
    mapper_->SetResolveCoincidentTopologyToPolygonOffset();
    mapper_->SetRelativeCoincidentTopologyPointOffsetParameter(-40);
}

void SceneActor::colour_cells(const std::vector<Rgb>& colours) {
    data_->GetPointData()->SetScalars(nullptr);
    data_->GetCellData()->SetScalars(to_vtk(colours));
    mapper_->ScalarVisibilityOn();
    mapper_->SetScalarModeToUseCellData();
    mapper_->InterpolateScalarsBeforeMappingOff();
}

void SceneActor::colour_points(const std::vector<Rgb>& colours) {
    data_->GetCellData()->SetScalars(nullptr);
    data_->GetPointData()->SetScalars(to_vtk(colours));
    mapper_->ScalarVisibilityOn();
    mapper_->SetScalarModeToUsePointData();
    mapper_->InterpolateScalarsBeforeMappingOff();
}

void SceneActor::colour_points_by_scale(const std::vector<float>& places) {
    static const vtkSmartPointer<vtkLookupTable> table = sequential_table();
    data_->GetCellData()->SetScalars(nullptr);
    data_->GetPointData()->SetScalars(to_vtk(places));
    mapper_->ScalarVisibilityOn();
    mapper_->SetScalarModeToUsePointData();
    mapper_->SetLookupTable(table);
    mapper_->SetScalarRange(0, 1);
    mapper_->InterpolateScalarsBeforeMappingOn();
}

void SceneActor::colour_all(const Rgb& colour) {
    mapper_->ScalarVisibilityOff();
    actor_->GetProperty()->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
}

} // namespace ameco::gui
