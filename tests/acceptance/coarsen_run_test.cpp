// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/hierarchy_json.h"
#include "tests/acceptance/run_ameco.h"

using namespace ameco::test;

class CoarsenRunTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void writes_levels_that_check_valid();
    void has_the_defaults_of_the_library();
    void prints_a_row_per_level();
    void prints_the_same_as_json();
    void gives_the_same_bytes_for_any_number_of_threads();
    void works_in_two_dimensions();
    void writes_text_when_asked();
    void writes_the_format_of_a_solver_when_asked();
    void copies_the_input_when_asked();
    void freezes_patches_by_name_and_by_id();
    void keeps_the_boundary_when_asked();
    void moves_nodes_when_asked();
    void leaves_no_folder_behind_when_it_fails();
    void refuses_patches_that_do_not_exist();
    void leaves_a_folder_alone_that_is_in_use();
    void replaces_a_hierarchy_when_forced();
    void goes_on_to_more_levels();
    void starts_anew_from_the_first_damaged_level();
    void resumes_only_what_was_made_alike_data();
    void resumes_only_what_was_made_alike();
    void takes_a_factor_per_level_and_remembers_it();
    void goes_on_until_nothing_is_stretched();
    void chooses_factors_for_a_ratio();
    void writes_transfers_when_asked();
    void adds_and_mends_transfers_on_resuming();
    void says_when_a_mesh_cannot_be_coarsened();
    void reports_progress_to_programs();
    void keeps_what_it_has_when_the_disk_is_full();

private:
    /// All files of a hierarchy but the one with the times.
    [[nodiscard]] QMap<QString, QByteArray> contents(const QString& folder) const;

    Workspace here_;
};

QMap<QString, QByteArray> CoarsenRunTest::contents(const QString& folder) const {
    QMap<QString, QByteArray> all;
    for (const QString& file : here_.files(folder)) {
        if (file != "timing.json") {
            all[file] = here_.content(folder + "/" + file);
        }
    }
    return all;
}

void CoarsenRunTest::initTestCase() {
    QCOMPARE(
        here_.ameco({"case", "layer", "--nx", "8", "--ny", "8", "--nz", "16", "-o", "layer.meshb"})
            .code,
        0);
    const Run run = here_.ameco({"coarsen", "layer.meshb", "-o", "all", "--levels", "3"});
    QVERIFY2(run.code == 0, run.text());
}

void CoarsenRunTest::writes_levels_that_check_valid() {
    QCOMPARE(broken_part_of(here_, "all"), QString());
    const auto json =
        nlohmann::ordered_json::parse(here_.content("all/hierarchy.json").toStdString());
    QCOMPARE(json.at("status").get<std::string>(), std::string("complete"));
    QCOMPARE(json.at("levels").size(), std::size_t{4});
    for (std::size_t k = 1; k < 4; ++k) {
        QVERIFY(json.at("levels").at(k).at("ratio").get<double>() > 1.05);
    }
    QCOMPARE(here_.files("all"),
             (QStringList{"hierarchy.json", "level_1.meshb", "level_2.meshb", "level_3.meshb",
                          "metric_0.solb", "metric_1.solb", "metric_2.solb", "metric_3.solb",
                          "state_1.cbor", "state_2.cbor", "state_3.cbor", "timing.json"}));
}

void CoarsenRunTest::has_the_defaults_of_the_library() {
    using Json = nlohmann::json;
    const Json made = Json::parse(here_.content("all/hierarchy.json").toStdString());
    Json settings = Json::parse(ameco::hierarchy_text({}))["settings"];
    settings["levels"] = 3;
    QCOMPARE(made["settings"].dump(2), settings.dump(2));
}

void CoarsenRunTest::prints_a_row_per_level() {
    const Run run = here_.ameco({"coarsen", "layer.meshb", "-o", "rows", "--levels", "2", "-v"});
    QCOMPARE(run.code, 0);
    const QStringList lines = run.out.split('\n');
    QVERIFY2(lines.at(0).startsWith("level      nodes        tets  ratio"), run.text());
    for (int k = 0; k < 3; ++k) {
        QVERIFY2(lines.at(1 + k).startsWith("    " + QString::number(k) + " "), run.text());
    }
    QVERIFY2(run.out.contains("\nnodes by aspect ratio\n"), run.text());
    QVERIFY2(run.out.contains("\n  accepted "), run.text());
    QVERIFY2(run.out.contains("\nrows: 2 coarser levels, grid complexity "), run.text());
}

