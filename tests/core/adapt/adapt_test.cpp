// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/adapt.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/core/adapt/adapt_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

namespace {

/// Stops from the n-th question on.
class StopAt : public Monitor {
public:
    explicit StopAt(int question) : left_(question) {}
    void message(Severity, std::string_view) override {}
    void progress(double, std::string_view) override {}
    [[nodiscard]] bool stop_requested() const override { return --left_ <= 0; }

private:
    mutable int left_;
};

} // namespace

class AdaptTest : public QObject {
    Q_OBJECT
private slots:
    void a_layer_of_aspect_ratio_1000_is_made_from_an_isotropic_cube() {
        const Mesh<3> mesh = make_cube<3>({.n = 4, .displace = 0});
        AdaptReport report;
        const auto adapted = adapt(mesh, LayerMetric<3>(3e-4, 0.3, 0.3), {}, report);
        QVERIFY2(report.conformity.in_band > 0.95,
                 std::to_string(report.conformity.in_band).c_str());
        QVERIFY2(report.conformity.worst_quality > 0.2,
                 std::to_string(report.conformity.worst_quality).c_str());
        QVERIFY(report.conformity.longest < 2);
        QVERIFY(report.stages > 3);
        QVERIFY(difference(remesh_test::extent(adapted.mesh), remesh_test::extent(mesh)) < 1e-12);
        const double ratio = static_cast<double>(report.nodes_after) / report.predicted_nodes;
        QVERIFY2(ratio > 0.8 && ratio < 1.25, std::to_string(ratio).c_str());
    }

    void and_taken_back() {
        const Mesh<3> mesh = make_cube<3>({.n = 4, .displace = 0});
        AdaptReport report;
        const auto fine = adapt(mesh, LayerMetric<3>(3e-3, 0.3, 0.3), {}, report);
        const auto back = adapt(fine.mesh, UniformMetric<3>(0.3), {}, report);
        QVERIFY(back.mesh.points.size() < fine.mesh.points.size() / 3);
        QVERIFY(report.conformity.in_band > 0.95);
        QVERIFY(report.conformity.worst_quality > 0.2);
    }

    void triangles_too() {
        const Mesh<2> mesh = make_cube<2>({.n = 6, .displace = 0});
        AdaptReport report;
        const auto adapted = adapt(mesh, LayerMetric<2>(1e-5, 0.2, 0.1), {}, report);
        QVERIFY2(report.conformity.in_band > 0.97,
                 std::to_string(report.conformity.in_band).c_str());
        QVERIFY(report.conformity.worst_quality > 0.4);
        QVERIFY(check(adapted.mesh).valid());
    }

    void the_metric_that_is_given_back_is_that_of_the_nodes() {
        const Mesh<3> mesh = make_cube<3>({.n = 3, .displace = 0});
        const LayerMetric<3> source(0.02, 0.3, 0.4);
        AdaptReport report;
        const auto adapted = adapt(mesh, source, {}, report);
        QCOMPARE(adapted.metric.size(), adapted.mesh.points.size());
        for (const NodeId v : adapted.mesh.points.ids()) {
            NodeId near;
            QVERIFY(adapted.metric[v] == source.at(adapted.mesh.points[v], near));
        }
    }

    void node_nested_meshes_have_nodes_of_the_mesh_only() {
        const Mesh<3> mesh = make_cube<3>({.n = 6});
        AdaptReport report;
        AdaptOptions options;
        options.node_nested = true;
        const auto adapted = adapt(mesh, UniformMetric<3>(0.3), options, report);
        QVERIFY(adapted.mesh.points.size() < mesh.points.size() / 2);
        QVERIFY(has_nodes_of(adapted.mesh, mesh));
    }

    void regions_and_the_faces_between_them_stay() {
        Mesh<3> mesh = make_cube<3>({.n = 4, .displace = 0});
        remesh_test::split_regions(mesh, 0.5);
        AdaptReport report;
        const auto adapted = adapt(mesh, UniformMetric<3>(0.15), {}, report);
        QVERIFY(adapted.mesh.points.size() > mesh.points.size());
        QVERIFY(difference(remesh_test::extent(adapted.mesh), remesh_test::extent(mesh)) < 1e-12);
    }

    void the_result_does_not_depend_on_the_number_of_threads() {
        const Mesh<3> mesh = make_cube<3>({.n = 4});
        Mesh<3> first;
        for (const int threads : {1, 2, 3}) {
            set_thread_count(threads);
            AdaptReport report;
            auto adapted = adapt(mesh, LayerMetric<3>(0.02, 0.3, 0.3), {}, report);
            if (threads == 1) {
                first = std::move(adapted.mesh);
            } else {
                QVERIFY(adapted.mesh == first);
            }
        }
        set_thread_count(0);
    }

    void a_metric_that_asks_for_too_many_nodes_is_refused() {
        const Mesh<3> mesh = make_cube<3>({.n = 2});
        AdaptReport report;
        QVERIFY_THROWS_EXCEPTION(InputError, (void)adapt(mesh, UniformMetric<3>(1e-9), {}, report));
        QVERIFY_THROWS_EXCEPTION(InputError,
                                 (void)adapt(mesh, UniformMetric<3>(1e-160), {}, report));
    }

    void a_stop_in_the_middle_is_obeyed_data() {
        QTest::addColumn<int>("question");
        for (const int question : {2, 3, 5, 9, 20}) {
            QTest::addRow("question %d", question) << question;
        }
    }
    void a_stop_in_the_middle_is_obeyed() {
        QFETCH(int, question);
        StopAt monitor(question);
        AdaptReport report;
        QVERIFY_THROWS_EXCEPTION(
            Cancelled,
            (void)adapt(make_cube<3>({.n = 4}), UniformMetric<3>(0.08), {}, report, monitor));
    }

    void it_can_be_stopped() {
        const Mesh<3> mesh = make_cube<3>({.n = 3});
        StopAt monitor(1);
        AdaptReport report;
        QVERIFY_THROWS_EXCEPTION(Cancelled,
                                 (void)adapt(mesh, UniformMetric<3>(0.1), {}, report, monitor));
    }
};

QTEST_APPLESS_MAIN(AdaptTest)
#include "adapt_test.moc"
