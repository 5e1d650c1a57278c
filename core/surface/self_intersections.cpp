// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/self_intersections.h"

#include "core/base/parallel.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/simplex.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace ameco {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Point point(const Mesh<3>& mesh, NodeId v) {
    const Vec<3>& x = mesh.points[v];
    return {x[0], x[1], x[2]};
}

Kernel::Triangle_3 triangle(const Mesh<3>& mesh, const Facet<3>& f) {
    return {point(mesh, f[0]), point(mesh, f[1]), point(mesh, f[2])};
}

bool contains(const Facet<3>& f, NodeId v) {
    return std::find(f.begin(), f.end(), v) != f.end();
}

/// The face with its shared nodes in front.
Facet<3> shared_first(Facet<3> f, const Facet<3>& other) {
    std::stable_partition(f.begin(), f.end(), [&](NodeId v) { return contains(other, v); });
    return f;
}

/// Two faces with a common edge: they meet beyond it if both lie on the same side of it in one
/// plane.
bool fold_onto_each_other(const Mesh<3>& mesh, const Facet<3>& f, const Facet<3>& g) {
    const Point a = point(mesh, f[0]), b = point(mesh, f[1]);
    const Point c = point(mesh, f[2]), d = point(mesh, g[2]);
    return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
}

/// Two faces with a common node: they meet beyond it if the edge opposite the node in one meets the
/// other, since where two triangles meet in a segment that begins at the node, it ends at the
/// border of one of them, on the opposite edge.
bool meet_beyond_node(const Mesh<3>& mesh, const Facet<3>& f, const Facet<3>& g) {
    const Kernel::Segment_3 opposite_f(point(mesh, f[1]), point(mesh, f[2]));
    const Kernel::Segment_3 opposite_g(point(mesh, g[1]), point(mesh, g[2]));
    return CGAL::do_intersect(opposite_f, triangle(mesh, g)) ||
           CGAL::do_intersect(opposite_g, triangle(mesh, f));
}

bool intersect(const Mesh<3>& mesh, const Facet<3>& f, const Facet<3>& g) {
    const Facet<3> a = shared_first(f, g), b = shared_first(g, f);
    switch (std::count_if(f.begin(), f.end(), [&](NodeId v) { return contains(g, v); })) {
    case 0:
        return CGAL::do_intersect(triangle(mesh, f), triangle(mesh, g));
    case 1:
        return meet_beyond_node(mesh, a, b);
    case 2:
        return fold_onto_each_other(mesh, a, b);
    default:
        return false; // the same nodes: a duplicate
    }
}

} // namespace

std::vector<std::array<FaceId, 2>> self_intersections(const Mesh<3>& mesh) {
    const std::size_t k = mesh.faces.size();
    std::vector<Box<3>> boxes(k);
    std::vector<char> flat(k);
    for (const FaceId f : mesh.faces.ids()) {
        for (const NodeId v : mesh.faces[f]) {
            boxes[f.index()].extend(mesh.points[v]);
        }
        flat[f.index()] = triangle(mesh, mesh.faces[f]).is_degenerate() ? 1 : 0;
    }
    const BoxTree<3> tree(boxes);
    constexpr std::size_t grain = 1024;
    std::vector<std::vector<std::array<FaceId, 2>>> pieces((k + grain - 1) / grain);
    parallel_for(k, grain, [&](std::size_t begin, std::size_t end) {
        auto& found = pieces[begin / grain];
        for (std::size_t i = begin; i < end; ++i) {
            if (flat[i] != 0) {
                continue;
            }
            tree.visit([&](const Box<3>& box) { return box.intersects(boxes[i]); },
                       [&](std::int32_t item) {
                           const auto j = static_cast<std::size_t>(item);
                           if (j > i && flat[j] == 0 && boxes[j].intersects(boxes[i]) &&
                               intersect(mesh, mesh.faces[FaceId(i)], mesh.faces[FaceId(j)])) {
                               found.push_back({FaceId(i), FaceId(j)});
                           }
                       });
        }
    });
    std::vector<std::array<FaceId, 2>> all;
    for (const auto& piece : pieces) {
        all.insert(all.end(), piece.begin(), piece.end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

} // namespace ameco
