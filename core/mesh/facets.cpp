// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/facets.h"

#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco {
namespace {

/// A facet in the bucket of its smallest node, packed so that two comparisons sort: by the other
/// nodes, elements before faces, by id.
template <int D>
struct Entry {
    std::uint64_t others = 0; ///< the other nodes, ascending
    std::uint64_t use = 0;    ///< of an element or, with the highest bit, a face

    static Entry of_element(const Facet<D>& nodes, ElementId e, int opposite) {
        return {pack(nodes), e.index() << 2 | static_cast<std::uint64_t>(opposite)};
    }
    static Entry of_face(const Facet<D>& nodes, FaceId f) {
        return {pack(nodes), face_bit | f.index()};
    }
    [[nodiscard]] bool is_face() const { return (use & face_bit) != 0; }
    [[nodiscard]] FaceId face() const { return FaceId(use & ~face_bit); }
    [[nodiscard]] ElementSide side() const {
        return {ElementId(use >> 2), static_cast<int>(use & 3)};
    }
    [[nodiscard]] NodeId other(int i) const {
        return NodeId(others >> 32 * (D - 2 - i) & 0xffffffff);
    }

    friend bool operator<(const Entry& a, const Entry& b) {
        return a.others != b.others ? a.others < b.others : a.use < b.use;
    }

private:
    Entry(std::uint64_t others_, std::uint64_t use_) : others(others_), use(use_) {}
    static constexpr std::uint64_t face_bit = std::uint64_t{1} << 63;
    static std::uint64_t pack(const Facet<D>& nodes) {
        std::uint64_t packed = 0;
        for (int i = 1; i < D; ++i) {
            packed = packed << 32 | nodes[i].index();
        }
        return packed;
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
        entries.push_back(Entry<D>::of_element(nodes, e, ranked[left_out].second));
    };
    if (ranked[0].first == v) {
        for (int i = 1; i <= D; ++i) {
            append_without(i);
        }
    } else {
        append_without(0);
    }
}

/// Calls `visit` for each run of entries on the same nodes.
template <int D>
void visit_runs(NodeId smallest, const std::vector<Entry<D>>& entries,
                std::vector<ElementSide>& sides, std::vector<FaceId>& faces,
                const std::function<void(const FacetUses<D>&)>& visit) {
    for (std::size_t i = 0; i < entries.size();) {
        FacetUses<D> uses;
        uses.nodes[0] = smallest;
        for (int k = 0; k < D - 1; ++k) {
            uses.nodes[k + 1] = entries[i].other(k);
        }
        sides.clear();
        faces.clear();
        const std::uint64_t others = entries[i].others;
        for (; i < entries.size() && entries[i].others == others; ++i) {
            if (entries[i].is_face()) {
                faces.push_back(entries[i].face());
            } else {
                sides.push_back(entries[i].side());
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
            entries.push_back(Entry<D>::of_face(sorted(mesh_.faces[f]), f));
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
