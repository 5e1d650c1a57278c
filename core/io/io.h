// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Files: recognise the format by its content, hand over to the format's own file.
#pragma once

#include "core/base/error.h"
#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace ameco {

/// A record of a file that means nothing to us; carried from file to file by `convert`.
struct OpaqueRecord {
    int keyword = 0;              ///< the format's code
    int version = 2;              ///< of the format it stood in, which decides the widths inside
    std::vector<std::byte> bytes; ///< payload as it stands in the file, little-endian
    friend bool operator==(const OpaqueRecord&, const OpaqueRecord&) = default;
};

/// What a mesh file holds.
struct MeshFile {
    std::variant<Mesh<3>, Mesh<2>> mesh;
    std::string format;                ///< e.g. "Medit binary, version 2"
    int format_version = 2;            ///< of the format, so that a conversion can keep it
    std::vector<OpaqueRecord> carried; ///< records copied through by `convert`
    std::vector<std::string> changes;  ///< one line each: what is not as it stands in the file
    std::vector<std::string> notes;    ///< one line each: what was unusual, skipped or assumed
};

struct MetricFile {
    std::variant<MetricField<3>, MetricField<2>> field;
    std::string format;
    int format_version = 2;
    std::vector<std::string> notes;
};

/// The tensors of a metric file as they stand there, not yet taken apart into sizes and
/// directions: what a conversion needs that keeps every bit.
struct TensorFile {
    std::variant<IdVector<NodeId, Tensor<3>>, IdVector<NodeId, Tensor<2>>> tensors; ///< [L^-2]
    std::string format;
    int format_version = 2;
    std::vector<std::string> notes;
};

struct ReadOptions {
    bool surfaces = false;    ///< accept a surface without elements, as a Mesh<3> of faces
    bool from_memory = false; ///< the content is not in a file of that name
};

/// Values at the nodes, to be written beside a mesh.
struct NodalField {
    std::string name;
    std::vector<double> values; ///< [n]
};

struct WriteOptions {
    std::string format = {}; ///< name of a format (format.h); empty: the suffix decides
    int version = 2;         ///< Medit binary, 1-4; raised when sizes or digits demand it
    const std::vector<OpaqueRecord>* carried = nullptr; ///< to be written too; may be null
    const TensorFile* tensors = nullptr; ///< metric at the nodes, for .vtu; may be null
    std::vector<NodalField> fields = {}; ///< values at the nodes, for .vtu
    std::filesystem::path metric = {};   ///< file that an MTC meta-file is to name as its metric
};

/// Reads a mesh as it stands in the file: nothing is turned, added or dropped (that is
/// mesh/boundary.h). Recognises the format by content, then by suffix.
/// \throws FileError   cannot be opened or read
/// \throws InputError  not a mesh of a known format, truncated, or its numbers make no sense (the
///                     text names file, place, entity and remedy)
[[nodiscard]] MeshFile read_mesh(const std::filesystem::path& path,
                                 const ReadOptions& options = {});

/// Writes in the format of the suffix, or in the one that is asked for (format.h has the table). A
/// file appears whole or not at all: it is written beside its final place and then renamed.
/// \return one line per thing that the format cannot carry, or that was changed to fit
/// \throws FileError   the folder is missing, not writable or full
/// \throws UsageError  unknown suffix, format or version, or a mesh that the format cannot hold
template <int D>
std::vector<std::string> write_mesh(const std::filesystem::path& path, const Mesh<D>& mesh,
                                    const WriteOptions& options = {});

/// Reads the tensors of a metric file (.sol, .solb): one symmetric tensor per vertex, its numbers
/// finite; whether it is positive definite is not asked.
/// \throws FileError, InputError
[[nodiscard]] TensorFile read_tensors(const std::filesystem::path& path);

/// Writes .sol (Medit text) or .solb (Medit binary), whole or not at all.
/// \throws FileError, UsageError
template <int D>
void write_tensors(const std::filesystem::path& path, const IdVector<NodeId, Tensor<D>>& tensors,
                   const WriteOptions& options = {});

/// Reads a metric field (.sol, .solb). Every tensor must be symmetric positive definite: the first
/// that is not is named.
/// \throws FileError, InputError
[[nodiscard]] MetricFile read_metric(const std::filesystem::path& path);

/// Writes a metric field in the format of the suffix, .sol or .solb, whole or not at all.
/// \throws FileError, UsageError
template <int D>
void write_metric(const std::filesystem::path& path, const MetricField<D>& field,
                  const WriteOptions& options = {});

} // namespace ameco
