// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the subcommands do alike with the meshes they are given.
#pragma once

#include "app/cli/command.h"
#include "core/io/io.h"
#include "core/mesh/boundary.h"
#include "core/mesh/check.h"
#include "core/metric/aspect_ratio.h"
#include "core/metric/conformity.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ameco::cli {

using Facts = std::vector<std::pair<std::string, std::string>>;

/// Reads a mesh; what was unusual in the file goes to the monitor.
[[nodiscard]] MeshFile load_mesh(const std::filesystem::path& path, Session& session,
                                 const ReadOptions& options = {});

/// Completes the boundary of a mesh that was read, and tests it.
/// \throws InputError when it is not valid
template <int D>
BoundaryRepair make_valid(Mesh<D>& mesh, const std::filesystem::path& path, double ridge_angle_deg,
                          Session& session);

/// A mesh that is ready to be computed with.
struct ReadyMesh {
    MeshFile file;
    BoundaryRepair repair;
};

/// Reads a mesh, completes its boundary and tests it.
/// \throws InputError when it is not valid
[[nodiscard]] ReadyMesh load_valid_mesh(const std::filesystem::path& path, double ridge_angle_deg,
                                        Session& session);

/// Which nodes belong to an element; the others leave the mesh when its boundary is completed.
template <int D>
[[nodiscard]] std::vector<bool> used_nodes(const Mesh<D>& mesh);

/// Reads the metric that was made for a mesh.
/// \param mesh_name  for the message
/// \throws InputError when it has another dimension or number of nodes
template <int D>
[[nodiscard]] MetricField<D> load_metric(const std::filesystem::path& path, const Mesh<D>& mesh,
                                         const std::string& mesh_name);

/// "Tets" and "triangles": elements of D dimensions.
[[nodiscard]] std::string element_word(int dimension);

/// Whether a file of this name holds a metric and no mesh (.sol, .solb, .metrique; also packed).
[[nodiscard]] bool is_metric_name(const std::filesystem::path& path);

/// Ids of the patches given by id or name, ascending.
/// \param option  that named them, for the message
/// \throws UsageError when the mesh has no such patch
template <int D>
[[nodiscard]] std::vector<int> find_patches(const Mesh<D>& mesh, const std::string& option,
                                            const std::vector<std::string>& wanted);

/// \throws UsageError when `output` is the same file as `input`
void refuse_overwriting(const std::filesystem::path& input, const std::filesystem::path& output);

/// \throws UsageError when `output` has none of the suffixes
void require_suffix(const std::filesystem::path& output, const std::vector<std::string>& suffixes);

/// Edge lengths and quality in a metric, for people.
[[nodiscard]] Facts conformity_facts(const Conformity& conformity);

[[nodiscard]] Facts aspect_ratio_facts(const AspectRatioSummary& summary);

} // namespace ameco::cli
