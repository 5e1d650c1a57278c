// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/icosphere.h"

#include "core/cases/random.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace ameco {
namespace {

using Triangle = std::array<int, 3>;

/// The regular icosahedron: its poles are two opposite corners.
SphereSurface icosahedron() {
    SphereSurface s;
    s.points.emplace_back(0, 0, 1);
    for (int ring = 0; ring < 2; ++ring) {
        for (int i = 0; i < 5; ++i) {
            const double angle = std::numbers::pi * (2 * i + ring) / 5;
            const double z = (ring == 0 ? 1 : -1) / std::sqrt(5.0);
            s.points.emplace_back(std::cos(angle) * 2 / std::sqrt(5.0),
                                  std::sin(angle) * 2 / std::sqrt(5.0), z);
        }
    }
    s.points.emplace_back(0, 0, -1);
    for (int i = 0; i < 5; ++i) {
        const int a = 1 + i, b = 1 + (i + 1) % 5, c = 6 + i, d = 6 + (i + 1) % 5;
        s.triangles.insert(s.triangles.end(), {{0, a, b}, {a, c, b}, {b, c, d}, {11, d, c}});
    }
    return s;
}

/// Cuts every triangle into n^2; nodes on shared edges are made once.
SphereSurface subdivided(const SphereSurface& coarse, int n) {
    SphereSurface fine;
    std::map<std::array<int, 4>, int> made; // (corner, share), (corner, share) in order of corner
    for (const Triangle& t : coarse.triangles) {
        const auto node = [&](int i, int j) { // n - i - j parts of corner 0, i of 1, j of 2
            const Vec<3> p = (n - i - j) * coarse.points[static_cast<std::size_t>(t[0])] +
                             i * coarse.points[static_cast<std::size_t>(t[1])] +
                             j * coarse.points[static_cast<std::size_t>(t[2])];
            const int number = static_cast<int>(fine.points.size());
            if (i > 0 && j > 0 && i + j < n) {
                fine.points.push_back(p.normalized());
                return number;
            }
            std::vector<std::pair<int, int>> shares; // of the corners that take part
            for (const auto& share : {std::pair(t[0], n - i - j), {t[1], i}, {t[2], j}}) {
                if (share.second > 0) {
                    shares.push_back(share);
                }
            }
            std::sort(shares.begin(), shares.end());
            const auto& [a, b] = std::pair(shares.front(), shares.back());
            const auto [at, is_new] = made.insert({{a.first, a.second, b.first, b.second}, number});
            if (is_new) {
                fine.points.push_back(p.normalized());
            }
            return at->second;
        };
        std::vector<std::vector<int>> rows; // rows[i][j]
        for (int i = 0; i <= n; ++i) {
            rows.emplace_back();
            for (int j = 0; i + j <= n; ++j) {
                rows.back().push_back(node(i, j));
            }
        }
        for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
            for (std::size_t j = 0; j + 1 < rows[i].size(); ++j) {
                fine.triangles.push_back({rows[i][j], rows[i + 1][j], rows[i][j + 1]});
                if (j + 1 < rows[i + 1].size()) {
                    fine.triangles.push_back({rows[i + 1][j], rows[i + 1][j + 1], rows[i][j + 1]});
                }
            }
        }
    }
    return fine;
}

/// Edge of the equilateral triangles that would cover the sphere as well.
double mean_edge(const SphereSurface& s) {
    const double area = 4 * std::numbers::pi / static_cast<double>(s.triangles.size());
    return std::sqrt(area * 4 / std::numbers::sqrt3);
}

void displace_nodes(SphereSurface& s, double displace, std::uint64_t seed) {
    const double reach = displace * mean_edge(s);
    for (std::size_t v = 0; v < s.points.size(); ++v) {
        Vec<3> shift;
        for (std::uint64_t d = 0; d < 3; ++d) {
            shift[static_cast<int>(d)] = random_signed({seed, 40, v, d});
        }
        shift -= shift.dot(s.points[v]) * s.points[v];
        s.points[v] = (s.points[v] + reach * shift / std::max(1.0, shift.norm())).normalized();
    }
}

/// Smallest angle of a triangle [rad].
double smallest_angle(const SphereSurface& s, const Triangle& t) {
    double smallest = std::numbers::pi;
    for (int i = 0; i < 3; ++i) {
        const Vec<3>& p = s.points[static_cast<std::size_t>(t[i])];
        const Vec<3> a = s.points[static_cast<std::size_t>(t[(i + 1) % 3])] - p;
        const Vec<3> b = s.points[static_cast<std::size_t>(t[(i + 2) % 3])] - p;
        smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
    return smallest;
}

/// Flips edges whose triangles have not changed yet, so that the list of edges stays true for the
/// rest of them.
void flip_edges(SphereSurface& s, double share, std::uint64_t seed) {
    constexpr double well_shaped = 30 * std::numbers::pi / 180;
    std::map<std::array<int, 2>, std::array<std::size_t, 2>> opposite; // edge -> 3 t + corner, left
    for (std::size_t t = 0; t < s.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = s.triangles[t][(i + 1) % 3], b = s.triangles[t][(i + 2) % 3];
            opposite[{std::min(a, b), std::max(a, b)}][a < b ? 0 : 1] = 3 * t + i;
        }
    }
    std::vector<bool> changed(s.triangles.size(), false);
    for (const auto& [edge, sides] : opposite) {
        const std::size_t left = sides[0] / 3, right = sides[1] / 3;
        const auto [a, b] = edge;
        if (changed[left] || changed[right] ||
            random_signed({seed, 41, static_cast<std::uint64_t>(a),
                           static_cast<std::uint64_t>(b)}) >= 2 * share - 1) {
            continue;
        }
        const int c = s.triangles[left][sides[0] % 3], d = s.triangles[right][sides[1] % 3];
        const Triangle first{a, d, c}, second{d, b, c};
        if (std::min(smallest_angle(s, first), smallest_angle(s, second)) < well_shaped) {
            continue;
        }
        s.triangles[left] = first;
        s.triangles[right] = second;
        changed[left] = changed[right] = true;
    }
}

} // namespace

SphereSurface icosphere(int frequency, double displace, double flips, std::uint64_t seed) {
    SphereSurface s = subdivided(icosahedron(), frequency);
    displace_nodes(s, displace, seed);
    flip_edges(s, flips, seed);
    return s;
}

} // namespace ameco
