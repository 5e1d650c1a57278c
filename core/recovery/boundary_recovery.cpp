// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/recovery/boundary_recovery.h"

#include "core/base/child_process.h"
#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/mesh/boundary.h"
#include "core/mesh/check.h"
#include "core/mesh/facets.h"
#include "core/mesh/simplex.h"
#ifdef AMECO_WITH_TETGEN
#include "core/recovery/tetgen_run.h"
#endif

#include <algorithm>
#include <csignal>
#include <cstring>
#include <exception>
#include <map>
#include <new>
#include <regex>
#include <set>

namespace ameco {

#ifndef AMECO_WITH_TETGEN

bool can_recover() {
    return false;
}

Recovery recover_boundary(const Mesh<3>&, const RecoveryOptions&, const std::string& name,
                          Monitor&) {
    throw Error(ExitCode::not_built, name + ": this build has no TetGen to fill a surface with "
                                            "(Debian: libtet1.5-dev)");
}

#else

namespace {

// --- from the child to us ------------------------------------------------------------------------

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
    const std::size_t count = values.size();
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(T));
}

template <class T>
void take(const std::string& bytes, std::size_t& at, std::vector<T>& values) {
    std::size_t count = 0;
    if (bytes.size() - at < sizeof count) {
        throw Error(ExitCode::internal, "TetGen's result is cut off");
    }
    std::memcpy(&count, bytes.data() + at, sizeof count);
    at += sizeof count;
    if ((bytes.size() - at) / sizeof(T) < count) {
        throw Error(ExitCode::internal, "TetGen's result is cut off");
    }
    values.resize(count);
    if (count > 0) {
        std::memcpy(values.data(), bytes.data() + at, count * sizeof(T));
    }
    at += count * sizeof(T);
}

/// What the child says: 'm' and a mesh, 'e' and the code of an error, or 'o' for no more memory.
std::string work_in_child(const Mesh<3>& surface, const RecoveryOptions& options,
                          const std::string& switches) {
    try {
        const TetgenMesh mesh = run_tetgen(surface, options, switches);
        std::string bytes = "m";
        append(bytes, mesh.points);
        append(bytes, mesh.tets);
        append(bytes, mesh.regions);
        append(bytes, mesh.faces);
        append(bytes, mesh.markers);
        return bytes;
    } catch (int code) {
        return code == 1 ? "o" : "e" + std::to_string(code);
    } catch (const std::bad_alloc&) {
        return "o";
    }
}

TetgenMesh unpacked(const std::string& bytes) {
    TetgenMesh mesh;
    std::size_t at = 1;
    take(bytes, at, mesh.points);
    take(bytes, at, mesh.tets);
    take(bytes, at, mesh.regions);
    take(bytes, at, mesh.faces);
    take(bytes, at, mesh.markers);
    return mesh;
}

// --- words ---------------------------------------------------------------------------------------

/// What TetGen's text names: nodes in brackets, two for an edge, three for a face, with the marker
/// of the facet behind them: "[141, 142] 1", "[240,244,241] 453", "[1, 2, 3] #7".
struct NamedPlaces {
    std::set<int> faces;
    std::set<Edge> edges;
};

NamedPlaces named_places(const std::string& text, const Mesh<3>& surface) {
    static const std::regex place("\\[\\s*([0-9]{1,9})\\s*,\\s*([0-9]{1,9})\\s*"
                                  "(?:,\\s*([0-9]{1,9})\\s*)?\\]\\s*#?([0-9]{1,9})?");
    std::map<Facet<3>, FaceId> by_nodes;
    for (const FaceId f : surface.faces.ids()) {
        by_nodes[sorted(surface.faces[f])] = f;
    }
    NamedPlaces named;
    for (auto m = std::sregex_iterator(text.begin(), text.end(), place);
         m != std::sregex_iterator(); ++m) {
        const auto number = [&](std::size_t group) { return std::stoi((*m)[group].str()); };
        const NodeId a(number(1)), b(number(2));
        if (!(*m)[3].matched) {
            if (std::max(a, b).index() < surface.points.size()) {
                named.edges.insert(sorted(Edge{a, b}));
            }
            continue;
        }
        const auto face = by_nodes.find(sorted(Facet<3>{a, b, NodeId(number(3))}));
        if (face != by_nodes.end()) {
            named.faces.insert(face->second.value());
        } else if ((*m)[4].matched && number(4) >= 1 &&
                   static_cast<std::size_t>(number(4)) <= surface.faces.size()) {
            named.faces.insert(number(4) - 1); // a piece of it
        }
    }
    return named;
}

