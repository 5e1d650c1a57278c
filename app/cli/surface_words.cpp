// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/surface_words.h"

#include "app/cli/report.h"
#include "core/mesh/references.h"
#include "core/surface/boundary_surface.h"

#include <set>

namespace ameco::cli {
namespace {

template <class IdType>
Json ids_json(const std::vector<IdType>& ids) {
    Json list = Json::array();
    for (const IdType id : ids) {
        list.push_back(id.value());
    }
    return list;
}

template <class IdType>
Json pairs_json(const std::vector<std::array<IdType, 2>>& pairs) {
    Json list = Json::array();
    for (const auto& pair : pairs) {
        list.push_back({pair[0].value(), pair[1].value()});
    }
    return list;
}

Json point_json(const Vec<3>& x) {
    return {x[0], x[1], x[2]};
}

std::size_t patch_count(const Mesh<3>& surface) {
    return std::set<int>(surface.patch.begin(), surface.patch.end()).size();
}

std::string genus_text(const SurfacePart& part) {
    return part.closed && part.orientable ? std::to_string(part.genus()) : "";
}

} // namespace

Mesh<3> load_surface(const std::filesystem::path& path, Session& session) {
    return surface_of(load_mesh(path, session, {.surfaces = true}), path, session.monitor);
}

Mesh<3> surface_of(MeshFile&& file, const std::filesystem::path& path, Monitor& monitor) {
    auto* const mesh = std::get_if<Mesh<3>>(&file.mesh);
    if (mesh == nullptr) {
        throw UsageError(path.string() + ": is a mesh in two dimensions, and has no surface");
    }
    if (mesh->elements.empty()) {
        return std::move(*mesh);
    }
    const BadReferences bad = find_bad_references(*mesh);
    if (bad.count > 0) {
        throw InputError(path.string() + ": " + bad.example);
    }
    for (const std::string& remark : repair_remarks(complete_boundary(*mesh))) {
        monitor.message(Severity::info, path.string() + ": " + remark);
    }
    return boundary_surface(*mesh);
}

Json surface_json(const SurfaceReport& report) {
    const SurfaceDefects& d = report.defects;
    Json parts = Json::array();
    for (const SurfacePart& p : report.parts) {
        Json part = {{"first_face", p.first_face.value()},
                     {"nodes", p.nodes},
                     {"edges", p.edges},
                     {"faces", p.faces},
                     {"closed", p.closed},
                     {"orientable", p.orientable},
                     {"area", p.area}};
        if (p.closed && p.orientable) {
            part["genus"] = p.genus();
            part["volume"] = p.volume;
        }
        parts.push_back(part);
    }
    return {{"sound", report.sound()},
            {"nodes", report.nodes},
            {"unused_nodes", report.unused_nodes},
            {"faces", report.faces},
            {"bounds", {{"low", point_json(report.low)}, {"high", point_json(report.high)}}},
            {"edge_lengths", {report.shortest_edge, report.longest_edge}},
            {"largest_aspect_ratio", report.largest_aspect_ratio},
            {"parts", parts},
            {"defects",
             {{"open_edges", pairs_json(d.open_edges)},
              {"crowded_edges", pairs_json(d.crowded_edges)},
              {"pinched_nodes", ids_json(d.pinched_nodes)},
              {"intersections", pairs_json(d.intersections)},
              {"duplicate_nodes", pairs_json(d.duplicate_nodes)},
              {"duplicate_faces", pairs_json(d.duplicate_faces)},
              {"flat_faces", ids_json(d.flat_faces)},
              {"disagreeing_edges", pairs_json(d.disagreeing_edges)}}}};
}

Json features_json(const Mesh<3>& surface, const SurfaceFeatures& features) {
    Json curves = Json::array();
    for (const SurfaceCurve& c : features.curves) {
        curves.push_back({{"patches", {c.patches.first, c.patches.second}},
                          {"edges", c.nodes.size() - 1},
                          {"length", c.length},
                          {"closed", c.closed()},
                          {"from", c.nodes.front().value()},
                          {"to", c.nodes.back().value()}});
    }
    return {{"patches", patch_count(surface)},
            {"ridge_edges", features.ridges.size()},
            {"corners", ids_json(features.corners)},
            {"curves", curves}};
}

void print_surface(std::ostream& out, const std::string& file, const SurfaceReport& report,
                   const std::vector<std::string>& mended) {
    out << file << ": " << (report.sound() ? "sound" : "NOT SOUND") << '\n';
    for (const std::string& line : defect_remarks(report.defects)) {
        out << "  error: " << line << '\n';
    }
    for (const SurfacePart& p : report.parts) {
        if (!p.orientable) {
            out << "  error: the part with face " << p.first_face.value() << " has one side only\n";
        }
    }
    for (const std::string& line : mended) {
        out << "  mended: " << line << '\n';
    }
    double area = 0, volume = 0;
    for (const SurfacePart& p : report.parts) {
        area += p.area;
        volume += p.volume;
    }
    Facts facts{{"nodes", count_text(report.nodes)},
                {"faces", count_text(report.faces)},
                {"area", number_text(area, 6)}};
    if (report.sound()) {
        facts.emplace_back("volume", number_text(volume, 6));
    }
    facts.emplace_back("edges", number_text(report.shortest_edge) + " .. " +
                                    number_text(report.longest_edge));
    facts.emplace_back("aspect ratio", "up to " + number_text(report.largest_aspect_ratio));
    print_facts(out, facts);
    Table table({{"part"}, {"nodes"}, {"faces"}, {"closed"}, {"genus"}, {"area"}, {"volume"}});
    constexpr std::size_t shown = 20;
    for (std::size_t i = 0; i < std::min(shown, report.parts.size()); ++i) {
        const SurfacePart& p = report.parts[i];
        table.add_row({std::to_string(i), count_text(p.nodes), count_text(p.faces),
                       p.closed ? "yes" : "no", genus_text(p), number_text(p.area, 6),
                       p.closed && p.orientable ? number_text(p.volume, 6) : ""});
    }
    table.print(out);
    if (report.parts.size() > shown) {
        out << "and " << report.parts.size() - shown << " parts more\n";
    }
}

Facts features_facts(const Mesh<3>& surface, const SurfaceFeatures& features) {
    return {{"patches", count_text(static_cast<std::int64_t>(patch_count(surface)))},
            {"ridges", plural(static_cast<std::int64_t>(features.ridges.size()), "edge") + " in " +
                           plural(static_cast<std::int64_t>(features.curves.size()), "curve")},
            {"corners", count_text(static_cast<std::int64_t>(features.corners.size()))}};
}

} // namespace ameco::cli
