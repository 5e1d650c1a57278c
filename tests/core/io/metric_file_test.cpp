// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf.h"
#include "tests/core/io/gmf_bytes.h"
#include "tests/core/io/io_support.h"

using namespace ameco;
using namespace ameco::test;

class MetricFileTest : public QObject {
    Q_OBJECT
private slots:
    void stores_the_upper_triangle_by_columns();
    void keeps_every_bit_of_tensors_data();
    void keeps_every_bit_of_tensors();
    void keeps_metrics_to_rounding_data();
    void keeps_metrics_to_rounding();
    void reads_text_with_a_header_in_one_line();
    void names_the_vertex_that_is_not_positive_definite();
    void recognises_components_in_vtk_order();
    void names_the_place_in_a_broken_file_data();
    void names_the_place_in_a_broken_file();
};

namespace {

template <int D>
IdVector<NodeId, Tensor<D>> random_tensors(unsigned seed, bool single) {
    Random random(seed);
    IdVector<NodeId, Tensor<D>> tensors(1 + static_cast<std::size_t>(random.below(40)));
    for (Tensor<D>& tensor : tensors) {
        for (double& component : tensor) {
            component = single ? static_cast<double>(random.real32()) : random.real();
        }
    }
    return tensors;
}

template <int D>
void check_round_trip(const Folder& folder, const std::string& suffix, int version, unsigned seed) {
    const auto tensors = random_tensors<D>(seed, version == 1);
    write_tensors<D>(folder / ("metric" + suffix), tensors, {.version = version});
    const TensorFile file = read_tensors(folder / ("metric" + suffix));
    const auto& again = std::get<IdVector<NodeId, Tensor<D>>>(file.tensors);
    QVERIFY(again == tensors);
    QVERIFY(std::memcmp(again.data(), tensors.data(), tensors.size() * sizeof(Tensor<D>)) == 0);
    QVERIFY(file.notes.empty());
    QCOMPARE(file.format_version, suffix == ".sol" ? 2 : version);
}

/// Vertices with a metric each, of aspect ratios up to 1e6, turned by random reflections.
template <int D>
MetricField<D> random_metrics(unsigned seed) {
    Random random(seed);
    MetricField<D> field(20);
    for (Metric<D>& metric : field) {
        Vec<D> normal;
        for (int k = 0; k < D; ++k) {
            metric.sizes[k] = std::pow(10.0, -6 + 3 * k) * (1 + 0.01 * random.below(100));
            normal[k] = 1 + random.below(100);
        }
        normal.normalize();
        metric.directions = Mat<D>::Identity() - 2 * normal * normal.transpose();
    }
    return field;
}

template <int D>
void check_metrics(const std::string& suffix) {
    const Folder folder;
    const MetricField<D> field = random_metrics<D>(4);
    write_metric(folder / ("metric" + suffix), field);
    const MetricFile file = read_metric(folder / ("metric" + suffix));
    const auto& again = std::get<MetricField<D>>(file.field);
    QCOMPARE(again.size(), field.size());
    for (const NodeId node : field.ids()) {
        // The tensor's condition number is 1e6 squared per pair of sizes: what 16 digits leave.
        const double smallest = again[node].sizes[0] / field[node].sizes[0];
        QVERIFY(std::abs(smallest - 1) < 1e-12);
        const Mat<D> difference =
            again[node].directions.cwiseAbs() - field[node].directions.cwiseAbs();
        QVERIFY(difference.col(0).norm() < 1e-9);
    }
}

/// Tensors xx 4, yy 9, zz 16, xy 0.5, yz 0.25, xz 0.125, one per vertex.
constexpr Tensor<3> example{4, 0.5, 0.125, 9, 0.25, 16};

} // namespace

