// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// An outer boundary around a body.
#pragma once

#include "core/mesh/mesh.h"

#include <string_view>

namespace ameco {

enum class FarfieldShape { box, sphere };

struct Farfield {
    FarfieldShape shape = FarfieldShape::box;
    /// Distance from the middle of the body's box to the sides of the box, or to the sphere [L];
    /// 0: ten times the diagonal of the body's box.
    double radius = 0;
    int pieces = 8; ///< edges along a side of the box; a sphere has faces of about that size
};

/// Reads "box", "sphere", "box:20" or "sphere:20".
/// \throws UsageError
[[nodiscard]] Farfield farfield_from(std::string_view text);

/// A box (six patches, by axis and side) or a sphere (one patch) around `body`, normals outwards;
/// patches are numbered from `first_patch`, and named farfield, or farfield-x0 and so on.
/// \throws UsageError  it would not hold the body
[[nodiscard]] Mesh<3> make_farfield(const Farfield& farfield, const Mesh<3>& body, int first_patch);

} // namespace ameco
