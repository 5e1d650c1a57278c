// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/nodal_metric.h"
#include "gui/scene/metric_glyphs.h"
#include "tests/gui/scene/scene_support.h"

#include <QTest>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

using namespace ameco;
using namespace ameco::gui;
using namespace ameco::gui::test;

namespace {

EllipsoidOptions at_sample(std::size_t count) {
    EllipsoidOptions options;
    options.where = EllipsoidOptions::Where::sample;
    options.max_count = count;
    return options;
}

bool is_ball(const QColor& c) { // orange, lit
    return c.hue() > 15 && c.hue() < 35 && c.saturation() > 120;
}

} // namespace

class MetricGlyphsTest : public QObject {
    Q_OBJECT
private slots:
    void have_the_sizes_and_directions_of_the_metric_data();
    void have_the_sizes_and_directions_of_the_metric();
    void are_coarsened_and_compressed_when_asked();
    void are_at_most_so_many();
    void stand_at_the_clip_plane();
    void lie_along_the_long_direction_in_the_picture();
    void are_lit_from_the_eye();
};

void MetricGlyphsTest::have_the_sizes_and_directions_of_the_metric_data() {
    QTest::addColumn<int>("mean");
    for (const Mean mean : {Mean::corrected, Mean::blended, Mean::interpolation,
                            Mean::log_euclidean, Mean::geodesic}) {
        QTest::newRow(std::string(name(mean)).c_str()) << static_cast<int>(mean);
    }
}

void MetricGlyphsTest::have_the_sizes_and_directions_of_the_metric() {
    QFETCH(int, mean);
    const auto data = make_level("layer", {{"nx", "4"}, {"ny", "4"}, {"nz", "6"}});
    const Mesh<3>& mesh = *std::get<0>(data->input).mesh;
    const auto field = nodal_metric(mesh, static_cast<Mean>(mean));
    EllipsoidOptions options;
    options.mean = static_cast<Mean>(mean);
    options.scale = 0.5;
    const std::vector<NodeId> nodes{NodeId(3), NodeId(40), NodeId(71)};
    const auto balls = make_ellipsoids(*data, nodes, options);
    QCOMPARE(balls.size(), nodes.size());
    for (const Ellipsoid& ball : balls) {
        const Metric<3>& metric = field[ball.node];
        for (int k = 0; k < 3; ++k) {
            QVERIFY(std::abs(ball.axes.col(k).norm() / (0.5 * metric.sizes[k]) - 1) < 1e-9);
            QVERIFY(ball.axes.col(k).normalized().cross(metric.directions.col(k)).norm() < 1e-6);
        }
    }
    // Points of the drawn ball have length `scale` in the metric, on the far side of 1e4 as well.
    const GlyphMesh drawn = glyph_mesh(*data, balls, make_view_transform({}, Vec3::Zero()));
    const std::size_t per_ball = drawn.points.size() / balls.size();
    for (std::size_t p = 0; p < drawn.points.size(); ++p) {
        const NodeId node = balls[p / per_ball].node;
        const double l = length<3>(field[node], drawn.points[p] - mesh.points[node]);
        QVERIFY2(std::abs(l - 0.5) < 1e-3, std::to_string(l).c_str());
    }
}

void MetricGlyphsTest::are_coarsened_and_compressed_when_asked() {
    const auto data = make_level("layer", {{"nx", "4"}, {"ny", "4"}, {"nz", "6"}});
    EllipsoidOptions options;
    const std::vector<NodeId> nodes{NodeId(30)};
    const Mat<3> natural = make_ellipsoids(*data, nodes, options).front().axes;
    options.source = EllipsoidSource::target;
    const Mat<3> target = make_ellipsoids(*data, nodes, options).front().axes;
    QVERIFY(std::abs(target.col(0).norm() / natural.col(0).norm() - 2) < 1e-9);
    QVERIFY(std::abs(target.col(2).norm() / natural.col(2).norm() - 1) < 1e-9);
    options.source = EllipsoidSource::natural;
    options.compress = 0.5;
    const Mat<3> compressed = make_ellipsoids(*data, nodes, options).front().axes;
    const double ratio = natural.col(2).norm() / natural.col(0).norm();
    QVERIFY(ratio > 1000);
    QVERIFY(std::abs(compressed.col(2).norm() / compressed.col(0).norm() / std::sqrt(ratio) - 1) <
            1e-9);
    QVERIFY(std::abs(compressed.col(2).norm() / natural.col(2).norm() - 1) < 1e-9);
}

