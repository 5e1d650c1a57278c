// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The order of sets of qualities (paper, section 4.2).
#pragma once

#include <span>

namespace ameco {

/// Whether the set of qualities `a` is worse than `b`: its worst one is lower; where they tie, both
/// leave their sets and the next ones are compared. A set that is used up first is the better one:
/// it has the same elements, and fewer.
///
/// A strict weak order of sets, and one that stays when the same elements are added to both: where
/// a part of a mesh gets better, the mesh does.
/// \param a, b  ascending
[[nodiscard]] bool is_worse(std::span<const float> a, std::span<const float> b);

} // namespace ameco
