// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A metric that is known everywhere in a domain, for nodes that are put somewhere new.
#pragma once

#include "core/mesh/locate.h"
#include "core/metric/metric_sum.h"

#include <array>
#include <memory>
#include <mutex>
#include <span>

namespace ameco {

template <int D>
class MetricSource {
public:
    virtual ~MetricSource() = default;

    /// The metric at a point.
    /// \param near  a node of the background mesh that lies near `p`, if there is such a mesh;
    ///              replaced by one that lies nearer
    [[nodiscard]] virtual Metric<D> at(const Vec<D>& p, NodeId& near) const = 0;
};

/// Means by which a metric can be interpolated: they can be weighted.
inline constexpr std::array interpolating_means{Mean::corrected, Mean::blended, Mean::interpolation,
                                                Mean::log_euclidean};

/// The metric of one size [L] in all directions, at each of `nodes` nodes.
template <int D>
[[nodiscard]] MetricField<D> isotropic_metric(std::size_t nodes, double size) {
    Metric<D> metric;
    metric.sizes.setConstant(size);
    return MetricField<D>(nodes, metric);
}

/// A metric given at the nodes of a mesh: mean of the nodes of the element that holds the point,
/// weighted by its barycentric coordinates. Beyond the boundary the
/// nearest boundary face takes the element's place. Reading it from several threads is safe.
///
/// Refers to the mesh, which must outlive it and stay as it is.
template <int D>
class BackgroundMetric : public MetricSource<D> {
public:
    /// \param mesh   valid
    /// \param field  one valid metric per node of `mesh`
    /// \param mean   one of `interpolating_means`. The corrected mean (9)-(10) is exact where sizes
    ///               grow linearly with the distance from a wall, as they do in boundary layers;
    ///               the log-Euclidean one makes them small over most of a large element.
    BackgroundMetric(const Mesh<D>& mesh, const MetricField<D>& field, Mean mean = Mean::corrected);
    ~BackgroundMetric() override;

    [[nodiscard]] Metric<D> at(const Vec<D>& p, NodeId& near) const override;

private:
    struct Search;
    [[nodiscard]] const Search& search() const;
    [[nodiscard]] Metric<D> interpolate(std::span<const NodeId> nodes,
                                        std::span<const double> weights) const;

    const Mesh<D>& mesh_;
    Locator<D> locator_;
    Mean mean_;
    IdVector<NodeId, Contribution<D>> terms_; ///< what each node adds
    mutable std::once_flag search_made_;
    mutable std::unique_ptr<Search> search_; ///< made when a walk first finds nothing
};

} // namespace ameco
