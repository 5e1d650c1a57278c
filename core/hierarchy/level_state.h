// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What a level has beside its mesh and metric, kept in a file so that a hierarchy can be resumed
/// with the same result as if it had never stopped.
#pragma once

#include "core/coarsen/coarsen.h"

#include <filesystem>
#include <string>

namespace ameco {

/// Geometry classes and parents of a level as CBOR (RFC 8949): a map with "schema_version",
/// "dimension", and byte strings, little-endian: "node_class" (uint8, [n]), "ridges" with "nodes"
/// (int32, [r][2]), "label" (int32, [r]) and "flags" (uint8, [r]: 1 listed, 2 declared),
/// "face_deviation" (float64, [k]), "parent" (int32, [n]).
template <int D>
[[nodiscard]] std::string level_state_bytes(const Level<D>& level);

/// Fills `level.geometry` and `level.parent`; `level.mesh` is there already and must fit.
/// \param file  for messages
/// \throws InputError when the bytes are damaged or of another mesh
template <int D>
void parse_level_state(const std::string& bytes, const std::filesystem::path& file,
                       Level<D>& level);

} // namespace ameco
