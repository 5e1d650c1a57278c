// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/model/document.h"

#include "core/hierarchy/settings.h"
#include "core/io/io.h"
#include "gui/model/level_table_model.h"
#include "tests/acceptance/run_ameco.h"

#include <QSignalSpy>
#include <QtTest>

using namespace ameco;
using namespace ameco::gui;
using ameco::test::content_of;
using ameco::test::Run;
using ameco::test::Workspace;

class DocumentTest : public QObject {
    Q_OBJECT
private slots:
    void opens_meshes_of_two_and_three_dimensions_data();
    void opens_meshes_of_two_and_three_dimensions();
    void a_broken_file_leaves_what_is_open();
    void levels_form_a_tree();
    void deleting_a_level_deletes_what_was_made_from_it();
    void follows_a_node_through_the_levels();
    void the_command_makes_the_same_bytes_data();
    void the_command_makes_the_same_bytes();
    void says_why_no_command_makes_a_branch();
    void opens_the_folder_of_a_hierarchy();
    void a_damaged_level_is_left_out();
    void a_surface_can_be_looked_at();
    void cancelling_keeps_the_levels_that_are_finished();
    void knows_on_which_level_nodes_disappear();
};

namespace {

QString sample(const char* name) {
    return QString(AMECO_SOURCE_DIR) + "/sample_meshes/" + name;
}

/// A document that opens and coarsens, and waits for it.
struct Case {
    JobRunner jobs;
    Document document{jobs};
    QStringList errors;

    Case() {
        QObject::connect(&jobs, &JobRunner::ended, &jobs,
                         [this](JobEnd end, const QString& reason) {
                             if (end == JobEnd::failed) {
                                 errors << reason;
                             }
                         });
        QObject::connect(&jobs, &JobRunner::said, &jobs,
                         [this](Severity severity, const QString& text) {
                             if (severity == Severity::warning) {
                                 errors << text;
                             }
                         });
    }
    bool wait() {
        return QTest::qWaitFor([this] { return !jobs.isRunning(); }, 120'000);
    }
    bool open(const QString& path) {
        document.open(path);
        return wait() && errors.isEmpty();
    }
    bool coarsen(int from, const HierarchyOptions& options) {
        document.coarsen(from, options);
        return wait() && errors.isEmpty();
    }
};

HierarchyOptions levels(int count) {
    HierarchyOptions options;
    options.levels = count;
    return options;
}

} // namespace

void DocumentTest::opens_meshes_of_two_and_three_dimensions_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("dimension");
    QTest::newRow("3-D") << "box.mesh" << 3;
    QTest::newRow("2-D") << "layer_2d.meshb" << 2;
}

void DocumentTest::opens_meshes_of_two_and_three_dimensions() {
    QFETCH(QString, file);
    QFETCH(int, dimension);
    Case c;
    QVERIFY(c.open(sample(qPrintable(file))));
    QCOMPARE(c.document.file().dimension, dimension);
    QCOMPARE(c.document.levels().size(), std::size_t{1});
    const CaseLevel& finest = *c.document.current();
    QVERIFY(finest.scene != nullptr);
    QCOMPARE(static_cast<std::int64_t>(finest.scene->node_count), finest.statistics.nodes);
    QVERIFY(!c.document.patches().empty());
}

void DocumentTest::a_broken_file_leaves_what_is_open() {
    Case c;
    QVERIFY(c.open(sample("box.mesh")));
    const Workspace here;
    here.write("broken.meshb", "this is no mesh");
    c.document.open(here.path("broken.meshb"));
    QVERIFY(c.wait());
    QCOMPARE(c.errors.size(), 1);
    QVERIFY2(c.errors[0].contains("broken.meshb"), qPrintable(c.errors[0]));
    QVERIFY(c.document.isOpen());
    QVERIFY(QString::fromStdString(c.document.file().path).endsWith("box.mesh"));
}

void DocumentTest::levels_form_a_tree() {
    Case c;
    QVERIFY(c.open(sample("layer.meshb")));
    const LevelTableModel table(c.document);
    QVERIFY(c.coarsen(0, levels(2)));
    HierarchyOptions other = levels(1);
    other.coarsen.target.factor = 2.5;
    QVERIFY(c.coarsen(1, other));
    QCOMPARE(c.document.levels().size(), std::size_t{4});
    QCOMPARE(c.document.successors(0), std::vector<int>{1});
    QCOMPARE(c.document.successors(1), (std::vector<int>{2, 3}));
    QCOMPARE(c.document.current()->id, 3);
    QCOMPARE(c.document.current()->number, 2);
    QCOMPARE(c.document.branch(3).size(), std::size_t{3});
    QCOMPARE(table.rowCount(), 4);
    QCOMPARE(table.idOf(3), 3);
    QVERIFY(table.data(table.index(3, 0), Qt::DisplayRole).toString().endsWith("2"));
}

