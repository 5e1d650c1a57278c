// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/move_nodes.h"

#include "core/adapt/place_on_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace ameco {
namespace {

/// Turn below which faces count as one plane, and edges as one line.
constexpr double flat = 1e-10;

/// Where a node may go.
enum class Room {
    domain,  ///< anywhere
    plane,   ///< in the plane of its faces
    line,    ///< on the line of its neighbours on the ridge
    surface, ///< on its patch of the original surface
    ridge,   ///< on the original ridges between its two patches, or inside the only one
    none
};

template <int D>
class Mover {
public:
    Mover(UnitMesh<D>& mesh, const MoveOptions& options) : mesh_(mesh), options_(options) {}

    Verdict move(NodeId v) {
        collect_guides(v);
        if (room_ == Room::none) {
            return Verdict::geometry_class;
        }
        before_ = measure_ball(v);
        if (options_.by_excess) {
            mesh_.edit.neighbours(v, neighbours_);
            excess_before_ = mesh_.excess(v, neighbours_);
        }
        if (is_curved() && put_on_surface(v)) {
            return Verdict::accepted;
        }
        if (options_.by_excess && excess_before_ > 0 && search(v, into_band(v), Aim::lengths)) {
            return Verdict::accepted;
        }
        if (before_.worst >= options_.below) {
            return Verdict::no_improvement;
        }
        if (room_ == Room::domain && search(v, towards_regular(v), Aim::quality)) {
            return Verdict::accepted;
        }
        return search(v, towards_unit(v), Aim::quality) ? Verdict::accepted
                                                        : Verdict::no_improvement;
    }

private:
    enum class Aim { quality, lengths, surface };

    bool search(NodeId v, const Vec<D>& step, Aim aim) {
        const auto old = mesh_.state(v);
        double share = 1;
        for (int k = 0; k <= options_.halvings; ++k, share /= 2) {
            const std::optional<Vec<D>> place = place_at(old.point, share * step);
            if (!place) {
                continue;
            }
            if (*place == old.point) {
                break;
            }
            if (try_place(v, old, *place, aim)) {
                return true;
            }
        }
        return false;
    }

    /// Puts a node that is off the original surface, as one may be that was put into an edge, on
    /// it.
    bool put_on_surface(NodeId v) {
        const auto old = mesh_.state(v);
        const std::optional<Vec<D>> place = place_at(old.point, Vec<D>::Zero());
        return place && !is_same_place<D>(*place, old.point) &&
               try_place(v, old, *place, Aim::surface);
    }

    bool try_place(NodeId v, const typename UnitMesh<D>::NodeState& old, const Vec<D>& p, Aim aim) {
        if (mesh_.length_at(v, p - mesh_.first_place(v)) > options_.farthest) {
            return false;
        }
        mesh_.move_node(v, p);
        if (is_better(v, aim) && keeps_surface(v)) {
            mesh_.keep_moved(v, qualities_);
            return true;
        }
        mesh_.restore(v, old);
        return false;
    }

    /// Mean of the apexes of regular elements of unit size on the facets of the ball, those of bad
    /// elements counting more.
    [[nodiscard]] Vec<D> towards_regular(NodeId v) const {
        constexpr double height = D == 2 ? 0.86602540378443865 : 0.81649658092772603;
        Vec<D> sum = Vec<D>::Zero();
        double weights = 0;
        for (const ElementId e : mesh_.edit.ball(v)) {
            if (mesh_.edit.is_ghost(e)) {
                continue;
            }
            const Simplex<D>& s = mesh_.edit.nodes(e);
            const auto apex = static_cast<int>(std::find(s.begin(), s.end(), v) - s.begin());
            const Facet<D> f = facet_of<D>(s, apex);
            std::array<Vec<D>, D> y;
            Vec<D> centre = Vec<D>::Zero();
            for (int k = 0; k < D; ++k) {
                y[k] = mesh_.to_unit(v, mesh_.edit.point(f[k]) - mesh_.edit.point(v));
                centre += y[k] / D;
            }
            // In the space of the metric the facet's normal may be flipped with all others; the
            // apex is where the node is.
            Vec<D> n = normal(y);
            n *= (n.dot(centre) > 0 ? -1 : 1) / std::max(n.norm(), 1e-300);
            const double q = static_cast<double>(mesh_.edit.element(e).measure);
            const double w = 1 / std::max(q * q, 1e-6);
            sum += w * (centre + height * n);
            weights += w;
        }
        return mesh_.from_unit(v, sum / weights);
    }

    static Vec<2> normal(const std::array<Vec<2>, 2>& y) {
        const Vec<2> t = y[1] - y[0];
        return {t[1], -t[0]};
    }
    static Vec<3> normal(const std::array<Vec<3>, 3>& y) {
        return (y[1] - y[0]).cross(y[2] - y[0]);
    }

    struct Measure {
        double worst = 1;
        double inverse_sum = 0; ///< of 1 / quality
    };

