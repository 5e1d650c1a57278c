// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/level_state.h"

#include "tests/core/hierarchy/hierarchy_support.h"

#include <QtTest>

using namespace ameco;
using namespace ameco::test;

class LevelStateTest : public QObject {
    Q_OBJECT
private slots:
    void is_the_same_after_writing_and_reading_it();
    void refuses_the_state_of_another_mesh();
    void refuses_damaged_bytes();
};

namespace {

Level<3> coarse_level() {
    Collected<3> made;
    HierarchyOptions options;
    options.levels = 1;
    build_hierarchy(small_mesh<3>(), options, made.sink());
    Level<3> level = std::move(made.levels.at(1));
    level.geometry.ridges.at(0).label = -7;
    level.geometry.ridges.at(1).listed = true;
    level.geometry.ridges.at(2).declared = true;
    return level;
}

} // namespace

void LevelStateTest::is_the_same_after_writing_and_reading_it() {
    const Level<3> level = coarse_level();
    Level<3> read;
    read.mesh = level.mesh;
    parse_level_state(level_state_bytes(level), "state_1.cbor", read);
    QVERIFY(read.geometry.node == level.geometry.node);
    QVERIFY(read.geometry.ridges == level.geometry.ridges);
    QVERIFY(read.geometry.deviation == level.geometry.deviation);
    QVERIFY(read.parent == level.parent);
}

void LevelStateTest::refuses_the_state_of_another_mesh() {
    const std::string bytes = level_state_bytes(coarse_level());
    Level<3> other;
    other.mesh = small_mesh<3>();
    QVERIFY_THROWS_EXCEPTION(InputError, parse_level_state(bytes, "state_1.cbor", other));
    Level<2> flat;
    flat.mesh = small_mesh<2>();
    QVERIFY_THROWS_EXCEPTION(InputError, parse_level_state(bytes, "state_1.cbor", flat));
}

void LevelStateTest::refuses_damaged_bytes() {
    const Level<3> level = coarse_level();
    const std::string bytes = level_state_bytes(level);
    for (const std::size_t length :
         {std::size_t{0}, std::size_t{1}, bytes.size() / 2, bytes.size() - 1}) {
        Level<3> read;
        read.mesh = level.mesh;
        QVERIFY_THROWS_EXCEPTION(InputError,
                                 parse_level_state(bytes.substr(0, length), "state_1.cbor", read));
    }
    std::string wrong_class = bytes;
    const std::size_t at = bytes.find("node_class") + 10 + 4; // after the key and the length
    wrong_class.at(at) = '\x7f';
    Level<3> read;
    read.mesh = level.mesh;
    QVERIFY_THROWS_EXCEPTION(InputError, parse_level_state(wrong_class, "state_1.cbor", read));
}

QTEST_APPLESS_MAIN(LevelStateTest)
#include "level_state_test.moc"
