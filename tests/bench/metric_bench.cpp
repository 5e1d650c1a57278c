// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Accuracy of the element metric beside the paper's equation (5), time and memory of the nodal
/// metric. Prints the tables of docs/theory/element_metric.md and means.md.
#include "core/base/parallel.h"
#include "core/metric/element_metric.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/metric/reference.h"
#include "tests/core/metric/wide_reference.h"

#include <Eigen/Geometry>

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

using namespace ameco;

namespace {

constexpr int samples = 2000;

struct Errors {
    double residual = 0;   ///< largest |x^T M x - 1|
    double sizes = 0;      ///< largest relative error of a size
    double residual_5 = 0; ///< the same two of the inverted sum in doubles
    double sizes_5 = 0;
    int not_definite = 0; ///< how often the inverted sum is no metric
};

template <int D>
Errors measure(double ratio) {
    std::mt19937 random(1);
    Errors errors;
    for (int n = 0; n < samples; ++n) {
        const auto points = reference::stretched_simplex<D>(random, ratio);
        const Vec<D> exact = wide::sizes<D>(points);
        const Metric<D> metric = element_metric<D>(points);
        errors.residual = std::max(errors.residual, reference::residual<D>(metric, points));
        errors.sizes =
            std::max(errors.sizes, reference::relative_difference<D>(metric.sizes, exact));

        const Mat<D> M = reference::inverted_sum<D>(points);
        reference::for_each_edge<D>(points, [&](const Vec<D>& x) {
            errors.residual_5 = std::max(errors.residual_5, std::abs(x.dot(M * x) - 1));
        });
        Tensor<D> tensor;
        std::size_t k = 0;
        for (int i = 0; i < D; ++i) {
            for (int j = i; j < D; ++j) {
                tensor[k++] = M(i, j);
            }
        }
        const Metric<D> inverted = from_tensor<D>(tensor);
        if (!is_valid<D>(inverted)) {
            ++errors.not_definite;
            continue;
        }
        errors.sizes_5 =
            std::max(errors.sizes_5, reference::relative_difference<D>(inverted.sizes, exact));
    }
    return errors;
}

template <int D>
void print_accuracy() {
    std::printf(
        "\n%d-D, %d elements a line   J = E W^-1 (ours)        inverted sum, equation (5)\n", D,
        samples);
    std::printf("aspect ratio     residual      sizes      residual      sizes   not definite\n");
    for (const double ratio : {1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8}) {
        const Errors e = measure<D>(ratio);
        std::printf("%12g   %10.1e %10.1e    %10.1e %10.1e   %8.1f %%\n", ratio, e.residual,
                    e.sizes, e.residual_5, e.sizes_5, 100.0 * e.not_definite / samples);
    }
}

/// n^3 cells of six tets, with nodes shaken by 20 % of the spacing; layers that begin with height
/// `first` and grow, or even ones for first = 0.
Mesh<3> shaken_box(int n, double first) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shake(-0.2, 0.2);
    std::vector<double> z(n + 2, 0.0);
    double h = first > 0 ? first : 1.0 / n;
    const double growth = first > 0 ? 1.05 * std::pow(1 / (n * first), 1.0 / n) : 1;
    for (int k = 0; k <= n; ++k) {
        z[k + 1] = z[k] + h;
        h = std::min(h * growth, 1.0 / n);
    }
    const Mat<3> Q = reference::random_rotation<3>(random);
    Mesh<3> mesh;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            for (int k = 0; k <= n; ++k) {
                const double dz = z[k + 1] - z[k];
                mesh.points.push_back(Q * Vec<3>((i + shake(random)) / n, (j + shake(random)) / n,
                                                 z[k] + dz * shake(random)));
            }
        }
    }
    const std::array<int, 3> stride{(n + 1) * (n + 1), n + 1, 1};
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            for (int k = 0; k < n; ++k) {
                std::array<int, 3> axes{0, 1, 2};
                do {
                    int corner = (i * (n + 1) + j) * (n + 1) + k;
                    Simplex<3> s{NodeId(corner)};
                    for (std::size_t c = 0; c < 3; ++c) {
                        corner += stride[axes[c]];
                        s[c + 1] = NodeId(corner);
                    }
                    if ((axes[0] + 1) % 3 != axes[1]) { // an odd permutation
                        std::swap(s[2], s[3]);
                    }
                    mesh.elements.push_back(s);
                } while (std::next_permutation(axes.begin(), axes.end()));
            }
        }
    }
    return mesh;
}

double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Processor time of each thread of this process so far [s].
std::map<std::string, double> thread_seconds() {
    std::map<std::string, double> seconds;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
        std::ifstream file(entry.path() / "schedstat");
        double nanoseconds = 0;
        if (file >> nanoseconds) {
            seconds[entry.path().filename().string()] = 1e-9 * nanoseconds;
        }
    }
    return seconds;
}

struct Times {
    double wall = HUGE_VAL;
    double busiest = HUGE_VAL; ///< processor time of the thread that worked most
};