void MetricGlyphsTest::are_at_most_so_many() {
    const auto data = make_level("cube", {{"n", "8"}});
    SurfaceExtractor extractor(data);
    const VisibleSurface& surface = extractor.extract({}, {});
    QCOMPARE(ellipsoid_nodes(*data, surface, {}, at_sample(50), {}).size(), std::size_t(50));
    QCOMPARE(ellipsoid_nodes(*data, surface, {}, at_sample(100'000), {}).size(),
             surface.nodes.size());
    const auto big = make_level("cube", {{"n", "20"}});
    SurfaceExtractor big_extractor(big);
    QCOMPARE(
        ellipsoid_nodes(*big, big_extractor.extract({}, {}), {}, at_sample(100'000), {}).size(),
        std::size_t(2000));
    EllipsoidOptions picked;
    picked.where = EllipsoidOptions::Where::picked;
    QVERIFY(ellipsoid_nodes(*data, surface, {}, picked, {}).empty());
    QVERIFY(ellipsoid_nodes(*data, surface, {}, picked, NodeId(999999)).empty());
    QCOMPARE(ellipsoid_nodes(*data, surface, {}, picked, NodeId(5)),
             std::vector<NodeId>{NodeId(5)});
}

void MetricGlyphsTest::stand_at_the_clip_plane() {
    const auto data = make_level("cube", {{"n", "10"}});
    SurfaceExtractor extractor(data);
    ClipPlane clip{true, {0.5, 0, 0}, {1, 0, 0}, true, false};
    EllipsoidOptions options;
    options.where = EllipsoidOptions::Where::clip_plane;
    const auto nodes = ellipsoid_nodes(*data, extractor.extract(clip, {}), clip, options, {});
    QVERIFY(nodes.size() > 100);
    for (const NodeId i : nodes) {
        QVERIFY(std::abs(data->position(i)[0] - 0.5) < 0.2);
    }
}

void MetricGlyphsTest::lie_along_the_long_direction_in_the_picture() {
    // A layer bent to a quarter of a circle: at its far end the long direction is no axis.
    const auto data = make_level(
        "layer",
        {{"nx", "8"}, {"ny", "8"}, {"nz", "6"}, {"aspect-ratio", "20"}, {"curvature", "1"}});
    Studio studio(data);
    studio.bare();
    // The node nearest to 45 degrees round, half-way up.
    const auto& field = *std::get<0>(data->input).natural;
    NodeId node;
    double best = 1e300;
    for (const NodeId i : field.ids()) {
        const Vec3 d = field[i].directions.col(0);
        const double off = std::abs(std::abs(d[0]) - std::abs(d[2])) + std::abs(d[1]);
        if (off < best) {
            best = off;
            node = i;
        }
    }
    SceneOptions options = studio.scene.options();
    options.ellipsoids.where = EllipsoidOptions::Where::picked;
    options.ellipsoids.mean = Mean::blended;
    options.representation = Representation::wireframe;
    options.colour = ColourBy::none;
    studio.scene.set_options(options);
    studio.scene.standard_view(StandardView::minus_y);
    Camera camera = studio.scene.camera();
    camera.focus = data->position(node);
    camera.height = 1.5 * field[node].sizes[2];
    studio.scene.set_camera(camera);
    studio.scene.mark(node);
    const QImage image = studio.picture();
    QCOMPARE(studio.scene.shown_ellipsoids(), std::size_t(1));
    // Second moments of the ball's pixels against the short direction as it is seen.
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (is_ball(image.pixelColor(x, y))) {
                const Eigen::Vector2d p(x - image.width() / 2.0, image.height() / 2.0 - y);
                moments += p * p.transpose();
                ++count;
            }
        }
    }
    QVERIFY2(count > 300, std::to_string(count).c_str());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(moments);
    const Eigen::Vector2d seen_short = solver.eigenvectors().col(0);
    const Vec3 h1 = field[node].directions.col(0);
    const Eigen::Vector2d expected = Eigen::Vector2d(h1[0], h1[2]).normalized();
    QVERIFY2(std::abs(seen_short.dot(expected)) > 0.98,
             std::to_string(seen_short.dot(expected)).c_str());
    QVERIFY(solver.eigenvalues()[1] > 9 * solver.eigenvalues()[0]); // stretched over 3
}

void MetricGlyphsTest::are_lit_from_the_eye() {
    const auto data = make_level("cube", {{"n", "2"}, {"displace", "0"}});
    Studio studio(data);
    studio.bare();
    NodeId corner;
    for (std::size_t i = 0; i < data->node_count; ++i) {
        if (data->position(NodeId(i)).norm() < 1e-12) {
            corner = NodeId(i);
        }
    }
    SceneOptions options = studio.scene.options();
    options.ellipsoids.where = EllipsoidOptions::Where::picked;
    options.ellipsoids.compress = 0.05; // as good as a ball
    studio.scene.set_options(options);
    studio.scene.mark(corner);
    Camera camera;
    camera.sight = {1, 1, 1};
    camera.height = 1.5;
    studio.scene.set_camera(camera);
    const QImage image = studio.picture();
    // From the middle to the rim it gets darker; the mark's ring is left out.
    const int middle = image.pixelColor(240, 180).lightness();
    int rim = 0;
    for (int x = 256; x < image.width() && is_ball(image.pixelColor(x, 180)); ++x) {
        rim = image.pixelColor(x, 180).lightness();
    }
    QVERIFY2(middle > rim + 20 && rim > 0,
             (std::to_string(middle) + " " + std::to_string(rim)).c_str());
}

QTEST_GUILESS_MAIN(MetricGlyphsTest)
#include "metric_glyphs_test.moc"
