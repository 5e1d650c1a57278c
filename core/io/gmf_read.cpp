// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf.h"
#include "core/io/gmf_reader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ameco::gmf {
namespace {

/// Reads the sections of one file into a mesh.
template <int D>
class MeshReader {
public:
    explicit MeshReader(Reader& reader) : reader_(reader) {}

    Mesh<D> read();
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

private:
    void read_section(const Section& section);
    void read_points(const Section& section);
    template <std::size_t N>
    void read_cells(const Section& section, std::vector<std::array<NodeId, N>>& cells,
                    std::vector<int>& labels);
    template <class T>
    void read_numbers(const Section& section, std::vector<T>& numbers);
    void take_names(const std::vector<ReferenceString>& strings);

    void check_kind() const;
    void check_points() const;
    void check_nodes() const;
    template <std::size_t N>
    void check_cells(const std::vector<std::array<NodeId, N>>& cells, int keyword) const;
    void check_features() const;
    void check_number(std::size_t number, std::size_t count, int keyword, std::size_t row,
                      int of) const;

    [[nodiscard]] std::int64_t count_of(int keyword) const {
        const auto found = counts_.find(keyword);
        return found == counts_.end() ? 0 : found->second;
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(reader_.name() + ": " + what);
    }

    Reader& reader_;
    Mesh<D> mesh_;
    std::vector<std::string> notes_;
    std::map<int, std::int64_t> counts_; ///< rows of the sections seen
    std::int64_t unused_strings_ = 0;
};

template <int D>
Mesh<D> MeshReader<D>::read() {
    while (const std::optional<Section> section = reader_.next()) {
        if (!counts_.emplace(section->keyword, section->count).second) {
            fail(word(section->keyword) + " occurs a second time at " + reader_.place(*section) +
                 "; keep one of the two");
        }
        read_section(*section);
    }
    take_names(reader_.names_in_comments());
    check_kind();
    check_points();
    check_nodes();
    check_features();
    notes_ = reader_.notes();
    if (count_of(sol_at_vertices) > 0) {
        notes_.push_back(
            "skipped the solution SolAtVertices, which belongs into a file of its own");
    }
    if (unused_strings_ > 0) {
        notes_.push_back("skipped " + std::to_string(unused_strings_) +
                         " reference strings that do not name patches");
    }
    return std::move(mesh_);
}

template <int D>
void MeshReader<D>::read_section(const Section& section) {
    constexpr bool is_3d = D == 3;
    Features& features = mesh_.features;
    switch (section.keyword) {
    case vertices:
        return read_points(section);
    case edges:
        if constexpr (is_3d) {
            return read_cells(section, features.edges, features.edge_labels);
        } else {
            return read_cells(section, mesh_.faces.raw(), mesh_.patch.raw());
        }
    case triangles:
        if constexpr (is_3d) {
            return read_cells(section, mesh_.faces.raw(), mesh_.patch.raw());
        } else {
            return read_cells(section, mesh_.elements.raw(), mesh_.region.raw());
        }
    case tetrahedra:
        if constexpr (is_3d) {
            return read_cells(section, mesh_.elements.raw(), mesh_.region.raw());
        } else {
            return reader_.skip(section);
        }
    case corners:
        return read_numbers(section, features.corners);
    case ridges:
        return read_numbers(section, features.ridges);
    case required_vertices:
        return read_numbers(section, features.required_nodes);
    case required_edges:
        return read_numbers(section, features.required_edges);
    case required_triangles:
        return read_numbers(section, is_3d ? features.required_faces : features.required_elements);
    case required_tetrahedra:
        return is_3d ? read_numbers(section, features.required_elements) : reader_.skip(section);
    case reference_strings:
        return take_names(reader_.read_strings(section));
    default:
        return reader_.skip(section);
    }
}

template <int D>
void MeshReader<D>::read_points(const Section& section) {
    const auto n = static_cast<std::size_t>(section.count);
    mesh_.points.resize(n, Vec<D>::Zero());
    reader_.read_points(section, {n == 0 ? nullptr : mesh_.points.data()->data(), n * D},
                        mesh_.labels.raw());
}

template <int D>
template <std::size_t N>
void MeshReader<D>::read_cells(const Section& section, std::vector<std::array<NodeId, N>>& cells,
                               std::vector<int>& labels) {
    const auto n = static_cast<std::size_t>(section.count);
    cells.resize(n);
    labels.resize(n);
    const bool known = counts_.contains(vertices);
    reader_.read_cells(section, known ? count_of(vertices) : unknown_count,
                       {n == 0 ? nullptr : cells.data()->data(), n * N}, labels);
}

template <int D>
template <class T>
void MeshReader<D>::read_numbers(const Section& section, std::vector<T>& numbers) {
    std::vector<std::int32_t> read(static_cast<std::size_t>(section.count));
    reader_.read_numbers(section, read);
    if constexpr (std::is_same_v<T, std::int32_t>) {
        numbers = std::move(read);
    } else {
        numbers.assign(read.size(), T());
        std::transform(read.begin(), read.end(), numbers.begin(),
                       [](std::int32_t number) { return T(number); });
    }
}

/// A string names a patch if its keyword is that of the faces, or if it stood in a comment.
template <int D>
void MeshReader<D>::take_names(const std::vector<ReferenceString>& strings) {
    constexpr int face_keyword = D == 3 ? triangles : edges;
    for (const ReferenceString& string : strings) {
        const auto patch = static_cast<int>(string.number);
        const bool names_patch = string.keyword == 0 || string.keyword == face_keyword;
        if (names_patch && patch == string.number && !string.text.empty()) {
            mesh_.patch_names[patch] = string.text;
        } else {
            ++unused_strings_;
        }
    }
}

/// What the file is, if it is not a mesh of simplices in D dimensions.
template <int D>
void MeshReader<D>::check_kind() const {
    std::string mixed;
    for (const int keyword : {quadrilaterals, pyramids, prisms, hexahedra}) {
        if (const std::int64_t count = count_of(keyword); count > 0) {
            mixed += mixed.empty() ? " " : ", ";
            mixed += std::to_string(count) + " " + plural(keyword);
        }
    }
    if (!mixed.empty()) {
        fail("mixed meshes are not supported yet:" + mixed + "; split them into simplices first");
    }
    if (count_of(vertices) == 0) {
        fail(count_of(sol_at_vertices) > 0
                 ? "holds a solution and no mesh; name the mesh file it belongs to"
                 : "holds no vertices; it is not a mesh, or damaged");
    }
    if (D == 2 && count_of(tetrahedra) > 0) {
        fail("holds " + std::to_string(count_of(tetrahedra)) +
             " tetrahedra, but its Dimension is 2; write it with Dimension 3");
    }
    if (mesh_.elements.empty() && (D == 2 || mesh_.faces.empty())) {
        std::string others;
        for (const OpaqueRecord& record : reader_.carried()) {
            others += (others.empty() ? " (it holds " : ", ") + word(record.keyword);
        }
        fail(std::string("holds no ") + (D == 3 ? "tetrahedra" : "triangles") + others +
             (others.empty() ? "" : ")") + "; there is nothing to work on");
    }
}

template <int D>
void MeshReader<D>::check_points() const {
    for (const NodeId node : mesh_.points.ids()) {
        if (!mesh_.points[node].allFinite()) {
            fail("vertex " + std::to_string(node.value() + 1) +
                 " has a coordinate that is not finite (NaN or infinity); repair the file");
        }
    }
}

/// Needed for cells that a text file lists before its vertices.
template <int D>
void MeshReader<D>::check_nodes() const {
    check_cells(mesh_.elements.raw(), D == 3 ? tetrahedra : triangles);
    check_cells(mesh_.faces.raw(), D == 3 ? triangles : edges);
    check_cells(mesh_.features.edges, edges);
}

template <int D>
template <std::size_t N>
void MeshReader<D>::check_cells(const std::vector<std::array<NodeId, N>>& cells,
                                int keyword) const {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (const NodeId node : cells[i]) {
            if (!mesh_.points.contains(node)) {
                fail(std::string(entity(keyword)) + " " + std::to_string(i + 1) + " uses node " +
                     std::to_string(node.index() + 1) + ", but the file has " +
                     std::to_string(mesh_.points.size()) + " nodes");
            }
        }
    }
}

