// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/edit_mesh.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cassert>

namespace ameco {
namespace {

template <int D>
bool has_node(const Simplex<D>& s, NodeId v) {
    return std::find(s.begin(), s.end(), v) != s.end();
}

} // namespace

template <int D>
EditMesh<D>::EditMesh(const Mesh<D>& mesh, const GeometryClasses<D>& classes)
    : points_(mesh.points), labels_(mesh.labels), class_(classes.node),
      on_boundary_(mesh.points.size(), 0), patch_names_(mesh.patch_names),
      frozen_patches_(classes.frozen_patches), original_(classes.original),
      features_(mesh.features) {
    open_lanes(1);
    elements_.reserve(mesh.elements.size() + mesh.faces.size());
    for (const ElementId e : mesh.elements.ids()) {
        elements_.push_back({mesh.elements[e], mesh.region[e], 0});
    }
    for (const RidgeEdge& r : classes.ridges) {
        ridges_.emplace(r.nodes, r);
    }
    // In two dimensions faces are edges, and files call them so.
    for (const int f : D == 2 ? features_.required_edges : features_.required_faces) {
        required_faces_.push_back(sorted(mesh.faces[FaceId(f)]));
    }
    std::sort(required_faces_.begin(), required_faces_.end());
    for (const int f : D == 2 ? features_.ridges : std::vector<int>{}) {
        ridge_faces_.push_back(sorted(mesh.faces[FaceId(f)]));
    }
    if constexpr (D == 2) {
        required_edges_ = required_faces_;
        required_edges_.insert(required_edges_.end(), ridge_faces_.begin(), ridge_faces_.end());
    } else {
        for (const int e : features_.required_edges) {
            required_edges_.push_back(sorted(features_.edges[static_cast<std::size_t>(e)]));
        }
    }
    std::sort(required_edges_.begin(), required_edges_.end());
    for (const FaceId f : mesh.faces.ids()) {
        elements_.push_back({ghost_simplex<D>(mesh.faces[f], ghost_), mesh.patch[f],
                             static_cast<float>(classes.deviation[f])});
    }
    fill_balls();
    // Faces inside the domain have an element on both sides: they are no ghost elements.
    for (const FaceId f : mesh.faces.ids()) {
        const ElementId e(mesh.elements.size() + f.index());
        const Facet<D>& face = mesh.faces[f];
        const auto at = ball(face[0]);
        const auto sides = std::count_if(at.begin(), at.end(), [&](ElementId other) {
            return !is_ghost(other) && std::all_of(face.begin(), face.end(), [&](NodeId v) {
                return has_node<D>(elements_[other].nodes, v);
            });
        });
        if (sides != 1) {
            interior_.emplace_back(face, mesh.patch[f]);
            put(e, EditElement<D>{}, lanes_.front());
            lanes_.front().free.push_back(e);
            continue;
        }
        for (const NodeId v : face) {
            on_boundary_[v] = 1;
        }
    }
}

template <int D>
void EditMesh<D>::fill_balls() {
    ball_.assign(points_.size(), Ball{});
    for (const EditElement<D>& e : elements_) {
        for (const NodeId v : e.nodes) {
            if (v != ghost_) {
                ++ball_[v].capacity;
            }
        }
    }
    std::int64_t total = 0;
    for (Ball& b : ball_) {
        // Room for the elements that a first collapse onto the node brings.
        b.capacity += b.capacity / 4 + 2;
        total += b.capacity;
    }
    pool_.resize(static_cast<std::size_t>(total));
    ElementId* start = pool_.data();
    for (Ball& b : ball_) {
        b.start = start;
        start += b.capacity;
    }
    for (const ElementId e : elements_.ids()) {
        for (const NodeId v : elements_[e].nodes) {
            if (v != ghost_) {
                add_to_ball(v, e, lanes_.front());
            }
        }
    }
}

template <int D>
void EditMesh<D>::neighbours(NodeId v, std::vector<NodeId>& out) const {
    // Each is met about six times: among few it is quicker to look for it than to sort them all.
    constexpr std::size_t few = 64;
    out.clear();
    const bool look = ball(v).size() <= few;
    for (const ElementId e : ball(v)) {
        for (const NodeId w : elements_[e].nodes) {
            if (w != v && w != ghost_ &&
                !(look && std::find(out.begin(), out.end(), w) != out.end())) {
                out.push_back(w);
            }
        }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
}

template <int D>
void EditMesh<D>::add_to_ball(NodeId v, ElementId e, Lane& lane) {
    Ball& b = ball_[v];
    if (b.size == b.capacity) {
        b.capacity += b.capacity / 2 + 4;
        std::pmr::polymorphic_allocator<ElementId> memory(lane.memory.get());
        ElementId* start = memory.allocate(static_cast<std::size_t>(b.capacity));
        std::uninitialized_copy_n(b.start, b.size, start);
        b.start = start;
    }
    b.start[b.size] = e;
    ++b.size;
}

template <int D>
void EditMesh<D>::remove_from_ball(NodeId v, ElementId e) {
    Ball& b = ball_[v];
    ElementId* const end = b.start + b.size;
    ElementId* const it = std::find(b.start, end, e);
    assert(it != end);
    --b.size;
    *it = *(end - 1);
}

template <int D>
void EditMesh<D>::put(ElementId slot, const EditElement<D>& fresh, Lane& lane) {
    const Simplex<D> before = elements_[slot].nodes;
    elements_[slot] = fresh;
    for (const NodeId v : before) {
        if (v.valid() && v != ghost_ && !has_node<D>(fresh.nodes, v)) {
            remove_from_ball(v, slot);
        }
    }
    for (const NodeId v : fresh.nodes) {
        if (v.valid() && v != ghost_ && !has_node<D>(before, v)) {
            add_to_ball(v, slot, lane);
        }
    }
}

template <int D>
void EditMesh<D>::open_lanes(std::size_t count) {
    all_free_.clear();
    for (Lane& lane : lanes_) {
        all_free_.insert(all_free_.end(), lane.free.begin(), lane.free.end());
        lane.free.clear();
    }
    while (lanes_.size() < count) {
        lanes_.emplace_back().memory = std::make_unique<std::pmr::monotonic_buffer_resource>();
    }
    open_lanes_ = count;
    const auto share = [&](std::size_t i) {
        return all_free_.begin() + static_cast<std::ptrdiff_t>(all_free_.size() * i / count);
    };
    parallel_for(count, 1, [&](std::size_t i, std::size_t next) {
        lanes_[i].free.assign(share(i), share(next));
    });
}

template <int D>
ElementId EditMesh<D>::free_slot(Lane& lane) {
    if (!lane.free.empty()) {
        const ElementId e = lane.free.back();
        lane.free.pop_back();
        return e;
    }
    assert(open_lanes_ == 1);
    elements_.push_back({});
    return ElementId(elements_.size() - 1);
}

template <int D>
std::span<const ElementId>
EditMesh<D>::replace(std::span<const ElementId> old, std::span<const EditElement<D>> fresh,
                     std::span<const ElementId> sources, std::size_t lane_index) {
    // Elements that stay in their slot first, then the rest into what is left over.
    Lane& lane = lanes_[lane_index];
    std::size_t next = 0;
    std::vector<ElementId>& left_over = lane.left_over;
    std::vector<ElementId>& slots = lane.filled;
    left_over.clear();
    slots.resize(fresh.size());
    for (const ElementId slot : old) {
        if (next < fresh.size() && sources[next] == slot) {
            put(slot, fresh[next], lane);
            slots[next] = slot;
            while (next < fresh.size() && sources[next] == slot) {
                ++next;
            }
        } else {
            left_over.push_back(slot);
        }
    }
    assert(next == fresh.size());
    std::size_t used = 0;
    for (std::size_t i = 1; i < fresh.size(); ++i) {
        if (sources[i] == sources[i - 1]) {
            slots[i] = used < left_over.size() ? left_over[used++] : free_slot(lane);
            put(slots[i], fresh[i], lane);
        }
    }
    for (; used < left_over.size(); ++used) {
        put(left_over[used], EditElement<D>{}, lane);
        lane.free.push_back(left_over[used]);
    }
    return slots;
}

template <int D>
bool EditMesh<D>::is_required(const Facet<D>& face) const {
    return std::binary_search(required_faces_.begin(), required_faces_.end(), sorted(face));
}

template <int D>
bool EditMesh<D>::is_frozen(ElementId ghost_element) const {
    const EditElement<D>& e = elements_[ghost_element];
    return std::find(frozen_patches_.begin(), frozen_patches_.end(), e.label) !=
               frozen_patches_.end() ||
           is_required(ghost_face<D>(e.nodes));
}

template <int D>
bool EditMesh<D>::is_required(NodeId a, NodeId b) const {
    return std::binary_search(required_edges_.begin(), required_edges_.end(), sorted(Edge{a, b}));
}

template <int D>
void EditMesh<D>::merge_ridges(NodeId removed, NodeId kept) {
    std::vector<RidgeEdge> moved;
    for (const ElementId e : ball(removed)) {
        for (const NodeId v : elements_[e].nodes) {
            const auto it = v == ghost_ || v == removed ? ridges_.end()
                                                        : ridges_.find(sorted(Edge{removed, v}));
            if (it != ridges_.end()) {
                moved.push_back(it->second);
                ridges_.erase(it);
            }
        }
    }
    for (RidgeEdge r : moved) {
        const NodeId other = r.nodes[0] == removed ? r.nodes[1] : r.nodes[0];
        if (other != kept) {
            r.nodes = sorted(Edge{kept, other});
            ridges_.emplace(r.nodes, r);
        }
    }
}

template <int D>
void EditMesh<D>::split_ridge(NodeId a, NodeId b, NodeId m) {
    const auto it = ridges_.find(sorted(Edge{a, b}));
    if (it == ridges_.end()) {
        return;
    }
    RidgeEdge half = it->second;
    ridges_.erase(it);
    for (const NodeId end : {a, b}) {
        half.nodes = sorted(Edge{end, m});
        ridges_.emplace(half.nodes, half);
    }
}

template <int D>
NodeId EditMesh<D>::add_node(const Vec<D>& p, NodeClass node_class, bool on_boundary) {
    const NodeId v = points_.next_id();
    points_.push_back(p);
    if (!labels_.empty()) {
        labels_.push_back(0);
    }
    class_.push_back(node_class);
    on_boundary_.push_back(on_boundary ? 1 : 0);
    ball_.push_back({});
    return v;
}

template <int D>
void EditMesh<D>::drop_last_node() {
    assert(ball_[NodeId(points_.size() - 1)].size == 0);
    points_.pop_back();
    if (!labels_.empty()) {
        labels_.pop_back();
    }
    class_.pop_back();
    on_boundary_.pop_back();
    ball_.pop_back();
}

template <int D>
typename EditMesh<D>::Compact EditMesh<D>::compact() const {
    Compact out;
    IdVector<NodeId, NodeId> new_id(points_.size());
    for (const NodeId v : points_.ids()) {
        if (is_removed(v)) {
            continue;
        }
        new_id[v] = out.mesh.points.next_id();
        out.mesh.points.push_back(points_[v]);
        if (!labels_.empty()) {
            out.mesh.labels.push_back(labels_[v]);
        }
        out.classes.node.push_back(class_[v]);
        out.parent.push_back(v);
    }
    const auto renumber = [&](auto nodes) {
        for (NodeId& v : nodes) {
            v = new_id[v];
        }
        return nodes;
    };
    for (const EditElement<D>& e : elements_) {
        if (!e.nodes[0].valid()) {
            continue;
        }
        if (e.nodes[D] == ghost_) {
            out.mesh.faces.push_back(renumber(ghost_face<D>(e.nodes)));
            out.mesh.patch.push_back(e.label);
            out.classes.deviation.push_back(static_cast<double>(e.measure));
        } else {
            out.mesh.elements.push_back(renumber(e.nodes));
            out.mesh.region.push_back(e.label);
        }
    }
    for (const auto& [face, patch] : interior_) {
        out.mesh.faces.push_back(renumber(face));
        out.mesh.patch.push_back(patch);
        out.classes.deviation.push_back(0);
    }
    for (const auto& [nodes, ridge] : ridges_) {
        RidgeEdge moved = ridge;
        moved.nodes = renumber(nodes);
        out.classes.ridges.push_back(moved);
    }
    // The hash map has no order of its own.
    std::sort(out.classes.ridges.begin(), out.classes.ridges.end(),
              [](const RidgeEdge& a, const RidgeEdge& b) { return a.nodes < b.nodes; });
    out.classes.frozen_patches = frozen_patches_;
    out.classes.original = original_;
    out.mesh.patch_names = patch_names_;
    out.mesh.features = compact_features(new_id, out.classes, out.mesh);
    return out;
}

template <int D>
Features EditMesh<D>::compact_features(const IdVector<NodeId, NodeId>& new_id,
                                       const GeometryClasses<D>& classes,
                                       const Mesh<D>& mesh) const {
    Features out;
    const auto renumber = [&](auto nodes) {
        for (NodeId& v : nodes) {
            v = new_id[v];
        }
        return sorted(nodes);
    };
    for (const NodeId v : features_.corners) {
        out.corners.push_back(new_id[v]);
    }
    for (const NodeId v : features_.required_nodes) {
        out.required_nodes.push_back(new_id[v]);
    }
    std::map<Edge, int> listed;
    for (const RidgeEdge& r : classes.ridges) {
        if (r.listed) {
            const int id = static_cast<int>(out.edges.size());
            listed.emplace(r.nodes, id);
            out.edges.push_back(r.nodes);
            out.edge_labels.push_back(r.label);
            if (r.declared) {
                out.ridges.push_back(id);
            }
        }
    }
    std::map<Facet<D>, int> faces;
    if (!required_faces_.empty() || !ridge_faces_.empty()) {
        for (const FaceId f : mesh.faces.ids()) {
            faces.emplace(sorted(mesh.faces[f]), f.value());
        }
    }
    for (const Facet<D>& f : required_faces_) {
        (D == 2 ? out.required_edges : out.required_faces).push_back(faces.at(renumber(f)));
    }
    for (const Facet<D>& f : ridge_faces_) {
        out.ridges.push_back(faces.at(renumber(f)));
    }
    if constexpr (D == 3) {
        for (const int e : features_.required_edges) {
            out.required_edges.push_back(
                listed.at(renumber(features_.edges[static_cast<std::size_t>(e)])));
        }
    }
    if (!features_.required_elements.empty()) {
        std::vector<int> compact_id(elements_.size(), -1);
        int next = 0;
        for (const ElementId e : elements_.ids()) {
            if (!is_free(e) && !is_ghost(e)) {
                compact_id[e.index()] = next++;
            }
        }
        for (const int e : features_.required_elements) {
            out.required_elements.push_back(compact_id[static_cast<std::size_t>(e)]);
        }
    }
    return out;
}

template class EditMesh<2>;
template class EditMesh<3>;

} // namespace ameco
