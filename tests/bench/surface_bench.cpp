// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Surfaces filled and checked, and levels made anew by TetGen beside those made by local
/// operations. Prints the two tables of docs/theory/surfaces.md:
///
///     surface_bench [--fill] [--levels] [CASE...]
///
/// Seconds are CPU time with that of TetGen's process. A distance is the larger of both directions
/// between the boundary of a mesh and the surface that was given, over the diagonal of the box
/// around that. The jet comes from AMECO_SHARED_DIR; where that is absent, its rows are left out.
#include "core/cases/cube.h"
#include "core/cases/icosphere.h"
#include "core/cases/layer.h"
#include "core/cases/onera_m6.h"
#include "core/hierarchy/build_hierarchy.h"
#include "core/io/io.h"
#include "core/multigrid/study.h"
#include "core/recovery/fill.h"
#include "core/surface/boundary_surface.h"
#include "core/surface/surface_distance.h"
#include "core/surface/surface_repair.h"
#include "core/surface/surface_report.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

using namespace ameco;

namespace {

namespace fs = std::filesystem;

double cpu_seconds() {
    double sum = 0;
    for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(who, &usage);
        for (const timeval& t : {usage.ru_utime, usage.ru_stime}) {
            sum += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
        }
    }
    return sum;
}

/// An ellipsoid with 20 frequency^2 faces.
Mesh<3> make_ellipsoid(const Vec<3>& axes, int frequency, double radius = 1) {
    const SphereSurface sphere = icosphere(frequency, 0, 0, 1);
    Mesh<3> mesh;
    for (const Vec<3>& x : sphere.points) {
        mesh.points.push_back(radius * x.cwiseProduct(axes));
    }
    for (const auto& [a, b, c] : sphere.triangles) {
        mesh.faces.push_back({NodeId(a), NodeId(b), NodeId(c)});
        mesh.patch.push_back(1);
    }
    return mesh;
}

/// A cube of edge 2 around the origin, with a cylinder of radius 0.5 along z bored through it:
/// genus 1. `n` edges around the cylinder, a multiple of 8.
Mesh<3> make_bored_cube(int n) {
    const int across = n / 8, along = n / 4; // cells from the cylinder to the sides, and along z
    const auto point = [&](int i, int j, int k) -> Vec<3> {
        const double angle = 2 * std::numbers::pi * i / n;
        const Vec<3> u(std::cos(angle), std::sin(angle), 0);
        const double outer = 1 / std::max(std::abs(u[0]), std::abs(u[1]));
        const double r = 0.5 + (outer - 0.5) * j / across;
        return r * u + Vec<3>(0, 0, -1 + 2.0 * k / along);
    };
    Mesh<3> mesh;
    std::map<std::array<int, 3>, NodeId> number;
    const auto node = [&](int i, int j, int k) {
        const auto [place, is_new] = number.try_emplace({i % n, j, k}, mesh.points.next_id());
        if (is_new) {
            mesh.points.push_back(point(i % n, j, k));
        }
        return place->second;
    };
    const auto quad = [&](NodeId a, NodeId b, NodeId c, NodeId d, int patch) {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
        mesh.patch.push_back(patch);
        mesh.patch.push_back(patch);
    };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < across; ++j) { // top and bottom
            quad(node(i, j, along), node(i, j + 1, along), node(i + 1, j + 1, along),
                 node(i + 1, j, along), 1);
            quad(node(i, j, 0), node(i + 1, j, 0), node(i + 1, j + 1, 0), node(i, j + 1, 0), 2);
        }
        const int side = ((i + n / 8) / (n / 4)) % 4;
        for (int k = 0; k < along; ++k) { // outside, and in the bore
            quad(node(i, across, k), node(i + 1, across, k), node(i + 1, across, k + 1),
                 node(i, across, k + 1), 3 + side);
            quad(node(i, 0, k), node(i, 0, k + 1), node(i + 1, 0, k + 1), node(i + 1, 0, k), 7);
        }
    }
    return mesh;
}