    [[nodiscard]] Measure measure_ball(NodeId v) const {
        Measure m;
        for (const ElementId e : mesh_.edit.ball(v)) {
            if (!mesh_.edit.is_ghost(e)) {
                add(m, static_cast<double>(mesh_.edit.element(e).measure));
            }
        }
        return m;
    }

    static void add(Measure& m, double quality) {
        m.worst = std::min(m.worst, quality);
        m.inverse_sum += 1 / std::max(quality, 1e-30);
    }

    /// Where a node may go, and the neighbours it moves among: all inside the domain (as often as
    /// they share elements with it), those of the surface on a patch, the two of the line on a
    /// ridge.
    void collect_guides(NodeId v) {
        guides_.clear();
        room_ = Room::none;
        switch (mesh_.edit.node_class(v)) {
        case NodeClass::interior:
            for (const ElementId e : mesh_.edit.ball(v)) {
                for (const NodeId w : mesh_.edit.nodes(e)) {
                    if (w != v) {
                        guides_.push_back(w);
                    }
                }
            }
            room_ = Room::domain;
            break;
        case NodeClass::patch:
            collect_patch(v);
            break;
        case NodeClass::ridge:
            collect_line(v);
            break;
        case NodeClass::frozen:
            break;
        }
    }

    /// Whether nodes of curved patches may move at all.
    [[nodiscard]] bool may_curve() const {
        return options_.curved && mesh_.edit.original_surface() != nullptr;
    }

    void collect_patch(NodeId v) {
        gather_site(mesh_.edit, v, site_);
        const auto& corners = site_.faces.corners;
        const Vec<D> first = unit_normal(corners.front());
        const bool plane = std::all_of(corners.begin(), corners.end(), [&](const auto& x) {
            return (unit_normal(x) - first).norm() < flat;
        });
        for (const ElementId e : site_.faces.ghosts) {
            const Facet<D> face = ghost_face<D>(mesh_.edit.nodes(e));
            std::copy_if(face.begin(), face.end(), std::back_inserter(guides_),
                         [&](NodeId w) { return w != v; });
        }
        std::sort(guides_.begin(), guides_.end());
        guides_.erase(std::unique(guides_.begin(), guides_.end()), guides_.end());
        room_ = plane ? Room::plane : may_curve() ? Room::surface : Room::none;
        if (plane) { // of all normals the largest faces have the most accurate ones
            site_.direction.setZero();
            for (const auto& x : corners) {
                site_.direction += normal(x);
            }
            site_.direction.normalize();
        }
    }

    void collect_line(NodeId v) {
        mesh_.edit.neighbours(v, neighbours_);
        std::copy_if(neighbours_.begin(), neighbours_.end(), std::back_inserter(guides_),
                     [&](NodeId w) { return mesh_.edit.is_ridge(v, w); });
        if (guides_.size() != 2) {
            return;
        }
        const Vec<D> a = (mesh_.edit.point(guides_[0]) - mesh_.edit.point(v)).normalized();
        const Vec<D> b = (mesh_.edit.point(guides_[1]) - mesh_.edit.point(v)).normalized();
        const bool straight = (a + b).norm() < flat;
        gather_site(mesh_.edit, v, site_);
        site_.direction = (b - a).normalized();
        // A node that was put into the middle of an edge is straight between its neighbours.
        if (may_curve() && (!straight || is_off_surface(v))) {
            room_ = Room::ridge;
        } else if (straight) {
            room_ = Room::line;
            site_.direction =
                (mesh_.edit.point(guides_[1]) - mesh_.edit.point(guides_[0])).normalized();
        }
    }

    [[nodiscard]] bool is_off_surface(NodeId v) const {
        const Vec<D>& p = mesh_.edit.point(v);
        const auto place = place_on_surface(*mesh_.edit.original_surface(), site_, p,
                                            options_.curved->largest_turn_deg);
        return place && !is_same_place(*place, p);
    }

    /// What of a step neither leaves the plane or line, nor, where they are curved, that which
    /// touches them.
    [[nodiscard]] Vec<D> part_within_room(const Vec<D>& step) const {
        if (room_ == Room::domain) {
            return step;
        }
        const Vec<D> along = site_.direction * site_.direction.dot(step);
        const bool on_line = room_ == Room::line || room_ == Room::ridge;
        return on_line ? along : Vec<D>(step - along);
    }

    /// The place a step leads to, if there is one.
    [[nodiscard]] std::optional<Vec<D>> place_at(const Vec<D>& old, const Vec<D>& step) const {
        Vec<D> p = old + part_within_room(step);
        if (room_ == Room::plane || room_ == Room::line) {
            // Planes across a coordinate axis and lines along one are kept to the bit.
            for (int k = 0; k < D; ++k) {
                if (std::all_of(guides_.begin(), guides_.end(),
                                [&](NodeId w) { return mesh_.edit.point(w)[k] == old[k]; })) {
                    p[k] = old[k];
                }
            }
        }
        return is_curved() ? place_on_surface(*mesh_.edit.original_surface(), site_, p,
                                              options_.curved->largest_turn_deg)
                           : std::optional<Vec<D>>(p);
    }