template <int D>
void MeshReader<D>::check_number(std::size_t number, std::size_t count, int keyword,
                                 std::size_t row, int of) const {
    if (number >= count) {
        fail(std::string(entity(keyword)) + " " + std::to_string(row + 1) + " is " +
             std::string(entity(of)) + " " + std::to_string(number + 1) + ", but the file has " +
             std::to_string(count) + " " + plural(of));
    }
}

template <int D>
void MeshReader<D>::check_features() const {
    const Features& f = mesh_.features;
    const std::size_t edge_count = D == 3 ? f.edges.size() : mesh_.faces.size();
    const auto check_nodes_of = [&](const std::vector<NodeId>& nodes, int keyword) {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            check_number(nodes[i].index(), mesh_.points.size(), keyword, i, vertices);
        }
    };
    const auto check_rows_of = [&](const std::vector<int>& rows, int keyword, std::size_t count,
                                   int of) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            check_number(static_cast<std::size_t>(rows[i]), count, keyword, i, of);
        }
    };
    check_nodes_of(f.corners, corners);
    check_nodes_of(f.required_nodes, required_vertices);
    check_rows_of(f.ridges, ridges, edge_count, edges);
    check_rows_of(f.required_edges, required_edges, edge_count, edges);
    check_rows_of(f.required_faces, required_triangles, mesh_.faces.size(), triangles);
    check_rows_of(f.required_elements, D == 3 ? required_tetrahedra : required_triangles,
                  mesh_.elements.size(), D == 3 ? tetrahedra : triangles);
}

