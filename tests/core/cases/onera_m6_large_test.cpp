// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/onera_m6.h"

#include "core/io/io.h"
#include "core/mesh/check.h"
#include "core/metric/aspect_ratio.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/cases/patches.h"

#include <array>
#include <filesystem>

#include <QtTest>

using namespace ameco;

namespace {

OneraM6Options preset(const std::string& name) {
    for (const OneraM6Preset& p : onera_m6_presets()) {
        if (p.name == name) {
            return p.options;
        }
    }
    throw std::logic_error("no preset " + name);
}

Vec<3> extent(const Mesh<3>& mesh) {
    Vec<3> low = mesh.points[NodeId(0)], high = low;
    for (const Vec<3>& p : mesh.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return high - low;
}

} // namespace

class OneraM6LargeTest : public QObject {
    Q_OBJECT
private slots:
    void presets_are_valid_and_of_their_size_data();
    void presets_are_valid_and_of_their_size();
    void matches_the_papers_67k_mesh();
    void resembles_the_given_67k_mesh();
    void has_the_papers_aspect_ratio_classes();
};

void OneraM6LargeTest::presets_are_valid_and_of_their_size_data() {
    QTest::addColumn<int>("preset");
    QTest::addColumn<double>("nodes");
    const std::map<std::string, double> expected{
        {"m6-8k", 8337}, {"m6-67k", 67866}, {"m6-500k", 500000}, {"m6-2m", 2008248}};
    int i = 0;
    for (const OneraM6Preset& p : onera_m6_presets()) {
        QTest::addRow("%s", p.name.c_str()) << i++ << expected.at(p.name);
    }
}

void OneraM6LargeTest::presets_are_valid_and_of_their_size() {
    QFETCH(int, preset);
    QFETCH(double, nodes);
    const Mesh<3> mesh =
        make_onera_m6(onera_m6_presets()[static_cast<std::size_t>(preset)].options);
    QVERIFY(near(static_cast<double>(mesh.points.size()), nodes, 0.01));
    const CheckReport report = check(mesh);
    QVERIFY2(report.valid(), report.summary().c_str());
    QVERIFY(report.warnings.empty());
}

void OneraM6LargeTest::matches_the_papers_67k_mesh() {
    const Mesh<3> m6 = make_onera_m6(preset("m6-67k"));
    QVERIFY(near(static_cast<double>(m6.points.size()), 67866, 0.01)); // paper, section 5.2
    const CheckReport report = check(m6);
    QVERIFY2(report.valid(), report.summary().c_str());
    const auto summary = summarise_aspect_ratios(nodal_metric(m6));
    QVERIFY(summary.share_above_150 > 0.05 && summary.share_above_150 < 0.065);
    QVERIFY(summary.share_isotropic > 0.28 && summary.share_isotropic < 0.33);
}

void OneraM6LargeTest::resembles_the_given_67k_mesh() {
    const std::filesystem::path path = AMECO_SHARED_DIR "/meshes/m6_67k.meshb";
    if (!std::filesystem::exists(path)) {
        QSKIP("needs meshes/m6_67k.meshb in AMECO_SHARED_DIR");
    }
    const auto given = std::get<Mesh<3>>(read_mesh(path).mesh);
    const Mesh<3> ours = make_onera_m6(preset("m6-67k"));
    QCOMPARE(ours.points.size(), given.points.size());
    QVERIFY(near(static_cast<double>(ours.elements.size()),
                 static_cast<double>(given.elements.size()), 1e-3));
    QVERIFY(near(check(ours).volume, check(given).volume, 0.05));
    QVERIFY(((extent(ours) - extent(given)).cwiseQuotient(extent(given))).norm() < 0.05);
    const auto a = summarise_aspect_ratios(nodal_metric(ours));
    const auto b = summarise_aspect_ratios(nodal_metric(given));
    QVERIFY(near(a.top_5_percent, b.top_5_percent, 0.05));
    QVERIFY(near(a.share_above_150, b.share_above_150, 0.05));
    QVERIFY(near(a.share_isotropic, b.share_isotropic, 0.05));
}

/// Nodes per class of the paper's Table 3, upper edge 532,713.
void OneraM6LargeTest::has_the_papers_aspect_ratio_classes() {
    constexpr std::array<double, 17> paper{1,      37,     1192,   42824,  98511,  110707,
                                           122646, 124437, 126260, 125025, 125231, 128334,
                                           134652, 138429, 147686, 128581, 158672};
    const Mesh<3> mesh = make_onera_m6(preset("m6-2m"));
    const auto field = nodal_metric(mesh);
    const auto summary = summarise_aspect_ratios(field);
    QVERIFY(near(summary.max, 532713, 0.02));
    QVERIFY(summary.top_5_percent > 15000);                   // paper, section 5.3
    QVERIFY(std::abs(summary.share_isotropic - 0.13) < 0.01); // "only 13 %"
    const auto classes = classify_aspect_ratios(field, 532713);
    for (std::size_t k = 3; k < 14; ++k) { // classes 4 to 14
        QVERIFY(near(static_cast<double>(classes.counts[k]), paper[k], 0.1));
    }
}

QTEST_APPLESS_MAIN(OneraM6LargeTest)
#include "onera_m6_large_test.moc"
