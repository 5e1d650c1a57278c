// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/size_quality.h"

#include "core/base/parallel.h"
#include "core/remesh/edit_mesh.h"

#include <cmath>

#include <Eigen/Geometry>

namespace ameco {
namespace {

/// Elementary symmetric polynomials e_1 ... e_D of the squared sizes of a simplex: for the regular
/// simplex of edge 1 they are those of D ones.
std::array<double, 2> invariants(const EditMesh<2>& mesh, const Simplex<2>& s) {
    const Vec<2> a = mesh.point(s[1]) - mesh.point(s[0]);
    const Vec<2> b = mesh.point(s[2]) - mesh.point(s[0]);
    const double det = a[0] * b[1] - a[1] * b[0];
    return {(a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm()) * 2 / 3, det * det * 4 / 3};
}

std::array<double, 3> invariants(const EditMesh<3>& mesh, const Simplex<3>& s) {
    const Vec<3> a = mesh.point(s[1]) - mesh.point(s[0]);
    const Vec<3> b = mesh.point(s[2]) - mesh.point(s[0]);
    const Vec<3> c = mesh.point(s[3]) - mesh.point(s[0]);
    const Vec<3> ab = a.cross(b), bc = b.cross(c), ca = c.cross(a);
    const double det = a.dot(bc);
    const double edges = a.squaredNorm() + b.squaredNorm() + c.squaredNorm() +
                         (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    const double faces =
        ab.squaredNorm() + bc.squaredNorm() + ca.squaredNorm() + (ab + bc + ca).squaredNorm();
    return {edges / 2, faces, 2 * det * det};
}

} // namespace

template <int D>
SizeField<D> make_size_field(const MetricField<D>& target) {
    SizeField<D> field(target.size());
    parallel_for(target.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vec<D> h = target[NodeId(i)].sizes;
            const Vec<D> h2 = h.cwiseAbs2();
            auto& r = field[NodeId(i)].r;
            r[0] = static_cast<float>(std::sqrt(h2.sum()));
            if constexpr (D == 2) {
                r[1] = static_cast<float>(h.prod() / std::sqrt(h2.sum()));
            } else {
                const double e2 = h2[0] * h2[1] + h2[0] * h2[2] + h2[1] * h2[2];
                r[1] = static_cast<float>(std::sqrt(e2 / h2.sum()));
                r[2] = static_cast<float>(h.prod() / std::sqrt(e2));
            }
        }
    });
    return field;
}

template <int D>
double size_quality(const EditMesh<D>& mesh, const SizeField<D>& sizes, const Simplex<D>& element) {
    const std::array<double, D> e = invariants(mesh, element);
    double product = 1;
    for (int k = 0; k < D; ++k) {
        double wanted = 0;
        for (const NodeId v : element) {
            wanted += static_cast<double>(sizes[v].r[static_cast<std::size_t>(k)]);
        }
        wanted /= D + 1;
        if (!(e[k] > 0)) {
            return 0; // flat, or all nodes on one line
        }
        const double ratio_squared = e[k] / (k == 0 ? 1.0 : e[k - 1]) / (wanted * wanted);
        product *= ratio_squared < 1 ? ratio_squared : 1 / ratio_squared;
    }
    return std::sqrt(product);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template SizeField<D> make_size_field(const MetricField<D>&);                                  \
    template double size_quality(const EditMesh<D>&, const SizeField<D>&, const Simplex<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
