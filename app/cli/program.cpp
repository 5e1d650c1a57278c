// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/program.h"

#include "app/cli/commands.h"
#include "app/cli/help.h"
#include "app/cli/options.h"
#include "app/cli/suggest.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>

#include <sys/ioctl.h>
#include <unistd.h>

namespace ameco::cli {
namespace {

struct CommonOptions {
    bool quiet = false;
    bool verbose = false;
    bool json = false;
    std::string progress;
    int threads = 0;
};

void add_common_options(CLI::App& app, CommonOptions& common) {
    app.set_help_flag("-h,--help", "print this help")->group(common_group);
    app.add_flag("-q,--quiet", common.quiet, "print results and errors, nothing else")
        ->group(common_group);
    app.add_flag("-v,--verbose", common.verbose, "say more")->group(common_group);
    app.add_flag("--json", common.json, "print results as JSON")->group(common_group);
    app.add_option("--progress", common.progress,
                   "how progress is shown on stderr: bar, plain, json, none [bar on a terminal, "
                   "else plain]")
        ->type_name("STYLE")
        ->check(one_of({"bar", "plain", "json", "none"}))
        ->group(common_group);
    app.add_option("--threads", common.threads,
                   "threads to use; 0 takes all of the machine's. The result does not depend on it")
        ->type_name("N")
        ->check(whole_number(0, 4096))
        ->capture_default_str()
        ->group(common_group);
}

bool is_terminal(int fd) {
    return ::isatty(fd) == 1;
}

int terminal_width() {
    winsize size{};
    const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

MonitorSettings monitor_settings(const CommonOptions& common) {
    static const std::map<std::string, ProgressStyle> styles{{"bar", ProgressStyle::bar},
                                                             {"plain", ProgressStyle::plain},
                                                             {"json", ProgressStyle::json},
                                                             {"none", ProgressStyle::none}};
    MonitorSettings settings;
    const bool terminal = is_terminal(STDERR_FILENO);
    const auto chosen = styles.find(common.progress);
    settings.style = chosen != styles.end() ? chosen->second
                     : common.quiet         ? ProgressStyle::none
                     : terminal             ? ProgressStyle::bar
                                            : ProgressStyle::plain;
    settings.verbosity = common.quiet ? -1 : common.verbose ? 1 : 0;
    const char* const no_color = std::getenv("NO_COLOR");
    settings.color = terminal && (no_color == nullptr || *no_color == '\0');
    settings.width = terminal_width();
    return settings;
}

/// The innermost command on the command line.
const CLI::App& parsed_app(const CLI::App& app) {
    const auto chosen = app.get_subcommands();
    return chosen.empty() ? app : parsed_app(*chosen.front());
}

std::string full_name(const CLI::App& app) {
    return app.get_parent() == nullptr ? "ameco"
                                       : full_name(*app.get_parent()) + " " + app.get_name();
}

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& word : option->get_lnames()) {
            names.push_back("--" + word);
        }
    }
    if (app.get_fallthrough() && app.get_parent() != nullptr) {
        const auto more = option_names(*app.get_parent());
        names.insert(names.end(), more.begin(), more.end());
    }
    return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return names;
}

/// What is wrong with a word that the parser could make nothing of.
std::string unknown_word(const CLI::App& app, const std::string& word) {
    if (word.starts_with('-')) {
        const std::string option = word.substr(0, word.find('='));
        return "unknown option " + option + did_you_mean(option, option_names(app));
    }
    if (app.get_subcommands([](const CLI::App*) { return true; }).empty()) {
        return "one argument too many: " + word;
    }
    std::error_code ignored;
    if (app.get_parent() == nullptr && std::filesystem::exists(word, ignored)) {
        return word + " is a file, not a command: try ameco info " + word;
    }
    const std::string kind = app.get_parent() == nullptr ? "command" : app.get_name();
    return "unknown " + kind + " " + word + did_you_mean(word, command_names(app));
}

