// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/session.h"

#include "core/base/error.h"

#include <QtTest>

using namespace ameco;
using namespace ameco::gui;

class SessionTest : public QObject {
    Q_OBJECT
private slots:
    void comes_back_as_it_was_written();
    void moves_with_its_folder();
    void says_what_is_wrong_data();
    void says_what_is_wrong();
};

namespace {

Session unusual() {
    Session s;
    s.mesh = "/meshes/wing.meshb";
    HierarchyOptions options;
    options.coarsen.mean = Mean::geodesic;
    options.coarsen.target.factor = 1.0 / 3 + 2;
    options.coarsen.features.frozen_patches = {3, 5};
    s.levels = {{1, 0, 1, "/meshes/wing.levels/1", options}};
    s.current = 1;
    s.shown = {0, 1};
    s.camera = {{1, 2, 3}, {0, 1, 0}, {0, 0, 1}, 1e-7};
    s.scene.representation = Representation::wireframe;
    s.scene.colour = ColourBy::aspect_ratio;
    s.scene.clip = {true, {0.1, 0.2, 0.3}, {0, 1, 0}, false, true};
    s.scene.view_scale = {1, 1e5, 1};
    s.scene.lens = {true, {1, 1, 1}, {0, 0, -1}, 1000};
    s.scene.ellipsoids.where = EllipsoidOptions::Where::clip_plane;
    s.scene.ellipsoids.source = EllipsoidSource::target;
    s.scene.ellipsoids.mean = Mean::log_euclidean;
    s.scene.ellipsoids.max_count = 17;
    s.scene.ellipsoids.compress = 0.3;
    s.scene.hidden_patches = {2};
    s.scene.range = {1e-9, 1};
    s.scene.dark = true;
    s.scene.legend = false;
    s.options = options;
    s.threads = 2;
    s.percent = true;
    return s;
}

} // namespace

void SessionTest::comes_back_as_it_was_written() {
    const Session a = unusual();
    const Session b = parse_session(session_text(a, "/meshes"), "/meshes/x.ameco");
    QCOMPARE(b.mesh, a.mesh);
    QVERIFY(b.scene == a.scene);
    QVERIFY(b.camera == a.camera);
    QCOMPARE(b.levels[0].folder, a.levels[0].folder);
    // Written again it is the same text: nothing else was lost.
    QCOMPARE(session_text(b, "/meshes"), session_text(a, "/meshes"));
}

void SessionTest::moves_with_its_folder() {
    const Session moved = parse_session(session_text(unusual(), "/meshes"), "/moved/here/x.ameco");
    QCOMPARE(moved.mesh, std::string("/moved/here/wing.meshb"));
    QCOMPARE(moved.levels[0].folder, std::string("/moved/here/wing.levels/1"));
}

void SessionTest::says_what_is_wrong_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::newRow("no JSON") << "{"
                             << "";
    QTest::newRow("another version") << "\"schema_version\": 1"
                                     << "\"schema_version\": 99";
    QTest::newRow("another file") << "ameco session"
                                  << "ameco hierarchy";
    QTest::newRow("lacks something") << "\"camera\""
                                     << "\"cam\"";
    QTest::newRow("unknown colour") << "aspect-ratio"
                                    << "beauty";
    QTest::newRow("unknown mean") << "log-euclidean"
                                  << "harmonic";
    QTest::newRow("setting out of range") << "\"levels\": \"4\""
                                          << "\"levels\": \"0\"";
}

void SessionTest::says_what_is_wrong() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QString text = QString::fromStdString(session_text(unusual(), "/meshes"));
    QVERIFY(text.contains(from));
    text.replace(from, to);
    try {
        (void)parse_session(text.toStdString(), "x.ameco");
        QFAIL("it was accepted");
    } catch (const InputError& error) {
        QVERIFY2(QString(error.what()).startsWith("x.ameco: "), error.what());
    }
}

QTEST_APPLESS_MAIN(SessionTest)
#include "session_test.moc"
