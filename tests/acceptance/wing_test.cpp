// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The paper's second example, section 5.2: an ONERA M6 wing of 67,866 nodes.
#include "core/cases/onera_m6.h"
#include "core/coarsen/target_ratio.h"
#include "core/io/io.h"
#include "core/mesh/boundary.h"
#include "core/metric/aspect_ratio.h"
#include "tests/acceptance/wing_iterations.h"

#include <QFileInfo>
#include <QTest>

using namespace ameco;

namespace {

/// \param in_band  share of the edges of level 1
void coarsens_as_the_metric_asks(Mesh<3> mesh, double in_band) {
    (void)complete_boundary(mesh);
    Level<3> level = finest_level(std::move(mesh), {});
    std::vector<AspectRatioClasses> classes{classify_aspect_ratios(level.natural)};
    for (int k = 1; k <= 4; ++k) {
        CoarsenReport report;
        level = coarsen(level, {}, report);
        QVERIFY(report.check.valid());
        const double before = static_cast<double>(report.nodes_before);
        const double after = static_cast<double>(report.nodes_after);
        QVERIFY2(before / after >= 2.0,
                 qPrintable(QStringLiteral("level %1: ratio %2").arg(k).arg(before / after)));
        const double reached = after / report.predicted_nodes;
        QVERIFY2(
            reached >= 0.95 && reached <= 1.05,
            qPrintable(QStringLiteral("level %1: %2 of the predicted nodes").arg(k).arg(reached)));
        QVERIFY2(k > 1 || report.conformity.in_band >= in_band,
                 qPrintable(QStringLiteral("in band: %1").arg(report.conformity.in_band)));
        classes.push_back(classify_aspect_ratios(level.natural, classes[0].max));
    }
    // The histogram moves to the right, figure 11: the share of nodes above an eighth of the
    // largest aspect ratio falls from level to level, to less than a tenth of what it was.
    const auto stretched = [](const AspectRatioClasses& c) {
        double total = 0;
        for (const std::int64_t n : c.counts) {
            total += static_cast<double>(n);
        }
        return static_cast<double>(c.counts[0] + c.counts[1] + c.counts[2]) / total;
    };
    for (std::size_t k = 1; k < classes.size(); ++k) {
        QVERIFY(stretched(classes[k]) < stretched(classes[k - 1]));
    }
    QVERIFY(stretched(classes.back()) < 0.1 * stretched(classes.front()));
}

} // namespace

class WingTest : public QObject {
    Q_OBJECT
private slots:
    void our_wing_coarsens_as_the_metric_asks();
    void a_wing_by_another_program_coarsens_as_the_metric_asks();
    void each_level_has_the_ratio_asked_for();
    void multigrid_does_not_feel_the_size();
};

void WingTest::our_wing_coarsens_as_the_metric_asks() {
    coarsens_as_the_metric_asks(make_onera_m6({}), 0.85);
}

void WingTest::a_wing_by_another_program_coarsens_as_the_metric_asks() {
    const QString path = QStringLiteral(AMECO_SHARED_DIR "/meshes/m6_67k.meshb");
    if (!QFileInfo::exists(path)) {
        QSKIP("m6_67k.meshb is not here");
    }
    coarsens_as_the_metric_asks(std::get<Mesh<3>>(read_mesh(path.toStdString()).mesh), 0.85);
}

void WingTest::each_level_has_the_ratio_asked_for() {
    Level<3> level = finest_level(make_onera_m6({}), {});
    for (int k = 1; k <= 4; ++k) {
        CoarsenReport report;
        level = coarsen_by_ratio(level, {}, 2, report);
        const double ratio =
            static_cast<double>(report.nodes_before) / static_cast<double>(report.nodes_after);
        QVERIFY2(ratio >= 1.9 && ratio <= 2.1,
                 qPrintable(QStringLiteral("level %1: ratio %2").arg(k).arg(ratio)));
    }
}

void WingTest::multigrid_does_not_feel_the_size() {
    const int small = iterations(make_onera_m6(half_as_fine()));
    const int large = iterations(make_onera_m6({}));
    QVERIFY2(small <= 10, qPrintable(QString::number(small)));
    QVERIFY2(4 * large <= 5 * small, qPrintable(QStringLiteral("%1 %2").arg(small).arg(large)));
}

QTEST_APPLESS_MAIN(WingTest)
#include "wing_test.moc"
