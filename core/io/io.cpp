// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/io.h"

#include "core/io/file_bytes.h"
#include "core/io/gmf.h"

#include <algorithm>

namespace ameco {
namespace {

/// The suffix in lower case, e.g. ".meshb".
std::string suffix_of(const std::filesystem::path& path) {
    std::string suffix = path.extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return suffix;
}

gmf::Form form_of(const std::filesystem::path& path, const char* text, const char* binary) {
    const std::string suffix = suffix_of(path);
    if (suffix == text) {
        return gmf::Form::text;
    }
    if (suffix == binary) {
        return gmf::Form::binary;
    }
    throw UsageError(path.string() + ": files of the kind '" + suffix +
                     "' cannot be written; choose a name that ends in " + text + " or " + binary);
}

[[noreturn]] void fail_unknown(const std::filesystem::path& path, std::string_view bytes,
                               const char* text, const char* binary) {
    throw InputError(path.string() +
                     (bytes.empty() ? ": is empty; " : ": is of no known format; ") +
                     "files that can be read here are Medit " + text + " and " + binary);
}

template <class File>
File with_compression(std::optional<File> file, const FileBytes& bytes) {
    if (bytes.was_compressed()) {
        file->format += ", gz-compressed";
    }
    return std::move(*file);
}

} // namespace

MeshFile read_mesh(const std::filesystem::path& path) {
    const FileBytes bytes(path);
    std::optional<MeshFile> file = gmf::read_mesh(bytes.view(), path.string());
    if (!file) {
        fail_unknown(path, bytes.view(), ".mesh", ".meshb");
    }
    return with_compression(std::move(file), bytes);
}

TensorFile read_tensors(const std::filesystem::path& path) {
    const FileBytes bytes(path);
    std::optional<TensorFile> file = gmf::read_tensors(bytes.view(), path.string());
    if (!file) {
        fail_unknown(path, bytes.view(), ".sol", ".solb");
    }
    return with_compression(std::move(file), bytes);
}

template <int D>
std::vector<std::string> write_mesh(const std::filesystem::path& path, const Mesh<D>& mesh,
                                    const WriteOptions& options) {
    return gmf::write_mesh(path, form_of(path, ".mesh", ".meshb"), mesh, options);
}

template <int D>
void write_tensors(const std::filesystem::path& path, const IdVector<NodeId, Tensor<D>>& tensors,
                   const WriteOptions& options) {
    gmf::write_tensors<D>(path, form_of(path, ".sol", ".solb"), tensors, options);
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
