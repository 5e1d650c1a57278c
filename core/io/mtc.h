// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The formats of the mesh generator MTC, appendix A.1 of the paper, all text.
///
///     wing.mtc         { M: wing.t }   { Metrique: wing.metrique }, relative to this file
///     wing.t           nodes dimension elements nodes-per-element; coordinates; elements, from 1.
///                      A face of the boundary is an element whose last node is 0.
///     wing.metrique    nodes [dimension]; the matrix of each node by rows, or its upper triangle
///
/// The mesh has no place for patches. We write them, with their names, into a file of our own
/// beside it, wing.t.patches:
///
///     nodes elements faces; the patch of each face; comments with names
///
/// and read that if its counts agree. Without it, faces that meet at less than 40 degrees are of
/// one patch.
#pragma once

#include "core/io/format.h"

namespace ameco::mtc {

[[nodiscard]] bool recognises_meta(std::string_view bytes);
[[nodiscard]] MeshFile read_meta(const Source& source);
[[nodiscard]] MeshFile read(const Source& source);
/// Of the metric that a meta-file names.
[[nodiscard]] TensorFile read_meta_tensors(const Source& source);
[[nodiscard]] TensorFile read_tensors(const Source& source);

/// Writes the mesh beside it too, as `<stem>.t`.
template <int D>
std::vector<std::string> write_meta(const std::filesystem::path& path, const Mesh<D>& mesh,
                                    const WriteOptions& options);
template <int D>
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<D>& mesh,
                               const WriteOptions& options);
template <int D>
void write_tensors(const std::filesystem::path& path, const IdVector<NodeId, Tensor<D>>& tensors,
                   const WriteOptions& options);

} // namespace ameco::mtc
