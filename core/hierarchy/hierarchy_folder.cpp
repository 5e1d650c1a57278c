// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/hierarchy_folder.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/hierarchy/content_hash.h"
#include "core/hierarchy/hierarchy_json.h"
#include "core/hierarchy/level_state.h"
#include "core/io/atomic_file.h"
#include "core/io/io.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <sstream>
#include <system_error>
#include <utility>

namespace ameco {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = "hierarchy.json";
constexpr const char* timing_name = "timing.json";

std::string read_whole(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file || !text) {
        throw FileError(path.string() + ": cannot be read: does it exist, may you read it?");
    }
    return std::move(text).str();
}

void copy_whole(const fs::path& from, const fs::path& to) {
    std::ifstream source(from, std::ios::binary);
    AtomicFile target(to);
    std::vector<char> buffer(std::size_t{1} << 20);
    while (source.read(buffer.data(), static_cast<std::streamsize>(buffer.size())),
           source.gcount() > 0) {
        target.write(buffer.data(), static_cast<std::size_t>(source.gcount()));
    }
    if (!source.eof()) {
        throw FileError(from.string() + ": cannot be read");
    }
    target.commit();
}

bool file_is_intact(const fs::path& folder, const HashedFile& file) {
    if (file.name.empty()) {
        return true;
    }
    try {
        return content_hash_of_file(folder / file.name) == file.hash;
    } catch (const FileError&) {
        return false;
    }
}

std::array<const HashedFile*, 4> files_of(const TransferFiles& t) {
    return {&t.matrix, &t.petsc, &t.parent, &t.projected};
}

std::vector<std::string> listed_files(const Hierarchy& hierarchy) {
    std::vector<std::string> names{hierarchy.input.file.name};
    for (const HierarchyLevel& level : hierarchy.levels) {
        for (const HashedFile* file : {&level.mesh, &level.metric, &level.state}) {
            names.push_back(file->name);
        }
        if (level.transfer) {
            for (const HashedFile* file : files_of(*level.transfer)) {
                names.push_back(file->name);
            }
        }
        for (const HashedFile& file : level.exports) {
            names.push_back(file.name);
        }
    }
    return names;
}

void remove_others(const fs::path& folder, const Hierarchy& hierarchy) {
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_regular_file() && is_hierarchy_file(entry.path().filename().string())) {
            old.push_back(entry.path());
        }
    }
    // The list goes first, so that it never names a file that is gone.
    std::sort(old.begin(), old.end(), [](const fs::path& a, const fs::path& b) {
        return std::pair(a.filename() != list_name, a) < std::pair(b.filename() != list_name, b);
    });
    const std::vector<std::string> keep = listed_files(hierarchy);
    for (const fs::path& file : old) {
        const std::string name = file.filename().string();
        if (std::find(keep.begin(), keep.end(), name) == keep.end()) {
            std::error_code failure;
            fs::remove(file, failure);
            if (failure) {
                throw FileError(file.string() + ": cannot be removed: " + failure.message());
            }
        }
    }
}

