// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/coarse_operator.h"

#include <algorithm>
#include <cmath>

namespace ameco {

std::string_view name(CoarseOperator kind) {
    switch (kind) {
    case CoarseOperator::rediscretised:
        return "rediscretised";
    case CoarseOperator::galerkin:
        return "galerkin";
    case CoarseOperator::stiffened:
        return "stiffened";
    case CoarseOperator::local_galerkin:
        return "local-galerkin";
    }
    return "";
}

SparseMatrix galerkin_product(const SparseMatrix& A, const SparseMatrix& P) {
    const SparseMatrix AP = A * P;
    return SparseMatrix(P.transpose()) * AP;
}

SparseMatrix stiffened(const SparseMatrix& coarse_A, const Vector& ratios) {
    const auto factor = [&](Eigen::Index i) { return std::max(1.0, ratios[i]); };
    SparseMatrix out = coarse_A;
    for (Eigen::Index i = 0; i < out.rows(); ++i) {
        double added = 0;
        double* diagonal = nullptr;
        for (SparseMatrix::InnerIterator it(out, i); it; ++it) {
            if (it.col() == i) {
                diagonal = &it.valueRef();
            } else if (it.value() < 0) {
                const double more =
                    (std::sqrt(factor(i) * factor(it.col())) - 1) * std::abs(it.value());
                it.valueRef() -= more;
                added += more;
            }
        }
        *diagonal += added;
    }
    return out;
}

} // namespace ameco
