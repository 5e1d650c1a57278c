// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_report.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/geometry/predicates.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/references.h"
#include "core/mesh/simplex.h"
#include "core/mesh/surface_edges.h"
#include "core/surface/self_intersections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <functional>
#include <numeric>

namespace ameco {
namespace {

using Triangle = std::array<Vec<3>, 3>;

Triangle points_of(const Mesh<3>& mesh, const Facet<3>& f) {
    return {mesh.points[f[0]], mesh.points[f[1]], mesh.points[f[2]]};
}

/// Exact: three points are on a line if they are so in all three projections.
bool has_no_area(const Triangle& t) {
    for (int skip = 0; skip < 3; ++skip) {
        const auto flat = [&](const Vec<3>& x) {
            return Vec<2>(x[(skip + 1) % 3], x[(skip + 2) % 3]);
        };
        if (orientation(flat(t[0]), flat(t[1]), flat(t[2])) != 0) {
            return false;
        }
    }
    return true;
}

// --- nodes and faces ---------------------------------------------------------------------------

void find_duplicate_nodes(const Mesh<3>& mesh, const std::vector<bool>& used,
                          SurfaceDefects& defects) {
    std::vector<NodeId> order;
    for (const NodeId v : mesh.points.ids()) {
        if (used[v.index()]) {
            order.push_back(v);
        }
    }
    const auto key = [&](NodeId v) {
        const Vec<3>& x = mesh.points[v];
        return std::array{x[0], x[1], x[2]};
    };
    std::sort(order.begin(), order.end(),
              [&](NodeId a, NodeId b) { return std::pair(key(a), a) < std::pair(key(b), b); });
    for (std::size_t i = 1, first = 0; i < order.size(); ++i) {
        if (key(order[i]) == key(order[first])) {
            defects.duplicate_nodes.push_back({order[first], order[i]});
        } else {
            first = i;
        }
    }
    std::sort(defects.duplicate_nodes.begin(), defects.duplicate_nodes.end());
}

void find_bad_faces(const Mesh<3>& mesh, SurfaceDefects& defects) {
    std::vector<std::pair<Facet<3>, FaceId>> faces;
    for (const FaceId f : mesh.faces.ids()) {
        faces.emplace_back(sorted(mesh.faces[f]), f);
        if (has_repetition(mesh.faces[f]) || has_no_area(points_of(mesh, mesh.faces[f]))) {
            defects.flat_faces.push_back(f);
        }
    }
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 1, first = 0; i < faces.size(); ++i) {
        if (faces[i].first == faces[first].first) {
            defects.duplicate_faces.push_back({faces[first].second, faces[i].second});
        } else {
            first = i;
        }
    }
    std::sort(defects.duplicate_faces.begin(), defects.duplicate_faces.end());
}

// --- edges and parts ---------------------------------------------------------------------------

/// Groups things that were found to belong together; the smallest number stands for its group.
class Groups {
public:
    explicit Groups(std::size_t n) : root_(n) { std::iota(root_.begin(), root_.end(), 0U); }
    std::size_t find(std::size_t i) {
        while (root_[i] != i) {
            i = root_[i] = root_[root_[i]];
        }
        return i;
    }
    void join(std::size_t i, std::size_t j) {
        i = find(i);
        j = find(j);
        root_[std::max(i, j)] = std::min(i, j);
    }

private:
    std::vector<std::size_t> root_;
};

/// Whether the faces of a part can be turned to agree: each face is doubled, as it is and turned,
/// and joined with those of its neighbours that agree. A face in one group with its own back tells
/// of a Moebius band.
void find_orientability(const Mesh<3>& mesh, const std::vector<EdgeUse>& uses,
                        SurfaceReport& report) {
    const std::size_t k = mesh.faces.size();
    Groups sides(2 * k);
    for_each_edge(uses, [&](std::span<const EdgeUse> at) {
        if (at.size() == 2) {
            const std::size_t a = at[0].face.index(), b = at[1].face.index();
            const bool agree = at[0].ascending != at[1].ascending;
            sides.join(a, agree ? b : b + k);
            sides.join(a + k, agree ? b + k : b);
        }
    });
    for (SurfacePart& part : report.parts) {
        part.orientable =
            sides.find(part.first_face.index()) != sides.find(part.first_face.index() + k);
    }
}

void find_parts(const Mesh<3>& mesh, const std::vector<EdgeUse>& uses, SurfaceReport& report) {
    Groups groups(mesh.faces.size());
    for_each_edge(uses, [&](std::span<const EdgeUse> at) {
        for (const EdgeUse& use : at.subspan(1)) {
            groups.join(at[0].face.index(), use.face.index());
        }
    });
    report.part_of.assign(mesh.faces.size(), -1);
    for (const FaceId f : mesh.faces.ids()) {
        const FaceId first(groups.find(f.index()));
        if (first == f) {
            report.part_of[f] = static_cast<int>(report.parts.size());
            report.parts.push_back({.first_face = f, .closed = true});
        }
        report.part_of[f] = report.part_of[first];
    }
}

/// Edges and nodes of each part, and what is wrong at edges.
void count_edges(const std::vector<EdgeUse>& uses, SurfaceReport& report) {
    for_each_edge(uses, [&](std::span<const EdgeUse> at) {
        SurfacePart& part = report.parts[static_cast<std::size_t>(report.part_of[at[0].face])];
        ++part.edges;
        part.closed = part.closed && at.size() == 2;
        if (at.size() == 1) {
            report.defects.open_edges.push_back(at[0].edge);
        } else if (at.size() > 2) {
            report.defects.crowded_edges.push_back(at[0].edge);
        } else if (at[0].ascending == at[1].ascending) {
            report.defects.disagreeing_edges.push_back(at[0].edge);
        }
    });
}

/// Nodes of each part, and nodes at which the faces fall into several fans.
void count_nodes(const Mesh<3>& mesh, SurfaceReport& report) {
    const auto at_node = file_under<NodeId, FaceId>(mesh.points.size(), mesh.faces.size(),
                                                    [&](FaceId f) { return mesh.faces[f]; });
    for (const NodeId v : mesh.points.ids()) {
        const auto faces = at_node[v];
        if (faces.empty()) {
            ++report.unused_nodes;
            continue;
        }
        ++report.nodes;
        Groups fans(faces.size());
        std::vector<std::pair<NodeId, std::size_t>> rim;
        std::vector<int> parts;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            parts.push_back(report.part_of[faces[i]]);
            for (const NodeId w : mesh.faces[faces[i]]) {
                if (w != v) {
                    rim.emplace_back(w, i);
                }
            }
        }
        std::sort(rim.begin(), rim.end());
        for (std::size_t i = 1; i < rim.size(); ++i) {
            if (rim[i].first == rim[i - 1].first) {
                fans.join(rim[i].second, rim[i - 1].second);
            }
        }
        bool one_fan = true;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            one_fan = one_fan && fans.find(i) == 0;
        }
        if (!one_fan) {
            report.defects.pinched_nodes.push_back(v);
        }
        std::sort(parts.begin(), parts.end());
        parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
        for (const int part : parts) {
            ++report.parts[static_cast<std::size_t>(part)].nodes;
        }
    }
}

