// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/level_table.h"

#include "app/cli/mesh_input.h"

#include <cmath>

namespace ameco::cli {
namespace {

void print_verdict_table(std::ostream& out, const Hierarchy& hierarchy, const std::string& heading,
                         VerdictCounts LevelStatistics::*counts) {
    std::vector<Table::Column> columns{{heading, Table::Align::left}};
    for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
        columns.push_back({"level " + std::to_string(k)});
    }
    Table table(columns);
    for (std::size_t v = 0; v < verdict_count; ++v) {
        const auto verdict = static_cast<Verdict>(v);
        std::vector<std::string> row{"  " + std::string(name(verdict))};
        bool occurred = false;
        for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
            const std::int64_t count = (hierarchy.levels[k].statistics.*counts)[verdict];
            occurred = occurred || count > 0;
            row.push_back(count_text(count));
        }
        if (occurred) {
            table.add_row(std::move(row));
        }
    }
    out << '\n';
    table.print(out);
}

} // namespace

LevelTable::LevelTable(std::ostream& out, int dimension)
    : out_(out), table_({{"level"},
                         {"nodes", Table::Align::right, 9},
                         {element_word(dimension), Table::Align::right, 10},
                         {"ratio"},
                         {"predicted", Table::Align::right, 9},
                         {"of that", Table::Align::right, 7},
                         {"max AR", Table::Align::right, 7},
                         {"top 5 %", Table::Align::right, 7},
                         {"AR < 5", Table::Align::right, 7},
                         {"in band", Table::Align::right, 7},
                         {"seconds", Table::Align::right, 7}}) {
    table_.print_heading(out_);
}

void LevelTable::add(const LevelStatistics& level, double seconds) {
    const bool coarse = level.level > 0;
    table_.print_row(
        out_, {std::to_string(level.level), count_text(level.nodes), count_text(level.elements),
               coarse ? ratio_text(level.ratio) : "",
               coarse ? count_text(std::llround(level.predicted_nodes)) : "",
               coarse ? percent_text(static_cast<double>(level.nodes) / level.predicted_nodes) : "",
               number_text(level.aspect_ratio.max), number_text(level.aspect_ratio.top_5_percent),
               percent_text(level.aspect_ratio.share_isotropic),
               percent_text(level.conformity.in_band), number_text(seconds, 3)});
}

void print_verdicts(std::ostream& out, const Hierarchy& hierarchy) {
    if (hierarchy.levels.size() < 2) {
        return;
    }
    print_verdict_table(out, hierarchy, "node removals", &LevelStatistics::removal);
    print_verdict_table(out, hierarchy, "swaps", &LevelStatistics::swaps);
    if (hierarchy.options.coarsen.nodes == CoarseNodes::moved) {
        print_verdict_table(out, hierarchy, "moves", &LevelStatistics::moves);
    }
}

} // namespace ameco::cli
