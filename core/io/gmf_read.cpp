// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf.h"
#include "core/io/gmf_reader.h"
#include "core/io/mixed_mesh.h"

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

    MixedMesh<D> read();
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

private:
    void read_section(const Section& section);
    void read_points(const Section& section);
    template <std::size_t N>
    void read_cells(const Section& section, Cells<N>& cells);
    template <class T>
    void read_numbers(const Section& section, std::vector<T>& numbers);
    void take_names(const std::vector<ReferenceString>& strings);

    void check_kind() const;
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
    MixedMesh<D> mixed_;
    std::vector<std::string> notes_;
    std::map<int, std::int64_t> counts_; ///< rows of the sections seen
    std::int64_t unused_strings_ = 0;
};

template <int D>
MixedMesh<D> MeshReader<D>::read() {
    while (const std::optional<Section> section = reader_.next()) {
        if (!counts_.emplace(section->keyword, section->count).second) {
            fail(word(section->keyword) + " occurs a second time at " + reader_.place(*section) +
                 "; keep one of the two");
        }
        read_section(*section);
    }
    take_names(reader_.names_in_comments());
    check_kind();
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
    return std::move(mixed_);
}

template <int D>
void MeshReader<D>::read_section(const Section& section) {
    constexpr bool is_3d = D == 3;
    Features& features = mixed_.features;
    switch (section.keyword) {
    case vertices:
        return read_points(section);
    case edges:
        return read_cells(section, mixed_.lines);
    case triangles:
        return read_cells(section, mixed_.triangles);
    case quadrilaterals:
        return read_cells(section, mixed_.quadrilaterals);
    case tetrahedra:
        return read_cells(section, mixed_.tetrahedra);
    case pyramids:
        return read_cells(section, mixed_.pyramids);
    case prisms:
        return read_cells(section, mixed_.prisms);
    case hexahedra:
        return read_cells(section, mixed_.hexahedra);
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
    mixed_.points.resize(n, Vec<D>::Zero());
    reader_.read_points(section, {n == 0 ? nullptr : mixed_.points.data()->data(), n * D},
                        mixed_.labels.raw());
}

template <int D>
template <std::size_t N>
void MeshReader<D>::read_cells(const Section& section, Cells<N>& cells) {
    const auto n = static_cast<std::size_t>(section.count);
    cells.resize(n);
    const bool known = counts_.contains(vertices);
    reader_.read_cells(section, known ? count_of(vertices) : unknown_count,
                       {n == 0 ? nullptr : cells.nodes.data()->data(), n * N}, cells.labels);
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

/// A string names a curve or a patch if its keyword is that of such cells; one in a comment names a
/// patch.
template <int D>
void MeshReader<D>::take_names(const std::vector<ReferenceString>& strings) {
    constexpr int face_keyword = D == 3 ? triangles : edges;
    for (const ReferenceString& string : strings) {
        const auto label = static_cast<int>(string.number);
        const auto keyword = string.keyword == 0 ? face_keyword : string.keyword;
        if (label != string.number || string.text.empty() ||
            (keyword != edges && keyword != triangles && keyword != tetrahedra)) {
            ++unused_strings_;
        } else {
            (keyword == edges       ? mixed_.line_names
             : keyword == triangles ? mixed_.face_names
                                    : mixed_.cell_names)[label] = string.text;
        }
    }
}

/// What the file is, if it holds nothing to work on.
template <int D>
void MeshReader<D>::check_kind() const {
    if (count_of(vertices) == 0) {
        fail(count_of(sol_at_vertices) > 0
                 ? "holds a solution and no mesh; name the mesh file it belongs to"
                 : "holds no vertices; it is not a mesh, or damaged");
    }
    if (D == 2 && count_of(tetrahedra) > 0) {
        fail("holds " + std::to_string(count_of(tetrahedra)) +
             " tetrahedra, but its Dimension is 2; write it with Dimension 3");
    }
    for (const int keyword : {triangles, quadrilaterals, tetrahedra, pyramids, prisms, hexahedra}) {
        if (count_of(keyword) > 0) {
            return;
        }
    }
    std::string others;
    for (const OpaqueRecord& record : reader_.carried()) {
        others += (others.empty() ? " (it holds " : ", ") + word(record.keyword);
    }
    fail(std::string("holds no ") + (D == 3 ? "tetrahedra" : "triangles") + others +
         (others.empty() ? "" : ")") + "; there is nothing to work on");
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
    const Features& f = mixed_.features;
    const std::size_t edge_count = mixed_.lines.size();
    const auto check_nodes_of = [&](const std::vector<NodeId>& nodes, int keyword) {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            check_number(nodes[i].index(), mixed_.points.size(), keyword, i, vertices);
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
    check_rows_of(f.required_faces, required_triangles, mixed_.triangles.size(), triangles);
    check_rows_of(f.required_elements, D == 3 ? required_tetrahedra : required_triangles,
                  D == 3 ? mixed_.tetrahedra.size() : mixed_.triangles.size(),
                  D == 3 ? tetrahedra : triangles);
}

template <int D>
void read_cells(Reader& reader, const ReadOptions& options, MeshFile& file) {
    MeshReader<D> source(reader);
    MixedMesh<D> mixed = source.read();
    file.notes = source.notes();
    finish_mesh(std::move(mixed), {reader.name(), 1, options.surfaces}, file);
}

} // namespace

std::optional<MeshFile> read_mesh(std::string_view bytes, const std::string& name,
                                  const ReadOptions& options, const FileBytes* mapped) {
    const std::unique_ptr<Reader> reader = open_reader(bytes, name);
    if (!reader) {
        return std::nullopt;
    }
    reader->set_file(mapped);
    MeshFile file;
    if (reader->dimension() == 3) {
        read_cells<3>(*reader, options, file);
    } else {
        read_cells<2>(*reader, options, file);
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
