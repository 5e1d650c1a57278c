// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/bridge/to_vtk.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <numeric>

namespace ameco::gui {
namespace {

/// Cells from offsets and corners, 32 bits each.
vtkSmartPointer<vtkCellArray> cells_from(vtkTypeInt32Array* offsets, vtkTypeInt32Array* corners) {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, corners);
    return cells;
}

/// A tuple of bytes for each std::array.
template <class Colours>
vtkSmartPointer<vtkUnsignedCharArray> bytes_of(const Colours& colours) {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetNumberOfComponents(static_cast<int>(std::tuple_size_v<typename Colours::value_type>));
    array->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
    unsigned char* to = array->GetPointer(0);
    for (const auto& colour : colours) {
        to = std::copy(colour.begin(), colour.end(), to);
    }
    return array;
}

} // namespace

vtkSmartPointer<vtkFloatArray> to_vtk(const std::vector<Vec<3>>& vectors) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(vectors.size()));
    float* to = array->GetPointer(0);
    for (const Vec<3>& v : vectors) {
        to = std::transform(v.data(), v.data() + 3, to,
                            [](double x) { return static_cast<float>(x); });
    }
    return array;
}

vtkSmartPointer<vtkPoints> to_vtk_points(const std::vector<Vec<3>>& positions) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(to_vtk(positions));
    return points;
}

vtkSmartPointer<vtkFloatArray> to_vtk(const std::vector<float>& values) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
}

vtkSmartPointer<vtkUnsignedCharArray> to_vtk(const std::vector<Rgb>& colours) {
    return bytes_of(colours);
}

vtkSmartPointer<vtkUnsignedCharArray> to_vtk(const std::vector<Rgba>& colours) {
    return bytes_of(colours);
}

vtkSmartPointer<vtkCellArray> to_vtk(std::span<const std::array<std::int32_t, 4>> polygons) {
    vtkNew<vtkTypeInt32Array> offsets;
    offsets->SetNumberOfValues(static_cast<vtkIdType>(polygons.size()) + 1);
    std::int32_t* at = offsets->GetPointer(0);
    *at = 0;
    for (const auto& p : polygons) {
        at[1] = at[0] + (p[3] < 0 ? 3 : 4);
        ++at;
    }
    vtkNew<vtkTypeInt32Array> corners;
    corners->SetNumberOfValues(*at);
    std::int32_t* to = corners->GetPointer(0);
    for (const auto& p : polygons) {
        to = std::copy_n(p.begin(), p[3] < 0 ? 3 : 4, to);
    }
    return cells_from(offsets, corners);
}

vtkSmartPointer<vtkCellArray> to_vtk(std::span<const std::array<std::int32_t, 2>> lines) {
    vtkNew<vtkTypeInt32Array> offsets;
    vtkNew<vtkTypeInt32Array> corners;
    offsets->SetNumberOfValues(static_cast<vtkIdType>(lines.size()) + 1);
    corners->SetNumberOfValues(static_cast<vtkIdType>(lines.size()) * 2);
    offsets->SetValue(0, 0);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto l = static_cast<vtkIdType>(i);
        offsets->SetValue(l + 1, static_cast<std::int32_t>(2 * i + 2));
        corners->SetValue(2 * l, lines[i][0]);
        corners->SetValue(2 * l + 1, lines[i][1]);
    }
    return cells_from(offsets, corners);
}

vtkSmartPointer<vtkCellArray> vertices(std::size_t points) {
    vtkNew<vtkTypeInt32Array> offsets;
    vtkNew<vtkTypeInt32Array> corners;
    offsets->SetNumberOfValues(static_cast<vtkIdType>(points) + 1);
    corners->SetNumberOfValues(static_cast<vtkIdType>(points));
    std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + points + 1, 0);
    std::iota(corners->GetPointer(0), corners->GetPointer(0) + points, 0);
    return cells_from(offsets, corners);
}

} // namespace ameco::gui
