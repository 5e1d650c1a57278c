// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/hierarchy_folder.h"

#include "core/base/error.h"
#include "core/io/io.h"
#include "tests/core/hierarchy/hierarchy_support.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ameco;
using namespace ameco::test;
namespace fs = std::filesystem;

class HierarchyFolderTest : public QObject {
    Q_OBJECT
private slots:
    void init();
    void lists_files_that_are_there_and_whole();
    void refers_to_the_input_or_copies_it_data();
    void refers_to_the_input_or_copies_it();
    void gives_back_a_level_as_it_was_made();
    void notices_changed_and_missing_files();
    void removes_the_files_of_an_older_hierarchy_and_no_others();
    void writes_text_when_asked();
    void writes_levels_in_another_format_too_data();
    void writes_levels_in_another_format_too();
    void a_damaged_export_is_made_anew();
    void knows_its_files_by_name();
    void refuses_a_file_in_place_of_the_folder();
    void takes_back_what_was_begun_for_nothing();
    void takes_nothing_back_that_is_of_use();
    void gives_back_which_patches_are_frozen();

private:
    /// Makes a hierarchy of two coarser levels in the folder `out`.
    void make(bool copy = false, const std::string& suffix = ".meshb",
              const std::string& export_format = "", const std::string& export_suffix = "");
    [[nodiscard]] fs::path operator/(const std::string& name) const {
        return fs::path(temporary_->path().toStdString()) / name;
    }

    std::unique_ptr<QTemporaryDir> temporary_;
    Collected<3> made_;
};

void HierarchyFolderTest::init() {
    temporary_ = std::make_unique<QTemporaryDir>();
    write_mesh(*this / "cube.meshb", small_mesh<3>());
}

void HierarchyFolderTest::make(bool copy, const std::string& suffix,
                               const std::string& export_format, const std::string& export_suffix) {
    made_ = {};
    Hierarchy start;
    start.options.levels = 2;
    start.mesh_suffix = suffix;
    start.export_format = export_format;
    start.export_suffix = export_suffix;
    start.input.copied = copy;
    HierarchyFolder folder(*this / "out", *this / "cube.meshb", start);
    const LevelSink<3> collect = made_.sink();
    const auto end = build_hierarchy<3>(
        small_mesh<3>(), start.options,
        [&](const Level<3>& level, const LevelStatistics& s, const LevelTiming& t) {
            folder.add_level(level, s, t);
            collect(level, s, t);
            // At this moment the program may be killed.
            const Hierarchy listed = read_hierarchy(*this / "out");
            QCOMPARE(listed.status, HierarchyStatus::in_progress);
            QCOMPARE(intact_levels(*this / "out", listed), s.level + 1);
        });
    folder.finish(end.status);
}

void HierarchyFolderTest::lists_files_that_are_there_and_whole() {
    make();
    const Hierarchy h = read_hierarchy(*this / "out");
    QCOMPARE(h.status, HierarchyStatus::complete);
    QCOMPARE(h.levels.size(), std::size_t{3});
    QCOMPARE(intact_levels(*this / "out", h), 3);
    QCOMPARE(h.levels[2].mesh.name, std::string("level_2.meshb"));
    QCOMPARE(h.levels[2].metric.name, std::string("metric_2.solb"));
    QCOMPARE(read_timing(*this / "out").size(), std::size_t{3});
    QCOMPARE(contents_of(*this / "out").size(), std::size_t{2 + 2 + 3 + 2});
}

void HierarchyFolderTest::refers_to_the_input_or_copies_it_data() {
    QTest::addColumn<bool>("copy");
    QTest::addColumn<QString>("file");
    QTest::newRow("refers") << false << "../cube.meshb";
    QTest::newRow("copies") << true << "level_0.meshb";
}

void HierarchyFolderTest::refers_to_the_input_or_copies_it() {
    QFETCH(bool, copy);
    QFETCH(QString, file);
    make(copy);
    const Hierarchy h = read_hierarchy(*this / "out");
    QCOMPARE(QString::fromStdString(h.levels[0].mesh.name), file);
    QCOMPARE(content_of(*this / "out" / h.levels[0].mesh.name), content_of(*this / "cube.meshb"));
    QVERIFY(read_level_mesh<3>(*this / "out", h, 0) == made_.levels[0].mesh);
}

