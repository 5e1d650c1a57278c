// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/vtk.h"

#include "core/io/file_bytes.h"
#include "core/io/mixed_mesh.h"
#include "core/io/text_scanner.h"
#include "core/io/trial_run.h"
#include "core/io/vtk_messages.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <new>
#include <optional>

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetReader.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace ameco::vtk {
namespace {

/// Under what names programs store the label of a cell; ours come first.
constexpr std::array<const char*, 8> label_names{
    "label",     "gmsh:physical", "medit:ref", "CellEntityIds",
    "cell_tags", "MaterialIds",   "physical",  "ref"};

/// A compressed file may hold so many times its size; meshes have 2 to 5. zlib could reach 1030, in
/// a file made to fill somebody's memory.
constexpr std::int64_t largest_compression = 64;

/// How a kind of cells is taken apart; its corners come first unless `order` says else.
struct CellKind {
    std::optional<CellType> type;
    bool curved = false;
    const int* order = nullptr;
};

CellKind kind_of(int code, vtkIdType points) {
    static constexpr int pixel[] = {0, 1, 3, 2};
    static constexpr int voxel[] = {0, 1, 3, 2, 4, 5, 7, 6};
    switch (code) {
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
        return {};
    case VTK_PIXEL:
        return {CellType::quadrilateral, false, pixel};
    case VTK_VOXEL:
        return {CellType::hexahedron, false, voxel};
    case VTK_POLYGON:
        return {points == 3   ? std::optional(CellType::triangle)
                : points == 4 ? std::optional(CellType::quadrilateral)
                              : std::nullopt};
    case VTK_POLY_LINE:
        return {points == 2 ? std::optional(CellType::line) : std::nullopt};
    case VTK_QUADRATIC_EDGE:
        return {CellType::line, true};
    case VTK_QUADRATIC_TRIANGLE:
        return {CellType::triangle, true};
    case VTK_QUADRATIC_QUAD:
        return {CellType::quadrilateral, true};
    case VTK_QUADRATIC_TETRA:
        return {CellType::tetrahedron, true};
    case VTK_QUADRATIC_HEXAHEDRON:
        return {CellType::hexahedron, true};
    case VTK_QUADRATIC_WEDGE:
        return {CellType::prism, true};
    case VTK_QUADRATIC_PYRAMID:
        return {CellType::pyramid, true};
    default:
        break;
    }
    const CellTypeInfo* type = find_cell_type(&CellTypeInfo::vtk, code);
    return {type != nullptr ? std::optional(type->type) : std::nullopt};
}

/// The labels of the cells of one kind.
vtkDataArray* find_labels(vtkCellData* data, const char* ours) {
    if (vtkDataArray* array = data->GetArray(ours)) {
        return array;
    }
    for (const char* name : label_names) {
        if (vtkDataArray* array = data->GetArray(name)) {
            return array;
        }
    }
    return nullptr;
}

class Converter {
public:
    Converter(vtkPointSet& grid, const Source& source) : grid_(grid), source_(source) {}

    MeshFile convert() {
        read_points();
        read_cells();
        read_names();
        MeshFile file;
        if (curved_) {
            file.changes.emplace_back("cells of second order were taken as straight ones; their "
                                      "middle nodes are left unused");
        }
        finish_mesh(std::move(mixed_), {source_.name, 0, source_.options.surfaces}, file);
        return file;
    }

private:
    void read_points() {
        const vtkIdType n = grid_.GetNumberOfPoints();
        if (n > std::numeric_limits<std::int32_t>::max()) {
            fail("has more than 2147483647 points");
        }
        mixed_.points.resize(static_cast<std::size_t>(n), Vec<3>::Zero());
        for (const NodeId node : mixed_.points.ids()) {
            grid_.GetPoint(node.value(), mixed_.points[node].data());
        }
        vtkDataArray* labels = grid_.GetPointData()->GetArray("label");
        if (labels != nullptr && labels->GetNumberOfTuples() == n) {
            for (vtkIdType i = 0; i < n; ++i) {
                mixed_.labels.push_back(label(labels, i));
            }
        }
    }

    void read_cells() {
        vtkCellData* data = grid_.GetCellData();
        const std::array<vtkDataArray*, 4> labels{nullptr, find_labels(data, "curve"),
                                                  find_labels(data, "patch"),
                                                  find_labels(data, "region")};
        // In a plane, the faces are lines and the elements are triangles.
        const bool solid = has_volume();
        vtkNew<vtkIdList> points;
        for (vtkIdType c = 0; c < grid_.GetNumberOfCells(); ++c) {
            grid_.GetCellPoints(c, points);
            const int code = grid_.GetCellType(c);
            const CellKind kind = kind_of(code, points->GetNumberOfIds());
            if (!kind.type) {
                if (code != VTK_EMPTY_CELL && code != VTK_VERTEX && code != VTK_POLY_VERTEX) {
                    fail("cell " + std::to_string(c) + " is of VTK's type " + std::to_string(code) +
                         ", which cannot be read");
                }
                continue;
            }
            curved_ = curved_ || kind.curved;
            const int dimension = info(*kind.type).dimension + (solid ? 0 : 1);
            vtkDataArray* array = labels[static_cast<std::size_t>(std::min(dimension, 3))];
            add(kind, *points, array == nullptr ? 0 : label(array, c));
        }
    }

    void add(const CellKind& kind, vtkIdList& points, int label) {
        std::array<NodeId, 8> nodes;
        const int count = info(*kind.type).nodes;
        if (points.GetNumberOfIds() < count) {
            fail("a cell has too few points; the file is damaged");
        }
        for (int k = 0; k < count; ++k) {
            const vtkIdType point = points.GetId(kind.order != nullptr ? kind.order[k] : k);
            if (point < 0 || point >= grid_.GetNumberOfPoints()) {
                fail("a cell uses point " + std::to_string(point) + ", but the file has " +
                     std::to_string(grid_.GetNumberOfPoints()));
            }
            nodes[static_cast<std::size_t>(k)] = NodeId(static_cast<std::int32_t>(point));
        }
        add_cell(mixed_, *kind.type, {nodes.data(), static_cast<std::size_t>(count)}, label);
    }

    bool has_volume() {
        for (vtkIdType c = 0; c < grid_.GetNumberOfCells(); ++c) {
            const CellKind kind = kind_of(grid_.GetCellType(c), 0);
            if (kind.type && info(*kind.type).dimension == 3) {
                return true;
            }
        }
        return false;
    }

    void read_names() {
        auto* bytes = vtkUnsignedCharArray::SafeDownCast(
            grid_.GetFieldData()->GetAbstractArray(patch_names_array));
        if (bytes == nullptr) {
            return;
        }
        const std::string_view text(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                                    static_cast<std::size_t>(bytes->GetNumberOfValues()));
        TextScanner rows(text, source_.name, '\0', TextScanner::Rows::lines);
        while (rows.next_row()) {
            const std::int64_t patch = rows.integer([] { return "names of patches: "; });
            if (patch == static_cast<std::int32_t>(patch)) {
                const std::string name(rows.take_line());
                mixed_.face_names[static_cast<int>(patch)] = name;
                mixed_.line_names[static_cast<int>(patch)] = name;
            }
        }
    }

    int label(vtkDataArray* array, vtkIdType i) const {
        const double value = i < array->GetNumberOfTuples() ? array->GetComponent(i, 0) : 0;
        if (!(std::abs(value) <= 2147483648.0) || value != std::floor(value) ||
            value == 2147483648.0) {
            fail("the array " + std::string(array->GetName()) + " holds " + std::to_string(value) +
                 " at " + std::to_string(i) + "; labels are whole numbers of 32 bits");
        }
        return static_cast<int>(value);
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(source_.name + ": " + what);
    }

    vtkPointSet& grid_;
    const Source& source_;
    MixedMesh<3> mixed_;
    bool curved_ = false;
};

/// Compares the counts that stand behind `key` with what the file can hold, since VTK asks for
/// memory before it looks.
void check_counts(const Source& source, std::string_view key, std::int64_t most) {
    for (std::size_t at = source.bytes.find(key); at != std::string_view::npos;
         at = source.bytes.find(key, at + 1)) {
        std::string_view text = source.bytes.substr(at + key.size(), 24);
        while (!text.empty() && (is_blank(text.front()) || text.front() == '"')) {
            text.remove_prefix(1);
        }
        std::int64_t count = 0;
        const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), count);
        if (error == std::errc::result_out_of_range ||
            (error == std::errc{} && (count < 0 || count > most))) {
            throw InputError(source.name + ": byte " + std::to_string(at) + ": " +
                             std::string(key) + std::to_string(count) +
                             " is more than the file can hold; it is truncated or damaged");
        }
    }
}

