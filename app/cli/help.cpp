// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/help.h"

#include <algorithm>
#include <sstream>

namespace ameco::cli {
namespace {

constexpr std::size_t line_width = 80;
constexpr std::size_t name_width = 26;

/// `text` after `name`, wrapped, with the following lines indented to the same column.
std::string entry(const std::string& name, const std::string& text, std::size_t width) {
    std::string out = "  " + name;
    std::size_t column = out.size();
    const std::size_t start = width + 4;
    const auto to_start = [&] {
        out += '\n' + std::string(start, ' ');
        column = start;
    };
    if (column + 2 > start) {
        to_start();
    } else {
        out += std::string(start - column, ' ');
        column = start;
    }
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (column > start && column + 1 + word.size() > line_width) {
            to_start();
        }
        if (column > start) {
            out += ' ';
            ++column;
        }
        out += word;
        column += word.size();
    }
    return out + '\n';
}

std::string option_name(const CLI::Option& option) {
    const std::string type = option.get_type_size() > 0 ? option.get_type_name() : "";
    if (!option.nonpositional()) {
        return option.get_name(true);
    }
    std::string name;
    for (const std::string& letter : option.get_snames()) {
        name += (name.empty() ? "-" : ", -") + letter;
    }
    for (const std::string& word : option.get_lnames()) {
        name += (name.empty() ? "    --" : ", --") + word;
    }
    return name + (type.empty() ? "" : " " + type);
}

std::string option_text(const CLI::Option& option) {
    std::string text = option.get_description();
    if (!option.get_default_str().empty()) {
        text += " [" + option.get_default_str() + "]";
    }
    return text;
}

std::string option_group(const CLI::App& app, const std::string& heading, const std::string& group,
                         bool positional) {
    std::string lines;
    for (const CLI::Option* option : app.get_options([&](const CLI::Option* o) {
             return o->get_group() == group && o->nonpositional() != positional;
         })) {
        lines += entry(option_name(*option), option_text(*option), name_width);
    }
    return lines.empty() ? "" : "\n" + heading + ":\n" + lines;
}

std::string examples_text(const std::vector<Example>& examples) {
    std::string text;
    for (const Example& example : examples) {
        text += "  ameco " + example.command + "\n      " + example.what + "\n";
    }
    return text.empty() ? "" : "\nExamples:\n" + text;
}

} // namespace

std::string HelpFormatter::make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const {
    std::string text = help_.summary + "\n" + examples_text(help_.examples) + "\nUsage:\n  ameco " +
                       help_.usage + "\n";
    text += option_group(*app, "Arguments", "Options", true);
    std::vector<std::string> groups = app->get_groups();
    for (const std::string& group : groups) {
        if (group != common_group && !group.empty()) {
            text += option_group(*app, group, group, false);
        }
    }
    // The parameters of one case belong to a command within a command: the common options are the
    // outer one's.
    const CLI::App* owner = app->get_fallthrough() ? app->get_parent() : app;
    text += option_group(*owner, common_group, common_group, false);
    return text + (help_.notes.empty() ? "" : "\n" + help_.notes + "\n");
}

std::string ProgramHelpFormatter::make_help(const CLI::App* app, std::string,
                                            CLI::AppFormatMode) const {
    std::string text =
        "ameco coarsens extremely stretched meshes of triangles or tetrahedra into the\n"
        "sequence of levels that geometric multigrid needs.\n";
    text += examples_text(
        {{"coarsen wing.meshb -o levels", "make four coarser levels in the folder levels"},
         {"info wing.meshb", "look at a mesh: patches, stretching, memory needed"},
         {"case onera-m6 -o m6.meshb", "make a mesh to try it on"}});
    text += "\nUsage:\n  ameco COMMAND [arguments] [options]\n\nCommands:\n";
    for (const CommandHelp& command : commands_) {
        text += entry(command.name, command.summary, 8);
    }
    text += option_group(*app, "Options", common_group, false);
    return text + "\nMore about a command: ameco COMMAND --help\n";
}

} // namespace ameco::cli
