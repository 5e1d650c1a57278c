// SPDX-License-Identifier: AGPL-3.0-or-later
/// The program as a user starts it, with files as arguments, on a real screen.
#include <QGuiApplication>
#include <QImage>
#include <QPixmap>
#include <QProcess>
#include <QScreen>
#include <QTemporaryDir>
#include <QtTest>

class OpenByArgumentTest : public QObject {
    Q_OBJECT
private slots:
    void shows_the_mesh_data();
    void shows_the_mesh();
};

namespace {

QImage screen() {
    return QGuiApplication::primaryScreen()->grabWindow(0).toImage();
}

/// Share of the screen's pixels that are clearly yellow, green or violet: colours of aspect ratios,
/// which nothing but a shown mesh has.
double coloured_share(const QImage& image) {
    qint64 coloured = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            coloured += c.hsvSaturation() > 90 && c.value() > 50;
        }
    }
    return static_cast<double>(coloured) / (image.width() * image.height());
}

} // namespace

void OpenByArgumentTest::shows_the_mesh_data() {
    QTest::addColumn<QStringList>("words");
    QTest::newRow("the command window") << QStringList{"window"};
    QTest::newRow("the file alone") << QStringList();
}

void OpenByArgumentTest::shows_the_mesh() {
    QFETCH(QStringList, words);
    const QTemporaryDir folder;
    const QString mesh = folder.filePath("layer.meshb");
    QCOMPARE(QProcess::execute(AMECO_PROGRAM,
                               {"case", "layer", "--nx", "6", "--ny", "6", "-q", "-o", mesh}),
             0);
    QVERIFY2(coloured_share(screen()) < 0.01, "the screen is empty at the beginning");
    QProcess program;
    program.start(AMECO_PROGRAM, words + QStringList{mesh});
    QVERIFY(program.waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(coloured_share(screen()) > 0.05, 60000);
    QCOMPARE(program.state(), QProcess::Running);
    program.terminate();
    QVERIFY(program.waitForFinished());
    QTRY_VERIFY(coloured_share(screen()) < 0.01);
}

QTEST_MAIN(OpenByArgumentTest)
#include "open_by_argument_test.moc"
