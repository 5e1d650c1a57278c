// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What is known about a surface from its faces alone: parts, holes, handles, and every defect with
/// the places where it is.
#pragma once

#include "core/mesh/mesh.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace ameco {

/// Places where the faces do not form a surface that bounds a volume. The first four are repaired
/// by `repair_surface` without loss; the others are not.
struct SurfaceDefects {
    std::vector<std::array<NodeId, 2>> duplicate_nodes; ///< at the same point, to the bit
    std::vector<std::array<FaceId, 2>> duplicate_faces; ///< on the same nodes
    std::vector<FaceId> flat_faces;                     ///< without area (exact), or a node twice
    std::vector<Edge> disagreeing_edges; ///< two faces that run through it in the same direction
    std::vector<Edge> open_edges;        ///< of one face only
    std::vector<Edge> crowded_edges;     ///< of more than two faces
    std::vector<NodeId> pinched_nodes;   ///< whose faces fall into several fans
    /// Faces that meet in more than the nodes they share; only where they were looked for.
    std::vector<std::array<FaceId, 2>> intersections;

    [[nodiscard]] bool none() const;
    /// Whether something is left that no repair may guess at.
    [[nodiscard]] bool beyond_repair() const;
};

/// Faces that hang together by their edges.
struct SurfacePart {
    FaceId first_face;
    std::int64_t nodes = 0, edges = 0, faces = 0;
    bool closed = false;     ///< every edge has two faces
    bool orientable = false; ///< the faces can be turned so that all agree
    double area = 0;         ///< [L^2]
    double volume = 0;       ///< enclosed, signed: > 0 if the normals point out [L^3]

    [[nodiscard]] std::int64_t euler_characteristic() const { return nodes - edges + faces; }
    /// Handles of a closed orientable part: 0 for a sphere, 1 for a torus.
    [[nodiscard]] std::int64_t genus() const { return 1 - euler_characteristic() / 2; }
};

struct SurfaceReport {
    std::int64_t nodes = 0; ///< that faces use
    std::int64_t unused_nodes = 0;
    std::int64_t faces = 0;
    SurfaceDefects defects;
    std::vector<SurfacePart> parts;  ///< in the order of their first faces
    IdVector<FaceId, int> part_of;   ///< [k] index into parts
    double shortest_edge = 0;        ///< [L]
    double longest_edge = 0;         ///< [L]
    double largest_aspect_ratio = 0; ///< longest edge over height on it, of faces with area [-]
    Vec<3> low = Vec<3>::Zero();     ///< bounding box [L]
    Vec<3> high = Vec<3>::Zero();

    /// Whether every part is a closed manifold whose faces agree, and nothing else is wrong.
    [[nodiscard]] bool sound() const;
    [[nodiscard]] double diagonal() const { return (high - low).norm(); }
};

/// Looks at the faces of `mesh`; elements mean nothing here.
/// \param intersections  whether to look for faces that intersect, too, which takes most of the
///                       time
/// \throws InputError  references or coordinates that make no sense, or no face at all
[[nodiscard]] SurfaceReport inspect_surface(const Mesh<3>& mesh, bool intersections = true);

/// What is wrong, one line per kind: how often, and the first few places, 0-based.
[[nodiscard]] std::vector<std::string> defect_remarks(const SurfaceDefects& defects);

/// \param name          of the surface, for the message
/// \param repair_helps  `repair_surface` makes it sound (surface_repair.h): then only what that
///                      mends is told, and not what follows from it
/// \throws InputError  the surface does not bound a volume: what is wrong, where, and whether
///                     `ameco surface --repair` can mend it
void require_sound_surface(const SurfaceReport& report, const std::string& name,
                           bool repair_helps = false);

} // namespace ameco
