// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/surface_columns.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/stop_check.h"
#include "core/cases/prism.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/simplex.h"
#include "core/surface/self_intersections.h"
#include "core/surface/surface_normals.h"
#include "core/surface/surface_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <span>

namespace ameco {
namespace {

constexpr double least_visibility = 0.1;  ///< cosine; below, a node has no layers
constexpr double least_share = 1e-3;      ///< below, likewise
constexpr double share_of_gap = 0.3;      ///< two columns that face each other leave 0.4 free
constexpr double longest_step = 2;        ///< over the distance from the faces
constexpr double least_turn_cosine = 0.5; ///< of the last layer's faces against the surface's
constexpr std::size_t grain = 1024;

double visibility(const Vec<3>& n, std::span<const FaceId> faces,
                  const IdVector<FaceId, Vec<3>>& normals) {
    double least = 1;
    for (const FaceId f : faces) {
        least = std::min(least, n.dot(normals[f]));
    }
    return least;
}

/// Averages directions with those of the neighbours. A node keeps its own where the average would
/// see its faces much worse.
void smooth(IdVector<NodeId, NodeDirection>& directions, const Mesh<3>& surface,
            const HalfEdges& half_edges, int rounds) {
    const auto normals = face_normals(surface);
    const auto faces_at = file_under<NodeId, FaceId>(surface.points.size(), surface.faces.size(),
                                                     [&](FaceId f) { return surface.faces[f]; });
    std::vector<std::vector<NodeId>> rings;
    IdVector<NodeId, double> best(surface.points.size());
    for (const NodeId v : surface.points.ids()) {
        rings.push_back(half_edges.nodes_around(v));
        best[v] = directions[v].visibility;
    }
    for (int round = 0; round < rounds; ++round) {
        const auto before = directions;
        parallel_for(surface.points.size(), grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const NodeId v(i);
                Vec<3> mean = before[v].normal;
                for (const NodeId w : rings[i]) {
                    mean += before[w].normal / static_cast<double>(rings[i].size());
                }
                mean.stableNormalize();
                const double seen = visibility(mean, faces_at[v], normals);
                if (seen > 0.9 * best[v]) {
                    directions[v].normal = mean;
                    directions[v].visibility = seen;
                }
            }
        });
    }
}

/// Shares that leave room for what a column points at.
void respect_gaps(SurfaceColumns& columns, const Mesh<3>& surface) {
    const SurfaceTree tree(surface);
    const double height = columns.distance.back();
    parallel_for(surface.points.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const NodeId v(i);
            if (columns.collapsed(v)) {
                continue;
            }
            const Vec<3> p = surface.points[v];
            const Vec<3> q = p + height / share_of_gap * columns.step[v];
            const auto crossed = tree.crossings(p, q, [&](FaceId f) {
                const Facet<3>& nodes = surface.faces[f];
                return std::find(nodes.begin(), nodes.end(), v) != nodes.end();
            });
            // A column that touches an edge is as near as one that crosses a face; without the
            // place the later tests shorten it.
            if (crossed && !crossed->empty()) {
                columns.share[v] = std::min(1.0, crossed->front().along);
            }
        }
    });
}

/// Those of the faces whose prisms have a tet that is not positive, or whose top turns too far.
std::vector<FaceId> folded_prisms(const SurfaceColumns& columns, const Mesh<3>& surface,
                                  const std::vector<std::uint64_t>& rank,
                                  const std::vector<FaceId>& asked) {
    const std::size_t layers = columns.distance.size() - 1;
    std::vector<char> folded(asked.size());
    parallel_for(asked.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Facet<3>& f = surface.faces[asked[i]];
            const auto is_flat = [&](const std::array<PrismCorner, 4>& s) {
                for (const PrismCorner& c : s) { // a column of no height has one node
                    const NodeId v(c.column);
                    if (c.top && columns.collapsed(v) &&
                        std::any_of(s.begin(), s.end(), [&](const PrismCorner& d) {
                            return d.column == c.column && !d.top;
                        })) {
                        return true;
                    }
                }
                return false;
            };
            for (std::size_t k = 0; k < layers && folded[i] == 0; ++k) {
                const auto point = [&](const PrismCorner& c) {
                    return columns.point(surface, NodeId(c.column), k + (c.top ? 1 : 0));
                };
                split_prism(std::array{f[0].value(), f[1].value(), f[2].value()}, rank,
                            [&](const std::array<PrismCorner, 4>& s) {
                                if (!is_flat(s) && orientation(point(s[0]), point(s[1]),
                                                               point(s[2]), point(s[3])) <= 0) {
                                    folded[i] = 1;
                                }
                            });
            }
            const auto normal_at = [&](std::size_t layer) {
                const Vec<3> a = columns.point(surface, f[0], layer);
                return Vec<3>((columns.point(surface, f[1], layer) - a)
                                  .cross(columns.point(surface, f[2], layer) - a)
                                  .stableNormalized());
            };
            if (normal_at(0).dot(normal_at(layers)) < least_turn_cosine) {
                folded[i] = 1;
            }
        }
    });
    std::vector<FaceId> faces;
    for (std::size_t i = 0; i < folded.size(); ++i) {
        if (folded[i] != 0) {
            faces.push_back(asked[i]);
        }
    }
    return faces;
}