template <class Reader>
MeshFile read_with(Reader& reader, const Source& source) {
    const Silence silence;
    try {
        reader.Update();
        auto* grid = vtkPointSet::SafeDownCast(reader.GetOutputDataObject(0));
        const std::string error = silence.error();
        if (grid == nullptr || !error.empty() || reader.GetErrorCode() != 0) {
            throw InputError(source.name + ": " +
                             (error.empty() ? "holds no unstructured grid" : error) +
                             "; it is damaged, or of a kind that cannot be read");
        }
        if (grid->GetNumberOfPoints() == 0) {
            throw InputError(source.name + ": holds no points; it is no mesh, or damaged");
        }
        return Converter(*grid, source).convert();
    } catch (const std::bad_alloc&) {
        throw InputError(source.name + ": asks for more memory than a file of " +
                         std::to_string(source.bytes.size()) + " bytes can need; it is damaged");
    }
}

MeshFile convert_vtu(const Source& source) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    if (source.options.from_memory) {
        reader->ReadFromInputStringOn();
        reader->SetInputString(std::string(source.bytes));
    } else {
        reader->SetFileName(source.path.c_str());
    }
    return read_with(*reader, source);
}

MeshFile convert_legacy(const Source& source) {
    vtkNew<vtkDataSetReader> reader;
    reader->ReadAllScalarsOn();
    if (source.options.from_memory) {
        reader->ReadFromInputStringOn();
        reader->SetInputString(source.bytes.data(), static_cast<int>(source.bytes.size()));
    } else {
        reader->SetFileName(source.path.c_str());
    }
    return read_with(*reader, source);
}

} // namespace

