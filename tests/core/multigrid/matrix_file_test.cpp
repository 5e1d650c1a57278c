// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/matrix_file.h"

#include "core/base/error.h"
#include "core/multigrid/random_vector.h"

#include <QDataStream>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <limits>

using namespace ameco;

namespace {

/// 3 x 2; the second row is 0.1, 1/3, the third is empty.
SparseMatrix sample() {
    SparseMatrix m(3, 2);
    m.insert(0, 0) = 1;
    m.insert(1, 0) = 0.1;
    m.insert(1, 1) = 1.0 / 3;
    m.makeCompressed();
    return m;
}

/// Rows of different lengths, and numbers of all magnitudes and signs.
SparseMatrix large() {
    constexpr int n = 200;
    const Vector values = random_vector(8 * n);
    SparseMatrix m(n, n + 7);
    int k = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < i % 7; ++j, ++k) {
            m.insert(i, (31 * i + 17 * j) % (n + 7)) = std::ldexp(values[k], (k * 37) % 600 - 300);
        }
    }
    m.insert(6, 3) = -0.0;
    m.insert(7, 3) = std::numeric_limits<double>::denorm_min();
    m.insert(14, 3) = std::numeric_limits<double>::max();
    m.makeCompressed();
    return m;
}

QByteArray bytes_of(const std::filesystem::path& path) {
    QFile in(QString::fromStdString(path.string()));
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

/// PETSc's format read by other means than ours: QDataStream is big-endian.
SparseMatrix read_petsc_matrix(const std::filesystem::path& path) {
    const QByteArray bytes = bytes_of(path);
    QDataStream in(bytes);
    qint32 id = 0, rows = 0, columns = 0, entries = 0;
    in >> id >> rows >> columns >> entries;
    SparseMatrix m(rows, columns);
    m.resizeNonZeros(entries);
    m.outerIndexPtr()[0] = 0;
    for (int i = 0; i < rows; ++i) {
        qint32 length = 0;
        in >> length;
        m.outerIndexPtr()[i + 1] = m.outerIndexPtr()[i] + length;
    }
    for (int k = 0; k < entries; ++k) {
        in >> m.innerIndexPtr()[k];
    }
    for (int k = 0; k < entries; ++k) {
        in >> m.valuePtr()[k];
    }
    return id == 1211216 && in.status() == QDataStream::Ok && in.atEnd() ? m : SparseMatrix();
}

bool same_bits(const SparseMatrix& a, const SparseMatrix& b) {
    if (a.rows() != b.rows() || a.cols() != b.cols() || a.nonZeros() != b.nonZeros()) {
        return false;
    }
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        SparseMatrix::InnerIterator p(a, i), q(b, i);
        for (; p && q; ++p, ++q) {
            if (p.col() != q.col() || std::bit_cast<std::uint64_t>(p.value()) !=
                                          std::bit_cast<std::uint64_t>(q.value())) {
                return false;
            }
        }
        if (p || q) {
            return false;
        }
    }
    return true;
}

} // namespace

class MatrixFileTest : public QObject {
    Q_OBJECT
private slots:
    void both_formats_keep_every_bit_data();
    void both_formats_keep_every_bit();
    void petsc_matrices_are_big_endian();
    void petsc_vectors_are_big_endian();
    void rows_with_room_to_grow_are_written_without_it();
    void files_of_others_are_read();
    void a_damaged_file_is_refused_by_line_data();
    void a_damaged_file_is_refused_by_line();
    void a_missing_file_is_refused();
    void an_unknown_suffix_is_refused();
    void nothing_but_the_file_is_left_in_the_folder();

private:
    [[nodiscard]] std::filesystem::path file(const char* name) const {
        return folder_.filePath(name).toStdString();
    }
    [[nodiscard]] std::filesystem::path written(const QByteArray& text) const {
        QFile out(folder_.filePath("given.mtx"));
        if (out.open(QIODevice::WriteOnly)) {
            out.write(text);
        }
        return file("given.mtx");
    }
    QTemporaryDir folder_;
};

void MatrixFileTest::both_formats_keep_every_bit_data() {
    QTest::addColumn<SparseMatrix>("matrix");
    QTest::newRow("small") << sample();
    QTest::newRow("large") << large();
    QTest::newRow("no entries") << SparseMatrix(3, 2);
    QTest::newRow("no rows") << SparseMatrix(0, 5);
    QTest::newRow("no columns") << SparseMatrix(5, 0);
    QTest::newRow("nothing at all") << SparseMatrix(0, 0);
}

void MatrixFileTest::both_formats_keep_every_bit() {
    QFETCH(SparseMatrix, matrix);
    write_matrix(file("a.mtx"), matrix);
    QVERIFY(same_bits(read_matrix_market(file("a.mtx")), matrix));
    write_matrix(file("a.petsc"), matrix);
    QVERIFY(same_bits(read_petsc_matrix(file("a.petsc")), matrix));
}