void CoarsenRunTest::prints_the_same_as_json() {
    const Run run = here_.ameco({"coarsen", "layer.meshb", "-o", "json", "--json"});
    QCOMPARE(run.code, 0);
    const auto json = run.json();
    QCOMPARE(json.at("hierarchy").dump(2) + "\n",
             here_.content("json/hierarchy.json").toStdString());
    QCOMPARE(json.at("timing").at("levels").size(), json.at("hierarchy").at("levels").size());
}

void CoarsenRunTest::gives_the_same_bytes_for_any_number_of_threads() {
    for (const char* threads : {"1", "2", "5"}) {
        const QString folder = QString("threads_") + threads;
        QCOMPARE(here_
                     .ameco({"coarsen", "layer.meshb", "-o", folder, "--levels", "3", "--threads",
                             threads})
                     .code,
                 0);
        QVERIFY2(contents(folder) == contents("all"), threads);
    }
}

void CoarsenRunTest::works_in_two_dimensions() {
    QCOMPARE(here_.ameco({"case", "model-layer", "-o", "flat.mesh"}).code, 0);
    const Run run = here_.ameco({"coarsen", "flat.mesh", "-o", "flat", "--levels", "2"});
    QVERIFY2(run.code == 0, run.text());
    QVERIFY2(run.out.contains("triangles"), run.text());
    QCOMPARE(broken_part_of(here_, "flat"), QString());
}

void CoarsenRunTest::writes_text_when_asked() {
    QCOMPARE(
        here_.ameco({"coarsen", "layer.meshb", "-o", "text", "--format", "mesh", "-n", "1"}).code,
        0);
    QVERIFY(here_.content("text/level_1.mesh").startsWith("MeshVersionFormatted"));
    QVERIFY(here_.content("text/metric_1.sol").startsWith("MeshVersionFormatted"));
    QCOMPARE(here_.ameco({"convert", "text/level_1.mesh", "level_1.meshb"}).code, 0);
    QCOMPARE(here_.content("level_1.meshb"), here_.content("all/level_1.meshb"));
}

void CoarsenRunTest::writes_the_format_of_a_solver_when_asked() {
    const QStringList arguments{"coarsen",  "layer.meshb", "-o",       "solver",
                                "--levels", "1",           "--format", "dimeco"};
    const Run run = here_.ameco(arguments);
    QCOMPARE(run.code, 0);
    QVERIFY2(run.err.contains("--format dimeco: left out, since AMeCo cannot hold them: names of"),
             run.text());
    QCOMPARE(run.err.count("left out"), 1); // not once a level
    QCOMPARE(here_.ameco({"check", "solver/level_1.dimeco"}).code, 0);
    // Level 1 stays as it is, level 2 is added; other commands go on working.
    QStringList more = arguments;
    more[5] = "2";
    QCOMPARE(here_.ameco(more + QStringList{"--resume"}).code, 0);
    QVERIFY(here_.files("solver").contains("level_2.dimeco"));
    QCOMPARE(here_.ameco({"convert", "solver", "su2", "--to", "su2"}).code, 0);
    QCOMPARE(here_.ameco({"check", "su2/level_2.su2"}).code, 0);
    QCOMPARE(here_.ameco({"multigrid", "solver"}).code, 0);
}

void CoarsenRunTest::copies_the_input_when_asked() {
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "copy", "--copy-input", "-n", "1"}).code,
             0);
    QCOMPARE(here_.content("copy/level_0.meshb"), here_.content("layer.meshb"));
    // The folder is complete: it can be moved.
    QVERIFY(QDir().rename(here_.path("copy"), here_.path("moved")));
    QCOMPARE(broken_part_of(here_, "moved"), QString());
}

