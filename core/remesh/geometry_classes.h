// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Which nodes may leave, and along what: corners, ridges, patches. Classified once on the finest
/// level and carried from level to level, so that coarse angles do not invent or lose features.
#pragma once

#include "core/mesh/mesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace ameco {

enum class NodeClass : std::uint8_t {
    interior, ///< may be removed along any edge
    patch,    ///< on a smooth part of the boundary: leaves along the boundary, within its patch
    ridge,    ///< on a sharp edge or between patches: leaves along that line only
    frozen    ///< corner, required, or on a face inside the domain: stays
};

/// What becomes of the boundary as a whole.
enum class BoundaryChoice {
    coarsen, ///< it is coarsened like the volume
    keep     ///< every patch is frozen
};

inline constexpr std::array all_boundary_choices{BoundaryChoice::coarsen, BoundaryChoice::keep};

[[nodiscard]] std::string_view name(BoundaryChoice choice);
[[nodiscard]] std::optional<BoundaryChoice> boundary_choice_from_name(std::string_view name);

struct FeatureOptions {
    double ridge_angle_deg = 60;  ///< boundary edges that turn by more than this are kept [deg]
    double corner_angle_deg = 50; ///< lines that turn by more than this have a corner there [deg]
    std::vector<int> frozen_patches; ///< patches whose nodes and faces are left untouched
    BoundaryChoice boundary = BoundaryChoice::coarsen; ///< `keep`: as if all patches were listed
};

/// The patches of the mesh whose nodes and faces are left untouched, ascending.
template <int D>
[[nodiscard]] std::vector<int> frozen_patches(const Mesh<D>& mesh, const FeatureOptions& options);

/// A line of the boundary that coarsening keeps: between patches, sharp, or listed by the file.
struct RidgeEdge {
    Edge nodes;            ///< ascending
    int label = 0;         ///< the file's, where it listed the edge
    bool listed = false;   ///< the file listed it: it is written again
    bool declared = false; ///< the file listed it among its ridges
    friend bool operator==(const RidgeEdge&, const RidgeEdge&) = default;
};

template <int D>
class OriginalSurface;

template <int D>
struct GeometryClasses {
    IdVector<NodeId, NodeClass> node; ///< [n]
    std::vector<RidgeEdge> ridges;    ///< D = 3 only, in ascending order of their nodes
    /// Upper bound of the distance between each face and the finest boundary [L], [k].
    IdVector<FaceId, double> deviation;
    std::vector<int> frozen_patches; ///< whose faces stay as they are
    /// The finest boundary; none where it is not known.
    std::shared_ptr<const OriginalSurface<D>> original;
};

/// Classifies the nodes of a valid mesh from patch ids, dihedral angles, declared features and
/// regions. Every node of a face or region border inside the domain is frozen.
template <int D>
[[nodiscard]] GeometryClasses<D> classify_geometry(const Mesh<D>& mesh,
                                                   const FeatureOptions& options = {});

} // namespace ameco
