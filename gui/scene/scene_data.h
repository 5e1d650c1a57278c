// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// One level of a hierarchy, ready to be shown.
#pragma once

#include "core/base/monitor.h"
#include "gui/scene/scene_input.h"
#include "gui/scene/scene_options.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace ameco::gui {

/// An immutable level. May be made on any thread, and is read by many views at once.
struct SceneData {
    int dimension = 3;
    std::variant<SceneInput<3>, SceneInput<2>> input;

    std::size_t node_count = 0;
    std::size_t element_count = 0;
    std::span<const std::array<NodeId, 3>> triangles; ///< [t] 3-D: boundary faces; 2-D: elements
    std::span<const int> triangle_patch;              ///< [t] 3-D: patch; 2-D: region
    std::vector<ElementId> triangle_element;          ///< [t] 3-D: the element behind
    std::span<const std::array<NodeId, 4>> tets;      ///< 3-D: elements; 2-D: empty
    std::vector<std::uint8_t> boundary_facets;        ///< [tets] bit k: facet k is in `triangles`
    std::span<const std::array<NodeId, 2>> lines;     ///< 2-D: boundary edges; 3-D: empty
    std::span<const int> line_patch;

    std::vector<int> patches; ///< ids in ascending order
    std::vector<int> outer;   ///< patches that bound the domain far away, see make_scene_data
    Vec3 low = Vec3::Zero();  ///< bounding box of all nodes [L]
    Vec3 high = Vec3::Zero();
    Vec3 focus_low = Vec3::Zero(); ///< bounding box of the patches that are not outer
    Vec3 focus_high = Vec3::Zero();

    [[nodiscard]] Vec3 position(NodeId i) const {
        if (dimension == 3) {
            return std::get<0>(input).mesh->points[i];
        }
        const Vec<2>& x = std::get<1>(input).mesh->points[i];
        return {x[0], x[1], 0};
    }
    [[nodiscard]] bool has_metric() const;
    [[nodiscard]] const std::vector<int>& removed_at() const;
    [[nodiscard]] const std::string& name() const;
    /// The patch's name, or "patch 3".
    [[nodiscard]] std::string patch_name(int patch) const;
};

/// Whether the natural metric is made where the input has none: it takes longer than all else.
enum class AbsentMetric {
    make,
    leave_out ///< colours that need it show none
};

/// Prepares a level to be shown: which elements lie behind the boundary faces, and where to look.
///
/// In an external flow the wall is small and the far field large. A patch counts as outer when its
/// bounding box has more than half the diagonal of the mesh's, provided that what remains has less
/// than a fifth of it. Views look at the other patches, and start with those outer patches hidden
/// that are not plane.
///
template <int D>
[[nodiscard]] std::shared_ptr<const SceneData>
make_scene_data(SceneInput<D> input, Monitor& monitor = Monitor::silent(),
                AbsentMetric absent = AbsentMetric::make);

/// Outer patches that are not plane: they would hide the wall.
[[nodiscard]] std::set<int> patches_hidden_at_first(const SceneData& data);

} // namespace ameco::gui
