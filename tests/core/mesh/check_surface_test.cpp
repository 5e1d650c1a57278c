// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/check_surface.h"
#include "tests/support/shapes.h"

#include <QtTest>

using namespace ameco;

class CheckSurfaceTest : public QObject {
    Q_OBJECT
private slots:
    void accepts_the_boundary_of_a_mesh();
    void names_what_is_wrong_data();
    void names_what_is_wrong();
    void has_a_finding_for_an_unusable_surface();
};

namespace {

Mesh<3> boundary_of_cube() {
    Mesh<3> mesh = shapes::cube(3);
    mesh.elements.clear();
    mesh.region.clear();
    return mesh;
}

} // namespace

void CheckSurfaceTest::accepts_the_boundary_of_a_mesh() {
    const CheckReport report = check_surface(boundary_of_cube());
    QVERIFY2(report.valid(), report.summary().c_str());
    QVERIFY(std::abs(report.volume - 1) < 1e-14);
}

void CheckSurfaceTest::names_what_is_wrong_data() {
    QTest::addColumn<QString>("damage");
    QTest::addColumn<int>("defect");
    QTest::addColumn<int>("count");
    QTest::newRow("hole") << "hole" << int(Defect::boundary_not_closed) << 3;
    QTest::newRow("face turned") << "turned" << int(Defect::face_turned_inward) << 3;
    QTest::newRow("all turned") << "all turned" << int(Defect::face_turned_inward) << 1;
    QTest::newRow("face twice") << "twice" << int(Defect::duplicate_face) << 1;
    QTest::newRow("fin") << "fin" << int(Defect::boundary_not_manifold) << 1;
}

void CheckSurfaceTest::names_what_is_wrong() {
    QFETCH(QString, damage);
    QFETCH(int, defect);
    QFETCH(int, count);
    Mesh<3> mesh = boundary_of_cube();
    Facet<3>& face = mesh.faces[FaceId(4)];
    if (damage == "hole") {
        mesh.faces.raw().erase(mesh.faces.raw().begin() + 4);
        mesh.patch.raw().pop_back();
    } else if (damage == "turned") {
        std::swap(face[0], face[1]);
    } else if (damage == "all turned") {
        for (Facet<3>& f : mesh.faces) {
            std::swap(f[0], f[1]);
        }
    } else if (damage == "twice") {
        mesh.faces.push_back({face[1], face[2], face[0]});
        mesh.patch.push_back(1);
    } else {
        mesh.points.push_back({2, 2, 2});
        mesh.faces.push_back({face[0], face[1], NodeId(mesh.points.size() - 1)});
        mesh.patch.push_back(1);
    }
    const CheckReport report = check_surface(mesh);
    const auto found = std::find_if(report.errors.begin(), report.errors.end(), [&](const auto& f) {
        return f.defect == static_cast<Defect>(defect);
    });
    QVERIFY2(found != report.errors.end(), report.summary().c_str());
    QCOMPARE(found->count, std::int64_t{count});
}

void CheckSurfaceTest::has_a_finding_for_an_unusable_surface() {
    Mesh<3> mesh = boundary_of_cube();
    mesh.faces[FaceId(0)][1] = NodeId(1000);
    QVERIFY(!check_surface(mesh).valid());
    QVERIFY(!check_surface(Mesh<3>()).valid());
}

QTEST_APPLESS_MAIN(CheckSurfaceTest)
#include "check_surface_test.moc"
