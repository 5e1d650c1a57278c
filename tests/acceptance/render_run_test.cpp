// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/acceptance/run_ameco.h"
#include "tests/support/picture.h"

#include <QImage>
#include <QRegularExpression>

using namespace ameco::test;

/// `ameco render` with no display to be had.
class RenderRunTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void makes_a_picture_without_a_screen();
    void makes_the_same_picture_on_any_number_of_threads();
    void shows_levels_beside_each_other();
    void shows_where_nodes_go();
    void marks_scaled_views();
    void is_transparent_when_asked();
    void explains_what_is_wrong_data();
    void explains_what_is_wrong();
    void leaves_nothing_behind_without_opengl();
    void leaves_nothing_behind_without_the_renderer();
    void needs_no_window_system_until_then();

private:
    [[nodiscard]] Run render(const QStringList& arguments) const {
        return here_.ameco(QStringList{"render"} + arguments);
    }
    [[nodiscard]] QImage picture(const QString& name) const { return QImage(here_.path(name)); }

    Workspace here_;
};

void RenderRunTest::initTestCase() {
    qunsetenv("DISPLAY");
    qunsetenv("WAYLAND_DISPLAY");
    QCOMPARE(here_.ameco({"case", "box", "-o", "box.meshb"}).code, 0);
    QCOMPARE(here_.ameco({"case", "onera-m6", "--preset", "m6-8k", "-o", "wing.meshb"}).code, 0);
    QCOMPARE(here_.ameco({"coarsen", "wing.meshb", "-o", "levels", "--levels", "2", "-q"}).code, 0);
}

void RenderRunTest::makes_a_picture_without_a_screen() {
    const Run run =
        render({"wing.meshb", "-o", "wing.png", "--size", "640x400", "--as", "surface"});
    QVERIFY2(run.code == 0, run.text());
    QVERIFY2(run.out.startsWith("wing.png: 640 x 400, "), run.text());
    const QImage image = picture("wing.png");
    QCOMPARE(image.size(), QSize(640, 400));
    QVERIFY(share_not_background(image) > 0.3);
    const auto is_blue = [](const QColor& c) { // the wing's patch
        return c.hue() > 195 && c.hue() < 225 && c.saturation() > 60;
    };
    QVERIFY(share_of_pixels(image, is_blue) > 0.1);
}

void RenderRunTest::makes_the_same_picture_on_any_number_of_threads() {
    const QStringList what{"wing.meshb",    "--size", "320x200",     "--clip", "0,0.5,0",
                           "--clip-normal", "0,1,0",  "--colour-by", "quality"};
    QCOMPARE(render(what + QStringList{"-o", "a.png", "--threads", "1"}).code, 0);
    QCOMPARE(render(what + QStringList{"-o", "b.png", "--threads", "4"}).code, 0);
    QCOMPARE(here_.content("a.png"), here_.content("b.png"));
}

void RenderRunTest::shows_levels_beside_each_other() {
    const Run run = render({"levels", "--levels", "0,2", "-o", "two.png", "--size", "800x300",
                            "--colour-by", "aspect-ratio", "--json", "--no-axes"});
    QVERIFY2(run.code == 0, run.text());
    QVERIFY(run.json().at("range").at(1).get<double>() > 100);
    const QImage image = picture("two.png");
    // The coarse half has fewer edges: more of its pixels look like their neighbour.
    const auto calm = [&](int left) {
        int count = 0;
        for (int y = 30; y < 300; ++y) {
            for (int x = left; x < left + 320; ++x) {
                count += near_colour(image.pixelColor(x, y), image.pixelColor(x + 1, y), 6) ? 1 : 0;
            }
        }
        return count;
    };
    QVERIFY2(calm(360) > 1.1 * calm(20), qPrintable(QString("%1 %2").arg(calm(20)).arg(calm(360))));
}

void RenderRunTest::shows_where_nodes_go() {
    const Run run = render({"levels", "-o", "gone.png", "--size", "800x600", "--colour-by",
                            "removed-at", "--view", "y+", "--focus", "0,0,0", "--height", "0.3"});
    QVERIFY2(run.code == 0, run.text());
    const QImage image = picture("gone.png");
    const auto orange = [](const QColor& c) { return near_colour(c, QColor(240, 160, 84), 12); };
    QVERIFY(share_of_pixels(image, orange) > 1e-3); // nodes that are missing on level 2 first
    const Run mesh = render({"wing.meshb", "-o", "x.png", "--colour-by", "removed-at"});
    QCOMPARE(mesh.code, 2);
}

