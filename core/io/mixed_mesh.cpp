// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/mixed_mesh.h"

#include "core/mesh/references.h"
#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco {
namespace {

[[noreturn]] void fail(const FileContext& context, const std::string& what) {
    throw InputError(context.name + ": " + what);
}

/// "12 prisms and 3 pyramids"
struct CountList {
    std::vector<std::string> items;
    std::size_t total = 0;

    void add(std::size_t count, CellType type) {
        total += count;
        if (count > 0) {
            items.push_back(std::to_string(count) + " " +
                            std::string(count == 1 ? info(type).name : info(type).plural));
        }
    }
    [[nodiscard]] const char* were() const { return total == 1 ? " was" : " were"; }
    [[nodiscard]] std::string text() const {
        std::string result;
        for (std::size_t i = 0; i < items.size(); ++i) {
            result += i == 0 ? "" : i + 1 < items.size() ? ", " : " and ";
            result += items[i];
        }
        return result;
    }
};

template <int D>
void check_points(const MixedMesh<D>& mixed, const FileContext& context) {
    for (const NodeId node : mixed.points.ids()) {
        if (!mixed.points[node].allFinite()) {
            fail(context, "vertex " + std::to_string(node.value() + context.first_number) +
                              " has a coordinate that is not finite (NaN or infinity); repair "
                              "the file");
        }
    }
}

template <std::size_t N>
void check_cells(const Cells<N>& cells, CellType type, std::size_t node_count,
                 const FileContext& context) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (const NodeId node : cells.nodes[i]) {
            if (!node.valid() || node.index() >= node_count) {
                fail(context,
                     std::string(info(type).name) + " " +
                         std::to_string(i + static_cast<std::size_t>(context.first_number)) +
                         " uses node " +
                         std::to_string(std::int64_t{node.value()} + context.first_number) +
                         ", but the file has " + std::to_string(node_count) + " nodes");
            }
        }
    }
}

/// Turns simplices if some are negative and none is positive.
/// \return  whether it did
template <int D>
bool turn_if_negative(const IdVector<NodeId, Vec<D>>& points, std::span<Simplex<D>> simplices) {
    bool negative = false;
    for (const Simplex<D>& s : simplices) {
        std::array<Vec<D>, D + 1> x;
        for (std::size_t k = 0; k <= D; ++k) {
            x[k] = points[s[k]];
        }
        const int sign = std::apply([](const auto&... p) { return orientation(p...); }, x);
        if (sign > 0) {
            return false; // for most meshes, at the first one
        }
        negative = negative || sign < 0;
    }
    if (negative) {
        for (Simplex<D>& s : simplices) {
            std::swap(s[D - 1], s[D]);
        }
    }
    return negative;
}

/// Adds the parts of some cells to the elements of a mesh.
class Splitter {
public:
    explicit Splitter(Mesh<3>& mesh) : mesh_(mesh) {}

    template <std::size_t N>
    void add(CellType type, Cells<N>& cells) {
        counts_.add(cells.size(), type);
        std::vector<Simplex<3>>& elements = mesh_.elements.raw();
        const std::size_t first = elements.size();
        for (std::size_t i = 0; i < cells.size(); ++i) {
            split_cell(type, cells.nodes[i], elements);
            mesh_.region.resize(elements.size(), cells.labels[i]);
        }
        cells = {};
        turn_if_negative<3>(mesh_.points, {elements.data() + first, elements.size() - first});
    }
    void add(Cells<4>& quadrilaterals) {
        face_counts_.add(quadrilaterals.size(), CellType::quadrilateral);
        for (std::size_t i = 0; i < quadrilaterals.size(); ++i) {
            split_quadrilateral(quadrilaterals.nodes[i], mesh_.faces.raw());
            mesh_.patch.resize(mesh_.faces.size(), quadrilaterals.labels[i]);
        }
        quadrilaterals = {};
    }
    /// What was split, or nothing.
    [[nodiscard]] std::string note(std::size_t simplices) const {
        std::string text = counts_.text();
        if (!counts_.items.empty()) {
            text += std::string(counts_.were()) + " split into " +
                    std::to_string(mesh_.elements.size() - simplices) + " tetrahedra";
        }
        if (!face_counts_.items.empty()) {
            text += text.empty() ? face_counts_.text() + face_counts_.were() + " split"
                                 : ", " + face_counts_.text();
            text += " into triangles";
        }
        return text;
    }

private:
    Mesh<3>& mesh_;
    CountList counts_;
    CountList face_counts_;
};

bool has_volume(const MixedMesh<3>& mixed) {
    return mixed.tetrahedra.size() + mixed.pyramids.size() + mixed.prisms.size() +
               mixed.hexahedra.size() >
           0;
}

