// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Words that our pages are made of: HTML that needs no other file and no network.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ameco::html {

struct Column {
    std::string heading;
    bool text = false;         ///< set to the left; numbers stand to the right
    std::string explanation{}; ///< shown where the mouse rests on the heading
};

/// Rows of plain text below each other, and as comma-separated values.
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<std::string>> rows; ///< one cell per column
};

[[nodiscard]] std::string text_of(const Table& table);

/// RFC 4180, numbers without the commas that group their digits.
[[nodiscard]] std::string csv_of(const Table& table);

/// Names and values below each other.
[[nodiscard]] std::string facts(const std::vector<std::pair<std::string, std::string>>& facts);

/// A heading with what belongs below it.
/// \param id  unique in the page, for links
[[nodiscard]] std::string section(const std::string& id, const std::string& title,
                                  const std::string& body);

/// A picture with a line below it.
[[nodiscard]] std::string figure(const std::string& svg, const std::string& caption);

/// The whole page: light or dark as the reader's system is, and fit for paper.
[[nodiscard]] std::string page(const std::string& title, const std::string& body);

} // namespace ameco::html