/// The surface and the last layer as one surface; columns of no height are shared.
Mesh<3> with_last_layer(const SurfaceColumns& columns, const Mesh<3>& surface) {
    Mesh<3> both = surface;
    IdVector<NodeId, NodeId> top(surface.points.size());
    for (const NodeId v : surface.points.ids()) {
        top[v] = v;
        if (!columns.collapsed(v)) {
            top[v] = both.points.next_id();
            both.points.push_back(columns.point(surface, v, columns.distance.size() - 1));
        }
    }
    for (const Facet<3>& f : surface.faces) {
        both.faces.push_back({top[f[0]], top[f[1]], top[f[2]]});
    }
    return both;
}

/// Faces whose last layer meets another's, or the surface; pairs of the surface alone are its own
/// matter.
std::vector<FaceId> crossing_prisms(const SurfaceColumns& columns, const Mesh<3>& surface) {
    const std::size_t k = surface.faces.size();
    std::vector<FaceId> faces;
    for (const auto& pair : self_intersections(with_last_layer(columns, surface))) {
        for (const FaceId f : pair) {
            faces.push_back(FaceId(f.index() % k));
        }
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

/// Halves the longest columns of each of these faces: a short one beside them is not what folds it.
/// \return all faces at a column that was shortened; none if there was none left
std::vector<FaceId> shorten(SurfaceColumns& columns, const Mesh<3>& surface,
                            const std::vector<FaceId>& faces) {
    constexpr double among_the_longest = 0.7;
    const auto length = [&](NodeId v) { return columns.share[v] * columns.step[v].norm(); };
    std::vector<bool> chosen(surface.points.size());
    for (const FaceId f : faces) {
        const auto& [a, b, c] = surface.faces[f];
        const double longest = std::max({length(a), length(b), length(c)});
        for (const NodeId v : surface.faces[f]) {
            if (longest > 0 && length(v) >= among_the_longest * longest) {
                chosen[v.index()] = true;
            }
        }
    }
    for (const NodeId v : surface.points.ids()) {
        if (chosen[v.index()]) {
            columns.share[v] *= 0.5;
            if (columns.share[v] < least_share) {
                columns.share[v] = 0;
            }
        }
    }
    std::vector<FaceId> changed;
    for (const FaceId f : surface.faces.ids()) {
        const Facet<3>& n = surface.faces[f];
        if (std::any_of(n.begin(), n.end(), [&](NodeId v) { return chosen[v.index()]; })) {
            changed.push_back(f);
        }
    }
    return changed;
}

SurfaceColumns full_columns(const Mesh<3>& surface, const SurfaceLayerOptions& options) {
    SurfaceColumns columns;
    double height = options.first_height, distance = 0;
    columns.distance.push_back(0);
    for (int k = 0; k < options.layers; ++k) {
        columns.distance.push_back(distance += height);
        height *= options.growth;
    }
    const HalfEdges half_edges(surface);
    auto directions = node_directions(surface, half_edges);
    smooth(directions, surface, half_edges, options.smoothing);
    for (const NodeId v : surface.points.ids()) {
        const auto& [normal, seen] = directions[v];
        const bool has_layers = seen >= least_visibility;
        columns.share.push_back(has_layers ? 1 : 0);
        columns.step.push_back(normal * std::min(longest_step, 1 / std::max(seen, 1e-3)));
    }
    return columns;
}

} // namespace

std::vector<std::uint64_t> column_ranks(const Mesh<3>& surface,
                                        const SurfaceLayerOptions& options) {
    const ColumnRank rank = column_rank(options.diagonals, static_cast<std::uint64_t>(options.seed),
                                        [](std::size_t) { return 0; });
    std::vector<std::uint64_t> ranks;
    for (std::size_t c = 0; c < surface.points.size(); ++c) {
        ranks.push_back(rank(c, 0));
    }
    return ranks;
}

SurfaceColumns find_columns(const Mesh<3>& surface, const SurfaceLayerOptions& options,
                            const std::string& name, Monitor& monitor) {
    SurfaceColumns columns = full_columns(surface, options);
    respect_gaps(columns, surface);
    const std::vector<std::uint64_t> rank = column_ranks(surface, options);
    std::vector<FaceId> asked;
    for (const FaceId f : surface.faces.ids()) {
        asked.push_back(f);
    }
    // Every round shortens columns, each of which can be halved ten times, or ends.
    constexpr int most_rounds = 500;
    for (int round = 0; round < most_rounds; ++round) {
        stop_if_asked(monitor);
        monitor.progress(1 - std::pow(0.9, round), "keeping columns apart");
        std::vector<FaceId> wrong = folded_prisms(columns, surface, rank, asked);
        if (wrong.empty()) {
            wrong = crossing_prisms(columns, surface);
            if (wrong.empty()) {
                return columns;
            }
        }
        asked = shorten(columns, surface, wrong);
        if (asked.empty()) {
            break;
        }
    }
    throw InputError(name + ": the columns of its layers cannot be kept apart");
}

} // namespace ameco
