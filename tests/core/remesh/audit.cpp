// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/remesh/audit.h"

#include "core/mesh/check.h"
#include "tests/core/remesh/remesh_support.h"

#include <cmath>
#include <optional>
#include <set>
#include <sstream>

#include <boost/multiprecision/cpp_int.hpp>

namespace ameco::remesh_test {
namespace {

namespace mp = boost::multiprecision;
/// Sums and products of three coordinates fit: these are below 2^4 and multiples of 2^-240.
using Exact = mp::number<mp::cpp_int_backend<1024, 1024, mp::signed_magnitude, mp::unchecked, void>,
                         mp::et_off>;

Exact exact(double x) {
    constexpr int places = 240;
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    const Exact digits(static_cast<long long>(std::ldexp(mantissa, 53)));
    const int shift = exponent - 53 + places;
    // Coordinates below 2^-187 would lose digits; none of the tests has such.
    return shift >= 0 ? digits << shift : digits >> -shift;
}

template <int D>
std::array<Exact, D> exact_vector(const Vec<D>& from, const Vec<D>& to) {
    std::array<Exact, D> out;
    for (int k = 0; k < D; ++k) {
        out[static_cast<std::size_t>(k)] = exact(to[k]) - exact(from[k]);
    }
    return out;
}

/// D! times the signed volume.
Exact exact_volume(const std::array<Vec<2>, 3>& x) {
    const auto a = exact_vector<2>(x[0], x[1]), b = exact_vector<2>(x[0], x[2]);
    return a[0] * b[1] - a[1] * b[0];
}
Exact exact_volume(const std::array<Vec<3>, 4>& x) {
    const auto a = exact_vector<3>(x[0], x[1]), b = exact_vector<3>(x[0], x[2]),
               c = exact_vector<3>(x[0], x[3]);
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

template <int D>
Exact exact_volume(const EditMesh<D>& mesh, const Simplex<D>& s) {
    std::array<Vec<D>, D + 1> x;
    for (int i = 0; i <= D; ++i) {
        x[i] = mesh.point(s[i]);
    }
    return exact_volume(x);
}

/// Twice the area, or the length, of a face in the plane of the other axes.
Exact exact_area(const std::array<Vec<2>, 2>& x, int normal) {
    return abs(exact(x[1][1 - normal]) - exact(x[0][1 - normal]));
}
Exact exact_area(const std::array<Vec<3>, 3>& x, int normal) {
    std::array<Vec<2>, 3> flat;
    for (std::size_t i = 0; i < 3; ++i) {
        flat[i] = {x[i][(normal + 1) % 3], x[i][(normal + 2) % 3]};
    }
    return abs(exact_volume(flat));
}

/// The axis along which some points agree; none where there is none.
template <int D, class Points>
std::optional<int> common_axis(const Points& x) {
    for (int k = 0; k < D; ++k) {
        if (std::all_of(x.begin(), x.end(), [&](const Vec<D>& p) { return p[k] == x[0][k]; })) {
            return k;
        }
    }
    return {};
}

template <int D, std::size_t N>
std::array<Vec<D>, N> points_of(const Mesh<D>& mesh, const std::array<NodeId, N>& nodes) {
    std::array<Vec<D>, N> x;
    std::transform(nodes.begin(), nodes.end(), x.begin(), [&](NodeId v) { return mesh.points[v]; });
    return x;
}

template <int D>
bool contains(const Simplex<D>& s, NodeId v) {
    return std::find(s.begin(), s.end(), v) != s.end();
}

/// Whether the balls hold what they should, and the marks of nodes are true.
template <int D>
std::string complaint_of_balls(const EditMesh<D>& mesh) {
    std::map<NodeId, std::size_t> uses;
    for (std::size_t i = 0; i < mesh.slot_count(); ++i) {
        const ElementId e(i);
        if (mesh.is_free(e)) {
            continue;
        }
        const Simplex<D> s = sorted(mesh.nodes(e));
        if (std::adjacent_find(s.begin(), s.end()) != s.end()) {
            return "an element has a node twice";
        }
        for (int k = 0; k <= D; ++k) {
            const NodeId v = mesh.nodes(e)[k];
            if (v == mesh.ghost()) {
                if (k != D) {
                    return "the ghost is not the last node of its element";
                }
                continue;
            }
            ++uses[v];
            const auto ball = mesh.ball(v);
            if (std::count(ball.begin(), ball.end(), e) != 1) {
                return "a ball does not hold an element once";
            }
        }
    }
    for (const NodeId v : mesh.nodes()) {
        const auto ball = mesh.ball(v);
        if (ball.size() != uses[v]) {
            return "a ball holds elements that are not at its node";
        }
        const bool at_ghost =
            std::any_of(ball.begin(), ball.end(), [&](ElementId e) { return mesh.is_ghost(e); });
        if (!ball.empty() && at_ghost != mesh.on_boundary(v)) {
            return "a node's mark says wrongly whether it is on the boundary";
        }
        if (!ball.empty() && mesh.node_class(v) == NodeClass::patch && !at_ghost) {
            return "a node of a patch is inside the domain";
        }
        if (!ball.empty() && mesh.node_class(v) == NodeClass::interior && at_ghost) {
            return "an interior node is on the boundary";
        }
    }
    return {};
}

/// Whether every facet is shared by two elements that see it from opposite sides.
template <int D>
std::string complaint_of_facets(const EditMesh<D>& mesh) {
    std::map<Facet<D>, std::vector<Facet<D>>> uses;
    for (std::size_t i = 0; i < mesh.slot_count(); ++i) {
        for (int k = 0; !mesh.is_free(ElementId(i)) && k <= D; ++k) {
            const Facet<D> f = facet_of<D>(mesh.nodes(ElementId(i)), k);
            uses[sorted(f)].push_back(f);
        }
    }
    for (const auto& [key, facets] : uses) {
        if (facets.size() != 2 || !oppositely_oriented(facets[0], facets[1])) {
            return "a facet is not shared by two elements that face each other";
        }
    }
    return {};
}

/// Whether ridges are edges of the mesh, and go on at their nodes.
template <int D>
std::string complaint_of_ridges(const EditMesh<D>& mesh, const typename EditMesh<D>::Compact& now) {
    if constexpr (D == 3) {
        std::map<NodeId, int> ends;
        for (const RidgeEdge& r : now.classes.ridges) {
            const NodeId a = now.parent[r.nodes[0]], b = now.parent[r.nodes[1]];
            const auto ball = mesh.ball(a);
            if (std::none_of(ball.begin(), ball.end(),
                             [&](ElementId e) { return contains<D>(mesh.nodes(e), b); })) {
                return "a ridge is no edge of the mesh";
            }
            ++ends[a];
            ++ends[b];
        }
        for (const NodeId v : mesh.nodes()) {
            if (!mesh.is_removed(v) && mesh.node_class(v) == NodeClass::ridge && ends[v] != 2) {
                return "a ridge ends at a node that is no corner";
            }
        }
    }
    return {};
}

} // namespace

template <int D>
struct Audit<D>::Kept {
    std::map<int, Exact> volume;                                       ///< by region
    std::map<std::tuple<int, int, double>, Exact> area;                ///< by patch, axis, place
    std::map<std::tuple<int, int, std::vector<double>>, Exact> length; ///< of ridges along axes
    Extent extent;                                                     ///< the same, rounded
    std::map<NodeId, Vec<D>> frozen;
    /// Kind, label, and corners of each thing that must be found again.
    std::multiset<std::tuple<std::string, int, std::vector<std::array<double, D>>>> entities;
    std::string complaint;
};

template <int D>
Audit<D>::Audit(const EditMesh<D>& mesh, double rounding) : rounding_(rounding) {
    kept_ = std::make_unique<Kept>(measure(mesh));
}

template <int D>
Audit<D>::~Audit() = default;

namespace {

/// Sums of areas over the plane sides of patches.
template <int D, class Kept>
void measure_sides(const EditMesh<D>& mesh, Kept& kept) {
    for (std::size_t i = 0; i < mesh.slot_count(); ++i) {
        const ElementId e(i);
        if (mesh.is_free(e) || !mesh.is_ghost(e)) {
            continue;
        }
        std::array<Vec<D>, D> x;
        for (int k = 0; k < D; ++k) {
            x[k] = mesh.point(mesh.nodes(e)[k]);
        }
        const auto axis = common_axis<D>(x);
        if (!axis) {
            kept.complaint = "a face of the boundary has left its plane";
            return;
        }
        kept.area[{mesh.element(e).label, *axis, x[0][*axis]}] += exact_area(x, *axis);
    }
}

/// Sums of lengths over the ridges on each line along an axis.
template <int D, class Kept>
void measure_ridges(const typename EditMesh<D>::Compact& now, Kept& kept) {
    for (const RidgeEdge& r : now.classes.ridges) {
        const auto x = points_of(now.mesh, r.nodes);
        int along = -1;
        std::vector<double> others;
        for (int k = 0; k < D; ++k) {
            if (x[0][k] == x[1][k]) {
                others.push_back(x[0][k]);
            } else {
                along = k;
            }
        }
        if (others.size() == D - 1) {
            kept.length[{r.listed ? r.label : -1, along, others}] +=
                abs(exact(x[1][along]) - exact(x[0][along]));
        }
    }
}

/// What must be found again, by its place.
template <int D, class Kept>
void collect_entities(const EditMesh<D>& mesh, const typename EditMesh<D>::Compact& now,
                      Kept& kept) {
    const Mesh<D>& m = now.mesh;
    const auto keep = [&](const char* what, int label, const auto& nodes) {
        kept.entities.emplace(what, label, place_of(m, nodes));
    };
    std::set<Facet<D>> boundary;
    for (std::size_t i = 0; i < mesh.slot_count(); ++i) {
        const ElementId e(i);
        if (!mesh.is_free(e) && mesh.is_ghost(e)) {
            boundary.insert(sorted(ghost_face<D>(mesh.nodes(e))));
        }
    }
    const auto& frozen = now.classes.frozen_patches;
    for (const FaceId f : m.faces.ids()) {
        Facet<D> here = m.faces[f];
        for (NodeId& v : here) {
            v = now.parent[v];
        }
        if (!boundary.contains(sorted(here))) {
            keep("inside", m.patch[f], m.faces[f]);
        } else if (std::find(frozen.begin(), frozen.end(), m.patch[f]) != frozen.end()) {
            keep("frozen", m.patch[f], m.faces[f]);
        }
    }
    const Features& features = m.features;
    for (const NodeId v : features.corners) {
        keep("corner", 0, std::array{v});
    }
    for (const NodeId v : features.required_nodes) {
        keep("required node", 0, std::array{v});
    }
    for (const int e : features.required_elements) {
        keep("required element", m.region[ElementId(e)], m.elements[ElementId(e)]);
    }
    for (const int f : features.required_faces) {
        keep("required face", m.patch[FaceId(f)], m.faces[FaceId(f)]);
    }
    for (const int e : features.required_edges) {
        if constexpr (D == 2) {
            keep("required edge", m.patch[FaceId(e)], m.faces[FaceId(e)]);
        } else {
            const auto i = static_cast<std::size_t>(e);
            keep("required edge", features.edge_labels[i], features.edges[i]);
        }
    }
    for (const int e : D == 2 ? features.ridges : std::vector<int>{}) {
        keep("ridge", m.patch[FaceId(e)], m.faces[FaceId(e)]);
    }
}

} // namespace

template <int D>
typename Audit<D>::Kept Audit<D>::measure(const EditMesh<D>& mesh) const {
    Kept kept;
    const auto now = mesh.compact();
    const CheckReport report = check(now.mesh);
    kept.complaint = report.valid() ? std::string() : report.summary();
    if (!kept.complaint.empty()) {
        return kept;
    }
    for (const std::string& found :
         {complaint_of_balls(mesh), complaint_of_facets(mesh), complaint_of_ridges(mesh, now)}) {
        if (!found.empty()) {
            kept.complaint = found;
            return kept;
        }
    }
    if (rounding_ == 0) {
        for (const ElementId e : now.mesh.elements.ids()) {
            kept.volume[now.mesh.region[e]] +=
                exact_volume(corners_of(now.mesh, now.mesh.elements[e]));
        }
        measure_sides(mesh, kept);
        measure_ridges<D>(now, kept);
    }
    kept.extent = extent(now.mesh);
    for (const NodeId v : now.parent.ids()) {
        if (now.classes.node[v] == NodeClass::frozen) {
            kept.frozen.emplace(now.parent[v], now.mesh.points[v]);
        }
    }
    collect_entities(mesh, now, kept);
    return kept;
}

template <int D>
std::string Audit<D>::complaint(const EditMesh<D>& mesh) const {
    const Kept now = measure(mesh);
    if (!now.complaint.empty()) {
        return now.complaint;
    }
    if (now.volume != kept_->volume) {
        return "the volume of a region has changed";
    }
    if (now.area != kept_->area) {
        return "the area of a patch has changed";
    }
    if (now.length != kept_->length) {
        return "the length of a ridge has changed";
    }
    const double changed = difference(now.extent, kept_->extent);
    if (!(changed <= std::max(rounding_, 1e-12))) {
        std::ostringstream text;
        text << "volumes or areas have changed by " << changed;
        return text.str();
    }
    if (now.frozen != kept_->frozen) {
        return "a frozen node has gone or moved";
    }
    if (now.entities != kept_->entities) {
        return "an entity that must be kept has gone";
    }
    return {};
}

template <int D>
StarVolumes compare_volumes(const EditMesh<D>& mesh, const Cavity<D>& cavity, const Star<D>& star) {
    Exact before = 0, after = 0, positive = 0;
    StarVolumes out{.equal = false, .minimal = false, .all_positive = true, .never_smaller = false};
    for (const ElementId e : cavity.elements) {
        before += mesh.is_ghost(e) ? Exact(0) : exact_volume(mesh, mesh.nodes(e));
    }
    for (const EditElement<D>& e : star.elements) {
        if (e.nodes[D] != mesh.ghost()) {
            const Exact v = exact_volume(mesh, e.nodes);
            out.all_positive = out.all_positive && v > 0;
            after += v;
            positive += abs(v);
        }
    }
    out.all_positive = out.all_positive && positive > 0;
    out.equal = after == before;
    out.minimal = positive == before;
    out.never_smaller = positive >= before;
    return out;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template class Audit<D>;                                                                       \
    template StarVolumes compare_volumes(const EditMesh<D>&, const Cavity<D>&, const Star<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco::remesh_test
