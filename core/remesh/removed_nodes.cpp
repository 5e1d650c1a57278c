// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/removed_nodes.h"

#include "core/geometry/volume.h"

#include <algorithm>
#include <limits>

namespace ameco {
namespace {

/// Weights below this are roundings of nodes that lie on a side of their element.
constexpr double negligible_weight = 1e-9;

/// Least conductance between two nodes, over a_vv: there is always a way over three couplings or
/// more, and a small weight of a far node does no harm.
constexpr double least_conductance = 0.02;

template <int D>
std::array<double, D + 1> weights_in(const EditMesh<D>& mesh, const Simplex<D>& s,
                                     const Vec<D>& p) {
    std::array<Vec<D>, D + 1> x;
    for (std::size_t i = 0; i <= D; ++i) {
        x[i] = mesh.point(s[i]);
    }
    std::array<double, D + 1> w;
    double sum = 0;
    for (std::size_t i = 0; i <= D; ++i) {
        const Vec<D> corner = std::exchange(x[i], p);
        w[i] = volume(x).value;
        x[i] = corner;
        sum += w[i];
    }
    for (double& value : w) {
        value /= sum;
    }
    return w;
}

} // namespace

template <int D>
RemovedNodes<D>::RemovedNodes(const Couplings& couplings, double bound)
    : couplings_(couplings), bound_(bound), next_(couplings.diagonal.size()),
      constant_(couplings.diagonal.size(), 0) {}

template <int D>
bool RemovedNodes<D>::interpolated_well(const EditMesh<D>& mesh, const Cavity<D>& cavity,
                                        const Star<D>& star, NodeId leaving) {
    places_.clear();
    const auto add = [&](NodeId v) {
        places_.push_back(locate(mesh, star, v));
        const double before = v == leaving ? 0 : static_cast<double>(constant_[v]);
        return static_cast<double>(places_.back().constant) <= std::max(bound_, before);
    };
    if (leaving.valid() && !add(leaving)) {
        return false;
    }
    for (const ElementId e : cavity.elements) {
        if (e.index() >= first_.size()) {
            continue;
        }
        for (NodeId v = first_[e]; v.valid(); v = next_[v]) {
            if (!add(v)) {
                return false;
            }
        }
    }
    return true;
}

template <int D>
void RemovedNodes<D>::move(std::span<const ElementId> old, std::span<const ElementId> slots) {
    for (const ElementId e : old) {
        if (e.index() < first_.size()) {
            first_[e] = NodeId();
        }
    }
    for (const Place& place : places_) {
        const ElementId e = slots[place.element];
        if (e.index() >= first_.size()) {
            first_.resize(std::max(e.index() + 1, first_.size() * 3 / 2));
        }
        next_[place.node] = first_[e];
        first_[e] = place.node;
        constant_[place.node] = place.constant;
    }
}

template <int D>
auto RemovedNodes<D>::locate(const EditMesh<D>& mesh, const Star<D>& star, NodeId v) const
    -> Place {
    // The element that holds the node, or, on a curved boundary, the one it is least outside of.
    double best = -std::numeric_limits<double>::infinity();
    std::size_t found = 0;
    std::array<double, D + 1> weights{};
    for (std::size_t k = 0; k < star.elements.size(); ++k) {
        const Simplex<D>& s = star.elements[k].nodes;
        if (s[D] == mesh.ghost()) {
            continue;
        }
        const auto w = weights_in(mesh, s, mesh.point(v));
        const double least = *std::min_element(w.begin(), w.end());
        if (least > best) {
            best = least;
            found = k;
            weights = w;
            if (least >= 0) {
                break;
            }
        }
    }
    return {v, found, static_cast<float>(constant(v, star.elements[found].nodes, weights))};
}

template <int D>
double RemovedNodes<D>::constant(NodeId v, const Simplex<D>& element,
                                 const std::array<double, D + 1>& weights) const {
    const auto neighbours = couplings_.neighbours[v];
    const auto values = couplings_.at(v);
    const double diagonal = static_cast<double>(couplings_.diagonal[v]);
    double sum = 0;
    for (std::size_t j = 0; j <= D; ++j) {
        if (weights[j] <= negligible_weight) {
            continue;
        }
        double conductance = 0;
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            const auto first = static_cast<double>(values[k]);
            if (neighbours[k] == element[j]) {
                conductance += std::max(first, 0.0);
            } else if (first > 0) {
                const auto second =
                    static_cast<double>(couplings_.between(neighbours[k], element[j]));
                conductance += second > 0 ? first * second / (first + second) : 0;
            }
        }
        sum += weights[j] / std::max(conductance, least_conductance * diagonal);
    }
    return diagonal * sum;
}

template class RemovedNodes<2>;
template class RemovedNodes<3>;

} // namespace ameco
