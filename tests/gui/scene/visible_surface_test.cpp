// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/cases.h"
#include "core/mesh/simplex.h"
#include "gui/scene/visible_surface.h"

#include <QTest>

#include <bit>
#include <map>
#include <set>

#include <Eigen/Geometry>

using namespace ameco;
using namespace ameco::gui;

namespace {

std::shared_ptr<const SceneData> make(const char* name,
                                      const std::map<std::string, std::string>& parameters) {
    return std::visit(
        []<int D>(const Mesh<D>& mesh) {
            SceneInput<D> input;
            input.mesh = std::make_shared<const Mesh<D>>(mesh);
            return make_scene_data(std::move(input));
        },
        make_case(name, parameters));
}

Vec3 place(const SceneData& data, const VisibleSurface& surface, std::int32_t point) {
    const auto p = static_cast<std::size_t>(point);
    if (p < surface.nodes.size()) {
        return data.position(surface.nodes[p]);
    }
    const CutPoint& c = surface.cuts[p - surface.nodes.size()];
    return data.position(c.a) + c.t * (data.position(c.b) - data.position(c.a));
}

double area(const SceneData& data, const VisibleSurface& surface, bool inside_only = false) {
    double sum = 0;
    for (std::size_t k = 0; k < surface.polygons.size(); ++k) {
        if (inside_only && surface.faces[k].valid()) {
            continue;
        }
        const auto& p = surface.polygons[k];
        for (std::size_t t = 1; t < 3 && p[t + 1] >= 0; ++t) {
            const Vec3 a = place(data, surface, p[0]);
            sum +=
                (place(data, surface, p[t]) - a).cross(place(data, surface, p[t + 1]) - a).norm() /
                2;
        }
    }
    return sum;
}

ClipPlane plane(const Vec3& origin, const Vec3& normal, bool crinkle) {
    ClipPlane clip;
    clip.enabled = true;
    clip.origin = origin;
    clip.normal = normal;
    clip.crinkle = crinkle;
    return clip;
}

} // namespace

class VisibleSurfaceTest : public QObject {
    Q_OBJECT
private slots:
    void is_the_boundary_without_a_plane();
    void leaves_out_hidden_patches();
    void is_cut_at_the_plane_without_crinkle();
    void bounds_the_whole_elements_behind_the_plane_with_crinkle();
    void shows_the_other_side_when_asked();
    void cuts_triangles_and_boundary_in_2d();
    void knows_the_element_behind_each_face();
};

void VisibleSurfaceTest::is_the_boundary_without_a_plane() {
    const auto data = make("cube", {{"n", "3"}});
    SurfaceExtractor extractor(data);
    const VisibleSurface& surface = extractor.extract({}, {});
    QCOMPARE(surface.polygons.size(), data->triangles.size());
    QVERIFY(surface.cut_elements.empty());
    QVERIFY(std::abs(area(*data, surface) - 6) < 1e-12);
}

void VisibleSurfaceTest::leaves_out_hidden_patches() {
    const auto data = make("cube", {{"n", "3"}});
    SurfaceExtractor extractor(data);
    const VisibleSurface& surface = extractor.extract({}, {data->patches.front()});
    QVERIFY(std::abs(area(*data, surface) - 5) < 1e-12);
    for (const FaceId face : surface.faces) {
        QVERIFY(data->triangle_patch[face.index()] != data->patches.front());
    }
}

void VisibleSurfaceTest::is_cut_at_the_plane_without_crinkle() {
    const auto data = make("cube", {{"n", "4"}});
    SurfaceExtractor extractor(data);
    const VisibleSurface& surface = extractor.extract(plane({0.3, 0, 0}, {2, 0, 0}, false), {});
    QVERIFY(std::abs(area(*data, surface, true) - 1) < 1e-9);           // the section
    QVERIFY(std::abs(area(*data, surface) - (1 + 1 + 4 * 0.3)) < 1e-9); // and the box behind it
    for (std::size_t p = 0; p < surface.point_count(); ++p) {
        QVERIFY(place(*data, surface, static_cast<std::int32_t>(p))[0] < 0.3 + 1e-12);
    }
}

