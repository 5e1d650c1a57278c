// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/session.h"

#include "core/base/error.h"
#include "core/hierarchy/settings.h"
#include "core/io/atomic_file.h"
#include "gui/model/case_work.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace ameco::gui {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* schema = "ameco session";
constexpr int schema_version = 1;

constexpr std::array where_names{"none", "picked", "clip plane", "sample"};

Json to_json(const Vec3& v) {
    return Json::array({v[0], v[1], v[2]});
}

Vec3 vector_of(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

/// Settings by their names, as words.
Json to_json(const HierarchyOptions& options) {
    Json json = Json::object();
    for (const Setting& s : settings()) {
        json[std::string(s.name)] = s.value(options);
    }
    json["factor"] = options.coarsen.target.factor;
    json["frozen_patches"] = options.coarsen.features.frozen_patches;
    return json;
}

HierarchyOptions options_of(const Json& json) {
    HierarchyOptions options;
    for (const Setting& s : settings()) {
        // Older sessions lack the settings that came later.
        const std::string word = json.value(std::string(s.name), s.value(options));
        if (!s.accepts(word)) {
            throw InputError("its setting " + std::string(s.name) + " is " + word);
        }
        s.assign(options, word);
    }
    json.at("factor").get_to(options.coarsen.target.factor);
    json.at("frozen_patches").get_to(options.coarsen.features.frozen_patches);
    return options;
}

Json to_json(const SceneOptions& o) {
    Json json = {{"representation", name(o.representation)},
                 {"colour", name(o.colour)},
                 {"clip",
                  {{"enabled", o.clip.enabled},
                   {"origin", to_json(o.clip.origin)},
                   {"normal", to_json(o.clip.normal)},
                   {"crinkle", o.clip.crinkle},
                   {"keep_other_side", o.clip.keep_other_side}}},
                 {"view_scale", to_json(o.view_scale)},
                 {"lens",
                  {{"enabled", o.lens.enabled},
                   {"origin", to_json(o.lens.origin)},
                   {"normal", to_json(o.lens.normal)},
                   {"factor", o.lens.factor}}},
                 {"ellipsoids",
                  {{"where", where_names.at(static_cast<std::size_t>(o.ellipsoids.where))},
                   {"target", o.ellipsoids.source == EllipsoidSource::target},
                   {"mean", name(o.ellipsoids.mean)},
                   {"max_count", o.ellipsoids.max_count},
                   {"scale", o.ellipsoids.scale},
                   {"compress", o.ellipsoids.compress}}},
                 {"hidden_patches", o.hidden_patches},
                 {"dark", o.dark},
                 {"axes", o.axes},
                 {"scale_bar", o.scale_bar},
                 {"legend", o.legend}};
    if (o.range) {
        json["range"] = {o.range->first, o.range->second};
    }
    return json;
}

/// The value of an enum by its name; the names' own type says which.
template <class Value>
Value required(const std::optional<Value>& value, const Json& json) {
    if (!value) {
        throw InputError("it has the unknown name " + json.dump());
    }
    return *value;
}

void read_ellipsoids(const Json& json, EllipsoidOptions& e) {
    const auto where = json.at("where").get<std::string>();
    const auto* const found = std::find(where_names.begin(), where_names.end(), where);
    if (found == where_names.end()) {
        throw InputError("it has the unknown name " + where);
    }
    e.where = static_cast<EllipsoidOptions::Where>(found - where_names.begin());
    e.source = json.at("target").get<bool>() ? EllipsoidSource::target : EllipsoidSource::natural;
    e.mean = required(mean_from_name(json.at("mean").get<std::string>()), json.at("mean"));
    json.at("max_count").get_to(e.max_count);
    json.at("scale").get_to(e.scale);
    json.at("compress").get_to(e.compress);
}

SceneOptions scene_of(const Json& json) {
    SceneOptions o;
    o.representation =
        required(representation_from_name(json.at("representation").get<std::string>()),
                 json.at("representation"));
    o.colour = required(colour_from_name(json.at("colour").get<std::string>()), json.at("colour"));
    const Json& clip = json.at("clip");
    clip.at("enabled").get_to(o.clip.enabled);
    o.clip.origin = vector_of(clip.at("origin"));
    o.clip.normal = vector_of(clip.at("normal"));
    clip.at("crinkle").get_to(o.clip.crinkle);
    clip.at("keep_other_side").get_to(o.clip.keep_other_side);
    o.view_scale = vector_of(json.at("view_scale"));
    const Json& lens = json.at("lens");
    lens.at("enabled").get_to(o.lens.enabled);
    o.lens.origin = vector_of(lens.at("origin"));
    o.lens.normal = vector_of(lens.at("normal"));
    lens.at("factor").get_to(o.lens.factor);
    read_ellipsoids(json.at("ellipsoids"), o.ellipsoids);
    json.at("hidden_patches").get_to(o.hidden_patches);
    json.at("dark").get_to(o.dark);
    json.at("axes").get_to(o.axes);
    json.at("scale_bar").get_to(o.scale_bar);
    json.at("legend").get_to(o.legend);
    if (json.contains("range")) {
        o.range = {json["range"].at(0).get<double>(), json["range"].at(1).get<double>()};
    }
    return o;
}

Json to_json(const Camera& c) {
    return {{"focus", to_json(c.focus)},
            {"sight", to_json(c.sight)},
            {"up", to_json(c.up)},
            {"height", c.height}};
}

Camera camera_of(const Json& json) {
    return {vector_of(json.at("focus")), vector_of(json.at("sight")), vector_of(json.at("up")),
            json.at("height").get<double>()};
}

Session read_json(const Json& json, const fs::path& folder) {
    if (json.at("schema") != schema || json.at("schema_version") != schema_version) {
        throw InputError("it is not a session of version " + std::to_string(schema_version));
    }
    const auto absolute = [&](const Json& path) {
        return (folder / path.get<std::string>()).lexically_normal().string();
    };
    Session s;
    s.mesh = absolute(json.at("mesh"));
    for (const Json& level : json.at("levels")) {
        s.levels.push_back({level.at("key").get<int>(), level.at("parent").get<int>(),
                            level.at("number").get<int>(), absolute(level.at("folder")),
                            options_of(level.at("settings"))});
    }
    json.at("current").get_to(s.current);
    json.at("shown").get_to(s.shown);
    if (s.shown.size() != 1 && s.shown.size() != 2 && s.shown.size() != 4) {
        throw InputError("it has " + std::to_string(s.shown.size()) + " views");
    }
    s.camera = camera_of(json.at("camera"));
    s.scene = scene_of(json.at("scene"));
    s.options = options_of(json.at("settings"));
    json.at("threads").get_to(s.threads);
    json.at("percent").get_to(s.percent);
    json.at("logarithmic").get_to(s.logarithmic);
    return s;
}

/// The levels from the finest to this one.
std::vector<CaseLevel> branch_of(const std::vector<CaseLevel>& levels, int id) {
    std::vector<CaseLevel> branch;
    while (id >= 0) {
        const auto level = std::find_if(levels.begin(), levels.end(),
                                        [id](const CaseLevel& l) { return l.id == id; });
        branch.insert(branch.begin(), *level);
        id = level->parent;
    }
    return branch;
}

} // namespace

