// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/level_charts.h"

#include "core/base/svg.h"
#include "core/base/text.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace ameco::gui {
namespace {

QString level_title(const CaseLevel& level) {
    return QObject::tr("level %1").arg(level.number);
}

template <class Counts>
std::vector<double> as_numbers(const Counts& counts) {
    return {counts.begin(), counts.end()};
}

std::vector<double> ascending(const AspectRatioClasses& classes) {
    return {classes.counts.rbegin(), classes.counts.rend()};
}

/// Short labels of large numbers: 1.3k, 20k, 1.5M.
QString short_label(double value) {
    const auto text = [](double v, const char* unit) {
        return QString::fromStdString(number_text(v, 2)) + QLatin1String(unit);
    };
    return value >= 1e6    ? text(value / 1e6, "M")
           : value >= 1000 ? text(value / 1000, "k")
                           : QString::fromStdString(number_text(value, value < 100 ? 2 : 3));
}

Chart empty_chart(const QString& x_title, const QString& y_title) {
    Chart chart;
    chart.x_title = x_title;
    chart.y_title = y_title;
    chart.empty_text = QObject::tr("No mesh is open.");
    return chart;
}

} // namespace

QColor level_colour(int number) {
    const auto& colours = svg::colours;
    return QColor(colours.at(static_cast<std::size_t>(number) % colours.size()));
}

Chart aspect_ratio_chart(const Branch& branch, const std::optional<Prediction>& prediction,
                         int from, const std::vector<double>& selection,
                         const QString& selection_title) {
    Chart chart = empty_chart(QObject::tr("aspect ratio"), QObject::tr("nodes"));
    if (branch.empty() || branch.front()->statistics.elements == 0) {
        return chart;
    }
    const AspectRatioClasses& classes = branch.front()->statistics.classes;
    const std::size_t count = classes.counts.size();
    chart.edges.push_back(QStringLiteral("1"));
    for (std::size_t k = count; k-- > 0;) {
        chart.edges.push_back(short_label(classes.upper(k)));
    }
    for (const CaseLevel* level : branch) {
        chart.series.push_back({level_title(*level), level_colour(level->number),
                                ascending(level->statistics.classes), false});
    }
    if (prediction) {
        chart.series.push_back({QObject::tr("level %1 predicted").arg(from + 1),
                                level_colour(from + 1), ascending(prediction->classes), true});
    }
    if (!selection.empty()) {
        chart.series.push_back({selection_title, QColor(214, 39, 40), selection, true});
    }
    return chart;
}

std::set<int> mirrored(const std::set<int>& classes, int count) {
    std::set<int> result;
    for (const int k : classes) {
        result.insert(count - 1 - k);
    }
    return result;
}

std::vector<double> count_nodes(const CaseLevel& level, const std::vector<NodeId>& nodes) {
    const AspectRatioClasses& classes = level.statistics.classes;
    std::vector<double> counts(classes.counts.size(), 0);
    std::visit(
        [&]<int D>(const Level<D>& l) {
            for (const NodeId v : nodes) {
                counts[counts.size() - 1 - classes.class_of(aspect_ratio<D>(l.natural[v]))] += 1;
            }
        },
        *level.level);
    return counts;
}

Chart quality_chart(const Branch& branch) {
    Chart chart =
        empty_chart(QObject::tr("quality in the metric asked for"), QObject::tr("elements"));
    for (int k = 0; k <= ConformityClasses::quality_classes; ++k) {
        chart.edges.push_back(
            QString::number(static_cast<double>(k) / ConformityClasses::quality_classes));
    }
    for (const CaseLevel* level : branch) {
        chart.series.push_back({level_title(*level), level_colour(level->number),
                                as_numbers(level->conformity.quality), false});
    }
    return chart;
}

Chart length_chart(const Branch& branch) {
    Chart chart =
        empty_chart(QObject::tr("edge length in the metric asked for"), QObject::tr("edges"));
    for (int k = 0; k <= ConformityClasses::length_classes; ++k) {
        const double length = std::exp2((k - ConformityClasses::length_classes / 2) / 4.0);
        chart.edges.push_back(QString::fromStdString(number_text(length, 2)));
    }
    for (const CaseLevel* level : branch) {
        chart.series.push_back({level_title(*level), level_colour(level->number),
                                as_numbers(level->conformity.length), false});
    }
    return chart;
}

Chart convergence_chart(const std::vector<ConvergenceCurve>& curves) {
    Chart chart = empty_chart(QObject::tr("iteration"), QObject::tr("relative residual"));
    chart.kind = Chart::Kind::curves;
    chart.empty_text = QObject::tr("Measures how multigrid converges on the levels.");
    for (std::size_t i = 0; i < curves.size(); ++i) {
        chart.series.push_back({QString::fromStdString(curves[i].title),
                                level_colour(static_cast<int>(i)), curves[i].residuals, false});
    }
    return chart;
}

} // namespace ameco::gui
