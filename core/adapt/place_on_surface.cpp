// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/place_on_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace ameco {
namespace {

template <int D>
Vec<D> mean_of(const std::array<Vec<D>, D>& x, const BoundaryPoint<D>& foot) {
    Vec<D> p = Vec<D>::Zero();
    for (std::size_t i = 0; i < D; ++i) {
        p += foot.weights[i] * x[i];
    }
    for (int k = 0; k < D; ++k) {
        if (std::all_of(x.begin(), x.end(), [&](const Vec<D>& y) { return y[k] == x[0][k]; })) {
            p[k] = x[0][k];
        }
    }
    return p;
}

} // namespace

Vec<2> unit_normal(const std::array<Vec<2>, 2>& face) {
    const Vec<2> t = face[1] - face[0];
    return Vec<2>(t[1], -t[0]).normalized();
}

Vec<3> unit_normal(const std::array<Vec<3>, 3>& face) {
    return (face[1] - face[0]).cross(face[2] - face[0]).normalized();
}

template <int D>
void gather_site(const EditMesh<D>& mesh, NodeId v, SurfaceSite<D>& site) {
    gather_faces(mesh, v, site.faces);
    site.on_ridge = mesh.node_class(v) == NodeClass::ridge;
    site.direction.setZero();
    for (const auto& x : site.faces.corners) {
        site.direction += unit_normal(x);
    }
    site.direction.normalize();
    site.patches.clear();
    for (const ElementId e : site.faces.ghosts) {
        site.patches.push_back(mesh.element(e).label);
    }
    std::sort(site.patches.begin(), site.patches.end());
    site.patches.erase(std::unique(site.patches.begin(), site.patches.end()), site.patches.end());
}

template <int D>
std::optional<Vec<D>> place_on_surface(const OriginalSurface<D>& original,
                                       const SurfaceSite<D>& site, const Vec<D>& p,
                                       double largest_turn_deg) {
    if (site.patches.size() > (site.on_ridge ? 2 : 1)) {
        return {};
    }
    const BoundaryPoint<D> foot = site.on_ridge
                                      ? original.projection().project_on_line(p, site.patches)
                                      : original.projection().project(p, site.patches);
    if (!foot.nodes[0].valid()) {
        return {};
    }
    std::array<Vec<D>, D> x;
    for (std::size_t i = 0; i < D; ++i) {
        x[i] = original.boundary().points[foot.nodes[i]];
    }
    // A line has no sense of its own.
    const double cosine = site.on_ridge ? std::abs((x[1] - x[0]).normalized().dot(site.direction))
                                        : unit_normal(x).dot(site.direction);
    if (!(cosine >= std::cos(largest_turn_deg * std::numbers::pi / 180))) {
        return {};
    }
    return mean_of<D>(x, foot);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template void gather_site(const EditMesh<D>&, NodeId, SurfaceSite<D>&);                        \
    template std::optional<Vec<D>> place_on_surface(const OriginalSurface<D>&,                     \
                                                    const SurfaceSite<D>&, const Vec<D>&, double);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
