// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Small meshes and hierarchies to test with.
#pragma once

#include "core/base/error.h"
#include "core/cases/cases.h"
#include "core/hierarchy/build_hierarchy.h"
#include "core/hierarchy/hierarchy_folder.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace ameco::test {

/// A cube of 8 x 8 x 8 cells (729 nodes) or a square of 16 x 16 (289): a few coarser levels can be
/// made in milliseconds.
template <int D>
Mesh<D> small_mesh() {
    return std::get<Mesh<D>>(
        make_case("cube", {{"dim", std::to_string(D)}, {"n", D == 3 ? "8" : "16"}}));
}

/// Keeps what a sink receives.
template <int D>
struct Collected {
    std::vector<Level<D>> levels;
    std::vector<LevelStatistics> statistics;
    std::vector<LevelTiming> timings;

    LevelSink<D> sink() {
        return [this](const Level<D>& level, const LevelStatistics& s, const LevelTiming& t) {
            levels.push_back(level);
            statistics.push_back(s);
            timings.push_back(t);
        };
    }
};

/// Stops at the n-th question.
class StopAt : public Monitor {
public:
    explicit StopAt(int question) : question_(question) {}
    void message(Severity, std::string_view) override {}
    void progress(double, std::string_view) override {}
    [[nodiscard]] bool stop_requested() const override { return ++asked_ >= question_; }
    [[nodiscard]] int asked() const { return asked_; }

private:
    int question_;
    mutable int asked_ = 0;
};

inline std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Contents of all files in a folder, by name.
inline std::map<std::string, std::string> contents_of(const std::filesystem::path& folder) {
    std::map<std::string, std::string> contents;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        contents[entry.path().filename().string()] = content_of(entry.path());
    }
    return contents;
}

} // namespace ameco::test
