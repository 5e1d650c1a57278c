// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/memory_estimate.h"

namespace ameco::cli {

double coarsening_memory(int dimension, std::int64_t nodes, std::int64_t elements) {
    const double per_node = dimension == 3 ? 400 : 250;
    const double per_element = dimension == 3 ? 100 : 80;
    return 20e6 + per_node * static_cast<double>(nodes) +
           per_element * static_cast<double>(elements);
}

} // namespace ameco::cli