/// Two spheres of 50,000 triangles each, by way of an STL file, which has no common nodes.
Mesh<3> stl_of_two_spheres() {
    Mesh<3> two = make_ellipsoid({1, 1, 1}, 50);
    const Mesh<3> second = make_ellipsoid({1, 1, 1}, 50);
    const int first_nodes = static_cast<int>(two.points.size());
    for (const Vec<3>& x : second.points) {
        two.points.push_back(x + Vec<3>(3, 0, 0));
    }
    for (const Facet<3>& f : second.faces) {
        two.faces.push_back({NodeId(f[0].value() + first_nodes), NodeId(f[1].value() + first_nodes),
                             NodeId(f[2].value() + first_nodes)});
        two.patch.push_back(1);
    }
    const fs::path file =
        fs::temp_directory_path() / ("surface_bench_" + std::to_string(getpid()) + ".stl");
    write_mesh(file, two);
    Mesh<3> read = std::get<Mesh<3>>(read_mesh(file, {.surfaces = true}).mesh);
    fs::remove(file);
    repair_surface(read);
    return read;
}

std::optional<Mesh<3>> jet() {
    const fs::path file = fs::path(AMECO_SHARED_DIR) / "meshes/falcon_full_surface.msh";
    if (!fs::exists(file)) {
        return std::nullopt;
    }
    Mesh<3> surface = std::get<Mesh<3>>(read_mesh(file, {.surfaces = true}).mesh);
    repair_surface(surface);
    return surface;
}

Mesh<3> wing(const std::string& preset) {
    const auto& all = onera_m6_presets();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == preset; });
    return make_onera_m6(found->options);
}

/// What is chosen on the command line; nothing: everything.
struct Wishes {
    bool fill = false, levels = false;
    std::set<std::string> names;

    [[nodiscard]] bool want(const std::string& name) const {
        return names.empty() || names.count(name) > 0;
    }
};

/// The distance between two surfaces over the diagonal of the second one's box: what was found, and
/// the bound that nothing exceeds where that is much larger.
std::string distance(const Mesh<3>& a, const Mesh<3>& b, double diagonal) {
    const SurfaceDistance d = surface_distance(a, b, 1e-4 * diagonal);
    std::array<char, 64> text{};
    if (d.upper() > 1.2 * d.lower() && d.upper() > 1e-12 * diagonal) {
        std::snprintf(text.data(), text.size(), "%.1g .. %.1g", d.lower() / diagonal,
                      d.upper() / diagonal);
    } else {
        std::snprintf(text.data(), text.size(), "%.2g", d.upper() / diagonal);
    }
    return text.data();
}

double diagonal_of(const Mesh<3>& surface) {
    return inspect_surface(surface, false).diagonal();
}

struct Surface {
    std::string name, words;
    std::function<std::optional<Mesh<3>>()> make;
    FillOptions options;
};

std::vector<Surface> surfaces() {
    FillOptions around;
    around.farfield = Farfield{FarfieldShape::sphere, 200};
    FillOptions split;
    split.recovery.faces = GivenFaces::split;
    split.recovery.size = 0.1;
    const auto sphere = [] { return make_ellipsoid({1, 1, 1}, 20); };
    return {{"sphere", "sphere", sphere, {}},
            {"sphere-split", "sphere, `--boundary split --size 0.1`", sphere, split},
            {"ellipsoid",
             "ellipsoid, axes 1, 0.5, 0.1",
             [] {
                 return make_ellipsoid({1, 0.5, 0.1}, 20);
             },
             {}},
            {"bored-cube", "cube with a cylindrical hole", [] { return make_bored_cube(64); }, {}},
            {"m6",
             "ONERA M6 in its domain (`m6-67k`)",
             [] { return boundary_surface(wing("m6-67k")); },
             {}},
            {"jet", "business jet, inside", jet, {}},
            {"jet-around", "business jet, around, `sphere:200`", jet, around},
            {"stl", "two spheres, STL", stl_of_two_spheres, {}}};
}

