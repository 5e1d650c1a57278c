# SPDX-License-Identifier: AGPL-3.0-or-later
"""Checked by mypy, and never run: what users write has the types that it looks like."""

import threading

import numpy as np
from numpy.typing import NDArray

import ameco


def report(fraction: float, step: str) -> bool:
    print(f"{fraction:.0%} {step}")
    return True


def coarse_nodes(path: str) -> NDArray[np.float64]:
    stop = threading.Event()
    mesh: ameco.Mesh = ameco.read(path)
    metric: ameco.MetricField = ameco.target_metric(mesh, factor=2)
    sizes: NDArray[np.float64] = metric.sizes
    levels: ameco.Hierarchy = ameco.hierarchy(
        mesh, 3, factor=[2, 2, 4], freeze=["wing", 3], progress=report, cancel=stop
    )
    last: ameco.Level = levels[-1]
    count: int = len(mesh.elements) + len(sizes)
    built = ameco.mesh(mesh.nodes, mesh.elements, patch_names={1: "wing"})
    print(count, built.check().valid, levels.transfer(0).shape)
    adapted: ameco.Mesh = ameco.remesh(mesh, metric, node_nested=True, freeze=[3]).mesh
    finer, at_nodes, told = ameco.remesh(adapted, np.ones((7, 6)), progress=report, cancel=stop)
    print(len(finer.nodes), at_nodes.sizes.min(), told["conformity"])
    surface: ameco.Mesh = ameco.read_surface(path)
    air: ameco.Filled = ameco.fill(surface, farfield="sphere:20", regions=[((0, 0, 0), 2, 0.1)])
    print(air.report["added_nodes"], ameco.fill(surface, size=0.1, holes=[[0, 0, 0]]).mesh.elements)
    return last.mesh.nodes