void HierarchyFolderTest::gives_back_a_level_as_it_was_made() {
    for (const std::string suffix : {".meshb", ".mesh"}) {
        make(false, suffix);
        const Level<3> read = read_level<3>(*this / "out", read_hierarchy(*this / "out"), 2);
        const Level<3>& made = made_.levels[2];
        QVERIFY(read.mesh == made.mesh);
        QVERIFY(read.natural == made.natural);
        QVERIFY(read.parent == made.parent);
        QVERIFY(read.geometry.node == made.geometry.node);
    }
}

void HierarchyFolderTest::notices_changed_and_missing_files() {
    make();
    const Hierarchy h = read_hierarchy(*this / "out");
    std::ofstream(*this / "out" / "metric_2.solb", std::ios::app) << "x";
    QCOMPARE(intact_levels(*this / "out", h), 2);
    fs::remove(*this / "out" / "level_1.meshb");
    QCOMPARE(intact_levels(*this / "out", h), 1);
    std::ofstream(*this / "cube.meshb", std::ios::app) << "x";
    QCOMPARE(intact_levels(*this / "out", h), 0);
}

void HierarchyFolderTest::removes_the_files_of_an_older_hierarchy_and_no_others() {
    make();
    for (const char* name : {"level_9.mesh", "P_1.mtx", ".level_3.meshb.123-4.tmp", "notes.txt"}) {
        std::ofstream(*this / "out" / name) << "x";
    }
    const HierarchyFolder folder(*this / "out", *this / "cube.meshb", {});
    std::vector<std::string> names;
    for (const auto& entry : contents_of(*this / "out")) {
        names.push_back(entry.first);
    }
    QCOMPARE(names, (std::vector<std::string>{"hierarchy.json", "notes.txt", "timing.json"}));
    QVERIFY(read_hierarchy(*this / "out").levels.empty());
}

void HierarchyFolderTest::writes_text_when_asked() {
    make(false, ".mesh");
    QVERIFY(content_of(*this / "out" / "level_1.mesh").starts_with("MeshVersionFormatted"));
    QVERIFY(content_of(*this / "out" / "metric_1.sol").starts_with("MeshVersionFormatted"));
}

void HierarchyFolderTest::writes_levels_in_another_format_too_data() {
    QTest::addColumn<QString>("format");
    QTest::addColumn<QString>("suffix");
    QTest::addColumn<QStringList>("files");
    QTest::newRow("SU2") << "su2"
                         << ".su2" << QStringList{"level_2.su2"};
    QTest::newRow("several files")
        << "tetgen"
        << ".node" << QStringList{"level_2.ele", "level_2.face", "level_2.node"};
    QTest::newRow("suffix with digits")
        << "ugrid"
        << ".lb8.ugrid" << QStringList{"level_2.lb8.ugrid", "level_2.mapbc"};
}

void HierarchyFolderTest::writes_levels_in_another_format_too() {
    QFETCH(QString, format);
    QFETCH(QString, suffix);
    QFETCH(QStringList, files);
    make(false, ".meshb", format.toStdString(), suffix.toStdString());
    const Hierarchy h = read_hierarchy(*this / "out");
    for (const int k : {0, 1, 2}) {
        const auto path = *this / "out" / ("level_" + std::to_string(k) + suffix.toStdString());
        const Mesh<3> read = std::get<Mesh<3>>(read_mesh(path).mesh);
        const Mesh<3>& made = made_.levels[static_cast<std::size_t>(k)].mesh;
        QVERIFY(read.points == made.points);
        QVERIFY(read.elements == made.elements);
        QCOMPARE(check(read).summary(), check(made).summary());
        // SU2 has the faces patch by patch.
        std::vector<int> patches(made.patch.begin(), made.patch.end());
        std::sort(patches.begin(), patches.end());
        std::vector<int> read_patches(read.patch.begin(), read.patch.end());
        std::sort(read_patches.begin(), read_patches.end());
        QCOMPARE(read_patches, patches);
    }
    QStringList listed;
    for (const HashedFile& file : h.levels[2].exports) {
        listed += QString::fromStdString(file.name);
    }
    QVERIFY(std::all_of(files.begin(), files.end(),
                        [&](const QString& file) { return listed.contains(file); }));
    // What was made is kept when the hierarchy is continued.
    const auto before = contents_of(*this / "out");
    const HierarchyFolder again(*this / "out", *this / "cube.meshb", h);
    QCOMPARE(contents_of(*this / "out").size(), before.size());
}

