// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Boundary layers on a given surface: columns of nodes along smoothed normals.
#pragma once

#include "core/base/monitor.h"
#include "core/cases/extrusion.h"
#include "core/recovery/fill.h"

#include <cstdint>

namespace ameco {

struct SurfaceLayerOptions {
    double first_height = 0; ///< distance of the first layer from the surface [L], > 0
    double growth = 1.2;     ///< of the heights from layer to layer [-], >= 1
    int layers = 20;         ///< >= 1
    int smoothing = 10;      ///< rounds in which directions are averaged with their neighbours'
    Farfield farfield = {FarfieldShape::sphere, 0, 8}; ///< up to which the space is filled
    double radius_edge = 1.6; ///< of the tets beyond the layers (RecoveryOptions)
    Diagonals diagonals = Diagonals::columns;
    int seed = 1; ///< of the diagonals
};

/// What became of the columns.
struct SurfaceLayers {
    Mesh<3> mesh; ///< valid; wall nodes first, in the order of the surface
    std::int64_t columns = 0;
    IdVector<NodeId, double> share; ///< [columns] height over what was asked for [-]; 0: no layers
    std::int64_t shrunk = 0;        ///< of a smaller height than asked for
    std::int64_t collapsed = 0;     ///< without any layers
    double least_share = 1;     ///< smallest height of a column that has one, over what was asked
    Vec<3> at = Vec<3>::Zero(); ///< foot of that column
    double height = 0;          ///< of all layers together [L]
    std::int64_t layer_nodes = 0;
    std::int64_t layer_elements = 0;
    Recovery recovery; ///< of the space beyond the layers; without its mesh
};

/// Meshes the space around a closed surface: layers of tets on it, and TetGen's tets from there to
/// a farfield.
///
/// Each node is the foot of a straight column. Its direction is the one that all faces at the node
/// are seen from best (surface/surface_normals.h), averaged with those of its neighbours as far as
/// the faces stay in sight. Layer k is at h (g^k - 1) / (g - 1) from the faces: the column is
/// longer by the cosine to them (at most twice). A prism between two layers over a face is cut into
/// three tets as in cases/extrusion.h, which conforms by itself.
///
/// A column is shortened, all of its layers by the same share, to at most 0.3 of the way to
/// whatever else it points at; by halves while a tet beside it is not positive, a face of the last
/// layer turns by more than 60 degrees from the one below, or the last layer meets itself or the
/// surface. What cannot be helped so (no direction sees all faces; the share would fall below
/// 1/1000) becomes a column of no height: prisms beside it lose those tets that vanish, and still
/// conform.
///
/// \throws UsageError   options out of range
/// \throws InputError   the surface is not sound, or its columns cannot be kept apart
/// \throws CheckFailed, Error, Cancelled  as `recover_boundary`
[[nodiscard]] SurfaceLayers make_surface_layers(const Mesh<3>& surface,
                                                const SurfaceLayerOptions& options,
                                                const std::string& name,
                                                Monitor& monitor = Monitor::silent());

} // namespace ameco
