// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/check.h"

#include "core/base/parallel.h"
#include "core/geometry/sum.h"
#include "core/geometry/volume.h"
#include "core/mesh/facets.h"
#include "core/mesh/references.h"
#include "core/mesh/simplex.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace ameco {
namespace {

constexpr std::size_t defect_count = static_cast<std::size_t>(Defect::volumes_do_not_add_up) + 1;
constexpr std::size_t items_per_piece = 16384;

/// How often a defect was seen, and the smallest entity (or pair of them) that has it.
struct Tally {
    using Key = std::array<std::int32_t, 2>;
    std::int64_t count = 0;
    Key first{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max()};

    void add(Key key) {
        ++count;
        first = std::min(first, key);
    }
    void merge(const Tally& other) {
        count += other.count;
        first = std::min(first, other.first);
    }
};

/// What one piece of a parallel loop found. Merging is order-free but for the sums, which are
/// merged in the order of the pieces.
struct Tallies {
    std::array<Tally, defect_count> of;
    std::int64_t interior_faces = 0;
    Sum volume;
    Sum magnitude;

    void add(Defect d, std::int32_t first, std::int32_t second = 0) {
        of[static_cast<std::size_t>(d)].add({first, second});
    }
    [[nodiscard]] const Tally& operator[](Defect d) const {
        return of[static_cast<std::size_t>(d)];
    }
    [[nodiscard]] bool any() const {
        return std::any_of(of.begin(), of.end(), [](const Tally& t) { return t.count > 0; });
    }
    void merge(const Tallies& other) {
        for (std::size_t d = 0; d < defect_count; ++d) {
            of[d].merge(other.of[d]);
        }
        interior_faces += other.interior_faces;
        volume.add(other.volume);
        magnitude.add(other.magnitude);
    }
};

/// Runs `body(begin, end, tallies)` over pieces of [0, n) and merges what they found.
template <class Body>
void tally_in_parallel(std::size_t n, Tallies& result, Body body) {
    std::vector<Tallies> pieces((n + items_per_piece - 1) / items_per_piece);
    parallel_for(n, items_per_piece, [&](std::size_t begin, std::size_t end) {
        body(begin, end, pieces[begin / items_per_piece]);
    });
    for (const Tallies& piece : pieces) {
        result.merge(piece);
    }
}

template <std::size_t N>
std::string list(const std::array<NodeId, N>& nodes) {
    std::string text = "nodes";
    for (const NodeId v : nodes) {
        text += ' ' + std::to_string(v.value());
    }
    return text;
}

template <int D>
std::string describe(const Mesh<D>& mesh, ElementId e) {
    return "element " + std::to_string(e.value()) + " (" + list(mesh.elements[e]) + ")";
}

template <int D>
std::string describe(const Mesh<D>& mesh, FaceId f) {
    return "face " + std::to_string(f.value()) + " (" + list(mesh.faces[f]) + ")";
}

// --- nodes and elements by themselves ----------------------------------------------------------

/// The second part of a repeated node's key tells elements (0) from faces (1).
template <int D>
void test_nodes(const Mesh<D>& mesh, Tallies& tallies) {
    for (const NodeId v : mesh.points.ids()) {
        if (!mesh.points[v].allFinite()) {
            tallies.add(Defect::not_finite, v.value());
        }
    }
    tally_in_parallel(mesh.elements.size(), tallies,
                      [&](std::size_t begin, std::size_t end, Tallies& piece) {
                          for (std::size_t i = begin; i < end; ++i) {
                              const ElementId e(i);
                              if (has_repetition(mesh.elements[e])) {
                                  piece.add(Defect::repeated_node, e.value(), 0);
                              }
                          }
                      });
    for (const FaceId f : mesh.faces.ids()) {
        if (has_repetition(mesh.faces[f])) {
            tallies.add(Defect::repeated_node, f.value(), 1);
        }
    }
}

template <int D>
void test_elements(const Mesh<D>& mesh, Tallies& tallies) {
    tally_in_parallel(mesh.elements.size(), tallies,
                      [&](std::size_t begin, std::size_t end, Tallies& piece) {
                          for (std::size_t i = begin; i < end; ++i) {
                              const ElementId e(i);
                              const int sign = orientation(mesh, mesh.elements[e]);
                              if (sign < 0) {
                                  piece.add(Defect::inverted_element, e.value());
                              } else if (sign == 0) {
                                  piece.add(Defect::flat_element, e.value());
                              }
                              const Volume v = volume(corners_of(mesh, mesh.elements[e]));
                              piece.volume.add(v.value);
                              piece.magnitude.add(v.magnitude);
                          }
                      });
}

template <int D>
void test_for_orphans(const Mesh<D>& mesh, Tallies& tallies) {
    std::vector<std::uint8_t> used(mesh.points.size(), 0);
    parallel_for(mesh.elements.size(), items_per_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (const NodeId v : mesh.elements[ElementId(i)]) {
                std::atomic_ref(used[v.index()]).store(1, std::memory_order_relaxed);
            }
        }
    });
    for (const NodeId v : mesh.points.ids()) {
        if (used[v.index()] == 0) {
            tallies.add(Defect::orphan_node, v.value());
        }
    }
}

