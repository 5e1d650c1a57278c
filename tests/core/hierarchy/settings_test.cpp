// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/settings.h"

#include <QtTest>

using namespace ameco;

class SettingsTest : public QObject {
    Q_OBJECT
private slots:
    void each_setting_takes_its_own_value_back();
    void numbers_keep_every_bit();
    void arguments_name_what_is_not_usual();
    void arguments_repeat_no_factor_that_goes_on();
    void settings_that_decide_nothing_about_a_level_do_not_differ();
    void words_are_quoted_for_the_shell_data();
    void words_are_quoted_for_the_shell();
};

void SettingsTest::each_setting_takes_its_own_value_back() {
    HierarchyOptions unusual;
    unusual.levels = 7;
    unusual.until_isotropic = true;
    unusual.rebuild = true;
    unusual.target_ratio = 1.9;
    unusual.coarsen.mean = Mean::geodesic;
    unusual.coarsen.target = {3, 1.5, 2.5, TargetAlgorithm::graded, 1.3};
    unusual.coarsen.removal.surface.relative_distance = 0.01;
    unusual.coarsen.features.ridge_angle_deg = 33;
    unusual.coarsen.features.boundary = BoundaryChoice::keep;
    unusual.coarsen.nodes = CoarseNodes::moved;
    HierarchyOptions other;
    for (const Setting& s : settings()) {
        QVERIFY2(s.value(other) != s.value(unusual), s.name.data());
        QVERIFY2(s.accepts(s.value(unusual)), s.name.data());
        s.assign(other, s.value(unusual));
        QCOMPARE(s.value(other), s.value(unusual));
    }
}

void SettingsTest::numbers_keep_every_bit() {
    for (const double value : {2.0, 0.13, 1.0 / 3, 1e-9, 2.0000000000000004}) {
        QCOMPARE(std::stod(exact_word(value)), value);
    }
    QCOMPARE(exact_word(0.13), std::string("0.13"));
}

void SettingsTest::arguments_name_what_is_not_usual() {
    HierarchyOptions options;
    options.levels = 2;
    const std::string mean(name(options.coarsen.mean));
    QCOMPARE(coarsen_arguments(options, {2, 2}),
             (std::vector<std::string>{"--levels", "2", "--mean", mean}));
    options.coarsen.target.slack = 1.25;
    options.coarsen.features.frozen_patches = {1, 4};
    QCOMPARE(coarsen_arguments(options, {2, 3}),
             (std::vector<std::string>{"--levels", "2", "--factor", "2,3", "--slack", "1.25",
                                       "--mean", mean, "--freeze", "1", "4"}));
}

void SettingsTest::arguments_repeat_no_factor_that_goes_on() {
    HierarchyOptions options;
    options.levels = 4;
    const auto words = coarsen_arguments(options, {2, 3, 3, 3});
    QCOMPARE(words[3], std::string("2,3"));
}

void SettingsTest::settings_that_decide_nothing_about_a_level_do_not_differ() {
    HierarchyOptions a, b;
    b.levels = 9;
    b.until_isotropic = true;
    b.coarsen.target.factor = 3;
    QCOMPARE(different_for_a_level(a, b), std::string());
    b.coarsen.mean = Mean::log_euclidean;
    b.coarsen.features.frozen_patches = {2};
    QCOMPARE(different_for_a_level(a, b), std::string("mean, freeze"));
}

void SettingsTest::words_are_quoted_for_the_shell_data() {
    QTest::addColumn<QString>("word");
    QTest::addColumn<QString>("quoted");
    QTest::newRow("plain") << "/a/b-1.meshb"
                           << "/a/b-1.meshb";
    QTest::newRow("blank") << "my wing"
                           << "'my wing'";
    QTest::newRow("quote") << "it's"
                           << "'it'\\''s'";
    QTest::newRow("dollar") << "$HOME"
                            << "'$HOME'";
    QTest::newRow("empty") << ""
                           << "''";
}

void SettingsTest::words_are_quoted_for_the_shell() {
    QFETCH(QString, word);
    QFETCH(QString, quoted);
    QCOMPARE(QString::fromStdString(shell_word(word.toStdString())), quoted);
}

QTEST_APPLESS_MAIN(SettingsTest)
#include "settings_test.moc"
