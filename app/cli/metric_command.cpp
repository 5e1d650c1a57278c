// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "core/coarsen/coarsen.h"
#include "core/hierarchy/statistics_json.h"
#include "core/metric/complexity.h"

#include <CLI/CLI.hpp>

namespace ameco::cli {
namespace {

struct MetricSummary {
    int dimension = 3;
    std::int64_t nodes = 0, elements = 0;
    double complexity = 0;         ///< of the metric that is written
    double predicted_elements = 0; ///< of a unit mesh in it
    double predicted_nodes = 0;
    AspectRatioSummary aspect_ratio;
    AspectRatioClasses classes;
};

class MetricCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {
            "metric",
            "Compute the natural metric of a mesh, or the metric of its next coarser level.",
            "metric MESH -o METRIC [options]",
            {{"metric wing.meshb -o wing.solb", "the metric in which the mesh is unit"},
             {"metric wing.meshb --coarsen 2 -o coarse.solb", "the metric ameco coarsen aims at"},
             {"metric wing.meshb --mean log-euclidean -o wing.solb", "another mean"}},
            "A node that no element uses gets the size of the whole mesh, so that the file has "
            "one tensor per node of the mesh file."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("MESH", mesh_, "mesh (.mesh, .meshb)")->required();
        app.add_option("-o,--output", output_, "metric to write (.solb, .sol)")
            ->type_name("METRIC")
            ->required();
        add_mean_option(app, mean_);
        app.add_option("--coarsen", target_.factor,
                       "write the metric of the next coarser level: coarse size over fine size, "
                       "greater than 1 [off]")
            ->type_name("C")
            ->check(greater_than(1));
        add_slack_option(app, target_);
        coarsen_ = app.get_option("--coarsen");
    }

    ExitCode run(Session& session) override {
        require_suffix(output_, {".solb", ".sol"});
        refuse_overwriting(mesh_, output_);
        MeshFile file = load_mesh(mesh_, session);
        const MetricSummary summary =
            std::visit([&](auto& mesh) { return compute(mesh, session); }, file.mesh);
        session.monitor.clear_line();
        if (session.json) {
            print_json(session.out, summary);
        } else {
            print(session.out, summary);
        }
        return ExitCode::ok;
    }

private:
    template <int D>
    MetricSummary compute(Mesh<D>& mesh, Session& session) const {
        const std::vector<bool> used = used_nodes(mesh);
        complete_boundary(mesh, FeatureOptions{}.ridge_angle_deg);
        if (const CheckReport report = check(mesh); !report.valid()) {
            throw InputError(mesh_ + ": not a valid mesh: " + report.summary());
        }
        MonitorPart part(session.monitor, 0.1, 0.9);
        MetricField<D> field = nodal_metric(mesh, chosen_mean(mean_), part);
        MetricSummary s;
        s.dimension = D;
        s.nodes = static_cast<std::int64_t>(mesh.points.size());
        s.elements = static_cast<std::int64_t>(mesh.elements.size());
        s.complexity = complexity(mesh, field);
        s.predicted_nodes = static_cast<double>(s.nodes);
        if (coarsen_->count() > 0) {
            field = target_metric(field, target_);
            const double coarse = complexity(mesh, field);
            s.predicted_nodes *= coarse / s.complexity;
            s.complexity = coarse;
        }
        s.predicted_elements = predicted_elements<D>(s.complexity);
        s.aspect_ratio = summarise_aspect_ratios(field);
        s.classes = classify_aspect_ratios(field);
        session.monitor.progress(0.9, "writing " + output_);
        write_metric(output_, with_unused_nodes(mesh, std::move(field), used));
        return s;
    }

    template <int D>
    static std::vector<bool> used_nodes(const Mesh<D>& mesh) {
        std::vector<bool> used(mesh.points.size());
        for (const Simplex<D>& element : mesh.elements) {
            for (const NodeId node : element) {
                used[node.index()] = true;
            }
        }
        return used;
    }

    /// One metric per node of the file: `field` lacks the nodes that no element uses.
    template <int D>
    static MetricField<D> with_unused_nodes(const Mesh<D>& mesh, MetricField<D> field,
                                            const std::vector<bool>& used) {
        if (used.size() == field.size()) {
            return field;
        }
        Vec<D> low = mesh.points[NodeId(0)];
        Vec<D> high = low;
        for (const Vec<D>& x : mesh.points) {
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
        Metric<D> whole;
        whole.sizes.setConstant((high - low).norm());
        MetricField<D> result;
        result.reserve(used.size());
        NodeId next(0);
        for (const bool is_used : used) {
            result.push_back(is_used ? field[next] : whole);
            next = is_used ? NodeId(next.value() + 1) : next;
        }
        return result;
    }

    void print(std::ostream& out, const MetricSummary& s) const {
        out << output_ << ": "
            << (coarsen_->count() > 0
                    ? "metric of the next coarser level, sizes times " + number_text(target_.factor)
                    : "natural metric")
            << " of " << mesh_ << " (" << mean_ << ")\n";
        const double ratio = static_cast<double>(s.nodes) / s.predicted_nodes;
        Facts facts{{"mesh", count_text(s.nodes) + " nodes, " + count_text(s.elements) + " " +
                                 element_word(s.dimension)},
                    {"complexity", number_text(s.complexity, 6)},
                    {"unit mesh of it", "about " + count_text(std::llround(s.predicted_elements)) +
                                            " " + element_word(s.dimension)}};
        if (coarsen_->count() > 0) {
            facts.emplace_back("coarser level", "about " +
                                                    count_text(std::llround(s.predicted_nodes)) +
                                                    " nodes (ratio " + ratio_text(ratio) + ")");
        }
        const Facts aspect = aspect_ratio_facts(s.aspect_ratio);
        facts.insert(facts.end(), aspect.begin(), aspect.end());
        print_facts(out, facts);
    }

    void print_json(std::ostream& out, const MetricSummary& s) const {
        const Json json = {{"file", output_},
                           {"mesh", mesh_},
                           {"mean", mean_},
                           {"factor", coarsen_->count() > 0 ? Json(target_.factor) : Json()},
                           {"dimension", s.dimension},
                           {"nodes", s.nodes},
                           {"elements", s.elements},
                           {"complexity", s.complexity},
                           {"predicted_elements", s.predicted_elements},
                           {"predicted_nodes", s.predicted_nodes},
                           {"aspect_ratio", to_json(s.aspect_ratio, s.classes)}};
        out << json.dump(2) << '\n';
    }

    std::string mesh_;
    std::string output_;
    std::string mean_ = std::string(name(Mean::corrected));
    TargetOptions target_;
    CLI::Option* coarsen_ = nullptr;
};

} // namespace

std::unique_ptr<Command> make_metric_command() {
    return std::make_unique<MetricCommand>();
}

} // namespace ameco::cli