// --- facets ------------------------------------------------------------------------------------

/// Counts duplicates among the elements at a facet and removes them from `sides`, so that they are
/// not reported a second time as too many elements.
template <int D>
void drop_duplicates(const Mesh<D>& mesh, const Facet<D>& nodes, std::vector<ElementSide>& sides,
                     Tallies& tallies) {
    const auto opposite = [&](const ElementSide& s) {
        return mesh.elements[s.element][s.opposite];
    };
    if (sides.size() == 2 && opposite(sides[0]) != opposite(sides[1])) {
        return; // as in a valid mesh
    }
    std::stable_sort(sides.begin(), sides.end(), [&](const ElementSide& a, const ElementSide& b) {
        return opposite(a) < opposite(b);
    });
    std::size_t kept = 0;
    for (const ElementSide& side : sides) {
        if (kept == 0 || opposite(sides[kept - 1]) != opposite(side)) {
            sides[kept++] = side;
        } else if (opposite(side) > nodes.back()) {
            // Duplicates share all their facets; they are counted at one of them.
            tallies.add(Defect::duplicate_element, sides[kept - 1].element.value(),
                        side.element.value());
        }
    }
    sides.resize(kept);
    std::sort(sides.begin(), sides.end(),
              [](const ElementSide& a, const ElementSide& b) { return a.element < b.element; });
}

template <int D>
void test_sides(const Mesh<D>& mesh, const std::vector<ElementSide>& sides, Tallies& tallies) {
    if (sides.size() < 2) {
        return;
    }
    bool wrong = sides.size() > 2;
    if (sides.size() == 2) {
        const Facet<D> a = facet_of<D>(mesh.elements[sides[0].element], sides[0].opposite);
        const Facet<D> b = facet_of<D>(mesh.elements[sides[1].element], sides[1].opposite);
        // Elements whose orientation is wrong are reported as such, not once more for each facet.
        wrong = !oppositely_oriented(a, b) &&
                orientation(mesh, mesh.elements[sides[0].element]) > 0 &&
                orientation(mesh, mesh.elements[sides[1].element]) > 0;
    }
    if (wrong) {
        tallies.add(Defect::facet_shared_too_often, sides[0].element.value(),
                    sides[1].element.value());
    }
}

template <int D>
void test_faces(const Mesh<D>& mesh, const FacetUses<D>& uses,
                const std::vector<ElementSide>& sides, Tallies& tallies,
                std::vector<char>& on_boundary) {
    for (std::size_t i = 1; i < uses.faces.size(); ++i) {
        tallies.add(Defect::duplicate_face, uses.faces[0].value(), uses.faces[i].value());
    }
    if (sides.empty()) {
        tallies.add(Defect::face_without_element, uses.faces[0].value());
    } else if (sides.size() >= 2) {
        tallies.interior_faces += static_cast<std::int64_t>(uses.faces.size());
    } else if (uses.faces.empty()) {
        tallies.add(Defect::boundary_without_face, sides[0].element.value(), sides[0].opposite);
    } else {
        on_boundary[uses.faces[0].index()] = 1;
        for (const FaceId f : uses.faces) {
            if (points_inward<D>(mesh, sides[0], mesh.faces[f])) {
                tallies.add(Defect::face_turned_inward, f.value());
            }
        }
    }
}

/// \param[out] on_boundary  [k] 1 for faces with an element on one side only, once per facet
template <int D>
void test_facets(const Mesh<D>& mesh, Tallies& tallies, std::vector<char>& on_boundary) {
    on_boundary.assign(mesh.faces.size(), 0);
    const FacetTable<D> table(mesh);
    tally_in_parallel(mesh.points.size(), tallies,
                      [&](std::size_t begin, std::size_t end, Tallies& piece) {
                          std::vector<ElementSide> sides;
                          table.visit(begin, end, [&](const FacetUses<D>& uses) {
                              sides.assign(uses.sides.begin(), uses.sides.end());
                              if (sides.size() > 1) {
                                  drop_duplicates<D>(mesh, uses.nodes, sides, piece);
                              }
                              test_sides<D>(mesh, sides, piece);
                              test_faces(mesh, uses, sides, piece, on_boundary);
                          });
                      });
}