void fill_one(const Surface& s) {
    const std::optional<Mesh<3>> surface = s.make();
    if (!surface) {
        std::fprintf(stderr, "%s: left out, AMECO_SHARED_DIR does not have it\n", s.name.c_str());
        return;
    }
    const double begin = cpu_seconds();
    const SurfaceReport report = inspect_surface(*surface);
    const double inspected = cpu_seconds();
    const Fill fill = fill_surface(*surface, s.options, s.name);
    const double filled = cpu_seconds();
    const CheckReport checked = check(fill.mesh);
    const double end = cpu_seconds();
    // A farfield is not of the surface.
    Mesh<3> boundary = fill.mesh;
    if (s.options.farfield) {
        const int last = *std::max_element(surface->patch.begin(), surface->patch.end());
        boundary.faces.clear();
        boundary.patch.clear();
        for (const FaceId f : fill.mesh.faces.ids()) {
            if (fill.mesh.patch[f] <= last) {
                boundary.faces.push_back(fill.mesh.faces[f]);
                boundary.patch.push_back(fill.mesh.patch[f]);
            }
        }
        boundary.elements.clear();
    } else {
        boundary = boundary_surface(fill.mesh);
    }
    std::int64_t genus = 0;
    for (const SurfacePart& part : report.parts) {
        genus += part.genus();
    }
    std::printf("| %s | %lld | %lld | %zu | %zu | %s | %.2f | %.2f | %.2f | %s |\n",
                s.words.c_str(), static_cast<long long>(report.faces),
                static_cast<long long>(genus), fill.mesh.points.size(), fill.mesh.elements.size(),
                distance(boundary, *surface, report.diagonal()).c_str(), inspected - begin,
                filled - inspected, end - filled, checked.valid() ? "yes" : "NO");
    std::fflush(stdout);
}

struct Case {
    std::string name, words;
    std::function<std::optional<Mesh<3>>()> make;
};

std::optional<Mesh<3>> filled(const std::optional<Mesh<3>>& surface, const FillOptions& options) {
    if (!surface) {
        return std::nullopt;
    }
    return fill_surface(*surface, options, "the surface").mesh;
}

Mesh<3> layers(double curvature) {
    LayerOptions options{.nx = 24, .ny = 24, .nz = 32, .aspect_ratio = 1e4};
    options.curvature = curvature;
    return make_layer<3>(options);
}

std::vector<Case> cases() {
    FillOptions around;
    around.farfield = Farfield{FarfieldShape::sphere, 200};
    FillOptions finer;
    finer.recovery.size = 0.1;
    return {
        {"jet", "jet, inside", [] { return filled(jet(), {}); }},
        {"jet-around", "jet, around", [around] { return filled(jet(), around); }},
        {"ellipsoid", "ellipsoid, axes 1, 0.5, 0.1",
         [] {
             return filled(make_ellipsoid({1, 0.5, 0.1}, 24), {});
         }},
        {"bored-cube", "cube with a hole", [finer] { return filled(make_bored_cube(64), finer); }},
        {"cube", "cube", [] { return make_cube<3>({.n = 16, .displace = 0.2}); }},
        {"layers", "layers, flat, aspect ratio 1e4", [] { return layers(0); }},
        {"bent-layers", "layers, bent", [] { return layers(2); }}};
}

/// Levels of a mesh, and what became of them.
struct Levels {
    std::vector<Mesh<3>> meshes;
    std::vector<Transfer> transfers;
    std::vector<double> in_band;
    bool valid = true;
    double seconds = 0;
    std::string fallbacks; ///< levels that were made by local operations all the same
};

/// Keeps the first words of warnings: the levels they are about.
class Warnings : public Monitor {
public:
    void message(Severity severity, std::string_view text) override {
        if (severity == Severity::warning) {
            levels += (levels.empty() ? "" : ", ") + std::string(text.substr(0, text.find(':')));
        }
    }
    void progress(double, std::string_view) override {}
    [[nodiscard]] bool stop_requested() const override { return false; }

    std::string levels;
};

