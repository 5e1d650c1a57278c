// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/pictures.h"

#include "core/hierarchy/hierarchy_folder.h"
#include "core/io/atomic_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

#include <Eigen/Geometry>

namespace ameco {
namespace {

/// Distinguishable without colour vision; finest level first.
constexpr std::array<const char*, 8> colours{"#1f4e79", "#d95f02", "#1b9e77", "#7570b3",
                                             "#e6ab02", "#a6761d", "#666666", "#e7298a"};

std::string number(double value, int decimals = 2) {
    char text[64];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
    return {text, end.ptr};
}

std::string short_number(double value) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3);
    return {text, end.ptr};
}

std::string open_svg(double width, double height) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width, 0) +
           "\" height=\"" + number(height, 0) + "\" viewBox=\"0 0 " + number(width, 0) + " " +
           number(height, 0) +
           "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
           "fill=\"#ffffff\"/>\n";
}

std::string text_at(double x, double y, const std::string& text, const char* anchor = "start") {
    return "<text x=\"" + number(x, 1) + "\" y=\"" + number(y, 1) + "\" text-anchor=\"" + anchor +
           "\" fill=\"#222222\">" + text + "</text>\n";
}

/// The triangles a section is looked for among, with the patch each is on.
template <class Visit>
void for_each_triangle(const Mesh<2>& mesh, const Visit& visit) {
    for (const Simplex<2>& s : mesh.elements) {
        visit(s, 0);
    }
}

template <class Visit>
void for_each_triangle(const Mesh<3>& mesh, const Visit& visit) {
    for (const FaceId f : mesh.faces.ids()) {
        visit(mesh.faces[f], mesh.patch[f]);
    }
}

Vec<3> normal(const Mesh<3>& mesh, const Facet<3>& t) {
    return (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
}

/// Patches whose faces all lie in one plane.
std::set<int> planar_patches(const Mesh<2>&) {
    return {0};
}

std::set<int> planar_patches(const Mesh<3>& mesh) {
    std::map<int, Vec<3>> direction;
    std::set<int> planar(mesh.patch.begin(), mesh.patch.end());
    for (const FaceId f : mesh.faces.ids()) {
        const Vec<3> n = normal(mesh, mesh.faces[f]).normalized();
        const auto [it, first] = direction.emplace(mesh.patch[f], n);
        if (!first && it->second.dot(n) < 1 - 1e-9) {
            planar.erase(mesh.patch[f]);
        }
    }
    return planar;
}

/// Long edge and height of a triangle.
template <int D>
struct Shape {
    Vec<D> along = Vec<D>::Zero();  ///< longest edge
    Vec<D> across = Vec<D>::Zero(); ///< from it to the opposite node, at right angles
    NodeId foot;                    ///< a node of the longest edge
    [[nodiscard]] double aspect() const { return along.norm() / across.norm(); }
};

template <int D>
Shape<D> shape_of(const Mesh<D>& mesh, const std::array<NodeId, 3>& t) {
    Shape<D> shape;
    double longest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec<D> edge = mesh.points[t[(i + 1) % 3]] - mesh.points[t[i]];
        if (edge.norm() > longest) {
            longest = edge.norm();
            shape.along = edge;
            shape.foot = t[i];
            const Vec<D> to = mesh.points[t[(i + 2) % 3]] - mesh.points[t[i]];
            shape.across = to - edge * (to.dot(edge) / edge.squaredNorm());
        }
    }
    return shape;
}

/// Whether most of the nodes in the window and in its mirror image lie below the origin.
template <int D>
bool layers_are_below(const Mesh<D>& mesh, const SectionView<D>& view) {
    int below = 0, above = 0;
    for_each_triangle(mesh, [&](const auto& t, int patch) {
        if (D == 3 && patch != view.patch) {
            return;
        }
        for (const NodeId v : t) {
            const Vec<D> d = mesh.points[v] - view.origin;
            const double up = d.dot(view.across);
            if (std::abs(d.dot(view.along)) < view.width / 2 && std::abs(up) < view.height) {
                below += up < 0;
                above += up > 0;
            }
        }
    });
    return below > above;
}

} // namespace

