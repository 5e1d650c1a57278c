// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/extrusion.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cases/prism.h"
#include "core/cases/random.h"
#include "core/geometry/predicates.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace ameco {
namespace {

/// The nodes of corners of a prism whose feet are numbered from `foot` and its tops from `top`.
template <std::size_t N>
std::array<NodeId, N> nodes_of(const std::array<PrismCorner, N>& corners, std::size_t foot,
                               std::size_t top) {
    std::array<NodeId, N> nodes;
    for (std::size_t k = 0; k < N; ++k) {
        nodes[k] = NodeId((corners[k].top ? top : foot) + corners[k].column);
    }
    return nodes;
}

/// Columns of the border opposite corner `i` of a facet, oriented as the facet's boundary.
/// `reversed` tells that a single node is the start of its facet, not its end.
struct Border2 {
    std::array<int, 1> columns;
    bool reversed;
};
Border2 border(const std::array<int, 2>& facet, int i) {
    return {{facet[1 - i]}, i == 1};
}

struct Border3 {
    std::array<int, 2> columns;
    bool reversed;
};
Border3 border(const std::array<int, 3>& facet, int i) {
    return {{facet[(i + 1) % 3], facet[(i + 2) % 3]}, false};
}

/// Whether the corners are in positive order, by exact signs.
template <int D>
bool positive(const Mesh<D>& mesh, const Simplex<D>& s) {
    const auto x = corners_of(mesh, s);
    if constexpr (D == 2) {
        return orientation(x[0], x[1], x[2]) > 0;
    } else {
        return orientation(x[0], x[1], x[2], x[3]) > 0;
    }
}

template <int D>
void require_positive_elements(const Mesh<D>& mesh) {
    std::atomic<std::int64_t> folded{0};
    parallel_for(mesh.elements.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e) {
            if (!positive(mesh, mesh.elements[ElementId(e)])) {
                ++folded;
            }
        }
    });
    if (folded > 0) {
        throw UsageError("these parameters fold " + std::to_string(folded) + " of " +
                         std::to_string(mesh.elements.size()) +
                         " elements: take more cells where the wall is curved, smaller "
                         "displacements, or thinner layers");
    }
}

template <int D>
void add_face(Mesh<D>& mesh, const Facet<D>& face, int patch) {
    mesh.faces.push_back(face);
    mesh.patch.push_back(patch);
}

} // namespace

ColumnRank column_rank(Diagonals diagonals, std::uint64_t seed,
                       std::function<int(std::size_t)> parity) {
    switch (diagonals) {
    case Diagonals::alternating:
        return [parity = std::move(parity)](std::size_t column, std::size_t layer) {
            return (static_cast<std::uint64_t>(parity(column)) + layer) % 2;
        };
    case Diagonals::columns:
        return [seed](std::size_t column, std::size_t) { return mix({seed, 1, column}); };
    case Diagonals::random:
        return [seed](std::size_t column, std::size_t layer) {
            return mix({seed, 2, column, layer});
        };
    case Diagonals::uniform:
        break;
    }
    return [](std::size_t column, std::size_t) { return column; };
}

template <int D>
Mesh<D> extrude(const Wall<D>& wall, std::vector<Vec<D>> points, const ColumnRank& rank,
                int wall_patch, int top_patch) {
    const std::size_t n = wall.columns;
    const std::size_t layers = points.size() / n - 1;
    Mesh<D> mesh;
    mesh.points = IdVector<NodeId, Vec<D>>(std::move(points));
    mesh.elements.reserve(wall.facets.size() * layers * D);
    mesh.faces.reserve(wall.facets.size() * 2 + wall.sides.size() * layers * (D - 1));

    std::vector<std::uint64_t> ranks(n);
    for (std::size_t k = 0; k < layers; ++k) {
        for (std::size_t c = 0; c < n; ++c) {
            ranks[c] = rank(c, k);
        }
        for (const auto& facet : wall.facets) {
            split_prism(facet, ranks, [&](const std::array<PrismCorner, D + 1>& corners) {
                mesh.elements.push_back(nodes_of(corners, k * n, (k + 1) * n));
            });
        }
        for (const auto& side : wall.sides) {
            const auto b = border(wall.facets[side.facet], side.opposite);
            split_prism(b.columns, ranks, [&](const std::array<PrismCorner, D>& corners) {
                Facet<D> face = nodes_of(corners, k * n, (k + 1) * n);
                if (b.reversed) {
                    std::swap(face[0], face[1]);
                }
                add_face<D>(mesh, face, side.patch);
            });
        }
    }
    for (const auto& facet : wall.facets) {
        Facet<D> bottom, top;
        for (int i = 0; i < D; ++i) {
            bottom[i] = NodeId(facet[i]);
            top[i] = NodeId(layers * n + static_cast<std::size_t>(facet[i]));
        }
        // Both start as in the wall: its normal points up in 3-D, and to its right, down, in 2-D.
        std::swap(D == 3 ? bottom[0] : top[0], D == 3 ? bottom[1] : top[1]);
        add_face<D>(mesh, bottom, wall_patch);
        add_face<D>(mesh, top, top_patch);
    }
    mesh.region.assign(mesh.elements.size(), 1);
    require_positive_elements(mesh);
    return mesh;
}

std::vector<std::size_t> kept_layers(std::size_t layers, int every) {
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < layers; k += static_cast<std::size_t>(every)) {
        kept.push_back(k);
    }
    kept.push_back(layers);
    return kept;
}

template Mesh<2> extrude<2>(const Wall<2>&, std::vector<Vec<2>>, const ColumnRank&, int, int);
template Mesh<3> extrude<3>(const Wall<3>&, std::vector<Vec<3>>, const ColumnRank&, int, int);

} // namespace ameco
