// SPDX-License-Identifier: AGPL-3.0-or-later
/// scripts/reproduce on small meshes; and the page that it has put into the manual.
#include "tests/acceptance/run_ameco.h"

#include <QRegularExpression>
#include <QXmlStreamReader>

using namespace ameco::test;

namespace {

constexpr int steps = 8;

/// Files that a page shows as pictures, relative to it.
QStringList pictures_of(const QByteArray& page) {
    static const QRegularExpression link(R"(!\[[^\]]+\]\(([^)]+)\))");
    QStringList files;
    for (auto hits = link.globalMatch(QString::fromUtf8(page)); hits.hasNext();) {
        files << hits.next().captured(1);
    }
    return files;
}

/// What is wrong with a picture, or "".
QString fault_of(const QString& path) {
    const QByteArray bytes = content_of(path);
    if (path.endsWith(".png")) {
        return bytes.startsWith("\x89PNG") ? "" : path + " is no PNG";
    }
    QXmlStreamReader xml(bytes);
    while (!xml.atEnd()) {
        xml.readNext();
    }
    return xml.hasError() ? path + ": " + xml.errorString() : "";
}

/// 32772 is 32,772.
QByteArray with_commas(qlonglong number) {
    return QLocale(QLocale::English, QLocale::UnitedStates).toString(number).toUtf8();
}

} // namespace

class ReproduceTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void every_figure_on_the_page_is_there_and_can_be_read();
    void the_page_has_the_papers_numbers_beside_ours();
    void the_box_loses_its_middle_layer_in_every_variant();
    void steps_that_are_there_are_not_made_again();
    void a_step_is_made_alone_and_again_when_the_program_has_changed();
    void small_meshes_do_not_get_into_the_manual();
    void the_manuals_page_has_small_figures_and_links_that_lead_somewhere();

private:
    [[nodiscard]] Run reproduce(const QString& arguments) const {
        return here_.shell("python3 '" AMECO_SOURCE_DIR "/scripts/reproduce' " + arguments);
    }
    [[nodiscard]] nlohmann::ordered_json found(const QString& step) const {
        const QByteArray text = here_.content("out/results/" + step + ".json");
        return nlohmann::ordered_json::parse(text.toStdString()).at("found");
    }

    Workspace here_;
    QByteArray page_;
};

void ReproduceTest::initTestCase() {
    const Run run = reproduce("--quick --program \"$AMECO\" -o out");
    QVERIFY2(run.code == 0, run.text());
    page_ = here_.content("out/reproduction.md");
    QVERIFY(page_.startsWith("# The paper reproduced"));
}

void ReproduceTest::every_figure_on_the_page_is_there_and_can_be_read() {
    const QStringList pictures = pictures_of(page_);
    // Those drawn without OpenGL.
    for (const char* figure :
         {"figure_1.svg", "figure_2_100.svg", "figure_2_1000.svg", "figure_3_100.svg",
          "figure_3_1000.svg", "figures_4_5.svg", "figure_11.svg", "figure_13.svg",
          "figures_12_to_17_layers.svg", "figure_18.svg", "cost.svg"}) {
        QVERIFY2(pictures.contains("pictures/" + QString(figure)), figure);
    }
    for (const QString& picture : pictures) {
        const QString fault = fault_of(here_.path("out/" + picture));
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }
    const auto left_out = page_.count("*(This figure needs OpenGL");
    QCOMPARE(pictures.size() + left_out, 16);
}

