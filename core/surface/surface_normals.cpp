// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_normals.h"

#include "core/base/parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace ameco {
namespace {

double visibility(const Vec<3>& n, const std::vector<Vec<3>>& normals) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec<3>& m : normals) {
        least = std::min(least, n.dot(m));
    }
    return least;
}

/// Normals that differ: a flat fan has one.
std::vector<Vec<3>> distinct(const std::vector<Vec<3>>& normals) {
    constexpr double same = 1e-20; // squared distance of unit vectors
    std::vector<Vec<3>> result;
    for (const Vec<3>& n : normals) {
        if (std::none_of(result.begin(), result.end(),
                         [&](const Vec<3>& m) { return (m - n).squaredNorm() < same; })) {
            result.push_back(n);
        }
    }
    return result;
}

NodeDirection best_direction(const std::vector<Vec<3>>& all) {
    const std::vector<Vec<3>> normals = distinct(all);
    NodeDirection best;
    best.visibility = -2; // less than any cosine
    const auto consider = [&](const Vec<3>& direction) {
        const double length = direction.norm();
        if (length > 0) {
            const double seen = visibility(direction / length, normals);
            if (seen > best.visibility) {
                best.normal = direction / length;
                best.visibility = seen;
            }
        }
    };
    const std::size_t n = normals.size();
    for (std::size_t i = 0; i < n; ++i) {
        consider(normals[i]);
        for (std::size_t j = i + 1; j < n; ++j) {
            consider(normals[i] + normals[j]);
            for (std::size_t k = j + 1; k < n; ++k) {
                // At the same angle to all three, on either side.
                const Vec<3> axis = (normals[j] - normals[i]).cross(normals[k] - normals[i]);
                consider(axis);
                consider(-axis);
            }
        }
    }
    return best;
}

} // namespace

IdVector<FaceId, Vec<3>> face_normals(const Mesh<3>& mesh) {
    IdVector<FaceId, Vec<3>> normals;
    normals.resize(mesh.faces.size(), Vec<3>::Zero());
    for (const FaceId f : mesh.faces.ids()) {
        const auto& [a, b, c] = mesh.faces[f];
        normals[f] = (mesh.points[b] - mesh.points[a])
                         .cross(mesh.points[c] - mesh.points[a])
                         .stableNormalized();
    }
    return normals;
}

IdVector<NodeId, NodeDirection> node_directions(const Mesh<3>& mesh, const HalfEdges& half_edges) {
    const IdVector<FaceId, Vec<3>> normals = face_normals(mesh);
    IdVector<NodeId, NodeDirection> directions(mesh.points.size());
    constexpr std::size_t grain = 1024;
    parallel_for(directions.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::vector<Vec<3>> around;
            for (const FaceId f : half_edges.faces_around(NodeId(i))) {
                around.push_back(normals[f]);
            }
            if (!around.empty()) {
                directions[NodeId(i)] = best_direction(around);
            }
        }
    });
    return directions;
}

} // namespace ameco
