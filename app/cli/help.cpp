// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/help.h"

#include <algorithm>
#include <sstream>

namespace ameco::cli {
namespace {

constexpr std::size_t line_width = 80;
constexpr std::size_t name_width = 26;

/// `text` in lines that begin at column `start`; the first one is begun already.
std::string wrapped(const std::string& text, std::size_t start) {
    std::string out;
    std::size_t column = start;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (column > start && column + 1 + word.size() > line_width) {
            out += '\n' + std::string(start, ' ');
            column = start;
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

/// `text` after `name`, with the following lines indented to the same column.
std::string entry(const std::string& name, const std::string& text, std::size_t width) {
    std::string out = "  " + name;
    const std::size_t start = width + 4;
    if (out.size() + 2 > start) {
        out += '\n' + std::string(start, ' ');
    } else {
        out.resize(start, ' ');
    }
    return out + wrapped(text, start);
}

/// Paragraphs, one per line of `text`.
std::string paragraphs(const std::string& text) {
    std::string out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        out += "\n" + wrapped(line, 0);
    }
    return out;
}

/// The commands within a command.
std::string subcommands_text(const CLI::App& app, const std::string& heading) {
    std::string lines;
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
        lines += entry(sub->get_name(), sub->get_description(), 14);
    }
    return lines.empty() ? "" : "\n" + heading + ":\n" + lines;
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
    text += subcommands_text(*app, "NAME is one of");
    text += option_group(*app, "Arguments", "Options", true);
    const std::vector<std::string> groups = app->get_groups();
    for (const std::string& group : groups) {
        if (group != common_group && !group.empty()) {
            text += option_group(*app, group, group, false);
        }
    }
    // The parameters of one case belong to a command within a command: the common options are the
    // outer one's.
    const CLI::App* owner = app->get_fallthrough() ? app->get_parent() : app;
    text += option_group(*owner, common_group, common_group, false);
    return text + paragraphs(help_.notes);
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
    std::size_t width = 0;
    for (const CommandHelp& command : commands_) {
        width = std::max(width, command.name.size());
    }
    for (const CommandHelp& command : commands_) {
        text += entry(command.name, command.summary, width);
    }
    text += option_group(*app, "Options", common_group, false);
    return text + "\nMore about a command: ameco COMMAND --help\n";
}

} // namespace ameco::cli
