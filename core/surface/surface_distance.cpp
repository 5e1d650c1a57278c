// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_distance.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/geometry/distance.h"
#include "core/surface/surface_tree.h"

#include <algorithm>
#include <queue>

namespace ameco {
namespace {

struct Corner {
    Vec<3> x = Vec<3>::Zero();
    double distance = 0; ///< to the other surface
    FaceId closest;      ///< of the other surface
};

/// A piece of a triangle with the bound on its farthest point.
struct Piece {
    double upper = 0;
    std::int64_t number = 0; ///< for ties: older pieces first
    std::array<Corner, 3> corners;
};

struct LessUrgent {
    bool operator()(const Piece& a, const Piece& b) const {
        return a.upper != b.upper ? a.upper < b.upper : a.number > b.number;
    }
};

Corner corner_at(const Vec<3>& x, const SurfaceTree& other) {
    const auto closest = other.closest(x);
    return {x, closest.distance, closest.face};
}

void bound_piece(Piece& piece, const SurfaceTree& other) {
    const auto farthest_from = [&](FaceId t) {
        double farthest = 0;
        for (const Corner& c : piece.corners) {
            farthest = std::max(farthest, distance(c.x, other.triangle(t)));
        }
        return farthest;
    };
    const auto& [a, b, c] = piece.corners;
    const Vec<3> middle = (a.x + b.x + c.x) / 3;
    piece.upper = farthest_from(other.closest(middle).face);
    for (const Corner& corner : piece.corners) {
        piece.upper = std::min(piece.upper, farthest_from(corner.closest));
    }
    // The distance to a surface grows by no more than one goes: a bound that needs no triangle.
    double reach = 0;
    for (const Corner& corner : piece.corners) {
        reach = std::max(reach, (corner.x - middle).norm());
    }
    piece.upper = std::min(piece.upper, other.distance(middle) + reach);
}

std::array<Piece, 2> cut(const Piece& piece, const SurfaceTree& other) {
    std::size_t k = 0;
    double longest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const double length =
            (piece.corners[(i + 1) % 3].x - piece.corners[(i + 2) % 3].x).squaredNorm();
        if (length > longest) {
            longest = length;
            k = i;
        }
    }
    const Corner middle =
        corner_at((piece.corners[(k + 1) % 3].x + piece.corners[(k + 2) % 3].x) / 2, other);
    std::array<Piece, 2> halves{piece, piece};
    halves[0].corners[(k + 1) % 3] = middle;
    halves[1].corners[(k + 2) % 3] = middle;
    for (Piece& half : halves) {
        bound_piece(half, other);
        half.upper = std::min(half.upper, piece.upper);
    }
    return halves;
}

void note(const Corner& corner, DirectedDistance& result) {
    if (corner.distance > result.lower) {
        result.lower = corner.distance;
        result.at = corner.x;
    }
}

std::vector<Piece> first_pieces(const Mesh<3>& from, const SurfaceTree& other) {
    IdVector<NodeId, Corner> corners(from.points.size());
    std::vector<bool> used(from.points.size());
    for (const Facet<3>& f : from.faces) {
        for (const NodeId v : f) {
            used[v.index()] = true;
        }
    }
    constexpr std::size_t grain = 256;
    parallel_for(corners.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (used[i]) {
                corners[NodeId(i)] = corner_at(from.points[NodeId(i)], other);
            }
        }
    });
    std::vector<Piece> pieces(from.faces.size());
    parallel_for(pieces.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Facet<3>& f = from.faces[FaceId(i)];
            pieces[i].corners = {corners[f[0]], corners[f[1]], corners[f[2]]};
            pieces[i].number = static_cast<std::int64_t>(i);
            bound_piece(pieces[i], other);
        }
    });
    return pieces;
}

} // namespace

double SurfaceDistance::lower() const {
    return std::max(there.lower, back.lower);
}

double SurfaceDistance::upper() const {
    return std::max(there.upper, back.upper);
}

DirectedDistance directed_distance(const Mesh<3>& from, const Mesh<3>& to, double tolerance,
                                   long max_cuts) {
    if (from.faces.empty() || to.faces.empty()) {
        throw InputError("a surface without faces has no distance from another");
    }
    const SurfaceTree other(to);
    DirectedDistance result;
    std::vector<Piece> pieces = first_pieces(from, other);
    result.at = pieces.front().corners[0].x;
    for (const Piece& piece : pieces) {
        for (const Corner& corner : piece.corners) {
            note(corner, result);
        }
    }
    auto number = static_cast<std::int64_t>(pieces.size());
    std::priority_queue<Piece, std::vector<Piece>, LessUrgent> queue(LessUrgent(),
                                                                     std::move(pieces));
    for (long cuts = 0; cuts < max_cuts && queue.top().upper > result.lower + tolerance; ++cuts) {
        const Piece piece = queue.top();
        queue.pop();
        for (Piece& half : cut(piece, other)) {
            half.number = number++;
            for (const Corner& corner : half.corners) {
                note(corner, result);
            }
            queue.push(half);
        }
    }
    result.upper = std::max(queue.top().upper, result.lower);
    result.converged = result.upper <= result.lower + tolerance;
    return result;
}

SurfaceDistance surface_distance(const Mesh<3>& a, const Mesh<3>& b, double tolerance) {
    return {directed_distance(a, b, tolerance), directed_distance(b, a, tolerance)};
}

} // namespace ameco
