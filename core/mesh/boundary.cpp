// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/boundary.h"

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/mesh/facets.h"
#include "core/mesh/references.h"
#include "core/mesh/simplex.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ameco {
namespace {

constexpr std::size_t nodes_per_piece = 16384;
constexpr double pi = 3.14159265358979323846;

// --- elements ----------------------------------------------------------------------------------

/// Turns all elements if some are negative and none is positive.
template <int D>
bool turn_elements(Mesh<D>& mesh) {
    bool negative = false;
    for (const Simplex<D>& s : mesh.elements) {
        const int sign = orientation(mesh, s);
        if (sign > 0) {
            return false; // for most meshes, at the first element
        }
        negative = negative || sign < 0;
    }
    if (negative) {
        for (Simplex<D>& s : mesh.elements) {
            std::swap(s[D - 1], s[D]);
        }
    }
    return negative;
}

// --- nodes -------------------------------------------------------------------------------------

void drop_missing(std::vector<NodeId>& nodes, const IdVector<NodeId, NodeId>& new_id) {
    std::vector<NodeId> kept;
    for (const NodeId v : nodes) {
        if (new_id[v].valid()) {
            kept.push_back(new_id[v]);
        }
    }
    nodes = std::move(kept);
}

/// Rewrites indices after some of what they refer to is gone (-1 in `new_index`).
void drop_missing(std::vector<int>& indices, const std::vector<int>& new_index) {
    std::vector<int> kept;
    for (const int i : indices) {
        if (new_index[static_cast<std::size_t>(i)] >= 0) {
            kept.push_back(new_index[static_cast<std::size_t>(i)]);
        }
    }
    indices = std::move(kept);
}

/// Renumbers the nodes in the features; what was declared of a dropped node is dropped with it.
template <int D>
void renumber(Features& features, const IdVector<NodeId, NodeId>& new_id) {
    drop_missing(features.corners, new_id);
    drop_missing(features.required_nodes, new_id);
    std::vector<Edge> edges;
    std::vector<int> labels;
    std::vector<int> new_index(features.edges.size(), -1);
    for (std::size_t i = 0; i < features.edges.size(); ++i) {
        const Edge edge{new_id[features.edges[i][0]], new_id[features.edges[i][1]]};
        if (edge[0].valid() && edge[1].valid()) {
            new_index[i] = static_cast<int>(edges.size());
            edges.push_back(edge);
            if (i < features.edge_labels.size()) {
                labels.push_back(features.edge_labels[i]);
            }
        }
    }
    features.edges = std::move(edges);
    features.edge_labels = std::move(labels);
    if constexpr (D == 3) { // in 2-D these are faces, which keep their numbers
        drop_missing(features.ridges, new_index);
        drop_missing(features.required_edges, new_index);
    }
}

/// Drops the nodes that neither elements nor faces use. (A face without element is a defect for
/// `check`, which must find it as it was.)
template <int D>
std::int64_t remove_orphans(Mesh<D>& mesh) {
    IdVector<NodeId, NodeId> new_id(mesh.points.size());
    const auto mark = [&](const auto& tuples) {
        for (const auto& tuple : tuples) {
            for (const NodeId v : tuple) {
                new_id[v] = v;
            }
        }
    };
    mark(mesh.elements);
    mark(mesh.faces);
    const bool labelled = !mesh.labels.empty();
    NodeId next(0);
    for (const NodeId v : mesh.points.ids()) {
        if (new_id[v].valid()) {
            new_id[v] = next;
            mesh.points[next] = mesh.points[v];
            if (labelled) {
                mesh.labels[next] = mesh.labels[v];
            }
            next = NodeId(next.index() + 1);
        }
    }
    const auto removed = static_cast<std::int64_t>(mesh.points.size() - next.index());
    if (removed == 0) {
        return 0;
    }
    mesh.points.resize(next.index(), Vec<D>::Zero());
    if (labelled) {
        mesh.labels.resize(next.index());
    }
    const auto renumber_tuples = [&](auto& tuples) {
        for (auto& tuple : tuples) {
            for (NodeId& v : tuple) {
                v = new_id[v];
            }
        }
    };
    renumber_tuples(mesh.elements);
    renumber_tuples(mesh.faces);
    renumber<D>(mesh.features, new_id);
    return removed;
}

// --- faces -------------------------------------------------------------------------------------

struct BoundaryFaults {
    std::vector<FaceId> turned;
    std::vector<ElementSide> missing; ///< sides of elements that no face covers, ascending
};

/// Boundary faces that point inward, and boundary facets that no face is listed for.
template <int D>
BoundaryFaults find_faults(const Mesh<D>& mesh) {
    const FacetTable<D> table(mesh);
    const std::size_t n = mesh.points.size();
    std::vector<BoundaryFaults> pieces((n + nodes_per_piece - 1) / nodes_per_piece);
    parallel_for(n, nodes_per_piece, [&](std::size_t begin, std::size_t end) {
        BoundaryFaults& piece = pieces[begin / nodes_per_piece];
        table.visit(begin, end, [&](const FacetUses<D>& uses) {
            if (uses.sides.size() != 1) {
                return;
            }
            if (uses.faces.empty()) {
                piece.missing.push_back(uses.sides[0]);
            }
            for (const FaceId f : uses.faces) {
                if (points_inward<D>(mesh, uses.sides[0], mesh.faces[f])) {
                    piece.turned.push_back(f);
                }
            }
        });
    });
    BoundaryFaults all;
    for (const BoundaryFaults& piece : pieces) {
        all.turned.insert(all.turned.end(), piece.turned.begin(), piece.turned.end());
        all.missing.insert(all.missing.end(), piece.missing.begin(), piece.missing.end());
    }
    std::sort(all.missing.begin(), all.missing.end(),
              [](const ElementSide& a, const ElementSide& b) {
                  return std::pair(a.element, a.opposite) < std::pair(b.element, b.opposite);
              });
    return all;
}

// --- patches for new faces ---------------------------------------------------------------------

/// Unit normal, outwards; zero if it cannot be computed.
Vec<2> normal(const Mesh<2>& mesh, const Facet<2>& f) {
    const Vec<2> t = mesh.points[f[1]] - mesh.points[f[0]];
    return Vec<2>(t[1], -t[0]).stableNormalized();
}
Vec<3> normal(const Mesh<3>& mesh, const Facet<3>& f) {
    const Vec<3> a = mesh.points[f[1]] - mesh.points[f[0]];
    const Vec<3> b = mesh.points[f[2]] - mesh.points[f[0]];
    return a.stableNormalized().cross(b.stableNormalized()).stableNormalized();
}

/// Where facet `f` may continue smoothly: its edges (3-D) or nodes (2-D), as sorted node tuples.
template <int D>
std::array<std::array<NodeId, D - 1>, D> rims(const Facet<D>& f) {
    std::array<std::array<NodeId, D - 1>, D> result;
    for (int i = 0; i < D; ++i) {
        for (int k = 0; k + 1 < D; ++k) {
            result[i][k] = f[(i + 1 + k) % D];
        }
        result[i] = sorted(result[i]);
    }
    return result;
}

std::size_t find_root(std::vector<std::size_t>& root, std::size_t i) {
    while (root[i] != i) {
        i = root[i] = root[root[i]];
    }
    return i;
}

/// Groups facets into runs that turn by no more than the angle from one to the next.
/// \return for each facet, the first one of its run
template <int D>
std::vector<std::size_t> smooth_runs(const Mesh<D>& mesh, const std::vector<Facet<D>>& facets,
                                     double ridge_angle_deg) {
    using Rim = std::pair<std::array<NodeId, D - 1>, std::size_t>;
    std::vector<Rim> at;
    at.reserve(facets.size() * D);
    for (std::size_t i = 0; i < facets.size(); ++i) {
        for (const auto& rim : rims<D>(facets[i])) {
            at.emplace_back(rim, i);
        }
    }
    std::sort(at.begin(), at.end());
    const double smallest_cosine = std::cos(ridge_angle_deg * pi / 180);
    std::vector<std::size_t> root(facets.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    for (std::size_t i = 0; i < at.size();) {
        std::size_t j = i + 1;
        for (; j < at.size() && at[j].first == at[i].first; ++j) {
        }
        if (j - i == 2) { // at a non-manifold rim no pair belongs together
            const std::size_t a = at[i].second;
            const std::size_t b = at[i + 1].second;
            if (normal(mesh, facets[a]).dot(normal(mesh, facets[b])) >= smallest_cosine) {
                const std::size_t root_a = find_root(root, a);
                const std::size_t root_b = find_root(root, b);
                root[std::max(root_a, root_b)] = std::min(root_a, root_b);
            }
        }
        i = j;
    }
    for (std::size_t i = 0; i < root.size(); ++i) {
        root[i] = find_root(root, i);
    }
    return root;
}

/// One above the highest patch id in use. (Ids near the end of the range, which some programs give
/// to what has no patch, would leave no room above them, and are passed over.)
template <int D>
int first_free_patch(const Mesh<D>& mesh) {
    constexpr int room_above = 1 << 30;
    int highest = 0;
    const auto consider = [&](int patch) {
        highest = patch < room_above ? std::max(highest, patch) : highest;
    };
    for (const int patch : mesh.patch) {
        consider(patch);
    }
    for (const auto& [patch, name] : mesh.patch_names) {
        consider(patch);
    }
    return highest + 1;
}

template <int D>
void add_faces(Mesh<D>& mesh, const std::vector<ElementSide>& sides, double ridge_angle_deg,
               int first_patch) {
    std::vector<Facet<D>> facets;
    facets.reserve(sides.size());
    for (const ElementSide& side : sides) {
        facets.push_back(facet_of<D>(mesh.elements[side.element], side.opposite));
    }
    const std::vector<std::size_t> run = smooth_runs<D>(mesh, facets, ridge_angle_deg);
    std::vector<int> patch(facets.size());
    int next = first_patch;
    for (std::size_t i = 0; i < facets.size(); ++i) {
        if (run[i] == i) {
            mesh.patch_names[next] = "boundary-" + std::to_string(next);
            patch[i] = next++;
        }
        patch[i] = patch[run[i]]; // its first facet came before
        mesh.faces.push_back(facets[i]);
        mesh.patch.push_back(patch[i]);
    }
}

} // namespace

template <int D>
BoundaryRepair complete_boundary(Mesh<D>& mesh, double ridge_angle_deg) {
    BoundaryRepair repair;
    repair.first_new_patch = first_free_patch(mesh);
    if (!is_computable(mesh)) {
        return repair;
    }
    repair.elements_turned = turn_elements(mesh);
    repair.orphans_removed = remove_orphans(mesh);
    const BoundaryFaults faults = find_faults(mesh);
    for (const FaceId f : faults.turned) {
        std::swap(mesh.faces[f][D - 2], mesh.faces[f][D - 1]);
    }
    repair.faces_turned = static_cast<std::int64_t>(faults.turned.size());
    add_faces(mesh, faults.missing, ridge_angle_deg, repair.first_new_patch);
    repair.faces_added = static_cast<std::int64_t>(faults.missing.size());
    return repair;
}

std::vector<std::string> repair_remarks(const BoundaryRepair& repair) {
    std::vector<std::string> remarks;
    if (repair.elements_turned) {
        remarks.emplace_back("all elements had negative orientation and were turned");
    }
    if (repair.faces_turned > 0) {
        remarks.push_back(plural(repair.faces_turned, "boundary face") + " pointed inwards and " +
                          (repair.faces_turned == 1 ? "was" : "were") + " turned");
    }
    if (repair.faces_added > 0) {
        remarks.push_back(plural(repair.faces_added, "boundary face") + " missing in the file " +
                          (repair.faces_added == 1 ? "was" : "were") + " added, as patch " +
                          std::to_string(repair.first_new_patch) + " and up");
    }
    if (repair.orphans_removed > 0) {
        remarks.push_back(plural(repair.orphans_removed, "node") + " that no element uses " +
                          (repair.orphans_removed == 1 ? "was" : "were") + " left out");
    }
    return remarks;
}

template BoundaryRepair complete_boundary(Mesh<2>&, double);
template BoundaryRepair complete_boundary(Mesh<3>&, double);

} // namespace ameco
