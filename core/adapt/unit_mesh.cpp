// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/unit_mesh.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace ameco {

template <int D>
UnitMesh<D>::UnitMesh(const Mesh<D>& mesh, const GeometryClasses<D>& classes,
                      const MetricSource<D>& source, IdVector<NodeId, NodeId> near,
                      Quality quality_function)
    : edit(mesh, classes), source_(source), quality_(quality_function),
      factor_(mesh.points.size(), Mat<D>::Zero()), root_(mesh.points.size()),
      short_size_(mesh.points.size(), 0), near_(std::move(near)), changes_(mesh.points.size()),
      move_tried_(mesh.points.size(), 0), held_(mesh.points.size(), 0), first_place_(mesh.points) {
    parallel_for(mesh.points.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const NodeId v(i);
            set_metric(v, source_.at(edit.point(v), near_[v]));
        }
    });
    parallel_for(edit.slot_count(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const ElementId e(i);
            if (!edit.is_free(e) && !edit.is_ghost(e)) {
                edit.set_measure(e, static_cast<float>(quality(edit.nodes(e))));
            }
        }
    });
}

template <int D>
void UnitMesh<D>::set_metric(NodeId v, const Metric<D>& metric) {
    factor_[v] = length_factor(metric);
    root_[v] = root_of(metric);
    short_size_[v] = metric.sizes[0];
}

template <int D>
NodeId UnitMesh<D>::add_node(const Vec<D>& p, NodeId beside, NodeClass node_class,
                             bool on_boundary) {
    const NodeId v = edit.add_node(p, node_class, on_boundary);
    factor_.push_back(Mat<D>::Zero());
    root_.push_back({});
    short_size_.push_back(0);
    near_.push_back(near_[beside]);
    changes_.add_node();
    move_tried_.push_back(0);
    held_.push_back(0);
    first_place_.push_back(p);
    set_metric(v, source_.at(p, near_[v]));
    return v;
}

template <int D>
void UnitMesh<D>::drop_last_node() {
    edit.drop_last_node();
    const std::size_t n = edit.node_count();
    factor_.resize(n, Mat<D>::Zero());
    root_.resize(n);
    short_size_.resize(n);
    near_.resize(n);
    changes_.drop_last_node();
    move_tried_.resize(n);
    held_.resize(n);
    first_place_.resize(n, Vec<D>::Zero());
}

template <int D>
void UnitMesh<D>::move_node(NodeId v, const Vec<D>& p) {
    edit.move_node(v, p);
    set_metric(v, source_.at(p, near_[v]));
}

template <int D>
void UnitMesh<D>::restore(NodeId v, const NodeState& state) {
    edit.move_node(v, state.point);
    factor_[v] = state.factor;
    root_[v] = state.root;
    short_size_[v] = state.short_size;
    near_[v] = state.near;
}

template <int D>
Verdict UnitMesh<D>::judge(double least, Star<D>& star) const {
    star.worst_quality = 1;
    for (EditElement<D>& e : star.elements) {
        if (e.nodes[D] == edit.ghost()) {
            continue;
        }
        const double q = quality(e.nodes);
        e.measure = static_cast<float>(q);
        star.worst_quality = std::min(star.worst_quality, q);
        if (q <= least) {
            return Verdict::low_quality;
        }
    }
    return Verdict::accepted;
}

template <int D>
void UnitMesh<D>::replace(const Cavity<D>& cavity, const Star<D>& star) {
    (void)edit.replace(cavity.elements, star.elements, star.sources);
    for (const EditElement<D>& e : star.elements) {
        for (const NodeId v : e.nodes) {
            if (v != edit.ghost()) {
                touch(v);
            }
        }
    }
    tick();
}

template <int D>
void UnitMesh<D>::keep_moved(NodeId v, std::span<const double> qualities) {
    std::size_t k = 0;
    for (const ElementId e : edit.ball(v)) {
        if (!edit.is_ghost(e)) {
            edit.set_measure(e, static_cast<float>(qualities[k++]));
        }
        for (const NodeId w : edit.nodes(e)) {
            if (w != edit.ghost()) {
                touch(w);
            }
        }
    }
    tick();
}

template <int D>
void UnitMesh<D>::note_swap_tried(ElementId e) {
    if (swap_tried_.size() <= e.index()) {
        swap_tried_.resize(edit.slot_count(), 0);
    }
    swap_tried_[e.index()] = changes_.now();
}

template class UnitMesh<2>;
template class UnitMesh<3>;

} // namespace ameco
