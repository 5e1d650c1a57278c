// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What removal and swaps remember, between them and from pass to pass, of the mesh they edit.
#pragma once

#include "core/remesh/change_times.h"
#include "core/remesh/edit_mesh.h"

namespace ameco {

/// Notes on the nodes and the element slots of a mesh. They spare work that would end as it did
/// before; to what few results that is not quite true, see docs/theory/remeshing.md.
struct EditNotes {
    template <int D>
    explicit EditNotes(const EditMesh<D>& mesh)
        : changes(mesh.node_count()), node_tried(mesh.node_count(), 0) {
        resize(mesh.slot_count());
    }

    void open_lanes(std::size_t lanes, std::size_t slot_count) {
        changes.open_lanes(lanes);
        resize(slot_count);
    }

    /// After `EditMesh::replace`: qualities of the new elements are not known.
    /// \param in  the slots of `fresh`
    template <int D>
    void replaced(std::span<const ElementId> in, const std::vector<EditElement<D>>& fresh,
                  const EditMesh<D>& mesh, std::size_t lane) {
        resize(mesh.slot_count());
        for (const ElementId e : in) {
            quality[e.index()] = -1;
        }
        for (const EditElement<D>& e : fresh) {
            for (const NodeId v : e.nodes) {
                if (v != mesh.ghost()) {
                    changes.touch(v, lane);
                }
            }
        }
        changes.tick(lane);
    }

    ChangeTimes changes;
    IdVector<NodeId, ChangeTimes::Time> node_tried; ///< when a node was last found to have to stay
    std::vector<ChangeTimes::Time> element_tried;   ///< when no swap was found at an element
    std::vector<float> quality;                     ///< `metric_quality`; negative: not known

private:
    void resize(std::size_t slot_count) {
        if (quality.size() < slot_count) {
            element_tried.resize(slot_count, 0);
            quality.resize(slot_count, -1);
        }
    }
};

} // namespace ameco
