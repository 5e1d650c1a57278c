// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/cavity.h"

#include "core/base/parallel.h"
#include "core/geometry/predicates.h"

#include <algorithm>

namespace ameco {
namespace {

template <class Nodes>
bool contains(const Nodes& nodes, NodeId v) {
    return std::find(nodes.begin(), nodes.end(), v) != nodes.end();
}

/// Of a node that a simplex has, without a branch.
template <int D>
int position_in(const Simplex<D>& s, NodeId v) {
    int position = 0;
    for (int i = 1; i <= D; ++i) {
        position += s[i] == v ? i : 0;
    }
    return position;
}

/// Of a cavity whose elements are those at the edge a, b.
template <int D>
void gather_shell_facets(const EditMesh<D>& mesh, NodeId a, NodeId b, Cavity<D>& cavity) {
    const std::size_t size = cavity.elements.size();
    cavity.facets.resize(2 * size);
    cavity.inside.resize(2 * size);
    for (std::size_t k = 0; k < size; ++k) {
        const ElementId e = cavity.elements[k];
        const Simplex<D>& s = mesh.nodes(e);
        cavity.facets[2 * k] = facet_of<D>(s, position_in<D>(s, a));
        cavity.facets[2 * k + 1] = facet_of<D>(s, position_in<D>(s, b));
        cavity.inside[2 * k] = cavity.inside[2 * k + 1] = e;
    }
}

} // namespace

template <int D>
bool is_positive(const EditMesh<D>& mesh, const Simplex<D>& s) {
    if constexpr (D == 2) {
        return orientation(mesh.point(s[0]), mesh.point(s[1]), mesh.point(s[2])) > 0;
    } else {
        return orientation(mesh.point(s[0]), mesh.point(s[1]), mesh.point(s[2]), mesh.point(s[3])) >
               0;
    }
}

template <int D>
void gather_ball(const EditMesh<D>& mesh, NodeId v, Cavity<D>& cavity) {
    const auto ball = mesh.ball(v);
    cavity.elements.assign(ball.begin(), ball.end());
    cavity.inside.assign(ball.begin(), ball.end());
    cavity.facets.resize(ball.size());
    for (std::size_t k = 0; k < ball.size(); ++k) {
        const Simplex<D>& s = mesh.nodes(ball[k]);
        cavity.facets[k] = facet_of<D>(s, position_in<D>(s, v));
    }
}

template <int D>
void gather_shell(const EditMesh<D>& mesh, NodeId a, NodeId b, Cavity<D>& cavity) {
    if (mesh.ball(b).size() < mesh.ball(a).size()) {
        std::swap(a, b);
    }
    cavity.elements.clear();
    for (const ElementId e : mesh.ball(a)) {
        if (contains(mesh.nodes(e), b)) {
            cavity.elements.push_back(e);
        }
    }
    gather_shell_facets(mesh, a, b, cavity);
}

template <int D>
void gather_shell(const EditMesh<D>& mesh, NodeId a, NodeId b, std::span<const ElementId> elements,
                  Cavity<D>& cavity) {
    if (mesh.ball(b).size() < mesh.ball(a).size()) {
        std::swap(a, b);
    }
    cavity.elements.assign(elements.begin(), elements.end());
    gather_shell_facets(mesh, a, b, cavity);
}

template <int D>
void gather_pair(const EditMesh<D>& mesh, ElementId e, ElementId f, Cavity<D>& cavity) {
    cavity.elements = {e, f};
    cavity.facets.resize(2 * D);
    cavity.inside.resize(2 * D);
    std::size_t k = 0;
    for (const auto& [inside, other] : {std::pair(e, f), std::pair(f, e)}) {
        const Simplex<D>& s = mesh.nodes(inside);
        for (int i = 0; i <= D; ++i) {
            if (contains(mesh.nodes(other), s[i])) { // all but the facet between the two
                cavity.facets[k] = facet_of<D>(s, i);
                cavity.inside[k++] = inside;
            }
        }
    }
}

template <int D>
void join_star(const EditMesh<D>& mesh, const Cavity<D>& cavity, NodeId node, Star<D>& star) {
    star.elements.clear();
    star.sources.clear();
    for (std::size_t i = 0; i < cavity.facets.size(); ++i) {
        if (!contains(cavity.facets[i], node)) {
            const EditElement<D>& source = mesh.element(cavity.inside[i]);
            star.elements.push_back({join_facet<D>(cavity.facets[i], node, mesh.ghost()),
                                     source.label, source.measure});
            star.sources.push_back(cavity.inside[i]);
        }
    }
}

template <int D>
Verdict test_star(const EditMesh<D>& mesh, const Star<D>& star) {
    bool any_real = false;
    for (const EditElement<D>& e : star.elements) {
        if (e.nodes[D] != mesh.ghost()) {
            if (!is_positive(mesh, e.nodes)) {
                return Verdict::inverts_element;
            }
            any_real = true;
        }
    }
    // Boundary faces alone: a part of the domain would be gone.
    return any_real ? Verdict::accepted : Verdict::inverts_element;
}

template <int D>
Verdict make_star(const EditMesh<D>& mesh, const Cavity<D>& cavity, NodeId node, Star<D>& star) {
    join_star(mesh, cavity, node, star);
    return test_star(mesh, star);
}

template <int D>
Verdict judge(const EditMesh<D>& mesh, const SizeField<D>& sizes, double floor, Star<D>& star) {
    star.worst_quality = 1;
    for (EditElement<D>& e : star.elements) {
        if (e.nodes[D] == mesh.ghost()) {
            continue;
        }
        const double q = size_quality(mesh, sizes, e.nodes);
        e.measure = static_cast<float>(q);
        star.worst_quality = std::min(star.worst_quality, q);
        if (q < floor) {
            return Verdict::low_quality;
        }
    }
    return Verdict::accepted;
}

template <int D>
void measure_size_quality(EditMesh<D>& mesh, const SizeField<D>& sizes) {
    parallel_for(mesh.slot_count(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const ElementId e(i);
            if (!mesh.is_free(e) && !mesh.is_ghost(e)) {
                mesh.set_measure(e, static_cast<float>(size_quality(mesh, sizes, mesh.nodes(e))));
            }
        }
    });
}

template <int D>
double worst_quality(const EditMesh<D>& mesh, const Cavity<D>& cavity) {
    double worst = 1;
    for (const ElementId e : cavity.elements) {
        if (!mesh.is_ghost(e)) {
            worst = std::min(worst, static_cast<double>(mesh.element(e).measure));
        }
    }
    return worst;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template bool is_positive(const EditMesh<D>&, const Simplex<D>&);                              \
    template void gather_ball(const EditMesh<D>&, NodeId, Cavity<D>&);                             \
    template void gather_shell(const EditMesh<D>&, NodeId, NodeId, Cavity<D>&);                    \
    template void gather_shell(const EditMesh<D>&, NodeId, NodeId, std::span<const ElementId>,     \
                               Cavity<D>&);                                                        \
    template void gather_pair(const EditMesh<D>&, ElementId, ElementId, Cavity<D>&);               \
    template void join_star(const EditMesh<D>&, const Cavity<D>&, NodeId, Star<D>&);               \
    template Verdict test_star(const EditMesh<D>&, const Star<D>&);                                \
    template Verdict make_star(const EditMesh<D>&, const Cavity<D>&, NodeId, Star<D>&);            \
    template Verdict judge(const EditMesh<D>&, const SizeField<D>&, double, Star<D>&);             \
    template void measure_size_quality(EditMesh<D>&, const SizeField<D>&);                         \
    template double worst_quality(const EditMesh<D>&, const Cavity<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