// --- the boundary as a whole -------------------------------------------------------------------

void test_face_count(std::size_t faces, std::int32_t v, std::int32_t w, Tallies& tallies) {
    if (faces % 2 == 1) {
        tallies.add(Defect::boundary_not_closed, v, w);
    }
    if (faces > 2) {
        tallies.add(Defect::boundary_not_manifold, v, w);
    }
}

/// The boundary edges at a node of a 3-D mesh, and the fans its faces form across them.
class NodeFans {
public:
    void test(const Mesh<3>& mesh, NodeId v, std::span<const FaceId> ball, Tallies& tallies) {
        spokes_.clear();
        for (std::size_t i = 0; i < ball.size(); ++i) {
            for (const NodeId w : mesh.faces[ball[i]]) {
                if (w != v) {
                    spokes_.emplace_back(w, i);
                }
            }
        }
        std::sort(spokes_.begin(), spokes_.end());
        root_.resize(ball.size());
        std::iota(root_.begin(), root_.end(), std::size_t{0});
        std::size_t fans = ball.size();
        for (std::size_t i = 0; i < spokes_.size();) {
            std::size_t j = i + 1;
            for (; j < spokes_.size() && spokes_[j].first == spokes_[i].first; ++j) {
                fans -= unite(spokes_[i].second, spokes_[j].second) ? 1 : 0;
            }
            if (v < spokes_[i].first) { // each edge once
                test_face_count(j - i, v.value(), spokes_[i].first.value(), tallies);
            }
            i = j;
        }
        if (fans > 1) {
            tallies.add(Defect::node_not_manifold, v.value(), static_cast<std::int32_t>(fans));
        }
    }

private:
    std::size_t find(std::size_t i) {
        while (root_[i] != i) {
            i = root_[i] = root_[root_[i]];
        }
        return i;
    }
    bool unite(std::size_t i, std::size_t j) {
        i = find(i);
        j = find(j);
        root_[std::max(i, j)] = std::min(i, j);
        return i != j;
    }

    std::vector<std::pair<NodeId, std::size_t>> spokes_; ///< (other end, face in the ball)
    std::vector<std::size_t> root_;
};

template <int D>
void test_boundary(const Mesh<D>& mesh, const std::vector<char>& on_boundary, Tallies& tallies) {
    const auto ball = file_under<NodeId, FaceId>(
        mesh.points.size(), mesh.faces.size(), [&](FaceId f) -> std::span<const NodeId> {
            const std::span<const NodeId> nodes(mesh.faces[f]);
            return nodes.first(on_boundary[f.index()] != 0 ? nodes.size() : 0);
        });
    tally_in_parallel(mesh.points.size(), tallies,
                      [&](std::size_t begin, std::size_t end, Tallies& piece) {
                          NodeFans fans;
                          for (std::size_t i = begin; i < end; ++i) {
                              const NodeId v(i);
                              if constexpr (D == 3) {
                                  fans.test(mesh, v, ball[v], piece);
                              } else {
                                  test_face_count(ball[v].size(), v.value(), 0, piece);
                              }
                          }
                      });
}

// --- volumes -----------------------------------------------------------------------------------