bool is_planar(const Mesh<3>& mesh) {
    const double z = mesh.points[NodeId(0)].z();
    return std::all_of(mesh.points.begin(), mesh.points.end(),
                       [&](const Vec<3>& x) { return x.z() == z; });
}

/// Triangles in a plane z = const, stored in 3-D, as the 2-D mesh they are.
Mesh<2> flatten(Mesh<3>&& solid) {
    Mesh<2> flat;
    flat.points.resize(solid.points.size(), Vec<2>::Zero());
    for (const NodeId node : solid.points.ids()) {
        flat.points[node] = solid.points[node].head<2>();
    }
    flat.labels = std::move(solid.labels);
    flat.elements.raw() = std::move(solid.faces.raw());
    flat.region.raw() = std::move(solid.patch.raw());
    flat.faces.raw() = std::move(solid.features.edges);
    flat.patch.raw() = std::move(solid.features.edge_labels);
    // The names were those of triangles, which are no patches any more.
    flat.features.corners = std::move(solid.features.corners);
    flat.features.ridges = std::move(solid.features.ridges);
    flat.features.required_nodes = std::move(solid.features.required_nodes);
    flat.features.required_edges = std::move(solid.features.required_edges);
    flat.features.required_elements = std::move(solid.features.required_faces);
    return flat;
}

void read_3d(Reader& reader, MeshFile& file) {
    MeshReader<3> source(reader);
    Mesh<3> mesh = source.read();
    file.notes = source.notes();
    if (!mesh.elements.empty()) {
        file.mesh = std::move(mesh);
        return;
    }
    if (!is_planar(mesh)) {
        throw InputError(reader.name() + ": is a surface of " + std::to_string(mesh.faces.size()) +
                         " triangles without tetrahedra; fill it with a volume mesher first");
    }
    file.notes.push_back("all z are equal and there are no tetrahedra: taken as a 2-D mesh, "
                         "without z and without names of patches");
    file.mesh = flatten(std::move(mesh));
}

} // namespace

