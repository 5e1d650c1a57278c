// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/onera_m6.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cases/confocal.h"
#include "core/cases/random.h"
#include "core/cases/shuffle.h"
#include "core/cases/spacing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ameco {
namespace {

constexpr double root_chord = 0.8059; // [m]
constexpr double half_span = 1.1963;  // [m]
constexpr double radians = std::numbers::pi / 180;
const double leading_slope = std::tan(30.0 * radians); // dx/dy
const double trailing_slope = std::tan(15.8 * radians);

// Foci of the columns' hyperbolas, in chords: half a nose radius (0.0145 chord) behind the leading
// edge and half the radius of the rounded trailing edge before its end, as for an ellipse.
constexpr double focus_behind_nose = 0.00725;
constexpr double focus_before_tail = 0.00035;

enum Patch : int { patch_wing = 1, patch_symmetry = 2, patch_farfield = 3 };

double chord(double y) {
    return root_chord - (leading_slope - trailing_slope) * y;
}

/// Where a column starts: a point of the section at span y, its plane turned by `turn` about the
/// line z = 0 (0: upper side, pi: lower side, between: the tip's cap).
struct Foot {
    double y;            ///< [m]
    Vec<2> section;      ///< upper point of the section (x/c, z/c)
    double cosine, sine; ///< of the turn
    double thinning;     ///< first height over the common one
};

/// Numbers of the columns: sections from root to tip, each from the leading edge over the upper
/// side to the trailing edge and back below; then the cap's arcs, without the sides and both edges.
struct Numbering {
    int chord_cells, span_cells, cap_cells;

