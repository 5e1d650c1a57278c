// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/fit_level.h"

#include "core/adapt/move_nodes.h"
#include "core/adapt/swap_edges.h"
#include "core/remesh/original_surface.h"

namespace ameco {

template <int D>
void fit_level(const Mesh<D>& fine, const MetricField<D>& target, const CoarsenOptions& options,
               Level<D>& coarse, CoarsenReport& report, Monitor& monitor) {
    const BackgroundMetric<D> source(fine, target);
    UnitMesh<D> unit(coarse.mesh, coarse.geometry, source, coarse.parent);
    for (const NodeId v : coarse.parent.ids()) {
        const auto& sizes = target[coarse.parent[v]].sizes;
        if (sizes[D - 1] >= options.fit.stretched * sizes[0]) {
            unit.hold(v);
        }
    }
    int since = 0;
    for (int pass = 0; pass < options.fit.passes; ++pass) {
        monitor.progress(static_cast<double>(pass) / options.fit.passes, "moving nodes");
        const int now = unit.tick();
        (void)swap_to_quality(unit, options.fit.swaps, options.removal.surface, since, report.swaps,
                              monitor);
        (void)move_nodes(unit, {.farthest = options.fit.farthest}, since, report.moves, monitor);
        stop_if_asked(monitor);
        since = now;
    }
    BoundaryDistance<D>().measure(unit.edit);
    auto compact = unit.edit.compact();
    coarse.mesh = std::move(compact.mesh);
    coarse.geometry = std::move(compact.classes);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template void fit_level(const Mesh<D>&, const MetricField<D>&, const CoarsenOptions&,          \
                            Level<D>&, CoarsenReport&, Monitor&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
