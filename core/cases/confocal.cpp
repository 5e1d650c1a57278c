// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/confocal.h"

#include <cmath>

namespace ameco {

ConfocalColumn::ConfocalColumn(const Vec<2>& foot, double focal) : focal_(focal) {
    const double x = foot[0] / focal, z = foot[1] / focal;
    // sinh^2 u and -sin^2 v are the roots of  q^2 - (x^2 + z^2 - 1) q - z^2 = 0; the one without
    // cancellation first, the other from their product.
    const double b = (x - 1) * (x + 1) + z * z;
    const double root = std::hypot(b, 2 * z);
    const double sinh2 = b > 0 ? (b + root) / 2 : 2 * z * z / (root - b);
    const double sin2 = b > 0 ? 2 * z * z / (root + b) : (root - b) / 2;
    sinh_u_ = std::sqrt(sinh2);
    cosh_u_ = std::sqrt(1 + sinh2);
    sin_v_ = std::copysign(std::sqrt(sin2), z);
    cos_v_ = x / cosh_u_;
    if (z == 0) { // on the chord's prolongation the column is straight, to the bit
        sin_v_ = 0;
        cos_v_ = x > 0 ? 1 : -1;
    }
}

Vec<2> ConfocalColumn::offset_in_u(double du) const {
    const double half = std::sinh(du / 2);
    const double versed = 2 * half * half; // cosh(du) - 1
    const double sine = std::sinh(du);
    return focal_ * Vec<2>(cos_v_ * (cosh_u_ * versed + sinh_u_ * sine),
                           sin_v_ * (sinh_u_ * versed + cosh_u_ * sine));
}

Vec<2> ConfocalColumn::offset(double distance) const {
    if (distance == 0) {
        return Vec<2>::Zero();
    }
    // The distance is a convex, increasing function of du: Newton's steps from above stay above.
    double du = std::asinh(distance / focal_ / std::hypot(sinh_u_, sin_v_));
    for (int i = 0; i < 50; ++i) {
        const Vec<2> at = offset_in_u(du);
        const double length = at.norm();
        const Vec<2> rate =
            focal_ * Vec<2>(cos_v_ * (sinh_u_ * std::cosh(du) + cosh_u_ * std::sinh(du)),
                            sin_v_ * (cosh_u_ * std::cosh(du) + sinh_u_ * std::sinh(du)));
        const double step = (length - distance) * length / at.dot(rate);
        du -= step;
        if (std::abs(step) < 1e-14 * du) {
            break;
        }
    }
    return offset_in_u(du);
}

double ConfocalColumn::distance_to_ellipse(double radius) const {
    return offset_in_u(std::asinh(radius / focal_) - std::asinh(sinh_u_)).norm();
}

} // namespace ameco