std::string histogram_svg(const std::vector<AspectRatioClasses>& levels) {
    const std::size_t classes = levels.empty() ? 0 : levels[0].counts.size();
    constexpr double left = 60, top = 40, height = 300, group = 64;
    const double width = left + group * static_cast<double>(classes) + 20;
    std::vector<std::vector<double>> shares;
    double largest = 1e-9;
    for (const AspectRatioClasses& level : levels) {
        double total = 0;
        for (const std::int64_t n : level.counts) {
            total += static_cast<double>(n);
        }
        shares.emplace_back();
        for (const std::int64_t n : level.counts) {
            shares.back().push_back(100 * static_cast<double>(n) / std::max(1.0, total));
            largest = std::max(largest, shares.back().back());
        }
    }
    const double top_value = std::ceil(largest / 10) * 10;
    std::string svg = open_svg(width, top + height + 90);
    svg += text_at(left, 22, "Per cent of the nodes by aspect ratio");
    for (int i = 0; i <= 5; ++i) {
        const double y = top + height * (1 - i / 5.0);
        svg += "<path d=\"M" + number(left) + " " + number(y) + "H" + number(width - 20) +
               "\" stroke=\"#dddddd\"/>\n" +
               text_at(left - 6, y + 4, short_number(top_value * i / 5), "end");
    }
    const double bar = (group - 10) / static_cast<double>(std::max<std::size_t>(1, levels.size()));
    for (std::size_t c = 0; c < classes; ++c) {
        const double x = left + group * static_cast<double>(c) + 5;
        for (std::size_t k = 0; k < levels.size(); ++k) {
            const double h = height * shares[k][c] / top_value;
            svg += "<rect x=\"" + number(x + bar * static_cast<double>(k)) + "\" y=\"" +
                   number(top + height - h) + "\" width=\"" + number(bar) + "\" height=\"" +
                   number(h) + "\" fill=\"" + colours[k % colours.size()] + "\"/>\n";
        }
        svg += text_at(x + group / 2 - 5, top + height + 16, short_number(levels[0].upper(c)),
                       "middle");
        svg += text_at(x + group / 2 - 5, top + height + 30,
                       "to " + short_number(std::max(1.0, levels[0].lower(c))), "middle");
    }
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const double x = left + 110 * static_cast<double>(k);
        svg += "<rect x=\"" + number(x) + "\" y=\"" + number(top + height + 52) +
               "\" width=\"12\" height=\"12\" fill=\"" + colours[k % colours.size()] + "\"/>\n" +
               text_at(x + 18, top + height + 62, "level " + std::to_string(k));
    }
    return svg + "</svg>\n";
}

template <int D>
std::optional<SectionView<D>> find_section(const Mesh<D>& mesh) {
    const std::set<int> planar = planar_patches(mesh);
    Shape<D> best;
    SectionView<D> view;
    double largest = 0;
    for_each_triangle(mesh, [&](const auto& t, int patch) {
        if (planar.count(patch) == 0) {
            return;
        }
        const Shape<D> shape = shape_of(mesh, t);
        if (shape.across.norm() > 0 && shape.aspect() > largest) {
            largest = shape.aspect();
            best = shape;
            view.patch = patch;
        }
    });
    if (largest == 0) {
        return std::nullopt;
    }
    view.origin = mesh.points[best.foot];
    view.along = best.along.normalized();
    view.across = best.across.normalized();
    // A few cells wide and some tens of layers high: wider, the curvature of a wall would fill it.
    view.width = 2.4 * best.along.norm();
    view.height = 40 * best.across.norm();
    if (layers_are_below(mesh, view)) {
        view.across = -view.across;
    }
    return view;
}