    [[nodiscard]] int around() const { return 2 * chord_cells; }
    [[nodiscard]] int columns() const {
        return around() * (span_cells + 1) + (cap_cells - 1) * (chord_cells - 1);
    }
    /// Column i of section j, 0 <= i <= 2 chord_cells.
    [[nodiscard]] int wing(int i, int j) const { return j * around() + i % around(); }
    /// Column i of arc p of the cap; p = 0 and p = cap_cells are the tip section's two sides.
    [[nodiscard]] int cap(int i, int p) const {
        if (p == 0 || i == 0 || i == chord_cells) {
            return wing(i, span_cells);
        }
        if (p == cap_cells) {
            return wing(around() - i, span_cells);
        }
        return around() * (span_cells + 1) + (p - 1) * (chord_cells - 1) + i - 1;
    }
};

Numbering numbering(const OneraM6Options& o) {
    return {o.chord_cells, o.span_cells, o.cap_cells};
}

/// Points of the section's upper side, from the leading to the trailing edge [chords].
std::vector<Vec<2>> section_points(const OneraM6Options& o) {
    const OneraD section(o.trailing_edge);
    constexpr double growth = 0.25; // of the spacing along the section
    const auto size = [&](double s) {
        return std::min({o.largest_size, o.leading_size + growth * s,
                         o.trailing_size + growth * (section.length() - s)});
    };
    std::vector<Vec<2>> points;
    for (const double s :
         equidistribute(section.length(), static_cast<std::size_t>(o.chord_cells), size)) {
        points.push_back(section(s));
    }
    return points;
}

/// Spans of the sections [m], finer towards the tip.
std::vector<double> section_spans(const OneraM6Options& o) {
    const auto size = [](double y) {
        return std::min(0.05 * half_span, 0.0067 * half_span + 0.25 * (half_span - y));
    };
    return equidistribute(half_span, static_cast<std::size_t>(o.span_cells), size);
}

/// First height at column i of section j over the common one.
double thinning(int i, int j, const OneraM6Options& o) {
    const double distance = std::hypot(i - o.chord_cells / 2, j - o.span_cells / 2);
    return std::min(1.0, o.thin_ratio * std::pow(1 + distance / o.thin_reach, o.thin_power));
}

std::vector<Foot> feet(const OneraM6Options& o) {
    const Numbering number = numbering(o);
    const std::vector<Vec<2>> section = section_points(o);
    const std::vector<double> spans = section_spans(o);
    const int n = o.chord_cells;
    std::vector<Foot> all(static_cast<std::size_t>(number.columns()));
    for (int j = 0; j <= o.span_cells; ++j) {
        for (int i = 0; i < number.around(); ++i) {
            const int upper = i <= n ? i : number.around() - i;
            all[static_cast<std::size_t>(number.wing(i, j))] = {
                spans[static_cast<std::size_t>(j)], section[static_cast<std::size_t>(upper)],
                i <= n ? 1.0 : -1.0, 0.0, i <= n ? thinning(i, j, o) : 1.0};
        }
    }
    for (int p = 1; p < o.cap_cells; ++p) {
        const double turn = std::numbers::pi * p / o.cap_cells;
        for (int i = 1; i < n; ++i) {
            all[static_cast<std::size_t>(number.cap(i, p))] = {half_span,
                                                               section[static_cast<std::size_t>(i)],
                                                               std::cos(turn), std::sin(turn), 1.0};
        }
    }
    return all;
}

/// Adds a quadrilateral a b c d, cut along a random diagonal; where a side has no length, a
/// triangle.
void add_cell(Wall<3>& wall, int a, int b, int c, int d, bool rising) {
    if (a == d) {
        wall.facets.push_back({a, b, c});
    } else if (b == c) {
        wall.facets.push_back({a, b, d});
    } else if (rising) {
        wall.facets.push_back({a, b, c});
        wall.facets.push_back({a, c, d});
    } else {
        wall.facets.push_back({a, b, d});
        wall.facets.push_back({b, c, d});
    }
}

Wall<3> wing_wall(const OneraM6Options& o) {
    const Numbering number = numbering(o);
    const auto rising = [&](int i, int j) {
        switch (o.diagonals) {
        case Diagonals::uniform:
            return true;
        case Diagonals::alternating:
            return (i + j) % 2 == 0;
        case Diagonals::columns:
        case Diagonals::random:
            break;
        }
        return mix({static_cast<std::uint64_t>(o.seed), 30, static_cast<std::uint64_t>(i),
                    static_cast<std::uint64_t>(j)}) %
                   2 ==
               0;
    };
    Wall<3> wall;
    wall.columns = static_cast<std::size_t>(number.columns());
    for (int j = 0; j < o.span_cells; ++j) {
        for (int i = 0; i < number.around(); ++i) {
            if (j ==
                0) { // the cell's edge a b on the root is opposite its first triangle's last node
                wall.sides.push_back({wall.facets.size(), 2, patch_symmetry});
            }
            add_cell(wall, number.wing(i, j), number.wing(i + 1, j), number.wing(i + 1, j + 1),
                     number.wing(i, j + 1), rising(i, j));
        }
    }
    for (int p = 0; p < o.cap_cells; ++p) {
        for (int i = 0; i < o.chord_cells; ++i) {
            add_cell(wall, number.cap(i, p), number.cap(i + 1, p), number.cap(i + 1, p + 1),
                     number.cap(i, p + 1), rising(i, o.span_cells + p));
        }
    }
    return wall;
}

/// Distances of the layers from the foot of a column of the given length.
std::vector<double> layer_distances(const OneraM6Options& o, double thinning, double length) {
    std::vector<double> distance{0};
    double common = o.first_height;          // height of the layer in columns that are not thinned
    double thin = o.first_height * thinning; // doubles from layer to layer until it is as high
    double height = 0;
    for (int k = 0; k < o.growth_layers; ++k) {
        height = std::min(common, thin);
        distance.push_back(distance.back() + height);
        common *= o.growth;
        thin *= 2;
    }
    if (distance.back() + height >= length) {
        throw UsageError("onera-m6: the first " + std::to_string(o.growth_layers) +
                         " layers already reach the far field: take fewer growth layers, a smaller "
                         "first height or a smaller growth");
    }
    const auto rest = static_cast<std::size_t>(o.layers - o.growth_layers);
    const double ratio = filling_ratio(height, length - distance.back(), rest);
    for (std::size_t k = 0; k < rest; ++k) {
        height *= ratio;
        distance.push_back(distance.back() + height);
    }
    distance.back() = length;
    return distance;
}

/// How much further apart the sections are at this distance from the wing: hardly within a tenth of
/// a chord, then in proportion to the distance.
double spread_at(double distance, const OneraM6Options& o) {
    const double begin = o.far_field / 40;
    const auto ramp = [begin](double d) { return d * d / (std::hypot(d, begin) + begin); };
    return 1 + (o.spread - 1) * ramp(distance) / ramp(o.far_field);
}

/// Puts the kept layers of a column into `points`, `stride` apart.
void place_column(const Foot& foot, const OneraM6Options& o, const std::vector<std::size_t>& kept,
                  double tail, Vec<3>* points, std::size_t stride) {
    const double c = chord(foot.y);
    const double focal = c * (tail - focus_before_tail - focus_behind_nose) / 2;
    const Vec<2> from_middle(foot.section[0] * c - (c * focus_behind_nose + focal),
                             foot.section[1] * c);
    const ConfocalColumn column(from_middle, focal);
    const std::vector<double> distance =
        layer_distances(o, foot.thinning, column.distance_to_ellipse(o.far_field));
    const double x0 = leading_slope * foot.y + foot.section[0] * c;
    const double r0 = foot.section[1] * c;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const double d = distance[kept[k]];
        const Vec<2> offset = column.offset(d);
        const double r = r0 + offset[1];
        points[k * stride] = {x0 + offset[0], foot.y * spread_at(d, o) + r * foot.sine,
                              r * foot.cosine};
    }
}

