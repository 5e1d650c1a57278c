// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/shuffle.h"

#include "core/cases/random.h"

#include <numeric>
#include <utility>

namespace ameco {
namespace {

/// new_place[i] is where item i goes. (std::shuffle gives different orders on different libraries.)
std::vector<std::size_t> random_order(std::size_t n, std::uint64_t seed) {
    std::vector<std::size_t> place(n);
    std::iota(place.begin(), place.end(), std::size_t{0});
    for (std::size_t i = n; i > 1; --i) {
        std::swap(place[i - 1], place[mix({seed, i}) % i]);
    }
    return place;
}

template <class T>
void rearrange(std::vector<T>& items, const std::vector<std::size_t>& place) {
    std::vector<T> old = std::exchange(items, std::vector<T>(items.size()));
    for (std::size_t i = 0; i < old.size(); ++i) {
        items[place[i]] = std::move(old[i]);
    }
}

/// Renames the nodes of a simplex, then swaps two pairs or rotates three: an even permutation,
/// which keeps the orientation. An edge keeps its order.
template <std::size_t N>
void rename_and_turn(std::array<NodeId, N>& s, const std::vector<std::size_t>& place,
                     std::uint64_t choice) {
    for (NodeId& v : s) {
        v = NodeId(place[v.index()]);
    }
    if constexpr (N >= 3) {
        for (std::uint64_t turns = choice % 3; turns > 0; --turns) {
            const NodeId first = s[0];
            s[0] = s[1];
            s[1] = s[2];
            s[2] = first;
        }
    }
    if constexpr (N >= 4) {
        if ((choice / 3) % 2 == 1) {
            std::swap(s[0], s[3]);
            std::swap(s[1], s[2]);
        }
    }
}

} // namespace

template <int D>
void shuffle(Mesh<D>& mesh, std::uint64_t seed) {
    const auto nodes = random_order(mesh.points.size(), mix({seed, 1}));
    const auto elements = random_order(mesh.elements.size(), mix({seed, 2}));
    const auto faces = random_order(mesh.faces.size(), mix({seed, 3}));
    for (const ElementId e : mesh.elements.ids()) {
        rename_and_turn(mesh.elements[e], nodes, mix({seed, 4, e.index()}));
    }
    for (const FaceId f : mesh.faces.ids()) {
        rename_and_turn(mesh.faces[f], nodes, mix({seed, 5, f.index()}));
    }
    rearrange(mesh.points.raw(), nodes);
    rearrange(mesh.elements.raw(), elements);
    rearrange(mesh.region.raw(), elements);
    rearrange(mesh.faces.raw(), faces);
    rearrange(mesh.patch.raw(), faces);
}

template void shuffle<2>(Mesh<2>&, std::uint64_t);
template void shuffle<3>(Mesh<3>&, std::uint64_t);

} // namespace ameco