void CoarsenRunTest::freezes_patches_by_name_and_by_id() {
    QCOMPARE(here_.ameco({"case", "cube", "--n", "6", "-o", "cube.meshb"}).code, 0);
    const auto faces = [this](const QString& mesh, std::size_t patch) {
        const auto info = here_.ameco({"info", mesh, "--json"}).json().at(0);
        return info.at("patches").at(patch).at("faces").get<int>();
    };
    QCOMPARE(
        here_.ameco({"coarsen", "cube.meshb", "-o", "named", "-n", "1", "--freeze", "bottom"}).code,
        0);
    QCOMPARE(
        here_.ameco({"coarsen", "cube.meshb", "-o", "numbered", "-n", "1", "--freeze", "1"}).code,
        0);
    QCOMPARE(contents("named"), contents("numbered"));
    QCOMPARE(faces("named/level_1.meshb", 0), faces("cube.meshb", 0));
    QVERIFY(faces("named/level_1.meshb", 1) < faces("cube.meshb", 1));
}

void CoarsenRunTest::keeps_the_boundary_when_asked() {
    QCOMPARE(here_.ameco({"case", "cube", "--n", "6", "-o", "cube.meshb"}).code, 0);
    const QStringList keep{"coarsen", "cube.meshb", "--boundary", "keep", "-o"};
    const Run run = here_.ameco(keep + QStringList{"kept", "-n", "2", "--json"});
    QVERIFY2(run.code == 0, run.text());
    const auto levels = run.json().at("hierarchy").at("levels");
    for (const auto& level : levels) {
        QCOMPARE(level.at("boundary_faces").get<int>(), 6 * 6 * 6 * 2);
    }
    QVERIFY(levels.at(1).at("nodes").get<int>() < levels.at(0).at("nodes").get<int>());
    // What was decided on the finest level holds for a level that is made later.
    QCOMPARE(here_.ameco(keep + QStringList{"kept_later", "-n", "1"}).code, 0);
    QCOMPARE(here_.ameco(keep + QStringList{"kept_later", "-n", "2", "--resume"}).code, 0);
    QCOMPARE(contents("kept_later"), contents("kept"));
    const Run other = here_.ameco({"coarsen", "cube.meshb", "-o", "kept", "-n", "3", "--resume"});
    QVERIFY2(other.code == 2 && other.err.contains("other settings (boundary)"), other.text());
}

void CoarsenRunTest::moves_nodes_when_asked() {
    QCOMPARE(here_.ameco({"case", "cube", "--n", "10", "-o", "for_moves.meshb"}).code, 0);
    const auto run = [&](const QString& folder, const QStringList& more) {
        return here_.ameco(
            QStringList{"coarsen", "for_moves.meshb", "--transfer", "-o", folder, "--json"} + more);
    };
    const auto nested = run("nested_nodes", {"-n", "2"});
    const auto moved = run("moved_nodes", {"-n", "2", "--nodes", "moved"});
    QVERIFY2(moved.code == 0, moved.text());
    const auto level_of = [](const Run& r) { return r.json().at("hierarchy").at("levels").at(1); };
    QCOMPARE(level_of(moved).at("nodes"), level_of(nested).at("nodes"));
    QVERIFY(level_of(moved).at("conformity").at("in_band").get<double>() >
            level_of(nested).at("conformity").at("in_band").get<double>());
    QVERIFY(level_of(moved).at("verdicts").at("moves").at("accepted").get<int>() > 0);
    QVERIFY(here_.content("moved_nodes/parent_0.txt").contains("\n-1\n"));
    QVERIFY(!here_.content("nested_nodes/parent_0.txt").contains("\n-1\n"));
    QCOMPARE(here_.ameco({"multigrid", "moved_nodes"}).code, 0);
    // Interrupted and continued, the levels are the same.
    QCOMPARE(run("moved_later", {"-n", "1", "--nodes", "moved"}).code, 0);
    QCOMPARE(run("moved_later", {"-n", "2", "--nodes", "moved", "--resume"}).code, 0);
    QCOMPARE(contents("moved_later"), contents("moved_nodes"));
    const Run other = run("moved_later", {"-n", "3", "--resume"});
    QVERIFY2(other.code == 2 && other.err.contains("other settings (nodes)"), other.text());
}

