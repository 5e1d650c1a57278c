// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/module.h"
#include "gui/window_job.h"

#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdlib>
#include <filesystem>

namespace ameco::cli {
namespace {

class WindowCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {"window",
                "Open the window: look at meshes, coarsen them, compare levels.",
                "window [FILE...] [options]",
                {{"window wing.meshb", "a mesh"},
                 {"window levels", "a hierarchy: the folder that coarsen made"},
                 {"window wing.ameco", "a session that was saved"}},
                "On a screen, ameco FILE is short for ameco window FILE, and ameco alone opens an "
                "empty window.\n"
                "Exit code 8: there is no screen, or this ameco was built without the window."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("FILE", files_, "meshes, folders of hierarchies, or sessions (.ameco)");
        app.add_flag("--dark", dark_, "dark colours");
    }

    ExitCode run(Session& session) override {
        for (const std::string& file : files_) {
            std::error_code ignored;
            if (!std::filesystem::exists(file, ignored)) {
                throw FileError(file + ": there is no such file");
            }
        }
        if (!has_display()) {
            throw Error(ExitCode::not_built,
                        "there is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set): all "
                        "other commands work without one, and ameco render makes pictures");
        }
        const auto open = load_function<gui::OpenWindow>("ameco_window", "ameco_open_window");
        session.monitor.clear_line();
        // Ctrl-C in the terminal ends a window as it ends other programs.
        std::signal(SIGINT, SIG_DFL);
        std::signal(SIGTERM, SIG_DFL);
        gui::WindowResult result;
        open({files_, session.threads, dark_}, result);
        if (!result.error.empty()) {
            throw Error(result.code, result.error);
        }
        return result.code;
    }

private:
    std::vector<std::string> files_;
    bool dark_ = false;
};

bool is_set(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr && *value != '\0';
}

} // namespace

bool has_display() {
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY") || is_set("QT_QPA_PLATFORM");
}

std::unique_ptr<Command> make_window_command() {
    return std::make_unique<WindowCommand>();
}

} // namespace ameco::cli