/// m11 m12 m22 m13 m23 m33: every row adds the next column of the upper triangle.
void MetricFileTest::stores_the_upper_triangle_by_columns() {
    const Folder folder;
    write_tensors<3>(folder / "a.sol", IdVector<NodeId, Tensor<3>>(1, example));
    QCOMPARE(content_of(folder / "a.sol"),
             std::string("MeshVersionFormatted 2\n\nDimension 3\n\nSolAtVertices\n1\n1 3\n"
                         "4 0.5 9 0.125 0.25 16\n\nEnd\n"));
    write_tensors<2>(folder / "b.sol", IdVector<NodeId, Tensor<2>>(1, {4, 0.5, 9}));
    QVERIFY(contains(content_of(folder / "b.sol"), "\n4 0.5 9\n"));
    for (const int version : {1, 2, 3, 4}) {
        GmfBytes bytes = GmfBytes::of(version, 3);
        bytes.begin(62).integer(1).int32(1).int32(3);
        bytes.real(4).real(0.5).real(9).real(0.125).real(0.25).real(16).end();
        const TensorFile file = read_tensors(folder.file("c.solb", bytes.finish()));
        const auto& tensors = std::get<IdVector<NodeId, Tensor<3>>>(file.tensors);
        QVERIFY(tensors == (IdVector<NodeId, Tensor<3>>(1, example)));
        write_tensors<3>(folder / "d.solb", tensors, {.version = version});
        QVERIFY(content_of(folder / "d.solb") == bytes.finish());
    }
}

void MetricFileTest::keeps_every_bit_of_tensors_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<QString>("suffix");
    QTest::addColumn<int>("version");
    for (const int d : {2, 3}) {
        QTest::addRow("%d-D text", d) << d << ".sol" << 2;
        for (const int version : {1, 2, 3, 4}) {
            QTest::addRow("%d-D binary %d", d, version) << d << ".solb" << version;
        }
    }
}

void MetricFileTest::keeps_every_bit_of_tensors() {
    QFETCH(int, dimension);
    QFETCH(QString, suffix);
    QFETCH(int, version);
    const Folder folder;
    for (unsigned seed = 0; seed < 20; ++seed) {
        if (dimension == 2) {
            check_round_trip<2>(folder, suffix.toStdString(), version, seed);
        } else {
            check_round_trip<3>(folder, suffix.toStdString(), version, seed);
        }
    }
}

void MetricFileTest::keeps_metrics_to_rounding_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<QString>("suffix");
    QTest::newRow("2-D text") << 2 << ".sol";
    QTest::newRow("2-D binary") << 2 << ".solb";
    QTest::newRow("3-D text") << 3 << ".sol";
    QTest::newRow("3-D binary") << 3 << ".solb";
}

void MetricFileTest::keeps_metrics_to_rounding() {
    QFETCH(int, dimension);
    QFETCH(QString, suffix);
    if (dimension == 2) {
        check_metrics<2>(suffix.toStdString());
    } else {
        check_metrics<3>(suffix.toStdString());
    }
}

void MetricFileTest::reads_text_with_a_header_in_one_line() {
    const Folder folder;
    const auto path = folder.file("a.sol", "MeshVersionFormatted 2\n\nDimension\n2\n\n"
                                           "SolAtVertices 2 1 3\n1D2 0 4\n1 0 1\nEnd\n");
    const MetricFile file = read_metric(path);
    const auto& field = std::get<MetricField<2>>(file.field);
    QCOMPARE(field.size(), 2U);
    QCOMPARE(field[NodeId(0)].sizes[0], 0.1);
    QCOMPARE(field[NodeId(0)].sizes[1], 0.5);
}

void MetricFileTest::names_the_vertex_that_is_not_positive_definite() {
    const Folder folder;
    IdVector<NodeId, Tensor<3>> tensors(5, {1, 0, 0, 1, 0, 1});
    tensors[NodeId(3)] = {1, 2, 0, 1, 0, 1};
    write_tensors<3>(folder / "a.solb", tensors);
    const std::string text =
        message_of<InputError>([&] { static_cast<void>(read_metric(folder / "a.solb")); });
    QVERIFY(contains(text, name_of(folder / "a.solb") + "the tensor of vertex 4 is not "
                                                        "positive definite (1 of 5 are not)"));
    QVERIFY(text.find("VTK") == std::string::npos);
    QVERIFY(std::get<0>(read_tensors(folder / "a.solb").tensors) == tensors);
}

