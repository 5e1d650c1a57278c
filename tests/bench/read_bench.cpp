// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Time and memory of reading a mesh, beside copying the same file to a RAM disk in the same run:
/// `read_bench wing.meshb`. The file is read once before, so that it is in memory.
#include "core/base/stopwatch.h"
#include "core/io/io.h"

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <string>

using namespace ameco;

namespace {

constexpr int rounds = 5;

template <class F>
double seconds(F&& f) {
    const Stopwatch watch;
    f();
    return watch.seconds();
}

template <class... Arrays>
double bytes_of(const Arrays&... arrays) {
    return (... + static_cast<double>(arrays.size() * sizeof(arrays.raw()[0])));
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: read_bench MESH\n", stderr);
        return 2;
    }
    const std::string file = arguments[1];
    const std::string copy = "cp '" + file + "' /dev/shm/ameco_read_bench";
    double read_best = 1e9, copy_best = 1e9, mesh_bytes = 0;
    for (int i = 0; i < rounds; ++i) {
        copy_best = std::min(copy_best, seconds([&] {
                                 if (std::system(copy.c_str()) != 0) {
                                     std::exit(1);
                                 }
                             }));
        std::remove("/dev/shm/ameco_read_bench");
        read_best = std::min(read_best, seconds([&] {
                                 const MeshFile read = read_mesh(file);
                                 std::visit(
                                     [&](const auto& m) {
                                         mesh_bytes = bytes_of(m.points, m.labels, m.elements,
                                                               m.region, m.faces, m.patch);
                                     },
                                     read.mesh);
                             }));
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double peak = 1024.0 * static_cast<double>(usage.ru_maxrss);
    std::printf("best of %d: cp %.3f s, read_mesh %.3f s, ratio %.2f\n", rounds, copy_best,
                read_best, read_best / copy_best);
    std::printf("mesh %.1f MB, peak memory %.1f MB, ratio %.2f\n", mesh_bytes / 1e6, peak / 1e6,
                peak / mesh_bytes);
    return 0;
}
