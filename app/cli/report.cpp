// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/report.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace ameco::cli {
namespace {

/// Columns a text takes on a terminal: UTF-8 continuation bytes take none.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

std::int64_t sum(const std::vector<std::int64_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

double share(std::int64_t part, std::int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

/// A bar of at most `width` characters.
std::string bar(double share_of_full, int width) {
    return std::string(static_cast<std::size_t>(std::lround(share_of_full * width)), '#');
}

std::string class_range(const AspectRatioClasses& classes, std::size_t k) {
    const double lower = k + 1 == classes.counts.size() ? 1 : classes.lower(k);
    return number_text(lower) + " - " + number_text(classes.upper(k));
}

} // namespace

std::vector<std::size_t> Table::widths() const {
    std::vector<std::size_t> result(columns_.size());
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        result[c] = std::max(width_of(columns_[c].heading),
                             static_cast<std::size_t>(columns_[c].min_width));
        for (const auto& row : rows_) {
            result[c] = std::max(result[c], width_of(row[c]));
        }
    }
    return result;
}

void Table::print_cells(std::ostream& out, const std::vector<std::string>& cells,
                        const std::vector<std::size_t>& column_widths) const {
    std::string line;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        const std::size_t used = width_of(cells[c]);
        const std::string space(column_widths[c] > used ? column_widths[c] - used : 0, ' ');
        line += c == 0 ? "" : "  ";
        line += columns_[c].align == Align::right ? space + cells[c] : cells[c] + space;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
}

void Table::print(std::ostream& out) const {
    const auto column_widths = widths();
    std::vector<std::string> heading;
    for (const Column& column : columns_) {
        heading.push_back(column.heading);
    }
    print_cells(out, heading, column_widths);
    for (const auto& row : rows_) {
        print_cells(out, row, column_widths);
    }
}

void Table::print_heading(std::ostream& out) const {
    Table(columns_).print(out);
    out << std::flush;
}

void Table::print_row(std::ostream& out, const std::vector<std::string>& cells) const {
    print_cells(out, cells, widths());
    out << std::flush;
}

void print_facts(std::ostream& out, const std::vector<std::pair<std::string, std::string>>& facts) {
    std::size_t width = 0;
    for (const auto& fact : facts) {
        width = std::max(width, width_of(fact.first));
    }
    for (const auto& [what, value] : facts) {
        out << "  " << what << std::string(width - width_of(what), ' ') << "  " << value << '\n';
    }
}

void print_aspect_ratio_classes(std::ostream& out, const AspectRatioClasses& classes) {
    const std::int64_t total = sum(classes.counts);
    const std::int64_t most = classes.counts.empty()
                                  ? 0
                                  : *std::max_element(classes.counts.begin(), classes.counts.end());
    Table table({{"class"}, {"aspect ratio"}, {"nodes"}, {"share"}, {"", Table::Align::left}});
    for (std::size_t k = 0; k < classes.counts.size(); ++k) {
        table.add_row({std::to_string(k + 1), class_range(classes, k),
                       count_text(classes.counts[k]), percent_text(share(classes.counts[k], total)),
                       bar(share(classes.counts[k], most), 30)});
    }
    table.print(out);
}

void print_aspect_ratio_histogram(std::ostream& out,
                                  const std::vector<AspectRatioClasses>& levels) {
    if (levels.empty()) {
        return;
    }
    double largest = 0;
    std::size_t class_count = 0;
    for (const AspectRatioClasses& level : levels) {
        const std::int64_t total = sum(level.counts);
        for (const std::int64_t count : level.counts) {
            largest = std::max(largest, share(count, total));
        }
        class_count = std::max(class_count, level.counts.size());
    }
    std::vector<Table::Column> columns{{"aspect ratio"}};
    for (std::size_t l = 0; l < levels.size(); ++l) {
        columns.push_back({"level " + std::to_string(l), Table::Align::left, 17});
    }
    Table table(columns);
    for (std::size_t k = 0; k < class_count; ++k) {
        std::vector<std::string> row{class_range(levels.front(), k)};
        for (const AspectRatioClasses& level : levels) {
            const double part =
                k < level.counts.size() ? share(level.counts[k], sum(level.counts)) : 0;
            const std::string text = part > 0 ? percent_text(part) : "";
            row.push_back(std::string(7 - std::min<std::size_t>(7, text.size()), ' ') + text + " " +
                          bar(largest > 0 ? part / largest : 0, 9));
        }
        table.add_row(std::move(row));
    }
    table.print(out);
}

} // namespace ameco::cli
