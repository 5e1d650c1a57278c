// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/removed_nodes.h"

#include "core/mesh/barycentric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace ameco {
namespace {

/// Weights below this are roundings of nodes that lie on a side of their element.
constexpr double negligible_weight = 1e-9;

/// Least conductance between two nodes, over a_vv.
constexpr double least_conductance = 0.02;

/// Most conductance between nodes at a distance d, over a_vv: this times (h_1 / d)^2.
constexpr double most_conductance = 2;

} // namespace

double interpolation_constant(const Couplings& couplings, NodeId v, std::span<const NodeId> nodes,
                              std::span<const double> weights, std::span<const double> most) {
    const auto neighbours = couplings.neighbours[v];
    const auto values = couplings.at(v);
    const auto diagonal = static_cast<double>(couplings.diagonal[v]);
    double sum = 0;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        if (weights[j] <= negligible_weight) {
            continue;
        }
        // Paths of two edges meet at common neighbours; both lists ascend.
        const auto others = couplings.neighbours[nodes[j]];
        const auto other_values = couplings.at(nodes[j]);
        double conductance = 0;
        std::size_t m = 0;
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            const auto first = static_cast<double>(values[k]);
            if (neighbours[k] == nodes[j]) {
                conductance += std::max(first, 0.0);
                continue;
            }
            while (m < others.size() && others[m] < neighbours[k]) {
                ++m;
            }
            if (first > 0 && m < others.size() && others[m] == neighbours[k]) {
                const auto second = static_cast<double>(other_values[m]);
                conductance += second > 0 ? first * second / (first + second) : 0;
            }
        }
        if (!most.empty()) {
            conductance = std::min(conductance, most[j] * diagonal);
        }
        sum += weights[j] * weights[j] / std::max(conductance, least_conductance * diagonal);
    }
    return diagonal * sum;
}

template <int D>
IdVector<NodeId, float> coarsened_directions(const MetricField<D>& natural,
                                             const MetricField<D>& target) {
    IdVector<NodeId, float> directions(natural.size());
    for (const NodeId v : natural.ids()) {
        const Vec<D> growth = target[v].sizes.cwiseQuotient(natural[v].sizes);
        directions[v] = static_cast<float>(std::log2(growth.prod()));
    }
    return directions;
}

template <int D>
double interpolation_bound(float directions, const InterpolationBound& bound) {
    const double further = std::max(static_cast<double>(directions) - 1, 0.0);
    const double t = isotropy<D>(directions);
    return bound.layer + bound.per_direction * further + bound.isotropic * t * t;
}

template <int D>
IdVector<NodeId, float> interpolation_bounds(const Couplings& couplings,
                                             const IdVector<NodeId, float>& directions,
                                             const InterpolationBound& bound) {
    constexpr float strong = 0.4f; // of a_vv
    IdVector<NodeId, float> bounds(directions.size());
    for (const NodeId v : directions.ids()) {
        const auto values = couplings.at(v);
        const float strongest =
            values.empty() ? 0 : *std::max_element(values.begin(), values.end());
        const bool held = strongest > strong * couplings.diagonal[v];
        bounds[v] = static_cast<float>(interpolation_bound<D>(directions[v], bound) -
                                       (held ? bound.held : 0));
    }
    return bounds;
}

template <int D>
RemovedNodes<D>::RemovedNodes(const Couplings& couplings, IdVector<NodeId, float> bounds,
                              IdVector<NodeId, float> short_size)
    : couplings_(couplings), bounds_(std::move(bounds)), short_size_(std::move(short_size)),
      next_(couplings.diagonal.size()), constant_(couplings.diagonal.size(), 0) {}

template <int D>
bool RemovedNodes<D>::interpolated_well(const EditMesh<D>& mesh, const Cavity<D>& cavity,
                                        const Star<D>& star, Leaving leaving, std::size_t lane) {
    std::vector<Place>& places = places_[lane].of;
    places.clear();
    const auto add = [&](NodeId v) {
        places.push_back(locate(mesh, star, v));
        const float more = v == leaving.node ? static_cast<float>(leaving.most) : constant_[v];
        const float most = std::max(bounds_[v], more);
        return places.back().constant <= most;
    };
    if (leaving.node.valid() && !mesh.on_boundary(leaving.node) && !add(leaving.node)) {
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
void RemovedNodes<D>::open_lanes(std::size_t count, std::size_t slots) {
    places_.resize(std::max(places_.size(), count));
    first_.resize(std::max(first_.size(), slots));
}

template <int D>
void RemovedNodes<D>::move(std::span<const ElementId> old, std::span<const ElementId> slots,
                           std::size_t lane) {
    for (const ElementId e : old) {
        if (e.index() < first_.size()) {
            first_[e] = NodeId();
        }
    }
    for (const Place& place : places_[lane].of) {
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
    // The element that holds the node, or, above a curved boundary, the one it is least outside of.
    double best = -std::numeric_limits<double>::infinity();
    std::size_t found = 0;
    std::array<double, D + 1> weights{};
    for (std::size_t k = 0; k < star.elements.size(); ++k) {
        const Simplex<D>& s = star.elements[k].nodes;
        if (s[D] == mesh.ghost()) {
            continue;
        }
        const auto w = barycentric<D>(corners_of(mesh, s), mesh.point(v));
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
    const Simplex<D>& nodes = star.elements[found].nodes;
    std::array<double, D + 1> most;
    std::transform(nodes.begin(), nodes.end(), most.begin(),
                   [&](NodeId w) { return conductance_limit(mesh, v, w); });
    return {v, found,
            static_cast<float>(interpolation_constant(couplings_, v, nodes, weights, most))};
}

template <int D>
double RemovedNodes<D>::conductance_limit(const EditMesh<D>& mesh, NodeId v, NodeId w) const {
    if (short_size_.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    const auto h = static_cast<double>(short_size_[v]);
    return most_conductance * h * h / (mesh.point(w) - mesh.point(v)).squaredNorm();
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template IdVector<NodeId, float> coarsened_directions(const MetricField<D>&,                   \
                                                          const MetricField<D>&);                  \
    template double interpolation_bound<D>(float, const InterpolationBound&);                      \
    template IdVector<NodeId, float> interpolation_bounds<D>(                                      \
        const Couplings&, const IdVector<NodeId, float>&, const InterpolationBound&);              \
    template class RemovedNodes<D>;

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
