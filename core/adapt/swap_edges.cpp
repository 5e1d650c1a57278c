// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/swap_edges.h"

#include <algorithm>

namespace ameco {
namespace {

template <int D>
class QualityRules {
public:
    explicit QualityRules(UnitMesh<D>& mesh) : mesh_(mesh) {}

    double quality(ElementId e) const { return static_cast<double>(mesh_.edit.element(e).measure); }
    double quality(const Simplex<D>& s, double /*least*/) const { return mesh_.quality(s); }
    double short_size(NodeId v) const { return mesh_.short_size(v); }
    void look_at(const Cavity<D>& /*cavity*/) {}
    Verdict judge(const Cavity<D>& /*cavity*/, Star<D>& star) { return mesh_.judge(0, star); }
    void make(const Cavity<D>& cavity, const Star<D>& star) { mesh_.replace(cavity, star); }

private:
    UnitMesh<D>& mesh_;
};

} // namespace

template <int D>
std::int64_t swap_to_quality(UnitMesh<D>& mesh, const SwapOptions& options,
                             const SurfaceRules& surface, int since, VerdictCounts& verdicts,
                             const Monitor& monitor) {
    QualityRules<D> rules(mesh);
    SwapSearch<D, QualityRules<D>> search(mesh.edit, rules, options, surface, verdicts);
    EdgeNeighbours<D> around;
    std::int64_t made = 0;
    StopCheck stop(monitor);
    for (int round = 0; round < options.rounds; ++round) {
        const int now = mesh.tick();
        const std::int64_t before = made;
        const std::size_t slots = mesh.edit.slot_count();
        for (std::size_t i = 0; i < slots; ++i) {
            const ElementId e(i);
            if (stop.asked()) {
                return made;
            }
            if (mesh.edit.is_free(e) || mesh.edit.is_ghost(e) ||
                rules.quality(e) >= options.below) {
                continue;
            }
            const Simplex<D>& s = mesh.edit.nodes(e);
            const auto is_held = [&](NodeId v) { return mesh.is_held(v); };
            const auto changed = [&](NodeId v) { return mesh.changed_since(v, since); };
            if (!std::any_of(s.begin(), s.end(), changed) ||
                std::all_of(s.begin(), s.end(), is_held)) {
                continue;
            }
            const unsigned corners = mesh.corners_changed_since_swap(e);
            if (!ChangeTimes::has_edge(corners)) {
                continue;
            }
            const double quality = rules.quality(e);
            around.find(mesh.edit, e, corners, [&](ElementId f) {
                return !mesh.edit.is_ghost(f) && rules.quality(f) < quality;
            });
            if (search.mend(e, around)) {
                ++made;
            } else {
                mesh.note_swap_tried(e);
            }
        }
        if (made == before) {
            break;
        }
        since = now;
    }
    return made;
}

template std::int64_t swap_to_quality(UnitMesh<2>&, const SwapOptions&, const SurfaceRules&, int,
                                      VerdictCounts&, const Monitor&);
template std::int64_t swap_to_quality(UnitMesh<3>&, const SwapOptions&, const SurfaceRules&, int,
                                      VerdictCounts&, const Monitor&);

} // namespace ameco
