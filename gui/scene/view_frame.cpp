// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/view_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace ameco::gui {
namespace {

/// Twice the signed area of a triangle.
double area2(const Pixel& a, const Pixel& b, const Pixel& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Barycentric coordinates of `p`; nothing outside the triangle or when it is seen edge-on.
std::optional<std::array<double, 3>> inside(const Pixel& p, const Pixel& a, const Pixel& b,
                                            const Pixel& c) {
    const double all = area2(a, b, c);
    if (all == 0) {
        return std::nullopt;
    }
    const std::array<double, 3> w{area2(p, b, c) / all, area2(a, p, c) / all, area2(a, b, p) / all};
    return *std::min_element(w.begin(), w.end()) >= 0 ? std::optional(w) : std::nullopt;
}

struct Hit {
    std::size_t polygon = 0;
    double depth = std::numeric_limits<double>::infinity();
    Vec3 place = Vec3::Zero();
};

Hit nearest_hit(const VisibleSurface& surface, const std::vector<Vec3>& places,
                const ViewFrame& frame, const Pixel& pixel) {
    std::vector<Pixel> pixels(places.size());
    std::transform(places.begin(), places.end(), pixels.begin(),
                   [&](const Vec3& y) { return frame.pixel_of_place(y); });
    Hit hit;
    for (std::size_t k = 0; k < surface.polygons.size(); ++k) {
        const auto& p = surface.polygons[k];
        for (std::size_t t = 1; t < 3 && p[t + 1] >= 0; ++t) {
            const std::array<std::size_t, 3> c{static_cast<std::size_t>(p[0]),
                                               static_cast<std::size_t>(p[t]),
                                               static_cast<std::size_t>(p[t + 1])};
            const auto w = inside(pixel, pixels[c[0]], pixels[c[1]], pixels[c[2]]);
            if (!w) {
                continue;
            }
            const Vec3 place =
                (*w)[0] * places[c[0]] + (*w)[1] * places[c[1]] + (*w)[2] * places[c[2]];
            if (const double depth = place.dot(frame.sight); depth < hit.depth) {
                hit = {k, depth, place};
            }
        }
    }
    return hit;
}

double squared_distance(const Pixel& a, const Pixel& b) {
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/// Of the polygon's corners that are nodes; of a section, of the element's nodes.
NodeId nearest_node(const SceneData& data, const VisibleSurface& surface, std::size_t polygon,
                    const ViewFrame& frame, const Pixel& pixel) {
    std::vector<NodeId> nodes;
    for (const std::int32_t c : surface.polygons[polygon]) {
        if (c >= 0 && static_cast<std::size_t>(c) < surface.nodes.size()) {
            nodes.push_back(surface.nodes[static_cast<std::size_t>(c)]);
        }
    }
    if (nodes.empty()) {
        std::visit(
            [&](const auto& input) {
                const auto& s = input.mesh->elements[surface.elements[polygon]];
                nodes.assign(s.begin(), s.end());
            },
            data.input);
    }
    return *std::min_element(nodes.begin(), nodes.end(), [&](NodeId a, NodeId b) {
        return squared_distance(frame.pixel_of(data.position(a)), pixel) <
               squared_distance(frame.pixel_of(data.position(b)), pixel);
    });
}

} // namespace

Pixel ViewFrame::pixel_of_place(const Vec3& y) const {
    const Vec3 d = y - focus;
    return {area.left + area.width / 2 + d.dot(right) / units_per_pixel,
            area.bottom + area.height / 2 + d.dot(up) / units_per_pixel};
}

ViewFrame make_view_frame(const Camera& camera, const ViewTransform& transform, const Area& area) {
    ViewFrame frame;
    frame.transform = transform;
    frame.sight = camera.sight.normalized();
    frame.right = frame.sight.cross(camera.up).normalized();
    frame.up = frame.right.cross(frame.sight);
    frame.focus = transform.forward(camera.focus);
    frame.units_per_pixel = camera.height / std::max(1.0, area.height);
    frame.area = area;
    return frame;
}

std::optional<Pick> pick_surface(const SceneData& data, const VisibleSurface& surface,
                                 const std::vector<Vec3>& places, const ViewFrame& frame,
                                 const Pixel& pixel) {
    const Hit hit = nearest_hit(surface, places, frame, pixel);
    if (!std::isfinite(hit.depth)) {
        return std::nullopt;
    }
    Pick pick;
    pick.element = surface.elements[hit.polygon];
    pick.face = surface.faces[hit.polygon];
    pick.patch = pick.face.valid() ? data.triangle_patch[pick.face.index()] : 0;
    pick.node = nearest_node(data, surface, hit.polygon, frame, pixel);
    pick.position = frame.transform.backward(hit.place);
    if (data.dimension == 2) {
        pick.normal = {0, 0, 1};
    } else {
        std::array<Vec3, 3> x;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto corner = static_cast<std::size_t>(surface.polygons[hit.polygon][k]);
            x[k] = frame.transform.inverse * places[corner];
        }
        pick.normal = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
    }
    return pick;
}

HandleShape handle_shape(const ClipPlane& clip, const ViewFrame& frame, double length) {
    const Vec3 n = clip.normal.normalized();
    const Vec3 middle = frame.transform.backward(frame.focus);
    const Vec3 foot = middle - (middle - clip.origin).dot(n) * n;
    HandleShape shape{frame.pixel_of(foot), {}};
    // The normal as it is seen: planes are mapped by the inverse transpose.
    const Vec3 seen = (frame.transform.inverse.transpose() * n).normalized();
    double x = seen.dot(frame.right);
    double y = seen.dot(frame.up);
    if (const double shown = std::hypot(x, y); shown < 0.25) { // almost along the sight
        x = shown > 0 ? 0.25 * x / shown : 0;
        y = shown > 0 ? 0.25 * y / shown : 0.25;
    }
    shape.tip = {shape.foot[0] + length * x, shape.foot[1] + length * y};
    return shape;
}

ClipPlane shifted(const ClipPlane& clip, const ViewFrame& frame, const Pixel& from,
                  const Pixel& to) {
    const Vec3 n = clip.normal.normalized();
    const Vec3 seen = frame.transform.A * n; // what a step of 1 along the normal looks like
    const double x = seen.dot(frame.right) / frame.units_per_pixel;
    const double y = seen.dot(frame.up) / frame.units_per_pixel;
    const double whole = seen.norm() / frame.units_per_pixel;
    const double dx = to[0] - from[0];
    const double dy = to[1] - from[1];
    ClipPlane moved = clip;
    const double squared = x * x + y * y;
    if (squared > 0.01 * whole * whole) {
        moved.origin += (dx * x + dy * y) / squared * n;
    } else {
        moved.origin += dy / whole * n; // along the sight: upwards is forwards
    }
    return moved;
}

ClipPlane turned(const ClipPlane& clip, const ViewFrame& frame, const Pixel& from, const Pixel& to,
                 double length) {
    const Vec3 seen = (frame.transform.inverse.transpose() * clip.normal).normalized();
    const Vec3 followed =
        seen + (to[0] - from[0]) / length * frame.right + (to[1] - from[1]) / length * frame.up;
    if (followed.norm() < 0.1) {
        return clip;
    }
    const Vec3 middle = frame.transform.backward(frame.focus);
    const Vec3 n = clip.normal.normalized();
    ClipPlane result = clip;
    result.origin = middle - (middle - clip.origin).dot(n) * n;
    result.normal = (frame.transform.A.transpose() * followed).normalized();
    return result;
}

} // namespace ameco::gui
