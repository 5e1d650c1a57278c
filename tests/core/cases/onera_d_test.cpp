// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/onera_d.h"

#include <cmath>
#include <fstream>

#include <QFile>
#include <QtTest>

using namespace ameco;

namespace {

/// Distance of the curve from a point, by search.
double distance_to(const OneraD& section, const Vec<2>& p) {
    double nearest = 1;
    for (int i = 0; i <= 40000; ++i) {
        nearest = std::min(nearest, (section(section.length() * i / 40000) - p).norm());
    }
    return nearest;
}

} // namespace

class OneraDTest : public QObject {
    Q_OBJECT
private slots:
    void starts_at_the_nose_and_ends_on_the_chord();
    void has_the_published_thickness_and_nose();
    void is_traversed_at_unit_speed();
    void closes_a_rounded_tail_without_a_corner();
    void prolongs_a_sharp_tail();
    void passes_the_published_points();
};

void OneraDTest::starts_at_the_nose_and_ends_on_the_chord() {
    for (const auto tail : {TrailingEdge::rounded, TrailingEdge::sharp}) {
        const OneraD section(tail);
        QVERIFY(section(0) == Vec<2>(0, 0));
        QCOMPARE(section(section.length())[1], 0.0);
        QVERIFY(section(1e-6)[0] < 1e-8 && section(1e-6)[1] > 0); // the nose is blunt
    }
}

void OneraDTest::has_the_published_thickness_and_nose() {
    const OneraD section(TrailingEdge::rounded);
    double thickest = 0;
    for (int i = 0; i <= 1000; ++i) {
        thickest = std::max(thickest, section(section.length() * i / 1000)[1]);
    }
    QVERIFY(std::abs(2 * thickest - 0.0979) < 1e-4); // largest published z/c: 0.0489296
    // Nose radius z^2 / 2x of the published points nearest to the nose: 0.01449.
    const Vec<2> p = section(0.001);
    QVERIFY(std::abs(p[1] * p[1] / (2 * p[0]) - 0.0145) < 2e-4);
}

void OneraDTest::is_traversed_at_unit_speed() {
    const OneraD section(TrailingEdge::rounded);
    for (double s = 0; s < section.length() - 1e-4; s += 0.0101) {
        QVERIFY(std::abs((section(s + 1e-5) - section(s)).norm() / 1e-5 - 1) < 0.02);
    }
}

void OneraDTest::closes_a_rounded_tail_without_a_corner() {
    const OneraD section(TrailingEdge::rounded);
    const double end = section.length();
    QVERIFY(std::abs(section(end)[0] - 1.000624) < 1e-5); // centre 0.999913 + radius 0.000711
    Vec<2> last = (section(0.98) - section(0.98 - 1e-6)).normalized();
    for (double s = 0.98; s < end - 1e-6; s += 2e-5) { // no turn of more than 4 degrees per step
        const Vec<2> direction = (section(s + 1e-6) - section(s)).normalized();
        QVERIFY(direction.dot(last) > std::cos(0.07));
        last = direction;
    }
    QVERIFY(last[1] < -0.99); // straight down at the end
}

void OneraDTest::prolongs_a_sharp_tail() {
    const OneraD section(TrailingEdge::sharp);
    QVERIFY(std::abs(section(section.length())[0] - 1.005694) < 2e-6);
}

void OneraDTest::passes_the_published_points() {
    std::ifstream file(AMECO_SHARED_DIR "/meshes/onera_d.csv");
    if (!file) {
        QSKIP("needs meshes/onera_d.csv in AMECO_SHARED_DIR");
    }
    const OneraD section(TrailingEdge::rounded);
    int points = 0;
    for (std::string line; std::getline(file, line);) {
        if (line[0] == '0' || line[0] == '1') {
            const std::size_t comma = line.find(',');
            const Vec<2> p(std::stod(line.substr(0, comma)), std::stod(line.substr(comma + 1)));
            QVERIFY(distance_to(section, p) < 2e-5);
            ++points;
        }
    }
    QCOMPARE(points, 72);
}

QTEST_APPLESS_MAIN(OneraDTest)
#include "onera_d_test.moc"
