// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/hierarchy_json.h"

#include "core/base/error.h"
#include "core/hierarchy/content_hash.h"
#include "core/hierarchy/statistics_json.h"

namespace ameco {
namespace {

constexpr int schema_version = 1;
constexpr const char* schema = "ameco hierarchy";

Json to_json(const HashedFile& file) {
    return {{"file", file.name}, {"hash", hash_text(file.hash)}};
}

HashedFile read_file(const Json& json) {
    return {json.at("file").get<std::string>(), parse_hash(json.at("hash").get<std::string>())};
}

Json to_json(const TransferFiles& t) {
    return {{"matrix", to_json(t.matrix)},
            {"petsc", to_json(t.petsc)},
            {"parent", to_json(t.parent)},
            {"projected", to_json(t.projected)},
            {"nested", t.nested},
            {"interpolated", t.interpolated},
            {"projected_nodes", t.projected_nodes},
            {"largest_projection", t.largest_projection}};
}

TransferFiles read_transfer(const Json& json) {
    TransferFiles t;
    t.matrix = read_file(json.at("matrix"));
    t.petsc = read_file(json.at("petsc"));
    t.parent = read_file(json.at("parent"));
    t.projected = read_file(json.at("projected"));
    json.at("nested").get_to(t.nested);
    json.at("interpolated").get_to(t.interpolated);
    json.at("projected_nodes").get_to(t.projected_nodes);
    json.at("largest_projection").get_to(t.largest_projection);
    return t;
}

Json settings_json(const Hierarchy& h) {
    const CoarsenOptions& o = h.options.coarsen;
    return {{"levels", h.options.levels},
            {"min_ratio", h.options.min_ratio},
            {"mean", name(o.mean)},
            {"factor", o.target.factor},
            {"factors", h.options.factors},
            {"target_ratio", h.options.target_ratio},
            {"until_isotropic", h.options.until_isotropic},
            {"nodes", name(o.nodes)},
            {"rebuild", h.options.rebuild ? "tetgen" : "none"},
            {"slack", o.target.slack},
            {"isotropic_below", o.target.isotropic_below},
            {"algorithm", name(o.target.algorithm)},
            {"gradation", o.target.gradation},
            {"surface_deviation", o.removal.surface.relative_distance},
            {"ridge_angle_deg", o.features.ridge_angle_deg},
            {"corner_angle_deg", o.features.corner_angle_deg},
            {"frozen_patches", o.features.frozen_patches},
            {"boundary", name(o.features.boundary)},
            {"mesh_suffix", h.mesh_suffix},
            {"export_format", h.export_format},
            {"export_suffix", h.export_suffix}};
}

BoundaryChoice read_boundary_choice(const std::string& text) {
    if (const std::optional<BoundaryChoice> choice = boundary_choice_from_name(text)) {
        return *choice;
    }
    throw InputError("unknown boundary \"" + text + "\"");
}

Mean read_mean(const std::string& text) {
    if (const std::optional<Mean> mean = mean_from_name(text)) {
        return *mean;
    }
    throw InputError("unknown mean \"" + text + "\"");
}

CoarseNodes read_nodes(const std::string& text) {
    if (const std::optional<CoarseNodes> nodes = coarse_nodes_from_name(text)) {
        return *nodes;
    }
    throw InputError("unknown nodes \"" + text + "\"");
}

TargetAlgorithm read_algorithm(const std::string& text) {
    if (const std::optional<TargetAlgorithm> algorithm = target_algorithm_from_name(text)) {
        return *algorithm;
    }
    throw InputError("unknown algorithm \"" + text + "\"");
}

void read_settings(const Json& json, Hierarchy& h) {
    CoarsenOptions& o = h.options.coarsen;
    json.at("levels").get_to(h.options.levels);
    json.at("min_ratio").get_to(h.options.min_ratio);
    o.mean = read_mean(json.at("mean").get<std::string>());
    json.at("factor").get_to(o.target.factor);
    json.at("factors").get_to(h.options.factors);
    json.at("target_ratio").get_to(h.options.target_ratio);
    json.at("until_isotropic").get_to(h.options.until_isotropic);
    o.nodes = read_nodes(json.value("nodes", "nested"));           // older files do not say
    h.options.rebuild = json.value("rebuild", "none") == "tetgen"; // older files do not say
    json.at("slack").get_to(o.target.slack);
    json.at("isotropic_below").get_to(o.target.isotropic_below);
    o.target.algorithm = read_algorithm(json.at("algorithm").get<std::string>());
    json.at("gradation").get_to(o.target.gradation);
    json.at("surface_deviation").get_to(o.removal.surface.relative_distance);
    json.at("ridge_angle_deg").get_to(o.features.ridge_angle_deg);
    json.at("corner_angle_deg").get_to(o.features.corner_angle_deg);
    json.at("frozen_patches").get_to(o.features.frozen_patches);
    o.features.boundary = // older files do not say
        read_boundary_choice(json.value("boundary", std::string(name(BoundaryChoice::coarsen))));
    json.at("mesh_suffix").get_to(h.mesh_suffix);
    json.at("export_format").get_to(h.export_format);
    json.at("export_suffix").get_to(h.export_suffix);
}

HierarchyStatus status_from_name(const std::string& text) {
    for (const HierarchyStatus status : {HierarchyStatus::in_progress, HierarchyStatus::complete,
                                         HierarchyStatus::exhausted, HierarchyStatus::cancelled}) {
        if (name(status) == text) {
            return status;
        }
    }
    throw InputError("unknown status \"" + text + "\"");
}

Json level_json(const HierarchyLevel& level) {
    Json json = {{"level", level.statistics.level}, {"mesh", to_json(level.mesh)}};
    json["metric"] = to_json(level.metric);
    if (!level.state.name.empty()) {
        json["state"] = to_json(level.state);
    }
    if (level.transfer) {
        json["transfer"] = to_json(*level.transfer);
    }
    for (const HashedFile& file : level.exports) {
        json["exports"].push_back(to_json(file));
    }
    json.update(to_json(level.statistics));
    return json;
}

HierarchyLevel read_level(const Json& json) {
    HierarchyLevel level;
    level.mesh = read_file(json.at("mesh"));
    level.metric = read_file(json.at("metric"));
    if (json.contains("state")) {
        level.state = read_file(json.at("state"));
    }
    if (json.contains("transfer")) {
        level.transfer = read_transfer(json.at("transfer"));
    }
    if (json.contains("exports")) {
        for (const Json& file : json.at("exports")) {
            level.exports.push_back(read_file(file));
        }
    }
    from_json(json, level.statistics);
    return level;
}

/// What the types cannot say: levels are numbered from 0, counts are those of meshes.
void require_sense(const Hierarchy& h) {
    if (h.dimension != 2 && h.dimension != 3) {
        throw InputError("dimension must be 2 or 3");
    }
    for (std::size_t k = 0; k < h.levels.size(); ++k) {
        const HierarchyLevel& level = h.levels[k];
        if (level.statistics.level != static_cast<int>(k)) {
            throw InputError("entry " + std::to_string(k) + " of \"levels\" is called level " +
                             std::to_string(level.statistics.level));
        }
        if (level.statistics.nodes <= 0 || level.statistics.elements <= 0 ||
            level.mesh.name.empty()) {
            throw InputError("level " + std::to_string(k) + " has no mesh");
        }
    }
}

Hierarchy read_hierarchy_json(const Json& json) {
    if (json.at("schema") != schema) {
        throw InputError("it is not an ameco hierarchy");
    }
    if (json.at("schema_version") != schema_version) {
        throw InputError("its schema version is " + json.at("schema_version").dump() +
                         ", this program reads version " + std::to_string(schema_version));
    }
    Hierarchy h;
    json.at("program").get_to(h.program);
    json.at("dimension").get_to(h.dimension);
    h.status = status_from_name(json.at("status").get<std::string>());
    read_settings(json.at("settings"), h);
    const Json& input = json.at("input");
    h.input.file = read_file(input);
    input.at("copied").get_to(h.input.copied);
    input.at("format").get_to(h.input.format);
    from_json(input.at("repair"), h.input.repair);
    for (const Json& level : json.at("levels")) {
        h.levels.push_back(read_level(level));
    }
    require_sense(h);
    return h;
}

/// Calls `read` and turns whatever goes wrong into one line that names the file.
template <class Read>
auto reading(const std::string& file, Read read) {
    try {
        return read();
    } catch (const Json::exception& e) {
        throw InputError(file + ": damaged or not written by ameco: " + e.what());
    } catch (const InputError& e) {
        throw InputError(file + ": cannot be used: " + e.what());
    }
}

} // namespace

std::string hierarchy_text(const Hierarchy& h) {
    Json input = to_json(h.input.file);
    input["copied"] = h.input.copied;
    input["format"] = h.input.format;
    input["repair"] = to_json(h.input.repair);
    Json levels = Json::array();
    for (const HierarchyLevel& level : h.levels) {
        levels.push_back(level_json(level));
    }
    const Json json = {{"schema", schema},
                       {"schema_version", schema_version},
                       {"program", h.program},
                       {"dimension", h.dimension},
                       {"status", name(h.status)},
                       {"settings", settings_json(h)},
                       {"input", std::move(input)},
                       {"grid_complexity", grid_complexity(h)},
                       {"element_complexity", element_complexity(h)},
                       {"levels", std::move(levels)}};
    return json.dump(2) + "\n";
}

Hierarchy parse_hierarchy(const std::string& text, const std::string& file) {
    return reading(file, [&] { return read_hierarchy_json(Json::parse(text)); });
}

std::string timing_text(const std::vector<LevelTiming>& timings, int threads) {
    Json levels = Json::array();
    for (const LevelTiming& timing : timings) {
        levels.push_back(to_json(timing));
    }
    const Json json = {
        {"schema_version", schema_version}, {"threads", threads}, {"levels", std::move(levels)}};
    return json.dump(2) + "\n";
}

std::vector<LevelTiming> parse_timing(const std::string& text, const std::string& file) {
    return reading(file, [&] {
        std::vector<LevelTiming> timings;
        const Json json = Json::parse(text);
        for (const Json& level : json.at("levels")) {
            timings.emplace_back();
            from_json(level, timings.back());
        }
        return timings;
    });
}

std::string different_settings(const Hierarchy& a, const Hierarchy& b) {
    const Json settings_a = settings_json(a);
    const Json settings_b = settings_json(b);
    std::string names;
    for (const auto& [key, value] : settings_a.items()) {
        if (key != "levels" && settings_b.at(key) != value) {
            names += (names.empty() ? "" : ", ") + key;
        }
    }
    return names;
}

} // namespace ameco
