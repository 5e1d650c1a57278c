// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/metric/wide_reference.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>

namespace ameco::wide {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;
template <int D>
using WideMat = std::array<std::array<Wide, D>, D>; // by rows

template <int D>
WideMat<D> zero() {
    WideMat<D> A;
    for (auto& row : A) {
        row.fill(0);
    }
    return A;
}

template <int D>
WideMat<D> transposed(const WideMat<D>& A) {
    WideMat<D> B;
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) {
            B[i][j] = A[j][i];
        }
    }
    return B;
}

template <int D>
WideMat<D> product(const WideMat<D>& A, const WideMat<D>& B) {
    WideMat<D> C = zero<D>();
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) {
            for (int k = 0; k < D; ++k) {
                C[i][j] += A[i][k] * B[k][j];
            }
        }
    }
    return C;
}

template <int D>
WideMat<D> inverse(const WideMat<D>& A) {
    WideMat<D> B;
    if constexpr (D == 2) {
        const Wide det = A[0][0] * A[1][1] - A[0][1] * A[1][0];
        B = {{{A[1][1] / det, -A[0][1] / det}, {-A[1][0] / det, A[0][0] / det}}};
    } else {
        Wide det = 0;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
                B[i][j] = A[a][c] * A[b][d] - A[a][d] * A[b][c];
            }
            det += A[0][i] * B[i][0];
        }
        for (auto& row : B) {
            for (Wide& x : row) {
                x /= det;
            }
        }
    }
    return B;
}

template <int D>
struct Spectrum {
    std::array<Wide, D> values; ///< ascending
    WideMat<D> vectors;         ///< columns
};

/// Jacobi's method.
template <int D>
Spectrum<D> eigen(WideMat<D> A) {
    Spectrum<D> result;
    WideMat<D> V = zero<D>();
    for (int i = 0; i < D; ++i) {
        V[i][i] = 1;
    }
    bool rotated = true;
    for (int sweep = 0; rotated && sweep < 30; ++sweep) {
        rotated = false;
        for (int i = 0; i < D; ++i) {
            for (int j = i + 1; j < D; ++j) {
                if (A[i][j] * A[i][j] <= 1e-90 * abs(A[i][i] * A[j][j]) || abs(A[i][j]) < 1e-80) {
                    continue;
                }
                rotated = true;
                const Wide theta = (A[j][j] - A[i][i]) / (2 * A[i][j]);
                const Wide t = (theta < 0 ? -1 : 1) / (abs(theta) + sqrt(theta * theta + 1));
                const Wide c = 1 / sqrt(t * t + 1);
                const Wide s = t * c;
                for (int k = 0; k < D; ++k) {
                    const Wide x = A[k][i];
                    A[k][i] = c * x - s * A[k][j];
                    A[k][j] = s * x + c * A[k][j];
                    const Wide v = V[k][i];
                    V[k][i] = c * v - s * V[k][j];
                    V[k][j] = s * v + c * V[k][j];
                }
                for (int k = 0; k < D; ++k) {
                    const Wide x = A[i][k];
                    A[i][k] = c * x - s * A[j][k];
                    A[j][k] = s * x + c * A[j][k];
                }
            }
        }
    }
    std::array<int, D> order;
    for (int i = 0; i < D; ++i) {
        order[i] = i;
    }
    std::sort(order.begin(), order.end(), [&](int i, int j) { return A[i][i] < A[j][j]; });
    for (int k = 0; k < D; ++k) {
        result.values[k] = A[order[k]][order[k]];
        for (int i = 0; i < D; ++i) {
            result.vectors[i][k] = V[i][order[k]];
        }
    }
    return result;
}

/// V f(values) V^T.
template <int D, class F>
WideMat<D> apply(const Spectrum<D>& e, const F& f) {
    WideMat<D> A = zero<D>();
    for (int k = 0; k < D; ++k) {
        const Wide value = f(e.values[k]);
        for (int i = 0; i < D; ++i) {
            for (int j = 0; j < D; ++j) {
                A[i][j] += value * e.vectors[i][k] * e.vectors[j][k];
            }
        }
    }
    return A;
}

/// M^-1 of an element: 2/(D+1) times the sum of x x^T, (5).
template <int D>
WideMat<D> inverse_metric(const Corners<D>& points) {
    WideMat<D> sum = zero<D>();
    for (int a = 0; a <= D; ++a) {
        for (int b = 0; b < a; ++b) {
            for (int i = 0; i < D; ++i) {
                for (int j = 0; j < D; ++j) {
                    sum[i][j] += (Wide(points[a][i]) - points[b][i]) *
                                 (Wide(points[a][j]) - points[b][j]) * 2 / (D + 1);
                }
            }
        }
    }
    return sum;
}