void MatrixFileTest::petsc_matrices_are_big_endian() {
    write_matrix(file("a.petsc"), sample());
    // Header of 4, 3 row lengths, 3 columns, 3 doubles; 1.0 is 3f f0 00 ...
    const QByteArray bytes = bytes_of(file("a.petsc"));
    QCOMPARE(bytes.size(), qsizetype(4 * (4 + 3 + 3) + 3 * 8));
    QCOMPARE(bytes.left(16).toHex(), QByteArray("00127b50000000030000000200000003"));
    QCOMPARE(bytes.mid(16, 12).toHex(), QByteArray("000000010000000200000000"));
    QCOMPARE(bytes.mid(40, 8).toHex(), QByteArray("3ff0000000000000"));
}

void MatrixFileTest::petsc_vectors_are_big_endian() {
    write_petsc_vector(file("b.petsc"), Vector{{1.0, -2.0}});
    QCOMPARE(bytes_of(file("b.petsc")).toHex(),
             QByteArray("00127b4e000000023ff0000000000000c000000000000000"));
    write_petsc_vector(file("b.petsc"), Vector());
    QCOMPARE(bytes_of(file("b.petsc")).toHex(), QByteArray("00127b4e00000000"));
}

void MatrixFileTest::rows_with_room_to_grow_are_written_without_it() {
    SparseMatrix roomy(3, 2);
    roomy.reserve(Eigen::VectorXi::Constant(3, 4));
    roomy.insert(0, 0) = 1;
    roomy.insert(1, 0) = 0.1;
    roomy.insert(1, 1) = 1.0 / 3;
    QVERIFY(!roomy.isCompressed());
    write_matrix(file("a.petsc"), roomy);
    QVERIFY(same_bits(read_petsc_matrix(file("a.petsc")), sample()));
    write_matrix(file("a.mtx"), roomy);
    QVERIFY(same_bits(read_matrix_market(file("a.mtx")), sample()));
}

void MatrixFileTest::files_of_others_are_read() {
    const auto path = written("%%MatrixMarket matrix coordinate real general\r\n% a comment\r\n\r\n"
                              "3 2 3\r\n2 2\t3.3333333333333331e-01\r\n 1 1 +1.0E+00 \r\n2 1 .1");
    QVERIFY(same_bits(read_matrix_market(path), sample()));
}

void MatrixFileTest::a_damaged_file_is_refused_by_line_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("place");
    const QByteArray banner = "%%MatrixMarket matrix coordinate real general\n";
    QTest::newRow("empty") << QByteArray() << QByteArray("line 1:");
    QTest::newRow("complex") << QByteArray(
                                    "%%MatrixMarket matrix coordinate complex general\n1 1 0\n")
                             << QByteArray("line 1:");
    QTest::newRow("no size") << banner + "% nothing\n" << QByteArray("line 3:");
    QTest::newRow("negative size") << banner + "2 -2 2\n" << QByteArray("line 2:");
    QTest::newRow("too large") << banner + "3000000000 2 0\n" << QByteArray("line 2:");
    QTest::newRow("truncated") << banner + "2 2 2\n1 1 0.5\n" << QByteArray("line 4:");
    QTest::newRow("too many") << banner + "2 2 1\n1 1 0.5\n2 2 1\n" << QByteArray("line 4:");
    QTest::newRow("row 0") << banner + "2 2 1\n0 1 0.5\n" << QByteArray("line 3:");
    QTest::newRow("row outside") << banner + "2 2 1\n3 1 0.5\n" << QByteArray("line 3:");
    QTest::newRow("column outside") << banner + "2 2 1\n1 3 0.5\n" << QByteArray("line 3:");
    QTest::newRow("no number") << banner + "2 2 1\n1 1 a\n" << QByteArray("line 3:");
    QTest::newRow("a fourth number") << banner + "2 2 1\n1 1 1 1\n" << QByteArray("line 3:");
}

void MatrixFileTest::a_damaged_file_is_refused_by_line() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, place);
    try {
        (void)read_matrix_market(written(text));
        QFAIL("was read");
    } catch (const InputError& e) {
        QVERIFY2(QByteArray(e.what()).contains(place), e.what());
        QVERIFY2(QByteArray(e.what()).contains("given.mtx"), e.what());
    }
}

void MatrixFileTest::a_missing_file_is_refused() {
    QVERIFY_THROWS_EXCEPTION(FileError, (void)read_matrix_market(file("none.mtx")));
    QVERIFY_THROWS_EXCEPTION(FileError, write_matrix(file("none/a.mtx"), sample()));
}

void MatrixFileTest::an_unknown_suffix_is_refused() {
    QVERIFY_THROWS_EXCEPTION(UsageError, write_matrix(file("a.txt"), sample()));
    QVERIFY(!std::filesystem::exists(file("a.txt")));
}

void MatrixFileTest::nothing_but_the_file_is_left_in_the_folder() {
    const QTemporaryDir empty;
    write_matrix(empty.filePath("a.mtx").toStdString(), large());
    write_matrix(empty.filePath("a.petsc").toStdString(), large());
    QCOMPARE(QDir(empty.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             QStringList({"a.mtx", "a.petsc"}));
}

QTEST_APPLESS_MAIN(MatrixFileTest)
#include "matrix_file_test.moc"
