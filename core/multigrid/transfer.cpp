// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/transfer.h"

#include "core/base/parallel.h"
#include "core/base/stop_check.h"
#include "core/mesh/barycentric.h"
#include "core/mesh/boundary_projection.h"
#include "core/mesh/locate.h"
#include "core/multigrid/random_vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace ameco {
namespace {

constexpr std::size_t nodes_per_piece = 4096;

/// Distance from the boundary, over the domain's diagonal, below which a node counts as on it: a
/// few roundings of a coordinate.
constexpr double on_boundary_tolerance = 1e-13;

/// Weights below this are roundings of nodes that lie on a side of their element.
constexpr double negligible_weight = 1e-12;

/// One row of P.
template <int D>
struct Row {
    std::array<NodeId, D + 1> nodes; ///< as many as are valid
    std::array<double, D + 1> weights{};
    TransferKind kind = TransferKind::nested;
    bool found = false;
    double distance = 0; ///< of a projected node [L]
};

/// Drops negligible weights and gives the rest a sum of 1.
template <int D>
void clean(Row<D>& row) {
    double sum = 0;
    for (std::size_t i = 0; i <= D; ++i) {
        if (row.weights[i] < negligible_weight) {
            row.nodes[i] = NodeId();
            row.weights[i] = 0;
        }
        sum += row.weights[i];
    }
    for (double& w : row.weights) {
        w /= sum;
    }
}

template <int D>
Row<D> row_in_element(const Mesh<D>& coarse, ElementId e, const Vec<D>& p) {
    Row<D> row;
    row.nodes = coarse.elements[e];
    row.weights = barycentric<D>(corners_of(coarse, coarse.elements[e]), p);
    row.kind = TransferKind::interpolated;
    row.found = true;
    clean(row);
    return row;
}

template <int D>
Row<D> row_on_boundary(const BoundaryPoint<D>& point, double tolerance) {
    Row<D> row;
    std::copy(point.nodes.begin(), point.nodes.end(), row.nodes.begin());
    std::copy(point.weights.begin(), point.weights.end(), row.weights.begin());
    row.kind = point.distance > tolerance ? TransferKind::projected : TransferKind::interpolated;
    row.distance = point.distance;
    row.found = true;
    clean(row);
    return row;
}

/// A coarse node near each fine one, from which to start walking: the coarse node itself, else the
/// nearest among the fine neighbours, else whatever the neighbours found.
template <int D>
IdVector<NodeId, NodeId> walk_starts(const Mesh<D>& fine,
                                     const IdVector<NodeId, NodeId>& coarse_of) {
    const NodeNodes neighbours = node_neighbours(fine);
    IdVector<NodeId, NodeId> starts = coarse_of;
    bool missing = true, found = true;
    while (missing && found) {
        missing = found = false;
        IdVector<NodeId, NodeId> next = starts;
        for (const NodeId v : fine.points.ids()) {
            if (starts[v].valid()) {
                continue;
            }
            double best = std::numeric_limits<double>::infinity();
            for (const NodeId w : neighbours[v]) {
                const double d = (fine.points[w] - fine.points[v]).squaredNorm();
                if (starts[w].valid() && d < best) {
                    best = d;
                    next[v] = starts[w];
                }
            }
            (next[v].valid() ? found : missing) = true;
        }
        starts = std::move(next);
    }
    for (NodeId& start : starts) {
        start = start.valid() ? start : NodeId(0);
    }
    return starts;
}

/// Finds the rows of P, piece by piece.
template <int D>
class RowFinder {
public:
    RowFinder(const Mesh<D>& fine, const Mesh<D>& coarse, const IdVector<NodeId, NodeId>& coarse_of)
        : fine_(fine), coarse_(coarse), coarse_of_(coarse_of), patches_(node_patches(fine)),
          locator_(coarse), boundary_(coarse), rows_(fine.points.size()) {
        Box<D> box;
        for (const Vec<D>& x : coarse.points) {
            box.extend(x);
        }
        tolerance_ = on_boundary_tolerance * box.diagonal().norm();
    }

