// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/report/report_page.h"

#include "core/base/text.h"
#include "core/hierarchy/content_hash.h"
#include "core/hierarchy/pictures.h"
#include "core/hierarchy/settings.h"
#include "core/multigrid/convergence_plot.h"
#include "core/report/report_tables.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace ameco {
namespace {

using Facts = std::vector<std::pair<std::string, std::string>>;

std::string paragraph(const std::string& text) {
    return "<p class=\"dim\">" + xml_escaped(text) + "</p>\n";
}

std::string tiles(const Facts& facts) {
    std::string out = "<div class=\"tiles\">\n";
    for (const auto& [name, value] : facts) {
        out +=
            "<div><b>" + xml_escaped(value) + "</b><span>" + xml_escaped(name) + "</span></div>\n";
    }
    return out + "</div>\n";
}

std::string status_text(const Hierarchy& h) {
    switch (h.status) {
    case HierarchyStatus::complete:
        return "complete";
    case HierarchyStatus::exhausted:
        return "complete: the last level cannot be coarsened further";
    case HierarchyStatus::cancelled:
        return "stopped by the user; the levels listed are good";
    case HierarchyStatus::in_progress:
        return "still being made, or the program was killed; the levels listed are good";
    }
    return "";
}

/// Without the way to it.
std::string mesh_name(const Hierarchy& h) {
    return std::filesystem::path(h.input.file.name).filename().string();
}

std::string head(const ReportContent& content) {
    const Hierarchy& h = content.hierarchy;
    const LevelStatistics& finest = h.levels.front().statistics;
    const LevelStatistics& coarsest = h.levels.back().statistics;
    std::string out = "<h1>" + xml_escaped(mesh_name(h)) + "</h1>\n" +
                      paragraph("A hierarchy of meshes for geometric multigrid, in " +
                                content.folder + ". Status: " + status_text(h) + ".");
    Facts facts{{"nodes, finest", count_text(finest.nodes)},
                {"nodes, coarsest", count_text(coarsest.nodes)},
                {"coarser levels", std::to_string(h.levels.size() - 1)},
                {"grid complexity", ratio_text(grid_complexity(h))},
                {"largest aspect ratio", number_text(finest.aspect_ratio.max)}};
    double deviation = 0, worst = 1;
    for (const HierarchyLevel& level : h.levels) {
        deviation = std::max(deviation, level.statistics.deviation_relative);
        worst = std::min(worst, level.statistics.conformity.worst_quality);
    }
    facts.emplace_back("boundary moved, over local size", number_text(deviation, 2));
    facts.emplace_back("worst element quality", number_text(worst, 2));
    if (!content.cycles.empty()) {
        const ReportedCycle& best = content.cycles.back();
        facts.emplace_back("CG iterations, " + best.title,
                           std::to_string(best.study.krylov.iterations));
    }
    return out + tiles(facts);
}

/// Names of the sections, with links to them.
std::string navigation(const std::vector<std::pair<std::string, std::string>>& sections) {
    std::string out = "<nav>";
    for (const auto& [id, title] : sections) {
        out += "<a href=\"#" + id + "\">" + xml_escaped(title) + "</a> ";
    }
    return out + "</nav>\n";
}

std::string setting_text(const Setting& setting, const std::string& word) {
    if (setting.kind == Setting::Kind::flag) {
        return word == "0" ? "no" : "yes";
    }
    return setting.zero_is_off && word == "0" ? "off" : word;
}

std::string input_body(const ReportContent& content) {
    const Hierarchy& h = content.hierarchy;
    const BoundaryRepair& r = h.input.repair;
    Facts facts{{"Finest mesh", h.input.file.name},
                {"Format", h.input.format},
                {"Fingerprint", hash_text(h.input.file.hash)},
                {"Dimension", std::to_string(h.dimension)}};
    if (r.faces_added > 0) {
        facts.emplace_back("Boundary faces added", count_text(r.faces_added));
    }
    if (r.faces_turned > 0) {
        facts.emplace_back("Boundary faces turned outwards", count_text(r.faces_turned));
    }
    if (r.orphans_removed > 0) {
        facts.emplace_back("Nodes no element used, dropped", count_text(r.orphans_removed));
    }
    for (const Setting& s : settings()) {
        facts.emplace_back(std::string(s.label), setting_text(s, s.value(h.options)));
    }
    std::string frozen;
    for (const int patch : h.options.coarsen.features.frozen_patches) {
        frozen += (frozen.empty() ? "" : ", ") + std::to_string(patch);
    }
    const bool all = h.options.coarsen.features.boundary == BoundaryChoice::keep;
    facts.emplace_back("Patches left untouched", all ? "all" : frozen.empty() ? "none" : frozen);
    facts.emplace_back("Program", h.program);
    std::string command = "ameco coarsen";
    std::vector<double> factors;
    for (std::size_t k = 1; k < h.levels.size(); ++k) {
        factors.push_back(h.levels[k].statistics.factor);
    }
    for (const std::string& word : coarsen_arguments(h.options, factors)) {
        command += ' ' + shell_word(word);
    }
    return html::facts(facts) + "<p>The same levels again: <code>" + xml_escaped(command) +
           "</code> with the mesh and <code>-o FOLDER</code>.</p>\n";
}

std::string warnings_body(const Hierarchy& h) {
    html::Table table{{{"level"}, {"what", true}, {"how often"}, {"the first one", true}}, {}};
    for (const HierarchyLevel& level : h.levels) {
        for (const Finding& finding : level.statistics.warnings) {
            table.rows.push_back({std::to_string(level.statistics.level),
                                  std::string(name(finding.defect)), count_text(finding.count),
                                  finding.example});
        }
    }
    return table.rows.empty() ? paragraph("Every level was tested after it was made: exact "
                                          "orientation, conforming, closed boundary. Nothing "
                                          "unusual was found.")
                              : paragraph("Every level was tested after it was made and is valid. "
                                          "Unusual, but workable:") +
                                    html::text_of(table);
}

std::string multigrid_body(const std::vector<ReportedCycle>& cycles) {
    html::Table table{{{"cycle", true},
                       {"operator complexity"},
                       {"work of a cycle", false, "in products with the finest matrix"},
                       {"factor", false, "error after a cycle over error before, by itself"},
                       {"CG iterations", false, "to a residual of 1e-8"}},
                      {}};
    std::vector<ConvergenceCurve> curves;
    for (const ReportedCycle& c : cycles) {
        table.rows.push_back(
            {c.title, ratio_text(c.operator_complexity), number_text(c.study.work_per_cycle, 3),
             number_text(c.study.factor, 3), std::to_string(c.study.krylov.iterations)});
        curves.push_back({c.title, c.study.krylov.residuals});
    }
    return paragraph("Poisson's equation with linear elements, Dirichlet conditions on the whole "
                     "boundary, right-hand side 1; conjugate gradients with one cycle as "
                     "preconditioner.") +
           html::text_of(table) +
           html::figure(convergence_plot(curves), "Relative residual of conjugate gradients");
}

} // namespace

