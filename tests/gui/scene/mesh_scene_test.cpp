// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/colour_map.h"
#include "gui/scene/scene_values.h"
#include "tests/gui/scene/scene_support.h"

#include <QTest>

#include <cmath>

using namespace ameco;
using namespace ameco::gui;
using namespace ameco::gui::test;
using ameco::test::near_colour;
using ameco::test::share_not_background;
using ameco::test::share_of_pixels;

namespace {

/// Whether two colours have the same hue, lit differently.
bool same_hue(const QColor& a, const Rgb& b, int tolerance) {
    const QColor other(b[0], b[1], b[2]);
    const int difference = std::abs(a.hue() - other.hue());
    return std::min(difference, 360 - difference) <= tolerance && a.saturation() > 30;
}

double amber_share(const QImage& image) {
    return share_of_pixels(image,
                           [](const QColor& c) { return near_colour(c, QColor(255, 193, 37), 4); });
}

} // namespace

class MeshSceneTest : public QObject {
    Q_OBJECT
private slots:
    void fits_what_is_shown();
    void shows_patches_in_their_colours();
    void looks_at_the_wall_of_an_external_flow();
    void shows_less_of_a_clipped_mesh();
    void hides_patches();
    void says_loudly_that_the_view_is_scaled();
    void keeps_heights_of_1e_9_apart();
    void lens_stretches_along_the_normal_only();
    void zooms_at_the_mouse();
    void picks_the_node_that_is_seen_there_data();
    void picks_the_node_that_is_seen_there();
    void picks_nothing_beside_the_mesh();
    void lights_up_nodes();
    void moves_the_clip_plane_with_its_handle();
    void leaves_room_for_the_legend();
    void is_transparent_when_asked();
    void is_light_and_dark();
    void shows_2d_meshes();
    void shows_where_nodes_go();
    void locks_the_range_of_the_colours();
    void does_without_a_metric();
};

void MeshSceneTest::fits_what_is_shown() {
    Studio studio(make_level("cube", {{"n", "3"}}));
    studio.bare();
    for (const StandardView view : all_standard_views) {
        studio.scene.standard_view(view);
        const QImage image = studio.picture();
        const double share = share_not_background(image);
        QVERIFY2(share > 0.25 && share < 0.8, std::to_string(share).c_str());
        for (int x = 0; x < image.width(); ++x) { // nothing is cut off
            QVERIFY(near_colour(image.pixelColor(x, 0), Qt::white, 2));
            QVERIFY(near_colour(image.pixelColor(x, image.height() - 1), Qt::white, 2));
        }
    }
}

void MeshSceneTest::shows_patches_in_their_colours() {
    const auto data = make_level("box");
    Studio studio(data);
    studio.bare();
    SceneOptions options = studio.scene.options();
    options.view_scale = {1, 1, 1000};
    studio.scene.set_options(options);
    studio.scene.standard_view(StandardView::plus_z);
    const QImage image = studio.picture();
    const auto pick = studio.scene.pick(240, 180);
    QVERIFY(pick.has_value());
    QVERIFY(pick->face.valid());
    QCOMPARE(data->patch_name(pick->patch), std::string("top"));
    QVERIFY(same_hue(colour_at(image, {240, 180}), patch_colour(*data, pick->patch), 6));
}

void MeshSceneTest::looks_at_the_wall_of_an_external_flow() {
    const auto data = make_level("onera-m6", {{"preset", "m6-8k"}});
    QCOMPARE(data->outer.size(), std::size_t(2)); // symmetry plane and far field
    Studio studio(data, 600, 400);
    studio.bare();
    QCOMPARE(studio.scene.options().hidden_patches, (std::set<int>{3}));
    studio.scene.reset_camera();
    const QImage image = studio.picture();
    const Rgb wing = patch_colour(*data, 1);
    const double share =
        share_of_pixels(image, [&](const QColor& c) { return same_hue(c, wing, 12); });
    QVERIFY2(share > 0.15, std::to_string(share).c_str());
}