void CoarsenRunTest::leaves_no_folder_behind_when_it_fails() {
    // Refused before anything is made; failed while the first files were written.
    QCOMPARE(here_
                 .ameco({"coarsen", "layer.meshb", "-o", "begun", "--rebuild", "tetgen", "--factor",
                         "4"})
                 .code,
             2);
    QVERIFY(!QFile::exists(here_.path("begun")));
    const Run full = here_.shell("trap '' XFSZ; ulimit -f 8; "
                                 "exec \"$AMECO\" coarsen layer.meshb -o begun");
    QVERIFY2(full.code == 4, full.text());
    QVERIFY(!QFile::exists(here_.path("begun")));
    // A refusal leaves the hierarchy alone that it would have replaced.
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "held", "-n", "1"}).code, 0);
    const auto before = contents("held");
    QCOMPARE(here_
                 .ameco({"coarsen", "layer.meshb", "-o", "held", "--force", "--rebuild", "tetgen",
                         "--target-ratio", "3"})
                 .code,
             2);
    QCOMPARE(contents("held"), before);
}

void CoarsenRunTest::refuses_patches_that_do_not_exist() {
    const Run run = here_.ameco({"coarsen", "layer.meshb", "-o", "none", "--freeze", "no-such"});
    QCOMPARE(run.code, 2);
    QVERIFY2(run.err.startsWith("ameco: --freeze no-such: the mesh has no such patch"), run.text());
    QVERIFY(!QFile::exists(here_.path("none")));
}

void CoarsenRunTest::leaves_a_folder_alone_that_is_in_use() {
    const auto before = contents("all");
    const Run again = here_.ameco({"coarsen", "layer.meshb", "-o", "all"});
    QCOMPARE(again.code, 2);
    QVERIFY2(again.err.contains("--resume") && again.err.contains("--force"), again.text());
    QVERIFY(contents("all") == before);
    QDir().mkpath(here_.path("mine"));
    here_.write("mine/notes.txt", "mine");
    const Run mine = here_.ameco({"coarsen", "layer.meshb", "-o", "mine"});
    QCOMPARE(mine.code, 2);
    QCOMPARE(here_.files("mine"), QStringList{"notes.txt"});
}

void CoarsenRunTest::replaces_a_hierarchy_when_forced() {
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "old", "-n", "3"}).code, 0);
    here_.write("old/notes.txt", "mine");
    QCOMPARE(
        here_.ameco({"coarsen", "layer.meshb", "-o", "old", "-n", "1", "--slack", "1", "--force"})
            .code,
        0);
    QVERIFY(!QFile::exists(here_.path("old/level_3.meshb")));
    QCOMPARE(here_.content("old/notes.txt"), QByteArray("mine"));
    QCOMPARE(broken_part_of(here_, "old"), QString());
}

void CoarsenRunTest::goes_on_to_more_levels() {
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "more", "-n", "1"}).code, 0);
    const Run run = here_.ameco({"coarsen", "layer.meshb", "-o", "more", "-n", "3", "--resume"});
    QVERIFY2(run.code == 0, run.text());
    QVERIFY(contents("more") == contents("all"));
    // Nothing is left to do, and nothing changes.
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "more", "-n", "3", "--resume"}).code, 0);
    QVERIFY(contents("more") == contents("all"));
}

void CoarsenRunTest::starts_anew_from_the_first_damaged_level() {
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "hurt", "-n", "3"}).code, 0);
    here_.write("hurt/level_2.meshb", "cut");
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "hurt", "-n", "3", "--resume"}).code, 0);
    QVERIFY(contents("hurt") == contents("all"));
}

void CoarsenRunTest::resumes_only_what_was_made_alike_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("complaint");
    QTest::newRow("settings") << QStringList{"layer.meshb", "--factor", "3"}
                              << "other settings (factor)";
    QTest::newRow("mesh") << QStringList{"other.meshb"} << "another mesh";
}

void CoarsenRunTest::resumes_only_what_was_made_alike() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, complaint);
    QCOMPARE(here_.ameco({"case", "cube", "-o", "other.meshb", "--n", "3"}).code, 0);
    const auto before = contents("all");
    const Run run = here_.ameco(QStringList{"coarsen", "-o", "all", "--resume"} + arguments);
    QVERIFY2(run.code == 2 && run.err.contains(complaint), run.text());
    QVERIFY(contents("all") == before);
}