std::string report_page(const ReportContent& content) {
    const Hierarchy& h = content.hierarchy;
    std::vector<AspectRatioClasses> classes;
    for (const HierarchyLevel& level : h.levels) {
        classes.push_back(level.statistics.classes);
    }
    std::vector<std::array<std::string, 3>> sections{
        {"levels", "Levels",
         html::text_of(levels_table(h)) +
             paragraph("AR: aspect ratio of the natural metric at the nodes. Rest the mouse on a "
                       "heading to see what it means.")},
        {"aspect-ratios", "Aspect ratios",
         html::figure(histogram_svg(classes), "Share of each level's nodes by aspect ratio; the "
                                              "classes halve from the finest level's largest") +
             html::text_of(classes_table(h))}};
    if (!content.sections.empty()) {
        sections.push_back(
            {"layers", "Near the wall",
             html::figure(content.sections, "Each level at the place where the finest mesh is "
                                            "stretched most")});
    }
    sections.push_back({"quality", "Quality and conformity",
                        html::text_of(conformity_table(h)) +
                            paragraph("Level 0 in its natural metric, the others in the metric "
                                      "that was asked for.")});
    sections.push_back(
        {"geometry", "Geometry", html::text_of(geometry_table(h)) + warnings_body(h)});
    if (!content.cycles.empty()) {
        sections.push_back({"multigrid", "Multigrid", multigrid_body(content.cycles)});
    }
    if (h.levels.size() > 1) {
        sections.push_back({"removals", "Why nodes stayed",
                            html::text_of(removals_table(h)) +
                                paragraph("Attempts, not nodes: a node is tried again in later "
                                          "passes.")});
    }
    if (!content.timings.empty()) {
        sections.push_back({"times", "Times and memory",
                            html::text_of(times_table(content.timings)) +
                                paragraph("Seconds on the clock, by phase.")});
    }
    sections.push_back({"input", "Input and settings", input_body(content)});
    std::string body;
    std::vector<std::pair<std::string, std::string>> names;
    for (const auto& [id, title, text] : sections) {
        names.emplace_back(id, title);
        body += html::section(id, title, text);
    }
    return html::page(mesh_name(h) + ": mesh hierarchy", head(content) + navigation(names) + body);
}

} // namespace ameco
