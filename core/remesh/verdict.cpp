// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/verdict.h"

namespace ameco {

std::string_view name(Verdict verdict) {
    static constexpr std::array<std::string_view, verdict_count> names{
        "accepted",       "geometry class",   "gap",           "line order",       "weak coupling",
        "coupling bound", "inverts element",  "low quality",   "no improvement",   "link condition",
        "surface normal", "surface distance", "breaks line",   "cavity too large", "region border",
        "short edge",     "long edge",        "stiff element", "soft element"};
    return names[static_cast<std::size_t>(verdict)];
}

} // namespace ameco