void VisibleSurfaceTest::bounds_the_whole_elements_behind_the_plane_with_crinkle() {
    const auto data = make("cube", {{"n", "4"}});
    SurfaceExtractor extractor(data);
    const Vec3 normal = Vec3(1, 0.4, -0.3).normalized();
    const ClipPlane clip = plane({0.5, 0.5, 0.5}, normal, true);
    const VisibleSurface& surface = extractor.extract(clip, {});
    // The elements with a node behind the plane, the facets that one of them has and two do not.
    double volume = 0;
    const Mesh<3>& mesh = *std::get<0>(data->input).mesh;
    std::map<std::array<NodeId, 3>, int> facets;
    for (const auto& s : mesh.elements) {
        const auto behind = [&](NodeId i) {
            return (mesh.points[i] - clip.origin).dot(normal) <= 0;
        };
        if (std::any_of(s.begin(), s.end(), behind)) {
            for (int k = 0; k < 4; ++k) {
                ++facets[sorted(facet_of<3>(s, k))];
            }
            const auto x = corners_of(mesh, s);
            volume += (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) / 6;
        }
    }
    std::set<std::array<NodeId, 3>> shown;
    double flux = 0;
    for (const auto& p : surface.polygons) {
        QCOMPARE(p[3], -1);
        const std::array<NodeId, 3> nodes{surface.nodes[static_cast<std::size_t>(p[0])],
                                          surface.nodes[static_cast<std::size_t>(p[1])],
                                          surface.nodes[static_cast<std::size_t>(p[2])]};
        shown.insert(sorted(nodes));
        flux += mesh.points[nodes[0]].dot(mesh.points[nodes[1]].cross(mesh.points[nodes[2]])) / 6;
    }
    for (const auto& [facet, count] : facets) {
        if (count == 1) {
            QVERIFY(shown.contains(facet)); // all that can be seen is there
        }
    }
    for (const auto& facet : shown) {
        QVERIFY(facets.contains(facet)); // and nothing of what was cut away
    }
    // Facets inside what is shown come in pairs of opposite normals, so the volume is right.
    QVERIFY(std::abs(flux - volume) < 1e-12);
    QVERIFY(!surface.cut_elements.empty());
}

void VisibleSurfaceTest::shows_the_other_side_when_asked() {
    const auto data = make("cube", {{"n", "4"}});
    SurfaceExtractor extractor(data);
    ClipPlane clip = plane({0.3, 0, 0}, {1, 0, 0}, false);
    clip.keep_other_side = true;
    QVERIFY(std::abs(area(*data, extractor.extract(clip, {})) - (1 + 1 + 4 * 0.7)) < 1e-9);
}

void VisibleSurfaceTest::cuts_triangles_and_boundary_in_2d() {
    const auto data = make("cube", {{"n", "4"}, {"dim", "2"}});
    SurfaceExtractor extractor(data);
    const VisibleSurface& whole = extractor.extract({}, {});
    QVERIFY(std::abs(area(*data, whole) - 1) < 1e-12);
    QCOMPARE(whole.lines.size(), data->lines.size());
    const VisibleSurface& cut = extractor.extract(plane({0.3, 0, 0}, {1, 0, 0}, false), {});
    QVERIFY(std::abs(area(*data, cut) - 0.3) < 1e-9);
    double length = 0;
    for (const auto& [a, b] : cut.lines) {
        length += (place(*data, cut, a) - place(*data, cut, b)).norm();
    }
    QVERIFY(std::abs(length - 1.6) < 1e-9);
}

void VisibleSurfaceTest::knows_the_element_behind_each_face() {
    const auto data = make("cube", {{"n", "3"}});
    int bits = 0;
    for (std::size_t t = 0; t < data->triangles.size(); ++t) {
        const auto& s = data->tets[data->triangle_element[t].index()];
        for (const NodeId i : data->triangles[t]) {
            QVERIFY(std::find(s.begin(), s.end(), i) != s.end());
        }
    }
    for (const std::uint8_t mask : data->boundary_facets) {
        bits += std::popcount(mask);
    }
    QCOMPARE(static_cast<std::size_t>(bits), data->triangles.size());
}

QTEST_APPLESS_MAIN(VisibleSurfaceTest)
#include "visible_surface_test.moc"
