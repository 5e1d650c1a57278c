// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "core/adapt/adapt.h"
#include "core/hierarchy/statistics_json.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>

namespace ameco::cli {
namespace {

template <class Words>
std::vector<std::string> names_of(const Words& words) {
    std::vector<std::string> names;
    for (const auto word : words) {
        names.emplace_back(name(word));
    }
    return names;
}

class RemeshCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {
            "remesh",
            "Adapt a mesh to any metric, finer or coarser.",
            "remesh MESH (--metric FILE | --size H) -o OUT [options]",
            {{"remesh wing.meshb --metric wing.solb -o adapted.meshb",
              "until all edges have length 1 in the metric of wing.solb"},
             {"remesh wing.meshb --size 0.1 -o uniform.meshb", "edges of length 0.1 everywhere"},
             {"remesh wing.meshb --metric wing.solb -o a.meshb --metric-out a.solb",
              "with the metric at the new nodes"}},
            "Edges that are too long are split, nodes that are too near to another leave along the "
            "edge between them, edges and faces are swapped, nodes are moved; where much is to "
            "change, in stages that halve or double sizes. The boundary of MESH is the geometry: "
            "corners, ridges and borders between patches stay, planar patches stay planar, nodes "
            "that are new on a curved patch lie on its faces, on a ridge on its edges.\n"
            "For a series of coarser meshes with lines kept whole use ameco coarsen."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("MESH", mesh_, "mesh, in any format of ameco formats")->required();
        app.add_option("-o,--output", output_, "mesh to write, in the format of its suffix")
            ->type_name("FILE")
            ->required();
        auto* metric = app.add_option("--metric", metric_,
                                      "metric to adapt to (.solb, .sol): one tensor per node of "
                                      "MESH");
        metric->type_name("FILE");
        app.add_option("--size", size_, "the same size everywhere instead of a metric, > 0")
            ->type_name("H")
            ->check(greater_than(0))
            ->excludes(metric);
        app.add_option("--metric-out", metric_out_,
                       "metric at the nodes of the result, to be written (.solb, .sol)")
            ->type_name("FILE");
        app.add_option("--interpolation", interpolation_,
                       "mean of the metrics of an element's nodes: corrected (sizes that grow "
                       "linearly are exact), log-euclidean, ... [corrected]")
            ->type_name("MEAN")
            ->check(one_of(names_of(interpolating_means)));
        app.add_flag("--node-nested", options_.node_nested,
                     "only take nodes away: no new ones, and none is moved");
        app.add_option(
               "--engine", engine_,
               "fast, or mtc: the paper's iteration until stagnation, less conforming [fast]")
            ->type_name("ENGINE")
            ->check(one_of(names_of(all_engines)));
        app.add_option("--quality", quality_,
                       "quality of elements: shape, original (with the mean size) or modified "
                       "(with every edge and the volume) [shape; of mtc modified]")
            ->type_name("QUALITY")
            ->check(one_of(names_of(all_qualities)));
        app.add_option("--passes", options_.passes,
                       "passes of the fast engine over the mesh at the end, at most [" +
                           std::to_string(options_.passes) + "]")
            ->type_name("N")
            ->check(whole_number(1, 1000));
        add_setting(app, shared_, "surface-deviation");
        add_setting(app, shared_, "ridge-angle");
        app.add_option("--freeze", frozen_, "patches that must not change, by id or name")
            ->type_name("PATCH");
    }

    ExitCode run(Session& session) override {
        if (metric_.empty() && size_ == 0) {
            throw UsageError("--metric or --size is missing (see ameco remesh --help)");
        }
        options_.engine = *engine_from_name(engine_);
        options_.quality = quality_from_name(quality_);
        refuse_overwriting(mesh_, output_);
        if (!metric_out_.empty()) {
            require_suffix(metric_out_, {".solb", ".sol"});
            refuse_overwriting(metric_, metric_out_);
        }
        MeshFile file = load_mesh(mesh_, session);
        const AdaptReport report =
            std::visit([&](auto& mesh) { return adapt_file(mesh, session); }, file.mesh);
        session.monitor.clear_line();
        if (session.json) {
            print_json(session.out, report);
        } else if (session.verbosity >= 0) {
            print(session.out, report, session.verbosity > 0);
        }
        return ExitCode::ok;
    }

private:
    template <int D>
    MetricField<D> wanted_metric(const Mesh<D>& mesh) const {
        if (!metric_.empty()) {
            return load_metric(metric_, mesh, mesh_);
        }
        return isotropic_metric<D>(mesh.points.size(), size_);
    }

