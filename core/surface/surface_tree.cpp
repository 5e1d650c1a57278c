// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_tree.h"

#include "core/base/error.h"
#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

std::vector<std::array<Vec<3>, 3>> triangles_of(const Mesh<3>& mesh) {
    std::vector<std::array<Vec<3>, 3>> triangles;
    triangles.reserve(mesh.faces.size());
    for (const Facet<3>& f : mesh.faces) {
        triangles.push_back({mesh.points[f[0]], mesh.points[f[1]], mesh.points[f[2]]});
    }
    return triangles;
}

std::vector<Box<3>> boxes_of(const std::vector<std::array<Vec<3>, 3>>& triangles) {
    std::vector<Box<3>> boxes(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (const Vec<3>& x : triangles[i]) {
            boxes[i].extend(x);
        }
    }
    return boxes;
}

/// Whether a segment may enter a box; it never says no where the answer is yes, for `slack` [L] is
/// more than rounding takes away.
bool may_enter(const Box<3>& box, const Vec<3>& p, const Vec<3>& d, double slack) {
    double from = 0, to = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.min()[axis] - slack, high = box.max()[axis] + slack;
        if (std::abs(d[axis]) <= slack) {
            if (std::max(p[axis], p[axis] + d[axis]) < low ||
                std::min(p[axis], p[axis] + d[axis]) > high) {
                return false;
            }
            continue;
        }
        const double a = (low - p[axis]) / d[axis], b = (high - p[axis]) / d[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    constexpr double rounding = 1e-12;
    return from <= to + rounding;
}

enum class Meeting { none, crossing, touch };

/// How a segment meets a triangle, by exact signs.
Meeting meeting(const Vec<3>& p, const Vec<3>& q, const std::array<Vec<3>, 3>& t) {
    const int side_p = orientation(t[0], t[1], t[2], p);
    const int side_q = orientation(t[0], t[1], t[2], q);
    if (side_p * side_q > 0) {
        return Meeting::none;
    }
    std::array<int, 3> around;
    for (std::size_t i = 0; i < 3; ++i) {
        around[i] = orientation(p, q, t[i], t[(i + 1) % 3]);
    }
    const auto [least, most] = std::minmax_element(around.begin(), around.end());
    if (*least < 0 && *most > 0) {
        return Meeting::none;
    }
    const bool clear = side_p * side_q < 0 && *least * *most > 0;
    return clear ? Meeting::crossing : Meeting::touch;
}

/// Where a segment that crosses a triangle's plane does so.
double place_along(const Vec<3>& p, const Vec<3>& q, const std::array<Vec<3>, 3>& t) {
    const Vec<3> n = (t[1] - t[0]).cross(t[2] - t[0]);
    const double at_p = (p - t[0]).dot(n), at_q = (q - t[0]).dot(n);
    return at_p == at_q ? 0 : std::clamp(at_p / (at_p - at_q), 0.0, 1.0);
}

} // namespace

SurfaceTree::SurfaceTree(const Mesh<3>& mesh)
    : triangles_(triangles_of(mesh)), tree_(boxes_of(triangles_)) {
    for (const auto& triangle : triangles_) {
        for (const Vec<3>& x : triangle) {
            bounds_.extend(x);
        }
    }
}

SurfaceTree::Closest SurfaceTree::closest(const Vec<3>& p) const {
    const std::int32_t item = tree_.nearest(p, [&](std::int32_t i) {
        return ameco::distance(p, triangles_[static_cast<std::size_t>(i)]);
    });
    Closest result;
    result.face = FaceId(item);
    result.point = closest_point(p, triangles_[static_cast<std::size_t>(item)]);
    result.distance = (p - result.point).norm();
    return result;
}

std::optional<std::vector<Crossing>>
SurfaceTree::crossings(const Vec<3>& p, const Vec<3>& q,
                       const std::function<bool(FaceId)>& ignores) const {
    const Vec<3> d = q - p;
    const double scale =
        std::max({p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff(),
                  bounds_.min().cwiseAbs().maxCoeff(), bounds_.max().cwiseAbs().maxCoeff()});
    const double slack = 1e-12 * scale;
    std::vector<Crossing> found;
    bool touches = false;
    tree_.visit([&](const Box<3>& box) { return !touches && may_enter(box, p, d, slack); },
                [&](std::int32_t item) {
                    if (ignores && ignores(FaceId(item))) {
                        return;
                    }
                    const auto& t = triangles_[static_cast<std::size_t>(item)];
                    const Meeting how = meeting(p, q, t);
                    touches = touches || how == Meeting::touch;
                    if (how == Meeting::crossing) {
                        found.push_back({place_along(p, q, t), FaceId(item)});
                    }
                });
    if (touches) {
        return std::nullopt;
    }
    std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) {
        return std::pair(a.along, a.face) < std::pair(b.along, b.face);
    });
    return found;
}

std::vector<int> nesting_depths(const Mesh<3>& mesh, const SurfaceTree& tree,
                                const IdVector<FaceId, int>& part_of,
                                const std::vector<bool>& closed) {
    std::vector<FaceId> first(closed.size());
    for (const FaceId f : mesh.faces.ids()) {
        FaceId& seen = first[static_cast<std::size_t>(part_of[f])];
        seen = seen.valid() ? seen : f;
    }
    const double diagonal = tree.bounds().diagonal().norm();
    std::vector<int> depth(closed.size(), 0);
    for (std::size_t part = 0; part < closed.size(); ++part) {
        // From the middle of a face of the part out of the box, in one direction after the other
        // until one meets no edge.
        const auto& t = tree.triangle(first[part]);
        const Vec<3> p = (t[0] + t[1] + t[2]) / 3;
        std::optional<std::vector<Crossing>> crossed;
        for (int attempt = 1; attempt <= 32 && !crossed; ++attempt) {
            const Vec<3> direction(std::cos(1.7 * attempt), std::sin(2.3 * attempt),
                                   std::cos(0.9 * attempt + 0.4));
            const Vec<3> q = p + 4 * diagonal * direction.normalized();
            crossed = tree.crossings(
                p, q, [&](FaceId f) { return static_cast<std::size_t>(part_of[f]) == part; });
        }
        if (!crossed) {
            throw InputError("cannot tell which part of the surface is inside which: face " +
                             std::to_string(first[part].value()));
        }
        std::vector<int> times(closed.size(), 0);
        for (const Crossing& c : *crossed) {
            ++times[static_cast<std::size_t>(part_of[c.face])];
        }
        for (std::size_t other = 0; other < closed.size(); ++other) {
            depth[part] += closed[other] ? times[other] % 2 : 0;
        }
    }
    return depth;
}

} // namespace ameco