/// Files in the folder that are called level_k and something.
std::vector<std::string> files_of_level(const fs::path& folder, int level) {
    const std::string begin = "level_" + std::to_string(level) + ".";
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::string name = entry.path().filename().string();
        if (name.compare(0, begin.size(), begin) == 0) {
            names.push_back(std::move(name));
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

template <int D>
Mesh<D> take(MeshFile&& file, const fs::path& path) {
    Mesh<D>* const mesh = std::get_if<Mesh<D>>(&file.mesh);
    if (mesh == nullptr) {
        throw InputError(path.string() + ": is not of the hierarchy's dimension " +
                         std::to_string(D));
    }
    return std::move(*mesh);
}

} // namespace

HierarchyFolder::HierarchyFolder(fs::path folder, const fs::path& source, Hierarchy start,
                                 std::vector<LevelTiming> timings)
    : folder_(std::move(folder)), made_folder_(!fs::exists(folder_)), hierarchy_(std::move(start)),
      timings_(std::move(timings)) {
    try {
        begin(source);
    } catch (...) {
        take_back();
        throw;
    }
}

void HierarchyFolder::begin(const fs::path& source) {
    create_folder(folder_);
    remove_others(folder_, hierarchy_);
    if (hierarchy_.levels.empty()) {
        HierarchyInput& input = hierarchy_.input;
        if (input.copied) {
            input.file.name = "level_0" + source.extension().string();
            copy_whole(source, folder_ / input.file.name);
        } else {
            input.file.name = fs::proximate(fs::canonical(source), fs::canonical(folder_)).string();
        }
        input.file.hash = content_hash_of_file(source);
    }
    hierarchy_.status = HierarchyStatus::in_progress;
    std::erase_if(timings_, [&](const LevelTiming& timing) {
        return timing.level >= static_cast<int>(hierarchy_.levels.size());
    });
    write_lists();
}

template <int D>
std::vector<std::string> HierarchyFolder::write_export(const Mesh<D>& mesh, int level,
                                                       HierarchyLevel& entry) const {
    const std::string& suffix = hierarchy_.export_suffix;
    if (hierarchy_.export_format.empty() || (level == 0 && entry.mesh.name.ends_with(suffix))) {
        return {}; // not asked for, or the input is in that format
    }
    auto notes = write_mesh(folder_ / ("level_" + std::to_string(level) + suffix), mesh,
                            {.format = hierarchy_.export_format});
    // Some formats are several files.
    for (const std::string& name : files_of_level(folder_, level)) {
        if (name != entry.mesh.name) {
            entry.exports.push_back(hashed(folder_, name));
        }
    }
    return notes;
}

template <int D>
std::vector<std::string> HierarchyFolder::add_level(const Level<D>& level,
                                                    const LevelStatistics& statistics,
                                                    LevelTiming timing) {
    const Stopwatch watch;
    const std::string number = std::to_string(statistics.level);
    HierarchyLevel entry;
    entry.statistics = statistics;
    if (statistics.level == 0) {
        entry.mesh = hierarchy_.input.file;
    } else {
        const std::string mesh = "level_" + number + hierarchy_.mesh_suffix;
        write_mesh(folder_ / mesh, level.mesh);
        entry.mesh = hashed(folder_, mesh);
        const std::string state = "state_" + number + ".cbor";
        write_whole_file(folder_ / state, level_state_bytes(level));
        entry.state = hashed(folder_, state);
    }
    const bool text = hierarchy_.mesh_suffix == ".mesh";
    const std::string metric = "metric_" + number + (text ? ".sol" : ".solb");
    write_metric(folder_ / metric, level.natural);
    entry.metric = hashed(folder_, metric);
    std::vector<std::string> notes = write_export(level.mesh, statistics.level, entry);
    hierarchy_.levels.push_back(std::move(entry));
    timing.write = watch.seconds();
    timings_.push_back(timing);
    write_lists();
    return notes;
}

void HierarchyFolder::add_transfer(int level, TransferFiles files, double seconds) {
    const auto k = static_cast<std::size_t>(level);
    hierarchy_.levels.at(k).transfer = std::move(files);
    if (k < timings_.size()) { // a folder without a readable timing.json has none
        timings_[k].transfer = seconds;
    }
    write_lists();
}

void HierarchyFolder::finish(HierarchyStatus status) {
    hierarchy_.status = status;
    write_lists();
}

void HierarchyFolder::take_back() noexcept {
    if (hierarchy_.levels.size() > 1) {
        return;
    }
    try {
        hierarchy_.levels.clear();
        hierarchy_.input.file = {};
        remove_others(folder_, hierarchy_);
        if (made_folder_) {
            fs::remove(folder_); // fails if somebody put a file there
        }
    } catch (const std::exception&) { // the error that ends the run is the one to tell of
    }
}

void HierarchyFolder::write_lists() const {
    write_whole_file(folder_ / timing_name, timing_text(timings_, thread_count()));
    write_whole_file(folder_ / list_name, hierarchy_text(hierarchy_));
}

Hierarchy read_hierarchy(const fs::path& folder) {
    const fs::path file = fs::is_directory(folder) ? folder / list_name : folder;
    return parse_hierarchy(read_whole(file), file.string());
}

std::vector<LevelTiming> read_timing(const fs::path& folder) {
    try {
        const fs::path file = folder / timing_name;
        return parse_timing(read_whole(file), file.string());
    } catch (const Error&) {
        return {}; // nothing depends on it
    }
}

int intact_levels(const fs::path& folder, const Hierarchy& hierarchy) {
    int count = 0;
    for (const HierarchyLevel& level : hierarchy.levels) {
        std::vector<const HashedFile*> files{&level.mesh, &level.metric, &level.state};
        for (const HashedFile& file : level.exports) {
            files.push_back(&file);
        }
        if (!std::all_of(files.begin(), files.end(),
                         [&](const HashedFile* file) { return file_is_intact(folder, *file); })) {
            break;
        }
        ++count;
    }
    return count;
}

bool is_intact(const fs::path& folder, const TransferFiles& files) {
    const auto all = files_of(files);
    return std::all_of(all.begin(), all.end(),
                       [&](const HashedFile* file) { return file_is_intact(folder, *file); });
}

HashedFile hashed(const fs::path& folder, const std::string& file) {
    return {file, content_hash_of_file(folder / file)};
}

template <int D>
Mesh<D> read_level_mesh(const fs::path& folder, const Hierarchy& hierarchy, int level) {
    const fs::path path = folder / hierarchy.levels.at(static_cast<std::size_t>(level)).mesh.name;
    Mesh<D> mesh = take<D>(read_mesh(path), path);
    if (level == 0) {
        complete_boundary(mesh, hierarchy.options.coarsen.features.ridge_angle_deg);
    }
    return mesh;
}

template <int D>
Level<D> read_level(const fs::path& folder, const Hierarchy& hierarchy, int level) {
    const HierarchyLevel& entry = hierarchy.levels.at(static_cast<std::size_t>(level));
    Level<D> result;
    result.mesh = read_level_mesh<D>(folder, hierarchy, level);
    const fs::path state = folder / entry.state.name;
    parse_level_state(read_whole(state), state, result);
    result.geometry.frozen_patches =
        frozen_patches(result.mesh, hierarchy.options.coarsen.features);
    result.geometry.original =
        level == 0 ? classify_geometry(result.mesh).original
                   : classify_geometry(read_level_mesh<D>(folder, hierarchy, 0)).original;
    // Not from its file: directions and sizes would lose digits by way of the tensor.
    result.natural = nodal_metric(result.mesh, hierarchy.options.coarsen.mean);
    return result;
}

bool is_hierarchy_file(const std::string& name) {
    // A killed run leaves files as .<name>.<process>-<count>.tmp (io/atomic_file.h).
    static const std::regex pattern(
        R"(\.?(hierarchy\.json|timing\.json|(level|metric|state|P|parent|projected)_[0-9]+\.[a-z0-9.]+?))"
        R"((\.[0-9]+-[0-9]+\.tmp)?)");
    return std::regex_match(name, pattern);
}

template std::vector<std::string> HierarchyFolder::add_level(const Level<2>&,
                                                             const LevelStatistics&, LevelTiming);
template std::vector<std::string> HierarchyFolder::add_level(const Level<3>&,
                                                             const LevelStatistics&, LevelTiming);
template Mesh<2> read_level_mesh(const fs::path&, const Hierarchy&, int);
template Mesh<3> read_level_mesh(const fs::path&, const Hierarchy&, int);
template Level<2> read_level(const fs::path&, const Hierarchy&, int);
template Level<3> read_level(const fs::path&, const Hierarchy&, int);

} // namespace ameco