bool recognises_vtu(std::string_view bytes) {
    const std::string_view begin = bytes.substr(0, 2048);
    return begin.find("<VTKFile") != std::string_view::npos &&
           begin.find("\"UnstructuredGrid\"") != std::string_view::npos;
}

bool recognises_legacy(std::string_view bytes) {
    return bytes.substr(0, 14) == "# vtk DataFile";
}

bool recognises_pvd(std::string_view bytes) {
    const std::string_view begin = bytes.substr(0, 2048);
    return begin.find("<VTKFile") != std::string_view::npos &&
           begin.find("\"Collection\"") != std::string_view::npos;
}

MeshFile read_vtu(const Source& source) {
    const auto bytes = static_cast<std::int64_t>(source.bytes.size());
    const bool packed = source.bytes.substr(0, 2048).find("compressor=") != std::string_view::npos;
    const std::int64_t most = packed ? largest_compression * bytes : bytes;
    check_counts(source, "NumberOfPoints=", most);
    check_counts(source, "NumberOfCells=", most);
    check_counts(source, "NumberOfTuples=", most);
    check_counts(source, "NumberOfComponents=", most);
    require_survival(source.name, "VTK", {most}, [&] { static_cast<void>(convert_vtu(source)); });
    MeshFile file = convert_vtu(source);
    file.format = "VTK XML (.vtu)";
    return file;
}

MeshFile read_legacy(const Source& source) {
    const auto bytes = static_cast<std::int64_t>(source.bytes.size());
    for (const char* key : {"POINTS ", "CELLS ", "CELL_TYPES ", "POLYGONS ", "POINT_DATA ",
                            "CELL_DATA ", "OFFSETS ", "VERTICES ", "LINES "}) {
        check_counts(source, key, bytes);
    }
    require_survival(source.name, "VTK", {bytes},
                     [&] { static_cast<void>(convert_legacy(source)); });
    MeshFile file = convert_legacy(source);
    file.format = "VTK legacy (.vtk)";
    return file;
}

MeshFile read_pvd(const Source& source) {
    constexpr std::string_view key = "file=\"";
    const std::size_t at = source.bytes.find(key);
    const std::size_t end = source.bytes.find('"', at + key.size());
    if (at == std::string_view::npos || end == std::string_view::npos) {
        throw InputError(source.name + ": names no file; it is damaged");
    }
    const std::filesystem::path path =
        source.path.parent_path() /
        std::string(source.bytes.substr(at + key.size(), end - at - key.size()));
    const FileBytes bytes(path);
    MeshFile file = read_vtu({path, path.string(), bytes.view(), source.options, &bytes});
    file.format = "VTK collection, " + file.format;
    file.notes.push_back("read its first file, " + path.filename().string());
    return file;
}

} // namespace ameco::vtk