Levels make_levels(const Mesh<3>& mesh, bool rebuild) {
    Levels levels;
    std::vector<IdVector<NodeId, NodeId>> parents;
    Warnings warnings;
    HierarchyOptions options;
    options.levels = 3;
    options.rebuild = rebuild;
    const double begin = cpu_seconds();
    build_hierarchy<3>(
        mesh, options,
        [&](const Level<3>& level, const LevelStatistics& statistics, const LevelTiming&) {
            levels.meshes.push_back(level.mesh);
            parents.push_back(level.parent);
            if (statistics.level > 0) {
                levels.in_band.push_back(100 * statistics.conformity.in_band);
            }
        },
        warnings);
    levels.seconds = cpu_seconds() - begin;
    for (std::size_t k = 0; k < levels.meshes.size(); ++k) {
        levels.valid = levels.valid && check(levels.meshes[k]).valid();
        if (k > 0) {
            levels.transfers.push_back(
                make_transfer(levels.meshes[k - 1], levels.meshes[k], parents[k]));
        }
    }
    levels.fallbacks = warnings.levels;
    return levels;
}

CycleStudy study(const Levels& levels) {
    const LevelEquations equations = level_equations(
        levels.meshes, levels.transfers, ModelProblem<3>{}, CoarseOperator::rediscretised);
    CycleOptions cycle;
    cycle.smoother.kind = SmootherKind::gauss_seidel;
    return study_cycle(equations, cycle,
                       restricted(unit_load(levels.meshes[0]), equations.unknowns[0]));
}

void print_levels(const Case& c, const Mesh<3>& mesh, bool rebuild) {
    const Levels levels = make_levels(mesh, rebuild);
    const std::string first =
        rebuild ? "" : c.words + ", " + std::to_string(mesh.points.size()) + " nodes";
    const std::string way = rebuild ? "rebuilt" : "local";
    std::printf("| %s | %s |", first.c_str(),
                (way + (levels.fallbacks.empty() ? "" : ", but " + levels.fallbacks)).c_str());
    for (std::size_t k = 1; k < levels.meshes.size(); ++k) {
        std::printf(" %zu", levels.meshes[k].points.size());
    }
    std::printf(" |");
    for (const double share : levels.in_band) {
        std::printf(" %.0f", share);
    }
    const Mesh<3> surface = boundary_surface(mesh);
    const CycleStudy s = study(levels);
    std::printf(
        " %% | %s | %.1f | %s | %.3f | %d |\n",
        distance(boundary_surface(levels.meshes.back()), surface, diagonal_of(surface)).c_str(),
        levels.seconds, levels.valid ? "yes" : "NO", s.factor, s.krylov.iterations);
    std::fflush(stdout);
}

Wishes wishes_from(int count, char** arguments) {
    Wishes wishes;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        if (word == "--fill") {
            wishes.fill = true;
        } else if (word == "--levels") {
            wishes.levels = true;
        } else {
            wishes.names.insert(word);
        }
    }
    if (!wishes.fill && !wishes.levels) {
        wishes.fill = wishes.levels = true;
    }
    return wishes;
}

} // namespace

int main(int count, char** arguments) {
    const Wishes wishes = wishes_from(count, arguments);
    if (wishes.fill) {
        std::printf("| surface | faces | genus | nodes | tets | distance | inspect [s] | fill [s] "
                    "| check [s] | valid |\n|---|---|---|---|---|---|---|---|---|---|\n");
        for (const Surface& s : surfaces()) {
            if (wishes.want(s.name)) {
                fill_one(s);
            }
        }
    }
    if (wishes.levels) {
        std::printf(
            "\n| case | way | nodes | in band | distance | seconds | valid | V(1,1) | CG |\n"
            "|---|---|---|---|---|---|---|---|---|\n");
        for (const Case& c : cases()) {
            if (!wishes.want(c.name)) {
                continue;
            }
            if (const std::optional<Mesh<3>> mesh = c.make()) {
                print_levels(c, *mesh, false);
                print_levels(c, *mesh, true);
            } else {
                std::fprintf(stderr, "%s: left out, AMECO_SHARED_DIR does not have it\n",
                             c.name.c_str());
            }
        }
    }
    return 0;
}
