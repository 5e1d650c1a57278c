// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/geometry/distance.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace ameco {
namespace {

template <int D>
double to_segment(const Vec<D>& p, const Vec<D>& a, const Vec<D>& b) {
    const Vec<D> ab = b - a, ap = p - a;
    const double length2 = ab.squaredNorm();
    const double t = length2 > 0 ? std::clamp(ap.dot(ab) / length2, 0.0, 1.0) : 0.0;
    return (ap - t * ab).norm();
}

} // namespace

double distance(const Vec<2>& p, const std::array<Vec<2>, 2>& s) {
    return to_segment<2>(p, s[0], s[1]);
}

double distance(const Vec<3>& p, const std::array<Vec<3>, 3>& t) {
    const Vec<3> n = (t[1] - t[0]).cross(t[2] - t[0]);
    const double area2 = n.squaredNorm();
    bool inside = area2 > 0;
    for (int i = 0; i < 3 && inside; ++i) {
        const Vec<3>& a = t[static_cast<std::size_t>(i)];
        const Vec<3>& b = t[static_cast<std::size_t>((i + 1) % 3)];
        inside = (b - a).cross(p - a).dot(n) >= 0;
    }
    if (inside) {
        return std::abs((p - t[0]).dot(n)) / std::sqrt(area2);
    }
    return std::min(
        {to_segment<3>(p, t[0], t[1]), to_segment<3>(p, t[1], t[2]), to_segment<3>(p, t[2], t[0])});
}

} // namespace ameco
