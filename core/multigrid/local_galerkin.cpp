// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/local_galerkin.h"

#include "core/multigrid/coarse_operator.h"

#include <algorithm>

namespace ameco {
namespace {

/// Whether any node of an element is in a set.
template <int D>
bool touches(const Simplex<D>& element, const std::vector<bool>& set) {
    return std::any_of(element.begin(), element.end(),
                       [&](NodeId node) { return set[node.index()]; });
}

/// The elements of a mesh that touch a set of nodes, or those that do not; all its nodes.
template <int D>
Mesh<D> part_of(const Mesh<D>& mesh, const std::vector<bool>& set, bool touching) {
    Mesh<D> part;
    part.points = mesh.points;
    for (const Simplex<D>& element : mesh.elements) {
        if (touches<D>(element, set) == touching) {
            part.elements.push_back(element);
        }
    }
    return part;
}

} // namespace

template <int D>
SparseMatrix local_galerkin(const Mesh<D>& fine, const Mesh<D>& coarse, const SparseMatrix& P,
                            const Vector& ratios, const ModelProblem<D>& problem, double limit) {
    std::vector<bool> soft(coarse.points.size());
    for (std::size_t i = 0; i < soft.size(); ++i) {
        soft[i] = ratios[static_cast<Eigen::Index>(i)] > limit;
    }
    std::vector<bool> above(fine.points.size());
    for (Eigen::Index v = 0; v < P.rows(); ++v) {
        for (SparseMatrix::InnerIterator it(P, v); it; ++it) {
            if (soft[static_cast<std::size_t>(it.col())]) {
                above[static_cast<std::size_t>(v)] = true;
            }
        }
    }
    return assemble(part_of(coarse, soft, false), problem) +
           galerkin_product(assemble(part_of(fine, above, true), problem), P);
}

template SparseMatrix local_galerkin(const Mesh<2>&, const Mesh<2>&, const SparseMatrix&,
                                     const Vector&, const ModelProblem<2>&, double);
template SparseMatrix local_galerkin(const Mesh<3>&, const Mesh<3>&, const SparseMatrix&,
                                     const Vector&, const ModelProblem<3>&, double);

} // namespace ameco