/// A mesh has no place for names of regions; their numbers stay.
void say_region_names(const std::map<int, std::string>& names, MeshFile& file) {
    std::string list;
    for (const auto& [region, name] : names) {
        list += (list.empty() ? "" : ", ") + std::to_string(region) + " " + name;
    }
    if (!list.empty()) {
        file.notes.push_back("names of regions are left out: " + list);
    }
}

/// Mesh with volume, or a surface.
Mesh<3> to_solid(MixedMesh<3>&& mixed, MeshFile& file) {
    Mesh<3> mesh;
    mesh.points = std::move(mixed.points);
    mesh.labels = std::move(mixed.labels);
    mesh.elements.raw() = std::move(mixed.tetrahedra.nodes);
    mesh.region.raw() = std::move(mixed.tetrahedra.labels);
    mesh.faces.raw() = std::move(mixed.triangles.nodes);
    mesh.patch.raw() = std::move(mixed.triangles.labels);
    mesh.patch_names = std::move(mixed.face_names);
    say_region_names(mixed.cell_names, file);
    mesh.features = std::move(mixed.features);
    mesh.features.edges = std::move(mixed.lines.nodes);
    mesh.features.edge_labels = std::move(mixed.lines.labels);
    if (mixed.pyramids.size() + mixed.prisms.size() + mixed.hexahedra.size() > 0) {
        // With positive cells beside them, complete_boundary would not turn these.
        turn_if_negative<3>(mesh.points, {mesh.elements.data(), mesh.elements.size()});
    }
    const std::size_t simplices = mesh.elements.size();
    Splitter splitter(mesh);
    splitter.add(CellType::prism, mixed.prisms);
    splitter.add(CellType::pyramid, mixed.pyramids);
    splitter.add(CellType::hexahedron, mixed.hexahedra);
    splitter.add(mixed.quadrilaterals);
    if (std::string note = splitter.note(simplices); !note.empty()) {
        file.changes.push_back(std::move(note));
    }
    return mesh;
}

/// Both triangles of a quadrilateral, cut from its node of smallest number unless only the other
/// diagonal lies inside.
void split_in_plane(const IdVector<NodeId, Vec<2>>& points, const std::array<NodeId, 4>& q,
                    std::vector<Simplex<2>>& parts) {
    const auto first = static_cast<std::size_t>(std::min_element(q.begin(), q.end()) - q.begin());
    const auto cut_at = [&](std::size_t i) {
        const auto at = [&](std::size_t k) { return q[(i + k) % 4]; };
        return std::array<Simplex<2>, 2>{{{at(0), at(1), at(2)}, {at(0), at(2), at(3)}}};
    };
    const auto sign = [&](const Simplex<2>& t) {
        return orientation(points[t[0]], points[t[1]], points[t[2]]);
    };
    const auto agree = [&](const std::array<Simplex<2>, 2>& cut) {
        return sign(cut[0]) * sign(cut[1]) > 0;
    };
    std::array<Simplex<2>, 2> cut = cut_at(first);
    if (!agree(cut) && agree(cut_at(first + 1))) {
        cut = cut_at(first + 1);
    }
    for (const Simplex<2>& t : cut) {
        if (!has_repetition(t)) {
            parts.push_back(t);
        }
    }
}

Mesh<2> to_plane(MixedMesh<2>&& mixed, MeshFile& file) {
    Mesh<2> mesh;
    mesh.points = std::move(mixed.points);
    mesh.labels = std::move(mixed.labels);
    mesh.elements.raw() = std::move(mixed.triangles.nodes);
    mesh.region.raw() = std::move(mixed.triangles.labels);
    mesh.faces.raw() = std::move(mixed.lines.nodes);
    mesh.patch.raw() = std::move(mixed.lines.labels);
    mesh.patch_names = std::move(mixed.line_names);
    say_region_names(mixed.face_names, file);
    mesh.features = std::move(mixed.features);
    if (const std::size_t quads = mixed.quadrilaterals.size(); quads > 0) {
        std::vector<Simplex<2>>& elements = mesh.elements.raw();
        turn_if_negative<2>(mesh.points, elements);
        const std::size_t first = elements.size();
        for (std::size_t i = 0; i < quads; ++i) {
            split_in_plane(mesh.points, mixed.quadrilaterals.nodes[i], elements);
            mesh.region.resize(elements.size(), mixed.quadrilaterals.labels[i]);
        }
        turn_if_negative<2>(mesh.points, {elements.data() + first, elements.size() - first});
        CountList counts;
        counts.add(quads, CellType::quadrilateral);
        file.changes.push_back(counts.text() + counts.were() + " split into " +
                               std::to_string(elements.size() - first) + " triangles");
    }
    return mesh;
}

