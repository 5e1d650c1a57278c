// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the paper's formats .dimeco and .dassault (appendices A.2 and A.3) have in common: three
/// counts, coordinates, elements, faces, and a logical number for each face, its patch.
///
/// Neither says how many dimensions it has: the amount of numbers in the file decides. Nodes are
/// numbered from 1; files that use a node 0 and no node n are taken as numbered from 0.
#pragma once

#include "core/io/mixed_mesh.h"

#include <algorithm>
#include <limits>

namespace ameco::founding {

struct Counts {
    std::int64_t nodes = 0;
    std::int64_t elements = 0;
    std::int64_t faces = 0;

    [[nodiscard]] bool possible() const {
        constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
        return nodes > 0 && nodes <= most && elements > 0 && elements <= most && faces >= 0 &&
               faces <= most;
    }
    [[nodiscard]] std::int64_t reals(int dimension) const { return nodes * dimension; }
    [[nodiscard]] std::int64_t integers(int dimension) const {
        return (elements + faces) * (dimension + 1);
    }
};

template <int D>
[[nodiscard]] Counts counts_of(const Mesh<D>& mesh) {
    return {static_cast<std::int64_t>(mesh.points.size()),
            static_cast<std::int64_t>(mesh.elements.size()),
            static_cast<std::int64_t>(mesh.faces.size())};
}

/// Where the patch of a face stands.
enum class Patches { behind_each_face, behind_all_faces };

/// Reads what follows the counts.
/// \param numbers  has `integer(what, row)`, `real(what, row)` and `begin_block()`
/// \throws InputError
template <int D, class Numbers>
class Reader {
public:
    Reader(Numbers& numbers, const Counts& counts, const std::string& name)
        : numbers_(numbers), counts_(counts), name_(name) {}

    MixedMesh<D> read(Patches patches) {
        numbers_.begin_block();
        mixed_.points.resize(static_cast<std::size_t>(counts_.nodes), Vec<D>::Zero());
        for (const NodeId node : mixed_.points.ids()) {
            for (int k = 0; k < D; ++k) {
                mixed_.points[node][k] = numbers_.real("node", node.value());
            }
        }
        auto& elements = element_cells();
        auto& faces = face_cells();
        elements.resize(static_cast<std::size_t>(counts_.elements));
        faces.resize(static_cast<std::size_t>(counts_.faces));
        numbers_.begin_block();
        for (std::size_t i = 0; i < elements.size(); ++i) {
            read_nodes(elements.nodes[i], "element", i);
        }
        const bool inline_patches = patches == Patches::behind_each_face;
        numbers_.begin_block();
        for (std::size_t i = 0; i < faces.size(); ++i) {
            read_nodes(faces.nodes[i], "face", i);
            if (inline_patches) {
                faces.labels[i] = read_label(i);
            }
        }
        numbers_.begin_block();
        for (std::size_t i = 0; i < faces.size() && !inline_patches; ++i) {
            faces.labels[i] = read_label(i);
        }
        number_from_0(elements);
        number_from_0(faces);
        return std::move(mixed_);
    }

private:
    auto& element_cells() {
        if constexpr (D == 3) {
            return mixed_.tetrahedra;
        } else {
            return mixed_.triangles;
        }
    }
    auto& face_cells() {
        if constexpr (D == 3) {
            return mixed_.triangles;
        } else {
            return mixed_.lines;
        }
    }

    template <std::size_t N>
    void read_nodes(std::array<NodeId, N>& nodes, const char* what, std::size_t row) {
        for (NodeId& node : nodes) {
            const std::int64_t number = numbers_.integer(what, static_cast<std::int64_t>(row));
            if (number < 0 || number > counts_.nodes) {
                throw InputError(name_ + ": " + what + " " + std::to_string(row + 1) +
                                 " uses node " + std::to_string(number) + ", but the file has " +
                                 std::to_string(counts_.nodes) + " nodes");
            }
            lowest_ = std::min(lowest_, number);
            highest_ = std::max(highest_, number);
            node = NodeId(static_cast<std::int32_t>(number));
        }
    }
    int read_label(std::size_t row) {
        const std::int64_t label =
            numbers_.integer("logical number of face", static_cast<std::int64_t>(row));
        if (label != static_cast<std::int32_t>(label)) {
            throw InputError(name_ + ": face " + std::to_string(row + 1) +
                             " has the logical number " + std::to_string(label) +
                             "; it must fit into 32 bits");
        }
        return static_cast<int>(label);
    }
    template <std::size_t N>
    void number_from_0(Cells<N>& cells) const {
        const bool already = lowest_ == 0 && highest_ < counts_.nodes;
        if (lowest_ == 0 && !already) {
            throw InputError(name_ + ": uses both a node 0 and a node " + std::to_string(highest_) +
                             ", but has " + std::to_string(counts_.nodes) + " nodes");
        }
        for (auto& nodes : cells.nodes) {
            for (NodeId& node : nodes) {
                node = already ? node : NodeId(node.value() - 1);
            }
        }
    }

    Numbers& numbers_;
    const Counts& counts_;
    const std::string& name_;
    MixedMesh<D> mixed_;
    std::int64_t lowest_ = 1;
    std::int64_t highest_ = 0;
};

} // namespace ameco::founding
