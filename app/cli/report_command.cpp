// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "core/base/stop_check.h"
#include "core/base/text.h"
#include "core/hierarchy/hierarchy_folder.h"
#include "core/hierarchy/pictures.h"
#include "core/hierarchy/statistics_json.h"
#include "core/io/atomic_file.h"
#include "core/multigrid/convergence_plot.h"
#include "core/report/report_page.h"
#include "core/report/report_tables.h"

#include <CLI/CLI.hpp>

namespace ameco::cli {
namespace {

namespace fs = std::filesystem;

/// The coarsest level is solved directly; above this many nodes that takes minutes in 3-D.
constexpr std::int64_t most_coarse_nodes = 20000;

/// The cycles that a report compares.
struct ReportCycle {
    CoarseOperator kind;
    int steps;
};
constexpr std::array report_cycles{ReportCycle{CoarseOperator::rediscretised, 1},
                                   ReportCycle{CoarseOperator::rediscretised, 2},
                                   ReportCycle{CoarseOperator::local_galerkin, 2}};

class ReportCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {"report",
                "Make a page about a hierarchy, for the engineer's file.",
                "report DIR -o PAGE.html [options]",
                {{"report levels -o wing.html", "tables, pictures, convergence"},
                 {"report levels -o wing.html --no-multigrid --no-times",
                  "the same bytes on every run, and quicker"}},
                "The page needs no network and no other file, follows light and dark, and prints. "
                "Beside it, named after it, are the tables as CSV and the pictures as SVG."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("DIR", folder_, "folder of the hierarchy")->required();
        app.add_option("-o,--output", output_, "page to write (.html)")
            ->required()
            ->type_name("PAGE");
        app.add_flag("--no-multigrid", no_multigrid_, "do not measure how multigrid converges");
        app.add_flag("--no-times", no_times_, "leave times and memory out");
    }

    ExitCode run(Session& session) override {
        require_suffix(output_, {".html", ".htm"});
        ReportContent content;
        content.folder = folder_;
        content.hierarchy = read_hierarchy(folder_);
        if (content.hierarchy.levels.empty()) {
            throw InputError(folder_ + ": has no level yet: make some with ameco coarsen");
        }
        if (!no_times_) {
            content.timings = read_timing(folder_);
        }
        content.hierarchy.dimension == 3 ? look_at_levels<3>(content, session)
                                         : look_at_levels<2>(content, session);
        session.monitor.clear_line();
        const std::vector<std::string> written = write_files(content);
        if (session.json) {
            session.out << Json{{"written", written}}.dump(2) << '\n';
        } else if (session.verbosity >= 0) {
            for (const std::string& file : written) {
                session.out << file << '\n';
            }
        }
        return ExitCode::ok;
    }

private:
    /// What needs the meshes: pictures and multigrid.
    template <int D>
    void look_at_levels(ReportContent& content, Session& session) const {
        const Hierarchy& h = content.hierarchy;
        std::vector<Mesh<D>> meshes;
        LayerPictures<D> layers;
        for (const HierarchyLevel& level : h.levels) {
            const int k = level.statistics.level;
            session.monitor.progress(0.3 * k / static_cast<double>(h.levels.size()),
                                     "reading levels");
            meshes.push_back(read_level_mesh<D>(folder_, h, k));
            layers.add(meshes.back(), level.statistics);
        }
        content.sections = layers.svg();
        if (!no_multigrid_ && h.levels.size() > 1) {
            measure_cycles(meshes, content, session);
        }
    }

    template <int D>
    void measure_cycles(const std::vector<Mesh<D>>& meshes, ReportContent& content,
                        Session& session) const {
        if (content.hierarchy.levels.back().statistics.nodes > most_coarse_nodes) {
            session.monitor.message(Severity::warning,
                                    folder_ +
                                        ": multigrid is not measured, since the coarsest "
                                        "level has more than " +
                                        count_text(most_coarse_nodes) +
                                        " nodes: make more levels with --resume");
            return;
        }
        session.monitor.progress(0.3, "locating nodes");
        std::vector<Transfer> transfers;
        for (std::size_t k = 0; k + 1 < meshes.size(); ++k) {
            transfers.push_back(make_transfer(meshes[k], meshes[k + 1], {}));
        }
        for (const ReportCycle& cycle : report_cycles) {
            stop_if_asked(session.monitor);
            session.monitor.progress(0.5 + 0.15 * static_cast<double>(content.cycles.size()),
                                     "multigrid");
            const LevelEquations equations =
                level_equations(meshes, transfers, ModelProblem<D>(), cycle.kind);
            CycleOptions options;
            options.before = options.after = cycle.steps;
            const std::string steps = std::to_string(cycle.steps);
            content.cycles.push_back(
                {"V(" + steps + "," + steps + "), " + std::string(name(cycle.kind)),
                 equations.operator_complexity,
                 study_cycle(equations, options,
                             restricted(unit_load(meshes[0]), equations.unknowns[0]))});
        }
    }

    [[nodiscard]] std::vector<std::string> write_files(const ReportContent& content) const {
        const Hierarchy& h = content.hierarchy;
        std::vector<std::string> written;
        const auto write = [&](const std::string& suffix, const std::string& text) {
            const fs::path page(output_);
            const fs::path file =
                suffix.empty() ? page : page.parent_path() / (page.stem().string() + suffix);
            write_whole_file(file, text);
            written.push_back(file.string());
        };
        write("", report_page(content));
        write("_levels.csv", html::csv_of(levels_table(h)));
        write("_classes.csv", html::csv_of(classes_table(h)));
        write("_quality.csv", html::csv_of(conformity_table(h)));
        std::vector<AspectRatioClasses> classes;
        for (const HierarchyLevel& level : h.levels) {
            classes.push_back(level.statistics.classes);
        }
        write("_histogram.svg", histogram_svg(classes));
        if (!content.sections.empty()) {
            write("_layers.svg", content.sections);
        }
        if (!content.cycles.empty()) {
            std::vector<ConvergenceCurve> curves;
            for (const ReportedCycle& cycle : content.cycles) {
                curves.push_back({cycle.title, cycle.study.krylov.residuals});
            }
            write("_convergence.svg", convergence_plot(curves));
        }
        return written;
    }

    std::string folder_, output_;
    bool no_multigrid_ = false, no_times_ = false;
};

} // namespace

std::unique_ptr<Command> make_report_command() {
    return std::make_unique<ReportCommand>();
}

} // namespace ameco::cli
