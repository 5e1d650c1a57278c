// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How stiff a few elements make their nodes, to compare what a swap takes with what it brings.
#pragma once

#include "core/mesh/barycentric.h"
#include "core/metric/element_measures.h"
#include "core/remesh/edit_mesh.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ameco {

/// What an element adds to the Laplacian's a_vv at each of its corners [L^(D-2)].
template <int D>
[[nodiscard]] std::array<double, D + 1> stiffness(const EditMesh<D>& mesh, const Simplex<D>& s) {
    constexpr double factorial = D == 2 ? 2 : 6;
    const auto x = corners_of(mesh, s);
    const auto n = scaled_gradients(x);
    const double determinant = factorial * edge_determinant(x);
    std::array<double, D + 1> out;
    std::transform(n.begin(), n.end(), out.begin(),
                   [&](const auto& gradient) { return gradient.squaredNorm() / determinant; });
    return out;
}

/// What elements add to a_vv, summed at each of their nodes.
template <int D>
class StiffnessDiagonal {
public:
    struct Part {
        NodeId node;
        double sum;
    };

    void clear() { parts_.clear(); }

    void add(const EditMesh<D>& mesh, const Simplex<D>& s) {
        const auto added = stiffness(mesh, s);
        for (std::size_t i = 0; i < s.size(); ++i) {
            at(s[i]) += added[i];
        }
    }

    [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

    /// 0 for nodes of none of the elements.
    [[nodiscard]] double operator[](NodeId v) const {
        const auto known = std::find_if(parts_.begin(), parts_.end(),
                                        [&](const Part& part) { return part.node == v; });
        return known != parts_.end() ? known->sum : 0;
    }

private:
    double& at(NodeId v) {
        const auto known = std::find_if(parts_.begin(), parts_.end(),
                                        [&](const Part& part) { return part.node == v; });
        return known != parts_.end() ? known->sum : parts_.emplace_back(Part{v, 0}).sum;
    }

    std::vector<Part> parts_; ///< few
};

} // namespace ameco
