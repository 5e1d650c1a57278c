// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A metric given on a surface, carried into the space around it.
#pragma once

#include "core/adapt/metric_source.h"
#include "core/mesh/box_tree.h"

namespace ameco {

/// The metric of the nearest point of a surface, all of its sizes larger by `growth` times the
/// distance to it: beside a wall that asks for layers, layers that grow geometrically.
///
/// Refers to the surface, which must outlive it and stay as it is.
class GrownMetric : public MetricSource<3> {
public:
    /// \param surface  faces, and no elements
    /// \param field    one valid metric per node of `surface`
    /// \param growth   size per distance [-], >= 0; layers grow by the factor 1 + growth
    GrownMetric(const Mesh<3>& surface, const MetricField<3>& field, double growth);

    [[nodiscard]] Metric<3> at(const Vec<3>& p, NodeId& near) const override;

private:
    const Mesh<3>& surface_;
    double growth_;
    BoxTree<3> faces_;
    IdVector<NodeId, Contribution<3>> terms_; ///< what each node adds to the mean
};

} // namespace ameco
