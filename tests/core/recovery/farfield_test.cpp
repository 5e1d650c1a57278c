// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/recovery/farfield.h"

#include "core/base/error.h"
#include "core/surface/surface_report.h"
#include "tests/core/surface/surfaces.h"

#include <QtTest>

#include <set>

using namespace ameco;

class FarfieldTest : public QObject {
    Q_OBJECT
private slots:
    void surrounds_the_body_data();
    void surrounds_the_body();
    void a_word_names_it_data();
    void a_word_names_it();
    void must_hold_the_body();
};

void FarfieldTest::surrounds_the_body_data() {
    QTest::addColumn<QString>("word");
    QTest::addColumn<int>("patches");
    QTest::addColumn<double>("volume");
    QTest::newRow("box") << "box:5" << 6 << 1000.0;
    QTest::newRow("sphere") << "sphere:5" << 1 << 4 * std::numbers::pi / 3 * 125;
}

void FarfieldTest::surrounds_the_body() {
    QFETCH(QString, word);
    QFETCH(int, patches);
    QFETCH(double, volume);
    const Mesh<3> mesh =
        make_farfield(farfield_from(word.toStdString()), surfaces::sphere(3, 1, {1, 2, 3}), 7);
    const SurfaceReport report = inspect_surface(mesh);
    QVERIFY(report.sound());
    QVERIFY(std::abs(report.parts[0].volume - volume) < 0.05 * volume); // and > 0: outwards
    QVERIFY(((report.low + report.high) / 2 - Vec<3>(1, 2, 3)).norm() < 1e-12);
    const std::set<int> ids(mesh.patch.begin(), mesh.patch.end());
    QCOMPARE(ids.size(), std::size_t(patches));
    QCOMPARE(*ids.begin(), 7);
    QCOMPARE(mesh.patch_names.size(), std::size_t(patches));
    for (const FaceId f : mesh.faces.ids()) { // patches of the box are named by side
        const std::string& name = mesh.patch_names.at(mesh.patch[f]);
        if (name == "farfield-y1") {
            QVERIFY(mesh.points[mesh.faces[f][0]][1] > 6.9);
        }
    }
}

void FarfieldTest::a_word_names_it_data() {
    QTest::addColumn<QString>("word");
    QTest::addColumn<bool>("good");
    for (const char* good : {"box", "sphere", "box:1", "sphere:2.5e3"}) {
        QTest::newRow(good) << good << true;
    }
    for (const char* bad :
         {"", "cube", "box:", "box:0", "sphere:-1", "sphere:x", "sphere:1x", "sphere:inf"}) {
        QTest::newRow(bad) << bad << false;
    }
}

void FarfieldTest::a_word_names_it() {
    QFETCH(QString, word);
    QFETCH(bool, good);
    try {
        const Farfield farfield = farfield_from(word.toStdString());
        QVERIFY(good);
        QCOMPARE(farfield.shape == FarfieldShape::box, word.startsWith("box"));
    } catch (const UsageError& error) {
        QVERIFY2(!good, error.what());
    }
}

void FarfieldTest::must_hold_the_body() {
    const Mesh<3> body = surfaces::cube(1); // corners are 0.87 from its middle
    QVERIFY_THROWS_EXCEPTION(UsageError, (void)make_farfield(farfield_from("sphere:0.8"), body, 1));
    QVERIFY_THROWS_EXCEPTION(UsageError, (void)make_farfield(farfield_from("box:0.5"), body, 1));
    QVERIFY(!make_farfield(farfield_from("box:0.51"), body, 1).faces.empty());
}

QTEST_APPLESS_MAIN(FarfieldTest)
#include "farfield_test.moc"
