// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Meshes on their way to be unit in a metric, for the tests of the operators.
#pragma once

#include "core/adapt/edge_queue.h"
#include "core/adapt/unit_mesh.h"
#include "core/cases/cube.h"
#include "tests/core/remesh/remesh_support.h"

#include <memory>

namespace ameco::adapt_test {

/// The same metric everywhere.
template <int D>
class UniformMetric : public MetricSource<D> {
public:
    explicit UniformMetric(const Metric<D>& metric) : metric_(metric) {}
    explicit UniformMetric(double h) : metric_{Vec<D>::Constant(h), Mat<D>::Identity()} {}
    [[nodiscard]] Metric<D> at(const Vec<D>& /*p*/, NodeId& /*near*/) const override {
        return metric_;
    }

private:
    Metric<D> metric_;
};

/// Sizes that grow linearly with the last coordinate, stretched across it.
template <int D>
class LayerMetric : public MetricSource<D> {
public:
    LayerMetric(double first, double growth, double far)
        : first_(first), growth_(growth), far_(far) {}
    [[nodiscard]] Metric<D> at(const Vec<D>& p, NodeId& /*near*/) const override {
        Metric<D> m;
        m.sizes.setConstant(far_);
        m.sizes[0] = std::min(first_ + growth_ * p[D - 1], far_);
        m.directions.setZero();
        m.directions(D - 1, 0) = 1;
        for (int k = 1; k < D; ++k) {
            m.directions(k - 1, k) = 1;
        }
        return m;
    }

private:
    double first_, growth_, far_;
};

/// A displaced unit cube or square of n cells a side, under edit.
template <int D>
struct Bench {
    Mesh<D> mesh;
    std::shared_ptr<const MetricSource<D>> source;
    UnitMesh<D> unit;

    template <class Source>
    Bench(int n, const Source& metric, int seed = 1, Quality quality = Quality::shape)
        : mesh(make_cube<D>({.n = n, .displace = 0.2, .seed = seed})),
          source(std::make_shared<Source>(metric)),
          unit(mesh, classify_geometry(mesh), *source,
               IdVector<NodeId, NodeId>(mesh.points.size(), NodeId(0)), quality) {}

    /// What is wrong with the mesh as it stands, or changed of its extent; empty if nothing.
    [[nodiscard]] std::string complaint() const {
        const Mesh<D> now = unit.edit.compact().mesh;
        const CheckReport report = check(now);
        if (!report.valid()) {
            return report.summary();
        }
        const double moved = difference(remesh_test::extent(now), remesh_test::extent(mesh));
        if (!(moved < 1e-12)) {
            return "patches or regions changed by " + std::to_string(moved);
        }
        for (std::size_t i = 0; i < unit.edit.slot_count(); ++i) {
            const ElementId e(i);
            if (!unit.edit.is_free(e) && !unit.edit.is_ghost(e) &&
                unit.edit.element(e).measure !=
                    static_cast<float>(unit.quality(unit.edit.nodes(e)))) {
                return "the quality kept of element " + std::to_string(i) + " is not its own";
            }
        }
        return {};
    }

    [[nodiscard]] std::size_t nodes() const { return unit.edit.compact().mesh.points.size(); }

    [[nodiscard]] double worst() const { return qualities().empty() ? 1 : qualities().front(); }

    /// Of all elements, ascending.
    [[nodiscard]] std::vector<float> qualities() const {
        std::vector<float> set;
        for (std::size_t i = 0; i < unit.edit.slot_count(); ++i) {
            const ElementId e(i);
            if (!unit.edit.is_free(e) && !unit.edit.is_ghost(e)) {
                set.push_back(unit.edit.element(e).measure);
            }
        }
        std::sort(set.begin(), set.end());
        return set;
    }
};

/// Sum over all edges; \see length_excess.
template <int D>
[[nodiscard]] double total_excess(const UnitMesh<D>& mesh) {
    double sum = 0;
    for (const LongEdge& edge : edges_by_length(mesh, 0, all_lengths)) {
        sum += length_excess(edge.length);
    }
    return sum;
}

/// What is wrong with a run of an operator that adds so many nodes with every operation it makes;
/// empty if nothing.
/// \param run  takes the mesh and the counts, returns the number of operations made
template <int D, class Run>
[[nodiscard]] std::string complaint_of_run(Bench<D>& bench, int nodes_each, const Run& run) {
    const auto before = static_cast<std::int64_t>(bench.nodes());
    VerdictCounts verdicts;
    const std::int64_t made = run(bench.unit, verdicts);
    const std::int64_t added = static_cast<std::int64_t>(bench.nodes()) - before;
    if (made <= 0 || verdicts[Verdict::accepted] != made || added != nodes_each * made) {
        return std::to_string(made) + " made, " + std::to_string(verdicts[Verdict::accepted]) +
               " counted, " + std::to_string(added) + " nodes added";
    }
    return bench.complaint();
}

/// The same, where every operation is to lower the sum of excesses.
template <int D, class Run>
[[nodiscard]] std::string complaint_of_excess(Bench<D>& bench, int nodes_each, const Run& run) {
    const double before = total_excess(bench.unit);
    std::int64_t made = 0;
    const std::string complaint =
        complaint_of_run(bench, nodes_each, [&](UnitMesh<D>& unit, VerdictCounts& verdicts) {
            return made = run(unit, verdicts);
        });
    const double fall = before - total_excess(bench.unit);
    return complaint.empty() && !(fall >= 0.99 * least_excess_fall * static_cast<double>(made))
               ? "the sum fell by " + std::to_string(fall) + " only"
               : complaint;
}

/// A mesh as it stands, with nothing known of what was tried on it.
template <int D>
struct Fresh {
    typename EditMesh<D>::Compact now;
    UnitMesh<D> unit;

    Fresh(const UnitMesh<D>& mesh, const MetricSource<D>& source, Quality quality = Quality::shape)
        : now(mesh.edit.compact()),
          unit(now.mesh, now.classes, source,
               IdVector<NodeId, NodeId>(now.mesh.points.size(), NodeId(0)), quality) {}
};

/// Whether all nodes of a mesh are at places of nodes of another.
[[nodiscard]] inline bool has_nodes_of(const Mesh<3>& mesh, const Mesh<3>& other) {
    std::set<std::array<double, 3>> places;
    for (const Vec<3>& p : other.points) {
        places.insert(remesh_test::key_of<3>(p));
    }
    return std::all_of(mesh.points.begin(), mesh.points.end(),
                       [&](const Vec<3>& p) { return places.contains(remesh_test::key_of<3>(p)); });
}

/// Rules of a boundary with plane sides: it may not move at all.
inline constexpr SurfaceRules plane_sides{
    .largest_turn_deg = 30, .relative_distance = 1e-9, .layer_share = 1e9};

} // namespace ameco::adapt_test
