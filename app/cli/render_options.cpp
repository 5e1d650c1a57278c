// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/render_options.h"

#include "app/cli/options.h"
#include "core/base/error.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace ameco::cli {
namespace {

constexpr const char* place_type = "X,Y,Z";

CLI::Validator numbers(std::size_t count, const std::string& wanted) {
    return {[count, wanted](const std::string& text) {
                return numbers_from(text).size() == count ? std::string()
                                                          : text + " is not " + wanted;
            },
            ""};
}

CLI::Validator place() {
    return numbers(3, "three numbers like 0,0.5,1");
}

CLI::Validator direction() {
    return {[](const std::string& text) {
                const auto v = numbers_from(text);
                return v.size() == 3 && std::hypot(v[0], v[1], v[2]) > 0
                           ? std::string()
                           : text + " is not a direction like 0,0,1";
            },
            ""};
}

CLI::Validator scales() {
    return {[](const std::string& text) {
                const auto v = numbers_from(text);
                bool good = v.size() == 3;
                for (const double s : v) {
                    good = good && s >= 1 && s <= 1e6;
                }
                return good ? std::string()
                            : text + " is not three scales from 1 to 1e6, like 1,1,1000";
            },
            ""};
}

/// Width and height; 0 and 0 when the text is something else.
std::pair<int, int> size_from(const std::string& text) {
    int width = 0;
    int height = 0;
    int used = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &used) != 2 ||
        static_cast<std::size_t>(used) != text.size()) {
        return {0, 0};
    }
    return {width, height};
}

CLI::Validator picture_size() {
    return {[](const std::string& text) {
                const auto [width, height] = size_from(text);
                const bool good = width >= 64 && height >= 64 && width <= 8000 && height <= 8000;
                return good ? std::string()
                            : text + " is not a size like 1600x1000, from 64 to 8000 pixels";
            },
            ""};
}

template <class Value, std::size_t N>
std::vector<std::string> names_of(const std::array<Value, N>& all) {
    std::vector<std::string> names;
    for (const Value value : all) {
        names.emplace_back(name(value));
    }
    return names;
}

void add_look(CLI::App& app, RenderOptions& o) {
    constexpr const char* group = "Where to look";
    app.add_option("--view", o.view,
                   "side to look from: x+, x-, y+, y-, z+, z- or corner [corner; 2-D: z+]")
        ->type_name("SIDE")
        ->check(one_of(names_of(gui::all_standard_views)))
        ->group(group);
    app.add_option("--from", o.from, "direction from the mesh to the eye, instead of --view")
        ->type_name(place_type)
        ->check(direction())
        ->group(group);
    app.add_option("--up", o.up, "direction that is upwards in the picture")
        ->type_name(place_type)
        ->check(direction())
        ->group(group);
    app.add_option("--focus", o.focus, "place in the middle of the picture [the walls' middle]")
        ->type_name(place_type)
        ->check(place())
        ->group(group);
    app.add_option("--node", o.node, "node to mark and, without --focus, to have in the middle")
        ->type_name("I")
        ->check(whole_number(0, 2147483646))
        ->group(group);
    app.add_option("--zoom", o.zoom, "show so many times less than everything")
        ->type_name("Z")
        ->check(greater_than(0))
        ->capture_default_str()
        ->group(group);
    app.add_option("--height", o.height, "height of what is shown, in the mesh's unit [all]")
        ->type_name("H")
        ->check(greater_than(0))
        ->group(group);
}

