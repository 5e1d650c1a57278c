// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/model_problem.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/geometry/volume.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/barycentric.h"
#include "core/mesh/boundary_projection.h"
#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco {
namespace {

/// D! times the volume.
template <int D>
double scaled_volume(const std::array<Vec<D>, D + 1>& x) {
    return volume(x).value * (D == 2 ? 2 : 6);
}

/// Row i of an element's matrix.
template <int D>
std::array<double, D + 1> element_row(const std::array<Vec<D>, D + 1>& x, std::size_t i,
                                      const ModelProblem<D>& problem) {
    const auto n = scaled_gradients(x);
    const double det = scaled_volume<D>(x);
    const double volumes = D == 2 ? 2 : 6;
    std::array<double, D + 1> row{};
    const Vec<D> flux = problem.diffusion * n[i] / (volumes * det);
    for (std::size_t j = 0; j <= D; ++j) {
        // Integral of phi_i b . grad phi_j = (V / (D + 1)) b . n_j / (D! V).
        row[j] = flux.dot(n[j]) + problem.velocity.dot(n[j]) / (volumes * (D + 1));
    }
    return row;
}

/// The pattern of P1 elements: each node with its neighbours and itself, ascending.
template <int D>
SparseMatrix empty_matrix(const Mesh<D>& mesh, const NodeNodes& neighbours) {
    const auto n = static_cast<Eigen::Index>(mesh.points.size());
    SparseMatrix A(n, n);
    A.resizeNonZeros(static_cast<Eigen::Index>(neighbours.values.size() + mesh.points.size()));
    int at = 0;
    for (const NodeId v : mesh.points.ids()) {
        A.outerIndexPtr()[v.index()] = at;
        bool self_done = false;
        for (const NodeId w : neighbours[v]) {
            if (!self_done && v < w) {
                A.innerIndexPtr()[at++] = v.value();
                self_done = true;
            }
            A.innerIndexPtr()[at++] = w.value();
        }
        if (!self_done) {
            A.innerIndexPtr()[at++] = v.value();
        }
    }
    A.outerIndexPtr()[n] = at;
    std::fill(A.valuePtr(), A.valuePtr() + at, 0.0);
    return A;
}

/// Adds the least symmetric diffusion between neighbours that leaves no positive off-diagonal
/// convection: d_ij = max(0, c_ij, c_ji) for the convection part c.
void add_upwinding(SparseMatrix& A, const SparseMatrix& diffusion) {
    const SparseMatrix transposed = SparseMatrix(A.transpose());
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        double added = 0;
        double* diagonal = nullptr;
        for (int k = A.outerIndexPtr()[i]; k < A.outerIndexPtr()[i + 1]; ++k) {
            if (A.innerIndexPtr()[k] == i) {
                diagonal = A.valuePtr() + k;
                continue;
            }
            // The stiffness matrix is symmetric, so both differences are the convection's.
            const double base = diffusion.valuePtr()[k];
            const double d =
                std::max({0.0, A.valuePtr()[k] - base, transposed.valuePtr()[k] - base});
            A.valuePtr()[k] -= d;
            added += d;
        }
        *diagonal += added;
    }
}

template <int D>
void fill(SparseMatrix& A, const Mesh<D>& mesh, const NodeElements& balls,
          const ModelProblem<D>& problem) {
    parallel_for(mesh.points.size(), 2048, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const NodeId v(i);
            const int* const first = A.innerIndexPtr() + A.outerIndexPtr()[i];
            const int* const last = A.innerIndexPtr() + A.outerIndexPtr()[i + 1];
            for (const ElementId e : balls[v]) {
                const Simplex<D>& s = mesh.elements[e];
                const auto self =
                    static_cast<std::size_t>(std::find(s.begin(), s.end(), v) - s.begin());
                const auto row = element_row<D>(corners_of(mesh, s), self, problem);
                for (std::size_t j = 0; j <= D; ++j) {
                    const auto k = std::lower_bound(first, last, s[j].value()) - first;
                    A.valuePtr()[A.outerIndexPtr()[i] + k] += row[j];
                }
            }
        }
    });
}

} // namespace

