// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/facets.h"

#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco {
namespace {

/// A facet in the bucket of its smallest node. Elements sort before faces.
template <int D>
struct Entry {
    std::array<NodeId, D - 1> others; ///< the other nodes, ascending
    std::int32_t id = 0;              ///< element or face
    std::int8_t opposite = 0;         ///< for an element 0 ... D; D + 1 for a face

    friend bool operator<(const Entry& a, const Entry& b) {
        if (a.others != b.others) {
            return a.others < b.others;
        }
        const bool a_is_face = a.opposite > D;
        const bool b_is_face = b.opposite > D;
        return a_is_face != b_is_face ? b_is_face : a.id < b.id;
    }
};

/// Appends the facets of an element whose smallest node is `v`, one of its two smallest nodes.
template <int D>
void append_element(const Simplex<D>& s, ElementId e, NodeId v, std::vector<Entry<D>>& entries) {
    std::array<std::pair<NodeId, int>, D + 1> ranked; // nodes in ascending order, with their place
    for (int i = 0; i <= D; ++i) {
        int j = i;
        for (; j > 0 && s[i] < ranked[j - 1].first; --j) {
            ranked[j] = ranked[j - 1];
        }
        ranked[j] = {s[i], i};
    }
    const auto append_without = [&](int left_out) {
        Facet<D> nodes;
        auto end = nodes.begin();
        for (int i = 0; i <= D; ++i) {
            if (i != left_out) {
                *end++ = ranked[i].first;
            }
        }
        Entry<D> entry;
        std::copy(nodes.begin() + 1, nodes.end(), entry.others.begin());
        entry.id = e.value();
        entry.opposite = static_cast<std::int8_t>(ranked[left_out].second);
        entries.push_back(entry);
    };
    if (ranked[0].first == v) {
        for (int i = 1; i <= D; ++i) {
            append_without(i);
        }
    } else {
        append_without(0);
    }
}

template <int D>
void append_face(const Facet<D>& face, FaceId f, std::vector<Entry<D>>& entries) {
    const Facet<D> nodes = sorted(face);
    Entry<D> entry;
    std::copy(nodes.begin() + 1, nodes.end(), entry.others.begin());
    entry.id = f.value();
    entry.opposite = D + 1;
    entries.push_back(entry);
}

/// Calls `visit` for each run of entries on the same nodes.
template <int D>
void visit_runs(NodeId smallest, const std::vector<Entry<D>>& entries,
                std::vector<ElementSide>& sides, std::vector<FaceId>& faces,
                const std::function<void(const FacetUses<D>&)>& visit) {
    for (std::size_t i = 0; i < entries.size();) {
        FacetUses<D> uses;
        uses.nodes[0] = smallest;
        std::copy(entries[i].others.begin(), entries[i].others.end(), uses.nodes.begin() + 1);
        sides.clear();
        faces.clear();
        const auto& others = entries[i].others;
        for (; i < entries.size() && entries[i].others == others; ++i) {
            if (entries[i].opposite > D) {
                faces.emplace_back(entries[i].id);
            } else {
                sides.push_back({ElementId(entries[i].id), entries[i].opposite});
            }
        }
        uses.sides = sides;
        uses.faces = faces;
        visit(uses);
    }
}

} // namespace

template <int D>
bool points_inward(const Mesh<D>& mesh, const ElementSide& side, const Facet<D>& listed) {
    const Simplex<D>& s = mesh.elements[side.element];
    return oppositely_oriented(facet_of<D>(s, side.opposite), listed) && orientation(mesh, s) > 0;
}

template <int D>
FacetTable<D>::FacetTable(const Mesh<D>& mesh) : mesh_(mesh) {
    // Of every facet of an element, the smallest node is the smallest or second smallest of the
    // element, since a facet misses one node only.
    elements_ =
        file_under<NodeId, ElementId>(mesh.points.size(), mesh.elements.size(), [&](ElementId e) {
            Simplex<D> s = mesh.elements[e];
            std::partial_sort(s.begin(), s.begin() + 2, s.end());
            return std::array<NodeId, 2>{s[0], s[1]};
        });
    faces_ = file_under<NodeId, FaceId>(mesh.points.size(), mesh.faces.size(), [&](FaceId f) {
        const Facet<D>& facet = mesh.faces[f];
        return std::array<NodeId, 1>{*std::min_element(facet.begin(), facet.end())};
    });
}

template <int D>
void FacetTable<D>::visit(std::size_t begin, std::size_t end,
                          const std::function<void(const FacetUses<D>&)>& visit) const {
    std::vector<Entry<D>> entries;
    std::vector<ElementSide> sides;
    std::vector<FaceId> faces;
    for (std::size_t i = begin; i < end; ++i) {
        const NodeId v(i);
        entries.clear();
        for (const ElementId e : elements_[v]) {
            append_element<D>(mesh_.elements[e], e, v, entries);
        }
        for (const FaceId f : faces_[v]) {
            append_face<D>(mesh_.faces[f], f, entries);
        }
        std::sort(entries.begin(), entries.end());
        visit_runs<D>(v, entries, sides, faces, visit);
    }
}

template bool points_inward<2>(const Mesh<2>&, const ElementSide&, const Facet<2>&);
template bool points_inward<3>(const Mesh<3>&, const ElementSide&, const Facet<3>&);
template class FacetTable<2>;
template class FacetTable<3>;

} // namespace ameco
