// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The table of all file formats: how each is called, recognised, read and written, and what of a
/// mesh it keeps. `read_mesh` and `write_mesh`, `ameco formats` and docs/user/formats.md all work
/// from it.
#pragma once

#include "core/io/file_bytes.h"
#include "core/io/io.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ameco {

/// A file to be read.
struct Source {
    std::filesystem::path path; ///< for what stands beside the file
    std::string name;           ///< of the file, for messages
    std::string_view bytes;     ///< the content, unpacked
    ReadOptions options;
    const FileBytes* file = nullptr; ///< where `bytes` lie, if they were not made in memory
};

/// What a format can hold, as a sum.
enum Keeps : unsigned {
    keeps_2d = 1u << 0,       ///< meshes in the plane
    keeps_3d = 1u << 1,       ///< meshes with volume
    keeps_surfaces = 1u << 2, ///< surfaces without volume
    keeps_patches = 1u << 3,  ///< numbers of patches
    keeps_names = 1u << 4,    ///< names of patches
    keeps_regions = 1u << 5,
    keeps_curves = 1u << 6,   ///< edges of the boundary, with labels (3-D)
    keeps_features = 1u << 7, ///< corners, ridges, what is required
    keeps_labels = 1u << 8,   ///< labels of nodes
};

/// How tables call what is kept.
struct KeepsColumn {
    Keeps what;
    std::string_view heading;
};
inline constexpr std::array<KeepsColumn, 9> keeps_columns{{{keeps_2d, "2-D"},
                                                           {keeps_3d, "3-D"},
                                                           {keeps_surfaces, "surface"},
                                                           {keeps_patches, "patches"},
                                                           {keeps_names, "names"},
                                                           {keeps_regions, "regions"},
                                                           {keeps_curves, "curves"},
                                                           {keeps_features, "features"},
                                                           {keeps_labels, "node labels"}}};

struct Format {
    std::string_view name;  ///< as `ameco convert --to` takes it
    std::string_view title; ///< for people
    /// Ends of file names, in lower case, the usual one first.
    std::vector<std::string_view> suffixes;
    unsigned keeps; ///< sum of Keeps
    std::string_view remark;

    /// Whether the content shows that it is of this format; null if no content can.
    bool (*recognises)(std::string_view bytes) = nullptr;
    /// Null if the format is not read. \throws InputError
    MeshFile (*read)(const Source& source) = nullptr;
    TensorFile (*read_tensors)(const Source& source) = nullptr;
    /// Null if not written. \return one line per thing that had to be changed. \throws FileError
    std::vector<std::string> (*write_2d)(const std::filesystem::path& path, const Mesh<2>& mesh,
                                         const WriteOptions& options) = nullptr;
    std::vector<std::string> (*write_3d)(const std::filesystem::path& path, const Mesh<3>& mesh,
                                         const WriteOptions& options) = nullptr;
    void (*write_tensors_2d)(const std::filesystem::path& path,
                             const IdVector<NodeId, Tensor<2>>& tensors,
                             const WriteOptions& options) = nullptr;
    void (*write_tensors_3d)(const std::filesystem::path& path,
                             const IdVector<NodeId, Tensor<3>>& tensors,
                             const WriteOptions& options) = nullptr;

    [[nodiscard]] bool reads() const { return read != nullptr || read_tensors != nullptr; }
    [[nodiscard]] bool writes() const { return write_3d != nullptr || write_tensors_3d != nullptr; }
    [[nodiscard]] bool is_metric() const {
        return read_tensors != nullptr || write_tensors_3d != nullptr;
    }
};

/// All formats of this build, in the order of the manual.
[[nodiscard]] const std::vector<Format>& formats();

/// The format with the longest suffix that ends the path (".gz" not counted); null if there is
/// none.
/// \param metric  look among the formats for metrics, or among those for meshes
[[nodiscard]] const Format* format_of_suffix(const std::filesystem::path& path, bool metric);

/// The format with a name; null if there is none.
[[nodiscard]] const Format* format_of_name(std::string_view name);

/// The format to write in: the one asked for, or that of the suffix.
/// \throws UsageError  there is none, or it is only read
/// \throws Error       (not_built) it is left out of this build
[[nodiscard]] const Format& format_to_write(const std::filesystem::path& path,
                                            const WriteOptions& options, bool metric);

/// ".mesh, .meshb, ...": what can be read, or written.
[[nodiscard]] std::string suffix_list(bool metric, bool to_write);

/// What `mesh` has and the format cannot hold, as one line; nothing if there is nothing.
template <int D>
[[nodiscard]] std::vector<std::string> losses(const Format& format, const Mesh<D>& mesh);

} // namespace ameco
