// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/statistics_json.h"

#include "core/base/error.h"

namespace ameco {
namespace {

constexpr std::size_t defect_count = static_cast<std::size_t>(Defect::volumes_do_not_add_up) + 1;

/// The value of an enum with the values 0 ... count-1 whose name is `text`.
template <class Enum>
Enum from_name(const std::string& text, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        if (name(static_cast<Enum>(i)) == text) {
            return static_cast<Enum>(i);
        }
    }
    throw InputError("\"" + text + "\" is not a name this version knows");
}

void read_aspect_ratios(const Json& json, LevelStatistics& s) {
    json.at("max").get_to(s.aspect_ratio.max);
    json.at("top_5_percent_above").get_to(s.aspect_ratio.top_5_percent);
    json.at("median").get_to(s.aspect_ratio.median);
    json.at("share_below_5").get_to(s.aspect_ratio.share_isotropic);
    json.at("share_above_150").get_to(s.aspect_ratio.share_above_150);
    json.at("classes").at("max").get_to(s.classes.max);
    json.at("classes").at("nodes").get_to(s.classes.counts);
}

void read_conformity(const Json& json, Conformity& c) {
    json.at("edges").get_to(c.edges);
    json.at("in_band").get_to(c.in_band);
    json.at("below_half").get_to(c.below_half);
    json.at("above_two").get_to(c.above_two);
    json.at("shortest").get_to(c.shortest);
    json.at("longest").get_to(c.longest);
    json.at("mean_quality").get_to(c.mean_quality);
    json.at("worst_quality").get_to(c.worst_quality);
}

VerdictCounts read_verdicts(const Json& json) {
    VerdictCounts counts;
    for (const auto& [key, value] : json.items()) {
        const auto verdict = from_name<Verdict>(key, verdict_count);
        value.get_to(counts.counts[static_cast<std::size_t>(verdict)]);
    }
    return counts;
}

std::vector<Finding> read_findings(const Json& json) {
    std::vector<Finding> findings;
    for (const Json& item : json) {
        findings.push_back({from_name<Defect>(item.at("defect").get<std::string>(), defect_count),
                            item.at("count").get<std::int64_t>(),
                            item.at("example").get<std::string>()});
    }
    return findings;
}

} // namespace

Json to_json(const AspectRatioSummary& summary, const AspectRatioClasses& classes) {
    return {{"max", summary.max},
            {"top_5_percent_above", summary.top_5_percent},
            {"median", summary.median},
            {"share_below_5", summary.share_isotropic},
            {"share_above_150", summary.share_above_150},
            {"classes", {{"max", classes.max}, {"nodes", classes.counts}}}};
}

Json to_json(const Conformity& c) {
    return {{"edges", c.edges},
            {"in_band", c.in_band},
            {"below_half", c.below_half},
            {"above_two", c.above_two},
            {"shortest", c.shortest},
            {"longest", c.longest},
            {"mean_quality", c.mean_quality},
            {"worst_quality", c.worst_quality}};
}

Json to_json(const std::vector<Finding>& findings) {
    Json list = Json::array();
    for (const Finding& f : findings) {
        list.push_back({{"defect", name(f.defect)}, {"count", f.count}, {"example", f.example}});
    }
    return list;
}

Json to_json(const BoundaryRepair& repair) {
    return {{"faces_added", repair.faces_added},
            {"faces_turned", repair.faces_turned},
            {"elements_turned", repair.elements_turned},
            {"orphans_removed", repair.orphans_removed},
            {"first_new_patch", repair.first_new_patch}};
}

Json to_json(const VerdictCounts& counts) {
    Json json = Json::object();
    for (std::size_t i = 0; i < verdict_count; ++i) {
        if (counts.counts[i] != 0) {
            json[std::string(name(static_cast<Verdict>(i)))] = counts.counts[i];
        }
    }
    return json;
}

