// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/icosphere.h"

#include <map>
#include <set>

#include <Eigen/Geometry>
#include <QtTest>

using namespace ameco;

namespace {

/// How often each directed edge occurs: once each way on a closed, oriented surface.
bool is_closed(const SphereSurface& s) {
    std::set<std::pair<int, int>> edges;
    for (const auto& t : s.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (!edges.insert({t[i], t[(i + 1) % 3]}).second) {
                return false;
            }
        }
    }
    for (const auto& [a, b] : edges) {
        if (edges.count({b, a}) == 0) {
            return false;
        }
    }
    return true;
}

bool faces_outward(const SphereSurface& s) {
    for (const auto& t : s.triangles) {
        const Vec<3>& a = s.points[static_cast<std::size_t>(t[0])];
        const Vec<3>& b = s.points[static_cast<std::size_t>(t[1])];
        const Vec<3>& c = s.points[static_cast<std::size_t>(t[2])];
        if (a.dot(b.cross(c)) <= 0) {
            return false;
        }
    }
    return true;
}

std::map<int, int> valences(const SphereSurface& s) {
    std::vector<int> degree(s.points.size());
    for (const auto& t : s.triangles) {
        for (const int v : t) {
            ++degree[static_cast<std::size_t>(v)];
        }
    }
    std::map<int, int> count;
    for (const int d : degree) {
        ++count[d];
    }
    return count;
}

} // namespace

class IcosphereTest : public QObject {
    Q_OBJECT
private slots:
    void is_a_closed_triangulation_of_the_sphere_data();
    void is_a_closed_triangulation_of_the_sphere();
    void has_twelve_nodes_of_five_neighbours_before_flips();
    void has_irregular_nodes_after_flips();
};

void IcosphereTest::is_a_closed_triangulation_of_the_sphere_data() {
    QTest::addColumn<int>("frequency");
    QTest::addColumn<double>("displace");
    QTest::addColumn<double>("flips");
    for (const int frequency : {1, 2, 7, 16}) {
        for (const double displace : {0.0, 0.2}) {
            for (const double flips : {0.0, 0.3, 1.0}) {
                QTest::addRow("frequency %d, displace %g, flips %g", frequency, displace, flips)
                    << frequency << displace << flips;
            }
        }
    }
}

void IcosphereTest::is_a_closed_triangulation_of_the_sphere() {
    QFETCH(int, frequency);
    QFETCH(double, displace);
    QFETCH(double, flips);
    const SphereSurface s = icosphere(frequency, displace, flips, 1);
    const auto f2 = static_cast<std::size_t>(frequency * frequency);
    QCOMPARE(s.points.size(), 10 * f2 + 2);
    QCOMPARE(s.triangles.size(), 20 * f2);
    for (const Vec<3>& p : s.points) {
        QVERIFY(std::abs(p.norm() - 1) < 1e-15);
    }
    QVERIFY(is_closed(s));
    QVERIFY(faces_outward(s));
}

void IcosphereTest::has_twelve_nodes_of_five_neighbours_before_flips() {
    const auto count = valences(icosphere(5, 0.1, 0, 1));
    QCOMPARE(count, (std::map<int, int>{{5, 12}, {6, 240}}));
}

void IcosphereTest::has_irregular_nodes_after_flips() {
    const auto count = valences(icosphere(16, 0.15, 0.2, 1));
    QVERIFY(count.count(7) > 0 && count.at(7) > 50);
    QVERIFY(count.begin()->first >= 3);
}

QTEST_APPLESS_MAIN(IcosphereTest)
#include "icosphere_test.moc"
