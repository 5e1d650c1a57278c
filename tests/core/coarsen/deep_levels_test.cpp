// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/shell.h"
#include "core/coarsen/coarsen.h"
#include "core/metric/aspect_ratio.h"
#include "tests/support/boundary_fit.h"

#include <QTest>

using namespace ameco;

class DeepLevelsTest : public QObject {
    Q_OBJECT
private slots:
    void a_sphere_is_coarsened_until_its_surfaces_are_left_data() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 4; ++seed) {
            QTest::addRow("seed %d", seed) << seed;
        }
    }

    /// Layers of aspect ratio 1e5 that grow by 1.2 halve their number six times; then the surfaces
    /// are left, and stop the coarsening.
    void a_sphere_is_coarsened_until_its_surfaces_are_left() {
        QFETCH(int, seed);
        ShellOptions shell;
        shell.seed = seed;
        shell.frequency = 8;
        shell.aspect_ratio = 1e5;
        const Mesh<3> finest = make_shell(shell);
        const double volume = check(finest).volume;
        Level<3> level = finest_level(finest, {});
        for (int k = 1;; ++k) {
            QVERIFY2(k <= 12, "the coarsening does not end");
            const double aspect = summarise_aspect_ratios(level.natural).max;
            CoarsenReport report;
            level = coarsen(level, {}, report);
            QVERIFY2(report.check.valid(), report.check.summary().c_str());
            QVERIFY(std::abs(report.check.volume / volume - 1) < 0.03);
            const auto fit = boundary_fit::measure(level, finest).at(1);
            QVERIFY(fit.over_short <= 0.5);
            QVERIFY(fit.over_edge <= 0.1);
            // No node of the last layer is left over: one alone makes elements as thin as it was.
            QVERIFY(k < 6 || summarise_aspect_ratios(level.natural).max < 20);
            const double ratio =
                static_cast<double>(report.nodes_before) / static_cast<double>(report.nodes_after);
            if (ratio < 1.05) {
                QVERIFY(aspect < 20);
                const auto& counts = report.removal.counts;
                const auto surface = static_cast<std::size_t>(Verdict::surface_distance);
                QCOMPARE(std::max_element(counts.begin(), counts.end()) - counts.begin(),
                         static_cast<std::ptrdiff_t>(surface));
                QVERIFY(k > 8);
                QVERIFY(report.nodes_after < 700); // with distances summed up 860 are left
                return;
            }
            if (aspect > 20) {
                // What is left when every other layer goes: few layers cannot be halved often.
                shell.every = 1 << (k - 1);
                const auto fine = static_cast<double>(make_shell(shell).points.size());
                shell.every = 1 << k;
                const double ideal = fine / static_cast<double>(make_shell(shell).points.size());
                QVERIFY(ratio >= 0.93 * std::min(1.8, ideal));
            }
        }
    }
};

QTEST_APPLESS_MAIN(DeepLevelsTest)
#include "deep_levels_test.moc"