Json to_json(const LevelStatistics& s) {
    return {
        {"level", s.level},
        {"nodes", s.nodes},
        {"elements", s.elements},
        {"boundary_faces", s.faces},
        {"factor", s.factor},
        {"ratio", s.ratio},
        {"predicted_nodes", s.predicted_nodes},
        {"predicted_elements", s.predicted_elements},
        {"volume", s.volume},
        {"complexity", s.complexity},
        {"aspect_ratio", to_json(s.aspect_ratio, s.classes)},
        {"conformity", to_json(s.conformity)},
        {"boundary", {{"deviation", s.deviation}, {"deviation_relative", s.deviation_relative}}},
        {"layers", {{"lines", s.lines}, {"nodes_on_lines", s.line_nodes}}},
        {"verdicts",
         {{"removal", to_json(s.removal)},
          {"swaps", to_json(s.swaps)},
          {"moves", to_json(s.moves)}}},
        {"warnings", to_json(s.warnings)}};
}

Json to_json(const LevelTiming& t) {
    return {{"level", t.level},
            {"seconds",
             {{"metric", t.phases.metric},
              {"order", t.phases.order},
              {"first_pass", t.phases.first_pass},
              {"remove", t.phases.remove},
              {"swap", t.phases.swap},
              {"fit", t.phases.fit},
              {"check", t.phases.check},
              {"statistics", t.statistics},
              {"write", t.write},
              {"transfer", t.transfer},
              {"total", t.total()}}},
            {"peak_memory_bytes", t.peak_memory}};
}

Json to_json(const AdaptReport& r) {
    return {{"nodes_before", r.nodes_before},
            {"nodes", r.nodes_after},
            {"elements_before", r.elements_before},
            {"elements", r.elements_after},
            {"predicted_nodes", r.predicted_nodes},
            {"conformity_before", to_json(r.conformity_before)},
            {"conformity", to_json(r.conformity)},
            {"stages", r.stages},
            {"passes", r.passes.size()},
            {"splits", to_json(r.splits)},
            {"collapses", to_json(r.collapses)},
            {"swaps", to_json(r.swaps)},
            {"moves", to_json(r.moves)},
            {"seconds", r.seconds}};
}

void from_json(const Json& json, BoundaryRepair& repair) {
    json.at("faces_added").get_to(repair.faces_added);
    json.at("faces_turned").get_to(repair.faces_turned);
    json.at("elements_turned").get_to(repair.elements_turned);
    json.at("orphans_removed").get_to(repair.orphans_removed);
    json.at("first_new_patch").get_to(repair.first_new_patch);
}

void from_json(const Json& json, LevelStatistics& s) {
    json.at("level").get_to(s.level);
    json.at("nodes").get_to(s.nodes);
    json.at("elements").get_to(s.elements);
    json.at("boundary_faces").get_to(s.faces);
    json.at("factor").get_to(s.factor);
    json.at("ratio").get_to(s.ratio);
    json.at("predicted_nodes").get_to(s.predicted_nodes);
    json.at("predicted_elements").get_to(s.predicted_elements);
    json.at("volume").get_to(s.volume);
    json.at("complexity").get_to(s.complexity);
    read_aspect_ratios(json.at("aspect_ratio"), s);
    read_conformity(json.at("conformity"), s.conformity);
    json.at("boundary").at("deviation").get_to(s.deviation);
    json.at("boundary").at("deviation_relative").get_to(s.deviation_relative);
    json.at("layers").at("lines").get_to(s.lines);
    json.at("layers").at("nodes_on_lines").get_to(s.line_nodes);
    s.removal = read_verdicts(json.at("verdicts").at("removal"));
    s.swaps = read_verdicts(json.at("verdicts").at("swaps"));
    s.moves = read_verdicts(json.at("verdicts").value("moves", Json::object())); // newer
    s.warnings = read_findings(json.at("warnings"));
}

void from_json(const Json& json, LevelTiming& t) {
    const Json& seconds = json.at("seconds");
    json.at("level").get_to(t.level);
    seconds.at("metric").get_to(t.phases.metric);
    seconds.at("order").get_to(t.phases.order);
    seconds.at("first_pass").get_to(t.phases.first_pass);
    seconds.at("remove").get_to(t.phases.remove);
    seconds.at("swap").get_to(t.phases.swap);
    t.phases.fit = seconds.value("fit", 0.0); // newer than the others
    seconds.at("check").get_to(t.phases.check);
    seconds.at("statistics").get_to(t.statistics);
    seconds.at("write").get_to(t.write);
    seconds.at("transfer").get_to(t.transfer);
    json.at("peak_memory_bytes").get_to(t.peak_memory);
}

} // namespace ameco
