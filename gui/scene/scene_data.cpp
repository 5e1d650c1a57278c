// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/scene_data.h"

#include "core/mesh/adjacency.h"
#include "core/mesh/simplex.h"
#include "core/metric/nodal_metric.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace ameco::gui {
namespace {

struct Box {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

    void add(const Vec3& x) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    void add(const Box& box) {
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    [[nodiscard]] bool empty() const { return !(low[0] <= high[0]); }
    [[nodiscard]] double diagonal() const { return empty() ? 0 : (high - low).norm(); }
    /// Whether it is flat across one of the axes.
    [[nodiscard]] bool is_plane() const { return (high - low).minCoeff() <= 1e-6 * diagonal(); }
};

/// Finds the element behind each boundary face (of a face inside the domain the one with the
/// smaller id), and which facets of the elements are such faces.
void match_faces(const Mesh<3>& mesh, SceneData& data) {
    const auto by_smallest_node =
        file_under<NodeId, FaceId>(mesh.points.size(), mesh.faces.size(), [&](FaceId f) {
            return std::array{*std::min_element(mesh.faces[f].begin(), mesh.faces[f].end())};
        });
    std::vector<std::uint8_t> on_face(mesh.points.size(), 0);
    for (const auto& face : mesh.faces) {
        for (const NodeId i : face) {
            on_face[i.index()] = 1;
        }
    }
    data.triangle_element.resize(mesh.faces.size());
    data.boundary_facets.assign(mesh.elements.size(), 0);
    for (const ElementId e : mesh.elements.ids()) {
        const auto& s = mesh.elements[e];
        int count = 0;
        for (const NodeId i : s) {
            count += on_face[i.index()];
        }
        for (int k = 0; count >= 3 && k < 4; ++k) {
            const Facet<3> facet = sorted(facet_of<3>(s, k));
            for (const FaceId f : by_smallest_node[facet[0]]) {
                if (sorted(mesh.faces[f]) == facet) {
                    data.boundary_facets[e.index()] |= static_cast<std::uint8_t>(1 << k);
                    ElementId& behind = data.triangle_element[f.index()];
                    behind = behind.valid() ? behind : e;
                }
            }
        }
    }
}

void view_arrays(const Mesh<3>& mesh, SceneData& data) {
    data.triangles = mesh.faces.raw();
    data.triangle_patch = mesh.patch.raw();
    data.tets = mesh.elements.raw();
    match_faces(mesh, data);
}

void view_arrays(const Mesh<2>& mesh, SceneData& data) {
    data.triangles = mesh.elements.raw();
    data.triangle_patch = mesh.region.raw();
    data.lines = mesh.faces.raw();
    data.line_patch = mesh.patch.raw();
    data.triangle_element.reserve(mesh.elements.size());
    for (const ElementId e : mesh.elements.ids()) {
        data.triangle_element.push_back(e);
    }
}

template <class Nodes>
void add_boxes(const SceneData& data, std::span<const Nodes> parts, std::span<const int> patch,
               std::map<int, Box>& boxes) {
    for (std::size_t t = 0; t < parts.size(); ++t) {
        Box& box = boxes[patch[t]];
        for (const NodeId i : parts[t]) {
            box.add(data.position(i));
        }
    }
}

void find_outer(SceneData& data) {
    Box all;
    for (std::size_t i = 0; i < data.node_count; ++i) {
        all.add(data.position(NodeId(i)));
    }
    if (all.empty()) {
        return;
    }
    std::map<int, Box> boxes;
    if (data.dimension == 3) {
        add_boxes(data, data.triangles, data.triangle_patch, boxes);
    } else {
        add_boxes(data, data.lines, data.line_patch, boxes);
    }
    Box inner;
    for (const auto& [patch, box] : boxes) {
        data.patches.push_back(patch);
        if (box.diagonal() > 0.5 * all.diagonal()) {
            data.outer.push_back(patch);
        } else {
            inner.add(box);
        }
    }
    if (inner.empty() || inner.diagonal() > 0.2 * all.diagonal()) {
        data.outer.clear();
        inner = all;
    }
    data.low = all.low;
    data.high = all.high;
    data.focus_low = inner.low;
    data.focus_high = inner.high;
}

} // namespace

template <int D>
std::shared_ptr<const SceneData> make_scene_data(SceneInput<D> input, Monitor& monitor,
                                                 AbsentMetric absent) {
    auto data = std::make_shared<SceneData>();
    if (input.natural == nullptr && absent == AbsentMetric::make) {
        input.natural = std::make_shared<const MetricField<D>>(
            nodal_metric<D>(*input.mesh, Mean::blended, monitor));
    }
    data->dimension = D;
    data->node_count = input.mesh->points.size();
    data->element_count = input.mesh->elements.size();
    view_arrays(*input.mesh, *data);
    data->input = std::move(input);
    find_outer(*data);
    return data;
}

template std::shared_ptr<const SceneData> make_scene_data(SceneInput<2>, Monitor&, AbsentMetric);
template std::shared_ptr<const SceneData> make_scene_data(SceneInput<3>, Monitor&, AbsentMetric);

bool SceneData::has_metric() const {
    return std::visit([](const auto& i) { return i.natural != nullptr; }, input);
}

const std::vector<int>& SceneData::removed_at() const {
    return std::visit([](const auto& i) -> const std::vector<int>& { return i.removed_at; }, input);
}

const std::string& SceneData::name() const {
    return std::visit([](const auto& i) -> const std::string& { return i.name; }, input);
}

std::string SceneData::patch_name(int patch) const {
    const auto& names = std::visit(
        [](const auto& i) -> const std::map<int, std::string>& { return i.mesh->patch_names; },
        input);
    const auto found = names.find(patch);
    return found != names.end() && !found->second.empty() ? found->second
                                                          : "patch " + std::to_string(patch);
}

std::set<int> patches_hidden_at_first(const SceneData& data) {
    std::set<int> hidden;
    if (data.dimension == 2) {
        return hidden;
    }
    std::map<int, Box> boxes;
    add_boxes(data, data.triangles, data.triangle_patch, boxes);
    for (const int patch : data.outer) {
        if (!boxes.at(patch).is_plane()) {
            hidden.insert(patch);
        }
    }
    return hidden;
}

} // namespace ameco::gui