std::optional<MeshFile> read_mesh(std::string_view bytes, const std::string& name) {
    const std::unique_ptr<Reader> reader = open_reader(bytes, name);
    if (!reader) {
        return std::nullopt;
    }
    MeshFile file;
    if (reader->dimension() == 3) {
        read_3d(*reader, file);
    } else {
        MeshReader<2> source(*reader);
        file.mesh = source.read();
        file.notes = source.notes();
    }
    file.format = reader->format();
    file.format_version = reader->version();
    file.carried = reader->carried();
    return file;
}

namespace {

std::string describe_fields(const std::vector<int>& types) {
    if (types.empty()) {
        return "no fields";
    }
    constexpr std::size_t most = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(types.size(), most); ++i) {
        text += (text.empty() ? "" : ", ") + std::string(type_name(types[i]));
    }
    return "the fields " + text + (types.size() > most ? ", ..." : "");
}

template <int D>
IdVector<NodeId, Tensor<D>> read_rows(Reader& reader, const Section& section) {
    const auto n = static_cast<std::size_t>(section.count);
    IdVector<NodeId, Tensor<D>> tensors(n);
    reader.read_reals(section, {n == 0 ? nullptr : tensors.data()->data(), n * tensor_size<D>});
    for (const NodeId node : tensors.ids()) {
        const Tensor<D> row = tensors[node];
        for (std::size_t k = 0; k < tensor_size<D>; ++k) {
            if (!std::isfinite(row[k])) {
                throw InputError(reader.name() + ": the tensor of vertex " +
                                 std::to_string(node.value() + 1) +
                                 " has a component that is not finite (NaN or infinity)");
            }
            tensors[node][k] = row[static_cast<std::size_t>(tensor_place<D>[k])];
        }
    }
    return tensors;
}

/// Strings hold words, which `skip` would take for keywords.
void skip_section(Reader& reader, const Section& section) {
    if (section.keyword == reference_strings) {
        static_cast<void>(reader.read_strings(section));
    } else {
        reader.skip(section);
    }
}

/// Reads the file up to its solution, which is to be one tensor per vertex.
Section find_tensors(Reader& reader) {
    bool is_mesh = false;
    while (std::optional<Section> section = reader.next()) {
        if (section->keyword != sol_at_vertices) {
            is_mesh = is_mesh || section->keyword == vertices;
            skip_section(reader, *section);
            continue;
        }
        const std::vector<int> types = reader.read_solution_types(*section);
        if (types != std::vector<int>{symmetric_tensor}) {
            throw InputError(reader.name() + ": holds " + describe_fields(types) +
                             " per vertex; a metric is one symmetric tensor per vertex (type 3)");
        }
        if (section->count == 0) {
            throw InputError(reader.name() + ": holds no tensors");
        }
        return *section;
    }
    throw InputError(reader.name() +
                     (is_mesh ? ": holds a mesh and no metric; name a .sol or .solb file"
                              : ": holds no SolAtVertices; it is not a metric at the vertices"));
}

} // namespace

std::optional<TensorFile> read_tensors(std::string_view bytes, const std::string& name) {
    const std::unique_ptr<Reader> reader = open_reader(bytes, name);
    if (!reader) {
        return std::nullopt;
    }
    const Section section = find_tensors(*reader);
    TensorFile file;
    if (reader->dimension() == 3) {
        file.tensors = read_rows<3>(*reader, section);
    } else {
        file.tensors = read_rows<2>(*reader, section);
    }
    while (const std::optional<Section> rest = reader->next()) {
        skip_section(*reader, *rest);
    }
    file.format = reader->format();
    file.format_version = reader->version();
    file.notes = reader->notes();
    return file;
}

} // namespace ameco::gmf