std::string session_text(const Session& s, const fs::path& folder) {
    const auto relative = [&](const std::string& path) {
        return fs::path(path).lexically_proximate(fs::absolute(folder)).string();
    };
    Json levels = Json::array();
    for (const StoredLevel& level : s.levels) {
        levels.push_back({{"key", level.key},
                          {"parent", level.parent_key},
                          {"number", level.number},
                          {"folder", relative(level.folder)},
                          {"settings", to_json(level.options)}});
    }
    const Json json = {{"schema", schema},
                       {"schema_version", schema_version},
                       {"program", std::string("ameco ") + AMECO_VERSION},
                       {"mesh", relative(s.mesh)},
                       {"levels", levels},
                       {"current", s.current},
                       {"shown", s.shown},
                       {"camera", to_json(s.camera)},
                       {"scene", to_json(s.scene)},
                       {"settings", to_json(s.options)},
                       {"threads", s.threads},
                       {"percent", s.percent},
                       {"logarithmic", s.logarithmic}};
    return json.dump(2) + '\n';
}

Session parse_session(const std::string& text, const fs::path& file) {
    try {
        return read_json(Json::parse(text), fs::absolute(file).parent_path());
    } catch (const Json::exception& error) {
        throw InputError(file.string() + ": not a session of ameco: " + error.what());
    } catch (const InputError& error) {
        throw InputError(file.string() + ": cannot be opened: " + error.what());
    }
}

Session read_session(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in || !text) {
        throw FileError(file.string() + ": cannot be read: does it exist, may you read it?");
    }
    return parse_session(text.str(), file);
}

void write_session(const fs::path& file, const Session& session) {
    const std::string text = session_text(session, fs::absolute(file).parent_path());
    AtomicFile out(file);
    out.write(text.data(), text.size());
    out.commit();
}

void save_session(const fs::path& file, Session session, const CaseFile& mesh,
                  const std::vector<CaseLevel>& levels, Monitor& monitor) {
    const fs::path folder = fs::absolute(file).parent_path() / (file.stem().string() + ".levels");
    session.mesh = mesh.path;
    session.levels.clear();
    int ends = 0;
    for (const CaseLevel& end : levels) {
        const bool is_end = std::none_of(levels.begin(), levels.end(),
                                         [&](const CaseLevel& l) { return l.parent == end.id; });
        if (!is_end || end.parent < 0) {
            continue;
        }
        const fs::path place = folder / std::to_string(++ends);
        const std::vector<CaseLevel> branch = branch_of(levels, end.id);
        write_branch(mesh, branch, place, monitor);
        for (std::size_t k = 1; k < branch.size(); ++k) {
            const auto is_listed = [&](const StoredLevel& s) { return s.key == branch[k].id; };
            if (std::none_of(session.levels.begin(), session.levels.end(), is_listed)) {
                session.levels.push_back({branch[k].id, branch[k].parent, branch[k].number,
                                          place.string(), branch[k].options});
            }
        }
    }
    write_session(file, session);
}

} // namespace ameco::gui
