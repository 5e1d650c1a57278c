// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/complexity.h"

#include "core/base/parallel.h"
#include "core/metric/element_metric.h"

#include <numeric>
#include <vector>

#include <Eigen/LU>

namespace ameco {

template <int D>
double complexity(const Mesh<D>& mesh, const MetricField<D>& field) {
    constexpr std::size_t piece_size = 8192;
    constexpr double volume_share = 1.0 / (D == 2 ? 2 : 6) / (D + 1);
    const std::size_t m = mesh.elements.size();
    std::vector<double> pieces((m + piece_size - 1) / piece_size, 0.0);
    parallel_for(m, piece_size, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t e = begin; e < end; ++e) {
            const Simplex<D>& s = mesh.elements[ElementId(e)];
            Mat<D> edges;
            double densities = density<D>(field[s[0]]);
            for (int i = 0; i < D; ++i) {
                edges.col(i) = mesh.points[s[i + 1]] - mesh.points[s[0]];
                densities += density<D>(field[s[i + 1]]);
            }
            sum += volume_share * edges.determinant() * densities;
        }
        pieces[begin / piece_size] = sum;
    });
    return std::accumulate(pieces.begin(), pieces.end(), 0.0);
}

template <int D>
double predicted_elements(double complexity) {
    return complexity / regular_simplex_volume<D>;
}

template double complexity<2>(const Mesh<2>&, const MetricField<2>&);
template double complexity<3>(const Mesh<3>&, const MetricField<3>&);
template double predicted_elements<2>(double);
template double predicted_elements<3>(double);

} // namespace ameco
