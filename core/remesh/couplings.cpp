// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/couplings.h"

#include "core/base/parallel.h"
#include "core/mesh/barycentric.h"
#include "core/mesh/simplex.h"
#include "core/metric/element_measures.h"

#include <algorithm>

namespace ameco {
namespace {

/// Adds what element `e` couples `v` to its other nodes.
template <int D>
void add_element(const Mesh<D>& mesh, ElementId e, NodeId v, std::span<const NodeId> neighbours,
                 std::vector<double>& sums) {
    const Simplex<D>& s = mesh.elements[e];
    const auto x = corners_of(mesh, s);
    const auto n = scaled_gradients(x);
    // grad(phi_i) = n_i / det, volume = det / D!.
    const double scale = (D == 2 ? 0.5 : 1.0 / 6.0) / edge_determinant(x);
    const auto self = static_cast<int>(std::find(s.begin(), s.end(), v) - s.begin());
    for (int j = 0; j <= D; ++j) {
        if (j != self) {
            const auto at = std::lower_bound(neighbours.begin(), neighbours.end(), s[j]);
            sums[static_cast<std::size_t>(at - neighbours.begin())] -= n[self].dot(n[j]) * scale;
        }
    }
}

} // namespace

float Couplings::between(NodeId v, NodeId w) const {
    const auto list = neighbours[v];
    const auto it = std::lower_bound(list.begin(), list.end(), w);
    return it != list.end() && *it == w ? at(v)[static_cast<std::size_t>(it - list.begin())] : 0.0f;
}

template <int D>
Couplings make_couplings(const Mesh<D>& mesh) {
    Couplings out;
    const NodeElements ball = node_elements(mesh);
    out.neighbours = node_neighbours(mesh, ball);
    measure_couplings(mesh, ball, out);
    return out;
}

template <int D>
void measure_couplings(const Mesh<D>& mesh, const NodeElements& ball, Couplings& out) {
    out.values.resize(out.neighbours.values.size());
    out.diagonal.assign(mesh.points.size(), 0);
    parallel_for(mesh.points.size(), 2048, [&](std::size_t begin, std::size_t end) {
        std::vector<double> sums;
        for (std::size_t i = begin; i < end; ++i) {
            const NodeId v(i);
            const auto neighbours = std::as_const(out.neighbours)[v];
            sums.assign(neighbours.size(), 0);
            for (const ElementId e : ball[v]) {
                add_element(mesh, e, v, neighbours, sums);
            }
            double total = 0;
            const auto row = static_cast<std::size_t>(out.neighbours.start[i]);
            for (std::size_t k = 0; k < sums.size(); ++k) {
                out.values[row + k] = static_cast<float>(sums[k]);
                total += sums[k];
            }
            out.diagonal[v] = static_cast<float>(total);
        }
    });
}

template Couplings make_couplings(const Mesh<2>&);
template Couplings make_couplings(const Mesh<3>&);
template void measure_couplings(const Mesh<2>&, const NodeElements&, Couplings&);
template void measure_couplings(const Mesh<3>&, const NodeElements&, Couplings&);

} // namespace ameco
