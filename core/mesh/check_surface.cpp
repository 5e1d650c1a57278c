// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/check_surface.h"

#include "core/mesh/references.h"
#include "core/mesh/simplex.h"
#include "core/mesh/surface_edges.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ameco {
namespace {

class Findings {
public:
    void add(Defect defect, const std::string& example) {
        const auto found = std::find_if(list_.begin(), list_.end(),
                                        [&](const Finding& f) { return f.defect == defect; });
        if (found != list_.end()) {
            ++found->count;
        } else {
            list_.push_back({defect, 1, example});
        }
    }
    [[nodiscard]] std::vector<Finding> take() { return std::move(list_); }
    [[nodiscard]] bool empty() const { return list_.empty(); }

private:
    std::vector<Finding> list_;
};

std::string describe(const EdgeUse& use) {
    return "edge " + std::to_string(use.edge[0].value()) + " " +
           std::to_string(use.edge[1].value()) + " of face " + std::to_string(use.face.value());
}

void test_edges(const Mesh<3>& mesh, Findings& findings) {
    for_each_edge(edge_uses(mesh.faces), [&](std::span<const EdgeUse> uses) {
        if (uses.size() == 1) {
            findings.add(Defect::boundary_not_closed, describe(uses[0]));
        } else if (uses.size() > 2) {
            findings.add(Defect::boundary_not_manifold, describe(uses[0]));
        } else if (uses[0].ascending == uses[1].ascending) {
            findings.add(Defect::face_turned_inward, describe(uses[1]));
        }
    });
}

void test_duplicates(const Mesh<3>& mesh, Findings& findings) {
    std::vector<std::pair<Facet<3>, FaceId>> faces;
    faces.reserve(mesh.faces.size());
    for (const FaceId f : mesh.faces.ids()) {
        faces.emplace_back(sorted(mesh.faces[f]), f);
    }
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 1; i < faces.size(); ++i) {
        if (faces[i].first == faces[i - 1].first) {
            findings.add(Defect::duplicate_face,
                         "faces " + std::to_string(faces[i - 1].second.value()) + " and " +
                             std::to_string(faces[i].second.value()));
        }
    }
}

/// From the first point, so that a distant origin costs no digits.
double enclosed_volume(const Mesh<3>& mesh) {
    const Vec<3> origin = mesh.points[mesh.faces[FaceId(0)][0]];
    double volume = 0;
    for (const Facet<3>& f : mesh.faces) {
        const Vec<3> a = mesh.points[f[0]] - origin;
        const Vec<3> b = mesh.points[f[1]] - origin;
        const Vec<3> c = mesh.points[f[2]] - origin;
        volume += a.dot(b.cross(c)) / 6;
    }
    return volume;
}

} // namespace

CheckReport check_surface(const Mesh<3>& mesh) {
    CheckReport report;
    if (mesh.faces.empty() || !is_computable(mesh)) {
        return check(mesh); // which names what is wrong with numbers and coordinates
    }
    Findings findings;
    test_duplicates(mesh, findings);
    test_edges(mesh, findings);
    report.volume = report.boundary_flux = enclosed_volume(mesh);
    if (findings.empty() && report.volume < 0) {
        findings.add(Defect::face_turned_inward,
                     "all faces: the surface encloses a negative volume");
    }
    report.errors = findings.take();
    return report;
}

} // namespace ameco
