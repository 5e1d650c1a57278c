// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How well a mesh agrees with a metric: lengths of its edges, quality of its elements.
#pragma once

#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

#include <array>
#include <cstdint>

namespace ameco {

struct Conformity {
    std::int64_t edges = 0;
    double in_band = 0;    ///< share of edges with length in [1/sqrt(2), sqrt(2)], in [0, 1]
    double below_half = 0; ///< share shorter than 0.5
    double above_two = 0;  ///< share longer than 2
    double shortest = 0, longest = 0;
    double mean_quality = 0,
           worst_quality = 0; ///< mean ratio of the elements in the metric, in [0, 1]
};

/// Measures all edges and elements of `mesh` in `field` (one metric per node of `mesh`). The length
/// of an edge is the logarithmic mean of its lengths in the metrics of its ends; the shape quality
/// of an element is (17), with the mean of its nodes' M^-1/2.
template <int D>
[[nodiscard]] Conformity conformity(const Mesh<D>& mesh, const MetricField<D>& field);

/// Shape quality (17) of one element in the mean of its nodes' M^-1/2, in [0, 1].
template <int D>
[[nodiscard]] double shape_quality(const Mesh<D>& mesh, const MetricField<D>& field,
                                   const Simplex<D>& element);

/// Elements by quality and edges by length, in classes of equal width, for histograms.
struct ConformityClasses {
    static constexpr int quality_classes = 20; ///< class k holds qualities in [k, k + 1) / 20
    static constexpr int length_classes = 24;  ///< class k: log2 of lengths in [k - 12, k - 11) / 4
    std::array<std::int64_t, quality_classes> quality{}; ///< the last one holds 1, too
    std::array<std::int64_t, length_classes> length{};   ///< the ends hold what is beyond them
};

/// The same edges and elements as `conformity`, counted.
template <int D>
[[nodiscard]] ConformityClasses classify_conformity(const Mesh<D>& mesh,
                                                    const MetricField<D>& field);

} // namespace ameco