std::string usage_error_text(const CLI::App& app, const CLI::ParseError& error) {
    const CLI::App& chosen = parsed_app(app);
    std::vector<std::string> rest = chosen.remaining();
    if (rest.empty()) {
        rest = app.remaining(true);
    }
    const bool has_commands = !chosen.get_subcommands([](const CLI::App*) { return true; }).empty();
    if (has_commands && !rest.empty() && !rest.front().starts_with('-')) {
        return unknown_word(chosen, rest.front()); // the words after it belong to it
    }
    // An unknown option is the better explanation when something else is missing, too.
    for (const std::string& word : rest) {
        if (word.starts_with('-') && word != "-" && word != "--") {
            return unknown_word(chosen, word);
        }
    }
    if (!rest.empty() && dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
        return unknown_word(chosen, rest.front());
    }
    std::string text = error.what();
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
        if (const std::size_t at = text.find("is required"); at != std::string::npos) {
            text.replace(at, std::string("is required").size(), "is missing");
        }
    }
    return text;
}

/// The command line's parser with all commands.
class Program {
public:
    Program() {
        app_.name("ameco");
        add_common_options(app_, common_);
        app_.set_version_flag("--version", std::string("ameco ") + AMECO_VERSION,
                              "print the version")
            ->group(common_group);
        std::vector<CommandHelp> helps;
        for (const auto& command : commands_) {
            helps.push_back(command->help());
            CLI::App* const sub = app_.add_subcommand(helps.back().name, helps.back().summary);
            sub->formatter(std::make_shared<HelpFormatter>(helps.back()));
            add_common_options(*sub, common_);
            command->add_options(*sub);
            by_app_[sub] = command.get();
        }
        app_.formatter(std::make_shared<ProgramHelpFormatter>(std::move(helps)));
        app_.require_subcommand(0, 1);
    }

    ExitCode run(int argc, const char* const* argv, TerminalMonitor& monitor) {
        if (!parse(with_window(argc, argv))) {
            return ExitCode::ok;
        }
        monitor.configure(monitor_settings(common_));
        set_thread_count(common_.threads);
        const auto chosen = app_.get_subcommands();
        if (chosen.empty()) {
            std::cout << app_.help();
            return ExitCode::ok;
        }
        Session session{std::cout, monitor, common_.json, monitor.settings().verbosity,
                        common_.threads};
        const ExitCode code = by_app_.at(chosen.front())->run(session);
        std::cout.flush();
        if (!std::cout) {
            throw FileError("standard output: cannot be written: is the disk full?");
        }
        return code;
    }

private:
    /// The words after the program's name. On a screen a file as the first one opens it in the
    /// window, and so does nothing at all when somebody sits there; scripts get the help.
    [[nodiscard]] std::vector<std::string> with_window(int argc, const char* const* argv) const {
        std::vector<std::string> words(argv + 1, argv + argc);
        if (!has_display()) {
            return words;
        }
        const std::vector<std::string> commands = command_names(app_);
        const auto is_command = [&](const std::string& word) {
            return std::find(commands.begin(), commands.end(), word) != commands.end();
        };
        std::error_code ignored;
        const bool opens_file = !words.empty() && !words.front().starts_with('-') &&
                                !is_command(words.front()) &&
                                std::filesystem::exists(words.front(), ignored);
        if (opens_file || (words.empty() && is_terminal(STDOUT_FILENO))) {
            words.insert(words.begin(), "window");
        }
        return words;
    }

    /// \return false when help or the version was asked for and printed
    bool parse(std::vector<std::string> words) {
        std::reverse(words.begin(), words.end()); // as the parser wants them
        try {
            app_.parse(std::move(words));
            return true;
        } catch (const CLI::CallForHelp&) {
            const CLI::App& chosen = parsed_app(app_);
            std::cout << chosen.get_formatter()->make_help(&chosen, "", CLI::AppFormatMode::Normal);
        } catch (const CLI::CallForVersion& version) {
            std::cout << version.what() << '\n';
        } catch (const CLI::ParseError& error) {
            throw UsageError(usage_error_text(app_, error) + " (see " +
                             full_name(parsed_app(app_)) + " --help)");
        }
        return false;
    }

    CLI::App app_;
    CommonOptions common_;
    std::vector<std::unique_ptr<Command>> commands_ = all_commands();
    std::map<const CLI::App*, Command*> by_app_;
};

} // namespace

ExitCode run_program(int argc, const char* const* argv) {
    TerminalMonitor monitor(std::cerr, monitor_settings({}));
    try {
        Program program;
        handle_interrupts();
        return program.run(argc, argv, monitor);
    } catch (const Error& error) {
        monitor.message(Severity::error, error.what());
        return error.code();
    }
}

} // namespace ameco::cli
