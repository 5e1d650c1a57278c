// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/settings.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QtTest>

using namespace ameco;

/// docs/user/options.md: all options of a hierarchy, from the table of settings and from the
/// headers of the structs. AMECO_UPDATE_DOCS=1 writes the page anew.
class OptionsPageTest : public QObject {
    Q_OBJECT
private slots:
    void is_the_same_in_the_manual();
    void knows_every_member_of_the_structs();
};

namespace {

/// A struct with options.
struct Source {
    const char* name;
    const char* what;
};
constexpr Source sources[] = {
    {"HierarchyOptions", "How many levels, and how coarse"},
    {"CoarsenOptions", "One level"},
    {"TargetOptions", "The metric of the next level"},
    {"FeatureOptions", "What is kept of the geometry"},
    {"LineOptions", "Lines across layers"},
    {"RemovalOptions", "Which nodes leave"},
    {"QualityFloor", "What a removal may do to elements"},
    {"SurfaceRules", "What an operation may do to the boundary"},
    {"InterpolationBound", "How well removed nodes stay interpolated"},
    {"SwapOptions", "Swaps"},
    {"LengthSwapOptions", "Swaps for lengths"},
    {"FitOptions", "Moved nodes"},
    {"AdaptOptions", "Adaptation to a metric (`ameco remesh`)"},
    {"SplitOptions", "Splits of long edges"},
    {"CollapseOptions", "Collapses of short edges"},
    {"MoveOptions", "Movement of nodes"},
};

struct Member {
    QString type, name, value, meaning;
};

QString content_of(const QString& name) {
    QFile file(QString(AMECO_SOURCE_DIR) + "/" + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Where a struct is, and its lines without the braces.
struct Definition {
    QString header;
    QStringList body;
};

Definition definition_of(const Source& source) {
    const QRegularExpression pattern(QString("\nstruct %1 \\{\n(.*?)\n\\};").arg(source.name),
                                     QRegularExpression::DotMatchesEverythingOption);
    const QDir root(AMECO_SOURCE_DIR);
    QDirIterator files(root.filePath("core"), {"*.h"}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString header = root.relativeFilePath(files.next());
        if (const auto match = pattern.match(content_of(header)); match.hasMatch()) {
            return {header, match.captured(1).split('\n')};
        }
    }
    return {};
}

/// Members with what is said of them, before (///) or behind (///<).
QList<Member> members_of(const QStringList& body) {
    static const QRegularExpression declaration(
        R"(^    ([\w:<>]+) (\w+)(?: =\s*([^;]+)|(\{[^;]*\}))?;(?:\s*///<\s*(.*))?$)");
    static const QRegularExpression behind(R"(^\s*///<\s*(.*)$)");
    static const QRegularExpression before(R"(^\s*///\s*(.*)$)");
    QList<Member> members;
    QString pending, line;
    for (const QString& part : body) {
        line = line.isEmpty() ? part : line + " " + part.trimmed();
        if (const auto match = behind.match(line); match.hasMatch()) {
            members.last().meaning += " " + match.captured(1);
        } else if (const auto other = before.match(line); other.hasMatch()) {
            pending += (pending.isEmpty() ? "" : " ") + other.captured(1);
        } else if (!line.contains(';') && line.contains('=')) {
            continue; // the value is on the next line
        } else if (const auto found = declaration.match(line); found.hasMatch()) {
            const QString meaning = found.captured(5).isEmpty() ? pending : found.captured(5);
            members.append({found.captured(1), found.captured(2),
                            found.captured(3) + found.captured(4), meaning});
            pending.clear();
        }
        line.clear();
    }
    return members;
}

/// What a text says in brackets is its unit, "[-]" a pure number.
QString unit_in(const QString& meaning) {
    static const QRegularExpression unit(R"(\[(-|deg|L(?:\^-?\w+)?)\])");
    return unit.match(meaning).captured(1);
}

QString cell(QString text) {
    return text.replace("|", "\\|").simplified();
}

QString settings_table() {
    QString text = "| option | in Python | default | accepts | unit | meaning |\n"
                   "|---|---|---|---|---|---|\n";
    const auto row = [&](const QString& name, const QString& value, const QString& accepts,
                         const QString& unit, const QString& meaning) {
        text += QString("| `--%1` | `%2` | %3 | %4 | %5 | %6 |\n")
                    .arg(name, QString(name).replace('-', '_'), value, cell(accepts), unit,
                         cell(meaning));
    };
    const HierarchyOptions defaults;
    row("factor", QString::fromStdString(exact_word(defaults.coarsen.target.factor)),
        "a number greater than 1, or one per level", "-", "coarse size over fine size");
    for (const Setting& s : settings()) {
        const QString value = QString::fromStdString(s.value(defaults));
        row(QString::fromUtf8(s.name.data(), static_cast<qsizetype>(s.name.size())),
            value == "0" && (s.zero_is_off || s.kind == Setting::Kind::flag) ? "off" : value,
            s.kind == Setting::Kind::flag ? "" : QString::fromStdString(s.wanted()),
            QString::fromUtf8(s.unit.data(), static_cast<qsizetype>(s.unit.size())),
            QString::fromStdString(s.help));
    }
    row("freeze", "none", "patches by id or name", "", "patches to leave untouched");
    return text;
}

QString struct_table(const Source& source) {
    const auto [header, body] = definition_of(source);
    QString text = QString("### %1: `%2`\n\n`%3`\n\n| member | default | unit | meaning |\n"
                           "|---|---|---|---|\n")
                       .arg(source.what, source.name, header);
    for (const Member& m : members_of(body)) {
        const QString value = m.value.isEmpty() ? "`" + m.type + "`" : m.value;
        text += QString("| `%1` | %2 | %3 | %4 |\n")
                    .arg(m.name, cell(value), unit_in(m.meaning), cell(m.meaning));
    }
    return text;
}

QString page() {
    QString text =
        "# Options\n\n"
        "This page is written by `tests/core/hierarchy/options_page_test.cpp` from the sources.\n\n"
        "## Of the program, the window and Python\n\n"
        "`ameco coarsen` takes all of these, `ameco metric` those that bear on the metric. What\n"
        "they do, and why the defaults are what they are, is in [coarsening](../theory/"
        "coarsening.md).\nThe other options of each command are in [cli.md](cli.md), the "
        "parameters of meshes by formula in\n[cases.md](cases.md).\n\n" +
        settings_table() +
        "\n## Of the C++ library\n\n"
        "The structs behind them, with what is not meant to be turned by everyone. A unit of L is "
        "the\nmesh's unit of length, - a pure number.\n";
    for (const Source& source : sources) {
        text += "\n" + struct_table(source);
    }
    return text;
}

} // namespace

void OptionsPageTest::is_the_same_in_the_manual() {
    const QString name = "docs/user/options.md";
    if (qEnvironmentVariableIsSet("AMECO_UPDATE_DOCS")) {
        QFile file(QString(AMECO_SOURCE_DIR) + "/" + name);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(page().toUtf8());
        return;
    }
    QVERIFY2(content_of(name) == page(),
             qPrintable(name + " is out of date: run this test with AMECO_UPDATE_DOCS=1"));
}

void OptionsPageTest::knows_every_member_of_the_structs() {
    for (const Source& source : sources) {
        const QStringList body = definition_of(source).body;
        const QString code = body.join('\n').remove(QRegularExpression("//[^\n]*"));
        const auto semicolons = code.count(';') - code.count("operator==");
        QVERIFY2(members_of(body).size() == semicolons && semicolons > 0, source.name);
    }
}

QTEST_APPLESS_MAIN(OptionsPageTest)
#include "options_page_test.moc"
