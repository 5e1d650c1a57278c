// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/barycentric.h"

#include "core/geometry/volume.h"
#include "core/mesh/simplex.h"

#include <Eigen/Geometry>

namespace ameco {

template <int D>
std::array<double, D + 1> barycentric(const std::array<Vec<D>, D + 1>& corners, const Vec<D>& p) {
    std::array<double, D + 1> w;
    double sum = 0;
    for (std::size_t i = 0; i <= D; ++i) {
        auto x = corners;
        x[i] = p;
        w[i] = volume(x).value;
        sum += w[i];
    }
    for (double& value : w) {
        value /= sum;
    }
    return w;
}

std::array<Vec<2>, 3> scaled_gradients(const std::array<Vec<2>, 3>& corners) {
    std::array<Vec<2>, 3> n;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec<2> t = corners[(i + 2) % 3] - corners[(i + 1) % 3];
        n[i] = {-t[1], t[0]};
    }
    return n;
}

std::array<Vec<3>, 4> scaled_gradients(const std::array<Vec<3>, 4>& corners) {
    std::array<Vec<3>, 4> n;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& f = SimplexNumbering<3>::facets[i];
        const auto corner = [&](std::size_t k) { return corners[static_cast<std::size_t>(f[k])]; };
        n[i] = (corner(2) - corner(0)).cross(corner(1) - corner(0));
    }
    return n;
}

template std::array<double, 3> barycentric<2>(const std::array<Vec<2>, 3>&, const Vec<2>&);
template std::array<double, 4> barycentric<3>(const std::array<Vec<3>, 4>&, const Vec<3>&);

} // namespace ameco