void MeshSceneTest::shows_less_of_a_clipped_mesh() {
    Studio studio(make_level("cube", {{"n", "6"}}));
    studio.bare();
    studio.scene.standard_view(StandardView::minus_y);
    const double whole = share_not_background(studio.picture());
    SceneOptions options = studio.scene.options();
    options.clip = {true, {0.5, 0, 0}, {1, 0, 0}, false, false};
    studio.scene.set_options(options);
    const double half = share_not_background(studio.picture());
    QVERIFY2(std::abs(half - whole / 2) < 0.02 * whole, std::to_string(half / whole).c_str());
    options.clip.crinkle = true;
    studio.scene.set_options(options);
    const double crinkled = share_not_background(studio.picture());
    QVERIFY(crinkled > half * 1.02 && crinkled < 0.75 * whole);
    // From the open side, what the plane lays open has the colour of the inside.
    studio.scene.standard_view(StandardView::plus_x);
    const double inside = share_of_pixels(studio.picture(), [](const QColor& c) {
        return same_hue(c, inside_colour, 12) || near_colour(c, QColor(233, 226, 208), 40);
    });
    QVERIFY2(inside > 0.2, std::to_string(inside).c_str());
}

void MeshSceneTest::hides_patches() {
    const auto data = make_level("cube", {{"n", "3"}});
    Studio studio(data);
    studio.bare();
    studio.scene.standard_view(StandardView::plus_z);
    studio.picture();
    const auto pick = studio.scene.pick(240, 180);
    SceneOptions options = studio.scene.options();
    options.hidden_patches = {pick->patch};
    studio.scene.set_options(options);
    studio.picture();
    const auto behind = studio.scene.pick(240, 180);
    QVERIFY(behind.has_value());
    QVERIFY(behind->patch != pick->patch);
    QVERIFY(behind->position[2] < 1e-9);
}

void MeshSceneTest::says_loudly_that_the_view_is_scaled() {
    Studio studio(make_level("box"));
    QCOMPARE(studio.scene.scale_label(), std::string());
    QVERIFY(amber_share(studio.picture()) < 1e-4);
    SceneOptions options = studio.scene.options();
    options.view_scale = {1, 1, 1000};
    studio.scene.set_options(options);
    studio.scene.reset_camera();
    const QImage image = studio.picture();
    QVERIFY(amber_share(image) > 0.01);
    QVERIFY(studio.scene.scale_label().starts_with("VIEW SCALED"));
    QVERIFY(studio.scene.scale_label().find("1000") != std::string::npos);
    QVERIFY(share_not_background(image) > 0.2); // and the flat box is a cube now
}

void MeshSceneTest::keeps_heights_of_1e_9_apart() {
    // Layers at coordinates of 1: single precision alone would make one plane of them.
    const auto data = make_level(
        "layer",
        {{"nx", "4"}, {"ny", "4"}, {"nz", "8"}, {"aspect-ratio", "2.5e8"}, {"growth", "1"}});
    const double height = (data->high - data->low)[2];
    QVERIFY(height < 1e-8);
    Studio studio(data);
    studio.bare();
    SceneOptions options = studio.scene.options();
    options.representation = Representation::surface_with_edges;
    options.colour = ColourBy::none;
    studio.scene.set_options(options);
    studio.scene.standard_view(StandardView::minus_y);
    Camera camera = studio.scene.camera();
    camera.focus = {0.9, 0, height / 2};
    camera.height = 1.5 * height;
    studio.scene.set_camera(camera);
    const QImage image = studio.picture();
    // Down a column of pixels the edges of the 8 layers are crossed at even distances.
    std::vector<int> rows;
    for (int y = 1; y < image.height(); ++y) {
        if (image.pixelColor(60, y).lightness() + 25 < image.pixelColor(60, y - 1).lightness()) {
            rows.push_back(y);
        }
    }
    QVERIFY2(rows.size() >= 7, std::to_string(rows.size()).c_str());
    const double step = image.height() / 1.5 / 8;
    for (std::size_t k = 1; k < rows.size(); ++k) {
        QVERIFY(rows[k] - rows[k - 1] < 1.4 * step);
    }
}

