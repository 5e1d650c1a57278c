// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/quality_order.h"

#include <algorithm>

namespace ameco {

bool is_worse(std::span<const float> a, std::span<const float> b) {
    const auto [i, j] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (i == a.end()) {
        return false;
    }
    return j == b.end() || *i < *j;
}

} // namespace ameco
