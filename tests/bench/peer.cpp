// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/bench/peer.h"

#include "core/io/io.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>

namespace ameco {
namespace {

double child_seconds() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

} // namespace

std::vector<Peer> known_peers() {
    return {// Without -hgrad -1 layers become isotropic.
            {"mmg", "--mmg", "-in in.meshb -sol in.solb -out out.meshb -hgrad -1", true, ""},
            // To refine edges lie on curves of a CAD model, which there is none of. Five passes a
            // cycle, not its 30 of one call: the metric is evaluated anew between.
            {"refine", "--refine", "adapt in.meshb --metric in.solb -x out.meshb -s 5", false, ""}};
}

PeerRun run_peer(const Peer& peer, const Mesh<3>& mesh, const MetricField<3>& field,
                 double most_seconds) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / "ameco_adapt_bench";
    fs::create_directories(folder);
    Mesh<3> input = mesh;
    if (!peer.takes_features) {
        input.features = {};
    }
    write_mesh(folder / "in.meshb", input);
    write_metric(folder / "in.solb", field);
    fs::remove(folder / "out.meshb");
    const auto limit = static_cast<long>(std::ceil(most_seconds));
    const std::string command = "cd '" + folder.string() + "' && ulimit -t " +
                                std::to_string(limit) + " && exec " + peer.program + " " +
                                peer.arguments + " > out.txt 2>&1";
    const double begin = child_seconds();
    const int status = std::system(command.c_str());
    PeerRun run;
    run.seconds = child_seconds() - begin;
    run.stopped =
        WIFSIGNALED(status) && (WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGXCPU);
    if (status == 0 && fs::exists(folder / "out.meshb")) {
        run.mesh = std::get<Mesh<3>>(read_mesh(folder / "out.meshb").mesh);
    }
    return run;
}

} // namespace ameco