// --- measures ----------------------------------------------------------------------------------

void measure(const Mesh<3>& mesh, SurfaceReport& report) {
    report.low = report.high = mesh.points[mesh.faces[FaceId(0)][0]];
    const Vec<3> origin = report.low; // so that a distant origin costs no digits
    double shortest2 = std::numeric_limits<double>::infinity(), longest2 = 0;
    for (const FaceId f : mesh.faces.ids()) {
        const Triangle t = points_of(mesh, mesh.faces[f]);
        const Vec<3> normal = (t[1] - t[0]).cross(t[2] - t[0]);
        SurfacePart& part = report.parts[static_cast<std::size_t>(report.part_of[f])];
        ++part.faces;
        part.area += normal.norm() / 2;
        part.volume += (t[0] - origin).dot((t[1] - origin).cross(t[2] - origin)) / 6;
        double longest_here = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            report.low = report.low.cwiseMin(t[i]);
            report.high = report.high.cwiseMax(t[i]);
            const double length2 = (t[(i + 1) % 3] - t[i]).squaredNorm();
            shortest2 = std::min(shortest2, length2);
            longest_here = std::max(longest_here, length2);
        }
        longest2 = std::max(longest2, longest_here);
        if (normal.norm() > 0) {
            report.largest_aspect_ratio =
                std::max(report.largest_aspect_ratio, longest_here / normal.norm());
        }
    }
    report.shortest_edge = std::sqrt(shortest2);
    report.longest_edge = std::sqrt(longest2);
}

// --- words -------------------------------------------------------------------------------------

std::string place(NodeId v) {
    return std::to_string(v.value());
}
std::string place(FaceId f) {
    return std::to_string(f.value());
}
template <class IdType>
std::string place(const std::array<IdType, 2>& pair) {
    return place(pair[0]) + "-" + place(pair[1]);
}

