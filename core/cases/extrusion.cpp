// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/extrusion.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cases/random.h"
#include "core/geometry/predicates.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace ameco {
namespace {

/// Splits the prism over a facet of N columns into N simplices of N + 1 nodes. With the columns in
/// order of rank, simplex i has the feet of columns 0 ... i and the tops of columns i ... N-1.
template <std::size_t N, class Emit>
void split_prism(std::array<int, N> facet, std::size_t foot, std::size_t top,
                 const std::vector<std::uint64_t>& rank, const Emit& emit) {
    bool odd = false;
    for (std::size_t i = 1; i < N; ++i) { // insertion sort that keeps count of the swaps
        for (std::size_t j = i; j > 0; --j) {
            const auto a = static_cast<std::size_t>(facet[j - 1]);
            const auto b = static_cast<std::size_t>(facet[j]);
            if (std::pair(rank[a], a) < std::pair(rank[b], b)) {
                break;
            }
            std::swap(facet[j - 1], facet[j]);
            odd = !odd;
        }
    }
    for (std::size_t i = 0; i < N; ++i) {
        std::array<NodeId, N + 1> s;
        for (std::size_t k = 0; k <= i; ++k) {
            s[k] = NodeId(foot + static_cast<std::size_t>(facet[k]));
        }
        for (std::size_t k = i; k < N; ++k) {
            s[k + 1] = NodeId(top + static_cast<std::size_t>(facet[k]));
        }
        if (odd != ((N - 1 - i) % 2 == 1)) {
            std::swap(s[N - 1], s[N]);
        }
        emit(s);
    }
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
            split_prism(facet, k * n, (k + 1) * n, ranks,
                        [&](const Simplex<D>& s) { mesh.elements.push_back(s); });
        }
        for (const auto& side : wall.sides) {
            const auto b = border(wall.facets[side.facet], side.opposite);
            split_prism(b.columns, k * n, (k + 1) * n, ranks, [&](Facet<D> face) {
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
