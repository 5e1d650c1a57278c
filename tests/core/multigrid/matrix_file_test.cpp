// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/matrix_file.h"

#include "core/base/error.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace ameco;

namespace {

SparseMatrix sample() {
    SparseMatrix m(3, 2);
    m.insert(0, 0) = 1;
    m.insert(1, 0) = 0.1;
    m.insert(1, 1) = 1.0 / 3;
    m.makeCompressed();
    return m;
}

} // namespace

class MatrixFileTest : public QObject {
    Q_OBJECT
private slots:
    void matrix_market_keeps_every_bit();
    void petsc_files_are_big_endian();
    void a_truncated_file_is_refused_by_line();
    void an_unknown_suffix_is_refused();

private:
    [[nodiscard]] std::filesystem::path file(const char* name) const {
        return folder_.filePath(name).toStdString();
    }
    QTemporaryDir folder_;
};

void MatrixFileTest::matrix_market_keeps_every_bit() {
    write_matrix(file("a.mtx"), sample());
    const SparseMatrix back = read_matrix_market(file("a.mtx"));
    QCOMPARE(back.rows(), Eigen::Index(3));
    QCOMPARE(back.nonZeros(), Eigen::Index(3));
    QCOMPARE((back - sample()).norm(), 0.0);
}

void MatrixFileTest::petsc_files_are_big_endian() {
    write_matrix(file("a.petsc"), sample());
    QFile in(folder_.filePath("a.petsc"));
    QVERIFY(in.open(QIODevice::ReadOnly));
    const QByteArray bytes = in.readAll();
    // Header of 4, 3 row lengths, 3 columns, 3 doubles; 1.0 is 3f f0 00 ...
    QCOMPARE(bytes.size(), qsizetype(4 * (4 + 3 + 3) + 3 * 8));
    QCOMPARE(bytes.left(8).toHex(), QByteArray("00127b5000000003"));
    QCOMPARE(bytes.mid(16, 12).toHex(), QByteArray("000000010000000200000000"));
    QCOMPARE(bytes.mid(40, 8).toHex(), QByteArray("3ff0000000000000"));
}

void MatrixFileTest::a_truncated_file_is_refused_by_line() {
    QFile out(folder_.filePath("b.mtx"));
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write("%%MatrixMarket matrix coordinate real general\n2 2 2\n1 1 0.5\n");
    out.close();
    try {
        (void)read_matrix_market(file("b.mtx"));
        QFAIL("was read");
    } catch (const InputError& e) {
        QVERIFY2(std::string(e.what()).find("line 4") != std::string::npos, e.what());
    }
}

void MatrixFileTest::an_unknown_suffix_is_refused() {
    QVERIFY_THROWS_EXCEPTION(UsageError, write_matrix(file("a.txt"), sample()));
}

QTEST_APPLESS_MAIN(MatrixFileTest)
#include "matrix_file_test.moc"