/// Flux of x / D through the boundary faces, about the middle of the domain so that little cancels.
template <int D>
Tallies boundary_flux(const Mesh<D>& mesh, const std::vector<char>& on_boundary) {
    Vec<D> low = mesh.points.raw().front();
    Vec<D> high = low;
    for (const Vec<D>& x : mesh.points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    const Vec<D> middle = low / 2 + high / 2;
    Tallies flux;
    for (const FaceId f : mesh.faces.ids()) {
        if (on_boundary[f.index()] == 0) {
            continue;
        }
        std::array<Vec<D>, D + 1> cone;
        cone[0] = middle;
        for (int i = 0; i < D; ++i) {
            cone[i + 1] = mesh.points[mesh.faces[f][i]];
        }
        const Volume v = volume(cone);
        flux.volume.add(v.value);
        flux.magnitude.add(v.magnitude);
    }
    return flux;
}

template <int D>
std::string volume_example(const CheckReport& report) {
    return std::string(D == 3 ? "volumes" : "areas") + " add up to " +
           std::to_string(report.volume) + ", the flux through the boundary is " +
           std::to_string(report.boundary_flux);
}

template <int D>
std::string example(const Mesh<D>& mesh, Defect defect, const Tally::Key& key) {
    const ElementId e(key[0]);
    const FaceId f(key[0]);
    const std::string first = std::to_string(key[0]);
    const std::string second = std::to_string(key[1]);
    switch (defect) {
    case Defect::not_finite:
        return "node " + first;
    case Defect::repeated_node:
        return key[1] == 0 ? describe(mesh, e) : describe(mesh, f);
    case Defect::duplicate_element:
        return "elements " + first + " and " + second + " (" + list(mesh.elements[e]) + ")";
    case Defect::inverted_element:
    case Defect::flat_element:
        return describe(mesh, e);
    case Defect::orphan_node:
        return "node " + first;
    case Defect::facet_shared_too_often:
        return describe(mesh, e) + " and " + describe(mesh, ElementId(key[1]));
    case Defect::boundary_without_face:
        return "the side of " + describe(mesh, e) + " on " +
               list(facet_of<D>(mesh.elements[e], key[1]));
    case Defect::face_without_element:
    case Defect::face_turned_inward:
        return describe(mesh, f);
    case Defect::duplicate_face:
        return "faces " + first + " and " + second + " (" + list(mesh.faces[f]) + ")";
    case Defect::boundary_not_closed:
    case Defect::boundary_not_manifold:
        return D == 3 ? "edge (nodes " + first + " " + second + ")" : "node " + first;
    case Defect::node_not_manifold:
        return "node " + first + ", where " + second + " fans of boundary faces touch";
    default:
        return {};
    }
}

template <int D>
void report_findings(const Mesh<D>& mesh, const Tallies& tallies, CheckReport& report) {
    for (std::size_t i = 0; i < defect_count; ++i) {
        const auto defect = static_cast<Defect>(i);
        const Tally& tally = tallies[defect];
        if (tally.count > 0) {
            auto& findings = defect == Defect::orphan_node ? report.warnings : report.errors;
            findings.push_back({defect, tally.count, example(mesh, defect, tally.first)});
        }
    }
}

} // namespace

std::string_view name(Defect defect) {
    constexpr std::array<std::string_view, defect_count> names{
        "no elements",
        "reference out of range",
        "coordinate that is not a finite number",
        "repeated node",
        "duplicate element",
        "inverted element",
        "flat element",
        "node without element",
        "facet shared too often",
        "boundary facet without face",
        "face without element",
        "duplicate face",
        "face turned inward",
        "boundary not closed",
        "non-manifold boundary",
        "non-manifold boundary node",
        "volumes do not add up"};
    return names[static_cast<std::size_t>(defect)];
}

std::string CheckReport::summary() const {
    std::string text;
    for (const Finding& finding : errors) {
        text += text.empty() ? "" : "; ";
        text += std::to_string(finding.count) + " x " + std::string(name(finding.defect));
        if (!finding.example.empty()) {
            text += ", first: " + finding.example;
        }
    }
    return text;
}

template <int D>
CheckReport check(const Mesh<D>& mesh) {
    CheckReport report;
    if (mesh.elements.empty()) {
        report.errors.push_back({Defect::no_elements, 1, {}});
        return report;
    }
    if (BadReferences bad = find_bad_references(mesh); bad.count > 0) {
        report.errors.push_back({Defect::node_out_of_range, bad.count, std::move(bad.example)});
        return report;
    }
    Tallies tallies;
    test_nodes(mesh, tallies);
    if (tallies.any()) {
        report_findings(mesh, tallies, report);
        return report;
    }
    test_elements(mesh, tallies);
    test_for_orphans(mesh, tallies);
    std::vector<char> on_boundary;
    test_facets(mesh, tallies, on_boundary);
    test_boundary(mesh, on_boundary, tallies);
    const Tallies flux = boundary_flux(mesh, on_boundary);
    report.interior_faces = tallies.interior_faces;
    report.volume = tallies.volume.value();
    report.boundary_flux = flux.volume.value();
    report_findings(mesh, tallies, report);

    const double bound = volume_error_bound * (tallies.magnitude.value() + flux.magnitude.value());
    // Written so that an overflow, which makes the difference NaN, is a defect as well.
    if (report.valid() && !(std::abs(report.volume - report.boundary_flux) <= bound)) {
        report.errors.push_back({Defect::volumes_do_not_add_up, 1, volume_example<D>(report)});
    }
    return report;
}

template CheckReport check(const Mesh<2>&);
template CheckReport check(const Mesh<3>&);

} // namespace ameco
