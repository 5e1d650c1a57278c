// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/pictures.h"

#include "core/base/svg.h"
#include "core/base/text.h"
#include "core/hierarchy/hierarchy_folder.h"
#include "core/io/atomic_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <Eigen/Geometry>

namespace ameco {
namespace {

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
    constexpr double left = 60, top = 40, height = 300, group = 64, legend_step = 110;
    const double width = left + 20 +
                         std::max(group * static_cast<double>(classes),
                                  legend_step * static_cast<double>(levels.size()));
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
    std::string svg = svg::open(width, top + height + 90);
    svg += svg::text_at(left, 22, "Per cent of the nodes by aspect ratio");
    for (int i = 0; i <= 5; ++i) {
        const double y = top + height * (1 - i / 5.0);
        svg += "<path d=\"M" + svg::number(left) + " " + svg::number(y) + "H" +
               svg::number(width - 20) + "\" stroke=\"#dddddd\"/>\n" +
               svg::text_at(left - 6, y + 4, svg::short_number(top_value * i / 5), "end");
    }
    const double bar = (group - 10) / static_cast<double>(std::max<std::size_t>(1, levels.size()));
    for (std::size_t c = 0; c < classes; ++c) {
        const double x = left + group * static_cast<double>(c) + 5;
        for (std::size_t k = 0; k < levels.size(); ++k) {
            const double h = height * shares[k][c] / top_value;
            svg += "<rect x=\"" + svg::number(x + bar * static_cast<double>(k)) + "\" y=\"" +
                   svg::number(top + height - h) + "\" width=\"" + svg::number(bar) +
                   "\" height=\"" + svg::number(h) + "\" fill=\"" +
                   svg::colours[k % svg::colours.size()] + "\"/>\n";
        }
        svg += svg::text_at(x + group / 2 - 5, top + height + 16,
                            svg::axis_number(levels[0].upper(c)), "middle");
        svg += svg::text_at(x + group / 2 - 5, top + height + 30,
                            "to " + svg::axis_number(std::max(1.0, levels[0].lower(c))), "middle");
    }
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const double x = left + legend_step * static_cast<double>(k);
        svg += "<rect x=\"" + svg::number(x) + "\" y=\"" + svg::number(top + height + 52) +
               "\" width=\"12\" height=\"12\" fill=\"" + svg::colours[k % svg::colours.size()] +
               "\"/>\n" + svg::text_at(x + 18, top + height + 62, "level " + std::to_string(k));
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
    std::string svg = svg::open(gap + static_cast<double>(columns) * (side + gap),
                                top + static_cast<double>(rows) * (side + gap + 18));
    svg += svg::text_at(gap, 24,
                        "Where the mesh is stretched most; view scaled " +
                            svg::short_number(scale) + " times across the layers");
    svg += "<defs><clipPath id=\"w\"><rect width=\"" + svg::number(side) + "\" height=\"" +
           svg::number(side) + "\"/></clipPath></defs>\n";
    for (std::size_t k = 0; k < panels.size(); ++k) {
        const double x = gap + static_cast<double>(k % columns) * (side + gap);
        const double y = top + static_cast<double>(k / columns) * (side + gap + 18);
        svg += svg::text_at(x, y - 6, panels[k].title);
        svg += "<g transform=\"translate(" + svg::number(x) + " " + svg::number(y) +
               ")\" clip-path=\"url(#w)\"><rect width=\"" + svg::number(side) + "\" height=\"" +
               svg::number(side) + "\" fill=\"#f4f6f8\"/><path fill=\"#ffffff\" stroke=\"" +
               svg::colours[k % svg::colours.size()] + "\" stroke-width=\"0.7\" d=\"";
        for (const auto& t : panels[k].triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                // Far outside the window the exact place is of no interest, and numbers stay short.
                svg += (i == 0 ? "M" : "L") +
                       svg::number(side * std::clamp(t[2 * i], -20.0, 20.0)) + " " +
                       svg::number(side * (1 - std::clamp(t[2 * i + 1], -20.0, 20.0)));
            }
            svg += "Z";
        }
        svg += "\"/></g>\n";
    }
    return svg + "</svg>\n";
}

template <int D>
void LayerPictures<D>::add(const Mesh<D>& mesh, const LevelStatistics& level) {
    if (level.level == 0) {
        view_ = find_section(mesh);
    }
    if (view_) {
        panels_.push_back(draw_section(mesh, *view_,
                                       "level " + std::to_string(level.level) + ": " +
                                           plural(level.nodes, "node")));
    }
}

template <int D>
std::string LayerPictures<D>::svg() const {
    return view_ ? sections_svg(panels_, view_->width / view_->height) : "";
}

template <int D>
std::vector<std::string> write_pictures(const std::filesystem::path& folder,
                                        const Hierarchy& hierarchy) {
    std::vector<std::string> names;
    const auto write = [&](const std::string& name, const std::string& svg) {
        write_whole_file(folder / name, svg);
        names.push_back(name);
    };
    std::vector<AspectRatioClasses> classes;
    LayerPictures<D> layers;
    for (const HierarchyLevel& level : hierarchy.levels) {
        classes.push_back(level.statistics.classes);
        layers.add(read_level_mesh<D>(folder, hierarchy, level.statistics.level), level.statistics);
    }
    write("histogram.svg", histogram_svg(classes));
    if (const std::string svg = layers.svg(); !svg.empty()) {
        write("layers.svg", svg);
    }
    return names;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template std::optional<SectionView<D>> find_section(const Mesh<D>&);                           \
    template SectionPanel draw_section(const Mesh<D>&, const SectionView<D>&, const std::string&); \
    template class LayerPictures<D>;                                                               \
    template std::vector<std::string> write_pictures<D>(const std::filesystem::path&,              \
                                                        const Hierarchy&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
