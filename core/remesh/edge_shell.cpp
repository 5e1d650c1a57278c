// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/edge_shell.h"

#include <algorithm>

namespace ameco {
namespace {

template <int D>
bool has(const Simplex<D>& s, NodeId v) {
    return std::find(s.begin(), s.end(), v) != s.end();
}

} // namespace

template <int D>
bool at_boundary(const EditMesh<D>& mesh, const Cavity<D>& cavity) {
    return std::any_of(cavity.elements.begin(), cavity.elements.end(),
                       [&](ElementId e) { return mesh.is_ghost(e); });
}

template <int D>
bool is_boundary_edge(const EditMesh<D>& mesh, NodeId a, NodeId b) {
    const auto ball = mesh.ball(a);
    return std::any_of(ball.begin(), ball.end(),
                       [&](ElementId e) { return mesh.is_ghost(e) && has<D>(mesh.nodes(e), b); });
}

template <int D>
bool has_one_label(const EditMesh<D>& mesh, const Cavity<D>& cavity) {
    const EditElement<D>* real = nullptr;
    const EditElement<D>* ghost = nullptr;
    for (const ElementId e : cavity.elements) {
        const EditElement<D>*& first = mesh.is_ghost(e) ? ghost : real;
        if (first == nullptr) {
            first = &mesh.element(e);
        } else if (first->label != mesh.element(e).label) {
            return false;
        }
    }
    return true;
}

namespace {

template <int D>
bool has_one_region(const EditMesh<D>& mesh, const Cavity<D>& cavity) {
    const EditElement<D>* first = nullptr;
    for (const ElementId e : cavity.elements) {
        if (mesh.is_ghost(e)) {
            continue;
        }
        if (first == nullptr) {
            first = &mesh.element(e);
        } else if (first->label != mesh.element(e).label) {
            return false;
        }
    }
    return true;
}

} // namespace

template <int D>
Verdict allowed_to_change(const EditMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell) {
    if (mesh.node_class(a) != NodeClass::frozen || mesh.node_class(b) != NodeClass::frozen) {
        return Verdict::accepted;
    }
    // Borders between regions need not be listed as faces.
    if (mesh.has_protected_inside() || !has_one_region(mesh, shell)) {
        return Verdict::region_border;
    }
    const bool kept = mesh.is_required(a, b) ||
                      std::any_of(shell.elements.begin(), shell.elements.end(), [&](ElementId e) {
                          return mesh.is_ghost(e) && mesh.is_frozen(e);
                      });
    return kept ? Verdict::geometry_class : Verdict::accepted;
}

template <int D>
Verdict allowed_to_leave(const EditMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell) {
    const Verdict verdict = allowed_to_change(mesh, a, b, shell);
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    if (mesh.is_ridge(a, b)) {
        return Verdict::geometry_class;
    }
    return has_one_label(mesh, shell) ? Verdict::accepted : Verdict::region_border;
}

namespace {

NodeId next_in_ring(const Simplex<2>& s, NodeId a, NodeId b) {
    return *std::find_if(s.begin(), s.end(), [&](NodeId v) { return v != a && v != b; });
}

/// Of the two nodes that an element adds to the edge a, b, the first one as seen along the edge:
/// elements around it have different ones.
NodeId next_in_ring(const Simplex<3>& s, NodeId a, NodeId b) {
    // Corner k such that (i, j, k, l) is an even permutation.
    constexpr std::array<std::array<int, 4>, 4> next{
        {{-1, 2, 3, 1}, {3, -1, 0, 2}, {1, 3, -1, 0}, {2, 0, 1, -1}}};
    int i = 0, j = 0;
    for (int k = 1; k < 4; ++k) {
        i += s[k] == a ? k : 0;
        j += s[k] == b ? k : 0;
    }
    return s[next[i][j]];
}

} // namespace

template <int D>
void shell_ring(const EditMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell,
                std::vector<NodeId>& ring) {
    ring.clear();
    const bool ghosts_only = at_boundary(mesh, shell);
    for (const ElementId e : shell.elements) {
        if (!ghosts_only) {
            ring.push_back(next_in_ring(mesh.nodes(e), a, b));
            continue;
        }
        if (!mesh.is_ghost(e)) {
            continue;
        }
        for (const NodeId v : mesh.nodes(e)) {
            if (v != a && v != b && v != mesh.ghost() &&
                std::find(ring.begin(), ring.end(), v) == ring.end()) {
                ring.push_back(v);
            }
        }
    }
    std::sort(ring.begin(), ring.end());
}

template <int D>
void drop_equal_stars(const EditMesh<D>& mesh, const Cavity<D>& shell, std::vector<NodeId>& ring) {
    const std::size_t size = shell.elements.size();
    if (ring.size() != size) { // at the boundary
        return;
    }
    if (size <= D) {
        ring.resize(1);
    } else if (D == 3 && size == 4) {
        const auto is_beside_first = [&](NodeId v) {
            return std::any_of(shell.elements.begin(), shell.elements.end(), [&](ElementId e) {
                return has<D>(mesh.nodes(e), ring[0]) && has<D>(mesh.nodes(e), v);
            });
        };
        ring = {ring[0], is_beside_first(ring[1]) ? ring[1] : ring[2]};
    }
}

template <int D>
Verdict judge_swapped_boundary(const EditMesh<D>& mesh, const SurfaceRules& surface,
                               double short_size, const Cavity<D>& cavity, NodeId node,
                               Star<D>& star) {
    if (!at_boundary(mesh, cavity)) {
        return judge_layer(mesh, cavity, surface, star);
    }
    const auto in_cavity = [&](NodeId v) {
        return std::any_of(cavity.elements.begin(), cavity.elements.end(), [&](ElementId e) {
            return mesh.is_ghost(e) && has<D>(mesh.nodes(e), node) && has<D>(mesh.nodes(e), v);
        });
    };
    // The new boundary edge must not exist elsewhere already.
    for (const EditElement<D>& e : star.elements) {
        for (int i = 0; e.nodes[D] == mesh.ghost() && i < D; ++i) {
            const NodeId v = e.nodes[i];
            if (v != node && !in_cavity(v) && is_boundary_edge(mesh, node, v)) {
                return Verdict::link_condition;
            }
        }
    }
    return judge_surface(mesh, cavity, short_size, surface, star);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template bool at_boundary(const EditMesh<D>&, const Cavity<D>&);                               \
    template bool is_boundary_edge(const EditMesh<D>&, NodeId, NodeId);                            \
    template bool has_one_label(const EditMesh<D>&, const Cavity<D>&);                             \
    template Verdict allowed_to_change(const EditMesh<D>&, NodeId, NodeId, const Cavity<D>&);      \
    template Verdict allowed_to_leave(const EditMesh<D>&, NodeId, NodeId, const Cavity<D>&);       \
    template void shell_ring(const EditMesh<D>&, NodeId, NodeId, const Cavity<D>&,                 \
                             std::vector<NodeId>&);                                                \
    template void drop_equal_stars(const EditMesh<D>&, const Cavity<D>&, std::vector<NodeId>&);    \
    template Verdict judge_swapped_boundary(const EditMesh<D>&, const SurfaceRules&, double,       \
                                            const Cavity<D>&, NodeId, Star<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
