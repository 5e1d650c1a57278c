// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Surfaces for people and for programs; shared by the commands that begin with one.
#pragma once

#include "app/cli/mesh_input.h"
#include "core/hierarchy/statistics_json.h"
#include "core/surface/surface_features.h"
#include "core/surface/surface_report.h"

namespace ameco::cli {

/// Reads a surface, or the boundary of a mesh.
/// \throws UsageError for a mesh in 2-D
[[nodiscard]] Mesh<3> load_surface(const std::filesystem::path& path, Session& session);

/// The surface in a file that was read with `ReadOptions::surfaces`.
/// \throws UsageError for a mesh in 2-D, InputError for one that refers to what is not there
[[nodiscard]] Mesh<3> surface_of(MeshFile&& file, const std::filesystem::path& path,
                                 Monitor& monitor);

[[nodiscard]] Json surface_json(const SurfaceReport& report);
[[nodiscard]] Json features_json(const Mesh<3>& surface, const SurfaceFeatures& features);

/// \param mended  what was done to the surface before, one line each
void print_surface(std::ostream& out, const std::string& file, const SurfaceReport& report,
                   const std::vector<std::string>& mended);
[[nodiscard]] Facts features_facts(const Mesh<3>& surface, const SurfaceFeatures& features);

} // namespace ameco::cli
