// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Accuracy of the element metric beside the paper's equation (5), time and memory of the nodal
/// metric. Prints the tables of docs/theory/metric.md.
#include "core/base/parallel.h"
#include "core/metric/element_metric.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/metric/reference.h"
#include "tests/core/metric/wide_reference.h"

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <ctime>
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

/// Microseconds per element: processor time and wall clock, the best of five runs.
template <class Run>
void print_time(const std::string& what, std::size_t elements, const Run& run) {
    double cpu = HUGE_VAL;
    double wall = HUGE_VAL;
    for (int n = 0; n < 5; ++n) {
        const double cpu_start = cpu_seconds();
        const double wall_start = wall_seconds();
        run();
        cpu = std::min(cpu, cpu_seconds() - cpu_start);
        wall = std::min(wall, wall_seconds() - wall_start);
    }
    const double scale = 1e6 / static_cast<double>(elements);
    std::printf("%-28s %8.3f %8.3f\n", what.c_str(), cpu * scale, wall * scale);
}

void print_times(int n, double first) {
    const Mesh<3> mesh = shaken_box(n, first);
    const std::size_t m = mesh.elements.size();
    std::printf("\n%zu tets, %zu nodes, %s\n", m, mesh.points.size(),
                first > 0 ? "stretched layers" : "isotropic");
    std::printf("us per tet                        cpu     wall\n");
    set_thread_count(1);
    double sum = 0;
    print_time("element_metric", m, [&] {
        for (const Simplex<3>& s : mesh.elements) {
            sum += element_metric<3>(corners_of<3>(mesh, s)).sizes[0];
        }
    });
    std::array<Metric<3>, 48> metrics;
    print_time("element_metrics", m, [&] {
        for (std::size_t e = 0; e + metrics.size() <= m; e += metrics.size()) {
            element_metrics<3>(mesh, ElementId(e), metrics);
            sum += metrics[0].sizes[0];
        }
    });
    for (const Mean mean : {Mean::corrected, Mean::interpolation, Mean::log_euclidean}) {
        for (const int threads : {1, 2}) {
            set_thread_count(threads);
            const double before = peak_megabytes();
            print_time(std::string(name(mean)) + ", threads: " + std::to_string(threads), m, [&] {
                const MetricField<3> field = nodal_metric(mesh, mean);
                sum += field[NodeId(0)].sizes[0];
            });
            if (mean == Mean::corrected && threads == 1 && peak_megabytes() > before) {
                const auto field = static_cast<double>(mesh.points.size() * sizeof(Metric<3>));
                std::printf("    memory: %.0f MB above the mesh, of which %.0f MB the result\n",
                            peak_megabytes() - before, field / 1048576);
            }
        }
    }
    std::printf("    (sum of a few sizes, to be sure that they are made: %g)\n", sum);
}

} // namespace

/// Argument: cells along an edge of the box that is timed, 55 (a million tets) unless given.
int main(int argc, char** argv) {
    const int n = argc > 1 ? std::stoi(argv[1]) : 55;
    print_times(n, 0);
    print_times(n, 1e-6);
    print_accuracy<2>();
    print_accuracy<3>();
}