    IdVector<NodeId, Row<D>> run() {
        const auto starts = walk_starts(fine_, coarse_of_);
        parallel_for(rows_.size(), nodes_per_piece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                rows_[NodeId(i)] = find(NodeId(i), starts[NodeId(i)]);
            }
        });
        search_the_rest();
        return std::move(rows_);
    }

private:
    [[nodiscard]] Row<D> find(NodeId v, NodeId start) const {
        if (coarse_of_[v].valid()) {
            Row<D> row;
            row.nodes[0] = coarse_of_[v];
            row.weights[0] = 1;
            row.found = true;
            return row;
        }
        const Vec<D>& p = fine_.points[v];
        if (!patches_[v].empty()) {
            return row_on_boundary(boundary_.project(p, patches_[v]), tolerance_);
        }
        const auto element = locator_.walk(p, start);
        return element ? row_in_element(coarse_, *element, p) : Row<D>();
    }

    /// Nodes whose walk ended at the boundary: around a corner of the domain, or outside.
    void search_the_rest() {
        std::vector<NodeId> rest;
        for (const NodeId v : rows_.ids()) {
            if (!rows_[v].found) {
                rest.push_back(v);
            }
        }
        if (rest.empty()) {
            return;
        }
        std::vector<Box<D>> boxes(coarse_.elements.size());
        for (const ElementId e : coarse_.elements.ids()) {
            for (const NodeId w : coarse_.elements[e]) {
                boxes[e.index()].extend(coarse_.points[w]);
            }
        }
        const BoxTree<D> tree(boxes);
        parallel_for(rest.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Vec<D>& p = fine_.points[rest[i]];
                const std::int32_t e = tree.find(
                    p, [&](std::int32_t item) { return locator_.contains(ElementId(item), p); });
                rows_[rest[i]] = e >= 0 ? row_in_element(coarse_, ElementId(e), p)
                                        : row_on_boundary(boundary_.project(p), 0.0);
            }
        });
    }

    const Mesh<D>& fine_;
    const Mesh<D>& coarse_;
    const IdVector<NodeId, NodeId>& coarse_of_;
    IdVector<NodeId, std::vector<int>> patches_;
    Locator<D> locator_;
    BoundaryProjection<D> boundary_;
    IdVector<NodeId, Row<D>> rows_;
    double tolerance_ = 0;
};

template <int D>
SparseMatrix assemble(const IdVector<NodeId, Row<D>>& rows, std::size_t columns) {
    SparseMatrix P(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
    P.reserve(Eigen::VectorXi::Constant(P.rows(), D + 1));
    for (const NodeId v : rows.ids()) {
        Row<D> row = rows[v];
        std::array<std::size_t, D + 1> order;
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return row.nodes[a] < row.nodes[b]; });
        for (const std::size_t i : order) {
            if (row.nodes[i].valid()) {
                P.insert(v.value(), row.nodes[i].value()) = row.weights[i];
            }
        }
    }
    P.makeCompressed();
    return P;
}

} // namespace

