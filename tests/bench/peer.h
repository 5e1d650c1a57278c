// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Other programs that adapt meshes, run through files beside ours.
#pragma once

#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

#include <optional>
#include <string>
#include <vector>

namespace ameco {

/// A program, and how it is called.
struct Peer {
    std::string name;      ///< what tables call it
    std::string option;    ///< of the bench, which gives its path
    std::string arguments; ///< in.meshb and in.solb to out.meshb, in the folder it runs in
    bool takes_features;   ///< edges and corners of the mesh go with it
    std::string program;   ///< its path; empty: not wanted
};

/// mmg3d and refine, no paths yet.
[[nodiscard]] std::vector<Peer> known_peers();

/// What one run of a peer gave, and took.
struct PeerRun {
    std::optional<Mesh<3>> mesh; ///< none: it failed, or was stopped
    bool stopped = false;        ///< at the limit
    double seconds = 0;          ///< of CPU time
};

/// Lets a peer adapt a mesh to the metric at its nodes.
/// \param most_seconds  of CPU time, after which it is stopped
[[nodiscard]] PeerRun run_peer(const Peer& peer, const Mesh<3>& mesh, const MetricField<3>& field,
                               double most_seconds);

} // namespace ameco