void MeshSceneTest::lens_stretches_along_the_normal_only() {
    Studio studio(make_level("box"));
    SceneOptions options = studio.scene.options();
    options.lens = {true, {0, 0, 0}, {0, 0, 3}, 100};
    studio.scene.set_options(options);
    studio.scene.standard_view(StandardView::minus_y);
    studio.picture();
    const auto [x0, y0] = studio.scene.pixel_of({0, 0, 0});
    const auto [x1, y1] = studio.scene.pixel_of({1, 0, 0});
    const auto [x2, y2] = studio.scene.pixel_of({0, 0, 0.002});
    QVERIFY(std::abs(y1 - y0) < 1e-6 && std::abs(x2 - x0) < 1e-6);
    QVERIFY(std::abs((y2 - y0) / (x1 - x0) - 0.2) < 1e-9); // 100 x 0.002 over 1
}

void MeshSceneTest::zooms_at_the_mouse() {
    const auto data = make_level("cube", {{"n", "3"}});
    Studio studio(data);
    studio.scene.reset_camera();
    studio.picture();
    const auto pick = studio.scene.pick(150, 200);
    QVERIFY(pick.has_value());
    for (int k = 0; k < 30; ++k) {
        studio.scene.zoom_at(150, 200, 1.5);
    }
    studio.picture();
    const auto [x, y] = studio.scene.pixel_of(pick->position);
    QVERIFY2(std::abs(x - 150) < 0.1 && std::abs(y - 200) < 0.1,
             (std::to_string(x) + " " + std::to_string(y)).c_str());
    const auto again = studio.scene.pick(150, 200);
    QVERIFY(again.has_value() && (again->position - pick->position).norm() < 1e-12);
}

void MeshSceneTest::picks_the_node_that_is_seen_there_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<bool>("clipped");
    QTest::newRow("plain") << 1.0 << false;
    QTest::newRow("scaled") << 40.0 << false;
    QTest::newRow("clipped") << 1.0 << true;
}

void MeshSceneTest::picks_the_node_that_is_seen_there() {
    QFETCH(double, scale);
    QFETCH(bool, clipped);
    const auto data = make_level("cube", {{"n", "5"}});
    Studio studio(data);
    SceneOptions options = studio.scene.options();
    options.view_scale = {1, 1, scale};
    options.clip = {clipped, {0.5, 0.5, 0.5}, {-1, 1, 1}, true, false};
    studio.scene.set_options(options);
    studio.scene.standard_view(StandardView::corner);
    studio.picture();
    // Every node whose own pixel shows it is picked there; none that lies behind something is.
    int picked = 0;
    const Vec3 sight = studio.scene.camera().sight.normalized();
    for (std::size_t i = 0; i < data->node_count; ++i) {
        const Vec3 x = data->position(NodeId(i));
        const auto [px, py] = studio.scene.pixel_of(x);
        const auto pick = studio.scene.pick(px, py);
        if (!pick) {
            continue; // on the outline, or clipped away beside it
        }
        const Vec3 way = options.view_scale.cwiseProduct(pick->position - x);
        QVERIFY((way - way.dot(sight) * sight).norm() < 1e-9 * scale); // on the ray
        if (way.norm() < 1e-9 * scale) {
            QCOMPARE(pick->node, NodeId(i));
            ++picked;
            const auto& s = data->tets[pick->element.index()];
            QVERIFY(std::find(s.begin(), s.end(), pick->node) != s.end());
        } else if (!clipped) {
            QVERIFY(way.dot(sight) < 0); // what hides the node is nearer to the eye
        }
    }
    QVERIFY2(picked > 40, std::to_string(picked).c_str());
}

void MeshSceneTest::picks_nothing_beside_the_mesh() {
    Studio studio(make_level("cube", {{"n", "2"}}));
    studio.picture();
    QVERIFY(!studio.scene.pick(2, 2).has_value());
    studio.scene.set_data(nullptr);
    studio.picture();
    QVERIFY(!studio.scene.pick(240, 180).has_value());
}

