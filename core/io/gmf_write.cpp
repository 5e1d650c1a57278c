// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf.h"
#include "core/io/gmf_binary_writer.h"
#include "core/io/gmf_text_writer.h"
#include "core/io/patch_names.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ameco::gmf {
namespace {

void check_version(const WriteOptions& options) {
    if (options.version < 1 || options.version > 4) {
        throw UsageError("Medit version " + std::to_string(options.version) +
                         " does not exist; choose 1, 2, 3 or 4");
    }
}

/// Whether every number survives a trip through float32.
bool fits_float(std::span<const double> values) {
    constexpr double largest = std::numeric_limits<float>::max();
    return std::all_of(values.begin(), values.end(), [](double v) {
        return std::abs(v) <= largest && static_cast<double>(static_cast<float>(v)) == v;
    });
}

/// The lowest version from the wanted one up that can hold the numbers and the file's size.
/// \param bytes  upper bound of the file's size in versions 2 and 3
int version_for(int wanted, bool needs_double, std::int64_t bytes,
                std::vector<std::string>& notes) {
    int version = wanted;
    if (version == 1 && needs_double) {
        notes.push_back("written as version 2: version 1 keeps single precision only");
        version = 2;
    }
    if (version < 3 && bytes > std::numeric_limits<std::int32_t>::max()) {
        notes.push_back("written as version 3: the file is larger than 2 GiB");
        version = 3;
    }
    return version;
}

/// Records of one version fit into files whose integers and reals have the same widths.
bool same_widths(int version_a, int version_b) {
    const auto widths = [](int version) { return version == 3 ? 2 : version; };
    return widths(version_a) == widths(version_b);
}

template <std::size_t N>
std::span<const NodeId> flat(const std::vector<std::array<NodeId, N>>& cells) {
    return {cells.empty() ? nullptr : cells.data()->data(), cells.size() * N};
}

template <int D>
std::span<const double> flat(const IdVector<NodeId, Vec<D>>& points) {
    return {points.empty() ? nullptr : points.data()->data(), points.size() * D};
}

template <std::size_t N>
void write_cells(Writer& writer, int keyword, const std::vector<std::array<NodeId, N>>& cells,
                 const std::vector<int>& labels) {
    if (!cells.empty()) {
        writer.write_cells(keyword, flat(cells), labels);
    }
}

void write_numbers(Writer& writer, int keyword, const std::vector<int>& numbers) {
    if (!numbers.empty()) {
        writer.write_numbers(keyword, numbers);
    }
}

void write_numbers(Writer& writer, int keyword, const std::vector<NodeId>& nodes) {
    std::vector<int> numbers(nodes.size());
    std::transform(nodes.begin(), nodes.end(), numbers.begin(),
                   [](NodeId node) { return node.value(); });
    write_numbers(writer, keyword, numbers);
}

template <int D>
void write_sections(Writer& writer, const Mesh<D>& mesh, const std::map<int, std::string>& names) {
    const Features& f = mesh.features;
    writer.write_points(flat<D>(mesh.points), D, mesh.labels.raw());
    if constexpr (D == 3) {
        write_cells(writer, edges, f.edges, f.edge_labels);
        write_cells(writer, triangles, mesh.faces.raw(), mesh.patch.raw());
        write_cells(writer, tetrahedra, mesh.elements.raw(), mesh.region.raw());
    } else {
        write_cells(writer, edges, mesh.faces.raw(), mesh.patch.raw());
        write_cells(writer, triangles, mesh.elements.raw(), mesh.region.raw());
    }
    write_numbers(writer, corners, f.corners);
    write_numbers(writer, ridges, f.ridges);
    write_numbers(writer, required_vertices, f.required_nodes);
    write_numbers(writer, required_edges, f.required_edges);
    if constexpr (D == 3) {
        write_numbers(writer, required_triangles, f.required_faces);
        write_numbers(writer, required_tetrahedra, f.required_elements);
    } else {
        write_numbers(writer, required_triangles, f.required_elements);
    }
    if (!names.empty()) {
        writer.write_names(D == 3 ? triangles : edges, names);
    }
}

/// Bytes of a file of version 2 or 3, rounded up.
template <int D>
std::int64_t size_bound(const Mesh<D>& mesh, const WriteOptions& options) {
    const Features& f = mesh.features;
    std::size_t bytes = 4096 + mesh.points.size() * (8 * D + 4) +
                        mesh.elements.size() * 4 * (D + 2) + mesh.faces.size() * 4 * (D + 1) +
                        f.edges.size() * 12 + mesh.patch_names.size() * 264;
    bytes += 4 * (f.corners.size() + f.ridges.size() + f.required_nodes.size() +
                  f.required_edges.size() + f.required_faces.size() + f.required_elements.size());
    if (options.carried) {
        for (const OpaqueRecord& record : *options.carried) {
            bytes += record.bytes.size() + 16;
        }
    }
    return static_cast<std::int64_t>(bytes);
}

void note_lost(const WriteOptions& options, const std::string& why,
               const std::vector<const OpaqueRecord*>& lost, std::vector<std::string>& notes) {
    if (!options.carried || lost.empty()) {
        return;
    }
    std::string words;
    for (const OpaqueRecord* record : lost) {
        words += (words.empty() ? "" : ", ") + word(record->keyword);
    }
    notes.push_back("left out, since " + why + ": " + words);
}

template <int D>
void write_binary(const std::filesystem::path& path, const Mesh<D>& mesh,
                  const std::map<int, std::string>& names, const WriteOptions& options,
                  std::vector<std::string>& notes) {
    const bool needs_double = options.version == 1 && !fits_float(flat<D>(mesh.points));
    const int version =
        version_for(options.version, needs_double, size_bound(mesh, options), notes);
    BinaryWriter writer(path, version, D);
    write_sections(writer, mesh, names);
    std::vector<const OpaqueRecord*> lost;
    if (options.carried) {
        for (const OpaqueRecord& record : *options.carried) {
            if (same_widths(record.version, version)) {
                writer.write_record(record);
            } else {
                lost.push_back(&record);
            }
        }
    }
    note_lost(options, "their numbers have other widths in version " + std::to_string(version),
              lost, notes);
    writer.commit();
}

} // namespace

