// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/recovery/farfield.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

namespace ameco {
namespace {

/// The surface of the cube [-1, 1]^3, n x n squares on each side, each cut in two. Patches 0 to 5
/// are x = -1, x = 1, y = -1, ...
Mesh<3> cube_surface(int n) {
    Mesh<3> mesh;
    std::map<std::array<int, 3>, NodeId> numbers;
    const auto node = [&](const std::array<int, 3>& at) {
        const auto [entry, is_new] = numbers.try_emplace(at, mesh.points.next_id());
        if (is_new) {
            mesh.points.push_back(Vec<3>(at[0], at[1], at[2]) * 2 / n - Vec<3>::Ones());
        }
        return entry->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const auto corner = [&](int u, int v) {
                        std::array<int, 3> at{};
                        at[axis] = side * n;
                        at[(axis + 1) % 3] = i + u;
                        at[(axis + 2) % 3] = j + v;
                        return node(at);
                    };
                    std::array<NodeId, 4> square{corner(0, 0), corner(1, 0), corner(1, 1),
                                                 corner(0, 1)};
                    if (side == 0) {
                        std::swap(square[1], square[3]); // normals out
                    }
                    mesh.faces.push_back({square[0], square[1], square[2]});
                    mesh.faces.push_back({square[0], square[2], square[3]});
                    mesh.patch.resize(mesh.faces.size(), static_cast<int>(2 * axis) + side);
                }
            }
        }
    }
    return mesh;
}

/// Moves the points of the cube to the unit sphere: tangents make the squares alike in size.
void round_off(Mesh<3>& mesh) {
    constexpr double quarter = 0.78539816339744831; // pi / 4
    for (Vec<3>& x : mesh.points) {
        x = (quarter * x).array().tan().matrix().normalized();
    }
}

void require_outside(const Mesh<3>& farfield, const Mesh<3>& body, double radius) {
    Vec<3> low = farfield.points[NodeId(0)], high = low;
    for (const Vec<3>& x : farfield.points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    const Vec<3> middle = (low + high) / 2;
    for (const Facet<3>& f : farfield.faces) {
        const Vec<3> a = farfield.points[f[0]], b = farfield.points[f[1]],
                     c = farfield.points[f[2]];
        const Vec<3> n = (b - a).cross(c - a).normalized();
        for (const Vec<3>& x : body.points) {
            if ((x - a).dot(n) >= 0) { // the farfield is convex: outside of one face is outside
                throw UsageError("--farfield: a radius of " + number_text(radius) +
                                 " does not hold the body, whose point " + number_text(x[0]) + " " +
                                 number_text(x[1]) + " " + number_text(x[2]) + " is " +
                                 number_text((x - middle).norm()) + " from its middle");
            }
        }
    }
}

} // namespace

Farfield farfield_from(std::string_view text) {
    Farfield farfield;
    const std::size_t colon = text.find(':');
    const std::string_view shape = text.substr(0, colon);
    if (shape != "box" && shape != "sphere") {
        throw UsageError("--farfield: " + std::string(text) +
                         " is neither box nor sphere, with a radius behind a colon or not");
    }
    farfield.shape = shape == "box" ? FarfieldShape::box : FarfieldShape::sphere;
    if (colon != std::string_view::npos) {
        const std::string_view number = text.substr(colon + 1);
        const auto [end, error] =
            std::from_chars(number.data(), number.data() + number.size(), farfield.radius);
        if (error != std::errc() || end != number.data() + number.size() ||
            !(farfield.radius > 0) || !std::isfinite(farfield.radius)) {
            throw UsageError("--farfield: " + std::string(number) + " is not a radius");
        }
    }
    return farfield;
}

Mesh<3> make_farfield(const Farfield& farfield, const Mesh<3>& body, int first_patch) {
    Vec<3> low = body.points[NodeId(0)], high = low;
    for (const Vec<3>& x : body.points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    const double radius = farfield.radius > 0 ? farfield.radius : 10 * (high - low).norm();
    const bool is_box = farfield.shape == FarfieldShape::box;
    Mesh<3> mesh = cube_surface(farfield.pieces);
    if (!is_box) {
        round_off(mesh);
    }
    for (Vec<3>& x : mesh.points) {
        x = (low + high) / 2 + radius * x;
    }
    for (int& patch : mesh.patch) {
        patch = first_patch + (is_box ? patch : 0);
    }
    static constexpr std::array<const char*, 6> sides{"x0", "x1", "y0", "y1", "z0", "z1"};
    for (int i = 0; i < (is_box ? 6 : 1); ++i) {
        mesh.patch_names[first_patch + i] =
            is_box ? std::string("farfield-") + sides[static_cast<std::size_t>(i)] : "farfield";
    }
    require_outside(mesh, body, radius);
    return mesh;
}

} // namespace ameco
