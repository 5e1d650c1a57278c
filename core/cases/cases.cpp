// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/cases.h"

#include "core/cases/box.h"
#include "core/cases/cube.h"
#include "core/cases/layer.h"
#include "core/cases/model_layer.h"
#include "core/cases/onera_m6.h"
#include "core/cases/parameters.h"
#include "core/cases/shell.h"

namespace ameco {
namespace {

using AnyMesh = std::variant<Mesh<3>, Mesh<2>>;
using Values = std::map<std::string, std::string>;

/// Options of a case that exists in both dimensions.
template <class Options>
struct WithDimension : Options {
    int dim = 3;
};

/// A case: what to print, and how to make it from names and values.
struct Case {
    CaseDescription description;
    std::function<AnyMesh(const Values&)> make;
};

const std::vector<std::pair<std::string, Diagonals>> diagonal_choices{
    {"uniform", Diagonals::uniform},
    {"alternating", Diagonals::alternating},
    {"columns", Diagonals::columns},
    {"random", Diagonals::random}};

const std::vector<std::pair<std::string, TrailingEdge>> trailing_edge_choices{
    {"rounded", TrailingEdge::rounded}, {"sharp", TrailingEdge::sharp}};

const Range dimensions{2, 3, false, "2 or 3"};

/// What all extruded cases have in common.
template <class Options>
void add_common(ParameterTable<Options>& table) {
    table
        .add("diagonals", &Options::diagonals, diagonal_choices,
             "how quadrilaterals are cut; columns: at random, the same in all layers")
        .add("seed", &Options::seed, at_least(0), "of everything that is random")
        .add("shuffle", &Options::shuffle, at_least(0),
             "seed of a random numbering; 0 numbers layer by layer");
}

template <class Options>
void add_every(ParameterTable<Options>& table) {
    table.add("every", &Options::every, at_least(1),
              "keep every n-th layer: the ideal semi-coarsened mesh of the same case");
}

Case box_case() {
    using Options = WithDimension<BoxOptions>;
    ParameterTable<Options> table("box");
    table.add("dim", &Options::dim, dimensions, "dimension")
        .add("nx", &Options::nx, at_least(1), "cells along x")
        .add("ny", &Options::ny, at_least(1), "cells along y; in 3-D only")
        .add("nz", &Options::nz, at_least(1), "cells along the short direction")
        .add("dx", &Options::dx, "L", above(0), "length of a cell along x and y")
        .add("ratio", &Options::ratio, "", above(0), "height of a cell over dx");
    add_every(table);
    add_common(table);
    return {{"box", "the paper's synthetic box (section 5.1): bricks cut into prisms and tets",
             table.parameters()},
            [table](const Values& values) -> AnyMesh {
                Options o;
                table.apply(values, o);
                return o.dim == 2 ? AnyMesh(make_box<2>(o)) : AnyMesh(make_box<3>(o));
            }};
}

Case model_layer_case() {
    using Options = ModelLayerOptions;
    ParameterTable<Options> table("model-layer");
    table
        .add("angle", &Options::angle_deg, "deg", between(-90, 90),
             "turn of the wall at its middle; > 0 convex, < 0 concave")
        .add("stretching", &Options::stretching, "", at_least(1), "h_max / h_min")
        .add("cells", &Options::cells, at_least(1), "wall edges on each side of the turn")
        .add("layers", &Options::layers, at_least(1), "layers over the wall");
    add_every(table);
    add_common(table);
    return {{"model-layer",
             "the paper's 2-D model of a boundary layer (figure 1): a wall that turns",
             table.parameters()},
            [table](const Values& values) -> AnyMesh {
                Options o;
                table.apply(values, o);
                return make_model_layer(o);
            }};
}

Case layer_case() {
    using Options = WithDimension<LayerOptions>;
    ParameterTable<Options> table("layer");
    table.add("dim", &Options::dim, dimensions, "dimension")
        .add("nx", &Options::nx, at_least(1), "cells along x, over a length of 1")
        .add("ny", &Options::ny, at_least(1), "cells along y, of the same size; in 3-D only")
        .add("nz", &Options::nz, at_least(1), "layers")
        .add("aspect-ratio", &Options::aspect_ratio, "", at_least(1),
             "length of a cell over the first height")
        .add("growth", &Options::growth, "", between(1, 10),
             "of heights from layer to layer, until cells are as high as long")
        .add("displace", &Options::displace, "", between(0, 0.24),
             "largest displacement of columns, in cell lengths")
        .add("jitter", &Options::jitter, "", between(0, 0.3),
             "largest movement of nodes along their columns, in local heights")
        .add("curvature", &Options::curvature, "L", between(-1e9, 1e9),
             "radius the plate is bent to; > 0 convex, < 0 concave, 0 flat");
    add_every(table);
    add_common(table);
    return {{"layer", "a boundary layer over a plate, flat or bent over a cylinder",
             table.parameters()},
            [table](const Values& values) -> AnyMesh {
                Options o;
                table.apply(values, o);
                return o.dim == 2 ? AnyMesh(make_layer<2>(o)) : AnyMesh(make_layer<3>(o));
            }};
}

Case cube_case() {
    using Options = WithDimension<CubeOptions>;
    ParameterTable<Options> table("cube");
    table.add("dim", &Options::dim, dimensions, "dimension")
        .add("n", &Options::n, at_least(1), "cells along each side")
        .add("displace", &Options::displace, "", between(0, 0.2),
             "largest displacement of nodes, in cell sizes");
    add_common(table);
    return {{"cube", "the unit cube or square with an isotropic mesh", table.parameters()},
            [table](const Values& values) -> AnyMesh {
                Options o;
                table.apply(values, o);
                return o.dim == 2 ? AnyMesh(make_cube<2>(o)) : AnyMesh(make_cube<3>(o));
            }};
}

Case shell_case() {
    using Options = ShellOptions;
    ParameterTable<Options> table("shell");
    table.add("a", &Options::a, "L", above(0), "longest half axis, along x")
        .add("b", &Options::b, "L", above(0), "half axis along y, <= a")
        .add("c", &Options::c, "L", above(0), "shortest half axis, along z, <= b")
        .add("frequency", &Options::frequency, between(2, 4096),
             "of the icosphere on the wall: 10 frequency^2 + 2 wall nodes")
        .add("aspect-ratio", &Options::aspect_ratio, "", at_least(1),
             "mean edge of the wall over the first height")
        .add("growth", &Options::growth, "", between(1.01, 10), "of heights from layer to layer")
        .add("far-field", &Options::far_field, "", between(1.01, 1e6),
             "half axis of the far field along x, over a")
        .add("cluster", &Options::cluster, "", between(0, 1),
             "how far wall nodes are drawn to the ends of the long axis")
        .add("displace", &Options::displace, "", between(0, 0.2),
             "largest displacement of wall nodes, in mean edges")
        .add("flips", &Options::flips, "", between(0, 1), "share of wall edges flipped at random");
    add_every(table);
    add_common(table);
    return {
        {"shell", "the space around a sphere or ellipsoid, with layers on it", table.parameters()},
        [table](const Values& values) -> AnyMesh {
            Options o;
            table.apply(values, o);
            return make_shell(o);
        }};
}

/// The wing's options, and the preset they start from (its place in the list of presets).
struct WithPreset : OneraM6Options {
    std::size_t preset = 1;
};

std::vector<std::pair<std::string, std::size_t>> preset_choices() {
    std::vector<std::pair<std::string, std::size_t>> choices;
    for (const OneraM6Preset& preset : onera_m6_presets()) {
        choices.emplace_back(preset.name, choices.size());
    }
    return choices;
}

/// Sets the preset first, whatever the order of the names, and then changes it.
AnyMesh make_onera_m6_case(const ParameterTable<WithPreset>& table, const Values& values) {
    WithPreset o;
    if (const auto preset = values.find("preset"); preset != values.end()) {
        table.apply({*preset}, o);
    }
    static_cast<OneraM6Options&>(o) = onera_m6_presets()[o.preset].options;
    table.apply(values, o);
    return make_onera_m6(o);
}

Case onera_m6_case() {
    using Options = WithPreset;
    ParameterTable<Options> table("onera-m6");
    table.add("preset", &Options::preset, preset_choices(), "where the other parameters start from")
        .add("chord-cells", &Options::chord_cells, at_least(4),
             "cells from the leading to the trailing edge, on each side")
        .add("span-cells", &Options::span_cells, at_least(2), "cells from the root to the tip")
        .add("cap-cells", &Options::cap_cells, at_least(3), "cells around the tip")
        .add("layers", &Options::layers, at_least(2), "layers, more than growth-layers")
        .add("growth-layers", &Options::growth_layers, at_least(1),
             "layers at the wall that grow by growth; the rest fill the far field")
        .add("first-height", &Options::first_height, "m", above(0), "of the layer at the wall")
        .add("growth", &Options::growth, "", between(1, 10), "of heights near the wall")
        .add("far-field", &Options::far_field, "m", at_least(2), "distance of the far field")
        .add("leading-size", &Options::leading_size, "chord", above(0),
             "relative spacing along the section at its leading edge")
        .add("trailing-size", &Options::trailing_size, "chord", above(0),
             "relative spacing at the trailing edge")
        .add("largest-size", &Options::largest_size, "chord", above(0),
             "largest relative spacing along the section")
        .add("spread", &Options::spread, "", at_least(1),
             "distance of sections in the far field, over that at the wing")
        .add("thin-ratio", &Options::thin_ratio, "", between(1e-6, 1),
             "first height at the thinnest column, over first-height")
        .add("thin-reach", &Options::thin_reach, "cells", above(0),
             "distance at which the thinning begins to fade")
        .add("thin-power", &Options::thin_power, "", above(0),
             "with which power of the distance it fades")
        .add("trailing-edge", &Options::trailing_edge, trailing_edge_choices,
             "how the section is closed");
    add_every(table);
    add_common(table);
    return {{"onera-m6",
             "the ONERA M6 half wing with viscous layers (section 5.2; the size of 5.3)",
             table.parameters()},
            [table](const Values& values) { return make_onera_m6_case(table, values); }};
}

const std::vector<Case>& all_cases() {
    static const std::vector<Case> all{box_case(),  model_layer_case(), layer_case(),
                                       cube_case(), shell_case(),       onera_m6_case()};
    return all;
}

} // namespace

const std::vector<CaseDescription>& cases() {
    static const std::vector<CaseDescription> descriptions = [] {
        std::vector<CaseDescription> list;
        for (const Case& c : all_cases()) {
            list.push_back(c.description);
        }
        return list;
    }();
    return descriptions;
}

AnyMesh make_case(std::string_view name, const Values& parameters) {
    std::vector<std::string> known;
    for (const Case& c : all_cases()) {
        if (c.description.name == name) {
            return c.make(parameters);
        }
        known.push_back(c.description.name);
    }
    throw_unknown("there is no case", name, known);
}

} // namespace ameco