template <int D>
std::vector<std::string> write_mesh(const std::filesystem::path& path, Form form,
                                    const Mesh<D>& mesh, const WriteOptions& options) {
    check_version(options);
    std::vector<std::string> notes;
    const std::map<int, std::string> names = portable_names(mesh.patch_names, notes);
    if (form == Form::binary) {
        write_binary(path, mesh, names, options, notes);
        return notes;
    }
    TextWriter writer(path, D);
    write_sections(writer, mesh, names);
    std::vector<const OpaqueRecord*> lost;
    if (options.carried) {
        for (const OpaqueRecord& record : *options.carried) {
            lost.push_back(&record);
        }
    }
    note_lost(options, "text files cannot hold them", lost, notes);
    writer.commit();
    return notes;
}

template <int D>
void write_tensors(const std::filesystem::path& path, Form form,
                   const IdVector<NodeId, Tensor<D>>& tensors, const WriteOptions& options) {
    check_version(options);
    constexpr std::size_t per_tensor = tensor_size<D>;
    std::vector<double> values(tensors.size() * per_tensor);
    for (const NodeId node : tensors.ids()) {
        for (std::size_t k = 0; k < per_tensor; ++k) {
            values[node.index() * per_tensor + static_cast<std::size_t>(tensor_place<D>[k])] =
                tensors[node][k];
        }
    }
    if (form == Form::text) {
        TextWriter writer(path, D);
        writer.write_tensors(values, per_tensor);
        writer.commit();
        return;
    }
    std::vector<std::string> notes;
    const bool needs_double = options.version == 1 && !fits_float(values);
    const auto bytes = static_cast<std::int64_t>(values.size() * 8 + 4096);
    BinaryWriter writer(path, version_for(options.version, needs_double, bytes, notes), D);
    writer.write_tensors(values, per_tensor);
    writer.commit();
}

template std::vector<std::string> write_mesh<2>(const std::filesystem::path&, Form, const Mesh<2>&,
                                                const WriteOptions&);
template std::vector<std::string> write_mesh<3>(const std::filesystem::path&, Form, const Mesh<3>&,
                                                const WriteOptions&);
template void write_tensors<2>(const std::filesystem::path&, Form,
                               const IdVector<NodeId, Tensor<2>>&, const WriteOptions&);
template void write_tensors<3>(const std::filesystem::path&, Form,
                               const IdVector<NodeId, Tensor<3>>&, const WriteOptions&);

} // namespace ameco::gmf