    template <int D>
    AdaptReport adapt_file(Mesh<D>& mesh, Session& session) {
        const MetricField<D> given = wanted_metric(mesh);
        const std::vector<bool> used = used_nodes(mesh);
        (void)make_valid(mesh, mesh_, shared_.coarsen.features.ridge_angle_deg, session);
        MetricField<D> field;
        for (const NodeId v : given.ids()) {
            if (used[v.index()]) {
                field.push_back(given[v]);
            }
        }
        options_.surface = shared_.coarsen.removal.surface;
        options_.features = shared_.coarsen.features;
        options_.features.frozen_patches = find_patches(mesh, "--freeze", frozen_);
        const BackgroundMetric<D> source(mesh, field, *mean_from_name(interpolation_));
        AdaptReport report;
        dimension_ = D;
        const Adapted<D> adapted = adapt(mesh, source, options_, report, session.monitor);
        for (const std::string& loss : write_mesh(output_, adapted.mesh)) {
            session.monitor.message(Severity::warning, output_ + ": " + loss);
        }
        if (!metric_out_.empty()) {
            write_metric(metric_out_, adapted.metric);
        }
        return report;
    }

    void print(std::ostream& out, const AdaptReport& r, bool verbose) const {
        out << output_ << ": " << plural(r.nodes_after, "node") << ", "
            << count_text(r.elements_after) << ' ' << element_word(dimension_) << ", from "
            << plural(r.nodes_before, "node") << '\n';
        Facts facts{
            {"unit mesh has about", plural(static_cast<std::int64_t>(r.predicted_nodes), "node")},
            {"edges in band before", percent_text(r.conformity_before.in_band)}};
        for (auto& fact : conformity_facts(r.conformity)) {
            facts.push_back(std::move(fact));
        }
        facts.emplace_back("stages, passes",
                           std::to_string(r.stages) + ", " + std::to_string(r.passes.size()));
        print_facts(out, facts);
        if (verbose) {
            out << '\n';
            print_verdicts(out, r);
        }
    }

    static void print_verdicts(std::ostream& out, const AdaptReport& r) {
        Table table({{"", Table::Align::left}, {"splits"}, {"collapses"}, {"swaps"}, {"moves"}});
        for (std::size_t v = 0; v < verdict_count; ++v) {
            const auto verdict = static_cast<Verdict>(v);
            const std::array<std::int64_t, 4> counts{r.splits[verdict], r.collapses[verdict],
                                                     r.swaps[verdict], r.moves[verdict]};
            if (std::any_of(counts.begin(), counts.end(), [](auto n) { return n > 0; })) {
                std::vector<std::string> row{std::string(name(verdict))};
                for (const std::int64_t n : counts) {
                    row.push_back(n > 0 ? count_text(n) : "");
                }
                table.add_row(std::move(row));
            }
        }
        table.print(out);
    }

    void print_json(std::ostream& out, const AdaptReport& r) const {
        Json json{
            {"output", output_}, {"engine", engine_}, {"quality", name(quality_of(options_))}};
        json.update(to_json(r));
        out << json.dump(2) << '\n';
    }

    std::string mesh_, metric_, metric_out_, output_;
    std::string interpolation_ = "corrected";
    std::string engine_ = "fast", quality_;
    double size_ = 0;
    std::vector<std::string> frozen_;
    HierarchyOptions shared_; ///< what `coarsen` has too
    AdaptOptions options_;
    int dimension_ = 3;
};

} // namespace

std::unique_ptr<Command> make_remesh_command() {
    return std::make_unique<RemeshCommand>();
}

} // namespace ameco::cli
