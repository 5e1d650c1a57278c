// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/level_table.h"
#include "app/cli/level_transfers.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "core/base/parallel.h"
#include "core/hierarchy/build_hierarchy.h"
#include "core/hierarchy/content_hash.h"
#include "core/hierarchy/hierarchy_folder.h"
#include "core/hierarchy/hierarchy_json.h"
#include "core/hierarchy/pictures.h"
#include "core/io/format.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

namespace ameco::cli {
namespace {

namespace fs = std::filesystem;

bool is_empty_folder(const fs::path& folder) {
    std::error_code failure;
    const fs::directory_iterator entries(folder, failure);
    return !failure && entries == fs::directory_iterator();
}

/// A format that levels can be written in beside Medit's, and the end of their names.
struct ExportFormat {
    std::string name;   ///< as the user gives it: a format's name, or one of its further suffixes
    std::string format; ///< its name in the table
    std::string suffix;
};

/// All of them: those that hold a mesh with volume.
std::vector<ExportFormat> export_formats() {
    std::vector<ExportFormat> result;
    for (const Format& format : formats()) {
        const bool medit = format.name == "medit" || format.name == "medit-text";
        if (format.is_metric() || !format.writes() || (format.keeps & keeps_3d) == 0 || medit) {
            continue;
        }
        const std::string name(format.name);
        result.push_back({name, name, std::string(format.suffixes.front())});
        if (format.name == "ugrid") { // its suffix says how numbers are written
            for (std::size_t i = 1; i < format.suffixes.size(); ++i) {
                const std::string suffix(format.suffixes[i]);
                result.push_back({suffix.substr(1), name, suffix});
            }
        }
    }
    return result;
}

std::vector<std::string> level_formats() {
    std::vector<std::string> names{"meshb", "mesh"};
    for (const ExportFormat& format : export_formats()) {
        names.push_back(format.name);
    }
    return names;
}

class CoarsenCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {
            "coarsen",
            "Make the hierarchy of coarser meshes that multigrid needs.",
            "coarsen MESH -o DIR [options]",
            {{"coarsen wing.meshb -o levels", "four coarser levels, in the folder levels"},
             {"coarsen wing.meshb -o levels --levels 6 --resume",
              "go on from what is there already"},
             {"coarsen wing.meshb -o levels --target-ratio 2 --until-isotropic",
              "half the nodes each time, until nothing is stretched any more"},
             {"coarsen wing.meshb -o levels --freeze wing tip", "leave two patches as they are"},
             {"coarsen wing.meshb -o levels --isotropic-below 1 --mean corrected",
              "sizes as the paper has them"}},
            "The folder gets hierarchy.json (statistics of all levels), level_k.meshb (level 0 "
            "is MESH itself; the levels in the format of --format beside them), metric_k.solb "
            "(natural metrics), state_k.cbor (for --resume) and "
            "timing.json. Ctrl-C keeps the levels that are finished.\n"
            "Columns: predicted: nodes the metric asks for; of that: nodes there are, as a "
            "share of it; AR: aspect ratio of the nodes; in band: edges of length 0.71 - 1.41 "
            "in the metric asked for (level 0: in its natural metric).\n"
            "Exit code 0: as many levels as the mesh allows; 3: it cannot be coarsened at all; "
            "5: not a valid mesh; 6: stopped early, finished levels are kept; 130: stopped "
            "before the first coarser level."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("MESH", mesh_, "finest mesh, in any format of ameco formats")->required();
        app.add_option("-o,--output", folder_, "folder for the levels; made if absent")
            ->type_name("DIR")
            ->required();
        levels_ = add_setting(app, options_, "levels", "Options", "n");
        add_setting(app, options_, "until-isotropic");
        std::string others;
        for (const ExportFormat& format : export_formats()) {
            others += (others.empty() ? "" : ", ") + format.name;
        }
        app.add_option("--format", format_,
                       "format of the levels: meshb (binary) or mesh (text); or one that all "
                       "levels are written in too, beside meshb: " +
                           others)
            ->type_name("NAME")
            ->check(one_of(level_formats()))
            ->capture_default_str();
        app.add_flag("--copy-input", copy_input_,
                     "put a copy of MESH into the folder, so that the folder is complete");
        app.add_flag(
            "--pictures", pictures_,
            "add histogram.svg (aspect ratios) and layers.svg (the layers, level by level)");
        app.add_flag("--transfer", transfer_,
                     "add the transfer of each level to the next finer one: P_k.mtx and P_k.petsc "
                     "(from level k + 1 to k), parent_k.txt (injection), projected_k.txt");
        app.add_flag("--resume", resume_,
                     "keep the levels in the folder that were made from the same mesh with the "
                     "same settings, and go on from there");
        app.add_flag("--force", force_, "replace the hierarchy in the folder");
        add_coarsening_options(app);
    }

