// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/suggest.h"

#include <QtTest>

using namespace ameco::cli;

class SuggestTest : public QObject {
    Q_OBJECT
private slots:
    void counts_the_slips_between_two_words_data();
    void counts_the_slips_between_two_words();
    void finds_the_word_that_was_meant_data();
    void finds_the_word_that_was_meant();
};

void SuggestTest::counts_the_slips_between_two_words_data() {
    QTest::addColumn<QString>("a");
    QTest::addColumn<QString>("b");
    QTest::addColumn<int>("slips");
    QTest::newRow("same") << "coarsen"
                          << "coarsen" << 0;
    QTest::newRow("a letter missing") << "corsen"
                                      << "coarsen" << 1;
    QTest::newRow("a letter too many") << "coarrsen"
                                       << "coarsen" << 1;
    QTest::newRow("another letter") << "coarsem"
                                    << "coarsen" << 1;
    QTest::newRow("two exchanged") << "caorsen"
                                   << "coarsen" << 1;
    QTest::newRow("from nothing") << ""
                                  << "abc" << 3;
    QTest::newRow("nothing alike") << "abc"
                                   << "xyz" << 3;
}

void SuggestTest::counts_the_slips_between_two_words() {
    QFETCH(QString, a);
    QFETCH(QString, b);
    QFETCH(int, slips);
    QCOMPARE(edit_distance(a.toStdString(), b.toStdString()), slips);
    QCOMPARE(edit_distance(b.toStdString(), a.toStdString()), slips);
}

void SuggestTest::finds_the_word_that_was_meant_data() {
    QTest::addColumn<QString>("word");
    QTest::addColumn<QString>("suggestion");
    QTest::newRow("slip") << "chekc"
                          << ", did you mean check?";
    QTest::newRow("beginning") << "coa"
                               << ", did you mean coarsen?";
    QTest::newRow("nothing near") << "remove"
                                  << "";
    QTest::newRow("too short to tell") << "x"
                                       << "";
}

void SuggestTest::finds_the_word_that_was_meant() {
    QFETCH(QString, word);
    QFETCH(QString, suggestion);
    const std::vector<std::string> known{"info", "check", "coarsen", "convert"};
    QCOMPARE(QString::fromStdString(did_you_mean(word.toStdString(), known)), suggestion);
}

QTEST_APPLESS_MAIN(SuggestTest)
#include "suggest_test.moc"
