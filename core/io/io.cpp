// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/io.h"

#include "core/io/file_bytes.h"
#include "core/io/format.h"

#include <algorithm>

namespace ameco {
namespace {

[[noreturn]] void fail_unknown(const Source& source, bool metric) {
    throw InputError(source.name +
                     (source.bytes.empty() ? ": is empty; " : ": is of no known format; ") +
                     (metric ? "metrics that can be read: " : "meshes that can be read: ") +
                     suffix_list(metric, false));
}

/// By content where that decides, then by suffix.
const Format& format_of(const Source& source, bool metric) {
    const Format* by_suffix = format_of_suffix(source.path, metric);
    const auto fits = [&](const Format& format) {
        return (metric ? format.read_tensors != nullptr : format.read != nullptr) &&
               format.recognises != nullptr && format.recognises(source.bytes);
    };
    if (by_suffix != nullptr && fits(*by_suffix)) {
        return *by_suffix;
    }
    const auto found = std::find_if(formats().begin(), formats().end(), fits);
    if (found != formats().end()) {
        return *found;
    }
    if (!metric && by_suffix != nullptr && !by_suffix->reads()) {
        throw Error(ExitCode::not_built, source.name + ": " + std::string(by_suffix->title) +
                                             " cannot be read: " + std::string(by_suffix->remark));
    }
    const bool decides = by_suffix != nullptr && by_suffix->recognises == nullptr &&
                         (metric ? by_suffix->read_tensors != nullptr : by_suffix->read != nullptr);
    if (!decides || source.bytes.empty()) {
        fail_unknown(source, metric);
    }
    return *by_suffix;
}

template <class File>
File with_compression(File file, const FileBytes& bytes) {
    if (bytes.was_compressed()) {
        file.format += ", gz-compressed";
    }
    return file;
}

} // namespace

MeshFile read_mesh(const std::filesystem::path& path, const ReadOptions& options) {
    const FileBytes bytes(path);
    Source source{path, path.string(), bytes.view(), options, &bytes};
    source.options.from_memory = source.options.from_memory || bytes.was_compressed();
    return with_compression(format_of(source, false).read(source), bytes);
}

TensorFile read_tensors(const std::filesystem::path& path) {
    const FileBytes bytes(path);
    const Source source{path, path.string(), bytes.view(), {}, &bytes};
    return with_compression(format_of(source, true).read_tensors(source), bytes);
}

template <int D>
std::vector<std::string> write_mesh(const std::filesystem::path& path, const Mesh<D>& mesh,
                                    const WriteOptions& options) {
    const Format& format = format_to_write(path, options, false);
    std::vector<std::string> notes = losses(format, mesh);
    std::vector<std::string> changes;
    if constexpr (D == 3) {
        changes = format.write_3d(path, mesh, options);
    } else {
        changes = format.write_2d(path, mesh, options);
    }
    notes.insert(notes.end(), changes.begin(), changes.end());
    return notes;
}

template <int D>
void write_tensors(const std::filesystem::path& path, const IdVector<NodeId, Tensor<D>>& tensors,
                   const WriteOptions& options) {
    const Format& format = format_to_write(path, options, true);
    if constexpr (D == 3) {
        format.write_tensors_3d(path, tensors, options);
    } else {
        format.write_tensors_2d(path, tensors, options);
    }
}

template std::vector<std::string> write_mesh<2>(const std::filesystem::path&, const Mesh<2>&,
                                                const WriteOptions&);
template std::vector<std::string> write_mesh<3>(const std::filesystem::path&, const Mesh<3>&,
                                                const WriteOptions&);
template void write_tensors<2>(const std::filesystem::path&, const IdVector<NodeId, Tensor<2>>&,
                               const WriteOptions&);
template void write_tensors<3>(const std::filesystem::path&, const IdVector<NodeId, Tensor<3>>&,
                               const WriteOptions&);

} // namespace ameco
