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

template <int D>
void add_facets_opposite(const EditMesh<D>& mesh, ElementId e, NodeId v, Cavity<D>& cavity) {
    const Simplex<D>& s = mesh.nodes(e);
    for (int i = 0; i <= D; ++i) {
        if (s[i] == v) {
            cavity.facets.push_back(facet_of<D>(s, i));
            cavity.inside.push_back(e);
        }
    }
}

template <int D>
void add_to_shell(const EditMesh<D>& mesh, ElementId e, NodeId a, NodeId b, Cavity<D>& cavity) {
    const Simplex<D>& s = mesh.nodes(e);
    cavity.elements.push_back(e);
    for (const NodeId v : {a, b}) {
        const auto i = static_cast<int>(std::find(s.begin(), s.end(), v) - s.begin());
        cavity.facets.push_back(facet_of<D>(s, i));
    }
    cavity.inside.insert(cavity.inside.end(), 2, e);
}

template <int D>
void clear(Cavity<D>& cavity) {
    cavity.elements.clear();
    cavity.facets.clear();
    cavity.inside.clear();
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
    clear(cavity);
    for (const ElementId e : mesh.ball(v)) {
        cavity.elements.push_back(e);
        add_facets_opposite(mesh, e, v, cavity);
    }
}

template <int D>
void gather_shell(const EditMesh<D>& mesh, NodeId a, NodeId b, Cavity<D>& cavity) {
    clear(cavity);
    if (mesh.ball(b).size() < mesh.ball(a).size()) {
        std::swap(a, b);
    }
    for (const ElementId e : mesh.ball(a)) {
        if (contains(mesh.nodes(e), b)) {
            add_to_shell(mesh, e, a, b, cavity);
        }
    }
}

template <int D>
void gather_shell(const EditMesh<D>& mesh, NodeId a, NodeId b, std::span<const ElementId> elements,
                  Cavity<D>& cavity) {
    clear(cavity);
    if (mesh.ball(b).size() < mesh.ball(a).size()) {
        std::swap(a, b);
    }
    for (const ElementId e : elements) {
        add_to_shell(mesh, e, a, b, cavity);
    }
}

template <int D>
void gather_pair(const EditMesh<D>& mesh, ElementId e, ElementId f, Cavity<D>& cavity) {
    clear(cavity);
    cavity.elements = {e, f};
    for (const auto& [inside, other] : {std::pair(e, f), std::pair(f, e)}) {
        for (const NodeId v : mesh.nodes(inside)) {
            if (contains(mesh.nodes(other), v)) { // all but the facet between the two
                add_facets_opposite(mesh, inside, v, cavity);
            }
        }
    }
}

template <int D>
Simplex<D> join_facet(const Facet<D>& facet, NodeId node, NodeId ghost) {
    if constexpr (D == 2) {
        const NodeId a = facet[0], b = facet[1];
        if (a == ghost) {
            return {b, node, a};
        }
        if (b == ghost) {
            return {node, a, b};
        }
        return {a, b, node};
    } else {
        const NodeId a = facet[0], b = facet[2], c = facet[1];
        // Even permutations of (a, b, c, node).
        if (a == ghost) {
            return {b, node, c, a};
        }
        if (b == ghost) {
            return {a, c, node, b};
        }
        if (c == ghost) {
            return {a, node, b, c};
        }
        return {a, b, c, node};
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
    template Simplex<D> join_facet<D>(const Facet<D>&, NodeId, NodeId);                            \
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