    ExitCode run(Session& session) override {
        require_usable_folder();
        set_factors();
        if (options_.until_isotropic && levels_->count() == 0) {
            options_.levels = static_cast<int>(setting("levels").high);
        }
        ReadyMesh input =
            load_valid_mesh(mesh_, options_.coarsen.features.ridge_angle_deg, session);
        return std::visit(
            [&](auto& mesh) {
                options_.coarsen.features.frozen_patches = find_patches(mesh, "--freeze", freeze_);
                return coarsen_mesh(std::move(mesh), input, session);
            },
            input.file.mesh);
    }

private:
    void add_coarsening_options(CLI::App& app) {
        constexpr const char* group = "Coarsening";
        CLI::Option* factor =
            app.add_option(
                   "--factor", factors_,
                   "coarse size over fine size, greater than 1; a list, like 2,2,4, has one "
                   "per level, its last one for all further levels")
                ->type_name("C[,C...]")
                ->delimiter(',')
                ->allow_extra_args(false)
                ->check(greater_than(1))
                ->default_str(number_text(options_.coarsen.target.factor))
                ->group(group);
        add_setting(app, options_, "target-ratio", group)->excludes(factor);
        for (const char* name :
             {"slack", "isotropic-below", "algorithm", "gradation", "mean", "surface-deviation",
              "ridge-angle", "nodes", "boundary", "rebuild"}) {
            add_setting(app, options_, name, group);
        }
        app.add_option("--freeze", freeze_,
                       "patches to leave untouched, by id or name (ameco info lists them)")
            ->type_name("PATCH...")
            ->group(group);
    }

    void set_factors() {
        if (!factors_.empty()) {
            options_.coarsen.target.factor = factors_.front();
        }
        if (factors_.size() > 1) {
            options_.factors = factors_;
        }
    }

