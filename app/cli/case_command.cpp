// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/body_layers.h"
#include "app/cli/commands.h"
#include "app/cli/help.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "core/cases/cases.h"
#include "core/cases/layer.h"
#include "core/hierarchy/statistics_json.h"

#include <CLI/CLI.hpp>

#include <map>

namespace ameco::cli {
namespace {

/// The cases are commands within this command, so that each has its own options and help.
class CaseCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {"case",
                "Make a mesh by formula: something to try, test and compare with.",
                "case NAME -o MESH [--parameter value ...]",
                {{"case --list", "which there are"},
                 {"case onera-m6 --help", "its parameters"},
                 {"case onera-m6 -o m6.meshb", "make it"}},
                ""};
    }

    void add_options(CLI::App& app) override {
        app.add_flag("--list", list_, "list the cases and leave");
        app.require_subcommand(0, 1);
        for (const CaseDescription& description : cases()) {
            add_case(app, description);
        }
    }

    ExitCode run(Session& session) override {
        if (list_ || chosen() == nullptr) {
            if (!list_) {
                throw UsageError("which case? (ameco case --list shows them)");
            }
            print_list(session);
            return ExitCode::ok;
        }
        require_suffix(output_, {".meshb", ".mesh"});
        const std::string& name = chosen()->get_name();
        if (name == "layer" && !body_.surface.empty()) {
            run_on_surface(session);
            return ExitCode::ok;
        }
        if (name == "layer" && body_was_asked_for()) {
            throw UsageError("case layer: --first-height, --layers and --farfield need --surface");
        }
        session.monitor.progress(0, "making " + name);
        const auto mesh = make_case(name, given_parameters());
        session.monitor.progress(0.5, "writing " + output_);
        std::visit([&](const auto& m) { write(m, name, session); }, mesh);
        return ExitCode::ok;
    }

private:
    [[nodiscard]] bool body_was_asked_for() const {
        return chosen()->count("--first-height") + chosen()->count("--layers") +
                   chosen()->count("--farfield") >
               0;
    }

    void run_on_surface(Session& session) const {
        const auto given = given_parameters();
        for (const auto& [parameter, value] : given) {
            if (parameter != "growth") {
                throw UsageError("case layer --surface: --" + parameter +
                                 " is a parameter of the plate");
            }
        }
        double growth = LayerOptions{}.growth;
        if (const auto text = given.find("growth"); text != given.end()) {
            const auto number = numbers_from(text->second);
            if (number.size() != 1 || number[0] < 1 || number[0] > 10) {
                throw UsageError("layer: growth: " + text->second + " is not between 1 and 10");
            }
            growth = number[0];
        }
        body_.run(growth, output_, session);
    }

    void add_case(CLI::App& app, const CaseDescription& description) {
        CLI::App* const sub = app.add_subcommand(description.name, description.summary);
        sub->fallthrough();
        sub->set_help_flag("-h,--help", "print this help")->group("");
        sub->formatter(std::make_shared<HelpFormatter>(
            CommandHelp{"case " + description.name,
                        description.summary,
                        "case " + description.name + " -o MESH [options]",
                        {{"case " + description.name + " -o " + description.name + ".meshb",
                          "make it with the values below"}},
                        ""}));
        sub->add_option("-o,--output", output_, "mesh to write (.meshb, .mesh)")
            ->type_name("MESH")
            ->required();
        for (const CaseParameter& parameter : description.parameters) {
            std::string text = parameter.help;
            text += parameter.range.empty() ? "" : " (" + parameter.range + ")";
            text += parameter.unit.empty() ? "" : " in " + parameter.unit;
            CLI::Option* const option = sub->add_option(
                "--" + parameter.name, values_[description.name + " " + parameter.name], text);
            option->type_name("VALUE");
            option->default_str(parameter.default_value);
            option->group("Parameters");
        }
        if (description.name == "layer") {
            body_.add_options(*sub);
        }
        apps_.push_back(sub);
    }

    [[nodiscard]] const CLI::App* chosen() const {
        for (const CLI::App* app : apps_) {
            if (app->parsed()) {
                return app;
            }
        }
        return nullptr;
    }

    [[nodiscard]] std::map<std::string, std::string> given_parameters() const {
        std::map<std::string, std::string> given;
        for (const CaseDescription& description : cases()) {
            for (const CaseParameter& parameter : description.parameters) {
                if (description.name == chosen()->get_name() &&
                    chosen()->get_option("--" + parameter.name)->count() > 0) {
                    given[parameter.name] = values_.at(description.name + " " + parameter.name);
                }
            }
        }
        return given;
    }

    template <int D>
    void write(const Mesh<D>& mesh, const std::string& name, Session& session) const {
        write_mesh(output_, mesh);
        session.monitor.clear_line();
        const auto nodes = static_cast<std::int64_t>(mesh.points.size());
        const auto elements = static_cast<std::int64_t>(mesh.elements.size());
        const auto faces = static_cast<std::int64_t>(mesh.faces.size());
        if (session.json) {
            session.out << Json{{"case", name},   {"file", output_},      {"dimension", D},
                                {"nodes", nodes}, {"elements", elements}, {"boundary_faces", faces}}
                               .dump(2)
                        << '\n';
        } else if (session.verbosity >= 0) {
            session.out << output_ << ": " << name << ", " << count_text(nodes) << " nodes, "
                        << count_text(elements) << " " << element_word(D) << ", "
                        << count_text(faces) << " boundary faces\n";
        }
    }

    static void print_list(Session& session) {
        if (!session.json) {
            Facts facts;
            for (const CaseDescription& description : cases()) {
                facts.emplace_back(description.name, description.summary);
            }
            print_facts(session.out, facts);
            return;
        }
        Json list = Json::array();
        for (const CaseDescription& description : cases()) {
            Json parameters = Json::array();
            for (const CaseParameter& p : description.parameters) {
                parameters.push_back({{"name", p.name},
                                      {"default", p.default_value},
                                      {"unit", p.unit},
                                      {"range", p.range},
                                      {"help", p.help}});
            }
            list.push_back({{"name", description.name},
                            {"summary", description.summary},
                            {"parameters", parameters}});
        }
        session.out << list.dump(2) << '\n';
    }

    bool list_ = false;
    BodyLayers body_;
    std::string output_;
    std::map<std::string, std::string> values_; ///< "case parameter" -> what was given
    std::vector<const CLI::App*> apps_;
};

} // namespace

std::unique_ptr<Command> make_case_command() {
    return std::make_unique<CaseCommand>();
}

} // namespace ameco::cli
