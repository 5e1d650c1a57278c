// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Results for people: tables, numbers and bars as text. (For programs: statistics_json.h.)
#pragma once

#include "core/base/text.h"
#include "core/metric/aspect_ratio.h"

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace ameco::cli {

/// Columns of text, aligned. The first row is the heading. Widths may be given, for a table that is
/// printed row by row while its rows are made.
class Table {
public:
    enum class Align { left, right };
    struct Column {
        std::string heading;
        Align align = Align::right;
        int min_width = 0;
    };

    explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

    /// One cell per column.
    void add_row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

    void print(std::ostream& out) const;
    /// For a table that grows: the heading, and one row, in the columns' `min_width`.
    void print_heading(std::ostream& out) const;
    void print_row(std::ostream& out, const std::vector<std::string>& cells) const;

private:
    [[nodiscard]] std::vector<std::size_t> widths() const;
    void print_cells(std::ostream& out, const std::vector<std::string>& cells,
                     const std::vector<std::size_t>& widths) const;

    std::vector<Column> columns_;
    std::vector<std::vector<std::string>> rows_;
};

/// "name   value" lines with the values below each other.
void print_facts(std::ostream& out, const std::vector<std::pair<std::string, std::string>>& facts);

/// The paper's Table 3: one row per class, from the most stretched nodes to the isotropic ones.
void print_aspect_ratio_classes(std::ostream& out, const AspectRatioClasses& classes);

/// Figures 11 and 18: for each class a row with one bar per level, each bar the share of that
/// level's nodes.
void print_aspect_ratio_histogram(std::ostream& out, const std::vector<AspectRatioClasses>& levels);

} // namespace ameco::cli