void RenderRunTest::marks_scaled_views() {
    const Run run = render(
        {"box.meshb", "-o", "box.png", "--size", "400x300", "--scale", "1,1,1000", "--json"});
    QVERIFY2(run.code == 0, run.text());
    QVERIFY(run.json().at("view_scaled").get<std::string>().starts_with("VIEW SCALED"));
    const auto amber = [](const QColor& c) { return near_colour(c, QColor(255, 193, 37), 4); };
    QVERIFY(share_of_pixels(picture("box.png"), amber) > 0.01);
    QCOMPARE(render({"box.meshb", "-o", "flat.png", "--size", "400x300"}).code, 0);
    QVERIFY(share_of_pixels(picture("flat.png"), amber) < 1e-4);
    const Run lens = render({"box.meshb", "-o", "lens.png", "--size", "400x300", "--lens", "500",
                             "--node", "4", "--zoom", "0.3"});
    QVERIFY2(lens.code == 0 && lens.out.contains("wall normal"), lens.text());
}

void RenderRunTest::is_transparent_when_asked() {
    QCOMPARE(render({"box.meshb", "-o", "t.png", "--size", "200x200", "--transparent"}).code, 0);
    QCOMPARE(picture("t.png").pixelColor(0, 0).alpha(), 0);
}

void RenderRunTest::explains_what_is_wrong_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("complaint");
    const auto row = [](const char* what, const QStringList& arguments, int code,
                        const char* complaint) {
        QTest::newRow(what) << arguments << code << complaint;
    };
    row("suffix", {"box.meshb", "-o", "x.jpg"}, 2, "must end in .png");
    row("colour", {"box.meshb", "-o", "x.png", "--colour-by", "h4"}, 2, "h4 is not");
    row("size", {"box.meshb", "-o", "x.png", "--size", "800"}, 2, "800 is not a size");
    row("place", {"box.meshb", "-o", "x.png", "--clip", "1,2"}, 2, "three numbers");
    row("direction", {"box.meshb", "-o", "x.png", "--up", "0,0,0"}, 2, "not a direction");
    row("scale", {"box.meshb", "-o", "x.png", "--scale", "1,1,1e7"}, 2, "from 1 to 1e6");
    row("range", {"box.meshb", "-o", "x.png", "--range", "5,1"}, 2, "smaller");
    row("patch", {"box.meshb", "-o", "x.png", "--hide", "botom"}, 2, "did you mean bottom?");
    row("node", {"box.meshb", "-o", "x.png", "--node", "27"}, 2, "has 27 nodes");
    row("lens nowhere", {"box.meshb", "-o", "x.png", "--lens", "9"}, 2, "say where");
    row("level", {"levels", "-o", "x.png", "--levels", "7"}, 2, "has the levels 0 to 2");
    row("panels",
        {"levels", "levels", "levels", "-o", "x.png", "--mean", "corrected,blended,geodesic"}, 2,
        "at most 8 panels");
    row("no mesh", {"absent.meshb", "-o", "x.png"}, 4, "absent.meshb");
    row("no folder", {"box.meshb", "-o", "absent/x.png"}, 4, "absent");
}

void RenderRunTest::explains_what_is_wrong() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, complaint);
    const Run run = render(arguments);
    QVERIFY2(run.code == code && run.err.contains(complaint), run.text());
    QCOMPARE(run.err.count("ameco: "), 1);
    QVERIFY(!QFile::exists(here_.path("x.png")));
}

void RenderRunTest::leaves_nothing_behind_without_opengl() {
    // Mesa told to offer no OpenGL that the renderer could use.
    const Run run =
        here_.shell("MESA_GL_VERSION_OVERRIDE=2.1 __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null "
                    "\"$AMECO\" render box.meshb -o x.png");
    QCOMPARE(run.code, 8);
    QVERIFY2(run.err.count('\n') == 1 && run.err.contains("OpenGL"), run.text());
    QVERIFY(!QFile::exists(here_.path("x.png")));
    QVERIFY(here_.files(".").filter("tmp").isEmpty());
}

void RenderRunTest::leaves_nothing_behind_without_the_renderer() {
    // The program alone, as on a machine without VTK.
    QVERIFY(QFile::copy(AMECO_PROGRAM, here_.path("ameco-alone")));
    const Run run = here_.shell("./ameco-alone render box.meshb -o x.png");
    QCOMPARE(run.code, 8);
    QVERIFY2(run.err.count('\n') == 1 && run.err.contains("libameco_render.so is missing"),
             run.text());
    QVERIFY(!QFile::exists(here_.path("x.png")));
    QCOMPARE(here_.shell("./ameco-alone info box.meshb").code, 0);
}

void RenderRunTest::needs_no_window_system_until_then() {
    const Run run = here_.shell("ldd \"$AMECO\"");
    QCOMPARE(run.code, 0);
    for (const QString& line : run.out.split('\n')) {
        const QRegularExpression window("libQt6(Gui|Widgets|OpenGL)|libGLX?\\.|libOpenGL|libEGL|"
                                        "libvtkRendering|libX11|libxcb");
        QVERIFY2(!window.match(line).hasMatch(), qPrintable(line));
    }
}

QTEST_GUILESS_MAIN(RenderRunTest)
#include "render_run_test.moc"