std::string place_text(const std::string& output, const Mesh<3>& surface) {
    constexpr int most = 8;
    const NamedPlaces named = named_places(output, surface);
    std::string list;
    int shown = 0;
    const auto add = [&](const std::string& what) {
        if (shown < most) {
            list += (shown == 0 ? "" : ", ") + what;
        }
        ++shown;
    };
    for (const int f : named.faces) {
        add("face " + std::to_string(f));
    }
    for (const Edge& e : named.edges) {
        add("edge " + std::to_string(e[0].value()) + "-" + std::to_string(e[1].value()));
    }
    return list.empty() ? "" : "; it names " + list + (shown > most ? ", ..." : "");
}

std::string meaning_of(int code) {
    switch (code) {
    case 2:
        return "a bug of its own";
    case 3:
        return "faces that intersect or nearly do";
    case 4:
        return "a feature too small for its precision";
    case 5:
        return "two faces that nearly coincide";
    case 10:
        return "input that it does not accept";
    default:
        return "error " + std::to_string(code);
    }
}

/// One run in a child process.
/// \throws as `recover_boundary` does
TetgenMesh try_switches(const Mesh<3>& surface, const RecoveryOptions& options,
                        const std::string& switches, const std::string& name, Monitor& monitor) {
    const ChildOutcome outcome =
        run_in_child([&] { return work_in_child(surface, options, switches); },
                     {.keep_output = true, .monitor = &monitor, .step = "filling the volume"});
    if (outcome.stopped || (outcome.signal == SIGINT && monitor.stop_requested())) {
        throw Cancelled();
    }
    if (!outcome.started) {
        throw Error(ExitCode::memory, name + ": there is no process to be had for TetGen");
    }
    const std::string place = place_text(outcome.output, surface);
    if (outcome.signal == SIGKILL || (outcome.survived && outcome.result.front() == 'o')) {
        throw Error(ExitCode::memory, name + ": not enough memory to fill it");
    }
    if (!outcome.survived) {
        throw InputError(name + ": TetGen breaks down over it" + place);
    }
    if (outcome.result.front() == 'e') {
        throw InputError(name + ": TetGen finds " +
                         meaning_of(std::stoi(outcome.result.substr(1))) + place);
    }
    return unpacked(outcome.result);
}

// --- the mesh ------------------------------------------------------------------------------------

Mesh<3> mesh_of(const Mesh<3>& surface, const TetgenMesh& t, GivenFaces given) {
    Mesh<3> mesh;
    mesh.patch_names = surface.patch_names;
    mesh.features = surface.features;
    mesh.points.reserve(t.points.size() / 3);
    for (std::size_t i = 0; i + 2 < t.points.size(); i += 3) {
        mesh.points.push_back({t.points[i], t.points[i + 1], t.points[i + 2]});
    }
    mesh.elements.reserve(t.tets.size() / 4);
    for (std::size_t i = 0; i + 3 < t.tets.size(); i += 4) {
        mesh.elements.push_back({NodeId(t.tets[i]), NodeId(t.tets[i + 1]), NodeId(t.tets[i + 2]),
                                 NodeId(t.tets[i + 3])});
        mesh.region.push_back(t.regions.empty() ? 1 : t.regions[i / 4]);
    }
    if (given == GivenFaces::keep) {
        mesh.faces = surface.faces;
        mesh.patch = surface.patch;
        return mesh;
    }
    for (std::size_t i = 0; i < t.markers.size(); ++i) {
        const int face = t.markers[i] - 1;
        if (face >= 0 && static_cast<std::size_t>(face) < surface.faces.size()) {
            mesh.faces.push_back(
                {NodeId(t.faces[3 * i]), NodeId(t.faces[3 * i + 1]), NodeId(t.faces[3 * i + 2])});
            mesh.patch.push_back(surface.patch[FaceId(face)]);
        }
    }
    return mesh;
}

