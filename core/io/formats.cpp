// SPDX-License-Identifier: AGPL-3.0-or-later
// The table of formats itself: a new format gets a file of its own and a row here.
#include "core/io/format.h"

#ifdef AMECO_WITH_CGNS
#include "core/io/cgns.h"
#endif
#include "core/io/dassault.h"
#include "core/io/dimeco.h"
#include "core/io/gmf.h"
#include "core/io/gmf_binary_reader.h"
#include "core/io/gmf_text_reader.h"
#include "core/io/gmsh.h"
#include "core/io/mtc.h"
#include "core/io/su2.h"
#ifdef AMECO_WITH_OPENMESH
#include "core/io/surface_files.h"
#endif
#include "core/io/tetgen_files.h"
#include "core/io/ugrid.h"
#ifdef AMECO_WITH_VTK
#include "core/io/vtk.h"
#endif

namespace ameco {
namespace {

constexpr unsigned both = keeps_2d | keeps_3d;
constexpr unsigned named = keeps_patches | keeps_names;
constexpr unsigned all_of_medit =
    both | keeps_surfaces | named | keeps_regions | keeps_curves | keeps_features | keeps_labels;

MeshFile read_gmf(const Source& source) {
    return *gmf::read_mesh(source.bytes, source.name, source.options, source.file);
}
TensorFile read_gmf_tensors(const Source& source) {
    return *gmf::read_tensors(source.bytes, source.name);
}
template <int D, gmf::Form form>
std::vector<std::string> write_gmf(const std::filesystem::path& path, const Mesh<D>& mesh,
                                   const WriteOptions& options) {
    return gmf::write_mesh(path, form, mesh, options);
}
template <int D, gmf::Form form>
void write_gmf_tensors(const std::filesystem::path& path,
                       const IdVector<NodeId, Tensor<D>>& tensors, const WriteOptions& options) {
    gmf::write_tensors<D>(path, form, tensors, options);
}

template <int D, int version, gmsh::Form form>
std::vector<std::string> write_gmsh(const std::filesystem::path& path, const Mesh<D>& mesh,
                                    const WriteOptions&) {
    return version == 2 ? gmsh::write_2(path, form, mesh) : gmsh::write_4(path, form, mesh);
}

/// Medit, in its two forms, for meshes and metrics.
void add_medit(std::vector<Format>& table) {
    constexpr gmf::Form text = gmf::Form::text;
    constexpr gmf::Form binary = gmf::Form::binary;
    table.push_back({.name = "medit",
                     .title = "Medit binary",
                     .suffixes = {".meshb"},
                     .keeps = all_of_medit,
                     .remark = "versions 1 to 4; unknown records are carried along",
                     .recognises = gmf::is_binary,
                     .read = read_gmf,
                     .write_2d = write_gmf<2, binary>,
                     .write_3d = write_gmf<3, binary>});
    table.push_back({.name = "medit-text",
                     .title = "Medit text",
                     .suffixes = {".mesh"},
                     .keeps = all_of_medit,
                     .remark = "names of patches in comments",
                     .recognises = gmf::is_text,
                     .read = read_gmf,
                     .write_2d = write_gmf<2, text>,
                     .write_3d = write_gmf<3, text>});
    table.push_back({.name = "medit-metric",
                     .title = "Medit metric, binary",
                     .suffixes = {".solb"},
                     .keeps = both,
                     .remark = "one symmetric tensor per node",
                     .recognises = gmf::is_binary,
                     .read_tensors = read_gmf_tensors,
                     .write_tensors_2d = write_gmf_tensors<2, binary>,
                     .write_tensors_3d = write_gmf_tensors<3, binary>});
    table.push_back({.name = "medit-metric-text",
                     .title = "Medit metric, text",
                     .suffixes = {".sol"},
                     .keeps = both,
                     .remark = "one symmetric tensor per node",
                     .recognises = gmf::is_text,
                     .read_tensors = read_gmf_tensors,
                     .write_tensors_2d = write_gmf_tensors<2, text>,
                     .write_tensors_3d = write_gmf_tensors<3, text>});
}

/// The formats of the paper's appendix A.
void add_founding(std::vector<Format>& table) {
    table.push_back({.name = "mtc",
                     .title = "MTC meta-file",
                     .suffixes = {".mtc"},
                     .keeps = both | named,
                     .remark = "names a mesh and a metric; the mesh is written as .t beside it",
                     .recognises = mtc::recognises_meta,
                     .read = mtc::read_meta,
                     .write_2d = mtc::write_meta<2>,
                     .write_3d = mtc::write_meta<3>});
    table.push_back({.name = "mtc-mesh",
                     .title = "MTC mesh",
                     .suffixes = {".t"},
                     .keeps = both | named,
                     .remark = "patches and names in .t.patches, a file of our own; without it "
                               "patches are divided at sharp edges",
                     .read = mtc::read,
                     .write_2d = mtc::write<2>,
                     .write_3d = mtc::write<3>});
    table.push_back({.name = "mtc-metric",
                     .title = "MTC metric",
                     .suffixes = {".metrique", "_metrique"},
                     .keeps = both,
                     .remark = "full matrices, or upper triangles on reading",
                     .read_tensors = mtc::read_tensors,
                     .write_tensors_2d = mtc::write_tensors<2>,
                     .write_tensors_3d = mtc::write_tensors<3>});
    table.push_back({.name = "mtc-meta-metric",
                     .title = "MTC meta-file, its metric",
                     .suffixes = {".mtc"},
                     .keeps = both,
                     .remark = "the metric that the meta-file names",
                     .recognises = mtc::recognises_meta,
                     .read_tensors = mtc::read_meta_tensors});
    table.push_back({.name = "dimeco",
                     .title = "AMeCo",
                     .suffixes = {".dimeco"},
                     .keeps = both | keeps_patches,
                     .remark = "either byte order and Fortran records on reading",
                     .read = dimeco::read,
                     .write_2d = dimeco::write<2>,
                     .write_3d = dimeco::write<3>});
    table.push_back({.name = "dassault",
                     .title = "Dassault",
                     .suffixes = {".dassault"},
                     .keeps = both | keeps_patches,
                     .remark = "",
                     .read = dassault::read,
                     .write_2d = dassault::write<2>,
                     .write_3d = dassault::write<3>});
}

template <int version, gmsh::Form form>
Format gmsh_format(std::string_view name, std::string_view title, std::string_view remark) {
    return {.name = name,
            .title = title,
            .suffixes = {".msh"},
            .keeps = both | keeps_surfaces | named | keeps_regions | keeps_curves,
            .remark = remark,
            .recognises = gmsh::recognises,
            .read = gmsh::read,
            .write_2d = write_gmsh<2, version, form>,
            .write_3d = write_gmsh<3, version, form>};
}

/// The first format of a suffix is the one it is written in.
void add_gmsh(std::vector<Format>& table) {
    constexpr gmsh::Form text = gmsh::Form::text;
    constexpr gmsh::Form binary = gmsh::Form::binary;
    table.push_back(gmsh_format<4, binary>("gmsh", "Gmsh 4.1 binary", "what .msh is written as"));
    table.push_back(gmsh_format<4, text>("gmsh-text", "Gmsh 4.1 text", ""));
    table.push_back(gmsh_format<2, binary>("gmsh22", "Gmsh 2.2 binary", ""));
    table.push_back(gmsh_format<2, text>("gmsh22-text", "Gmsh 2.2 text", ""));
}

void add_solvers(std::vector<Format>& table) {
    table.push_back({.name = "su2",
                     .title = "SU2",
                     .suffixes = {".su2"},
                     .keeps = both | named,
                     .remark = "numbers of patches in comments; one zone",
                     .recognises = su2::recognises,
                     .read = su2::read,
                     .write_2d = su2::write<2>,
                     .write_3d = su2::write<3>});
    table.push_back({.name = "ugrid",
                     .title = "UGRID",
                     .suffixes = {".ugrid", ".b8.ugrid", ".lb8.ugrid", ".b4.ugrid", ".lb4.ugrid",
                                  ".r8.ugrid", ".lr8.ugrid", ".r4.ugrid", ".lr4.ugrid",
                                  ".b8l.ugrid", ".lb8l.ugrid", ".b8.ugrid64", ".lb8.ugrid64"},
                     .keeps = keeps_3d | keeps_surfaces | named,
                     .remark = "text, or binary as the suffix says; names in .mapbc",
                     .read = ugrid::read,
                     .write_3d = ugrid::write});
    table.push_back({.name = "tetgen",
                     .title = "TetGen, Triangle",
                     .suffixes = {".node", ".ele"},
                     .keeps = both | named | keeps_regions | keeps_labels,
                     .remark = "three files; names in comments",
                     .read = tetgen_files::read,
                     .write_2d = tetgen_files::write<2>,
                     .write_3d = tetgen_files::write<3>});
}

/// Rows whose library is absent stay in the table, to say so.
constexpr std::string_view not_built = "left out of this build";

#ifdef AMECO_WITH_CGNS
template <int D, cgns::Container container>
std::vector<std::string> write_cgns(const std::filesystem::path& path, const Mesh<D>& mesh,
                                    const WriteOptions&) {
    return cgns::write(path, container, mesh);
}
#endif

void add_cgns(std::vector<Format>& table) {
    const Format row{.name = "cgns",
                     .title = "CGNS",
                     .suffixes = {".cgns"},
                     .keeps = both | named,
                     .remark = not_built};
    table.push_back(row);
    table.push_back(row);
    table.back().name = "cgns-adf";
    table.back().title = "CGNS in ADF";
#ifdef AMECO_WITH_CGNS
    for (Format* format : {&table.back() - 1, &table.back()}) {
        format->remark = "one unstructured zone, HDF5 or ADF";
        format->recognises = cgns::recognises;
        format->read = cgns::read;
    }
    Format& hdf5 = table[table.size() - 2];
    hdf5.write_2d = write_cgns<2, cgns::Container::hdf5>;
    hdf5.write_3d = write_cgns<3, cgns::Container::hdf5>;
    table.back().write_2d = write_cgns<2, cgns::Container::adf>;
    table.back().write_3d = write_cgns<3, cgns::Container::adf>;
#endif
}

void add_vtk(std::vector<Format>& table) {
    Format vtu{.name = "vtu",
               .title = "VTK XML",
               .suffixes = {".vtu"},
               .keeps = both | keeps_surfaces | named | keeps_regions | keeps_curves | keeps_labels,
               .remark = not_built};
    Format legacy{.name = "vtk",
                  .title = "VTK legacy",
                  .suffixes = {".vtk"},
                  .keeps = both | keeps_surfaces,
                  .remark = not_built};
    Format collection{.name = "pvd",
                      .title = "VTK collection",
                      .suffixes = {".pvd"},
                      .keeps = vtu.keeps,
                      .remark = not_built};
#ifdef AMECO_WITH_VTK
    vtu.remark = "labels in cell arrays region, patch, curve";
    vtu.recognises = vtk::recognises_vtu;
    vtu.read = vtk::read_vtu;
    vtu.write_2d = vtk::write_vtu<2>;
    vtu.write_3d = vtk::write_vtu<3>;
    legacy.remark = "labels where an array of a known name has them";
    legacy.recognises = vtk::recognises_legacy;
    legacy.read = vtk::read_legacy;
    collection.remark = "the first file is read";
    collection.recognises = vtk::recognises_pvd;
    collection.read = vtk::read_pvd;
#endif
    table.insert(table.end(), {vtu, legacy, collection});
}

#ifdef AMECO_WITH_OPENMESH
/// The suffix is a template argument, since the table holds plain functions.
enum class SurfaceKind { stl, obj, ply, off };
constexpr std::array<const char*, 4> surface_suffixes{"stl", "obj", "ply", "off"};

template <SurfaceKind kind>
MeshFile read_surface(const Source& source) {
    return surface_files::read(source, surface_suffixes[static_cast<std::size_t>(kind)]);
}
template <SurfaceKind kind>
std::vector<std::string> write_surface(const std::filesystem::path& path, const Mesh<3>& mesh,
                                       const WriteOptions&) {
    return surface_files::write(path, surface_suffixes[static_cast<std::size_t>(kind)], mesh);
}
#endif

void add_surfaces(std::vector<Format>& table) {
    const std::size_t first = table.size();
    for (const auto& [name, title, suffix] : {std::array<std::string_view, 3>{"stl", "STL", ".stl"},
                                              {"obj", "OBJ", ".obj"},
                                              {"ply", "PLY", ".ply"},
                                              {"off", "OFF", ".off"}}) {
        table.push_back({.name = name,
                         .title = title,
                         .suffixes = {suffix},
                         .keeps = keeps_surfaces,
                         .remark = not_built});
    }
#ifdef AMECO_WITH_OPENMESH
    const auto add = [&](std::size_t at, auto read, auto write) {
        table[first + at].remark = "32-bit coordinates; of a mesh with volume, the boundary";
        table[first + at].read = read;
        table[first + at].write_3d = write;
    };
    add(0, read_surface<SurfaceKind::stl>, write_surface<SurfaceKind::stl>);
    add(1, read_surface<SurfaceKind::obj>, write_surface<SurfaceKind::obj>);
    add(2, read_surface<SurfaceKind::ply>, write_surface<SurfaceKind::ply>);
    add(3, read_surface<SurfaceKind::off>, write_surface<SurfaceKind::off>);
#endif
    static_cast<void>(first);
}

std::vector<Format> make_table() {
    std::vector<Format> table;
    add_medit(table);
    add_founding(table);
    add_solvers(table);
    add_gmsh(table);
    add_cgns(table);
    add_vtk(table);
    add_surfaces(table);
    return table;
}

} // namespace

const std::vector<Format>& formats() {
    static const std::vector<Format> table = make_table();
    return table;
}

} // namespace ameco
