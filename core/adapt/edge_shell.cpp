// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/edge_shell.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

/// Where along an edge from a to b the two parts have the same length, when the density of length
/// goes geometrically from l_a to l_b.
double middle(double l_a, double l_b) {
    const double r = std::log(l_b / l_a);
    if (std::abs(r) < 1e-3) {
        return 0.5 + r / 8;
    }
    constexpr double nearest_end = 0.1;
    return std::clamp(std::log(0.5 * (1 + std::exp(r))) / r, nearest_end, 1 - nearest_end);
}

template <int D>
bool at_boundary(const EditMesh<D>& mesh, const Cavity<D>& cavity) {
    return std::any_of(cavity.elements.begin(), cavity.elements.end(),
                       [&](ElementId e) { return mesh.is_ghost(e); });
}

template <int D>
bool one_label(const EditMesh<D>& mesh, const Cavity<D>& cavity, bool ghosts) {
    const EditElement<D>* first = nullptr;
    for (const ElementId e : cavity.elements) {
        if (mesh.is_ghost(e) == ghosts) {
            first = first == nullptr ? &mesh.element(e) : first;
            if (mesh.element(e).label != first->label) {
                return false;
            }
        }
    }
    return true;
}

template <int D>
bool is_boundary_edge(const EditMesh<D>& mesh, NodeId a, NodeId b) {
    const auto ball = mesh.ball(a);
    return std::any_of(ball.begin(), ball.end(), [&](ElementId e) {
        const Simplex<D>& s = mesh.nodes(e);
        return mesh.is_ghost(e) && std::find(s.begin(), s.end(), b) != s.end();
    });
}

} // namespace

template <int D>
Verdict allowed_to_change(const EditMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell) {
    if (mesh.node_class(a) != NodeClass::frozen || mesh.node_class(b) != NodeClass::frozen) {
        return Verdict::accepted;
    }
    if (mesh.has_protected_inside()) {
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
    return one_label(mesh, shell, false) && one_label(mesh, shell, true) ? Verdict::accepted
                                                                         : Verdict::region_border;
}

template <int D>
void shell_ring(const EditMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell,
                std::vector<NodeId>& ring) {
    ring.clear();
    const bool ghosts_only = at_boundary(mesh, shell);
    for (const ElementId e : shell.elements) {
        if (ghosts_only && !mesh.is_ghost(e)) {
            continue;
        }
        for (const NodeId v : mesh.nodes(e)) {
            if (v != a && v != b && v != mesh.ghost()) {
                ring.push_back(v);
            }
        }
    }
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
}

template <int D>
Verdict judge_swapped_boundary(const UnitMesh<D>& mesh, const SurfaceRules& surface,
                               const Cavity<D>& shell, NodeId node, Star<D>& star) {
    if (!at_boundary(mesh.edit, shell)) {
        return Verdict::accepted;
    }
    const auto in_shell = [&](NodeId v) {
        return std::any_of(shell.elements.begin(), shell.elements.end(), [&](ElementId e) {
            const Simplex<D>& s = mesh.edit.nodes(e);
            return mesh.edit.is_ghost(e) && std::find(s.begin(), s.end(), node) != s.end() &&
                   std::find(s.begin(), s.end(), v) != s.end();
        });
    };
    // The new boundary edge must not exist elsewhere already.
    for (const EditElement<D>& e : star.elements) {
        for (int i = 0; e.nodes[D] == mesh.edit.ghost() && i < D; ++i) {
            const NodeId v = e.nodes[i];
            if (v != node && !in_shell(v) && is_boundary_edge(mesh.edit, node, v)) {
                return Verdict::link_condition;
            }
        }
    }
    return judge_surface(mesh.edit, shell, mesh.short_size(node), surface, star);
}

template <int D>
NodeId add_middle_node(UnitMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell) {
    const bool boundary = at_boundary(mesh.edit, shell);
    const NodeClass node_class = mesh.edit.is_ridge(a, b) ? NodeClass::ridge
                                 : boundary               ? NodeClass::patch
                                                          : NodeClass::interior;
    const Vec<D> e = mesh.edit.point(b) - mesh.edit.point(a);
    const Vec<D> p = mesh.edit.point(a) + middle(mesh.length_at(a, e), mesh.length_at(b, e)) * e;
    return mesh.add_node(p, a, node_class, boundary);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template Verdict allowed_to_change(const EditMesh<D>&, NodeId, NodeId, const Cavity<D>&);      \
    template Verdict allowed_to_leave(const EditMesh<D>&, NodeId, NodeId, const Cavity<D>&);       \
    template void shell_ring(const EditMesh<D>&, NodeId, NodeId, const Cavity<D>&,                 \
                             std::vector<NodeId>&);                                                \
    template Verdict judge_swapped_boundary(const UnitMesh<D>&, const SurfaceRules&,               \
                                            const Cavity<D>&, NodeId, Star<D>&);                   \
    template NodeId add_middle_node(UnitMesh<D>&, NodeId, NodeId, const Cavity<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