template <int D>
SparseMatrix assemble(const Mesh<D>& mesh, const ModelProblem<D>& problem) {
    const NodeElements balls = node_elements(mesh);
    SparseMatrix A = empty_matrix(mesh, node_neighbours(mesh, balls));
    ModelProblem<D> diffusion = problem;
    diffusion.velocity.setZero();
    if (problem.velocity.isZero()) {
        fill(A, mesh, balls, diffusion);
        return A;
    }
    SparseMatrix stiffness = A;
    fill(stiffness, mesh, balls, diffusion);
    fill(A, mesh, balls, problem);
    add_upwinding(A, stiffness);
    return A;
}

template <int D>
Vector unit_load(const Mesh<D>& mesh) {
    Vector f = Vector::Zero(static_cast<Eigen::Index>(mesh.points.size()));
    for (const ElementId e : mesh.elements.ids()) {
        const double share = volume(corners_of(mesh, mesh.elements[e])).value / (D + 1);
        for (const NodeId v : mesh.elements[e]) {
            f[v.value()] += share;
        }
    }
    return f;
}

template <int D>
std::vector<NodeId> free_nodes(const Mesh<D>& mesh, const ModelProblem<D>& problem) {
    const auto& chosen = problem.dirichlet_patches;
    IdVector<NodeId, std::uint8_t> fixed(mesh.points.size(), 0);
    std::vector<int> seen;
    for (const FaceId f : outer_faces(mesh)) {
        const int patch = mesh.patch[f];
        if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), patch) == chosen.end()) {
            continue;
        }
        if (std::find(seen.begin(), seen.end(), patch) == seen.end()) {
            seen.push_back(patch);
        }
        for (const NodeId v : mesh.faces[f]) {
            fixed[v] = 1;
        }
    }
    for (const int patch : chosen) {
        if (std::find(seen.begin(), seen.end(), patch) == seen.end()) {
            throw UsageError("patch " + std::to_string(patch) +
                             ", asked for as Dirichlet boundary, bounds nothing in this mesh");
        }
    }
    if (seen.empty()) {
        throw UsageError("the mesh has no boundary for Dirichlet conditions");
    }
    std::vector<NodeId> nodes;
    for (const NodeId v : mesh.points.ids()) {
        if (fixed[v] == 0) {
            nodes.push_back(v);
        }
    }
    return nodes;
}

SparseMatrix restricted(const SparseMatrix& matrix, const std::vector<NodeId>& rows,
                        const std::vector<NodeId>& columns) {
    std::vector<int> column(static_cast<std::size_t>(matrix.cols()), -1);
    for (std::size_t j = 0; j < columns.size(); ++j) {
        column[columns[j].index()] = static_cast<int>(j);
    }
    SparseMatrix out(static_cast<Eigen::Index>(rows.size()),
                     static_cast<Eigen::Index>(columns.size()));
    out.reserve(matrix.nonZeros());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        out.startVec(static_cast<Eigen::Index>(i));
        for (SparseMatrix::InnerIterator it(matrix, rows[i].value()); it; ++it) {
            if (const int j = column[static_cast<std::size_t>(it.col())]; j >= 0) {
                out.insertBack(static_cast<Eigen::Index>(i), j) = it.value();
            }
        }
    }
    out.finalize();
    return out;
}

Vector restricted(const Vector& vector, const std::vector<NodeId>& rows) {
    Vector out(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        out[static_cast<Eigen::Index>(i)] = vector[rows[i].value()];
    }
    return out;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template SparseMatrix assemble(const Mesh<D>&, const ModelProblem<D>&);                        \
    template Vector unit_load(const Mesh<D>&);                                                     \
    template std::vector<NodeId> free_nodes(const Mesh<D>&, const ModelProblem<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
