// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/references.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace ameco {
namespace {

/// The two ends of a reference in words, e.g. "corner" and "node".
struct Kind {
    const char* source;
    const char* target;
    std::size_t targets; ///< how many there are
};

void test(const Kind& kind, std::size_t source, std::int64_t target, BadReferences& bad) {
    if (target >= 0 && static_cast<std::size_t>(target) < kind.targets) {
        return;
    }
    if (bad.count++ == 0) {
        bad.example = std::string(kind.source) + ' ' + std::to_string(source) + " refers to " +
                      kind.target + ' ' + std::to_string(target) + ", but there are " +
                      std::to_string(kind.targets);
    }
}

constexpr std::size_t tuples_per_piece = 16384;

template <class Tuples>
void test_tuples(const Kind& kind, const Tuples& tuples, BadReferences& bad) {
    std::vector<BadReferences> pieces(tuples.size() / tuples_per_piece + 1);
    parallel_for(tuples.size(), tuples_per_piece, [&](std::size_t begin, std::size_t end) {
        BadReferences& piece = pieces[begin / tuples_per_piece];
        for (std::size_t source = begin; source < end; ++source) {
            for (const NodeId v : tuples.begin()[static_cast<std::ptrdiff_t>(source)]) {
                test(kind, source, v.value(), piece);
            }
        }
    });
    for (BadReferences& piece : pieces) {
        if (bad.count == 0) {
            bad.example = std::move(piece.example);
        }
        bad.count += piece.count;
    }
}

template <class Tuples, class Predicate>
bool any_of(const Tuples& tuples, const Predicate& predicate) {
    std::atomic<bool> found{false};
    parallel_for(tuples.size(), tuples_per_piece, [&](std::size_t begin, std::size_t end) {
        const auto at = [&](std::size_t i) {
            return tuples.begin() + static_cast<std::ptrdiff_t>(i);
        };
        if (std::any_of(at(begin), at(end), predicate)) {
            found.store(true, std::memory_order_relaxed);
        }
    });
    return found.load(std::memory_order_relaxed);
}

void test_nodes(const Kind& kind, const std::vector<NodeId>& nodes, BadReferences& bad) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        test(kind, i, nodes[i].value(), bad);
    }
}

void test_indices(const Kind& kind, const std::vector<int>& indices, BadReferences& bad) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
        test(kind, i, indices[i], bad);
    }
}

} // namespace

template <int D>
BadReferences find_bad_references(const Mesh<D>& mesh) {
    const std::size_t n = mesh.points.size();
    const std::size_t k = mesh.faces.size();
    const Features& features = mesh.features;
    // Lines are declared edges in 3-D and faces in 2-D.
    const char* const line = D == 3 ? "edge" : "face";
    const std::size_t lines = D == 3 ? features.edges.size() : k;
    BadReferences bad;
    test_tuples({"element", "node", n}, mesh.elements, bad);
    test_tuples({"face", "node", n}, mesh.faces, bad);
    test_tuples({"feature edge", "node", n}, features.edges, bad);
    test_nodes({"corner", "node", n}, features.corners, bad);
    test_nodes({"required node", "node", n}, features.required_nodes, bad);
    test_indices({"ridge", line, lines}, features.ridges, bad);
    test_indices({"required edge", line, lines}, features.required_edges, bad);
    test_indices({"required face", "face", k}, features.required_faces, bad);
    test_indices({"required element", "element", mesh.elements.size()}, features.required_elements,
                 bad);
    return bad;
}

template <int D>
bool is_computable(const Mesh<D>& mesh) {
    const auto repeats = [](const auto& nodes) { return has_repetition(nodes); };
    return find_bad_references(mesh).count == 0 &&
           std::all_of(mesh.points.begin(), mesh.points.end(),
                       [](const Vec<D>& x) { return x.allFinite(); }) &&
           !any_of(mesh.elements, repeats) && !any_of(mesh.faces, repeats);
}

template BadReferences find_bad_references(const Mesh<2>&);
template BadReferences find_bad_references(const Mesh<3>&);
template bool is_computable(const Mesh<2>&);
template bool is_computable(const Mesh<3>&);

} // namespace ameco
