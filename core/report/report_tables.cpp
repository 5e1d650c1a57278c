// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/report/report_tables.h"

#include "core/base/svg.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

std::string seconds_text(double seconds) {
    return svg::number(seconds, 2);
}

std::string level_text(const LevelStatistics& level) {
    return std::to_string(level.level);
}

} // namespace

html::Table levels_table(const Hierarchy& hierarchy) {
    html::Table table;
    table.columns = {{"level"},
                     {"nodes"},
                     {hierarchy.dimension == 3 ? "tets" : "triangles"},
                     {"boundary faces"},
                     {"ratio", false, "nodes of the finer level over nodes of this one"},
                     {"factor", false, "coarse size over fine size that was asked for"},
                     {"predicted", false, "nodes that the metric asks for"},
                     {"of that", false, "nodes there are, as a share of those predicted"},
                     {"max AR", false, "largest aspect ratio of a node's metric"},
                     {"top 5 %", false, "5 % of the nodes have an aspect ratio above this"},
                     {"median AR"},
                     {"AR < 5", false, "share of the nodes that are isotropic"}};
    for (const HierarchyLevel& entry : hierarchy.levels) {
        const LevelStatistics& s = entry.statistics;
        const bool coarse = s.level > 0;
        table.rows.push_back(
            {level_text(s), count_text(s.nodes), count_text(s.elements), count_text(s.faces),
             coarse ? ratio_text(s.ratio) : "", coarse ? number_text(s.factor, 3) : "",
             coarse ? count_text(std::llround(s.predicted_nodes)) : "",
             coarse ? percent_text(static_cast<double>(s.nodes) / s.predicted_nodes) : "",
             number_text(s.aspect_ratio.max), number_text(s.aspect_ratio.top_5_percent),
             number_text(s.aspect_ratio.median, 3), percent_text(s.aspect_ratio.share_isotropic)});
    }
    return table;
}

html::Table classes_table(const Hierarchy& hierarchy) {
    html::Table table;
    table.columns = {{"class"}, {"aspect ratio", true}};
    if (hierarchy.levels.empty()) {
        return table;
    }
    for (const HierarchyLevel& level : hierarchy.levels) {
        table.columns.push_back({"level " + level_text(level.statistics)});
        table.columns.push_back({"%"});
    }
    const AspectRatioClasses& edges = hierarchy.levels[0].statistics.classes;
    for (std::size_t c = 0; c < edges.counts.size(); ++c) {
        std::vector<std::string> row{std::to_string(c + 1),
                                     number_text(std::max(1.0, edges.lower(c))) + " to " +
                                         number_text(edges.upper(c))};
        for (const HierarchyLevel& level : hierarchy.levels) {
            const LevelStatistics& s = level.statistics;
            const std::int64_t count = c < s.classes.counts.size() ? s.classes.counts[c] : 0;
            row.push_back(count_text(count));
            row.push_back(percent_text(static_cast<double>(count) / static_cast<double>(s.nodes)));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

html::Table conformity_table(const Hierarchy& hierarchy) {
    html::Table table;
    table.columns = {{"level"},
                     {"edges"},
                     {"in band", false, "length in the metric from 0.71 to 1.41"},
                     {"below 0.5"},
                     {"above 2"},
                     {"shortest"},
                     {"longest"},
                     {"mean quality", false, "1 for an element that is equilateral in the metric"},
                     {"worst quality"}};
    for (const HierarchyLevel& level : hierarchy.levels) {
        const Conformity& c = level.statistics.conformity;
        table.rows.push_back({level_text(level.statistics), count_text(c.edges),
                              percent_text(c.in_band), percent_text(c.below_half),
                              percent_text(c.above_two), number_text(c.shortest, 3),
                              number_text(c.longest, 3), number_text(c.mean_quality, 3),
                              number_text(c.worst_quality, 3)});
    }
    return table;
}

html::Table geometry_table(const Hierarchy& hierarchy) {
    html::Table table;
    table.columns = {
        {"level"},
        {hierarchy.dimension == 3 ? "volume" : "area"},
        {"change", false, "against level 0"},
        {"boundary distance", false,
         "bound of the distance between this level's boundary and that of level 0"},
        {"over local size", false, "the same, over the mean edge of the surface mesh there"},
        {"lines", false, "lines of nodes across layers, found on the finer level"},
        {"nodes on them"}};
    for (const HierarchyLevel& level : hierarchy.levels) {
        const LevelStatistics& s = level.statistics;
        const double finest = hierarchy.levels[0].statistics.volume;
        const bool coarse = s.level > 0;
        table.rows.push_back({level_text(s), number_text(s.volume, 10),
                              coarse ? number_text(s.volume / finest - 1, 3) : "",
                              coarse ? number_text(s.deviation, 3) : "",
                              coarse ? number_text(s.deviation_relative, 3) : "",
                              coarse ? count_text(s.lines) : "",
                              coarse ? count_text(s.line_nodes) : ""});
    }
    return table;
}

html::Table removals_table(const Hierarchy& hierarchy) {
    html::Table table;
    table.columns = {{"verdict", true}};
    for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
        table.columns.push_back({"level " + std::to_string(k)});
    }
    for (std::size_t v = 0; v < verdict_count; ++v) {
        const auto verdict = static_cast<Verdict>(v);
        std::vector<std::string> row{std::string(name(verdict))};
        bool occurred = false;
        for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
            const std::int64_t count = hierarchy.levels[k].statistics.removal[verdict];
            occurred = occurred || count > 0;
            row.push_back(count_text(count));
        }
        if (occurred) {
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

html::Table times_table(const std::vector<LevelTiming>& timings) {
    html::Table table;
    table.columns = {{"level"},  {"metric"},   {"order"},   {"first pass"},
                     {"remove"}, {"swap"},     {"check"},   {"statistics"},
                     {"write"},  {"transfer"}, {"all [s]"}, {"peak memory"}};
    for (const LevelTiming& t : timings) {
        table.rows.push_back(
            {std::to_string(t.level), seconds_text(t.phases.metric), seconds_text(t.phases.order),
             seconds_text(t.phases.first_pass), seconds_text(t.phases.remove),
             seconds_text(t.phases.swap), seconds_text(t.phases.check), seconds_text(t.statistics),
             seconds_text(t.write), seconds_text(t.transfer), seconds_text(t.total()),
             bytes_text(static_cast<double>(t.peak_memory))});
    }
    return table;
}

} // namespace ameco