template <int D>
IdVector<NodeId, NodeId> match_nodes(const Mesh<D>& fine, const Mesh<D>& coarse) {
    const auto less = [](const Vec<D>& a, const Vec<D>& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::vector<NodeId> order;
    for (const NodeId v : fine.points.ids()) {
        order.push_back(v);
    }
    std::sort(order.begin(), order.end(),
              [&](NodeId a, NodeId b) { return less(fine.points[a], fine.points[b]); });
    IdVector<NodeId, NodeId> parent(coarse.points.size());
    for (const NodeId c : coarse.points.ids()) {
        const Vec<D>& x = coarse.points[c];
        const auto at =
            std::lower_bound(order.begin(), order.end(), x,
                             [&](NodeId v, const auto& y) { return less(fine.points[v], y); });
        if (at != order.end() && fine.points[*at] == x) {
            parent[c] = *at;
        }
    }
    return parent;
}

template <int D>
Transfer make_transfer(const Mesh<D>& fine, const Mesh<D>& coarse,
                       const IdVector<NodeId, NodeId>& parent, Monitor& monitor) {
    Transfer transfer;
    transfer.parent = parent.empty() ? match_nodes(fine, coarse) : parent;
    IdVector<NodeId, NodeId> coarse_of(fine.points.size());
    for (const NodeId c : transfer.parent.ids()) {
        NodeId& p = transfer.parent[c];
        if (p.valid() && fine.points[p] != coarse.points[c]) {
            p = NodeId(); // it was moved
        }
        if (p.valid()) {
            coarse_of[transfer.parent[c]] = c;
        }
    }
    monitor.progress(0.0, "locating nodes");
    const auto rows = RowFinder<D>(fine, coarse, coarse_of).run();
    stop_if_asked(monitor);
    transfer.kind.resize(rows.size());
    for (const NodeId v : rows.ids()) {
        transfer.kind[v] = rows[v].kind;
        if (rows[v].kind == TransferKind::projected) {
            transfer.largest_projection = std::max(transfer.largest_projection, rows[v].distance);
        }
    }
    transfer.P = assemble(rows, coarse.points.size());
    return transfer;
}

bool TransferCheck::passed() const {
    return failures().empty();
}

std::string TransferCheck::failures() const {
    std::string text;
    const auto demand = [&](bool holds, const std::string& what) {
        if (!holds) {
            text += (text.empty() ? "" : "; ") + what;
        }
    };
    demand(row_sum_error <= 1e-12,
           "rows do not sum to 1 (off by " + std::to_string(row_sum_error) + ")");
    demand(linear_error <= 1e-10,
           "linear functions are not reproduced (off by " + std::to_string(linear_error) + ")");
    demand(smallest_weight >= 0 && largest_weight <= 1, "weights leave [0, 1]");
    demand(empty_columns == 0,
           std::to_string(empty_columns) + " coarse nodes that no fine node refers to");
    demand(sum_error <= 1e-12, "the restriction does not keep sums");
    return text;
}

template <int D>
TransferCheck check(const Transfer& transfer, const Mesh<D>& fine, const Mesh<D>& coarse) {
    TransferCheck result;
    const SparseMatrix& P = transfer.P;
    Box<D> box;
    for (const Vec<D>& x : coarse.points) {
        box.extend(x);
    }
    std::vector<std::uint8_t> used(static_cast<std::size_t>(P.cols()), 0);
    for (const NodeId v : transfer.kind.ids()) {
        const TransferKind kind = transfer.kind[v];
        ++(kind == TransferKind::nested         ? result.nested
           : kind == TransferKind::interpolated ? result.interpolated
                                                : result.projected);
        double sum = 0;
        Vec<D> x = Vec<D>::Zero();
        for (SparseMatrix::InnerIterator it(P, v.value()); it; ++it) {
            used[static_cast<std::size_t>(it.col())] = 1;
            sum += it.value();
            // Relative to the fine node, so that only the interpolation's own error is seen.
            x += it.value() *
                 (coarse.points[NodeId(static_cast<std::size_t>(it.col()))] - fine.points[v]);
            result.smallest_weight = std::min(result.smallest_weight, it.value());
            result.largest_weight = std::max(result.largest_weight, it.value());
        }
        result.row_sum_error = std::max(result.row_sum_error, std::abs(sum - 1));
        if (kind != TransferKind::projected) {
            result.linear_error = std::max(result.linear_error, x.norm() / box.diagonal().norm());
        }
    }
    result.empty_columns = std::count(used.begin(), used.end(), 0);
    const Vector r = random_vector(P.rows());
    const Vector coarse_r = P.transpose() * r;
    result.sum_error = std::abs(coarse_r.sum() - r.sum()) / r.cwiseAbs().sum();
    result.largest_projection = transfer.largest_projection;
    return result;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template IdVector<NodeId, NodeId> match_nodes(const Mesh<D>&, const Mesh<D>&);                 \
    template Transfer make_transfer(const Mesh<D>&, const Mesh<D>&,                                \
                                    const IdVector<NodeId, NodeId>&, Monitor&);                    \
    template TransferCheck check(const Transfer&, const Mesh<D>&, const Mesh<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
