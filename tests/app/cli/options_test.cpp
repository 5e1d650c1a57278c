// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/options.h"

#include "core/base/error.h"

#include <cmath>

#include <QtTest>

using namespace ameco;
using namespace ameco::cli;

class OptionsTest : public QObject {
    Q_OBJECT
private slots:
    void accepts_what_makes_sense_and_says_why_not_data();
    void accepts_what_makes_sense_and_says_why_not();
    void suggests_the_word_that_was_meant();
    void takes_every_setting_of_the_table_data();
    void takes_every_setting_of_the_table();
};

namespace {

enum Kind { whole_0_to_10, above_1, at_least_1, angle };

CLI::Validator validator_of(int kind) {
    switch (kind) {
    case whole_0_to_10:
        return whole_number(0, 10);
    case above_1:
        return greater_than(1);
    case at_least_1:
        return number_within(1, HUGE_VAL);
    default:
        return number_within(0, 180);
    }
}

} // namespace

void OptionsTest::accepts_what_makes_sense_and_says_why_not_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("complaint");
    const auto row = [](Kind kind, const char* value, const char* complaint) {
        QTest::addRow("%d: %s", kind, value) << int(kind) << value << complaint;
    };
    row(whole_0_to_10, "0", "");
    row(whole_0_to_10, "10", "");
    row(whole_0_to_10, "11", "11 is not a whole number from 0 to 10");
    row(whole_0_to_10, "-1", "-1 is not a whole number from 0 to 10");
    row(whole_0_to_10, "2.5", "2.5 is not a whole number from 0 to 10");
    row(whole_0_to_10, "", " is not a whole number from 0 to 10");
    row(above_1, "1.0001", "");
    row(above_1, "1", "1 is not a number greater than 1");
    row(above_1, "nan", "nan is not a number greater than 1");
    row(above_1, "inf", "inf is not a number greater than 1");
    row(at_least_1, "1", "");
    row(at_least_1, "0.9", "0.9 is not a number of at least 1");
    row(angle, "180", "");
    row(angle, "0,5", "0,5 is not a number from 0 to 180");
}

void OptionsTest::accepts_what_makes_sense_and_says_why_not() {
    QFETCH(int, kind);
    QFETCH(QString, value);
    QFETCH(QString, complaint);
    std::string text = value.toStdString();
    QCOMPARE(QString::fromStdString(validator_of(kind)(text)), complaint);
}

void OptionsTest::suggests_the_word_that_was_meant() {
    std::string text = "plian";
    QCOMPARE(one_of({"bar", "plain"})(text),
             std::string("plian is not one of bar, plain, did you mean plain?"));
}

void OptionsTest::takes_every_setting_of_the_table_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("word");
    QTest::addColumn<bool>("good");
    const auto row = [](const char* name, const char* word, bool good) {
        QTest::addRow("%s %s", name, word) << name << word << good;
    };
    row("levels", "7", true);
    row("levels", "0", false);
    row("levels", "2.5", false);
    row("target-ratio", "2.25", true);
    row("target-ratio", "1", false);
    row("slack", "1", true);
    row("slack", "0.9", false);
    row("algorithm", "maca", true);
    row("algorithm", "mecca", false);
    row("gradation", "1.2", true);
    row("gradation", "1", false);
    row("mean", "geodesic", true);
    row("mean", "harmonic", false);
    row("surface-deviation", "0", true);
    row("surface-deviation", "-1", false);
    row("ridge-angle", "180", true);
    row("ridge-angle", "180.5", false);
}

void OptionsTest::takes_every_setting_of_the_table() {
    QFETCH(QString, name);
    QFETCH(QString, word);
    QFETCH(bool, good);
    HierarchyOptions options;
    CLI::App app;
    add_setting(app, options, setting(name.toStdString()).name);
    const auto parse = [&] {
        app.parse(std::vector<std::string>{word.toStdString(), "--" + name.toStdString()});
    };
    QCOMPARE(setting(name.toStdString()).accepts(word.toStdString()), good);
    if (good) {
        parse();
        QCOMPARE(setting(name.toStdString()).value(options), word.toStdString());
    } else {
        QVERIFY_THROWS_EXCEPTION(CLI::ParseError, parse());
    }
}

QTEST_APPLESS_MAIN(OptionsTest)
#include "options_test.moc"
