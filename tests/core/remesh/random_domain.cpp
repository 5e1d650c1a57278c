// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/remesh/random_domain.h"

#include "core/mesh/check.h"
#include "tests/support/shapes.h"

#include <cmath>
#include <set>
#include <stdexcept>

#include <Eigen/Geometry>

namespace ameco::remesh_test {
namespace {

double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

/// Grid lines from 0 to 1 at random distances.
std::vector<double> grid_lines(int cells, std::mt19937& random) {
    std::vector<double> x{0};
    for (int i = 1; i < cells; ++i) {
        x.push_back((i + uniform(random, -0.3, 0.3)) / cells);
    }
    x.push_back(1);
    return x;
}

template <int D>
using GridLines = std::array<std::vector<double>, D>;

Mesh<2> mesh_of(const GridLines<2>& lines) {
    return shapes::rectangle(lines[0], lines[1]);
}
Mesh<3> mesh_of(const GridLines<3>& lines) {
    return shapes::box(lines[0], lines[1], lines[2]);
}

template <int D>
Vec<D> centre(const Mesh<D>& mesh, const Simplex<D>& s) {
    Vec<D> sum = Vec<D>::Zero();
    for (const NodeId v : s) {
        sum += mesh.points[v] / (D + 1);
    }
    return sum;
}

/// Drops nodes without elements, and gives the others new numbers in random order.
template <int D>
void renumber(Mesh<D>& mesh, std::mt19937& random) {
    std::vector<NodeId> used;
    {
        std::set<NodeId> found;
        for (const Simplex<D>& s : mesh.elements) {
            found.insert(s.begin(), s.end());
        }
        used.assign(found.begin(), found.end());
    }
    std::shuffle(used.begin(), used.end(), random);
    IdVector<NodeId, NodeId> fresh(mesh.points.size());
    IdVector<NodeId, Vec<D>> points;
    for (const NodeId v : used) {
        fresh[v] = points.next_id();
        points.push_back(mesh.points[v]);
    }
    mesh.points = points;
    for (Simplex<D>& s : mesh.elements) {
        for (NodeId& v : s) {
            v = fresh[v];
        }
    }
    std::shuffle(mesh.elements.begin(), mesh.elements.end(), random);
}

/// A rectangle of cells in a grid plane x = `plane`: the ranges of the other coordinates.
template <int D>
struct PlaneCells {
    double plane = 0;
    std::array<double, D> low{}, high{};