void add_content(CLI::App& app, RenderOptions& o) {
    constexpr const char* group = "What to show";
    app.add_option("--colour-by", o.colour,
                   "none, patch, aspect-ratio, h1, h2, h3 (sizes of the natural metric), quality, "
                   "quality-original, edge-length (in the metric) or removed-at (the level on "
                   "which a node is missing; for a folder)")
        ->type_name("WHAT")
        ->check(one_of(names_of(gui::all_colours)))
        ->capture_default_str()
        ->group(group);
    app.add_option("--range", o.range, "numbers at the ends of the colour scale [the mesh's own]")
        ->type_name("LOW,HIGH")
        ->check(numbers(2, "two numbers like 1,1000"))
        ->group(group);
    app.add_option("--as", o.representation, "surface, edges (surface with edges) or wireframe")
        ->type_name("HOW")
        ->check(one_of(names_of(gui::all_representations)))
        ->capture_default_str()
        ->group(group);
    app.add_option("--hide", o.hide, "patches to leave out, by id or name")
        ->type_name("PATCH...")
        ->group(group);
    app.add_flag("--all-patches", o.all_patches,
                 "show the far field, too, which hides what is inside")
        ->group(group);
    app.add_option("--clip", o.clip, "a place on a plane; what lies before the plane is left out")
        ->type_name(place_type)
        ->check(place())
        ->group(group);
    app.add_option("--clip-normal", o.clip_normal, "normal of the plane, towards what is left out")
        ->type_name(place_type)
        ->check(direction())
        ->capture_default_str()
        ->group(group);
    app.add_flag("--cut", o.cut, "cut elements at the plane; else they are shown whole")
        ->group(group);
    app.add_flag("--flip", o.flip, "show the other side of the plane")->group(group);
}

void add_scales(CLI::App& app, RenderOptions& o) {
    constexpr const char* group = "Layers too thin to be seen (the picture says \"VIEW SCALED\")";
    app.add_option("--scale", o.scale, "scale of each axis, from 1 to 1e6")
        ->type_name("SX,SY,SZ")
        ->check(scales())
        ->capture_default_str()
        ->group(group);
    app.add_option("--lens", o.lens, "scale along the wall's normal only")
        ->type_name("S")
        ->check(number_within(1, 1e6))
        ->capture_default_str()
        ->group(group);
    app.add_option("--lens-at", o.lens_at,
                   "place at the wall whose normal it is [--node, else --focus]")
        ->type_name(place_type)
        ->check(place())
        ->group(group);
    app.add_option("--lens-normal", o.lens_normal, "another direction for the lens")
        ->type_name(place_type)
        ->check(direction())
        ->group(group);
}

void add_ellipsoids(CLI::App& app, RenderOptions& o) {
    constexpr const char* group = "Metric ellipsoids";
    app.add_option("--ellipsoids", o.ellipsoids,
                   "where: none, node (--node), plane (nodes at the clip plane) or sample")
        ->type_name("WHERE")
        ->check(one_of({"none", "node", "plane", "sample"}))
        ->capture_default_str()
        ->group(group);
    app.add_option("--metric", o.source, "natural, or target: that of the next coarser level")
        ->type_name("WHICH")
        ->check(one_of({"natural", "target"}))
        ->capture_default_str()
        ->group(group);
    app.add_option("--mean", o.means,
                   "how the elements' metrics become the node's (ameco metric --help); several, "
                   "with commas, have a panel each [blended]")
        ->type_name("MEAN[,MEAN...]")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(one_of(names_of(all_means)))
        ->group(group);
    app.add_option("--factor", o.factor, "coarse size over fine size, for --metric target")
        ->type_name("C")
        ->check(greater_than(1))
        ->capture_default_str()
        ->group(group);
    app.add_option("--max-ellipsoids", o.max_ellipsoids, "at most so many, spread evenly")
        ->type_name("N")
        ->check(whole_number(1, 2000))
        ->capture_default_str()
        ->group(group);
    app.add_option("--ellipsoid-scale", o.ellipsoid_scale,
                   "half axes over the sizes; at 0.5 the balls of neighbours touch")
        ->type_name("S")
        ->check(greater_than(0))
        ->capture_default_str()
        ->group(group);
    app.add_option("--compress", o.compress, "draw an aspect ratio a as a^E, with E from 0.05 to 1")
        ->type_name("E")
        ->check(number_within(0.05, 1))
        ->capture_default_str()
        ->group(group);
}

