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
    void knows_every_mean_by_its_name();
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

void OptionsTest::knows_every_mean_by_its_name() {
    for (const Mean mean : all_means) {
        QCOMPARE(chosen_mean(std::string(name(mean))), mean);
    }
    QVERIFY_EXCEPTION_THROWN((void)chosen_mean("harmonic"), UsageError);
}

QTEST_APPLESS_MAIN(OptionsTest)
#include "options_test.moc"
