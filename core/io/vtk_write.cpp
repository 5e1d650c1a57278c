// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/vtk.h"

#include "core/io/atomic_file.h"
#include "core/io/cell_type.h"
#include "core/io/patch_names.h"
#include "core/io/vtk_messages.h"

#include <algorithm>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace ameco::vtk {
namespace {

vtkSmartPointer<vtkIntArray> make_array(const char* name, vtkIdType values) {
    auto array = vtkSmartPointer<vtkIntArray>::New();
    array->SetName(name);
    array->SetNumberOfValues(values);
    array->Fill(0);
    return array;
}

/// The cells of a grid in the making.
class Cells {
public:
    explicit Cells(std::size_t count) {
        const auto n = static_cast<vtkIdType>(count);
        types_->SetNumberOfValues(n);
        cells_->AllocateEstimate(n, 4);
    }

    /// \param labels  [cells.size()], into the cell array `name`
    template <std::size_t N>
    void add(CellType type, const std::vector<std::array<NodeId, N>>& cells,
             const std::vector<int>& labels, const char* name) {
        auto array = make_array(name, types_->GetNumberOfValues());
        for (std::size_t i = 0; i < cells.size(); ++i) {
            std::array<vtkIdType, N> nodes;
            for (std::size_t k = 0; k < N; ++k) {
                nodes[k] = cells[i][k].value();
            }
            const vtkIdType cell = cells_->InsertNextCell(static_cast<vtkIdType>(N), nodes.data());
            types_->SetValue(cell, static_cast<unsigned char>(info(type).vtk));
            array->SetValue(cell, labels[i]);
        }
        if (!cells.empty()) {
            arrays_.push_back(array);
        }
    }

    void put_into(vtkUnstructuredGrid& grid) const {
        grid.SetCells(types_, cells_);
        for (const auto& array : arrays_) {
            grid.GetCellData()->AddArray(array);
        }
    }

private:
    vtkNew<vtkUnsignedCharArray> types_;
    vtkNew<vtkCellArray> cells_;
    std::vector<vtkSmartPointer<vtkIntArray>> arrays_;
};

template <int D>
void add_points(const Mesh<D>& mesh, vtkUnstructuredGrid& grid) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
    for (const NodeId node : mesh.points.ids()) {
        Vec<3> x = Vec<3>::Zero();
        x.head<D>() = mesh.points[node];
        points->SetPoint(node.value(), x.data());
    }
    grid.SetPoints(points);
    if (!mesh.labels.empty()) {
        auto labels = make_array("label", static_cast<vtkIdType>(mesh.labels.size()));
        for (const NodeId node : mesh.points.ids()) {
            labels->SetValue(node.value(), mesh.labels[node]);
        }
        grid.GetPointData()->AddArray(labels);
    }
}

/// As bytes of text, since meshio does not read files with arrays of strings.
void add_names(const std::map<int, std::string>& names, vtkUnstructuredGrid& grid) {
    std::string rows;
    for (const auto& [patch, name] : names) {
        rows += std::to_string(patch) + " " + name + "\n";
    }
    if (rows.empty()) {
        return;
    }
    vtkNew<vtkUnsignedCharArray> bytes;
    bytes->SetName(patch_names_array);
    bytes->SetNumberOfValues(static_cast<vtkIdType>(rows.size()));
    std::copy(rows.begin(), rows.end(), bytes->GetPointer(0));
    grid.GetFieldData()->AddArray(bytes);
}

vtkSmartPointer<vtkDoubleArray> make_reals(const char* name, int components, vtkIdType tuples) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
    return array;
}

/// Metric, sizes and aspect ratios at the points. VTK's tensors are xx yy zz xy yz xz.
template <int D>
void add_metric(const TensorFile& file, vtkUnstructuredGrid& grid, const std::string& name) {
    const auto* tensors = std::get_if<IdVector<NodeId, Tensor<D>>>(&file.tensors);
    const vtkIdType n = grid.GetNumberOfPoints();
    if (tensors == nullptr || static_cast<vtkIdType>(tensors->size()) != n) {
        throw UsageError(name + ": the metric does not belong to the mesh: their dimensions or "
                                "numbers of nodes differ");
    }
    const auto metric = make_reals("metric", 6, n);
    const auto sizes = make_reals("sizes", D, n);
    const auto ratio = make_reals("aspect_ratio", 1, n);
    for (const NodeId node : tensors->ids()) {
        const Tensor<D>& t = (*tensors)[node];
        const std::array<double, 6> in_vtk_order = [&] {
            if constexpr (D == 3) {
                return std::array<double, 6>{t[0], t[3], t[5], t[1], t[4], t[2]};
            } else {
                return std::array<double, 6>{t[0], t[2], 0, t[1], 0, 0};
            }
        }();
        const Metric<D> m = from_tensor<D>(t);
        metric->SetTypedTuple(node.value(), in_vtk_order.data());
        sizes->SetTypedTuple(node.value(), m.sizes.data());
        ratio->SetValue(node.value(), aspect_ratio(m));
    }
    for (const auto& array : {metric, sizes, ratio}) {
        grid.GetPointData()->AddArray(array);
    }
}

} // namespace

template <int D>
std::vector<std::string> write_vtu(const std::filesystem::path& path, const Mesh<D>& mesh,
                                   const WriteOptions& options) {
    std::vector<std::string> notes;
    AtomicFile target(path);
    vtkNew<vtkUnstructuredGrid> grid;
    add_points(mesh, *grid);
    const Features& f = mesh.features;
    Cells cells(mesh.elements.size() + mesh.faces.size() + (D == 3 ? f.edges.size() : 0));
    cells.add(D == 3 ? CellType::tetrahedron : CellType::triangle, mesh.elements.raw(),
              mesh.region.raw(), "region");
    cells.add(D == 3 ? CellType::triangle : CellType::line, mesh.faces.raw(), mesh.patch.raw(),
              "patch");
    if constexpr (D == 3) {
        cells.add(CellType::line, f.edges, f.edge_labels, "curve");
    }
    cells.put_into(*grid);
    add_names(portable_names(mesh.patch_names, notes), *grid);

    if (options.tensors != nullptr) {
        add_metric<D>(*options.tensors, *grid, path.string());
    }
    for (const NodalField& field : options.fields) {
        const auto values = make_reals(field.name.c_str(), 1, grid->GetNumberOfPoints());
        std::copy(field.values.begin(), field.values.end(), values->GetPointer(0));
        grid->GetPointData()->AddArray(values);
    }
    const Silence silence;
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->SetFileName(target.temporary().c_str());
    // Not appended: the ParaView 5.11 of an up-to-date Debian 12 stops at the first byte of
    // appended data, raw or encoded ("not well-formed"); VTK's own readers do not.
    writer->SetDataModeToBinary();
    writer->SetHeaderTypeToUInt64();
    writer->SetCompressorTypeToNone();
    if (writer->Write() == 0 || !silence.error().empty()) {
        throw FileError(path.string() + ": cannot be written: " + silence.error());
    }
    target.commit();
    return notes;
}

template std::vector<std::string> write_vtu(const std::filesystem::path&, const Mesh<2>&,
                                            const WriteOptions&);
template std::vector<std::string> write_vtu(const std::filesystem::path&, const Mesh<3>&,
                                            const WriteOptions&);

} // namespace ameco::vtk
