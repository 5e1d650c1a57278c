// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A hierarchy on disk: a folder with hierarchy.json and the files it lists.
///
///     hierarchy.json    settings, files, hashes, statistics: the same bytes for the same input
///     timing.json       seconds and memory: differs from run to run
///     level_k.meshb     mesh of level k (k >= 1; level 0 is the input, or its copy level_0.*)
///     metric_k.solb     natural metric of level k
///     state_k.cbor      what the next coarsening needs besides (level_state.h)
///     level_k.su2 ...   the mesh in another format too, where that was asked for; level 0 as well,
///                       unless the input is in that format
///     P_k.mtx, P_k.petsc, parent_k.txt, projected_k.txt
///                       if asked for: transfer between the levels k + 1 and k
///                       (multigrid/transfer_files.h)
#pragma once

#include "core/hierarchy/build_hierarchy.h"
#include "core/hierarchy/hierarchy.h"

#include <filesystem>

namespace ameco {

/// Writes a hierarchy level by level. At any time, also when the program is killed, every file
/// that hierarchy.json lists is there and whole.
class HierarchyFolder {
public:
    /// Starts a new hierarchy in `folder`, or continues one whose first levels are in `start`.
    /// Files of an older hierarchy that `start` does not list are removed.
    /// \param source  the file of level 0: copied into the folder if `start.input.copied`, else
    ///                referred to; of no matter when `start` has levels already
    /// \throws FileError
    HierarchyFolder(std::filesystem::path folder, const std::filesystem::path& source,
                    Hierarchy start, std::vector<LevelTiming> timings = {});

    /// Writes the files of a level, then lists them. Level 0's mesh is the input's file.
    /// \return  what the format of the exports cannot carry, one line each
    /// \throws FileError, and UsageError if that format cannot hold the mesh at all
    template <int D>
    std::vector<std::string> add_level(const Level<D>& level, const LevelStatistics& statistics,
                                       LevelTiming timing);

    /// Lists files that are in the folder already: those of the transfer between `level`, at least
    /// 1, and the next finer one.
    /// \param seconds  what they cost
    void add_transfer(int level, TransferFiles files, double seconds);

    /// Writes down how it ended.
    void finish(HierarchyStatus status);

    /// Takes back what was begun, where no coarser level came of it: the files of the hierarchy
    /// go, and the folder if it was made for them. To be called when an error ends the run.
    void take_back() noexcept;

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
    [[nodiscard]] const Hierarchy& hierarchy() const { return hierarchy_; }
    [[nodiscard]] const std::vector<LevelTiming>& timings() const { return timings_; }

private:
    void begin(const std::filesystem::path& source);
    void write_lists() const;
    template <int D>
    std::vector<std::string> write_export(const Mesh<D>& mesh, int level,
                                          HierarchyLevel& entry) const;

    std::filesystem::path folder_;
    bool made_folder_ = false;
    Hierarchy hierarchy_;
    std::vector<LevelTiming> timings_;
};

/// Reads hierarchy.json of a folder, or that file itself.
/// \throws FileError, InputError
[[nodiscard]] Hierarchy read_hierarchy(const std::filesystem::path& folder);

/// Reads timing.json of a folder; empty when there is none that can be read.
[[nodiscard]] std::vector<LevelTiming> read_timing(const std::filesystem::path& folder);

/// How many levels, from level 0 on, have all their files with the bytes that were written.
[[nodiscard]] int intact_levels(const std::filesystem::path& folder, const Hierarchy& hierarchy);

/// Whether all files of a transfer have the bytes that were written.
[[nodiscard]] bool is_intact(const std::filesystem::path& folder, const TransferFiles& files);

/// The name of a file in `folder`, with the hash of what it holds. \throws FileError
[[nodiscard]] HashedFile hashed(const std::filesystem::path& folder, const std::string& file);

/// Reads the mesh of a level; level 0 with its boundary completed, as it was coarsened.
/// \throws FileError, InputError
template <int D>
[[nodiscard]] Mesh<D> read_level_mesh(const std::filesystem::path& folder,
                                      const Hierarchy& hierarchy, int level);

/// Reads a level of 1 or more as it was when it was made, so that it can be coarsened further.
/// \throws FileError, InputError
template <int D>
[[nodiscard]] Level<D> read_level(const std::filesystem::path& folder, const Hierarchy& hierarchy,
                                  int level);

/// Whether `name` is a name this module gives to files of a hierarchy.
[[nodiscard]] bool is_hierarchy_file(const std::string& name);

} // namespace ameco
