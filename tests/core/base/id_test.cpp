// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/id.h"

#include <QTest>

#include <set>
#include <string>
#include <type_traits>

using namespace ameco;

// One kind of id is no other kind, and no number turns into an id by itself.
static_assert(!std::is_convertible_v<NodeId, ElementId>);
static_assert(!std::is_constructible_v<NodeId, ElementId>);
static_assert(!std::is_convertible_v<int, NodeId>);
static_assert(!std::is_convertible_v<NodeId, int>);
static_assert(!std::is_invocable_v<decltype([](auto& v, auto i) -> decltype(v[i]) { return v[i]; }),
                                   IdVector<NodeId, int>&, ElementId>);
static_assert(sizeof(NodeId) == 4);
static_assert(std::is_trivially_copyable_v<NodeId>);

class IdTest : public QObject {
    Q_OBJECT
private slots:
    void means_none_by_default();
    void compares_by_number();
    void indexes_its_own_vector();
    void knows_which_ids_are_inside();
    void walks_over_all_ids();
};

void IdTest::means_none_by_default() {
    QVERIFY(!NodeId().valid());
    QVERIFY(NodeId(0).valid());
    QVERIFY(!NodeId(-5).valid());
    QCOMPARE(NodeId(std::size_t{7}).value(), 7);
    QCOMPARE(NodeId(7).index(), std::size_t{7});
}

void IdTest::compares_by_number() {
    QVERIFY(NodeId(2) < NodeId(3));
    QVERIFY(NodeId(3) == NodeId(3));
    QVERIFY(NodeId() < NodeId(0));
    const std::set<NodeId> ids{NodeId(2), NodeId(1), NodeId(2)};
    QCOMPARE(ids.size(), std::size_t{2});
}

void IdTest::indexes_its_own_vector() {
    IdVector<NodeId, std::string> names(2, "none");
    names[NodeId(1)] = "one";
    QCOMPARE(names.next_id(), NodeId(2));
    names.push_back("two");
    QCOMPARE(names.raw(), (std::vector<std::string>{"none", "one", "two"}));
    const auto& constant = names;
    QCOMPARE(constant[NodeId(2)], std::string("two"));
    names.resize(4, "new");
    QCOMPARE(names[NodeId(3)], std::string("new"));
    names.assign(1, "again");
    QVERIFY(names == (IdVector<NodeId, std::string>({"again"})));
}

void IdTest::knows_which_ids_are_inside() {
    const IdVector<FaceId, int> values(3);
    QVERIFY(values.contains(FaceId(0)));
    QVERIFY(values.contains(FaceId(2)));
    QVERIFY(!values.contains(FaceId(3)));
    QVERIFY(!values.contains(FaceId()));
}

void IdTest::walks_over_all_ids() {
    const IdVector<ElementId, int> values(3);
    std::vector<ElementId> seen;
    for (const ElementId e : values.ids()) {
        seen.push_back(e);
    }
    QCOMPARE(seen, (std::vector<ElementId>{ElementId(0), ElementId(1), ElementId(2)}));
    for (const ElementId e : IdVector<ElementId, int>().ids()) {
        QVERIFY2(false, std::to_string(e.value()).c_str());
    }
}

QTEST_APPLESS_MAIN(IdTest)
#include "id_test.moc"
