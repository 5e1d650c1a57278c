// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/geometry/volume.h"

#include <cmath>

namespace ameco {

Volume volume(const std::array<Vec<2>, 3>& corners) {
    const Vec<2> a = corners[1] - corners[0];
    const Vec<2> b = corners[2] - corners[0];
    const double left = a[0] * b[1];
    const double right = a[1] * b[0];
    return {(left - right) / 2, (std::abs(left) + std::abs(right)) / 2};
}

Volume volume(const std::array<Vec<3>, 4>& corners) {
    const Vec<3> a = corners[1] - corners[0];
    const Vec<3> b = corners[2] - corners[0];
    const Vec<3> c = corners[3] - corners[0];
    Volume result;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        const double left = b[j] * c[k];
        const double right = b[k] * c[j];
        result.value += a[i] * (left - right);
        result.magnitude += std::abs(a[i]) * (std::abs(left) + std::abs(right));
    }
    result.value /= 6;
    result.magnitude /= 6;
    return result;
}

} // namespace ameco