void CoarsenRunTest::takes_a_factor_per_level_and_remembers_it() {
    const QStringList command{"coarsen", "layer.meshb", "-o", "factors", "--factor", "1.9,2.1"};
    QCOMPARE(here_.ameco(command + QStringList{"--levels", "2"}).code, 0);
    const Run more = here_.ameco(command + QStringList{"--levels", "3", "--resume", "--json"});
    QVERIFY2(more.code == 0, more.text());
    const auto levels = more.json().at("hierarchy").at("levels");
    QCOMPARE(levels.size(), std::size_t{4});
    QCOMPARE(levels.at(1).at("factor").get<double>(), 1.9);
    QCOMPARE(levels.at(2).at("factor").get<double>(), 2.1);
    QCOMPARE(levels.at(3).at("factor").get<double>(), 2.1);
    const Run other = here_.ameco({"coarsen", "layer.meshb", "-o", "factors", "--factor", "1.9,2",
                                   "--levels", "3", "--resume"});
    QVERIFY2(other.code == 2 && other.err.contains("factors"), other.text());
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "none", "--factor", "2,1"}).code, 2);
}

void CoarsenRunTest::goes_on_until_nothing_is_stretched() {
    const QStringList layer{"case", "layer",    "--dim",          "2",  "--nx",     "24",
                            "--nz", "32",       "--aspect-ratio", "16", "--growth", "1",
                            "-o",   "flat.mesh"};
    QCOMPARE(here_.ameco(layer).code, 0);
    const QStringList command{"coarsen", "flat.mesh", "-o", "until", "--until-isotropic", "--json"};
    const Run run = here_.ameco(command);
    QVERIFY2(run.code == 0, run.text());
    const auto levels = run.json().at("hierarchy").at("levels");
    QVERIFY(levels.size() >= 3 && levels.size() <= 5);
    const auto share = [&](std::size_t k) {
        return levels.at(k).at("aspect_ratio").at("share_below_5").get<double>();
    };
    QVERIFY(share(levels.size() - 1) >= 0.95);
    QVERIFY(share(levels.size() - 2) < 0.95);
    const Run again = here_.ameco(command + QStringList{"--resume"}); // nothing is left to do
    QCOMPARE(again.code, 0);
    QCOMPARE(again.json().at("hierarchy").at("levels").size(), levels.size());
}

void CoarsenRunTest::chooses_factors_for_a_ratio() {
    QCOMPARE(
        here_
            .ameco({"coarsen", "layer.meshb", "-o", "both", "--target-ratio", "2", "--factor", "2"})
            .code,
        2);
    const Run run = here_.ameco({"coarsen", "layer.meshb", "-o", "ratio", "--target-ratio", "1.85",
                                 "--levels", "1", "--json"});
    QVERIFY2(run.code == 0, run.text());
    const double ratio = run.json().at("hierarchy").at("levels").at(1).at("ratio").get<double>();
    const bool told = run.err.contains("not the 1.85 asked for");
    QVERIFY2((std::abs(ratio / 1.85 - 1) <= 0.05) != told, run.text());
}

void CoarsenRunTest::writes_transfers_when_asked() {
    const Run run =
        here_.ameco({"coarsen", "layer.meshb", "-o", "transfers", "-n", "2", "--transfer"});
    QVERIFY2(run.code == 0, run.text());
    const auto json =
        nlohmann::json::parse(here_.content("transfers/hierarchy.json").toStdString());
    QVERIFY(!json["levels"][0].contains("transfer"));
    for (int k = 0; k < 2; ++k) {
        const auto transfer = json["levels"][static_cast<std::size_t>(k) + 1]["transfer"];
        const QString number = QString::number(k);
        QCOMPARE(transfer["matrix"]["file"].get<std::string>(),
                 ("P_" + number + ".mtx").toStdString());
        // The same as the command for two meshes makes.
        const QString fine = k == 0 ? "layer.meshb" : "transfers/level_1.meshb";
        const QString coarse = QString("transfers/level_%1.meshb").arg(k + 1);
        for (const QString suffix : {".mtx", ".petsc"}) {
            const Run alone = here_.ameco({"transfer", fine, coarse, "-o", "alone" + suffix});
            QVERIFY2(alone.code == 0, alone.text());
            QCOMPARE(here_.content("transfers/P_" + number + suffix),
                     here_.content("alone" + suffix));
        }
        // A line per coarse node, each the number of a fine node; in layers all are.
        const QList<QByteArray> parents =
            here_.content("transfers/parent_" + number + ".txt").trimmed().split('\n');
        QVERIFY(parents[0].startsWith("# "));
        const auto& levels = json["levels"];
        const auto level = static_cast<std::size_t>(k);
        QCOMPARE(parents.size() - 1, levels[level + 1]["nodes"].get<qsizetype>());
        for (const QByteArray& parent : parents.mid(1)) {
            QVERIFY(parent.toInt() >= 0 && parent.toInt() < levels[level]["nodes"].get<int>());
        }
        QCOMPARE(transfer["nested"].get<qsizetype>(), parents.size() - 1);
    }
}

