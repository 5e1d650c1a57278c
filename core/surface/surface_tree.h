// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A surface that can be asked: what is closest to a point, what does a segment cross, what is
/// inside.
#pragma once

#include "core/mesh/box_tree.h"
#include "core/mesh/mesh.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace ameco {

/// A face that a segment crosses.
struct Crossing {
    double along = 0; ///< where, as a share of the segment, in [0, 1]
    FaceId face;
};

/// The faces of a surface in a tree of boxes. Keeps its own copy of their points, so the mesh may
/// change or go. Asking from several threads is safe.
class SurfaceTree {
public:
    explicit SurfaceTree(const Mesh<3>& mesh);

    struct Closest {
        FaceId face; ///< the one with the smallest number, where several are equally close
        Vec<3> point = Vec<3>::Zero();
        double distance = 0; ///< [L]
    };
    /// The point of the surface that is closest to `p`.
    [[nodiscard]] Closest closest(const Vec<3>& p) const;
    [[nodiscard]] double distance(const Vec<3>& p) const { return closest(p).distance; }

    /// The faces that the segment from `p` to `q` crosses, by exact signs, in the order of the
    /// segment; nothing if it touches an edge, a node, or a face without crossing it.
    /// \param ignores  faces that are not asked, such as those that `p` lies on; may be empty
    [[nodiscard]] std::optional<std::vector<Crossing>>
    crossings(const Vec<3>& p, const Vec<3>& q,
              const std::function<bool(FaceId)>& ignores = {}) const;

    [[nodiscard]] const std::array<Vec<3>, 3>& triangle(FaceId f) const {
        return triangles_[f.index()];
    }
    [[nodiscard]] const Box<3>& bounds() const { return bounds_; }

private:
    std::vector<std::array<Vec<3>, 3>> triangles_;
    Box<3> bounds_;
    BoxTree<3> tree_;
};

/// How many of the parts of a surface hold each part: 0 for outer ones, 1 for cavities in them or
/// bodies inside, and so on. Parts that are not closed hold nothing.
/// \param part_of  [k] part of each face, 0 ... parts - 1
/// \param closed   [parts]
[[nodiscard]] std::vector<int> nesting_depths(const Mesh<3>& mesh, const SurfaceTree& tree,
                                              const IdVector<FaceId, int>& part_of,
                                              const std::vector<bool>& closed);

} // namespace ameco