    /// Before the mesh is read, which may take long.
    void require_usable_folder() const {
        const fs::path folder(folder_);
        std::error_code ignored;
        if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored)) {
            throw FileError(folder_ + ": is a file: name a folder for the levels");
        }
        const fs::path mesh_folder = fs::weakly_canonical(mesh_, ignored).parent_path();
        if (fs::equivalent(mesh_folder, folder, ignored) &&
            is_hierarchy_file(fs::path(mesh_).filename().string())) {
            throw UsageError(mesh_ + ": is a level in " + folder_ +
                             ", which would be overwritten: name another folder");
        }
        if (force_ || !fs::exists(folder, ignored) || is_empty_folder(folder)) {
            return;
        }
        if (!fs::exists(folder / "hierarchy.json", ignored)) {
            throw UsageError(folder_ + ": the folder is not empty: name another one, or use it "
                                       "all the same with --force");
        }
        if (!resume_) {
            throw UsageError(folder_ + ": holds a hierarchy: go on from it with --resume, "
                                       "replace it with --force, or name another folder");
        }
    }

    [[nodiscard]] Hierarchy fresh_hierarchy(int dimension, const ReadyMesh& input) const {
        Hierarchy h;
        h.program = std::string("ameco ") + AMECO_VERSION;
        h.dimension = dimension;
        if (format_ == "meshb" || format_ == "mesh") {
            h.mesh_suffix = "." + format_;
        } else {
            for (const ExportFormat& format : export_formats()) {
                if (format.name == format_) {
                    h.export_format = format.format;
                    h.export_suffix = format.suffix;
                }
            }
        }
        h.options = options_;
        h.input.copied = copy_input_;
        h.input.format = input.file.format;
        h.input.repair = input.repair;
        return h;
    }

    /// What can be kept of the hierarchy in the folder; `fresh` when there is none.
    [[nodiscard]] Hierarchy hierarchy_to_continue(const Hierarchy& fresh, Session& session) const {
        const fs::path folder(folder_);
        if (!resume_ || !fs::exists(folder / "hierarchy.json")) {
            return fresh;
        }
        Hierarchy old = read_hierarchy(folder);
        if (old.input.file.hash != content_hash_of_file(mesh_)) {
            throw UsageError(folder_ + ": holds the levels of another mesh than " + mesh_ +
                             ": name another folder, or replace them with --force");
        }
        if (const std::string names = different_settings(old, fresh); !names.empty()) {
            throw UsageError(folder_ + ": was made with other settings (" + names +
                             "): give the same ones, or replace it with --force");
        }
        if (old.program != fresh.program) {
            session.monitor.message(Severity::warning,
                                    folder_ + ": its levels were made by " + old.program);
        }
        const int kept = intact_levels(folder, old);
        old.levels.resize(static_cast<std::size_t>(kept));
        for (HierarchyLevel& level : old.levels) {
            if (level.transfer && !is_intact(folder, *level.transfer)) {
                level.transfer.reset();
            }
        }
        old.options.levels = std::max(options_.levels, kept - 1);
        old.program = fresh.program;
        if (kept < 2) {
            return fresh; // level 0 alone is made as quickly as it is read
        }
        return old;
    }

    template <int D>
    ExitCode coarsen_mesh(Mesh<D> mesh, const ReadyMesh& input, Session& session) {
        require_possible(mesh, options_);
        const Hierarchy start = hierarchy_to_continue(fresh_hierarchy(D, input), session);
        HierarchyFolder folder(folder_, mesh_, start, read_timing(folder_));
        try {
            return fill_folder(std::move(mesh), folder, session);
        } catch (const std::exception&) {
            folder.take_back();
            throw;
        }
    }

    template <int D>
    ExitCode fill_folder(Mesh<D> mesh, HierarchyFolder& folder, Session& session) {
        std::optional<LevelTable> table;
        if (!session.json) {
            table.emplace(session.out, D);
            show_kept_levels(folder, *table);
        }
        std::optional<LevelTransfers<D>> transfers;
        if (transfer_) {
            transfers.emplace(folder, session.monitor);
        }
        const LevelSink<D> sink = [&](const Level<D>& level, const LevelStatistics& statistics,
                                      const LevelTiming& timing) {
            say_once(folder.add_level(level, statistics, timing), session);
            if (transfers) {
                transfers->add(level, statistics.level);
            }
            session.monitor.clear_line();
            if (table) {
                table->add(statistics, folder.timings().back().total());
            }
        };
        const HierarchyEnd end = make_levels(std::move(mesh), folder, sink, session);
        folder.finish(end.status);
        if (pictures_) {
            write_pictures<D>(folder_, folder.hierarchy());
        }
        session.monitor.clear_line();
        if (session.json) {
            print_json(session.out, folder);
        } else {
            print_summary(session, folder, end);
        }
        return exit_code(folder.hierarchy());
    }

    /// What the format of the levels cannot carry is said of the first level that it is true of.
    void say_once(const std::vector<std::string>& notes, Session& session) {
        for (const std::string& note : notes) {
            if (said_.insert(note).second) {
                session.monitor.message(Severity::warning, "--format " + format_ + ": " + note);
            }
        }
    }

    template <int D>
    HierarchyEnd make_levels(Mesh<D> mesh, const HierarchyFolder& folder, const LevelSink<D>& sink,
                             Session& session) const {
        const Hierarchy& kept = folder.hierarchy();
        if (kept.levels.empty()) {
            return build_hierarchy(std::move(mesh), options_, sink, session.monitor);
        }
        mesh = Mesh<D>();
        const int last = static_cast<int>(kept.levels.size()) - 1;
        if (last >= options_.levels || is_isotropic_end(kept.levels.back().statistics, options_)) {
            return {};
        }
        return extend_hierarchy(read_level<D>(folder_, kept, last), last,
                                kept.levels.front().statistics.classes.max, options_, sink,
                                session.monitor);
    }

    static void show_kept_levels(const HierarchyFolder& folder, LevelTable& table) {
        for (std::size_t k = 0; k < folder.hierarchy().levels.size(); ++k) {
            const auto& timings = folder.timings();
            table.add(folder.hierarchy().levels[k].statistics,
                      k < timings.size() ? timings[k].total() : 0);
        }
    }

    [[nodiscard]] static ExitCode exit_code(const Hierarchy& hierarchy) {
        const bool has_levels = hierarchy.levels.size() > 1;
        if (hierarchy.status == HierarchyStatus::cancelled) {
            return has_levels ? ExitCode::partial : ExitCode::cancelled;
        }
        return has_levels ? ExitCode::ok : ExitCode::check_failed;
    }

    void print_summary(Session& session, const HierarchyFolder& folder,
                       const HierarchyEnd& end) const {
        const Hierarchy& h = folder.hierarchy();
        std::vector<AspectRatioClasses> classes;
        for (const HierarchyLevel& level : h.levels) {
            classes.push_back(level.statistics.classes);
        }
        if (classes.size() > 1) {
            session.out << "\nnodes by aspect ratio\n";
            print_aspect_ratio_histogram(session.out, classes);
        }
        if (session.verbosity > 0) {
            print_verdicts(session.out, h);
        }
        const std::size_t made = h.levels.empty() ? 0 : h.levels.size() - 1;
        session.out << '\n'
                    << folder_ << ": " << plural(static_cast<std::int64_t>(made), "coarser level");
        if (made > 0) {
            session.out << ", grid complexity " << ratio_text(grid_complexity(h));
        }
        session.out << ", peak memory " << bytes_text(static_cast<double>(peak_memory()))
                    << std::endl;
        explain_end(session, h, end);
    }

    void explain_end(Session& session, const Hierarchy& h, const HierarchyEnd& end) const {
        const std::size_t next = h.levels.size();
        if (end.status == HierarchyStatus::cancelled) {
            session.monitor.message(Severity::error,
                                    "stopped before level " + std::to_string(next) +
                                        " was finished; --resume goes on from here");
        } else if (end.refused) {
            session.monitor.message(
                Severity::warning,
                "level " + std::to_string(next) + " would have kept " +
                    count_text(end.refused->nodes_after) + " of " +
                    count_text(end.refused->nodes_before) +
                    " nodes: the mesh cannot be coarsened further (-v shows why nodes stayed)");
        }
    }

    static void print_json(std::ostream& out, const HierarchyFolder& folder) {
        using Json = nlohmann::ordered_json;
        const Json json = {{"hierarchy", Json::parse(hierarchy_text(folder.hierarchy()))},
                           {"timing", Json::parse(timing_text(folder.timings(), thread_count()))}};
        out << json.dump(2) << '\n';
    }

    std::string mesh_;
    std::string folder_;
    HierarchyOptions options_;
    std::vector<double> factors_;
    CLI::Option* levels_ = nullptr;
    std::string format_ = "meshb";
    std::set<std::string> said_;
    std::vector<std::string> freeze_;
    bool copy_input_ = false;
    bool pictures_ = false;
    bool transfer_ = false;
    bool resume_ = false;
    bool force_ = false;
};

} // namespace

std::unique_ptr<Command> make_coarsen_command() {
    return std::make_unique<CoarsenCommand>();
}

} // namespace ameco::cli