/// F with M = F^T F.
template <int D>
WideMat<D> factor(const Metric<D>& metric) {
    WideMat<D> F;
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) {
            F[i][j] = Wide(metric.directions(j, i)) / metric.sizes[i];
        }
    }
    return F;
}

Wide log_of(const Wide& x) {
    return log(x);
}

} // namespace

template <int D>
Vec<D> sizes(const Corners<D>& points) {
    const Spectrum<D> e = eigen<D>(inverse_metric<D>(points));
    Vec<D> result;
    for (int i = 0; i < D; ++i) {
        result[i] = static_cast<double>(Wide(sqrt(e.values[i])));
    }
    return result;
}

template <int D>
Vec<D> sizes_of_tensor(const Tensor<D>& tensor) {
    WideMat<D> A;
    std::size_t n = 0;
    for (int i = 0; i < D; ++i) {
        for (int j = i; j < D; ++j) {
            A[i][j] = A[j][i] = tensor[n++];
        }
    }
    const Spectrum<D> e = eigen<D>(A);
    Vec<D> result;
    for (int i = 0; i < D; ++i) {
        result[i] = static_cast<double>(Wide(1 / sqrt(e.values[D - 1 - i])));
    }
    return result;
}

template <int D>
Metric<D> mean(const std::vector<Corners<D>>& elements, Mean mean) {
    WideMat<D> sum = zero<D>();
    std::array<Wide, D> sorted;
    sorted.fill(0);
    for (const Corners<D>& points : elements) {
        const Spectrum<D> e = eigen<D>(inverse_metric<D>(points));
        const WideMat<D> A = apply<D>(e, [&](const Wide& x) {
            return mean == Mean::log_euclidean ? Wide(log(x) / 2) : Wide(sqrt(x));
        });
        for (int i = 0; i < D; ++i) {
            sorted[i] += sqrt(e.values[i]) / elements.size();
            for (int j = 0; j < D; ++j) {
                sum[i][j] += A[i][j] / elements.size();
            }
        }
    }
    const Spectrum<D> e = eigen<D>(sum);
    Metric<D> result;
    for (int k = 0; k < D; ++k) {
        const Wide own = mean == Mean::log_euclidean ? Wide(exp(e.values[k])) : e.values[k];
        result.sizes[k] = static_cast<double>(mean == Mean::corrected ? sorted[k] : own);
        for (int i = 0; i < D; ++i) {
            result.directions(i, k) = static_cast<double>(e.vectors[i][k]);
        }
    }
    return result;
}

template <int D>
double geodesic_residual(const std::vector<Corners<D>>& elements, const Metric<D>& R) {
    // In the frame of R, the inverse of a metric M is F M^-1 F^T, and its logarithm minus that of
    // M.
    const WideMat<D> F = factor(R);
    WideMat<D> sum = zero<D>();
    for (const Corners<D>& points : elements) {
        const WideMat<D> A = product<D>(product<D>(F, inverse_metric<D>(points)), transposed<D>(F));
        const WideMat<D> L = apply<D>(eigen<D>(A), log_of);
        for (int i = 0; i < D; ++i) {
            for (int j = 0; j < D; ++j) {
                sum[i][j] += L[i][j] / elements.size();
            }
        }
    }
    Wide square = 0;
    for (const auto& row : sum) {
        for (const Wide& x : row) {
            square += x * x;
        }
    }
    return static_cast<double>(Wide(sqrt(square)));
}

template <int D>
Tangent<D> log_map(const Metric<D>& base, const Metric<D>& other) {
    const WideMat<D> K = product<D>(factor(other), inverse<D>(factor(base)));
    const WideMat<D> L = apply<D>(eigen<D>(product<D>(transposed<D>(K), K)), log_of);
    Tangent<D> tangent;
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) {
            tangent.X(i, j) = static_cast<double>(L[i][j]);
        }
    }
    return tangent;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template Vec<D> sizes<D>(const Corners<D>&);                                                   \
    template Vec<D> sizes_of_tensor<D>(const Tensor<D>&);                                          \
    template Metric<D> mean<D>(const std::vector<Corners<D>>&, Mean);                              \
    template double geodesic_residual<D>(const std::vector<Corners<D>>&, const Metric<D>&);        \
    template Tangent<D> log_map<D>(const Metric<D>&, const Metric<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco::wide
