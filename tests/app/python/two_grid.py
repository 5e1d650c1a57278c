# SPDX-License-Identifier: AGPL-3.0-or-later
"""Linear finite elements and a two-grid cycle in a few lines: what a solver does with a transfer."""

from __future__ import annotations

import math

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg


def stiffness(mesh):
    """Matrix of the Laplacian with linear elements, for all nodes."""
    d = mesh.dimension
    x = mesh.nodes[mesh.elements]  # (m, d + 1, d)
    edges = x[:, 1:] - x[:, :1]
    volume = np.abs(np.linalg.det(edges)) / math.factorial(d)
    gradients = np.linalg.inv(edges)  # column i: gradient of the basis function of node i + 1
    gradients = np.concatenate([-gradients.sum(axis=2, keepdims=True), gradients], axis=2)
    local = np.einsum("m,mki,mkj->mij", volume, gradients, gradients)
    n = len(mesh.nodes)
    i = np.repeat(mesh.elements, d + 1, axis=1).ravel()
    j = np.tile(mesh.elements, (1, d + 1)).ravel()
    return sp.coo_matrix((local.ravel(), (i, j)), shape=(n, n)).tocsr()


def inner(mesh):
    """Nodes that are not on the boundary, where values are given."""
    return np.setdiff1d(np.arange(len(mesh.nodes)), mesh.faces)


def contraction(A, P=None, sweeps=1, omega=2 / 3, cycles=20):
    """By how much damped Jacobi, with the coarse grid of P if given, shrinks the error in the end."""
    D = A.diagonal()
    coarse = None
    if P is not None:
        coarse = scipy.sparse.linalg.splu((P.T @ A @ P).tocsc())
    u = np.random.default_rng(7).standard_normal(A.shape[0])
    norms = []
    for _ in range(cycles):
        for _ in range(sweeps):
            u -= omega * (A @ u) / D
        if coarse is not None:
            u -= P @ coarse.solve(P.T @ (A @ u))
        for _ in range(sweeps):
            u -= omega * (A @ u) / D
        norms.append(math.sqrt(u @ (A @ u)))
    return norms[-1] / norms[-2]
