// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/locate.h"

#include "core/geometry/predicates.h"
#include "core/mesh/facets.h"
#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco {
namespace {

/// Sign of the volume of element `s` with `p` in the place of its node `i`.
template <int D>
int side(const Mesh<D>& mesh, const Simplex<D>& s, int i, const Vec<D>& p) {
    auto x = corners_of(mesh, s);
    x[static_cast<std::size_t>(i)] = p;
    return std::apply([](const auto&... c) { return orientation(c...); }, x);
}

} // namespace

template <int D>
Locator<D>::Locator(const Mesh<D>& mesh)
    : mesh_(mesh), balls_(node_elements(mesh)), across_(mesh.elements.size()) {
    const FacetTable<D> facets(mesh);
    facets.visit(0, mesh.points.size(), [&](const FacetUses<D>& f) {
        if (f.sides.size() == 2) {
            for (std::size_t k = 0; k < 2; ++k) {
                const ElementSide& here = f.sides[k];
                across_[here.element][static_cast<std::size_t>(here.opposite)] =
                    f.sides[1 - k].element;
            }
        }
    });
}

template <int D>
bool Locator<D>::contains(ElementId e, const Vec<D>& p) const {
    for (int i = 0; i <= D; ++i) {
        if (side(mesh_, mesh_.elements[e], i, p) < 0) {
            return false;
        }
    }
    return true;
}

/// The element to go to; `at` itself if it holds `p`; none at the boundary.
template <int D>
ElementId Locator<D>::step(ElementId at, ElementId before, const Vec<D>& p, unsigned turn) const {
    bool holds = true;
    ElementId back;
    for (unsigned k = 0; k <= D; ++k) {
        const unsigned i = (k + turn) % (D + 1);
        if (side(mesh_, mesh_.elements[at], static_cast<int>(i), p) >= 0) {
            continue;
        }
        holds = false;
        const ElementId next = across_[at][i];
        if (next.valid() && next != before) {
            return next;
        }
        if (next.valid()) {
            back = next;
        }
    }
    return holds ? at : back;
}

template <int D>
std::optional<ElementId> Locator<D>::walk(const Vec<D>& p, NodeId start) const {
    for (const ElementId e : balls_[start]) {
        if (contains(e, p)) {
            return e;
        }
    }
    // Elements seen once from p may be seen again where the mesh is not Delaunay; trying their
    // facets in another order each time leaves such cycles.
    constexpr int most_steps = 300;
    ElementId at = balls_[start].front(), before;
    std::uint32_t state = 2654435761u;
    for (int steps = 0; steps < most_steps; ++steps) {
        state = state * 1664525u + 1013904223u;
        const ElementId next = step(at, before, p, (state >> 16) % (D + 1));
        if (next == at) {
            return at;
        }
        if (!next.valid()) {
            return std::nullopt;
        }
        before = at;
        at = next;
    }
    return std::nullopt;
}

template class Locator<2>;
template class Locator<3>;

} // namespace ameco
