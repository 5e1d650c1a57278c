// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/report.h"
#include "core/io/format.h"

#include <nlohmann/json.hpp>

#include <CLI/CLI.hpp>

namespace ameco::cli {
namespace {

std::string suffixes_of(const Format& format) {
    std::string text;
    for (const std::string_view suffix : format.suffixes) {
        text += (text.empty() ? "" : " ") + std::string(suffix);
    }
    return text;
}

nlohmann::ordered_json formats_json() {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Format& format : formats()) {
        nlohmann::ordered_json kept = nlohmann::ordered_json::array();
        for (const KeepsColumn& column : keeps_columns) {
            if ((format.keeps & column.what) != 0) {
                kept.push_back(column.heading);
            }
        }
        list.push_back({{"name", format.name},
                        {"title", format.title},
                        {"suffixes", format.suffixes},
                        {"holds", format.is_metric() ? "metric" : "mesh"},
                        {"reads", format.reads()},
                        {"writes", format.writes()},
                        {"keeps", kept},
                        {"remark", format.remark}});
    }
    return list;
}

void print_table(std::ostream& out, bool metrics) {
    using Align = Table::Align;
    std::vector<Table::Column> columns{{"name", Align::left},
                                       {"format", Align::left},
                                       {"read", Align::left},
                                       {"write", Align::left}};
    for (const KeepsColumn& column : keeps_columns) {
        if (!metrics || column.what == keeps_2d || column.what == keeps_3d) {
            columns.push_back({std::string(column.heading), Align::left});
        }
    }
    columns.push_back({"suffixes", Align::left});
    const std::size_t kept = columns.size() - 5;
    Table table(columns);
    for (const Format& format : formats()) {
        if (format.is_metric() != metrics) {
            continue;
        }
        std::vector<std::string> row{std::string(format.name), std::string(format.title),
                                     format.reads() ? "yes" : "-", format.writes() ? "yes" : "-"};
        for (std::size_t i = 0; i < kept; ++i) {
            row.emplace_back((format.keeps & keeps_columns[i].what) != 0 ? "x" : "-");
        }
        row.push_back(suffixes_of(format));
        table.add_row(row);
    }
    table.print(out);
}

class FormatsCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {"formats",
                "List the file formats: what is read, written and kept.",
                "formats [options]",
                {{"formats", "the table"}, {"formats --json", "the same for programs"}},
                "The columns from 2-D on say what a file of the format can hold. convert tells in "
                "one line what of a mesh is left out."};
    }

    void add_options(CLI::App&) override {}

    ExitCode run(Session& session) override {
        if (session.json) {
            session.out << formats_json().dump(2) << '\n';
            return ExitCode::ok;
        }
        session.out << "meshes\n";
        print_table(session.out, false);
        session.out << "\nmetrics\n";
        print_table(session.out, true);
        std::string absent;
        for (const Format& format : formats()) {
            if (!format.reads() && !format.writes()) {
                absent += (absent.empty() ? "" : ", ") + std::string(format.name);
            }
        }
        if (!absent.empty()) {
            session.out << "\nleft out of this build: " << absent << '\n';
        }
        return ExitCode::ok;
    }
};

} // namespace

std::unique_ptr<Command> make_formats_command() {
    return std::make_unique<FormatsCommand>();
}

} // namespace ameco::cli