void DocumentTest::deleting_a_level_deletes_what_was_made_from_it() {
    Case c;
    QVERIFY(c.open(sample("layer.meshb")));
    QVERIFY(c.coarsen(0, levels(2)));
    QSignalSpy removed(&c.document, &Document::levelRemoved);
    c.document.remove(0);
    QCOMPARE(c.document.levels().size(), std::size_t{3}); // the finest stays
    c.document.remove(1);
    QCOMPARE(c.document.levels().size(), std::size_t{1});
    QCOMPARE(removed.count(), 2);
    QCOMPARE(c.document.current()->id, 0);
    QVERIFY(c.coarsen(0, levels(1)));
    QCOMPARE(c.document.current()->id, 3); // ids are not used again
}

void DocumentTest::follows_a_node_through_the_levels() {
    Case c;
    QVERIFY(c.open(sample("layer.meshb")));
    QVERIFY(c.coarsen(0, levels(2)));
    const auto position = [&](int id, NodeId v) {
        return c.document.level(id)->scene->position(v);
    };
    const auto nodes = static_cast<std::size_t>(c.document.level(2)->statistics.nodes);
    for (std::size_t i = 0; i < nodes; i += 7) {
        const auto fine = c.document.sameNode(2, NodeId(i), 0);
        QVERIFY(fine);
        QCOMPARE(position(0, *fine), position(2, NodeId(i)));
        QVERIFY(c.document.sameNode(0, *fine, 2) == NodeId(i));
    }
    std::size_t gone = 0;
    const auto all = static_cast<std::size_t>(c.document.level(0)->statistics.nodes);
    for (std::size_t i = 0; i < all; ++i) {
        gone += c.document.sameNode(0, NodeId(i), 2) ? 0 : 1;
    }
    QCOMPARE(gone, all - nodes);
}

void DocumentTest::the_command_makes_the_same_bytes_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QStringList>("changes"); ///< name, word, name, word, ...
    QTest::addColumn<double>("second_factor");
    QTest::newRow("as it comes") << "layer.meshb" << QStringList() << 2.0;
    QTest::newRow("another factor for level 2") << "layer.meshb" << QStringList() << 1.7;
    QTest::newRow("in 2-D") << "layer_2d.meshb" << QStringList() << 2.0;
    QTest::newRow("all settings") << "layer.meshb"
                                  << QStringList{"mean",
                                                 "corrected",
                                                 "isotropic-below",
                                                 "1",
                                                 "slack",
                                                 "1.3",
                                                 "algorithm",
                                                 "graded",
                                                 "gradation",
                                                 "1.4",
                                                 "ridge-angle",
                                                 "50",
                                                 "surface-deviation",
                                                 "0.05"}
                                  << 2.5;
    QTest::newRow("a ratio") << "layer_2d.meshb" << QStringList{"target-ratio", "1.8"} << 2.0;
}

void DocumentTest::the_command_makes_the_same_bytes() {
    QFETCH(QString, file);
    QFETCH(QStringList, changes);
    QFETCH(double, second_factor);
    const Workspace here;
    QVERIFY(QFile::copy(sample(qPrintable(file)), here.path("a mesh's copy.meshb")));
    Case c;
    QVERIFY(c.open(here.path("a mesh's copy.meshb")));
    HierarchyOptions options = levels(1);
    for (qsizetype i = 0; i + 1 < changes.size(); i += 2) {
        setting(changes[i].toStdString()).assign(options, changes[i + 1].toStdString());
    }
    c.document.coarsen(0, options);
    QVERIFY(c.wait());
    options.coarsen.target.factor = second_factor;
    c.document.coarsen(1, options);
    QVERIFY(c.wait());
    QCOMPARE(c.document.levels().size(), std::size_t{3});
    c.document.exportBranch(2, here.path("window"));
    QVERIFY(c.wait());

    QString command = c.document.commandLine(2, 1);
    QVERIFY2(command.startsWith("ameco coarsen '"), qPrintable(command));
    const Run run = here.shell(command.replace(0, 5, "\"$AMECO\""));
    QVERIFY2(run.code == 0, run.text());
    for (const char* name : {"level_1.meshb", "level_2.meshb", "state_1.cbor", "state_2.cbor",
                             "metric_1.solb", "metric_2.solb"}) {
        QVERIFY2(here.content(QString("window/") + name) == here.content(QString("levels/") + name),
                 name);
    }
}

