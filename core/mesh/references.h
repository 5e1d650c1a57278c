// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Whether the numbers by which a mesh's arrays refer to each other make sense at all.
#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <string>

namespace ameco {

/// References to nodes, faces, edges or elements that do not exist.
struct BadReferences {
    std::int64_t count = 0;
    std::string example; ///< the first one: what refers to what, 0-based
};

/// Tests elements, faces and features.
template <int D>
[[nodiscard]] BadReferences find_bad_references(const Mesh<D>& mesh);

/// Whether a node occurs twice.
template <std::size_t N>
[[nodiscard]] bool has_repetition(const std::array<NodeId, N>& nodes) {
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t j = i + 1; j < N; ++j) {
            if (nodes[i] == nodes[j]) {
                return true;
            }
        }
    }
    return false;
}

/// Whether orientations and facets can be computed: all references good, all coordinates finite, no
/// node twice in an element or face.
template <int D>
[[nodiscard]] bool is_computable(const Mesh<D>& mesh);

} // namespace ameco