/// Microseconds per element: processor time and wall clock, the best of some runs. Returns the
/// latter.
template <class Run>
Times print_time(const std::string& what, std::size_t elements, int runs, const Run& run) {
    double cpu = HUGE_VAL;
    Times times;
    for (int n = 0; n < runs; ++n) {
        auto threads_start = thread_seconds();
        const double cpu_start = cpu_seconds();
        const double wall_start = wall_seconds();
        run();
        times.wall = std::min(times.wall, wall_seconds() - wall_start);
        cpu = std::min(cpu, cpu_seconds() - cpu_start);
        double busiest = 0;
        for (const auto& [thread, seconds] : thread_seconds()) {
            busiest = std::max(busiest, seconds - threads_start[thread]);
        }
        times.busiest = std::min(times.busiest, busiest);
    }
    const double scale = 1e6 / static_cast<double>(elements);
    std::printf("%-28s %8.3f %8.3f\n", what.c_str(), cpu * scale, times.wall * scale);
    return times;
}

void print_times(int n, double first) {
    const Mesh<3> mesh = shaken_box(n, first);
    const std::size_t m = mesh.elements.size();
    std::printf("\n%zu tets, %zu nodes, %s\n", m, mesh.points.size(),
                first > 0 ? "stretched layers" : "isotropic");
    std::printf("us per tet                        cpu     wall\n");
    set_thread_count(1);
    double sum = 0;
    print_time("volumes only", m, 5, [&] {
        for (const Simplex<3>& s : mesh.elements) {
            const auto x = corners_of<3>(mesh, s);
            sum += (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]);
        }
    });
    print_time("element_metric", m, 5, [&] {
        for (const Simplex<3>& s : mesh.elements) {
            sum += element_metric<3>(corners_of<3>(mesh, s)).sizes[0];
        }
    });
    std::array<Metric<3>, 48> metrics;
    print_time("element_metrics", m, 5, [&] {
        for (std::size_t e = 0; e + metrics.size() <= m; e += metrics.size()) {
            element_metrics<3>(mesh, ElementId(e), metrics);
            sum += metrics[0].sizes[0];
        }
    });
    for (const Mean mean : all_means) {
        if (mean == Mean::geodesic_fixed_step) {
            continue; // does not converge everywhere
        }
        Times one;
        for (const int threads : {1, 2}) {
            set_thread_count(threads);
            const double before = peak_megabytes();
            const Times times =
                print_time(std::string(name(mean)) + ", threads: " + std::to_string(threads), m,
                           comes_from_sums(mean) ? 5 : 1, [&] {
                               const MetricField<3> field = nodal_metric(mesh, mean);
                               sum += field[NodeId(0)].sizes[0];
                           });
            if (threads == 1) {
                one = times;
            } else {
                // Others on the machine spoil the first, not the second.
                std::printf("    2 threads are %.2f times as fast by the clock, %.2f by the "
                            "processor time of the busiest\n",
                            one.wall / times.wall, one.busiest / times.busiest);
            }
            if (mean == Mean::corrected && threads == 1 && peak_megabytes() > before) {
                const auto field = static_cast<double>(mesh.points.size() * sizeof(Metric<3>));
                std::printf("    memory: %.0f MB above the mesh, of which %.0f MB the result\n",
                            peak_megabytes() - before, field / 1048576);
            }
        }
    }
    std::printf("    (sum of a few sizes, to be sure that they are made: %g)\n", sum);
}

/// Worst relative error of a size and angle of the short axis [rad] over some stars of elements.
void print_accuracy_of_means() {
    std::printf(
        "\nMeans of 12 tets whose directions differ by up to 1e-6 ... 0.3 rad, against fifty "
        "digits\naspect ratio  mean              sizes     short axis\n");
    for (const double ratio : {1e2, 1e4, 1e6}) {
        for (const Mean mean : {Mean::corrected, Mean::interpolation, Mean::log_euclidean}) {
            std::mt19937 random(1);
            double sizes = 0, angle = 0;
            for (const double fan : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3}) {
                const Mesh<3> mesh = reference::star_of(reference::fan<3>(random, ratio, fan));
                const Metric<3> found = nodal_metric(mesh, mean)[NodeId(0)];
                const Metric<3> exact = wide::mean<3>(reference::all_corners(mesh), mean);
                sizes =
                    std::max(sizes, reference::relative_difference<3>(found.sizes, exact.sizes));
                angle =
                    std::max(angle, found.directions.col(0).cross(exact.directions.col(0)).norm());
            }
            std::printf("%12g  %-14s %10.1e %12.1e\n", ratio, name(mean).data(), sizes, angle);
        }
        std::mt19937 random(1);
        double residual = 0;
        for (const double fan : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3}) {
            const Mesh<3> mesh = reference::star_of(reference::fan<3>(random, ratio, fan));
            const Metric<3> found = nodal_metric(mesh, Mean::geodesic)[NodeId(0)];
            residual =
                std::max(residual, wide::geodesic_residual<3>(reference::all_corners(mesh), found));
        }
        std::printf("%12g  %-14s %10.1e  (bound of the distance)\n", ratio, "geodesic", residual);
    }
}

} // namespace

/// Argument: cells along an edge of the box that is timed, 55 (a million tets) unless given.
int main(int argc, char** argv) {
    const int n = argc > 1 ? std::stoi(argv[1]) : 55;
    print_times(n, 0);
    print_times(n, 1e-6);
    print_accuracy<2>();
    print_accuracy<3>();
    print_accuracy_of_means();
}
