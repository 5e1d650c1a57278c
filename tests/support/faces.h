// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The faces of a mesh as a set that two meshes with other numbers can have in common.
#pragma once

#include "core/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

namespace ameco::test {

/// Coordinates of the nodes of a face, to the bit and in ascending order, and its patch.
template <int D>
using FaceKey = std::pair<std::array<std::array<double, D>, D>, int>;

/// \param patch  none: all
template <int D>
std::set<FaceKey<D>> faces_of(const Mesh<D>& mesh, std::optional<int> patch = {}) {
    std::set<FaceKey<D>> faces;
    for (const FaceId f : mesh.faces.ids()) {
        if (patch && mesh.patch[f] != *patch) {
            continue;
        }
        FaceKey<D> key;
        key.second = mesh.patch[f];
        for (std::size_t i = 0; i < D; ++i) {
            std::copy_n(mesh.points[mesh.faces[f][i]].data(), D, key.first[i].begin());
        }
        std::sort(key.first.begin(), key.first.end());
        faces.insert(key);
    }
    return faces;
}

} // namespace ameco::test
