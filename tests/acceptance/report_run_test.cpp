// SPDX-License-Identifier: AGPL-3.0-or-later
/// ameco report, and the page in a browser.
#include "tests/acceptance/run_ameco.h"

#include <QImage>
#include <QRegularExpression>
#include <QStandardPaths>

using namespace ameco::test;

class ReportRunTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void writes_a_page_tables_and_pictures();
    void gives_the_same_bytes_without_times();
    void works_in_two_dimensions();
    void refuses_data();
    void refuses();
    void a_browser_shows_it_without_a_complaint_or_a_request();

private:
    Workspace here_;
};

void ReportRunTest::initTestCase() {
    QCOMPARE(here_.ameco({"case", "layer", "--nx", "8", "--ny", "8", "-o", "layer.meshb"}).code, 0);
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "levels", "-n", "3"}).code, 0);
}

void ReportRunTest::writes_a_page_tables_and_pictures() {
    const Run run = here_.ameco({"report", "levels", "-o", "out.html"});
    QVERIFY2(run.code == 0, run.text());
    const QStringList files{"out.html",           "out_levels.csv",    "out_classes.csv",
                            "out_quality.csv",    "out_histogram.svg", "out_layers.svg",
                            "out_convergence.svg"};
    QCOMPARE(run.out.trimmed().split('\n'), files);
    const QByteArray page = here_.content("out.html");
    QVERIFY(page.contains("id=\"multigrid\"") && page.contains("id=\"times\""));
    const auto json = nlohmann::json::parse(here_.content("levels/hierarchy.json").toStdString());
    const QList<QByteArray> rows = here_.content("out_levels.csv").trimmed().split('\n');
    QCOMPARE(rows.size(), qsizetype{5});
    for (qsizetype k = 0; k < 4; ++k) {
        QCOMPARE(rows[k + 1].split(',')[1].toInt(),
                 json["levels"][static_cast<std::size_t>(k)]["nodes"].get<int>());
    }
}

void ReportRunTest::gives_the_same_bytes_without_times() {
    QByteArray first;
    for (const QString threads : {"1", "2"}) {
        const Run run = here_.ameco(
            {"report", "levels", "-o", "same.html", "--no-times", "--threads", threads});
        QVERIFY2(run.code == 0, run.text());
        const QByteArray page = here_.content("same.html");
        QVERIFY(!page.contains("id=\"times\""));
        QVERIFY(first.isEmpty() || first == page);
        first = page;
    }
}

void ReportRunTest::works_in_two_dimensions() {
    QCOMPARE(here_.ameco({"case", "layer", "--dim", "2", "-o", "flat.meshb"}).code, 0);
    QCOMPARE(here_.ameco({"coarsen", "flat.meshb", "-o", "flat", "-n", "2"}).code, 0);
    const Run run = here_.ameco({"report", "flat", "-o", "flat.html"});
    QVERIFY2(run.code == 0, run.text());
    QVERIFY(here_.content("flat.html").contains(">triangles</th>"));
}

void ReportRunTest::refuses_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("part");
    QTest::newRow("no folder") << QStringList{"report", "nowhere", "-o", "a.html"} << 4
                               << "nowhere";
    QTest::newRow("no page") << QStringList{"report", "levels", "-o", "a.pdf"} << 2 << ".html";
    QTest::newRow("no place") << QStringList{"report", "levels", "-o", "no/a.html"} << 4 << "no";
}

void ReportRunTest::refuses() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, part);
    const Run run = here_.ameco(arguments);
    QVERIFY2(run.code == code, run.text());
    QVERIFY2(run.err.contains(part), run.text());
}

void ReportRunTest::a_browser_shows_it_without_a_complaint_or_a_request() {
    const QString chromium = QStandardPaths::findExecutable("chromium");
    if (chromium.isEmpty()) {
        QSKIP("chromium is not installed");
    }
    const QStringList quiet{"--headless",
                            "--no-sandbox",
                            "--disable-gpu",
                            "--disable-dev-shm-usage",
                            "--disable-quic",
                            "--no-first-run",
                            "--disable-background-networking",
                            "--disable-component-update",
                            "--disable-sync",
                            "--hide-scrollbars",
                            "--user-data-dir=" + here_.path("profile")};
    // A machine on which the browser shows nothing at all says nothing about our page.
    QProcess probe;
    probe.start(chromium, quiet + QStringList{"--dump-dom", "data:text/html,<p>here</p>"});
    if (!probe.waitForFinished(60000) || !probe.readAllStandardOutput().contains("<p>here</p>")) {
        probe.kill();
        probe.waitForFinished();
        QSKIP("chromium does not run on this machine");
    }
    QVERIFY(here_.ameco({"report", "levels", "-o", "shown.html"}).code == 0);
    QProcess browser;
    browser.setWorkingDirectory(here_.path());
    browser.start(chromium,
                  quiet + QStringList{"--enable-logging=stderr", "--window-size=1280,3000",
                                      "--screenshot=" + here_.path("shown.png"),
                                      "--log-net-log=" + here_.path("net.json"),
                                      "file://" + here_.path("shown.html")});
    QVERIFY2(browser.waitForFinished(120000), "chromium does not end");
    const QByteArray log = browser.readAllStandardError();
    QVERIFY2(!log.contains(":CONSOLE"), log.constData());
    // Nothing is asked for but the page itself and, by the browser on its own account, its maker.
    const QString requests = QString::fromUtf8(here_.content("net.json"));
    const QRegularExpression request("\"url\":\"(https?://([^/\"]*)[^\"]*)\"");
    for (auto it = request.globalMatch(requests); it.hasNext();) {
        const auto match = it.next();
        QVERIFY2(match.captured(2).endsWith(".google.com") ||
                     match.captured(2).endsWith(".googleapis.com"),
                 qPrintable(match.captured(1)));
    }
    const QImage picture(here_.path("shown.png"));
    QCOMPARE(picture.size(), QSize(1280, 3000));
    // Bars in the first levels' colours: the histogram is there.
    int bars = 0;
    for (int y = 0; y < picture.height(); y += 2) {
        for (int x = 0; x < picture.width(); x += 2) {
            bars += picture.pixelColor(x, y) == QColor("#1f4e79") ||
                    picture.pixelColor(x, y) == QColor("#d95f02");
        }
    }
    QVERIFY2(bars > 500, qPrintable(QString::number(bars)));
}

QTEST_GUILESS_MAIN(ReportRunTest)
#include "report_run_test.moc"