    [[nodiscard]] bool holds(const Vec<D>& p) const {
        bool inside = p[0] == plane;
        for (int k = 1; k < D; ++k) {
            inside = inside && p[k] >= low[k] && p[k] <= high[k];
        }
        return inside;
    }
    /// Whether all cells of the plane at a node are among them: on the box's own sides there are
    /// none beyond.
    [[nodiscard]] bool surrounds(const Vec<D>& p) const {
        bool inside = holds(p);
        for (int k = 1; k < D; ++k) {
            inside = inside && (p[k] > low[k] || low[k] == 0) && (p[k] < high[k] || high[k] == 1);
        }
        return inside;
    }
};

template <int D>
PlaneCells<D> random_plane_cells(const GridLines<D>& lines, std::mt19937& random) {
    PlaneCells<D> cells;
    cells.plane = lines[0][1 + random() % (lines[0].size() - 2)];
    for (int k = 1; k < D; ++k) {
        const std::size_t n = lines[k].size() - 1;
        const std::size_t first = random() % n;
        cells.low[k] = lines[k][first];
        cells.high[k] = lines[k][first + 1 + random() % (n - first)];
    }
    return cells;
}

/// A slit from y = 0 to a line of the grid, through the whole box: its rim is straight. One that
/// ends inside the box would have a rim along the diagonals of its outer cells, whose three nodes
/// are all on it.
template <int D>
PlaneCells<D> random_slit(const GridLines<D>& lines, std::mt19937& random) {
    PlaneCells<D> cells;
    cells.plane = lines[0][1 + random() % (lines[0].size() - 2)];
    cells.high.fill(1);
    cells.high[1] = lines[1][1 + random() % (lines[1].size() - 2)];
    return cells;
}

/// Takes a block of cells out that leaves some on each side along x.
template <int D>
void cut_hole(Mesh<D>& mesh, const GridLines<D>& lines, std::mt19937& random) {
    std::array<double, D> low{}, high{};
    for (int k = 0; k < D; ++k) {
        low[k] = lines[k][1];
        high[k] = lines[k][lines[k].size() - 2];
    }
    if (D == 3 && random() % 2 == 0) { // through the box
        low[D - 1] = 0;
        high[D - 1] = 1;
    }
    IdVector<ElementId, Simplex<D>> kept;
    for (const Simplex<D>& s : mesh.elements) {
        const Vec<D> c = centre(mesh, s);
        bool inside = true;
        for (int k = 0; k < D; ++k) {
            inside = inside && c[k] > low[k] && c[k] < high[k];
        }
        if (!inside) {
            kept.push_back(s);
        }
    }
    mesh.elements = kept;
}

/// Gives the elements beyond the plane nodes of their own where the slit is all around.
template <int D>
void cut_slit(Mesh<D>& mesh, const PlaneCells<D>& slit) {
    std::map<NodeId, NodeId> twin;
    for (Simplex<D>& s : mesh.elements) {
        if (centre(mesh, s)[0] < slit.plane) {
            continue;
        }
        for (NodeId& v : s) {
            const Vec<D> p = mesh.points[v];
            if (slit.surrounds(p)) {
                const auto [it, fresh] = twin.emplace(v, mesh.points.next_id());
                if (fresh) {
                    mesh.points.push_back(p);
                }
                v = it->second;
            }
        }
    }
}

/// Replaces elements by their children from a new node, if these are all positive.
template <int D>
void insert(Mesh<D>& mesh, const std::vector<ElementId>& old, const Vec<D>& p,
            const std::vector<Simplex<D>>& children) {
    mesh.points.push_back(p);
    for (const Simplex<D>& s : children) {
        if (orientation(mesh, s) <= 0) {
            mesh.points.pop_back();
            return;
        }
    }
    for (std::size_t i = 0; i < children.size(); ++i) {
        if (i < old.size()) {
            mesh.elements[old[i]] = children[i];
        } else {
            mesh.elements.push_back(children[i]);
        }
    }
}

/// A node inside an element, anywhere.
template <int D>
void insert_inside(Mesh<D>& mesh, std::mt19937& random) {
    const ElementId e(random() % mesh.elements.size());
    const Simplex<D> s = mesh.elements[e];
    Vec<D> p = Vec<D>::Zero();
    double sum = 0;
    for (const NodeId v : s) {
        const double w = std::pow(uniform(random, 0.1, 1), 2);
        p += w * mesh.points[v];
        sum += w;
    }
    std::vector<Simplex<D>> children;
    for (int i = 0; i <= D; ++i) {
        children.push_back(s);
        children.back()[i] = mesh.points.next_id();
    }
    insert<D>(mesh, {e}, p / sum, children);
}

/// A node on an edge, be it on the boundary or not.
template <int D>
void insert_on_edge(Mesh<D>& mesh, std::mt19937& random) {
    Simplex<D> s = mesh.elements[ElementId(random() % mesh.elements.size())];
    std::shuffle(s.begin(), s.end(), random);
    const NodeId a = s[0], b = s[1];
    std::vector<ElementId> old;
    std::vector<Simplex<D>> children;
    for (const ElementId e : mesh.elements.ids()) {
        Simplex<D> t = mesh.elements[e];
        const auto at_a = std::find(t.begin(), t.end(), a), at_b = std::find(t.begin(), t.end(), b);
        if (at_a != t.end() && at_b != t.end()) {
            old.push_back(e);
            for (const auto& [gone, back] : {std::pair(at_a, a), std::pair(at_b, b)}) {
                *gone = mesh.points.next_id();
                children.push_back(t);
                *gone = back;
            }
        }
    }
    const Vec<D> p =
        mesh.points[a] + uniform(random, 0.15, 0.85) * (mesh.points[b] - mesh.points[a]);
    insert(mesh, old, p, children);
}

/// Regions on both sides of a plane, and the faces between them if they are to be listed.
template <int D>
void add_regions(Mesh<D>& mesh, double plane, bool list_faces) {
    for (const ElementId e : mesh.elements.ids()) {
        mesh.region[e] = centre(mesh, mesh.elements[e])[0] < plane ? 2 : 1;
        for (int i = 0; list_faces && mesh.region[e] == 1 && i <= D; ++i) {
            const Facet<D> f = facet_of<D>(mesh.elements[e], i);
            if (std::all_of(f.begin(), f.end(),
                            [&](NodeId v) { return mesh.points[v][0] == plane; })) {
                mesh.faces.push_back(f);
                mesh.patch.push_back(20);
            }
        }
    }
}

/// Lists the facets of elements that lie in the cells of a plane, each once.
template <int D>
void add_baffle(Mesh<D>& mesh, const PlaneCells<D>& cells) {
    for (const Simplex<D>& s : mesh.elements) {
        for (int i = 0; centre(mesh, s)[0] > cells.plane && i <= D; ++i) {
            const Facet<D> f = facet_of<D>(s, i);
            if (std::all_of(f.begin(), f.end(),
                            [&](NodeId v) { return cells.holds(mesh.points[v]); })) {
                mesh.faces.push_back(f);
                mesh.patch.push_back(30);
            }
        }
    }
}

/// Entities that a file wants to keep, of each kind with some luck.
template <int D>
void add_features(RandomDomain<D>& domain, std::mt19937& random) {
    Mesh<D>& mesh = domain.mesh;
    Features& features = mesh.features;
    const auto lucky = [&] { return random() % 3 == 0; };
    const auto any_face = [&] { return static_cast<int>(random() % mesh.faces.size()); };
    if (lucky()) {
        domain.features.frozen_patches = {pick(mesh.patch, random)};
    }
    if (lucky()) {
        features.required_nodes = {pick(pick(mesh.elements, random), random)};
        features.corners = {pick(pick(mesh.faces, random), random)};
    }
    if (lucky()) {
        features.required_elements = {static_cast<int>(random() % mesh.elements.size())};
    }
    if constexpr (D == 2) {
        if (lucky()) {
            features.required_edges = {any_face()};
        }
        if (lucky()) {
            features.ridges = {any_face()};
        }
    } else {
        if (lucky()) {
            features.required_faces = {any_face()};
        }
        if (lucky()) {
            const Facet<3>& f = mesh.faces[FaceId(any_face())];
            features.edges = {{f[0], f[1]}, {f[1], f[2]}, {f[2], f[0]}};
            features.edge_labels = {5, 6, 6};
            features.ridges = {1};
            features.required_edges = {static_cast<int>(random() % 3)};
        }
    }
}

/// Turns all points by a fixed angle about each axis in turn.
template <int D>
void turn(Mesh<D>& mesh) {
    Mat<D> turn;
    if constexpr (D == 2) {
        turn = Eigen::Rotation2Dd(0.4).toRotationMatrix();
    } else {
        turn = (Eigen::AngleAxisd(0.4, Vec<3>::UnitX()) * Eigen::AngleAxisd(0.7, Vec<3>::UnitY()) *
                Eigen::AngleAxisd(1.1, Vec<3>::UnitZ()))
                   .toRotationMatrix();
    }
    for (Vec<D>& p : mesh.points) {
        p = turn * p;
    }
}

template <int D>
RandomDomain<D> try_domain(DomainKind kind, std::mt19937& random) {
    GridLines<D> lines;
    const int cells = kind == DomainKind::hole ? 3 : 2;
    for (auto& x : lines) {
        x = grid_lines(cells + static_cast<int>(random() % (D == 2 ? 3 : 1)), random);
    }
    RandomDomain<D> domain;
    domain.mesh = mesh_of(lines);
    Mesh<D>& mesh = domain.mesh;
    mesh.faces.clear();
    mesh.patch.clear();
    const PlaneCells<D> wall = random_plane_cells<D>(lines, random);
    if (kind == DomainKind::hole) {
        cut_hole<D>(mesh, lines, random);
    } else if (kind == DomainKind::slit) {
        cut_slit(mesh, random_slit<D>(lines, random));
    }
    // With few points the walls of a hole are one element thick.
    const int points = static_cast<int>(random() % (D == 2 ? 90 : 60));
    for (int i = 0; i < points; ++i) {
        if (random() % 2 == 0) {
            insert_inside(mesh, random);
        } else {
            insert_on_edge(mesh, random);
        }
    }
    const int axis = static_cast<int>(random() % D);
    const double stretch = std::ldexp(1.0, -static_cast<int>(random() % 21));
    renumber(mesh, random);
    mesh.region.assign(mesh.elements.size(), 1);
    shapes::add_boundary(mesh);
    if (random() % 4 != 0) { // otherwise the whole boundary is one patch
        shapes::number_box_sides(mesh);
    }
    if (kind == DomainKind::regions || kind == DomainKind::unlisted_regions) {
        add_regions(mesh, wall.plane, kind == DomainKind::regions);
    } else if (kind == DomainKind::baffle) {
        add_baffle(mesh, wall);
    }
    for (Vec<D>& p : mesh.points) {
        p[axis] *= stretch;
    }
    if (kind == DomainKind::turned) {
        turn(mesh);
        domain.rounding = 1e-13 / stretch; // nodes leave their sides by 1e-16, over the thickness
    }
    add_features(domain, random);
    return domain;
}

} // namespace

const char* name(DomainKind kind) {
    switch (kind) {
    case DomainKind::plain:
        return "box";
    case DomainKind::regions:
        return "two regions";
    case DomainKind::unlisted_regions:
        return "two regions, border not listed";
    case DomainKind::baffle:
        return "baffle";
    case DomainKind::slit:
        return "slit";
    case DomainKind::hole:
        return "hole";
    case DomainKind::turned:
        return "turned box";
    }
    return "";
}

template <int D>
RandomDomain<D> random_domain(DomainKind kind, unsigned seed) {
    std::mt19937 random(seed * 16 + static_cast<unsigned>(kind));
    // Turned and flattened slivers may be turned over.
    for (int attempt = 0; attempt < 50; ++attempt) {
        RandomDomain<D> domain = try_domain<D>(kind, random);
        if (check(domain.mesh).valid()) {
            return domain;
        }
    }
    throw std::logic_error("no valid mesh of this kind was found");
}

template RandomDomain<2> random_domain(DomainKind, unsigned);
template RandomDomain<3> random_domain(DomainKind, unsigned);

} // namespace ameco::remesh_test