void MeshSceneTest::lights_up_nodes() {
    const auto data = make_level("cube", {{"n", "2"}});
    Studio studio(data);
    studio.bare();
    studio.scene.standard_view(StandardView::plus_z);
    studio.picture();
    const auto pick = studio.scene.pick(240, 180);
    const auto pixel = studio.scene.pixel_of(data->position(pick->node));
    const auto is_lit = [](const QColor& c) { return near_colour(c, QColor(235, 20, 120), 60); };
    QVERIFY(!is_lit(colour_at(studio.picture(), pixel)));
    studio.scene.highlight({pick->node, NodeId(99999999), NodeId()});
    QVERIFY(is_lit(colour_at(studio.picture(), pixel)));
    studio.scene.highlight({});
    QVERIFY(!is_lit(colour_at(studio.picture(), pixel)));
}

void MeshSceneTest::moves_the_clip_plane_with_its_handle() {
    Studio studio(make_level("cube", {{"n", "4"}}));
    SceneOptions options = studio.scene.options();
    options.clip = {true, {0.5, 0.5, 0.5}, {1, 0, 0}, true, false};
    studio.scene.set_options(options);
    studio.scene.standard_view(StandardView::minus_y);
    studio.picture();
    const auto [x, y] = studio.scene.pixel_of({0.5, 0.5, 0.5});
    QVERIFY(!studio.scene.clip_handle_at(x + 30, y).has_value()); // not shown, not there
    studio.scene.set_handles(true);
    studio.picture();
    QCOMPARE(studio.scene.clip_handle_at(x + 30, y), std::optional(ClipHandle::shift));
    QCOMPARE(studio.scene.clip_handle_at(x + 90, y), std::optional(ClipHandle::turn));
    QVERIFY(!studio.scene.clip_handle_at(x, y + 60).has_value());
    const double unit =
        studio.scene.pixel_of({1, 0, 0}).first - studio.scene.pixel_of({0, 0, 0}).first;
    const ClipPlane moved =
        studio.scene.dragged_clip(ClipHandle::shift, x, y, x + 0.25 * unit, y + 17);
    QVERIFY(std::abs(moved.origin[0] - 0.75) < 1e-9); // the mouse's way across counts for nothing
    QCOMPARE(moved.normal, options.clip.normal);
    const ClipPlane turned = studio.scene.dragged_clip(ClipHandle::turn, x + 90, y, x + 90, y + 30);
    QVERIFY(std::abs(turned.normal.norm() - 1) < 1e-12);
    QVERIFY(turned.normal[2] > 0.2 && std::abs(turned.normal[1]) < 1e-9); // follows the mouse
}

void MeshSceneTest::leaves_room_for_the_legend() {
    Studio studio(make_level("cube", {{"n", "3"}}), 600, 400);
    SceneOptions options = studio.scene.options();
    options.colour = ColourBy::aspect_ratio;
    options.range = {{1, 1000}};
    studio.scene.set_options(options);
    studio.scene.reset_camera();
    studio.picture();
    const double room = studio.scene.legend_pixels();
    QVERIFY(room > 50 && room < 200);
    for (const double x : {0.0, 1.0}) { // the mesh keeps out of it
        for (const double z : {0.0, 1.0}) {
            QVERIFY(studio.scene.pixel_of({x, 1, z}).first < 600 - room);
        }
    }
    const QImage image = studio.picture();
    QVERIFY(!studio.scene.pick(600 - room / 2, 200).has_value());
    const QImage margin = image.copy(600 - static_cast<int>(room), 0, static_cast<int>(room), 400);
    const auto yellow = [](const QColor& c) { return near_colour(c, QColor(253, 231, 37), 30); };
    QVERIFY(share_of_pixels(margin, yellow) > 1e-3); // the upper end of the scale
    options.legend = false;
    studio.scene.set_options(options);
    studio.picture();
    QCOMPARE(studio.scene.legend_pixels(), 0.0);
}

void MeshSceneTest::is_transparent_when_asked() {
    Studio studio(make_level("cube", {{"n", "3"}}));
    studio.bare();
    QCOMPARE(studio.picture().pixelColor(0, 0).alpha(), 255);
    studio.scene.set_transparent(true);
    const QImage image = studio.picture();
    QCOMPARE(image.pixelColor(0, 0).alpha(), 0);
    QCOMPARE(image.pixelColor(240, 180).alpha(), 255);
}

