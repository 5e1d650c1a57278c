// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/visible_surface.h"

#include "core/base/parallel.h"
#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco::gui {
namespace {

constexpr std::size_t piece_size = 1 << 16;

} // namespace

SurfaceExtractor::SurfaceExtractor(std::shared_ptr<const SceneData> data)
    : data_(std::move(data)), point_of_node_(data_->node_count, -1) {}

const VisibleSurface& SurfaceExtractor::extract(const ClipPlane& clip,
                                                const std::set<int>& hidden_patches,
                                                bool boundary_only) {
    for (const NodeId i : surface_.nodes) {
        point_of_node_[i.index()] = -1;
    }
    surface_.nodes.clear();
    surface_.cuts.clear();
    surface_.polygons.clear();
    surface_.elements.clear();
    surface_.faces.clear();
    surface_.lines.clear();
    surface_.line_patch.clear();
    surface_.cut_elements.clear();
    clipped_ = clip.enabled;
    if (clipped_) {
        find_sides(clip);
    }
    add_boundary(clip, hidden_patches);
    if (clipped_ && !boundary_only && data_->dimension == 3) {
        add_inside(clip);
    }
    add_lines(clip, hidden_patches);
    // Cut points were numbered from 0 on; they come behind the nodes.
    const auto first = static_cast<std::int32_t>(surface_.nodes.size());
    const auto renumber = [&](std::int32_t& p) { p = p < -1 ? first + (-2 - p) : p; };
    for (auto& polygon : surface_.polygons) {
        std::for_each(polygon.begin(), polygon.end(), renumber);
    }
    for (auto& line : surface_.lines) {
        std::for_each(line.begin(), line.end(), renumber);
    }
    return surface_;
}

void SurfaceExtractor::find_sides(const ClipPlane& clip) {
    offset_.resize(data_->node_count);
    const Vec3 normal = clip.normal.normalized() * (clip.keep_other_side ? -1 : 1);
    parallel_for(data_->node_count, piece_size, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            offset_[i] = (data_->position(NodeId(i)) - clip.origin).dot(normal);
        }
    });
}

std::int32_t SurfaceExtractor::point(NodeId node) {
    std::int32_t& p = point_of_node_[node.index()];
    if (p < 0) {
        p = static_cast<std::int32_t>(surface_.nodes.size());
        surface_.nodes.push_back(node);
    }
    return p;
}

/// The place where the plane cuts an edge, numbered -2, -3, ... until all nodes are known.
std::int32_t SurfaceExtractor::point(NodeId a, NodeId b) {
    const double s = offset_[a.index()];
    const double t = s / (s - offset_[b.index()]);
    surface_.cuts.push_back({a, b, t});
    return -1 - static_cast<std::int32_t>(surface_.cuts.size());
}

void SurfaceExtractor::add_triangle(const std::array<NodeId, 3>& nodes, ElementId element,
                                    FaceId face) {
    surface_.polygons.push_back({point(nodes[0]), point(nodes[1]), point(nodes[2]), -1});
    surface_.elements.push_back(element);
    surface_.faces.push_back(face);
}

/// The part of a triangle behind the plane.
void SurfaceExtractor::add_clipped(const std::array<NodeId, 3>& nodes, ElementId element,
                                   FaceId face) {
    std::array<std::int32_t, 4> polygon{-1, -1, -1, -1};
    std::size_t corners = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const NodeId a = nodes[k];
        const NodeId b = nodes[(k + 1) % 3];
        if (!in_front(a)) {
            polygon[corners++] = point(a);
        }
        if (in_front(a) != in_front(b)) {
            polygon[corners++] = point(a, b);
        }
    }
    if (corners >= 3) {
        surface_.polygons.push_back(polygon);
        surface_.elements.push_back(element);
        surface_.faces.push_back(face);
    }
}

/// The section of a tet with the plane.
void SurfaceExtractor::add_section(const std::array<NodeId, 4>& nodes, ElementId element) {
    std::array<NodeId, 4> front;
    std::array<NodeId, 4> behind;
    std::size_t fronts = 0;
    std::size_t behinds = 0;
    for (const NodeId i : nodes) {
        (in_front(i) ? front[fronts++] : behind[behinds++]) = i;
    }
    std::array<std::int32_t, 4> polygon{-1, -1, -1, -1};
    if (fronts == 2) {
        polygon = {point(front[0], behind[0]), point(front[0], behind[1]),
                   point(front[1], behind[1]), point(front[1], behind[0])};
    } else {
        const NodeId lone = fronts == 1 ? front[0] : behind[0];
        const auto& others = fronts == 1 ? behind : front;
        for (std::size_t k = 0; k < 3; ++k) {
            polygon[k] = point(lone, others[k]);
        }
    }
    surface_.polygons.push_back(polygon);
    surface_.elements.push_back(element);
    surface_.faces.push_back({});
}