void MetricFileTest::recognises_components_in_vtk_order() {
    const Folder folder;
    // xx yy zz xy yz xz with a dominant diagonal; taken in Medit's order m12 is larger than m11.
    const auto solid =
        folder.file("a.sol", "MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n2\n"
                             "1 3\n4 9 16 0.5 0.25 0.125\n4 9 16 0 0 0\nEnd\n");
    const std::string text = message_of<InputError>([&] { static_cast<void>(read_metric(solid)); });
    QVERIFY(contains(text, "vertex 1 is not positive definite (2 of 2 are not)"));
    QVERIFY(contains(text, "VTK's order (xx yy zz xy yz xz) 2 would be"));
    const auto flat = folder.file("b.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n1\n"
                                           "1 3\n4 9 0.5\nEnd\n");
    QVERIFY(contains(message_of<InputError>([&] { static_cast<void>(read_metric(flat)); }),
                     "VTK's order (xx yy xy) 1 would be"));
}

void MetricFileTest::names_the_place_in_a_broken_file_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& bytes, const char* message) {
        QTest::newRow(name) << QByteArray::fromStdString(bytes) << message;
    };
    const auto solution = [] { return GmfBytes::of(2, 3).begin(62); };
    const std::string head = "MeshVersionFormatted 2\nDimension 2\n";
    row("a scalar", solution().integer(1).int32(1).int32(1).real(1).end().finish(),
        "holds the fields scalar per vertex");
    row("a vector", solution().integer(0).int32(1).int32(2).end().finish(), "vector");
    row("a full tensor", solution().integer(0).int32(1).int32(4).end().finish(), "full tensor");
    row("a tensor and a scalar", solution().integer(0).int32(2).int32(3).int32(1).end().finish(),
        "symmetric tensor, scalar");
    row("an unknown type", solution().integer(0).int32(1).int32(99).end().finish(), "unknown");
    row("no fields", solution().integer(0).int32(0).end().finish(), "no fields");
    row("no tensors", solution().integer(0).int32(1).int32(3).end().finish(), "holds no tensors");
    row("no types", solution().integer(1).end().finish(), "announces -1 fields");
    row("2^31 fields", solution().integer(1).int32(2147483647).end().finish(),
        "SolAtVertices at byte 20 announces 2147483647 fields");
    row("-3 fields", solution().integer(1).int32(-3).end().finish(), "announces -3 fields");
    row("rows too few",
        solution()
            .integer(2)
            .int32(1)
            .int32(3)
            .real(1)
            .real(0)
            .real(1)
            .real(0)
            .real(0)
            .real(1)
            .end()
            .finish(),
        "SolAtVertices at byte 20 announces 2 rows of 48 bytes, but has room for 48 bytes");
    row("2^31 rows", solution().integer(2147483647).int32(1).int32(3).end().finish(),
        "announces 2147483647 rows");
    row("a mesh", tetrahedron(2).finish(), "holds a mesh and no metric");
    row("nothing", GmfBytes::of(2, 3).finish(), "no SolAtVertices");
    row("a mesh in text", head + "Vertices\n1\n0 0 0\nEnd\n", "holds a mesh and no metric");
    row("NaN", head + "SolAtVertices\n2\n1 3\n1 0 1\n1 nan 1\nEnd\n", "the tensor of vertex 2");
    row("a scalar in text", head + "SolAtVertices\n1\n1 1\n1\nEnd\n", "scalar");
    row("letters in text", head + "SolAtVertices\n2\n1 3\n1 0 1\n1 x 1\nEnd\n",
        "line 7: SolAtVertices, row 2 of 2: expected a number, found 'x'");
    row("count beyond the text", head + "SolAtVertices\n2000\n1 3\n1 0 1\n",
        "SolAtVertices announces 2000 rows");
    row("fields beyond the text", head + "SolAtVertices\n1\n2000\n1 0 1\n", "2000 fields");
}

void MetricFileTest::names_the_place_in_a_broken_file() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, message);
    const std::string text = message_of<InputError>(
        [&] { static_cast<void>(gmf::read_tensors(bytes.toStdString(), "wing.solb")); });
    QVERIFY(contains(text, "wing.solb: "));
    QVERIFY(contains(text, message));
}

QTEST_APPLESS_MAIN(MetricFileTest)
#include "metric_file_test.moc"
