// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/surface_files.h"

#include "core/io/atomic_file.h"

#include <fstream>
#include <limits>

// OpenMesh registers its readers and writers where this header is included before the mesh types.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace ameco::surface_files {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

/// The faces, with the nodes they use in ascending order.
Surface surface_of(const Mesh<3>& mesh, const std::filesystem::path& path) {
    Surface surface;
    IdVector<NodeId, OpenMesh::VertexHandle> vertex(mesh.points.size());
    for (const Facet<3>& face : mesh.faces) {
        for (const NodeId node : face) {
            vertex[node] = OpenMesh::VertexHandle(0); // used; its number comes below
        }
    }
    for (const NodeId node : mesh.points.ids()) {
        if (vertex[node].is_valid()) {
            const Vec<3>& x = mesh.points[node];
            vertex[node] = surface.add_vertex({x[0], x[1], x[2]});
        }
    }
    for (const Facet<3>& face : mesh.faces) {
        if (!surface.add_face(vertex[face[0]], vertex[face[1]], vertex[face[2]]).is_valid()) {
            throw UsageError(path.string() +
                             ": the surface is not manifold, which this format cannot be written "
                             "with; choose .msh or .meshb");
        }
    }
    return surface;
}

} // namespace

std::vector<std::string> write(const std::filesystem::path& path, const std::string& suffix,
                               const Mesh<3>& mesh) {
    omerr().disable();
    omlog().disable();
    Surface surface = surface_of(mesh, path);
    AtomicFile target(path);
    {
        std::ofstream stream(target.temporary(), std::ios::binary);
        const bool binary = suffix == "stl";
        OpenMesh::IO::Options options(binary ? OpenMesh::IO::Options::Binary
                                             : OpenMesh::IO::Options::Default);
        if (suffix == "stl") {
            surface.request_face_normals();
            surface.update_face_normals();
        }
        const bool good =
            OpenMesh::IO::write_mesh(surface, stream, binary ? ".stlb" : "." + suffix, options,
                                     std::numeric_limits<double>::max_digits10);
        stream.close();
        if (!good || !stream) {
            throw FileError(path.string() + ": cannot be written");
        }
    }
    target.commit();
    std::vector<std::string> notes;
    if (!mesh.elements.empty()) {
        notes.emplace_back("only the boundary was written: the format holds surfaces");
    }
    notes.emplace_back("coordinates were rounded to single precision");
    return notes;
}

} // namespace ameco::surface_files