/// \throws CheckFailed  a given face is no facet of a tet
void require_faces(const Mesh<3>& mesh, const std::string& name) {
    std::vector<std::size_t> missing;
    FacetTable<3>(mesh).visit(0, mesh.points.size(), [&](const FacetUses<3>& uses) {
        for (const FaceId f : uses.faces) {
            if (uses.sides.empty()) {
                missing.push_back(f.index());
            }
        }
    });
    if (!missing.empty()) {
        std::sort(missing.begin(), missing.end());
        std::string list;
        for (std::size_t i = 0; i < std::min<std::size_t>(8, missing.size()); ++i) {
            list += (i == 0 ? "" : ", ") + std::to_string(missing[i]);
        }
        throw CheckFailed(name + ": TetGen lost " +
                          plural(static_cast<std::int64_t>(missing.size()), "face") +
                          " that it was to keep: " + list + (missing.size() > 8 ? ", ..." : ""));
    }
}

void require_same_nodes(const Mesh<3>& mesh, const Mesh<3>& surface, const std::string& name) {
    const std::size_t n = surface.points.size();
    if (mesh.points.size() < n ||
        !std::equal(surface.points.begin(), surface.points.end(), mesh.points.begin())) {
        throw CheckFailed(name + ": TetGen moved or lost nodes of the surface");
    }
}

Mesh<3> checked_mesh(const Mesh<3>& surface, const TetgenMesh& result, GivenFaces given,
                     const std::string& name) {
    if (result.tets.empty()) {
        throw InputError(name + ": nothing is left to fill: do the hole points lie in the volume, "
                                "or do the faces bound none?");
    }
    Mesh<3> mesh = mesh_of(surface, result, given);
    require_same_nodes(mesh, surface, name);
    if (given == GivenFaces::keep) {
        require_faces(mesh, name);
    } else {
        static_cast<void>(complete_boundary(mesh)); // turns the pieces of faces outwards
    }
    const CheckReport report = check(mesh);
    if (!report.valid()) {
        throw CheckFailed(name + ": what TetGen made of it is not valid: " + report.summary());
    }
    return mesh;
}

void require_finite(const Mesh<3>& surface, const std::string& name) {
    for (const NodeId v : surface.points.ids()) {
        if (!surface.points[v].allFinite()) { // TetGen would crash
            throw InputError(name + ": node " + std::to_string(v.value()) +
                             " has a coordinate that is no finite number");
        }
    }
}

} // namespace

bool can_recover() {
    return true;
}

Recovery recover_boundary(const Mesh<3>& surface, const RecoveryOptions& options,
                          const std::string& name, Monitor& monitor) {
    require_finite(surface, name);
    const Stopwatch watch;
    Recovery recovery;
    // Some surfaces come out only with other switches: TetGen's optimiser leaves a flat tet, or its
    // recovery gives up at one ordering of the points and not at another.
    const std::string plain = tetgen_switches(options);
    const std::vector<std::string> attempts{plain, plain + "O0", plain + "l"};
    std::exception_ptr first_failure;
    for (std::size_t i = 0;; ++i) {
        try {
            const TetgenMesh result = try_switches(surface, options, attempts[i], name, monitor);
            monitor.progress(0.8, "testing the mesh");
            recovery.mesh = checked_mesh(surface, result, options.faces, name);
            break;
        } catch (const Error& error) {
            const bool may_help =
                error.code() == ExitCode::invalid_input || error.code() == ExitCode::check_failed;
            if (!may_help) {
                throw;
            }
            first_failure = first_failure ? first_failure : std::current_exception();
            if (i + 1 == attempts.size()) {
                std::rethrow_exception(first_failure);
            }
            recovery.remarks.push_back(std::string(error.what()) + "; trying again");
        }
    }
    recovery.added_nodes =
        static_cast<std::int64_t>(recovery.mesh.points.size() - surface.points.size());
    recovery.seconds = watch.seconds();
    return recovery;
}

#endif

} // namespace ameco
