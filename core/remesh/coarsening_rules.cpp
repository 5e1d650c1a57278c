// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/coarsening_rules.h"

namespace ameco {

template <int D>
bool is_lineless(const Lines& lines, const Simplex<D>& element) {
    for (const NodeId v : element) {
        if (!lines.on_line(v)) {
            return false;
        }
    }
    for (const auto& [i, j] : SimplexNumbering<D>::edges) {
        if (lines.linked(element[i], element[j])) {
            return false;
        }
    }
    return true;
}

template bool is_lineless<2>(const Lines&, const Simplex<2>&);
template bool is_lineless<3>(const Lines&, const Simplex<3>&);

} // namespace ameco
