// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Core's arrays as VTK's.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <vtkSmartPointer.h>

class vtkCellArray;
class vtkFloatArray;
class vtkPoints;
class vtkUnsignedCharArray;

namespace ameco::gui {

using Rgb = std::array<unsigned char, 3>;
using Rgba = std::array<unsigned char, 4>; ///< the last is the opacity

/// In single precision, as graphics cards have them: to be near the origin beforehand.
[[nodiscard]] vtkSmartPointer<vtkFloatArray> to_vtk(const std::vector<Vec<3>>& vectors);
[[nodiscard]] vtkSmartPointer<vtkPoints> to_vtk_points(const std::vector<Vec<3>>& positions);
[[nodiscard]] vtkSmartPointer<vtkFloatArray> to_vtk(const std::vector<float>& values);
[[nodiscard]] vtkSmartPointer<vtkUnsignedCharArray> to_vtk(const std::vector<Rgb>& colours);
[[nodiscard]] vtkSmartPointer<vtkUnsignedCharArray> to_vtk(const std::vector<Rgba>& colours);

/// Triangles and quadrilaterals (the fourth index of a triangle is -1).
[[nodiscard]] vtkSmartPointer<vtkCellArray>
to_vtk(std::span<const std::array<std::int32_t, 4>> polygons);
[[nodiscard]] vtkSmartPointer<vtkCellArray>
to_vtk(std::span<const std::array<std::int32_t, 2>> lines);
/// One vertex per point.
[[nodiscard]] vtkSmartPointer<vtkCellArray> vertices(std::size_t points);

} // namespace ameco::gui