void DocumentTest::says_why_no_command_makes_a_branch() {
    Case c;
    QVERIFY(c.open(sample("layer.meshb")));
    QVERIFY(c.document.commandLine(0, 0).startsWith("ameco info "));
    QVERIFY(c.coarsen(0, levels(1)));
    HierarchyOptions other = levels(1);
    other.coarsen.mean = Mean::geodesic;
    QVERIFY(c.coarsen(1, other));
    const QString text = c.document.commandLine(2, 0);
    QVERIFY2(text.startsWith("# no single command") && text.contains("mean"), qPrintable(text));
    QVERIFY(c.document.commandLine(1, 0).startsWith("ameco coarsen"));
}

void DocumentTest::opens_the_folder_of_a_hierarchy() {
    const Workspace here;
    const Run run = here.ameco(
        {"coarsen", sample("layer.meshb"), "-o", "levels", "-n", "2", "--factor", "2.2"});
    QCOMPARE(run.code, 0);
    Case c;
    QVERIFY(c.open(here.path("levels")));
    QCOMPARE(c.document.levels().size(), std::size_t{3});
    QCOMPARE(c.document.level(2)->options.coarsen.target.factor, 2.2);
    QVERIFY(c.coarsen(2, levels(1))); // goes on from there
    QCOMPARE(c.document.current()->number, 3);
}

void DocumentTest::a_damaged_level_is_left_out() {
    const Workspace here;
    QCOMPARE(here.ameco({"coarsen", sample("layer.meshb"), "-o", "levels", "-n", "2"}).code, 0);
    here.write("levels/level_2.meshb", "damaged");
    Case c;
    c.document.open(here.path("levels"));
    QVERIFY(c.wait());
    QCOMPARE(c.document.levels().size(), std::size_t{2});
    QVERIFY(!c.errors.isEmpty() && c.errors[0].contains("level 2"));
}

void DocumentTest::a_surface_can_be_looked_at() {
    const Workspace here;
    here.write("corner.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                             "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    Case c;
    c.document.open(here.path("corner.off"));
    QVERIFY(c.wait());
    if (!c.document.isOpen()) {
        QVERIFY2(c.errors.join(" ").contains("OpenMesh"), qPrintable(c.errors.join("\n")));
        QSKIP("built without OpenMesh");
    }
    QCOMPARE(c.document.current()->scene->triangles.size(), std::size_t{4});
    QCOMPARE(c.document.current()->statistics.elements, std::int64_t{0});
    c.document.coarsen(0, levels(1));
    QVERIFY(!c.jobs.isRunning()); // there is nothing to coarsen
}

void DocumentTest::cancelling_keeps_the_levels_that_are_finished() {
    Case c;
    QVERIFY(c.open(sample("m6_8k.meshb")));
    connect(&c.document, &Document::levelAdded, &c.jobs, &JobRunner::cancel);
    c.document.coarsen(0, levels(4));
    QVERIFY(c.wait());
    QTRY_COMPARE(c.jobs.windingDown(), 0);
    QCOMPARE(c.document.levels().size(), std::size_t{2});
    QVERIFY(c.document.current()->statistics.nodes < c.document.level(0)->statistics.nodes);
}

void DocumentTest::knows_on_which_level_nodes_disappear() {
    Case c;
    QVERIFY(c.open(sample("layer.meshb")));
    QVERIFY(c.coarsen(0, levels(2)));
    c.document.prepareRemovedAt();
    QVERIFY(c.wait());
    const auto& removed_at = c.document.level(0)->scene->removed_at();
    QCOMPARE(static_cast<std::int64_t>(removed_at.size()), c.document.level(0)->statistics.nodes);
    for (std::size_t i = 0; i < removed_at.size(); ++i) {
        const bool on_1 = c.document.sameNode(0, NodeId(i), 1).has_value();
        const bool on_2 = c.document.sameNode(0, NodeId(i), 2).has_value();
        QCOMPARE(removed_at[i], on_2 ? 0 : on_1 ? 2 : 1);
    }
}

QTEST_GUILESS_MAIN(DocumentTest)
#include "document_test.moc"
