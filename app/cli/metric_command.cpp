// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "core/coarsen/coarsen.h"
#include "core/hierarchy/statistics_json.h"
#include "core/io/atomic_file.h"
#include "core/metric/complexity.h"
#include "core/metric/mean_comparison.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>

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
            "metric MESH -o FILE [options]",
            {{"metric wing.meshb -o wing.solb", "the metric in which the mesh is unit"},
             {"metric wing.meshb --coarsen 2 -o coarse.solb", "the metric ameco coarsen aims at"},
             {"metric wing.meshb --mean log-euclidean -o wing.solb", "another mean"},
             {"metric wing.meshb --compare 12 -o balls.svg",
              "all means at one node, as a table and a picture"}},
            "A node that no element uses gets the size of the whole mesh, so that the file has "
            "one tensor per node of the mesh file.\n"
            "--compare: turn and distance are those to the corrected mean, the distance the "
            "invariant one (two metrics whose sizes differ by 1 % are about 0.02 apart)."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("MESH", mesh_, "mesh, in any format of ameco formats")->required();
        app.add_option("-o,--output", output_,
                       "metric to write (.solb, .sol); with --compare a picture (.svg)")
            ->type_name("FILE");
        add_setting(app, options_, "mean");
        app.add_option("--coarsen", options_.coarsen.target.factor,
                       "write the metric of the next coarser level: coarse size over fine size, "
                       "greater than 1 [off]")
            ->type_name("C")
            ->check(greater_than(1));
        for (const char* name : {"slack", "isotropic-below", "algorithm", "gradation"}) {
            add_setting(app, options_, name);
        }
        coarsen_ = app.get_option("--coarsen");
        compare_ = app.add_option("--compare", node_,
                                  "compare all means at this node of the mesh file, counted from "
                                  "0, instead of writing a metric")
                       ->type_name("NODE")
                       ->check(whole_number(0, INT32_MAX))
                       ->excludes(coarsen_);
    }

    ExitCode run(Session& session) override {
        if (compare_->count() > 0) {
            return run_comparison(session);
        }
        if (output_.empty()) {
            throw UsageError("--output is missing (see ameco metric --help)");
        }
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
    ExitCode run_comparison(Session& session) const {
        if (!output_.empty()) {
            require_suffix(output_, {".svg"});
        }
        MeshFile file = load_mesh(mesh_, session);
        std::visit([&](auto& mesh) { compare(mesh, session); }, file.mesh);
        return ExitCode::ok;
    }

    template <int D>
    void compare(Mesh<D>& mesh, Session& session) const {
        const std::vector<bool> used = used_nodes(mesh);
        require_valid(mesh);
        const auto wanted = static_cast<std::size_t>(node_);
        if (wanted >= used.size() || !used[wanted]) {
            throw UsageError("--compare " + std::to_string(node_) + ": " +
                             (wanted >= used.size()
                                  ? mesh_ + " has the nodes 0 to " + std::to_string(used.size() - 1)
                                  : "no element uses this node"));
        }
        // Nodes that no element uses have left the mesh.
        const auto place = std::count(used.begin(), used.begin() + node_, true);
        MeanComparison<D> comparison = compare_means(mesh, NodeId(static_cast<std::size_t>(place)));
        comparison.node = NodeId(wanted);
        session.monitor.clear_line();
        if (!output_.empty()) {
            const std::string picture = unit_balls_svg(comparison);
            AtomicFile out(output_);
            out.write(picture.data(), picture.size());
            out.commit();
        }
        if (session.json) {
            print_json(session.out, comparison);
        } else {
            print(session.out, comparison);
        }
    }

    template <int D>
    void print(std::ostream& out, const MeanComparison<D>& c) const {
        out << mesh_ << ": node " << c.node.value() << ", "
            << plural(static_cast<std::int64_t>(c.elements.size()), "element") << '\n';
        std::vector<Table::Column> columns{{"mean", Table::Align::left}};
        for (int k = 1; k <= D; ++k) {
            columns.push_back({"h" + std::to_string(k)});
        }
        columns.push_back({"AR"});
        columns.push_back({"turn [deg]"});
        columns.push_back({"distance"});
        Table table(columns);
        for (const ComparedMean<D>& m : c.means) {
            std::vector<std::string> row{std::string(name(m.mean))};
            if (m.failure.empty()) {
                for (const double h : m.metric.sizes) {
                    row.push_back(number_text(h));
                }
                row.push_back(number_text(aspect_ratio(m.metric)));
                // Below this it is rounding.
                row.push_back(number_text(m.turn_deg < 1e-9 ? 0 : m.turn_deg, 3));
                row.push_back(number_text(m.distance < 1e-9 ? 0 : m.distance, 3));
            } else {
                row.push_back(m.failure);
                row.resize(columns.size());
            }
            table.add_row(std::move(row));
        }
        table.print(out);
    }

    template <int D>
    void print_json(std::ostream& out, const MeanComparison<D>& c) const {
        Json means = Json::array();
        for (const ComparedMean<D>& m : c.means) {
            Json row = {{"mean", name(m.mean)}};
            if (m.failure.empty()) {
                row["sizes"] = std::vector<double>(m.metric.sizes.begin(), m.metric.sizes.end());
                row["aspect_ratio"] = aspect_ratio(m.metric);
                row["turn_deg"] = m.turn_deg;
                row["distance"] = m.distance;
            } else {
                row["failure"] = m.failure;
            }
            means.push_back(std::move(row));
        }
        const Json json = {{"mesh", mesh_},
                           {"node", c.node.value()},
                           {"elements", c.elements.size()},
                           {"means", std::move(means)}};
        out << json.dump(2) << '\n';
    }

    template <int D>
    void require_valid(Mesh<D>& mesh) const {
        complete_boundary(mesh, FeatureOptions{}.ridge_angle_deg);
        if (const CheckReport report = check(mesh); !report.valid()) {
            throw InputError(mesh_ + ": not a valid mesh: " + report.summary());
        }
    }

    template <int D>
    MetricSummary compute(Mesh<D>& mesh, Session& session) const {
        const std::vector<bool> used = used_nodes(mesh);
        require_valid(mesh);
        MonitorPart part(session.monitor, 0.1, 0.9);
        MetricField<D> field = nodal_metric(mesh, options_.coarsen.mean, part);
        MetricSummary s;
        s.dimension = D;
        s.nodes = static_cast<std::int64_t>(mesh.points.size());
        s.elements = static_cast<std::int64_t>(mesh.elements.size());
        s.complexity = complexity(mesh, field);
        s.predicted_nodes = static_cast<double>(s.nodes);
        if (coarsen_->count() > 0) {
            field = target_metric(mesh, field, options_.coarsen.target);
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
            << (coarsen_->count() > 0 ? "metric of the next coarser level, sizes times " +
                                            number_text(options_.coarsen.target.factor)
                                      : "natural metric")
            << " of " << mesh_ << " (" << name(options_.coarsen.mean) << ")\n";
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
        const Json json = {
            {"file", output_},
            {"mesh", mesh_},
            {"mean", name(options_.coarsen.mean)},
            {"factor", coarsen_->count() > 0 ? Json(options_.coarsen.target.factor) : Json()},
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
    HierarchyOptions options_; ///< mean and target
    int node_ = 0;
    CLI::Option* coarsen_ = nullptr;
    CLI::Option* compare_ = nullptr;
};

} // namespace

std::unique_ptr<Command> make_metric_command() {
    return std::make_unique<MetricCommand>();
}

} // namespace ameco::cli
