// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/error_mode.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>

namespace ameco {
namespace {

/// A number with `decimals` digits behind the point.
std::string text(double value, int decimals) {
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::fixed, decimals);
    return {buffer.data(), end.ptr};
}

template <int D>
std::string findings(const SlowNode<D>& node) {
    std::string all;
    const auto add = [&](bool wrong, const std::string& what) {
        if (wrong) {
            all += (all.empty() ? "" : "; ") + what;
        }
    };
    add(node.gap > 1, "gap: " + std::to_string(node.gap) + " nodes in a row left its line");
    add(node.projected, "projected: outside the coarse domain or off its boundary");
    add(!node.kept && node.removed_coupling > 0.9,
        text(node.removed_coupling, 2) + " of its coupling goes to removed nodes");
    add(!node.kept && node.interpolated_coupling < 0.3,
        "missing strong edge: only " + text(node.interpolated_coupling, 2) +
            " of its coupling goes to the nodes it is interpolated from");
    add(node.interpolation > 4, "badly interpolated: constant " + text(node.interpolation, 1) +
                                    " (1 in layers, about 2 elsewhere)");
    add(node.galerkin_ratio > 2, "bad coarse element: the coarse matrix is " +
                                     text(node.galerkin_ratio, 1) + " times too soft");
    return all.empty() ? "nothing conspicuous" : all;
}

template <int D>
SlowNode<D> examine(const Mesh<D>& fine, const LevelStructure& structure, const Transfer& transfer,
                    const IdVector<NodeId, NodeId>& kept, const IdVector<NodeId, double>& ratios,
                    NodeId v, double share) {
    SlowNode<D> out;
    out.node = v;
    out.point = fine.points[v];
    out.share = share;
    out.kept = kept[v].valid();
    out.on_line = structure.lines.on_line(v);
    out.gap = gap_at(structure.lines, kept, v);
    out.removed_coupling = removed_coupling(structure.couplings, kept, v);
    out.interpolated_coupling = interpolated_coupling(structure.couplings, transfer, v);
    out.interpolation = interpolation_constant(structure.couplings, transfer, v);
    out.largest_weight = 0;
    for (SparseMatrix::InnerIterator it(transfer.P, v.value()); it; ++it) {
        out.largest_weight = std::max(out.largest_weight, it.value());
        out.galerkin_ratio =
            std::max(out.galerkin_ratio, ratios[NodeId(static_cast<std::size_t>(it.col()))]);
    }
    out.projected = transfer.kind[v] == TransferKind::projected;
    out.findings = findings(out);
    return out;
}

} // namespace

template <int D>
ErrorMode<D> examine_error(const Mesh<D>& fine, const LevelStructure& structure,
                           const Transfer& transfer, const Vector& error, const Vector& diagonal,
                           const std::vector<NodeId>& unknowns,
                           const IdVector<NodeId, double>& ratios, int count) {
    ErrorMode<D> mode;
    mode.field.assign(fine.points.size(), 0.0);
    const Vector weight = diagonal.cwiseProduct(error.cwiseAbs2());
    const double total = weight.sum();
    const double largest = error.cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        mode.field[unknowns[i]] = error[static_cast<Eigen::Index>(i)] / largest;
    }
    std::vector<Eigen::Index> order(unknowns.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return weight[a] != weight[b] ? weight[a] > weight[b] : a < b;
    });
    const IdVector<NodeId, NodeId> kept = coarse_of(transfer);
    std::vector<NodeId> taken;
    double sum = 0;
    for (const Eigen::Index i : order) {
        if (sum < 0.9 * total) {
            ++mode.carriers;
            sum += weight[i];
        }
        const NodeId v = unknowns[static_cast<std::size_t>(i)];
        const bool beside = std::any_of(taken.begin(), taken.end(), [&](NodeId w) {
            return structure.couplings.between(v, w) != 0;
        });
        if (!beside && static_cast<int>(taken.size()) < count) {
            taken.push_back(v);
            mode.worst.push_back(
                examine(fine, structure, transfer, kept, ratios, v, weight[i] / total));
        }
        if (sum >= 0.9 * total && static_cast<int>(taken.size()) >= count) {
            break;
        }
    }
    return mode;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template ErrorMode<D> examine_error(const Mesh<D>&, const LevelStructure&, const Transfer&,    \
                                        const Vector&, const Vector&, const std::vector<NodeId>&,  \
                                        const IdVector<NodeId, double>&, int);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
