// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What tests of the cases ask of a mesh's patches.
#pragma once

#include "core/mesh/mesh.h"

#include <cmath>
#include <functional>
#include <map>
#include <set>

#include <Eigen/Geometry>

namespace ameco {

/// Outward normal of a face, its length the face's measure [L^(D-1)].
inline Vec<2> face_normal(const Mesh<2>& mesh, const Facet<2>& f) {
    const Vec<2> e = mesh.points[f[1]] - mesh.points[f[0]];
    return {e[1], -e[0]};
}

inline Vec<3> face_normal(const Mesh<3>& mesh, const Facet<3>& f) {
    const Vec<3> a = mesh.points[f[1]] - mesh.points[f[0]];
    const Vec<3> b = mesh.points[f[2]] - mesh.points[f[0]];
    return a.cross(b) / 2;
}

/// Sum of the outward normals of each patch [L^(D-1)].
template <int D>
std::map<std::string, Vec<D>> patch_normals(const Mesh<D>& mesh) {
    std::map<std::string, Vec<D>> sum;
    for (const FaceId f : mesh.faces.ids()) {
        const std::string& name = mesh.patch_names.at(mesh.patch[f]);
        sum.try_emplace(name, Vec<D>::Zero()).first->second += face_normal(mesh, mesh.faces[f]);
    }
    return sum;
}

/// Nodes of a patch, given by name.
template <int D>
std::set<NodeId> patch_nodes(const Mesh<D>& mesh, const std::string& name) {
    std::set<NodeId> nodes;
    for (const FaceId f : mesh.faces.ids()) {
        if (mesh.patch_names.at(mesh.patch[f]) == name) {
            nodes.insert(mesh.faces[f].begin(), mesh.faces[f].end());
        }
    }
    return nodes;
}

template <int D>
bool all_of_patch(const Mesh<D>& mesh, const std::string& name,
                  const std::function<bool(const Vec<D>&)>& holds) {
    for (const NodeId v : patch_nodes(mesh, name)) {
        if (!holds(mesh.points[v])) {
            return false;
        }
    }
    return true;
}

/// Whether two numbers agree to a relative tolerance.
inline bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

} // namespace ameco
