// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/metric_quality.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

/// Q_F Q_S = V / h_M^D min(h_M^D, h_M^-D).
/// \param h2  h_M^2
template <int D>
double original_quality(double volume, double h2) {
    return std::max(0.0, h2 <= 1 ? volume : volume / (D == 2 ? h2 * h2 : h2 * h2 * h2));
}

template <int D>
double modified_quality(const ElementMeasures<D>& m) {
    double worst = 1;
    for (const double square : m.squares) {
        worst = std::min({worst, square, 1 / square});
    }
    const double sizes = D == 2 ? worst : worst * std::sqrt(worst);
    const double volume = std::min(m.volume, 1 / m.volume);
    return shape_quality(m) * sizes * std::max(0.0, volume);
}

} // namespace

std::string_view name(Quality quality) {
    switch (quality) {
    case Quality::shape:
        return "shape";
    case Quality::original:
        return "original";
    case Quality::modified:
        break;
    }
    return "modified";
}

std::optional<Quality> quality_from_name(std::string_view text) {
    for (const Quality quality : all_qualities) {
        if (name(quality) == text) {
            return quality;
        }
    }
    return {};
}

template <int D>
MetricQualities metric_qualities(const std::array<Vec<D>, D + 1>& x,
                                 const std::array<Metric<D>, D + 1>& natural) {
    Tensor<D> mean{};
    for (const Metric<D>& metric : natural) {
        const Tensor<D> root = root_of<D>(metric);
        for (int k = 0; k < tensor_size<D>; ++k) {
            mean[k] += root[k] / (D + 1);
        }
    }
    const ElementMeasures<D> m = element_measures<D>(x, invert(mean));
    return {original_quality<D>(m.volume, m.h2), modified_quality(m)};
}

template <int D>
double metric_quality(const EditMesh<D>& mesh, const RootField<D>& root, const Simplex<D>& element,
                      Quality quality) {
    const auto x = corners_of(mesh, element);
    if (edge_determinant(x) <= 0) {
        return 0;
    }
    const ElementMeasures<D> m = element_measures<D>(x, invert(mean_root<D>(root, element)));
    switch (quality) {
    case Quality::shape:
        return shape_quality(m);
    case Quality::original:
        return original_quality<D>(m.volume, m.h2);
    case Quality::modified:
        break;
    }
    return modified_quality(m);
}

template <int D>
double metric_quality_above(const EditMesh<D>& mesh, const RootField<D>& root,
                            const Simplex<D>& element, double least) {
    const auto x = corners_of(mesh, element);
    const double determinant = edge_determinant(x);
    if (determinant <= 0) {
        return 0;
    }
    // Of equal volume the regular simplex has the shortest edges: Q_F Q_S is at most the volume.
    const SymmetricInverse<D> inverse = invert(mean_root<D>(root, element));
    const double volume = determinant / (inverse.det * regular_determinant<D>());
    if (volume <= least) {
        return volume;
    }
    return original_quality<D>(volume, mean_square_length<D>(x, inverse));
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template MetricQualities metric_qualities(const std::array<Vec<D>, D + 1>&,                    \
                                              const std::array<Metric<D>, D + 1>&);                \
    template double metric_quality(const EditMesh<D>&, const RootField<D>&, const Simplex<D>&,     \
                                   Quality);                                                       \
    template double metric_quality_above(const EditMesh<D>&, const RootField<D>&,                  \
                                         const Simplex<D>&, double);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
