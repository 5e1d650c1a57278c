// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/pictures.h"

#include "core/cases/layer.h"
#include "core/cases/shell.h"

#include <QTest>
#include <QXmlStreamReader>

using namespace ameco;

namespace {

/// Parses to the end; counts elements of a name.
int count_elements(const std::string& svg, const QString& name) {
    QXmlStreamReader xml(QByteArray::fromStdString(svg));
    int count = 0;
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == name) {
            ++count;
        }
    }
    return xml.hasError() ? -1 : count;
}

template <int D>
void window_shows_the_wall() {
    LayerOptions layer;
    layer.aspect_ratio = 1e4;
    const auto mesh = make_layer<D>(layer);
    const auto view = find_section(mesh);
    QVERIFY(view.has_value());
    // Columns stand upright on the wall: the view looks up from it.
    QVERIFY(view->across[D - 1] > 0.99);
    QVERIFY(view->width / view->height > 100);
    const SectionPanel panel = draw_section(mesh, *view, "level 0");
    QVERIFY(panel.triangles.size() > 40);
    for (const auto& t : panel.triangles) {
        QVERIFY(std::min({t[0], t[2], t[4]}) < 1 && std::max({t[0], t[2], t[4]}) > 0);
    }
}

} // namespace

class PicturesTest : public QObject {
    Q_OBJECT
private slots:
    void histogram_has_a_bar_per_class_and_level();
    void section_looks_at_the_wall_of_a_layer_in_3d() { window_shows_the_wall<3>(); }
    void section_looks_at_the_wall_of_a_layer_in_2d() { window_shows_the_wall<2>(); }
    void sections_are_well_formed_with_a_panel_per_level();
    void a_mesh_without_planar_patch_has_no_section();
};

void PicturesTest::histogram_has_a_bar_per_class_and_level() {
    AspectRatioClasses fine{16, {10, 20, 30, 40, 5}}, coarse{16, {0, 5, 10, 20, 5}};
    const std::string svg = histogram_svg({fine, coarse});
    // Background, ten bars, two keys.
    QCOMPARE(count_elements(svg, QStringLiteral("rect")), 1 + 10 + 2);
}

void PicturesTest::sections_are_well_formed_with_a_panel_per_level() {
    const auto mesh = make_layer<3>({});
    const auto view = find_section(mesh);
    QVERIFY(view.has_value());
    const SectionPanel panel = draw_section(mesh, *view, "a");
    const std::string svg = sections_svg({panel, panel, panel, panel}, 100);
    QCOMPARE(count_elements(svg, QStringLiteral("g")), 4);
    QVERIFY(svg.find("scaled 100 times") != std::string::npos);
}

void PicturesTest::a_mesh_without_planar_patch_has_no_section() {
    QVERIFY(!find_section(make_shell({})).has_value());
}

QTEST_APPLESS_MAIN(PicturesTest)
#include "pictures_test.moc"