void HierarchyFolderTest::a_damaged_export_is_made_anew() {
    make(false, ".meshb", "su2", ".su2");
    const Hierarchy h = read_hierarchy(*this / "out");
    QCOMPARE(intact_levels(*this / "out", h), 3);
    std::ofstream(*this / "out" / "level_2.su2", std::ios::app) << "x";
    QCOMPARE(intact_levels(*this / "out", h), 2);
}

void HierarchyFolderTest::knows_its_files_by_name() {
    for (const char* name : {"hierarchy.json", "timing.json", "level_0.mesh.gz", "level_12.meshb",
                             "metric_3.sol", "state_1.cbor", "P_2.mtx", "level_1.lb8.ugrid",
                             "level_1.t.patches", ".hierarchy.json.77-0.tmp"}) {
        QVERIFY2(is_hierarchy_file(name), name);
    }
    for (const char* name : {"level.meshb", "level_x.meshb", "my_level_1.meshb", "levels_1.meshb",
                             "level_1", "wing.meshb", ""}) {
        QVERIFY2(!is_hierarchy_file(name), name);
    }
}

void HierarchyFolderTest::refuses_a_file_in_place_of_the_folder() {
    QVERIFY_THROWS_EXCEPTION(
        FileError, HierarchyFolder(*this / "cube.meshb", *this / "cube.meshb", Hierarchy()));
}

void HierarchyFolderTest::takes_back_what_was_begun_for_nothing() {
    Hierarchy start;
    start.input.copied = true;
    HierarchyFolder folder(*this / "out", *this / "cube.meshb", start);
    folder.add_level(finest_level(small_mesh<3>(), {}), {}, {});
    QVERIFY(fs::exists(*this / "out" / "metric_0.solb"));
    folder.take_back();
    QVERIFY(!fs::exists(*this / "out"));
    QVERIFY(fs::exists(*this / "cube.meshb"));
    // A folder that was there stays, with what somebody else put there.
    fs::create_directory(*this / "mine");
    std::ofstream(*this / "mine" / "notes.txt") << "x";
    HierarchyFolder(*this / "mine", *this / "cube.meshb", start).take_back();
    QCOMPARE(contents_of(*this / "mine").size(), std::size_t{1});
    // The copy of a file that is not there fails before there is an object.
    QVERIFY_THROWS_EXCEPTION(FileError,
                             HierarchyFolder(*this / "out", *this / "nothing.meshb", start));
    QVERIFY(!fs::exists(*this / "out"));
}

void HierarchyFolderTest::takes_nothing_back_that_is_of_use() {
    make();
    const auto before = contents_of(*this / "out");
    HierarchyFolder folder(*this / "out", *this / "cube.meshb", read_hierarchy(*this / "out"));
    folder.finish(HierarchyStatus::complete);
    folder.take_back();
    QCOMPARE(contents_of(*this / "out").size(), before.size());
}

void HierarchyFolderTest::gives_back_which_patches_are_frozen() {
    make();
    Hierarchy h = read_hierarchy(*this / "out");
    h.options.coarsen.features.frozen_patches = {2};
    QCOMPARE(read_level<3>(*this / "out", h, 1).geometry.frozen_patches, std::vector<int>{2});
    h.options.coarsen.features.boundary = BoundaryChoice::keep;
    QCOMPARE(read_level<3>(*this / "out", h, 1).geometry.frozen_patches,
             (std::vector<int>{1, 2, 3, 4, 5, 6}));
}

QTEST_APPLESS_MAIN(HierarchyFolderTest)
#include "hierarchy_folder_test.moc"
