// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/geometry/distance.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace ameco {
namespace {

/// From `a` to the point of the segment that is closest to `p`.
template <int D>
Vec<D> along_segment(const Vec<D>& p, const Vec<D>& a, const Vec<D>& b) {
    const Vec<D> ab = b - a, ap = p - a;
    const double length2 = ab.squaredNorm();
    const double t = length2 > 0 ? std::clamp(ap.dot(ab) / length2, 0.0, 1.0) : 0.0;
    return t * ab;
}

template <int D>
double to_segment(const Vec<D>& p, const Vec<D>& a, const Vec<D>& b) {
    return (p - a - along_segment<D>(p, a, b)).norm();
}

/// Whether the foot of the perpendicular from `p` on the triangle's plane, which has the normal
/// `n`, is in the triangle. Never for a triangle without area, or whose height rounding made: its
/// normal could point anywhere, and its edges are all there is of it.
bool is_above(const Vec<3>& p, const std::array<Vec<3>, 3>& t, const Vec<3>& n) {
    constexpr double rounding = 1e-14; // of a height over the edge it stands on
    const double longest2 = std::max(
        {(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
    bool inside = n.norm() > rounding * longest2;
    for (int i = 0; i < 3 && inside; ++i) {
        const Vec<3>& a = t[static_cast<std::size_t>(i)];
        const Vec<3>& b = t[static_cast<std::size_t>((i + 1) % 3)];
        inside = (b - a).cross(p - a).dot(n) >= 0;
    }
    return inside;
}

} // namespace

double distance(const Vec<2>& p, const std::array<Vec<2>, 2>& s) {
    return to_segment<2>(p, s[0], s[1]);
}

double distance(const Vec<3>& p, const std::array<Vec<3>, 3>& t) {
    const Vec<3> n = (t[1] - t[0]).cross(t[2] - t[0]);
    if (is_above(p, t, n)) {
        return std::abs((p - t[0]).dot(n)) / n.norm();
    }
    return std::min(
        {to_segment<3>(p, t[0], t[1]), to_segment<3>(p, t[1], t[2]), to_segment<3>(p, t[2], t[0])});
}

Vec<3> closest_point(const Vec<3>& p, const std::array<Vec<3>, 3>& t) {
    const Vec<3> n = (t[1] - t[0]).cross(t[2] - t[0]);
    if (is_above(p, t, n)) {
        return p - n * ((p - t[0]).dot(n) / n.squaredNorm());
    }
    Vec<3> best = t[0];
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec<3> q = t[i] + along_segment<3>(p, t[i], t[(i + 1) % 3]);
        if ((p - q).squaredNorm() < (p - best).squaredNorm()) {
            best = q;
        }
    }
    return best;
}

} // namespace ameco
