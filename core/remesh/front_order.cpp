// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/front_order.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include <Eigen/Geometry>

namespace ameco {
namespace {

Vec<2> normal(const Mesh<2>& mesh, const Facet<2>& f) {
    const Vec<2> t = mesh.points[f[1]] - mesh.points[f[0]];
    return {t[1], -t[0]};
}

Vec<3> normal(const Mesh<3>& mesh, const Facet<3>& f) {
    return (mesh.points[f[1]] - mesh.points[f[0]]).cross(mesh.points[f[2]] - mesh.points[f[0]]);
}

/// Cost of the edge with the metric of one end.
template <int D>
double cost(const Metric<D>& metric, const Vec<D>& e) {
    const Vec<D> along = (metric.directions.transpose() * e).cwiseQuotient(metric.sizes);
    return (along.cwiseQuotient(metric.sizes) * metric.sizes[0]).norm();
}

template <int D>
std::vector<NodeId> wall_nodes(const Mesh<D>& mesh, const MetricField<D>& natural,
                               const FrontOptions& options) {
    std::vector<std::uint8_t> mark(mesh.points.size(), 0); // 1 boundary, 2 wall
    for (const FaceId f : mesh.faces.ids()) {
        const Vec<D> n = normal(mesh, mesh.faces[f]);
        const double area = n.norm();
        for (const NodeId v : mesh.faces[f]) {
            const Metric<D>& m = natural[v];
            const bool wall = m.sizes[1] >= options.seed_anisotropy * m.sizes[0] &&
                              std::abs(n.dot(m.directions.col(0))) >= options.seed_cosine * area;
            mark[v.index()] = std::max<std::uint8_t>(mark[v.index()], wall ? 2 : 1);
        }
    }
    const bool any = std::find(mark.begin(), mark.end(), 2) != mark.end();
    std::vector<NodeId> seeds;
    for (const NodeId v : mesh.points.ids()) {
        if (mark[v.index()] >= (any ? 2 : 1)) {
            seeds.push_back(v);
        }
    }
    return seeds;
}

/// Of the edges of each node, in the order of its neighbours.
template <int D>
std::vector<double> edge_costs(const Mesh<D>& mesh, const MetricField<D>& natural,
                               const NodeNodes& neighbours) {
    std::vector<double> costs(neighbours.values.size());
    parallel_for(mesh.points.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const NodeId v(i);
            auto k = static_cast<std::size_t>(neighbours.start[i]);
            for (const NodeId w : neighbours[v]) {
                const Vec<D> e = mesh.points[w] - mesh.points[v];
                costs[k++] = std::min(cost(natural[v], e), cost(natural[w], e));
            }
        }
    });
    return costs;
}

} // namespace

template <int D>
FrontOrder front_order(const Mesh<D>& mesh, const MetricField<D>& natural,
                       const NodeNodes& neighbours, const FrontOptions& options) {
    const std::vector<double> costs = edge_costs(mesh, natural, neighbours);
    FrontOrder out;
    out.key.assign(mesh.points.size(), std::numeric_limits<double>::infinity());
    out.order.reserve(mesh.points.size());
    using Entry = std::pair<double, NodeId>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const NodeId v : wall_nodes(mesh, natural, options)) {
        out.key[v] = 0;
        queue.emplace(0.0, v);
    }
    while (!queue.empty()) {
        const auto [key, v] = queue.top();
        queue.pop();
        if (key > out.key[v]) {
            continue;
        }
        out.order.push_back(v);
        auto k = static_cast<std::size_t>(neighbours.start[v.index()]);
        for (const NodeId w : neighbours[v]) {
            const double reached = key + costs[k++];
            if (reached < out.key[w]) {
                out.key[w] = reached;
                queue.emplace(reached, w);
            }
        }
    }
    for (const NodeId v : mesh.points.ids()) {
        if (std::isinf(out.key[v])) {
            out.order.push_back(v);
        }
    }
    // Nodes leave the queue in this order, but for those that an edge of cost 0 reaches.
    const auto comes_first = [&](NodeId a, NodeId b) {
        return std::pair(out.key[a], a) < std::pair(out.key[b], b);
    };
    if (!std::is_sorted(out.order.begin(), out.order.end(), comes_first)) {
        std::sort(out.order.begin(), out.order.end(), comes_first);
    }
    return out;
}

template FrontOrder front_order(const Mesh<2>&, const MetricField<2>&, const NodeNodes&,
                                const FrontOptions&);
template FrontOrder front_order(const Mesh<3>&, const MetricField<3>&, const NodeNodes&,
                                const FrontOptions&);

} // namespace ameco