void SurfaceExtractor::add_boundary(const ClipPlane& clip, const std::set<int>& hidden) {
    const bool is_solid = data_->dimension == 3;
    int last_patch = 0;
    bool last_hidden = hidden.contains(0);
    for (std::size_t t = 0; t < data_->triangles.size(); ++t) {
        if (const int patch = data_->triangle_patch[t]; is_solid && patch != last_patch) {
            last_patch = patch;
            last_hidden = hidden.contains(patch);
        }
        if (is_solid && last_hidden) {
            continue;
        }
        const auto& nodes = data_->triangles[t];
        const ElementId element = data_->triangle_element[t];
        const FaceId face = is_solid ? FaceId(t) : FaceId();
        const auto fronts = clipped_ ? std::count_if(nodes.begin(), nodes.end(),
                                                     [&](NodeId i) { return in_front(i); })
                                     : 0;
        if (!is_solid && fronts > 0 && fronts < 3) {
            surface_.cut_elements.push_back(element);
        }
        if (fronts == 0) {
            add_triangle(nodes, element, face);
        } else if (!clip.crinkle) {
            add_clipped(nodes, element, face);
        } else {
            const auto shown = [&](NodeId i) { return !in_front(i); };
            const bool keep = is_solid && element.valid()
                                  ? std::any_of(data_->tets[element.index()].begin(),
                                                data_->tets[element.index()].end(), shown)
                                  : fronts < 3;
            if (keep) {
                add_triangle(nodes, element, face);
            }
        }
    }
}

void SurfaceExtractor::add_inside(const ClipPlane& clip) {
    const auto& tets = data_->tets;
    std::vector<std::vector<ElementId>> pieces((tets.size() + piece_size - 1) / piece_size);
    parallel_for(tets.size(), piece_size, [&](std::size_t begin, std::size_t end) {
        auto& cut = pieces[begin / piece_size];
        for (std::size_t e = begin; e < end; ++e) {
            const auto& s = tets[e];
            const int fronts = (in_front(s[0]) ? 1 : 0) + (in_front(s[1]) ? 1 : 0) +
                               (in_front(s[2]) ? 1 : 0) + (in_front(s[3]) ? 1 : 0);
            if (fronts > 0 && fronts < 4) {
                cut.push_back(ElementId(e));
            }
        }
    });
    for (const auto& piece : pieces) {
        surface_.cut_elements.insert(surface_.cut_elements.end(), piece.begin(), piece.end());
    }
    for (const ElementId e : surface_.cut_elements) {
        const auto& s = tets[e.index()];
        if (!clip.crinkle) {
            add_section(s, e);
            continue;
        }
        // A facet in front of the plane is seen where the element on its other side is not shown,
        // which has then no node behind the plane; otherwise it is inside what is shown, and
        // hidden.
        const auto fronts =
            std::count_if(s.begin(), s.end(), [&](NodeId i) { return in_front(i); });
        for (int k = 0; fronts == 3 && k < 4; ++k) {
            const bool on_boundary = (data_->boundary_facets[e.index()] >> k & 1) != 0;
            if (!in_front(s[static_cast<std::size_t>(k)]) && !on_boundary) {
                add_triangle(facet_of<3>(s, k), e, {});
            }
        }
    }
}

void SurfaceExtractor::add_lines(const ClipPlane& clip, const std::set<int>& hidden) {
    for (std::size_t l = 0; l < data_->lines.size(); ++l) {
        const auto [a, b] = data_->lines[l];
        if (hidden.contains(data_->line_patch[l]) || (clipped_ && in_front(a) && in_front(b))) {
            continue;
        }
        if (!clipped_ || clip.crinkle || in_front(a) == in_front(b)) {
            surface_.lines.push_back({point(a), point(b)});
        } else {
            surface_.lines.push_back({point(in_front(a) ? b : a), point(a, b)});
        }
        surface_.line_patch.push_back(data_->line_patch[l]);
    }
}

} // namespace ameco::gui
