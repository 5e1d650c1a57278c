// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_repair.h"

#include "core/base/text.h"
#include "core/mesh/boundary.h"
#include "core/mesh/references.h"
#include "core/mesh/simplex.h"
#include "core/mesh/surface_edges.h"
#include "core/surface/surface_tree.h"

#include <algorithm>
#include <deque>

namespace ameco {
namespace {

std::int64_t merge_nodes(Mesh<3>& mesh) {
    const SurfaceReport report = inspect_surface(mesh, false);
    IdVector<NodeId, NodeId> kept(mesh.points.size());
    for (const NodeId v : mesh.points.ids()) {
        kept[v] = v;
    }
    for (const auto& [first, again] : report.defects.duplicate_nodes) {
        kept[again] = first;
    }
    const auto replace = [&](auto& tuples) {
        for (auto& tuple : tuples) {
            for (NodeId& v : tuple) {
                v = kept[v];
            }
        }
    };
    replace(mesh.faces);
    replace(mesh.features.edges);
    for (NodeId& v : mesh.features.corners) {
        v = kept[v];
    }
    for (NodeId& v : mesh.features.required_nodes) {
        v = kept[v];
    }
    return static_cast<std::int64_t>(report.defects.duplicate_nodes.size());
}

/// Drops the marked faces; what was said of required faces follows.
void drop_faces(Mesh<3>& mesh, const std::vector<bool>& drop) {
    IdVector<FaceId, Facet<3>> faces;
    IdVector<FaceId, int> patch;
    std::vector<int> new_index(drop.size(), -1);
    for (const FaceId f : mesh.faces.ids()) {
        if (!drop[f.index()]) {
            new_index[f.index()] = static_cast<int>(faces.size());
            faces.push_back(mesh.faces[f]);
            patch.push_back(mesh.patch[f]);
        }
    }
    mesh.faces = std::move(faces);
    mesh.patch = std::move(patch);
    std::vector<int> required;
    for (const int f : mesh.features.required_faces) {
        if (new_index[static_cast<std::size_t>(f)] >= 0) {
            required.push_back(new_index[static_cast<std::size_t>(f)]);
        }
    }
    mesh.features.required_faces = std::move(required);
}

std::int64_t drop_repeated_faces(Mesh<3>& mesh) {
    const SurfaceReport report = inspect_surface(mesh, false);
    std::vector<bool> drop(mesh.faces.size());
    for (const auto& [first, again] : report.defects.duplicate_faces) {
        drop[again.index()] = true;
    }
    for (const FaceId f : mesh.faces.ids()) {
        drop[f.index()] = drop[f.index()] || has_repetition(mesh.faces[f]);
    }
    const std::int64_t count = std::count(drop.begin(), drop.end(), true);
    if (count > 0) {
        drop_faces(mesh, drop);
    }
    return count;
}

/// Flips the longest edge of a face without area into the face beside it, which then has the node
/// that lay on that edge as a corner. \return whether that was possible
bool flip_longest_edge(Mesh<3>& mesh, FaceId flat) {
    Facet<3>& f = mesh.faces[flat];
    int k = 0; // opposite the longest edge
    double longest = -1;
    for (int i = 0; i < 3; ++i) {
        const double length = (mesh.points[f[static_cast<std::size_t>((i + 1) % 3)]] -
                               mesh.points[f[static_cast<std::size_t>((i + 2) % 3)]])
                                  .norm();
        if (length > longest) {
            longest = length;
            k = i;
        }
    }
    std::rotate(f.begin(), f.begin() + k, f.end()); // f[0] lies on the edge f[1], f[2]
    for (const FaceId g : mesh.faces.ids()) {
        Facet<3>& n = mesh.faces[g];
        const auto has = [&](NodeId v) { return std::find(n.begin(), n.end(), v) != n.end(); };
        if (g == flat || !has(f[1]) || !has(f[2]) || has(f[0])) {
            continue;
        }
        Facet<3> first = n, second = n;
        std::replace(first.begin(), first.end(), f[2], f[0]);
        std::replace(second.begin(), second.end(), f[1], f[0]);
        n = first;
        f = second;
        mesh.patch[flat] = mesh.patch[g];
        return true;
    }
    return false;
}

std::int64_t flip_flat_faces(Mesh<3>& mesh) {
    std::int64_t flipped = 0;
    // A flip may leave a face without area beside another: a chain of nodes on one edge takes as
    // many rounds as it has nodes.
    for (int round = 0; round < 16; ++round) {
        const SurfaceReport report = inspect_surface(mesh, false);
        std::int64_t now = 0;
        for (const FaceId f : report.defects.flat_faces) {
            now += flip_longest_edge(mesh, f) ? 1 : 0;
        }
        flipped += now;
        if (now == 0) {
            break;
        }
    }
    return flipped;
}

/// Turns faces until those beside each other agree, starting from the first face of each part.
/// \return which faces are turned; nothing is changed
std::vector<bool> turns_to_agree(const Mesh<3>& mesh) {
    const std::vector<EdgeUse> uses = edge_uses(mesh.faces);
    struct Neighbour {
        FaceId face;
        bool agrees;
    };
    std::vector<std::vector<Neighbour>> beside(mesh.faces.size());
    for_each_edge(uses, [&](std::span<const EdgeUse> at) {
        if (at.size() == 2) {
            const bool agrees = at[0].ascending != at[1].ascending;
            beside[at[0].face.index()].push_back({at[1].face, agrees});
            beside[at[1].face.index()].push_back({at[0].face, agrees});
        }
    });
    std::vector<bool> turned(mesh.faces.size()), seen(mesh.faces.size());
    for (const FaceId start : mesh.faces.ids()) {
        if (seen[start.index()]) {
            continue;
        }
        seen[start.index()] = true;
        std::deque<FaceId> front{start};
        while (!front.empty()) {
            const FaceId f = front.front();
            front.pop_front();
            for (const Neighbour& n : beside[f.index()]) {
                if (!seen[n.face.index()]) {
                    seen[n.face.index()] = true;
                    turned[n.face.index()] = turned[f.index()] != !n.agrees;
                    front.push_back(n.face);
                }
            }
        }
    }
    return turned;
}

void turn(Facet<3>& face) {
    std::swap(face[1], face[2]);
}

std::int64_t turn_faces(Mesh<3>& mesh) {
    std::vector<bool> turned = turns_to_agree(mesh);
    for (const FaceId f : mesh.faces.ids()) {
        if (turned[f.index()]) {
            turn(mesh.faces[f]);
        }
    }
    const SurfaceReport report = inspect_surface(mesh, false);
    std::vector<bool> closed;
    for (const SurfacePart& part : report.parts) {
        closed.push_back(part.closed && part.orientable);
    }
    const std::vector<int> depth = nesting_depths(mesh, SurfaceTree(mesh), report.part_of, closed);
    for (const FaceId f : mesh.faces.ids()) {
        const auto part = static_cast<std::size_t>(report.part_of[f]);
        const bool outwards = depth[part] % 2 == 0;
        if (closed[part] && (report.parts[part].volume > 0) != outwards) {
            turn(mesh.faces[f]);
            turned[f.index()] = !turned[f.index()];
        }
    }
    return std::count(turned.begin(), turned.end(), true);
}

} // namespace

SurfaceRepair repair_surface(Mesh<3>& mesh) {
    SurfaceRepair repair;
    mesh.elements.clear();
    mesh.region.clear();
    mesh.features.required_elements.clear();
    repair.nodes_merged = merge_nodes(mesh);
    repair.faces_dropped = drop_repeated_faces(mesh);
    if (mesh.faces.empty()) {
        return repair;
    }
    repair.edges_flipped = flip_flat_faces(mesh);
    repair.faces_dropped += drop_repeated_faces(mesh);
    if (mesh.faces.empty()) {
        return repair;
    }
    repair.faces_turned = turn_faces(mesh);
    repair.nodes_dropped =
        std::max<std::int64_t>(0, complete_boundary(mesh).orphans_removed - repair.nodes_merged);
    return repair;
}

bool repair_helps(const Mesh<3>& surface, const SurfaceReport& report) {
    const SurfaceDefects& d = report.defects;
    if (d.duplicate_nodes.empty() && d.duplicate_faces.empty() && d.flat_faces.empty() &&
        d.disagreeing_edges.empty()) {
        return false;
    }
    Mesh<3> mended = surface;
    repair_surface(mended);
    return !mended.faces.empty() && inspect_surface(mended).sound();
}

std::vector<std::string> repair_remarks(const SurfaceRepair& repair) {
    std::vector<std::string> remarks;
    const auto add = [&](std::int64_t count, const std::string& one, const std::string& what) {
        if (count > 0) {
            remarks.push_back(plural(count, one) + " " + (count == 1 ? "was " : "were ") + what);
        }
    };
    add(repair.nodes_merged, "node", "merged with another at the same point");
    add(repair.faces_dropped, "face", "left out, being there twice or having a node twice");
    add(repair.edges_flipped, "edge", "flipped at faces without area");
    add(repair.faces_turned, "face", "turned");
    add(repair.nodes_dropped, "node", "left out, as no face uses it");
    return remarks;
}

} // namespace ameco