void ReproduceTest::the_page_has_the_papers_numbers_beside_ours() {
    for (const char* papers : {"| 30,961 | 2.19 |", "| 8,323 | 1.59 |", "| 779,558 | 2.57 |",
                               "266,356 | 1 |", "| 82,859 |"}) {
        QVERIFY2(page_.contains(papers), papers);
    }
    for (const auto& level : found("m6").at("levels")) {
        const QByteArray nodes = with_commas(level.at("nodes").get<qlonglong>());
        QVERIFY2(page_.contains("| " + nodes + " |"), nodes);
    }
    const auto counts =
        found("falcon-paper").at("levels")[0].at("aspect_ratio").at("classes").at("nodes");
    const QByteArray fifth = "| 98,511 | " + with_commas(counts[4].get<qlonglong>()) + " |";
    QVERIFY2(page_.contains(fifth), fifth);
    QVERIFY(page_.contains("| geodesic-fixed-step | 1, 1.15 | 1, 1.15 | does not converge |"));
}

void ReproduceTest::the_box_loses_its_middle_layer_in_every_variant() {
    const auto rows = found("box").at("rows");
    QCOMPARE(rows.size(), std::size_t{16});
    for (const auto& row : rows) {
        const bool is_solid = row.at("dimension") == 3;
        QCOMPARE(row.at("nodes")[0].get<int>(), is_solid ? 27 : 9);
        QCOMPARE(row.at("nodes")[1].get<int>(), is_solid ? 18 : 6);
        const auto& aspect = row.at("aspect_ratios");
        QVERIFY(std::abs(aspect[0].get<double>() / aspect[1].get<double>() - 2) < 1e-5);
    }
}

void ReproduceTest::steps_that_are_there_are_not_made_again() {
    const Run run = reproduce("--quick --program \"$AMECO\" -o out");
    QVERIFY2(run.code == 0, run.text());
    QCOMPARE(run.out.count("is there already"), steps);
    QCOMPARE(here_.content("out/reproduction.md"), page_);
}

void ReproduceTest::a_step_is_made_alone_and_again_when_the_program_has_changed() {
    const QString make = "--quick --only interface --program \"$PWD/program\" -o alone";
    const QByteArray program = "#!/bin/sh\nexec \"" AMECO_PROGRAM "\" \"$@\"\n";
    here_.write("program", program);
    QFile::setPermissions(here_.path("program"),
                          QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner);
    const Run first = reproduce(make);
    QVERIFY2(first.code == 0, first.text());
    QVERIFY2(first.out.contains("no page yet: means, box, m6"), first.text());
    QCOMPARE(here_.files("alone/results"), QStringList{"interface.json"});
    QVERIFY(!QFile::exists(here_.path("alone/reproduction.md")));
    QVERIFY(reproduce(make).out.contains("interface: is there already"));
    here_.write("program", program + "# another one\n");
    QVERIFY(!reproduce(make).out.contains("is there already"));
}

void ReproduceTest::small_meshes_do_not_get_into_the_manual() {
    const Run run = reproduce("--quick --update-docs --program \"$AMECO\" -o out");
    QCOMPARE(run.code, 1);
    QVERIFY2(run.err.contains("leave out --quick"), run.text());
}

void ReproduceTest::the_manuals_page_has_small_figures_and_links_that_lead_somewhere() {
    const QString docs = AMECO_SOURCE_DIR "/docs/";
    const QByteArray page = content_of(docs + "reproduction.md");
    QVERIFY(!page.contains("--quick`)"));
    const QStringList pictures = pictures_of(page);
    QCOMPARE(pictures.size(), 16);
    for (const QString& picture : pictures) {
        const QString fault = fault_of(docs + picture);
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
        QVERIFY2(QFileInfo(docs + picture).size() < 150'000, qPrintable(picture));
    }
    static const QRegularExpression link(R"(\]\(([^)#]+\.md)(#[^)]*)?\))");
    int links = 0;
    for (auto hits = link.globalMatch(QString::fromUtf8(page)); hits.hasNext(); ++links) {
        const QString target = hits.next().captured(1);
        QVERIFY2(QFile::exists(docs + target), qPrintable(target));
    }
    QVERIFY(links > 0);
}

QTEST_GUILESS_MAIN(ReproduceTest)
#include "reproduce_test.moc"