void require_sensible_layers(const OneraM6Options& o) {
    if (o.growth_layers >= o.layers) {
        throw UsageError("onera-m6: growth-layers is " + std::to_string(o.growth_layers) + " of " +
                         std::to_string(o.layers) + " layers: leave some to fill the far field");
    }
    // Where columns lag behind their neighbours for good, outer layers would be too steep.
    const double caught_up = o.thin_ratio * std::pow(2 / o.growth, o.growth_layers - 1);
    if (o.thin_ratio < 1 && caught_up < 1) {
        throw UsageError("onera-m6: thin-ratio is " + std::to_string(o.thin_ratio) +
                         ", but thinned heights, which double, do not become as high as the "
                         "others in " +
                         std::to_string(o.growth_layers) + " growth-layers: take more of either");
    }
}

} // namespace

Mesh<3> make_onera_m6(const OneraM6Options& o) {
    require_sensible_layers(o);
    const Wall<3> wall = wing_wall(o);
    const std::vector<Foot> start = feet(o);
    const std::vector<std::size_t> kept = kept_layers(static_cast<std::size_t>(o.layers), o.every);
    const double tail = start[static_cast<std::size_t>(o.chord_cells)].section[0];
    std::vector<Vec<3>> points(kept.size() * wall.columns);
    parallel_for(wall.columns, 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            place_column(start[c], o, kept, tail, points.data() + c, wall.columns);
        }
    });
    const int around = 2 * o.chord_cells;
    const auto seed = static_cast<std::uint64_t>(o.seed);
    const ColumnRank rank = column_rank(o.diagonals, seed, [around](std::size_t column) {
        const int c = static_cast<int>(column);
        return c % around + c / around;
    });
    Mesh<3> mesh = extrude(wall, std::move(points), rank, patch_wing, patch_farfield);
    mesh.patch_names = {
        {patch_wing, "wing"}, {patch_symmetry, "symmetry"}, {patch_farfield, "farfield"}};
    if (o.shuffle != 0) {
        shuffle(mesh, static_cast<std::uint64_t>(o.shuffle));
    }
    return mesh;
}

const std::vector<OneraM6Preset>& onera_m6_presets() {
    static const std::vector<OneraM6Preset> presets = [] {
        OneraM6Options small;
        small.chord_cells = 16;
        small.span_cells = 10;
        small.cap_cells = 4;
        small.layers = 20;
        small.growth_layers = 8;
        small.first_height = 1e-3;
        small.growth = 1.4;
        OneraM6Options medium;
        medium.chord_cells = 48;
        medium.span_cells = 36;
        medium.cap_cells = 8;
        medium.layers = 128;
        medium.growth_layers = 75;
        medium.first_height = 1e-5;
        medium.growth = 1.09;
        OneraM6Options large;
        large.chord_cells = 66;
        large.span_cells = 54;
        large.cap_cells = 10;
        large.layers = 255;
        large.growth_layers = 165;
        large.first_height = 0.86e-6;
        large.growth = 1.0443;
        large.thin_ratio = 0.0128;
        large.thin_reach = 0.022;
        large.thin_power = 0.6265;
        return std::vector<OneraM6Preset>{
            {"m6-8k", small}, {"m6-67k", {}}, {"m6-500k", medium}, {"m6-2m", large}};
    }();
    return presets;
}

} // namespace ameco