/// "3 open edges (of one face only): 4-5, 7-8, 9-11".
template <class List>
void remark(std::vector<std::string>& remarks, const List& list, const std::string& one,
            const std::string& many) {
    constexpr std::size_t shown = 8;
    if (list.empty()) {
        return;
    }
    std::string text = count_text(static_cast<std::int64_t>(list.size())) + " " +
                       (list.size() == 1 ? one : many) + ": ";
    for (std::size_t i = 0; i < std::min(shown, list.size()); ++i) {
        text += (i == 0 ? "" : ", ") + place(list[i]);
    }
    remarks.push_back(text + (list.size() > shown ? ", ..." : ""));
}

void remark_harmless(std::vector<std::string>& remarks, const SurfaceDefects& d) {
    remark(remarks, d.duplicate_nodes, "pair of nodes at the same point",
           "pairs of nodes at the same point");
    remark(remarks, d.duplicate_faces, "pair of faces on the same nodes",
           "pairs of faces on the same nodes");
    remark(remarks, d.flat_faces, "face without area", "faces without area");
    remark(remarks, d.disagreeing_edges, "edge whose two faces are turned differently",
           "edges whose two faces are turned differently");
}

void remark_serious(std::vector<std::string>& remarks, const SurfaceDefects& d) {
    remark(remarks, d.open_edges, "open edge, with one face only",
           "open edges, with one face only");
    remark(remarks, d.crowded_edges, "edge of more than two faces", "edges of more than two faces");
    remark(remarks, d.pinched_nodes, "node where parts of the surface only touch",
           "nodes where parts of the surface only touch");
    remark(remarks, d.intersections, "pair of faces that intersect",
           "pairs of faces that intersect");
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += (text.empty() ? "" : "; ") + line;
    }
    return text;
}

} // namespace

bool SurfaceDefects::none() const {
    return duplicate_nodes.empty() && duplicate_faces.empty() && flat_faces.empty() &&
           disagreeing_edges.empty() && !beyond_repair();
}

bool SurfaceDefects::beyond_repair() const {
    return !open_edges.empty() || !crowded_edges.empty() || !pinched_nodes.empty() ||
           !intersections.empty();
}

bool SurfaceReport::sound() const {
    return defects.none() && std::all_of(parts.begin(), parts.end(), [](const SurfacePart& p) {
               return p.closed && p.orientable;
           });
}

SurfaceReport inspect_surface(const Mesh<3>& mesh, bool intersections) {
    if (mesh.faces.empty()) {
        throw InputError("the surface has no faces");
    }
    const BadReferences bad = find_bad_references(mesh);
    if (bad.count > 0) {
        throw InputError("the surface refers to what is not there: " + bad.example);
    }
    SurfaceReport report;
    report.faces = static_cast<std::int64_t>(mesh.faces.size());
    std::vector<bool> used(mesh.points.size());
    for (const Facet<3>& f : mesh.faces) {
        for (const NodeId v : f) {
            used[v.index()] = true;
            if (!mesh.points[v].allFinite()) {
                throw InputError("node " + place(v) +
                                 " of the surface has a coordinate that is "
                                 "no finite number");
            }
        }
    }
    find_duplicate_nodes(mesh, used, report.defects);
    find_bad_faces(mesh, report.defects);
    const std::vector<EdgeUse> uses = edge_uses(mesh.faces);
    find_parts(mesh, uses, report);
    count_edges(uses, report);
    count_nodes(mesh, report);
    find_orientability(mesh, uses, report);
    measure(mesh, report);
    if (intersections) {
        report.defects.intersections = self_intersections(mesh);
    }
    return report;
}

std::vector<std::string> defect_remarks(const SurfaceDefects& defects) {
    std::vector<std::string> remarks;
    remark_serious(remarks, defects);
    remark_harmless(remarks, defects);
    return remarks;
}

void require_sound_surface(const SurfaceReport& report, const std::string& name,
                           bool repair_helps) {
    std::vector<std::string> remarks;
    if (!repair_helps) {
        remark_serious(remarks, report.defects);
    }
    if (!remarks.empty()) {
        throw InputError(name + ": does not bound a volume: " + joined(remarks) +
                         "; mend it where it was made (ameco surface lists everything)");
    }
    for (const SurfacePart& part : report.parts) {
        if (!part.orientable) {
            throw InputError(name + ": has no inside: the part with face " +
                             place(part.first_face) + " has one side only, like a Moebius band");
        }
    }
    remark_harmless(remarks, report.defects);
    if (!remarks.empty()) {
        throw InputError(name + ": " + joined(remarks) +
                         "; ameco surface --repair mends this without loss");
    }
}

} // namespace ameco
