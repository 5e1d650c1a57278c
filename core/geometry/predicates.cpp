// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/geometry/predicates.h"

#include <cmath>
#include <limits>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace ameco {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

thread_local long long exact_calls = 0;

constexpr double epsilon = std::numeric_limits<double>::epsilon() / 2;
// Bounds of Shewchuk (1997), stage A, on the rounding error of the determinants below relative to
// the same sums of absolute values.
constexpr double bound_2d = (3 + 16 * epsilon) * epsilon;
constexpr double bound_3d = (7 + 56 * epsilon) * epsilon;
// Underflow hides from the relative bounds: a product of two differences may lose up to 5e-324,
// which the third factor then enlarges. This is far more than all such losses together.
constexpr double underflow_bound = 1e-300;

} // namespace

int orientation(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    const double left = (a[0] - c[0]) * (b[1] - c[1]);
    const double right = (a[1] - c[1]) * (b[0] - c[0]);
    const double det = left - right;
    const double sum = std::abs(left) + std::abs(right);
    if (std::abs(det) > bound_2d * sum + underflow_bound) {
        return det > 0 ? 1 : -1;
    }
    ++exact_calls;
    return static_cast<int>(CGAL::orientation(
        Kernel::Point_2(a[0], a[1]), Kernel::Point_2(b[0], b[1]), Kernel::Point_2(c[0], c[1])));
}

int orientation(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d) {
    const double ax = b[0] - a[0], ay = b[1] - a[1], az = b[2] - a[2];
    const double bx = c[0] - a[0], by = c[1] - a[1], bz = c[2] - a[2];
    const double cx = d[0] - a[0], cy = d[1] - a[1], cz = d[2] - a[2];
    const double bycz = by * cz, bzcy = bz * cy;
    const double bzcx = bz * cx, bxcz = bx * cz;
    const double bxcy = bx * cy, bycx = by * cx;
    const double det = ax * (bycz - bzcy) + ay * (bzcx - bxcz) + az * (bxcy - bycx);
    const double sum = std::abs(ax) * (std::abs(bycz) + std::abs(bzcy)) +
                       std::abs(ay) * (std::abs(bzcx) + std::abs(bxcz)) +
                       std::abs(az) * (std::abs(bxcy) + std::abs(bycx));
    const double largest_factor = 1 + std::abs(ax) + std::abs(ay) + std::abs(az);
    if (std::abs(det) > bound_3d * sum + underflow_bound * largest_factor) {
        return det > 0 ? 1 : -1;
    }
    ++exact_calls;
    return static_cast<int>(
        CGAL::orientation(Kernel::Point_3(a[0], a[1], a[2]), Kernel::Point_3(b[0], b[1], b[2]),
                          Kernel::Point_3(c[0], c[1], c[2]), Kernel::Point_3(d[0], d[1], d[2])));
}

long long exact_orientation_calls() {
    return exact_calls;
}

} // namespace ameco