    [[nodiscard]] bool is_curved() const { return room_ == Room::surface || room_ == Room::ridge; }

    /// Whether the boundary at a node that moved on it is one the rules allow.
    [[nodiscard]] bool keeps_surface(NodeId v) {
        return !is_curved() || judge_moved_faces(mesh_.edit, v, site_.faces, mesh_.short_size(v),
                                                 *options_.curved) == Verdict::accepted;
    }

    /// Mean of the places one unit away from each guide, on the line to it.
    [[nodiscard]] Vec<D> towards_unit(NodeId v) const {
        Vec<D> sum = Vec<D>::Zero();
        for (const NodeId w : guides_) {
            const Vec<D> e = mesh_.edit.point(v) - mesh_.edit.point(w);
            sum += e * (1 / mesh_.length(v, w) - 1);
        }
        return sum / static_cast<double>(guides_.size());
    }

    /// Sum of the steps that bring each edge out of the band a little into it.
    [[nodiscard]] Vec<D> into_band(NodeId v) const {
        constexpr double inside = 1.03;
        Vec<D> sum = Vec<D>::Zero();
        for (const NodeId w : neighbours_) {
            const double l = mesh_.length(v, w);
            const Vec<D> e = mesh_.edit.point(v) - mesh_.edit.point(w);
            sum += e * (std::clamp(l, shortest_in_band * inside, longest_in_band / inside) / l - 1);
        }
        return sum;
    }

    bool is_better(NodeId v, Aim aim) {
        const double least =
            aim == Aim::quality ? 0 : std::min(options_.excess_quality, before_.worst);
        const double most = aim == Aim::quality ? before_.inverse_sum / options_.gain
                                                : std::numeric_limits<double>::infinity();
        Measure after;
        qualities_.clear();
        for (const ElementId e : mesh_.edit.ball(v)) {
            if (mesh_.edit.is_ghost(e)) {
                continue;
            }
            const double q = mesh_.quality(mesh_.edit.nodes(e));
            qualities_.push_back(q);
            add(after, q);
            if (q <= least || after.inverse_sum > most) {
                return false;
            }
        }
        if (aim == Aim::quality && after.worst < before_.worst && after.worst < 0.3) {
            return false;
        }
        if (options_.by_excess && aim != Aim::surface &&
            mesh_.excess(v, neighbours_) >
                excess_before_ - (aim == Aim::lengths ? least_excess_fall : 0)) {
            return false;
        }
        return std::all_of(mesh_.edit.ball(v).begin(), mesh_.edit.ball(v).end(), [&](ElementId e) {
            return mesh_.edit.is_ghost(e) || is_positive(mesh_.edit, mesh_.edit.nodes(e));
        });
    }

    UnitMesh<D>& mesh_;
    const MoveOptions& options_;
    std::vector<NodeId> guides_, neighbours_;
    Room room_ = Room::none;
    SurfaceSite<D> site_; ///< before the move; on the boundary
    std::vector<double> qualities_;
    double excess_before_ = 0; ///< of the edges to neighbours_
    Measure before_;
};

} // namespace

template <int D>
Verdict move_node(UnitMesh<D>& mesh, NodeId v, const MoveOptions& options) {
    return Mover<D>(mesh, options).move(v);
}

template <int D>
std::int64_t move_nodes(UnitMesh<D>& mesh, const MoveOptions& options, int since,
                        VerdictCounts& verdicts, const Monitor& monitor) {
    Mover<D> mover(mesh, options);
    std::int64_t made = 0;
    StopCheck stop(monitor);
    for (const NodeId v : mesh.edit.nodes()) {
        if (stop.asked()) {
            break;
        }
        if (!mesh.edit.is_removed(v) && !mesh.is_held(v) && mesh.changed_since(v, since) &&
            mesh.changed_since(v, mesh.move_tried(v))) {
            const Verdict verdict = mover.move(v);
            verdicts.add(verdict);
            if (verdict != Verdict::accepted) {
                mesh.note_move_tried(v);
            }
            made += verdict == Verdict::accepted ? 1 : 0;
        }
    }
    return made;
}

template Verdict move_node(UnitMesh<2>&, NodeId, const MoveOptions&);
template Verdict move_node(UnitMesh<3>&, NodeId, const MoveOptions&);
template std::int64_t move_nodes(UnitMesh<2>&, const MoveOptions&, int, VerdictCounts&,
                                 const Monitor&);
template std::int64_t move_nodes(UnitMesh<3>&, const MoveOptions&, int, VerdictCounts&,
                                 const Monitor&);

} // namespace ameco
