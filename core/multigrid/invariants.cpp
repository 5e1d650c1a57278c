// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/invariants.h"

#include "core/mesh/boundary_projection.h"
#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco {
namespace {

constexpr double ff_bound = 0.9;
constexpr double largest_interpolation = 5;
constexpr double galerkin_bound = 2;

template <int D>
void raise(WorstPlace<D>& worst, double value, NodeId node, const Mesh<D>& mesh) {
    if (value > worst.value) {
        worst = {value, node, mesh.points[node]};
    }
}

template <int D>
void count_gaps(const Mesh<D>& fine, const Lines& lines, const IdVector<NodeId, NodeId>& coarse_of,
                PairInvariants<D>& out) {
    for (const NodeId start : fine.points.ids()) {
        if (lines.position[start] != 0) {
            continue;
        }
        int removed = 0, kept = 0;
        bool from_end = true; // no kept node yet
        for (NodeId v = start; v.valid(); v = lines.next[v]) {
            const bool is_kept = coarse_of[v].valid();
            removed = is_kept ? 0 : removed + 1;
            from_end = from_end && !is_kept;
            const bool to_end = !lines.next[v].valid();
            out.gaps_at_ends += (removed == 2 && from_end) || (removed > 1 && to_end && !from_end);
            kept = is_kept ? kept + 1 : 0;
            out.gaps += removed == 2 ? 1 : 0;
            out.stuck += kept == 3 ? 1 : 0;
            raise(out.longest_gap, removed, v, fine);
        }
    }
}

template <int D>
void count_lineless(const Mesh<D>& coarse, const Lines& lines, PairInvariants<D>& out) {
    for (const ElementId e : coarse.elements.ids()) {
        const Simplex<D>& s = coarse.elements[e];
        const bool all_on_lines =
            std::all_of(s.begin(), s.end(), [&](NodeId v) { return lines.on_line(v); });
        const auto& edges = SimplexNumbering<D>::edges;
        const bool has_line_edge = std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
            return lines.linked(s[static_cast<std::size_t>(edge[0])],
                                s[static_cast<std::size_t>(edge[1])]);
        });
        if (all_on_lines && !has_line_edge) {
            ++out.lineless_elements;
            raise(out.lineless, 1, s[0], coarse);
        }
    }
    out.lineless_share =
        static_cast<double>(out.lineless_elements) / static_cast<double>(coarse.elements.size());
}

} // namespace

template <int D>
LevelStructure level_structure(const Mesh<D>& mesh, const LineOptions& options) {
    LevelStructure structure;
    structure.couplings = make_couplings(mesh);
    // Which end a line is numbered from does not matter here.
    const IdVector<NodeId, double> key(mesh.points.size(), 0.0);
    structure.lines = find_lines(mesh, structure.couplings, key, options);
    return structure;
}

double interpolated_coupling(const Couplings& couplings, const Transfer& transfer, NodeId v) {
    if (transfer.kind[v] == TransferKind::nested) {
        return 1;
    }
    double sum = 0;
    for (SparseMatrix::InnerIterator it(transfer.P, v.value()); it; ++it) {
        const NodeId w = transfer.parent[NodeId(static_cast<std::size_t>(it.col()))];
        sum += w.valid() ? couplings.between(v, w) : 0;
    }
    return sum / couplings.diagonal[v];
}

double interpolation_constant(const Couplings& couplings, const Transfer& transfer, NodeId v) {
    if (transfer.kind[v] == TransferKind::nested) {
        return 0;
    }
    std::vector<NodeId> nodes;
    std::vector<double> weights;
    for (SparseMatrix::InnerIterator it(transfer.P, v.value()); it; ++it) {
        nodes.push_back(transfer.parent[NodeId(static_cast<std::size_t>(it.col()))]);
        if (!nodes.back().valid()) {
            return 0;
        }
        weights.push_back(it.value());
    }
    return interpolation_constant(couplings, v, nodes, weights);
}

double removed_coupling(const Couplings& couplings, const IdVector<NodeId, NodeId>& coarse_of,
                        NodeId v) {
    double sum = 0;
    const auto neighbours = couplings.neighbours[v];
    const auto values = couplings.at(v);
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
        sum += coarse_of[neighbours[i]].valid() ? 0 : values[i];
    }
    return sum / couplings.diagonal[v];
}

IdVector<NodeId, NodeId> coarse_of(const Transfer& transfer) {
    IdVector<NodeId, NodeId> result(transfer.kind.size());
    for (const NodeId c : transfer.parent.ids()) {
        if (transfer.parent[c].valid()) {
            result[transfer.parent[c]] = c;
        }
    }
    return result;
}

int gap_at(const Lines& lines, const IdVector<NodeId, NodeId>& coarse_of, NodeId v) {
    if (!lines.on_line(v) || coarse_of[v].valid()) {
        return 0;
    }
    int removed = 1;
    for (NodeId w = lines.next[v]; w.valid() && !coarse_of[w].valid(); w = lines.next[w]) {
        ++removed;
    }
    for (NodeId w = lines.previous[v]; w.valid() && !coarse_of[w].valid(); w = lines.previous[w]) {
        ++removed;
    }
    return removed;
}

Vector galerkin_ratios(const SparseMatrix& A, const SparseMatrix& P, const SparseMatrix& coarse_A) {
    const SparseMatrix AP = A * P;
    Vector diagonal = Vector::Zero(P.cols());
    for (Eigen::Index i = 0; i < P.rows(); ++i) {
        SparseMatrix::InnerIterator p(P, i);
        for (SparseMatrix::InnerIterator q(AP, i); q && p; ++q) {
            if (q.col() == p.col()) {
                diagonal[q.col()] += p.value() * q.value();
                ++p;
            }
        }
    }
    return diagonal.cwiseQuotient(Vector(coarse_A.diagonal()));
}

template <int D>
PairInvariants<D> pair_invariants(const Mesh<D>& fine, const LevelStructure& fine_structure,
                                  const Mesh<D>& coarse, const LevelStructure& coarse_structure,
                                  const Transfer& transfer, const Vector& ratios,
                                  const std::vector<NodeId>& unknowns) {
    PairInvariants<D> out;
    const IdVector<NodeId, NodeId> kept = coarse_of(transfer);
    out.line_nodes = fine_structure.lines.node_count;
    out.coarse_line_nodes = coarse_structure.lines.node_count;
    count_gaps(fine, fine_structure.lines, kept, out);
    count_lineless(coarse, coarse_structure.lines, out);
    const auto patches = node_patches(fine);
    for (const NodeId v : fine.points.ids()) {
        if (!kept[v].valid() && patches[v].empty()) {
            const double K = interpolation_constant(fine_structure.couplings, transfer, v);
            out.interpolation_exceeded += K > largest_interpolation ? 1 : 0;
            raise(out.interpolation, K, v, fine);
        }
        if (!kept[v].valid()) {
            const double ff = removed_coupling(fine_structure.couplings, kept, v);
            out.ff_exceeded += ff > ff_bound ? 1 : 0;
            raise(out.ff, ff, v, fine);
        }
    }
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const double ratio = ratios[static_cast<Eigen::Index>(i)];
        out.galerkin_exceeded += ratio > galerkin_bound ? 1 : 0;
        raise(out.galerkin_ratio, ratio, unknowns[i], coarse);
    }
    return out;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template LevelStructure level_structure(const Mesh<D>&, const LineOptions&);                   \
    template PairInvariants<D> pair_invariants(                                                    \
        const Mesh<D>&, const LevelStructure&, const Mesh<D>&, const LevelStructure&,              \
        const Transfer&, const Vector&, const std::vector<NodeId>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