bool is_planar(const MixedMesh<3>& mixed) {
    const double z = mixed.points[NodeId(0)].z();
    return std::all_of(mixed.points.begin(), mixed.points.end(),
                       [&](const Vec<3>& x) { return x.z() == z; });
}

/// Cells in a plane z = const, stored in 3-D, as the 2-D mesh they are.
MixedMesh<2> flatten(MixedMesh<3>&& solid) {
    MixedMesh<2> flat;
    flat.points.resize(solid.points.size(), Vec<2>::Zero());
    for (const NodeId node : solid.points.ids()) {
        flat.points[node] = solid.points[node].head<2>();
    }
    flat.labels = std::move(solid.labels);
    flat.lines = std::move(solid.lines);
    flat.triangles = std::move(solid.triangles);
    flat.quadrilaterals = std::move(solid.quadrilaterals);
    if (solid.face_names != solid.line_names) { // .vtu names patches, whatever their dimension
        flat.face_names = std::move(solid.face_names);
    }
    flat.line_names = std::move(solid.line_names);
    flat.features.corners = std::move(solid.features.corners);
    flat.features.ridges = std::move(solid.features.ridges);
    flat.features.required_nodes = std::move(solid.features.required_nodes);
    flat.features.required_edges = std::move(solid.features.required_edges);
    flat.features.required_elements = std::move(solid.features.required_faces);
    return flat;
}

void finish(MixedMesh<3>&& mixed, const FileContext& context, MeshFile& file) {
    if (has_volume(mixed)) {
        Mesh<3> mesh = to_solid(std::move(mixed), file);
        if (mesh.elements.empty()) {
            fail(context, "holds degenerate cells only; there is nothing to work on");
        }
        file.mesh = std::move(mesh);
        return;
    }
    const std::size_t faces = mixed.triangles.size() + mixed.quadrilaterals.size();
    if (faces == 0) {
        fail(context, "holds no tetrahedra; there is nothing to work on");
    }
    if (is_planar(mixed)) {
        file.notes.push_back("all z are equal and there are no tetrahedra: taken as a 2-D mesh");
        file.mesh = to_plane(flatten(std::move(mixed)), file);
        return;
    }
    if (!context.surfaces) {
        fail(context, "is a surface of " + std::to_string(faces) +
                          " triangles without tetrahedra; fill it with a volume mesher first");
    }
    file.mesh = to_solid(std::move(mixed), file);
}

void finish(MixedMesh<2>&& mixed, const FileContext& context, MeshFile& file) {
    if (mixed.tetrahedra.size() + mixed.pyramids.size() + mixed.prisms.size() +
            mixed.hexahedra.size() >
        0) {
        fail(context, "holds cells with volume, but its dimension is 2; write it with dimension 3");
    }
    if (mixed.triangles.size() + mixed.quadrilaterals.size() == 0) {
        fail(context, "holds no triangles; there is nothing to work on");
    }
    file.mesh = to_plane(std::move(mixed), file);
}

template <std::size_t N>
void add_to(Cells<N>& cells, std::span<const NodeId> nodes, int label) {
    std::array<NodeId, N> cell;
    std::copy_n(nodes.begin(), N, cell.begin());
    cells.add(cell, label);
}

} // namespace

template <int D>
void finish_mesh(MixedMesh<D>&& mixed, const FileContext& context, MeshFile& file) {
    if (mixed.points.empty()) {
        fail(context, "holds no vertices; it is not a mesh, or damaged");
    }
    check_points(mixed, context);
    for_each_kind(mixed, [&](CellType type, const auto& cells) {
        check_cells(cells, type, mixed.points.size(), context);
    });
    finish(std::move(mixed), context, file);
}

template <int D>
void add_cell(MixedMesh<D>& mixed, CellType type, std::span<const NodeId> nodes, int label) {
    for_each_kind(mixed, [&](CellType kind, auto& cells) {
        if (kind == type) {
            add_to(cells, nodes, label);
        }
    });
}

template <int D>
void reserve_cells(MixedMesh<D>& mixed, CellType type, std::size_t count) {
    for_each_kind(mixed, [&](CellType kind, auto& cells) {
        if (kind == type) {
            cells.nodes.reserve(cells.size() + count);
            cells.labels.reserve(cells.size() + count);
        }
    });
}

template void finish_mesh(MixedMesh<2>&&, const FileContext&, MeshFile&);
template void finish_mesh(MixedMesh<3>&&, const FileContext&, MeshFile&);
template void add_cell(MixedMesh<2>&, CellType, std::span<const NodeId>, int);
template void add_cell(MixedMesh<3>&, CellType, std::span<const NodeId>, int);
template void reserve_cells(MixedMesh<2>&, CellType, std::size_t);
template void reserve_cells(MixedMesh<3>&, CellType, std::size_t);

} // namespace ameco
