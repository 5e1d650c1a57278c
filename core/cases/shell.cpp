// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/shell.h"

#include "core/base/error.h"
#include "core/cases/icosphere.h"
#include "core/cases/shuffle.h"

#include <cmath>

namespace ameco {
namespace {

enum Patch : int { patch_wall = 1, patch_farfield = 2 };

/// How far a half axis grows when its square grows by `lambda`: sqrt(axis^2 + lambda) - axis, with
/// all its digits also where that is 1e-9 of the axis.
double axis_growth(double axis, double lambda) {
    return lambda / (std::sqrt(axis * axis + lambda) + axis);
}

Vec<3> half_axes(const ShellOptions& o) {
    return {o.a, o.b, o.c};
}

/// Root mean square of the wall's edges [L].
double wall_edge(const SphereSurface& sphere, const ShellOptions& o) {
    double sum = 0;
    for (const auto& t : sphere.triangles) {
        for (int i = 0; i < 3; ++i) {
            const Vec<3> e = sphere.points[static_cast<std::size_t>(t[(i + 1) % 3])] -
                             sphere.points[static_cast<std::size_t>(t[i])];
            sum += e.cwiseProduct(half_axes(o)).squaredNorm();
        }
    }
    return std::sqrt(sum / (3 * static_cast<double>(sphere.triangles.size())));
}

/// Squares that the layers' ellipsoids add to those of the half axes [L^2]. Heights are those over
/// the ends of the shortest axis, where confocal ellipsoids are farthest apart.
std::vector<double> layers(double edge, const ShellOptions& o) {
    const double last = o.a * o.a * (o.far_field - 1) * (o.far_field + 1);
    const double end = axis_growth(o.c, last);
    const auto scale = [&](double distance) { // of the surface mesh, against the wall's
        const double lambda = distance * (2 * o.c + distance);
        double product = 1;
        for (const double axis : {o.a, o.b, o.c}) {
            product *= 1 + axis_growth(axis, lambda) / axis;
        }
        return std::cbrt(product);
    };
    std::vector<double> lambda{0};
    double distance = 0, height = edge / o.aspect_ratio;
    while (distance + 1.5 * height < end) {
        distance += height;
        lambda.push_back(distance * (2 * o.c + distance));
        height = std::min(height * o.growth, std::max(height, edge * scale(distance)));
    }
    lambda.push_back(last);
    return lambda;
}

} // namespace

Mesh<3> make_shell(const ShellOptions& o) {
    if (o.a < o.b || o.b < o.c) {
        throw UsageError("shell: the half axes must descend, a >= b >= c");
    }
    const auto seed = static_cast<std::uint64_t>(o.seed);
    SphereSurface sphere = icosphere(o.frequency, o.displace, o.flips, seed);
    const Vec<3> draw(1, std::pow(o.b / o.a, o.cluster), std::pow(o.c / o.a, o.cluster));
    for (Vec<3>& u : sphere.points) {
        u = u.cwiseProduct(draw).normalized();
    }
    const std::vector<double> lambda = layers(wall_edge(sphere, o), o);
    std::vector<Vec<3>> points;
    for (const std::size_t k : kept_layers(lambda.size() - 1, o.every)) {
        const Vec<3> growth(axis_growth(o.a, lambda[k]), axis_growth(o.b, lambda[k]),
                            axis_growth(o.c, lambda[k]));
        for (const Vec<3>& u : sphere.points) {
            points.push_back(u.cwiseProduct(half_axes(o)) + u.cwiseProduct(growth));
        }
    }
    const Wall<3> wall{sphere.points.size(), sphere.triangles, {}};
    const ColumnRank rank = column_rank(
        o.diagonals, seed, [](std::size_t column) { return static_cast<int>(column % 2); });
    Mesh<3> mesh = extrude(wall, std::move(points), rank, patch_wall, patch_farfield);
    mesh.patch_names = {{patch_wall, "wall"}, {patch_farfield, "farfield"}};
    if (o.shuffle != 0) {
        shuffle(mesh, static_cast<std::uint64_t>(o.shuffle));
    }
    return mesh;
}

} // namespace ameco