template <int D>
SectionPanel draw_section(const Mesh<D>& mesh, const SectionView<D>& view,
                          const std::string& title) {
    SectionPanel panel{title, {}};
    for_each_triangle(mesh, [&](const auto& t, int patch) {
        if (D == 3 && patch != view.patch) {
            return;
        }
        std::array<double, 6> xy;
        std::array<double, 4> box{2, 2, -1, -1};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec<D> d = mesh.points[t[i]] - view.origin;
            xy[2 * i] = d.dot(view.along) / view.width + 0.5;
            xy[2 * i + 1] = d.dot(view.across) / view.height + 0.06;
            for (std::size_t a = 0; a < 2; ++a) {
                box[a] = std::min(box[a], xy[2 * i + a]);
                box[2 + a] = std::max(box[2 + a], xy[2 * i + a]);
            }
        }
        if (box[0] < 1 && box[1] < 1 && box[2] > 0 && box[3] > 0) {
            panel.triangles.push_back(xy);
        }
    });
    return panel;
}

std::string sections_svg(const std::vector<SectionPanel>& panels, double scale) {
    constexpr double side = 300, gap = 16, top = 56;
    const std::size_t columns = std::min<std::size_t>(3, std::max<std::size_t>(1, panels.size()));
    const std::size_t rows = (panels.size() + columns - 1) / columns;
    std::string svg = open_svg(gap + static_cast<double>(columns) * (side + gap),
                               top + static_cast<double>(rows) * (side + gap + 18));
    svg += text_at(gap, 24,
                   "Where the mesh is stretched most; view scaled " + short_number(scale) +
                       " times across the layers");
    svg += "<defs><clipPath id=\"w\"><rect width=\"" + number(side) + "\" height=\"" +
           number(side) + "\"/></clipPath></defs>\n";
    for (std::size_t k = 0; k < panels.size(); ++k) {
        const double x = gap + static_cast<double>(k % columns) * (side + gap);
        const double y = top + static_cast<double>(k / columns) * (side + gap + 18);
        svg += text_at(x, y - 6, panels[k].title);
        svg += "<g transform=\"translate(" + number(x) + " " + number(y) +
               ")\" clip-path=\"url(#w)\"><rect width=\"" + number(side) + "\" height=\"" +
               number(side) + "\" fill=\"#f4f6f8\"/><path fill=\"#ffffff\" stroke=\"" +
               colours[k % colours.size()] + "\" stroke-width=\"0.7\" d=\"";
        for (const auto& t : panels[k].triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                // Far outside the window the exact place is of no interest, and numbers stay short.
                svg += (i == 0 ? "M" : "L") + number(side * std::clamp(t[2 * i], -20.0, 20.0)) +
                       " " + number(side * (1 - std::clamp(t[2 * i + 1], -20.0, 20.0)));
            }
            svg += "Z";
        }
        svg += "\"/></g>\n";
    }
    return svg + "</svg>\n";
}

template <int D>
std::vector<std::string> write_pictures(const std::filesystem::path& folder,
                                        const Hierarchy& hierarchy) {
    std::vector<std::string> names;
    const auto write = [&](const std::string& name, const std::string& svg) {
        AtomicFile file(folder / name);
        file.write(svg.data(), svg.size());
        file.commit();
        names.push_back(name);
    };
    std::vector<AspectRatioClasses> classes;
    std::optional<SectionView<D>> view;
    std::vector<SectionPanel> panels;
    for (const HierarchyLevel& level : hierarchy.levels) {
        const int k = static_cast<int>(classes.size());
        classes.push_back(level.statistics.classes);
        const Mesh<D> mesh = read_level_mesh<D>(folder, hierarchy, k);
        if (k == 0) {
            view = find_section(mesh);
        }
        if (view) {
            panels.push_back(draw_section(mesh, *view,
                                          "level " + std::to_string(k) + ": " +
                                              std::to_string(level.statistics.nodes) + " nodes"));
        }
    }
    write("histogram.svg", histogram_svg(classes));
    if (view) {
        write("layers.svg", sections_svg(panels, view->width / view->height));
    }
    return names;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template std::optional<SectionView<D>> find_section(const Mesh<D>&);                           \
    template SectionPanel draw_section(const Mesh<D>&, const SectionView<D>&, const std::string&); \
    template std::vector<std::string> write_pictures<D>(const std::filesystem::path&,              \
                                                        const Hierarchy&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
