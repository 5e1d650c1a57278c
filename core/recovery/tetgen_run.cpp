// SPDX-License-Identifier: AGPL-3.0-or-later
// The one file that includes tetgen.h: its macros and its globals stay here.
#include "core/recovery/tetgen_run.h"

#include <array>
#include <charconv>
#include <memory>

#define TETLIBRARY
#define terminatetetgen terminatetetgen_of_header
#include <tetgen.h>
#undef terminatetetgen
#undef REAL

// As Debian ships it, TetGen 1.5.0 ends on an error by freeing its mesh and throwing, and the mesh
// is then freed again, which crashes. Our definition takes the place of the library's weak one;
// where it does not (a module that hides its symbols), the child crashes, and is reported.
__attribute__((visibility("default"))) void terminatetetgen(tetgenmesh* mesh, int code);
void terminatetetgen(tetgenmesh*, int code) {
    throw code;
}

namespace ameco {
namespace {

/// Volume of the regular tet with edges of this length.
double volume_of_size(double size) {
    return size * size * size / 8.485281374238570; // 6 sqrt(2)
}

std::string digits(double value) {
    std::array<char, 32> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 18);
    return {text.data(), end.ptr};
}

void fill_points(const Mesh<3>& surface, const RecoveryOptions& options, tetgenio& in) {
    const std::size_t n = surface.points.size();
    in.numberofpoints = static_cast<int>(n);
    in.pointlist = new double[3 * n];
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            in.pointlist[3 * i + k] = surface.points[NodeId(i)][static_cast<int>(k)];
        }
    }
    if (!options.sizes.empty()) {
        in.numberofpointmtrs = 1;
        in.pointmtrlist = new double[n];
        std::copy(options.sizes.begin(), options.sizes.end(), in.pointmtrlist);
    }
}

void fill_facets(const Mesh<3>& surface, tetgenio& in) {
    const std::size_t k = surface.faces.size();
    in.numberoffacets = static_cast<int>(k);
    in.facetlist = new tetgenio::facet[k];
    in.facetmarkerlist = new int[k];
    for (std::size_t f = 0; f < k; ++f) {
        tetgenio::facet& facet = in.facetlist[f];
        tetgenio::init(&facet);
        facet.numberofpolygons = 1;
        facet.polygonlist = new tetgenio::polygon[1];
        facet.polygonlist[0].numberofvertices = 3;
        facet.polygonlist[0].vertexlist = new int[3];
        for (std::size_t i = 0; i < 3; ++i) {
            facet.polygonlist[0].vertexlist[i] = surface.faces[FaceId(f)][i].value();
        }
        in.facetmarkerlist[f] = static_cast<int>(f) + 1;
    }
}

void fill_seeds(const RecoveryOptions& options, tetgenio& in) {
    in.numberofholes = static_cast<int>(options.holes.size());
    in.holelist = new double[3 * options.holes.size()];
    double* hole = in.holelist;
    for (const Vec<3>& x : options.holes) {
        hole = std::copy_n(x.data(), 3, hole);
    }
    in.numberofregions = static_cast<int>(options.regions.size());
    in.regionlist = new double[5 * options.regions.size()];
    double* region = in.regionlist;
    for (const RegionSeed& seed : options.regions) {
        region = std::copy_n(seed.inside.data(), 3, region);
        const double size = seed.size > 0 ? seed.size : options.size;
        *region++ = seed.region;
        *region++ = size > 0 ? volume_of_size(size) : -1;
    }
}

} // namespace

std::string tetgen_switches(const RecoveryOptions& options) {
    // p: facets; M: each triangle is a facet of its own, so that no diagonal may move; z: from 0.
    std::string text = "pMz";
    text += options.faces == GivenFaces::keep ? "Y" : "";
    text += options.radius_edge > 0 ? "q" + digits(options.radius_edge) : "";
    text += options.size > 0 ? "a" + digits(volume_of_size(options.size)) : "";
    text += options.regions.empty() ? "" : "A";
    bool sizes_by_region = false;
    for (const RegionSeed& seed : options.regions) {
        sizes_by_region = sizes_by_region || seed.size > 0;
    }
    text += sizes_by_region ? "a" : "";
    text += options.sizes.empty() ? "" : "m";
    return text + "T" + digits(options.tolerance);
}

TetgenMesh run_tetgen(const Mesh<3>& surface, const RecoveryOptions& options,
                      const std::string& switches) {
    tetgenio in, out;
    fill_points(surface, options, in);
    fill_facets(surface, in);
    fill_seeds(options, in);
    std::string words = switches; // TetGen wants to write into it
    tetrahedralize(words.data(), &in, &out);
    TetgenMesh mesh;
    mesh.points.assign(out.pointlist, out.pointlist + 3 * std::ptrdiff_t{out.numberofpoints});
    mesh.tets.reserve(4 * static_cast<std::size_t>(out.numberoftetrahedra));
    for (int t = 0; t < out.numberoftetrahedra; ++t) {
        const int* corners = out.tetrahedronlist + std::ptrdiff_t{t} * out.numberofcorners;
        mesh.tets.insert(mesh.tets.end(), corners, corners + 4);
    }
    if (out.numberoftetrahedronattributes > 0) {
        for (int t = 0; t < out.numberoftetrahedra; ++t) {
            mesh.regions.push_back(
                static_cast<int>(out.tetrahedronattributelist[std::ptrdiff_t{t} *
                                                              out.numberoftetrahedronattributes]));
        }
    }
    if (out.numberoftrifaces > 0) {
        mesh.faces.assign(out.trifacelist,
                          out.trifacelist + 3 * std::ptrdiff_t{out.numberoftrifaces});
        if (out.trifacemarkerlist != nullptr) {
            mesh.markers.assign(out.trifacemarkerlist,
                                out.trifacemarkerlist + out.numberoftrifaces);
        }
    }
    return mesh;
}

} // namespace ameco
