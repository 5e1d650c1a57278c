// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/move_nodes.h"

#include "core/geometry/predicates.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace ameco {
namespace {

/// Turn below which faces count as one plane, and edges as one line.
constexpr double flat = 1e-10;

Vec<2> face_normal(const EditMesh<2>& mesh, const Facet<2>& f) {
    const Vec<2> t = mesh.point(f[1]) - mesh.point(f[0]);
    return Vec<2>(t[1], -t[0]).normalized();
}

Vec<3> face_normal(const EditMesh<3>& mesh, const Facet<3>& f) {
    const Vec<3>& a = mesh.point(f[0]);
    return (mesh.point(f[1]) - a).cross(mesh.point(f[2]) - a).normalized();
}

template <int D>
class Mover {
public:
    Mover(UnitMesh<D>& mesh, const MoveOptions& options) : mesh_(mesh), options_(options) {}

    Verdict move(NodeId v) {
        if (!collect_guides(v)) {
            return Verdict::geometry_class;
        }
        before_ = measure_ball(v);
        if (before_.worst >= options_.below) {
            return Verdict::no_improvement;
        }
        if (mesh_.edit.node_class(v) == NodeClass::interior && search(v, towards_regular(v))) {
            return Verdict::accepted;
        }
        return search(v, towards_unit(v)) ? Verdict::accepted : Verdict::no_improvement;
    }

private:
    bool search(NodeId v, const Vec<D>& step) {
        const auto old = mesh_.state(v);
        double share = 1;
        for (int k = 0; k <= options_.halvings; ++k, share /= 2) {
            Vec<D> p = old.point + share * step;
            hold_common_coordinates(v, old.point, p);
            if (p == old.point) {
                break;
            }
            if (mesh_.length_at(v, p - mesh_.first_place(v)) > options_.farthest) {
                continue;
            }
            mesh_.move_node(v, p);
            if (is_better(v)) {
                store(v);
                return true;
            }
            mesh_.restore(v, old);
        }
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

    /// The neighbours a node may move among: all inside the domain (as often as they share
    /// elements with it), those of the plane on a planar patch, the two of the line on a ridge.
    bool collect_guides(NodeId v) {
        switch (mesh_.edit.node_class(v)) {
        case NodeClass::interior:
            guides_.clear();
            for (const ElementId e : mesh_.edit.ball(v)) {
                for (const NodeId w : mesh_.edit.nodes(e)) {
                    if (w != v) {
                        guides_.push_back(w);
                    }
                }
            }
            return true;
        case NodeClass::patch:
            return collect_plane(v);
        case NodeClass::ridge:
            return collect_line(v);
        case NodeClass::frozen:
            break;
        }
        return false;
    }

    bool collect_plane(NodeId v) {
        guides_.clear();
        bool first = true;
        Vec<D> normal = Vec<D>::Zero();
        for (const ElementId e : mesh_.edit.ball(v)) {
            if (!mesh_.edit.is_ghost(e)) {
                continue;
            }
            const Facet<D> face = ghost_face<D>(mesh_.edit.nodes(e));
            const Vec<D> n = face_normal(mesh_.edit, face);
            if (first) {
                normal = n;
                first = false;
            } else if (!((n - normal).norm() < flat)) {
                return false;
            }
            std::copy_if(face.begin(), face.end(), std::back_inserter(guides_),
                         [&](NodeId w) { return w != v; });
        }
        std::sort(guides_.begin(), guides_.end());
        guides_.erase(std::unique(guides_.begin(), guides_.end()), guides_.end());
        return !first;
    }

    bool collect_line(NodeId v) {
        mesh_.edit.neighbours(v, neighbours_);
        guides_.clear();
        std::copy_if(neighbours_.begin(), neighbours_.end(), std::back_inserter(guides_),
                     [&](NodeId w) { return mesh_.edit.is_ridge(v, w); });
        if (guides_.size() != 2) {
            return false;
        }
        const Vec<D> a = (mesh_.edit.point(guides_[0]) - mesh_.edit.point(v)).normalized();
        const Vec<D> b = (mesh_.edit.point(guides_[1]) - mesh_.edit.point(v)).normalized();
        return (a + b).norm() < flat;
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

    /// A plane or line along a coordinate axis is kept to the bit.
    void hold_common_coordinates(NodeId v, const Vec<D>& old, Vec<D>& p) const {
        if (mesh_.edit.node_class(v) == NodeClass::interior) {
            return;
        }
        for (int k = 0; k < D; ++k) {
            if (std::all_of(guides_.begin(), guides_.end(),
                            [&](NodeId w) { return mesh_.edit.point(w)[k] == old[k]; })) {
                p[k] = old[k];
            }
        }
    }

    bool is_better(NodeId v) {
        Measure after;
        qualities_.clear();
        for (const ElementId e : mesh_.edit.ball(v)) {
            if (mesh_.edit.is_ghost(e)) {
                continue;
            }
            const double q = mesh_.quality(mesh_.edit.nodes(e));
            qualities_.push_back(q);
            add(after, q);
            if (q <= 0 || after.inverse_sum * options_.gain > before_.inverse_sum) {
                return false;
            }
        }
        if (after.worst < before_.worst && after.worst < 0.3) {
            return false;
        }
        return std::all_of(mesh_.edit.ball(v).begin(), mesh_.edit.ball(v).end(), [&](ElementId e) {
            return mesh_.edit.is_ghost(e) || is_positive(mesh_.edit, mesh_.edit.nodes(e));
        });
    }

    void store(NodeId v) {
        std::size_t k = 0;
        for (const ElementId e : mesh_.edit.ball(v)) {
            if (!mesh_.edit.is_ghost(e)) {
                mesh_.edit.set_measure(e, static_cast<float>(qualities_[k++]));
            }
        }
        for (const ElementId e : mesh_.edit.ball(v)) {
            for (const NodeId w : mesh_.edit.nodes(e)) {
                if (w != mesh_.edit.ghost()) {
                    mesh_.touch(w);
                }
            }
        }
    }

    UnitMesh<D>& mesh_;
    const MoveOptions& options_;
    std::vector<NodeId> guides_, neighbours_;
    std::vector<double> qualities_;
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
        if (!mesh.edit.is_removed(v) && !mesh.is_held(v) && mesh.changed_since(v, since)) {
            const Verdict verdict = mover.move(v);
            verdicts.add(verdict);
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
