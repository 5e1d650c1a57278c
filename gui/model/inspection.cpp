// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/model/inspection.h"

#include "core/base/text.h"
#include "core/geometry/volume.h"
#include "core/metric/conformity.h"
#include "core/metric/element_metric.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace ameco::gui {
namespace {

const char* class_name(NodeClass node_class) {
    switch (node_class) {
    case NodeClass::interior:
        return "interior";
    case NodeClass::patch:
        return "patch";
    case NodeClass::ridge:
        return "ridge";
    case NodeClass::frozen:
        return "corner or frozen";
    }
    return "";
}

template <int D>
std::vector<double> numbers(const Vec<D>& v) {
    return {v.begin(), v.end()};
}

template <int D>
std::vector<std::string> patches_at(const Mesh<D>& mesh, NodeId node, const SceneData& scene) {
    std::set<int> found;
    for (const FaceId f : mesh.faces.ids()) {
        const auto& face = mesh.faces[f];
        if (std::find(face.begin(), face.end(), node) != face.end()) {
            found.insert(mesh.patch[f]);
        }
    }
    std::vector<std::string> names;
    for (const int patch : found) {
        names.push_back(scene.patch_name(patch));
    }
    return names;
}

template <int D>
InspectedElement inspect_element(const Level<D>& level, ElementId element) {
    const Mesh<D>& mesh = level.mesh;
    const Simplex<D>& simplex = mesh.elements[element];
    const Metric<D> own = element_metric<D>(corners_of(mesh, simplex));
    InspectedElement i;
    i.id = element;
    for (const NodeId node : simplex) {
        i.nodes.push_back(node.value());
    }
    i.region = mesh.region[element];
    i.volume = volume(corners_of(mesh, simplex)).value;
    i.quality = shape_quality(mesh, level.natural, simplex);
    i.aspect_ratio = aspect_ratio<D>(own);
    i.sizes = numbers<D>(own.sizes);
    return i;
}

template <int D>
Inspection inspect_level(const Level<D>& level, NodeId node, const TargetOptions& target,
                         const SceneData& scene) {
    Inspection i;
    i.node = node;
    i.point = numbers<D>(level.mesh.points[node]);
    i.patches = patches_at(level.mesh, node, scene);
    i.node_class = class_name(level.geometry.node[node]);
    const Metric<D>& natural = level.natural[node];
    i.sizes = numbers<D>(natural.sizes);
    i.target_sizes = numbers<D>(coarsened_sizes<D>(natural.sizes, target));
    i.aspect_ratio = aspect_ratio<D>(natural);
    for (int k = 0; k < D; ++k) {
        i.directions.push_back(numbers<D>(natural.directions.col(k)));
    }
    i.worst_quality = 1;
    for (const Simplex<D>& s : level.mesh.elements) {
        if (std::find(s.begin(), s.end(), node) != s.end()) {
            i.worst_quality =
                std::min(i.worst_quality, shape_quality(level.mesh, level.natural, s));
        }
    }
    const MeanComparison<D> comparison = compare_means(level.mesh, node);
    i.elements = comparison.elements.size();
    for (const ComparedMean<D>& m : comparison.means) {
        InspectedMean mean{std::string(name(m.mean)), m.failure, {}, 1, m.turn_deg};
        if (m.failure.empty()) {
            mean.sizes = numbers<D>(m.metric.sizes);
            mean.aspect_ratio = aspect_ratio<D>(m.metric);
        }
        i.means.push_back(std::move(mean));
    }
    return i;
}

std::string list_of(const std::vector<double>& values, int digits) {
    std::string text;
    for (const double value : values) {
        text += (text.empty() ? "" : "  ") + number_text(value, digits);
    }
    return text;
}

} // namespace

Inspection inspect(const CaseLevel& level, NodeId node, const TargetOptions& target,
                   ElementId element) {
    Inspection result = std::visit(
        [&](const auto& l) {
            Inspection i = inspect_level(l, node, target, *level.scene);
            if (element.valid()) {
                i.element = inspect_element(l, element);
            }
            return i;
        },
        *level.level);
    result.level_id = level.id;
    result.level = level.number;
    return result;
}

std::string inspection_text(const Inspection& i) {
    std::ostringstream text;
    text << "level " << i.level << ", node " << i.node.value() << '\n';
    text << "position      " << list_of(i.point, 10) << '\n';
    text << "patches      ";
    for (const std::string& patch : i.patches) {
        text << ' ' << patch;
    }
    text << (i.patches.empty() ? " none" : "") << "\nclass         " << i.node_class << '\n'
         << "elements      " << i.elements << ", worst quality " << number_text(i.worst_quality, 3)
         << '\n'
         << "aspect ratio  " << number_text(i.aspect_ratio) << '\n'
         << "sizes         " << list_of(i.sizes, 5) << '\n'
         << "target sizes  " << list_of(i.target_sizes, 5) << '\n';
    for (std::size_t k = 0; k < i.directions.size(); ++k) {
        text << "direction " << k + 1 << "   " << list_of(i.directions[k], 6) << '\n';
    }
    for (const InspectedMean& m : i.means) {
        text << m.name << ": ";
        m.failure.empty() ? text << "sizes " << list_of(m.sizes, 5) << ", aspect ratio "
                                 << number_text(m.aspect_ratio) << ", turned by "
                                 << number_text(m.turn_deg, 3) << " deg\n"
                          : text << m.failure << '\n';
    }
    if (i.element) {
        const InspectedElement& e = *i.element;
        text << "element " << e.id.value() << ": nodes";
        for (const int node : e.nodes) {
            text << ' ' << node;
        }
        text << ", region " << e.region << ", volume " << number_text(e.volume) << ", quality "
             << number_text(e.quality, 3) << ", aspect ratio " << number_text(e.aspect_ratio)
             << ", sizes " << list_of(e.sizes, 5) << '\n';
    }
    return text.str();
}

} // namespace ameco::gui
