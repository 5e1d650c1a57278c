// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Fills a closed surface with tets that contain its faces.
#pragma once

#include "core/base/monitor.h"
#include "core/mesh/mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ameco {

/// What may happen to the faces that are given.
enum class GivenFaces {
    keep, ///< each is a face of the result, with the same nodes
    split ///< nodes may be put on them; they stay where they are
};

/// A part of the volume that gets a region of its own.
struct RegionSeed {
    Vec<3> inside = Vec<3>::Zero(); ///< a point in it
    int region = 0;
    double size = 0; ///< edge length wanted there [L]; 0: as everywhere
};

/// Below this bound of radius over edge no end of refining is in sight.
inline constexpr double least_radius_edge = 1.1;

struct RecoveryOptions {
    GivenFaces faces = GivenFaces::keep;
    double size = 0;           ///< largest edge length wanted in the volume [L]; 0: as it comes
    std::vector<double> sizes; ///< [n] edge length wanted at each node [L], or empty
    double radius_edge = 1.6;  ///< largest circumradius over shortest edge of a tet [-], > 1;
                               ///< 0: no node is added but where the boundary needs one
    std::vector<Vec<3>> holes; ///< a point in each part of space that is to stay empty
    std::vector<RegionSeed> regions;
    /// Angle or height over the size of the whole below which TetGen takes things for flat [-].
    /// Its own 1e-8 would merge layers of 1e-9.
    double tolerance = 1e-14;
};

struct Recovery {
    /// Valid in the sense of `check`. The nodes of the surface come first, in their order. Faces
    /// are those of the surface, with their patches, or their pieces.
    Mesh<3> mesh;
    std::int64_t added_nodes = 0;
    double seconds = 0;
    std::vector<std::string> remarks; ///< one line each: what was tried before it worked
};

/// Whether this build has TetGen.
[[nodiscard]] bool can_recover();

/// Fills the volume bounded by the faces of `surface` with tets (Si, TetGen, ACM TOMS 41, 2015).
/// Nodes that no face uses must lie in the volume, and become nodes of the mesh.
///
/// The surface must be sound (surface/surface_report.h) and its normals must point out of the
/// volume, except at faces between two regions. TetGen works in a child process: whatever it does
/// there, our memory and our files are safe. What it delivers is tested: every face of the surface
/// that is to be kept is there, and the mesh passes `check`.
///
/// \param name  of the surface, for messages
/// \throws InputError  TetGen cannot: the text names the faces it stumbled over
/// \throws CheckFailed what it made is not valid, or lacks faces that were to be kept
/// \throws Cancelled   the monitor asked to stop
/// \throws Error       TetGen is not in this build, or there is not enough memory
[[nodiscard]] Recovery recover_boundary(const Mesh<3>& surface, const RecoveryOptions& options,
                                        const std::string& name,
                                        Monitor& monitor = Monitor::silent());

} // namespace ameco