void MeshSceneTest::is_light_and_dark() {
    Studio studio(make_level("cube", {{"n", "3"}}));
    QVERIFY(studio.picture().pixelColor(0, 0).lightness() > 240);
    SceneOptions options = studio.scene.options();
    options.dark = true;
    studio.scene.set_options(options);
    QVERIFY(studio.picture().pixelColor(0, 0).lightness() < 60);
}

void MeshSceneTest::shows_2d_meshes() {
    const auto data = make_level("cube", {{"n", "6"}, {"dim", "2"}});
    Studio studio(data);
    studio.bare();
    QCOMPARE(studio.scene.camera().sight, Vec3(0, 0, -1));
    const QImage image = studio.picture();
    const auto [x0, y0] = studio.scene.pixel_of({0, 0, 0});
    const auto [x1, y1] = studio.scene.pixel_of({1, 1, 0});
    const double square = (x1 - x0) * (y1 - y0) / (480.0 * 360);
    QVERIFY(std::abs(share_not_background(image) - square) < 0.03);
    const auto pick = studio.scene.pick(240, 180);
    QVERIFY(pick.has_value() && pick->element.valid() && !pick->face.valid());
}

void MeshSceneTest::shows_where_nodes_go() {
    SceneInput<2> input;
    input.mesh = std::make_shared<const Mesh<2>>(
        std::get<Mesh<2>>(make_case("cube", {{"n", "3"}, {"dim", "2"}, {"displace", "0"}})));
    input.removed_at.assign(input.mesh->points.size(), 0);
    input.removed_at[5] = 1;
    Studio studio(make_scene_data(std::move(input)));
    studio.bare();
    SceneOptions options = studio.scene.options();
    options.colour = ColourBy::removed_at;
    studio.scene.set_options(options);
    const auto& data = *studio.scene.data();
    const QImage image = studio.picture();
    const Rgb gone = removal_colour(1);
    QVERIFY(near_colour(colour_at(image, studio.scene.pixel_of(data.position(NodeId(5)))),
                        QColor(gone[0], gone[1], gone[2]), 30));
    const Rgb stays = removal_colour(0);
    QVERIFY(near_colour(colour_at(image, studio.scene.pixel_of(data.position(NodeId(6)))),
                        QColor(stays[0], stays[1], stays[2]), 30));
}

void MeshSceneTest::locks_the_range_of_the_colours() {
    const auto data = make_level("layer", {{"nx", "6"}, {"ny", "6"}, {"nz", "10"}});
    Studio studio(data);
    SceneOptions options = studio.scene.options();
    options.colour = ColourBy::aspect_ratio;
    studio.scene.set_options(options);
    studio.picture();
    const auto own = studio.scene.shown_range();
    QVERIFY(own.has_value());
    QCOMPARE(own->first, 1.0);
    double largest = 0;
    for (std::size_t i = 0; i < data->node_count; ++i) {
        largest = std::max(largest, node_value(*data, ColourBy::aspect_ratio, NodeId(i)));
    }
    QCOMPARE(own->second, largest);
    options.range = {{10, 20}};
    studio.scene.set_options(options);
    studio.picture();
    QCOMPARE(*studio.scene.shown_range(), (std::pair<double, double>{10, 20}));
}

void MeshSceneTest::does_without_a_metric() {
    SceneInput<3> input;
    input.mesh = std::make_shared<const Mesh<3>>(std::get<0>(make_case("cube", {{"n", "2"}})));
    const auto data = make_scene_data(std::move(input), Monitor::silent(), AbsentMetric::leave_out);
    QVERIFY(!data->has_metric());
    Studio studio(data);
    for (const ColourBy colour : all_colours) {
        SceneOptions options = studio.scene.options();
        options.colour = colour;
        options.ellipsoids.where = EllipsoidOptions::Where::sample; // made from the elements
        studio.scene.set_options(options);
        QVERIFY(share_not_background(studio.picture()) > 0.1);
        QVERIFY(!studio.scene.shown_range().has_value());
        QVERIFY(studio.scene.shown_ellipsoids() > 0);
    }
}

QTEST_GUILESS_MAIN(MeshSceneTest)
#include "mesh_scene_test.moc"
