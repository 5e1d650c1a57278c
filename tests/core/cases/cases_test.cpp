// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/cases.h"

#include "core/base/error.h"
#include "core/cases/box.h"
#include "core/cases/onera_m6.h"
#include "core/mesh/check.h"

#include <fstream>
#include <iterator>
#include <set>
#include <tuple>

#include <QtTest>

using namespace ameco;

namespace {

using Values = std::map<std::string, std::string>;

/// Cheap values for each case.
Values small(const std::string& name) {
    if (name == "shell") {
        return {{"frequency", "3"}, {"aspect-ratio", "100"}};
    }
    if (name == "onera-m6") {
        return {{"preset", "m6-8k"}};
    }
    if (name == "layer") {
        return {{"nx", "4"}, {"ny", "4"}, {"nz", "6"}};
    }
    return {};
}

std::string error_of(const std::string& name, const Values& values) {
    try {
        std::ignore = make_case(name, values);
    } catch (const UsageError& e) {
        return e.what();
    }
    return "no error";
}

} // namespace

class CasesTest : public QObject {
    Q_OBJECT
private slots:
    void describes_every_parameter();
    void makes_every_case_valid_in_every_dimension();
    void accepts_the_defaults_it_prints();
    void makes_what_the_options_struct_makes();
    void lets_parameters_change_a_preset();
    void makes_the_same_bytes_again();
    void are_all_in_the_manual();
    void says_what_is_wrong_data();
    void says_what_is_wrong();
};

void CasesTest::describes_every_parameter() {
    std::set<std::string> names;
    for (const CaseDescription& c : cases()) {
        QVERIFY(names.insert(c.name).second);
        QVERIFY(!c.summary.empty());
        std::set<std::string> parameters;
        for (const CaseParameter& p : c.parameters) {
            QVERIFY(parameters.insert(p.name).second);
            QVERIFY(!p.default_value.empty() && !p.range.empty() && !p.help.empty());
        }
    }
    QCOMPARE(names,
             (std::set<std::string>{"box", "model-layer", "layer", "cube", "shell", "onera-m6"}));
}

void CasesTest::makes_every_case_valid_in_every_dimension() {
    for (const CaseDescription& c : cases()) {
        const auto mesh = make_case(c.name, small(c.name));
        QVERIFY2(std::visit([](const auto& m) { return check(m).valid(); }, mesh), c.name.c_str());
        for (const CaseParameter& p : c.parameters) {
            if (p.name == "dim") {
                Values values = small(c.name);
                values.emplace("dim", "2");
                const auto flat = make_case(c.name, values);
                QVERIFY(std::holds_alternative<Mesh<2>>(flat));
                QVERIFY(check(std::get<Mesh<2>>(flat)).valid());
            }
        }
    }
}

void CasesTest::accepts_the_defaults_it_prints() {
    for (const CaseDescription& c : cases()) {
        if (c.name == "onera-m6" || c.name == "shell") {
            continue; // the same code, with larger meshes
        }
        Values defaults;
        for (const CaseParameter& p : c.parameters) {
            defaults[p.name] = p.default_value;
        }
        QVERIFY(make_case(c.name, defaults) == make_case(c.name));
    }
}

void CasesTest::makes_what_the_options_struct_makes() {
    BoxOptions o;
    o.nz = 3;
    o.ratio = 1e-5;
    o.diagonals = Diagonals::alternating;
    const auto box = make_case(
        "box", {{"nz", "3"}, {"ratio", "1e-5"}, {"diagonals", "alternating"}, {"dim", "3"}});
    QVERIFY(std::get<Mesh<3>>(box) == make_box<3>(o));
}

void CasesTest::lets_parameters_change_a_preset() {
    const auto nodes = [](const Values& values) {
        return std::get<Mesh<3>>(make_case("onera-m6", values)).points.size();
    };
    QCOMPARE(nodes({{"preset", "m6-8k"}}), 397u * 21);
    QCOMPARE(nodes({{"preset", "m6-8k"}, {"layers", "12"}}), 397u * 13);
    QCOMPARE(nodes({{"layers", "20"}}), 1499u * 21); // of m6-67k, the default
}

void CasesTest::makes_the_same_bytes_again() {
    for (const CaseDescription& c : cases()) {
        QVERIFY(make_case(c.name, small(c.name)) == make_case(c.name, small(c.name)));
    }
}

void CasesTest::are_all_in_the_manual() {
    std::ifstream file(AMECO_SOURCE_DIR "/docs/user/cases.md");
    const std::string manual{std::istreambuf_iterator<char>(file), {}};
    for (const CaseDescription& c : cases()) {
        const std::size_t begin = manual.find("\n## " + c.name + "\n");
        QVERIFY2(begin != std::string::npos, c.name.c_str());
        const std::string chapter = manual.substr(begin, manual.find("\n## ", begin + 1) - begin);
        for (const CaseParameter& p : c.parameters) {
            std::string row = "| `";
            row += p.name + "` | " + p.default_value + " | " + p.unit + " | " + p.range + " | " +
                   p.help + " |\n";
            QVERIFY2(chapter.find(row) != std::string::npos, (c.name + " lacks " + row).c_str());
        }
    }
}

void CasesTest::says_what_is_wrong_data() {
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("parameter");
    QTest::addColumn<std::string>("value");
    QTest::addColumn<std::string>("text");
    const auto row = [](const char* title, const char* name, const char* parameter,
                        const char* value, const char* text) {
        QTest::newRow(title) << std::string(name) << std::string(parameter) << std::string(value)
                             << std::string(text);
    };
    row("slip in a case", "onera-m7", "", "",
        "there is no case 'onera-m7'; did you mean 'onera-m6'?");
    row("unknown case", "sausage", "", "",
        "there is no case 'sausage'; known are box, model-layer, "
        "layer, cube, shell, onera-m6");
    row("slip in a parameter", "layer", "aspect-rato", "1",
        "layer: there is no parameter 'aspect-rato'; did you mean 'aspect-ratio'?");
    row("slip in a choice", "box", "diagonals", "unifrom",
        "box: diagonals cannot be 'unifrom'; did you mean 'uniform'?");
    row("unknown preset", "onera-m6", "preset", "huge",
        "onera-m6: preset cannot be 'huge'; known are m6-8k, m6-67k, m6-500k, m6-2m");
    row("not a number", "box", "ratio", "1e-3x", "box: ratio is '1e-3x', but must be a number > 0");
    row("not a whole number", "box", "nx", "2.5",
        "box: nx is '2.5', but must be a whole number >= 1");
    row("out of range", "cube", "displace", "0.5",
        "cube: displace is '0.5', but must be a number 0 ... 0.2");
    row("on an open end", "box", "dx", "0", "box: dx is '0', but must be a number > 0");
    row("infinite", "box", "dx", "inf", "box: dx is 'inf', but must be a number > 0");
    row("empty", "box", "dx", "", "box: dx is '', but must be a number > 0");
    row("wrong dimension", "box", "dim", "4", "box: dim is '4', but must be a whole number 2 or 3");
}

void CasesTest::says_what_is_wrong() {
    QFETCH(std::string, name);
    QFETCH(std::string, parameter);
    QFETCH(std::string, value);
    QFETCH(std::string, text);
    const Values values = parameter.empty() ? Values{} : Values{{parameter, value}};
    QCOMPARE(error_of(name, values), text);
}

QTEST_APPLESS_MAIN(CasesTest)
#include "cases_test.moc"