void set_look(const RenderOptions& o, gui::LookOptions& look) {
    if (!o.view.empty()) {
        look.view = *gui::standard_view_from_name(o.view);
        look.view_given = true;
    }
    const auto set = [](const std::string& text, std::optional<Vec<3>>& value) {
        if (!text.empty()) {
            value = vector_from(text);
        }
    };
    set(o.from, look.from);
    set(o.up, look.up);
    set(o.focus, look.focus);
    if (o.height > 0) {
        look.height = o.height;
    }
    look.zoom = o.zoom;
}

void set_ellipsoids(const RenderOptions& o, gui::EllipsoidOptions& ellipsoids) {
    using Where = gui::EllipsoidOptions::Where;
    ellipsoids.where = o.ellipsoids == "node"     ? Where::picked
                       : o.ellipsoids == "plane"  ? Where::clip_plane
                       : o.ellipsoids == "sample" ? Where::sample
                                                  : Where::none;
    ellipsoids.source =
        o.source == "target" ? gui::EllipsoidSource::target : gui::EllipsoidSource::natural;
    ellipsoids.target.factor = o.factor;
    ellipsoids.max_count = static_cast<std::size_t>(o.max_ellipsoids);
    ellipsoids.scale = o.ellipsoid_scale;
    ellipsoids.compress = o.compress;
}

} // namespace

Vec<3> vector_from(const std::string& text) {
    const auto v = numbers_from(text);
    return {v.at(0), v.at(1), v.at(2)};
}

void add_render_options(CLI::App& app, RenderOptions& o) {
    app.add_option("MESH", o.inputs, "meshes, or folders of levels; a panel each")
        ->required()
        ->expected(1, 8);
    app.add_option("-o,--output", o.output, "picture to write (.png)")
        ->required()
        ->type_name("PNG");
    app.add_option("--levels", o.levels,
                   "levels of a folder; several, with commas, have a panel "
                   "each")
        ->type_name("K[,K...]")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    app.add_option("--size", o.size, "width and height of the picture in pixels")
        ->type_name("WxH")
        ->check(picture_size())
        ->capture_default_str();
    app.add_option("--text", o.text_scale, "size of the texts and lines, 1 is usual")
        ->type_name("S")
        ->check(number_within(0.2, 10))
        ->capture_default_str();
    app.add_flag("--dark", o.dark, "on a dark background");
    app.add_flag("--transparent", o.transparent, "without a background");
    app.add_flag("--no-legend", o.no_legend, "without the colours' meaning");
    app.add_flag("--no-axes", o.no_axes, "without axes and scale bar");
    add_look(app, o);
    add_content(app, o);
    add_scales(app, o);
    add_ellipsoids(app, o);
}

gui::RenderJob render_job(const RenderOptions& o) {
    gui::RenderJob job;
    std::tie(job.width, job.height) = size_from(o.size);
    job.text_scale = o.text_scale;
    job.transparent = o.transparent;
    job.hide_outer = !o.all_patches;
    set_look(o, job.look);
    if (o.node >= 0) {
        job.node = NodeId(o.node);
    }
    gui::SceneOptions& scene = job.scene;
    scene.colour = *gui::colour_from_name(o.colour);
    scene.representation = *gui::representation_from_name(o.representation);
    if (!o.range.empty()) {
        const auto range = numbers_from(o.range);
        if (!(range[0] < range[1])) {
            throw UsageError("--range: " + o.range + ": the first number must be the smaller one");
        }
        scene.range = {range[0], range[1]};
    }
    if (!o.clip.empty()) {
        scene.clip = {true, vector_from(o.clip), vector_from(o.clip_normal), !o.cut, o.flip};
    }
    scene.view_scale = vector_from(o.scale);
    set_ellipsoids(o, scene.ellipsoids);
    scene.dark = o.dark;
    scene.legend = !o.no_legend;
    scene.axes = scene.scale_bar = !o.no_axes;
    return job;
}

} // namespace ameco::cli
