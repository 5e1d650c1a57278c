// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Which triangles of a level are seen: its boundary, and what a clip plane lays open.
#pragma once

#include "gui/scene/scene_data.h"

#include <cstdint>
#include <set>
#include <vector>

namespace ameco::gui {

/// A place on an edge, x = a + t (b - a).
struct CutPoint {
    NodeId a, b;
    double t = 0;
};

/// Polygons in space. Their corners are points: first the nodes used, then the places where a plane
/// cuts edges.
struct VisibleSurface {
    std::vector<NodeId> nodes;                         ///< each node once
    std::vector<CutPoint> cuts;                        ///< behind the nodes
    std::vector<std::array<std::int32_t, 4>> polygons; ///< the fourth is -1 in a triangle
    std::vector<ElementId> elements;                   ///< [polygons]
    std::vector<FaceId> faces; ///< [polygons] boundary face (3-D); none inside, and in 2-D
    std::vector<std::array<std::int32_t, 2>> lines; ///< boundary edges (2-D)
    std::vector<int> line_patch;                    ///< [lines]
    std::vector<ElementId> cut_elements;            ///< those that the plane cuts

    [[nodiscard]] std::size_t point_count() const { return nodes.size() + cuts.size(); }
};

/// Finds the visible surface of one level, again and again with the same buffers.
class SurfaceExtractor {
public:
    explicit SurfaceExtractor(std::shared_ptr<const SceneData> data);

    /// With `crinkle`, elements that the plane cuts are kept whole: their facets that look through
    /// the plane are shown. Without, boundary and elements are cut at the plane.
    /// \param boundary_only  leaves out what lies inside the domain
    [[nodiscard]] const VisibleSurface&
    extract(const ClipPlane& clip, const std::set<int>& hidden_patches, bool boundary_only = false);

private:
    void find_sides(const ClipPlane& clip);
    void add_boundary(const ClipPlane& clip, const std::set<int>& hidden);
    void add_inside(const ClipPlane& clip);
    void add_lines(const ClipPlane& clip, const std::set<int>& hidden);
    void add_triangle(const std::array<NodeId, 3>& nodes, ElementId element, FaceId face);
    void add_clipped(const std::array<NodeId, 3>& nodes, ElementId element, FaceId face);
    void add_section(const std::array<NodeId, 4>& nodes, ElementId element);
    [[nodiscard]] std::int32_t point(NodeId node);
    [[nodiscard]] std::int32_t point(NodeId a, NodeId b);
    [[nodiscard]] bool in_front(NodeId i) const { return offset_[i.index()] > 0; }

    std::shared_ptr<const SceneData> data_;
    VisibleSurface surface_;
    std::vector<std::int32_t> point_of_node_; ///< -1: not used
    std::vector<double> offset_;              ///< from the plane, > 0 is not shown
    bool clipped_ = false;
};

} // namespace ameco::gui
