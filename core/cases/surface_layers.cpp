// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/surface_layers.h"

#include "core/base/error.h"
#include "core/cases/prism.h"
#include "core/cases/surface_columns.h"
#include "core/mesh/check.h"
#include "core/mesh/simplex.h"
#include "core/surface/surface_repair.h"

#include <algorithm>

namespace ameco {
namespace {

void require_sense(const SurfaceLayerOptions& options) {
    if (!(options.first_height > 0) || !(options.growth >= 1) || options.layers < 1) {
        throw UsageError("layers need a first height above 0, a growth of at least 1 and at least "
                         "one layer");
    }
}

/// Nodes of the columns: the feet, then layer by layer the columns that have a height.
class ColumnNodes {
public:
    explicit ColumnNodes(const SurfaceColumns& columns) : place_(columns.share.size(), -1) {
        for (std::size_t c = 0; c < place_.size(); ++c) {
            if (!columns.collapsed(NodeId(c))) {
                place_[c] = static_cast<std::int64_t>(per_layer_++);
            }
        }
    }
    [[nodiscard]] NodeId operator()(std::size_t column, std::size_t layer) const {
        if (layer == 0 || place_[column] < 0) {
            return NodeId(column);
        }
        return NodeId(place_.size() + (layer - 1) * per_layer_ +
                      static_cast<std::size_t>(place_[column]));
    }

private:
    std::vector<std::int64_t> place_;
    std::size_t per_layer_ = 0;
};

void add_layers(Mesh<3>& mesh, const SurfaceColumns& columns, const ColumnNodes& node,
                const Mesh<3>& surface, const std::vector<std::uint64_t>& rank) {
    const std::size_t layers = columns.distance.size() - 1;
    mesh.points = surface.points;
    for (std::size_t k = 1; k <= layers; ++k) {
        for (const NodeId v : surface.points.ids()) {
            if (!columns.collapsed(v)) {
                mesh.points.push_back(columns.point(surface, v, k));
            }
        }
    }
    mesh.elements.reserve(3 * layers * surface.faces.size());
    for (std::size_t k = 0; k < layers; ++k) {
        for (const Facet<3>& f : surface.faces) {
            split_prism(std::array{f[0].value(), f[1].value(), f[2].value()}, rank,
                        [&](const std::array<PrismCorner, 4>& corners) {
                            Simplex<3> s;
                            for (std::size_t i = 0; i < 4; ++i) {
                                s[i] = node(corners[i].column, k + (corners[i].top ? 1 : 0));
                            }
                            Simplex<3> ascending = sorted(s);
                            if (std::adjacent_find(ascending.begin(), ascending.end()) ==
                                ascending.end()) {
                                mesh.elements.push_back(s);
                            }
                        });
        }
    }
    for (const FaceId f : surface.faces.ids()) { // the body is outside of the mesh
        const auto& [a, b, c] = surface.faces[f];
        mesh.faces.push_back({a, c, b});
        mesh.patch.push_back(surface.patch[f]);
    }
    mesh.patch_names = surface.patch_names;
}

/// Adds the tets beyond the last layer, whose nodes come first in `beyond`.
void add_space(Mesh<3>& mesh, const Mesh<3>& beyond, const ColumnNodes& node, std::size_t columns,
               std::size_t layers) {
    std::vector<NodeId> number(beyond.points.size());
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (i < columns) {
            number[i] = node(i, layers);
        } else {
            number[i] = mesh.points.next_id();
            mesh.points.push_back(beyond.points[NodeId(i)]);
        }
    }
    for (const Simplex<3>& s : beyond.elements) {
        mesh.elements.push_back({number[s[0].index()], number[s[1].index()], number[s[2].index()],
                                 number[s[3].index()]});
    }
    for (const FaceId f : beyond.faces.ids()) {
        const Facet<3>& n = beyond.faces[f];
        // Farfield faces have nodes of the farfield only; the others are inside the mesh now.
        if (n[0].index() >= columns && n[1].index() >= columns && n[2].index() >= columns) {
            mesh.faces.push_back(
                {number[n[0].index()], number[n[1].index()], number[n[2].index()]});
            mesh.patch.push_back(beyond.patch[f]);
        }
    }
    mesh.patch_names.insert(beyond.patch_names.begin(), beyond.patch_names.end());
    mesh.region.assign(mesh.elements.size(), 1);
}

void count_columns(const SurfaceColumns& columns, const Mesh<3>& surface, SurfaceLayers& result) {
    result.columns = static_cast<std::int64_t>(surface.points.size());
    result.height = columns.distance.back();
    result.share = columns.share;
    for (const NodeId v : surface.points.ids()) {
        result.collapsed += columns.collapsed(v) ? 1 : 0;
        result.shrunk += columns.share[v] > 0 && columns.share[v] < 1 ? 1 : 0;
        if (columns.share[v] > 0 && columns.share[v] < result.least_share) {
            result.least_share = columns.share[v];
            result.at = surface.points[v];
        }
    }
}

/// The surface of the last layer, with the nodes of the given one.
Mesh<3> last_layer(const SurfaceColumns& columns, const Mesh<3>& surface) {
    Mesh<3> top = surface;
    top.features = {};
    for (const NodeId v : surface.points.ids()) {
        top.points[v] = columns.point(surface, v, columns.distance.size() - 1);
    }
    return top;
}

} // namespace

SurfaceLayers make_surface_layers(const Mesh<3>& surface, const SurfaceLayerOptions& options,
                                  const std::string& name, Monitor& monitor) {
    require_sense(options);
    const SurfaceReport report = inspect_surface(surface);
    require_sound_surface(report, name, repair_helps(surface, report));
    for (const SurfacePart& part : report.parts) {
        if (part.volume < 0) {
            throw InputError(name + ": is turned inwards; ameco surface --repair turns it");
        }
    }
    if (report.unused_nodes > 0) {
        throw InputError(name + ": has nodes that no face uses; ameco surface --repair drops them");
    }
    SurfaceLayers result;
    MonitorPart finding(monitor, 0, 0.3), filling(monitor, 0.3, 0.8);
    const SurfaceColumns columns = find_columns(surface, options, name, finding);
    count_columns(columns, surface, result);
    const ColumnNodes node(columns);
    add_layers(result.mesh, columns, node, surface, column_ranks(surface, options));
    result.layer_nodes = static_cast<std::int64_t>(result.mesh.points.size());
    result.layer_elements = static_cast<std::int64_t>(result.mesh.elements.size());

    FillOptions fill_options;
    fill_options.farfield = options.farfield;
    fill_options.recovery.radius_edge = options.radius_edge;
    Fill fill = fill_surface(last_layer(columns, surface), fill_options, name, filling);
    add_space(result.mesh, fill.mesh, node, surface.points.size(),
              static_cast<std::size_t>(options.layers));
    result.recovery = std::move(fill.recovery);
    monitor.progress(0.85, "testing the mesh");
    const CheckReport checked = check(result.mesh);
    if (!checked.valid()) {
        throw CheckFailed(name + ": the mesh with layers is not valid: " + checked.summary());
    }
    return result;
}

} // namespace ameco
