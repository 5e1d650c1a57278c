// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/recovery/fill.h"

#include "core/base/error.h"
#include "core/surface/surface_repair.h"
#include "core/surface/surface_report.h"
#include "core/surface/surface_tree.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ameco {
namespace {

/// Puts the farfield behind the surface.
void join(Mesh<3>& surface, const Mesh<3>& farfield) {
    const std::size_t n = surface.points.size();
    for (const Vec<3>& x : farfield.points) {
        surface.points.push_back(x);
    }
    for (const FaceId f : farfield.faces.ids()) {
        Facet<3> face = farfield.faces[f];
        for (NodeId& v : face) {
            v = NodeId(v.index() + n);
        }
        surface.faces.push_back(face);
        surface.patch.push_back(farfield.patch[f]);
    }
    surface.labels.clear();
    surface.patch_names.insert(farfield.patch_names.begin(), farfield.patch_names.end());
}

int free_patch(const Mesh<3>& surface) {
    int highest = 0;
    for (const int patch : surface.patch) {
        highest = std::max(highest, patch);
    }
    for (const auto& [patch, name] : surface.patch_names) {
        highest = std::max(highest, patch);
    }
    return highest + 1;
}

/// The part that holds a point most narrowly, -1 for none.
int holder_of(const Vec<3>& p, const SurfaceTree& tree, const SurfaceReport& report,
              const std::vector<int>& depth) {
    const double reach = 4 * tree.bounds().diagonal().norm() + (p - tree.bounds().center()).norm();
    for (int attempt = 1; attempt <= 32; ++attempt) {
        const Vec<3> direction(std::cos(1.7 * attempt), std::sin(2.3 * attempt),
                               std::cos(0.9 * attempt + 0.4));
        const auto crossed = tree.crossings(p, p + reach * direction.normalized());
        if (!crossed) {
            continue;
        }
        std::vector<int> times(report.parts.size(), 0);
        for (const Crossing& c : *crossed) {
            ++times[static_cast<std::size_t>(report.part_of[c.face])];
        }
        int holder = -1;
        for (std::size_t part = 0; part < times.size(); ++part) {
            if (times[part] % 2 == 1 &&
                (holder < 0 || depth[part] > depth[static_cast<std::size_t>(holder)])) {
                holder = static_cast<int>(part);
            }
        }
        return holder;
    }
    throw UsageError("cannot tell what holds the point " + std::to_string(p[0]) + "," +
                     std::to_string(p[1]) + "," + std::to_string(p[2]) +
                     ": it lies on the surface");
}

} // namespace

Vec<3> point_inside(const Mesh<3>& surface, const IdVector<FaceId, int>& part_of, int part) {
    const SurfaceTree tree(surface);
    const double diagonal = tree.bounds().diagonal().norm();
    std::vector<FaceId> faces;
    double volume = 0; // of the part, for the side its normals point to
    const Vec<3> origin = tree.bounds().center();
    for (const FaceId f : surface.faces.ids()) {
        if (part_of[f] == part) {
            faces.push_back(f);
            const auto& t = tree.triangle(f);
            volume += (t[0] - origin).dot((t[1] - origin).cross(t[2] - origin));
        }
    }
    constexpr std::size_t samples = 256;
    const std::size_t stride = std::max<std::size_t>(1, faces.size() / samples);
    double best = 0;
    Vec<3> point = Vec<3>::Zero();
    for (std::size_t i = 0; i < faces.size(); i += stride) {
        const auto& t = tree.triangle(faces[i]);
        const Vec<3> n = (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized();
        const Vec<3> p = (t[0] + t[1] + t[2]) / 3;
        const Vec<3> inwards = volume > 0 ? Vec<3>(-n) : n;
        // Straight inwards a symmetric body's rays may all meet edges beyond it: then a bit aside.
        std::optional<std::vector<Crossing>> crossed;
        Vec<3> q = p;
        for (int attempt = 0; attempt < 4 && !crossed; ++attempt) {
            const Vec<3> aside(0.013 * attempt, 0.029 * attempt, -0.017 * attempt);
            q = p + 2 * diagonal * (inwards + aside);
            crossed = tree.crossings(p, q, [&](FaceId f) { return f == faces[i]; });
        }
        if (!crossed || crossed->empty()) {
            continue;
        }
        const Vec<3> half_way = p + crossed->front().along / 2 * (q - p);
        const double clearance = tree.distance(half_way);
        if (clearance > best) {
            best = clearance;
            point = half_way;
        }
    }
    if (best == 0) {
        throw InputError("no point is found inside the part of the surface with face " +
                         std::to_string(faces.front().value()) + ": it is too thin");
    }
    return point;
}

std::vector<Vec<3>> points_in_cavities(const Mesh<3>& surface) {
    const SurfaceReport report = inspect_surface(surface, false);
    const std::vector<bool> closed(report.parts.size(), true);
    const std::vector<int> depth =
        nesting_depths(surface, SurfaceTree(surface), report.part_of, closed);
    std::vector<Vec<3>> points;
    for (std::size_t part = 0; part < depth.size(); ++part) {
        if (depth[part] % 2 == 1) {
            points.push_back(point_inside(surface, report.part_of, static_cast<int>(part)));
        }
    }
    return points;
}

Fill fill_surface(const Mesh<3>& surface, const FillOptions& options, const std::string& name,
                  Monitor& monitor) {
    Mesh<3> whole = surface;
    if (options.farfield) {
        if (whole.points.empty()) {
            throw InputError(name + ": has no nodes");
        }
        join(whole, make_farfield(*options.farfield, surface, free_patch(surface)));
    }
    monitor.progress(0, "testing the surface");
    SurfaceReport report = inspect_surface(whole);
    require_sound_surface(report, name, repair_helps(whole, report));
    static_cast<void>(repair_surface(whole)); // turns cavities inwards
    const SurfaceTree tree(whole);
    const std::vector<bool> closed(report.parts.size(), true);
    const std::vector<int> depth = nesting_depths(whole, tree, report.part_of, closed);
    std::vector<bool> filled(report.parts.size());
    for (std::size_t part = 0; part < filled.size(); ++part) {
        filled[part] = depth[part] % 2 == 0;
    }
    for (const RegionSeed& seed : options.recovery.regions) {
        const int holder = holder_of(seed.inside, tree, report, depth);
        if (holder < 0) {
            throw UsageError("--region: the point is outside of the surface");
        }
        filled[static_cast<std::size_t>(holder)] = true;
    }
    Fill fill;
    fill.surface_nodes = static_cast<std::int64_t>(whole.points.size());
    RecoveryOptions recovery = options.recovery;
    if (!recovery.sizes.empty()) { // the farfield's nodes have none: TetGen takes 0 for that
        recovery.sizes.resize(whole.points.size(), 0);
    }
    for (std::size_t part = 0; part < filled.size(); ++part) {
        if (!filled[part]) {
            recovery.holes.push_back(point_inside(whole, report.part_of, static_cast<int>(part)));
        }
    }
    fill.empty = recovery.holes;
    fill.recovery = recover_boundary(whole, recovery, name, monitor);
    fill.mesh = std::move(fill.recovery.mesh);
    fill.recovery.mesh = {};
    return fill;
}

} // namespace ameco
