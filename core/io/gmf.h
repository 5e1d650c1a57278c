// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The Gamma Mesh Format of Medit, GHS3D, Mmg and refine: .mesh .meshb .sol .solb, versions 1 to 4.
///
/// What of a mesh stands where:
///
///     Mesh<D>             3-D                      2-D
///     points, labels      Vertices                 Vertices
///     elements, region    Tetrahedra               Triangles
///     faces, patch        Triangles                Edges
///     features.edges      Edges                    -
///     required_faces      RequiredTriangles        -
///     required_elements   RequiredTetrahedra       RequiredTriangles
///     patch_names         ReferenceStrings (binary), comments (text)
///
/// and Corners, Ridges, RequiredVertices, RequiredEdges under their names. Numbers are 1-based in
/// the file. A symmetric tensor is m11 m12 m22 m13 m23 m33 in the file.
/// \see docs/user/formats.md; https://github.com/LoicMarechal/libMeshb
#pragma once

#include "core/io/file_bytes.h"
#include "core/io/io.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ameco::gmf {

enum class Form { text, binary };

/// Reads the content of a mesh file; nothing if it is not GMF at all.
/// \param name  of the file, for messages
/// \param file  where `bytes` lie, if they are mapped from a file; else null
/// \throws InputError
[[nodiscard]] std::optional<MeshFile> read_mesh(std::string_view bytes, const std::string& name,
                                                const ReadOptions& options = {},
                                                const FileBytes* file = nullptr);

/// Reads the content of a metric file, likewise.
[[nodiscard]] std::optional<TensorFile> read_tensors(std::string_view bytes,
                                                     const std::string& name);

/// \return one line per thing that could not be written
/// \throws FileError, UsageError
template <int D>
std::vector<std::string> write_mesh(const std::filesystem::path& path, Form form,
                                    const Mesh<D>& mesh, const WriteOptions& options);

template <int D>
void write_tensors(const std::filesystem::path& path, Form form,
                   const IdVector<NodeId, Tensor<D>>& tensors, const WriteOptions& options);

/// Place in the file of each of our tensor components xx xy xz yy yz zz (or xx xy yy): the file
/// goes down the columns of the upper triangle, we go along its rows.
template <int D>
inline constexpr std::array<int, tensor_size<D>> tensor_place{};
template <>
inline constexpr std::array<int, 3> tensor_place<2>{0, 1, 2};
template <>
inline constexpr std::array<int, 6> tensor_place<3>{0, 1, 3, 2, 4, 5};

} // namespace ameco::gmf
