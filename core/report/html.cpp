// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/report/html.h"

#include "core/base/text.h"

#include <algorithm>

namespace ameco::html {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --ink: #1b1f24; --dim: #59636e; --line: #d5dae0; --back: #ffffff;
  --stripe: #f5f7f9; --accent: #1f4e79; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e8ec; --dim: #9aa4af; --line: #3a424b;
  --back: #16191d; --stripe: #1e2329; --accent: #7db4e6; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 76rem; color: var(--ink);
  background: var(--back); font: 15px/1.5 "Source Sans 3", "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.2rem; margin: 2.6rem 0 .6rem; padding-top: .6rem; border-top: 1px solid var(--line); }
p { margin: .4rem 0; max-width: 60rem; }
p.dim, figcaption { color: var(--dim); font-size: .9rem; }
nav { margin: 1.2rem 0; }
nav a { margin-right: 1rem; color: var(--accent); text-decoration: none; white-space: nowrap; }
nav a:hover { text-decoration: underline; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(8rem, 1fr)); gap: .7rem;
  margin: 1.2rem 0; }
.tiles div { border: 1px solid var(--line); border-radius: .4rem; padding: .6rem .8rem; }
.tiles b { display: block; font-size: 1.35rem; font-weight: 600; }
.tiles span { color: var(--dim); font-size: .85rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin: .5rem 0; }
th, td { padding: .22rem .7rem; text-align: right; white-space: nowrap; }
th { font-weight: 600; border-bottom: 2px solid var(--line); vertical-align: bottom; }
th[title] { text-decoration: underline dotted var(--dim); text-underline-offset: .2em; cursor: help; }
td { border-bottom: 1px solid var(--line); }
tbody tr:nth-child(even) { background: var(--stripe); }
.left { text-align: left; }
table.facts td:first-child { color: var(--dim); text-align: left; }
table.facts td:last-child { text-align: left; white-space: normal; overflow-wrap: anywhere; }
figure { margin: .8rem 0; }
figure svg { max-width: 100%; height: auto; border-radius: .4rem; border: 1px solid var(--line); }
code { font-family: "DejaVu Sans Mono", monospace; font-size: .88em; overflow-wrap: anywhere; }
@media print { :root { --ink: #000000; --dim: #444444; --back: #ffffff; --stripe: #f3f3f3;
  --line: #bbbbbb; --accent: #000000; } body { max-width: none; padding: 0; font-size: 9.5pt; }
  nav { display: none; } h2 { break-after: avoid; } figure, tr { break-inside: avoid; }
  th, td { padding: .12rem .4rem; } }
)";

std::string without_grouping(const std::string& cell) {
    const bool number = cell.find_first_not_of("0123456789,.-+e %") == std::string::npos;
    std::string out;
    std::copy_if(cell.begin(), cell.end(), std::back_inserter(out),
                 [&](char c) { return !(number && (c == ',' || c == ' ' || c == '%')); });
    return out;
}

std::string csv_cell(const std::string& cell) {
    const std::string plain = without_grouping(cell);
    if (plain.find_first_of(",\"\n") == std::string::npos) {
        return plain;
    }
    std::string quoted = "\"";
    for (const char c : plain) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

} // namespace

std::string text_of(const Table& table) {
    std::string out = "<div class=\"wide\"><table>\n<thead><tr>";
    for (const Column& column : table.columns) {
        out += column.text ? "<th class=\"left\"" : "<th";
        if (!column.explanation.empty()) {
            out += " title=\"" + xml_escaped(column.explanation) + '"';
        }
        out += '>' + xml_escaped(column.heading) + "</th>";
    }
    out += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        out += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            out += (table.columns[i].text ? "<td class=\"left\">" : "<td>") + xml_escaped(row[i]) +
                   "</td>";
        }
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

std::string csv_of(const Table& table) {
    std::string out;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        out += (i > 0 ? "," : "") + csv_cell(table.columns[i].heading);
    }
    out += "\r\n";
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            out += (i > 0 ? "," : "") + csv_cell(row[i]);
        }
        out += "\r\n";
    }
    return out;
}

std::string facts(const std::vector<std::pair<std::string, std::string>>& facts) {
    std::string out = "<table class=\"facts\"><tbody>\n";
    for (const auto& [name, value] : facts) {
        out += "<tr><td>" + xml_escaped(name) + "</td><td>" + xml_escaped(value) + "</td></tr>\n";
    }
    return out + "</tbody></table>\n";
}

std::string section(const std::string& id, const std::string& title, const std::string& body) {
    return "<section id=\"" + id + "\"><h2>" + xml_escaped(title) + "</h2>\n" + body +
           "</section>\n";
}

std::string figure(const std::string& svg, const std::string& caption) {
    return "<figure>" + svg + "<figcaption>" + xml_escaped(caption) + "</figcaption></figure>\n";
}

std::string page(const std::string& title, const std::string& body) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<link rel=\"icon\" href=\"data:,\">\n<title>" +
           xml_escaped(title) + "</title>\n<style>" + style + "</style></head>\n<body>\n" + body +
           "</body></html>\n";
}

} // namespace ameco::html
