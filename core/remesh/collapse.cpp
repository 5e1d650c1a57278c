// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/collapse.h"

#include "core/remesh/edge_shell.h"

#include <algorithm>

namespace ameco {

template <int D>
Verdict allowed_by_geometry(const EditMesh<D>& mesh, Collapse collapse) {
    switch (mesh.node_class(collapse.removed)) {
    case NodeClass::interior:
        return Verdict::accepted;
    case NodeClass::patch:
        return mesh.on_boundary(collapse.kept) &&
                       is_boundary_edge(mesh, collapse.removed, collapse.kept)
                   ? Verdict::accepted
                   : Verdict::geometry_class;
    case NodeClass::ridge:
        return mesh.is_ridge(collapse.removed, collapse.kept) ? Verdict::accepted
                                                              : Verdict::geometry_class;
    case NodeClass::frozen:
        break;
    }
    return Verdict::geometry_class;
}

template <int D>
Verdict propose_collapse(const EditMesh<D>& mesh, const SizeField<D>& sizes,
                         const SurfaceRules& surface, const QualityFloor& quality,
                         double short_size, Collapse collapse, const Cavity<D>& ball,
                         Star<D>& star) {
    Verdict verdict = allowed_by_geometry(mesh, collapse);
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    verdict = make_star(mesh, ball, collapse.kept, star);
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    const double floor = std::min(quality.floor, quality.share * worst_quality(mesh, ball));
    verdict = judge(mesh, sizes, floor, star);
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    // A ball inside the domain that is covered by positive elements stays one; on the boundary the
    // surface must stay a manifold too.
    return mesh.on_boundary(collapse.removed)
               ? judge_collapsed_boundary(mesh, surface, short_size, collapse, ball, star)
               : judge_layer(mesh, ball, surface, star);
}

template <int D>
Verdict judge_collapsed_boundary(const EditMesh<D>& mesh, const SurfaceRules& surface,
                                 double short_size, Collapse collapse, const Cavity<D>& ball,
                                 Star<D>& star) {
    const Verdict verdict = check_link(mesh, collapse.removed, collapse.kept);
    return verdict == Verdict::accepted ? judge_surface(mesh, ball, short_size, surface, star)
                                        : verdict;
}

template <int D>
std::span<const ElementId> apply_collapse(EditMesh<D>& mesh, Collapse collapse,
                                          const Cavity<D>& ball, const Star<D>& star,
                                          std::size_t lane) {
    if (mesh.node_class(collapse.removed) == NodeClass::ridge) {
        mesh.merge_ridges(collapse.removed, collapse.kept);
    }
    return mesh.replace(ball.elements, star.elements, star.sources, lane);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template Verdict allowed_by_geometry(const EditMesh<D>&, Collapse);                            \
    template Verdict propose_collapse(const EditMesh<D>&, const SizeField<D>&,                     \
                                      const SurfaceRules&, const QualityFloor&, double, Collapse,  \
                                      const Cavity<D>&, Star<D>&);                                 \
    template Verdict judge_collapsed_boundary(const EditMesh<D>&, const SurfaceRules&, double,     \
                                              Collapse, const Cavity<D>&, Star<D>&);               \
    template std::span<const ElementId> apply_collapse(EditMesh<D>&, Collapse, const Cavity<D>&,   \
                                                       const Star<D>&, std::size_t);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