void CoarsenRunTest::adds_and_mends_transfers_on_resuming() {
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "later", "-n", "1"}).code, 0);
    const QStringList resume{"coarsen", "layer.meshb", "-o",       "later",
                             "-n",      "2",           "--resume", "--transfer"};
    QVERIFY2(here_.ameco(resume).code == 0, "resumed with transfers");
    QCOMPARE(contents("later"), contents("transfers"));
    here_.write("later/P_0.mtx", "damaged");
    QVERIFY2(here_.ameco(resume).code == 0, "resumed with a damaged transfer");
    QCOMPARE(contents("later"), contents("transfers"));
}

void CoarsenRunTest::says_when_a_mesh_cannot_be_coarsened() {
    QCOMPARE(here_.ameco({"case", "cube", "--n", "1", "-o", "corners.meshb"}).code, 0);
    const Run none = here_.ameco({"coarsen", "corners.meshb", "-o", "corners"});
    QVERIFY2(none.code == 3, none.text());
    QVERIFY2(none.err.contains("level 1 would have kept 8 of 8 nodes"), none.text());
    QCOMPARE(here_.ameco({"case", "cube", "--n", "4", "-o", "small.meshb"}).code, 0);
    const Run some = here_.ameco({"coarsen", "small.meshb", "-o", "small", "-n", "50"});
    QVERIFY2(some.code == 0, some.text());
    QVERIFY2(some.err.contains("the mesh cannot be coarsened further"), some.text());
    QCOMPARE(broken_part_of(here_, "small"), QString());
}

void CoarsenRunTest::reports_progress_to_programs() {
    const Run run = here_.ameco({"coarsen", "layer.meshb", "-o", "progress", "--progress", "json"});
    QCOMPARE(run.code, 0);
    double last = 0;
    int lines = 0;
    for (const QString& line : run.err.split('\n', Qt::SkipEmptyParts)) {
        const auto json = nlohmann::json::parse(line.toStdString());
        const double progress = json.at("progress").get<double>();
        QVERIFY2(progress >= last && progress <= 1, run.text());
        last = progress;
        ++lines;
    }
    QVERIFY(lines > 0);
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "quiet", "-q"}).err, QString());
}

void CoarsenRunTest::keeps_what_it_has_when_the_disk_is_full() {
    // A level 1 of about 80 kB may be written, the metric of level 0 (200 kB) may not: then a limit
    // in between ends the run at a known place.
    const auto size = QFile(here_.path("all/metric_0.solb")).size();
    const QString limit = QString::number(size / 512 / 2);
    const Run run = here_.shell("trap '' XFSZ; ulimit -f " + limit +
                                "; exec \"$AMECO\" coarsen layer.meshb -o full");
    QVERIFY2(run.code == 4 && run.err.startsWith("ameco: full/"), run.text());
    QVERIFY(!QFile::exists(here_.path("full"))); // nothing was made
    const Run resumed =
        here_.ameco({"coarsen", "layer.meshb", "-o", "full", "-n", "3", "--resume"});
    QVERIFY2(resumed.code == 0, resumed.text());
    QVERIFY(contents("full") == contents("all"));
}

QTEST_GUILESS_MAIN(CoarsenRunTest)
#include "coarsen_run_test.moc"
