# SPDX-License-Identifier: AGPL-3.0-or-later
"""Mesh hierarchies for geometric multigrid from extremely stretched meshes.

    >>> import ameco
    >>> mesh = ameco.read("wing.meshb")
    >>> levels = ameco.hierarchy(mesh, 4)
    >>> P = levels.transfer(0)          # scipy.sparse.csr_matrix, from level 1 to level 0

Meshes, metrics and levels never change; their arrays look at ameco's memory without a copy and
cannot be written to. Computations release Python's lock and use all processors.

Arguments are those of the command line, with the same names and defaults ("-" is "_"):
docs/user/options.md. `progress` is called with the share done and the step; when it returns False
or raises, the computation stops. `cancel` is something with `is_set()`, such as a threading.Event.
What was unusual in a file, and what a format cannot carry, goes to the logger "ameco".
"""

from __future__ import annotations

import copyreg
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, Union, overload

from . import _core
from ._core import (
    Cancelled,
    CheckFailed,
    CheckReport,
    Error,
    FileError,
    Finding,
    InputError,
    Level,
    Mesh,
    MetricField,
    NotConverged,
    UsageError,
    cases,
    complexity,
    conformity,
    read_metric,
    read_surface,
    set_threads,
    settings,
    threads,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from scipy.sparse import csr_matrix  # type: ignore[import]

__version__ = _core.version

__all__ = [
    "Cancelled",
    "CheckFailed",
    "CheckReport",
    "Error",
    "FileError",
    "Filled",
    "Finding",
    "Hierarchy",
    "InputError",
    "Level",
    "Mesh",
    "MetricField",
    "NotConverged",
    "Remeshed",
    "UsageError",
    "case",
    "cases",
    "coarsen",
    "complexity",
    "conformity",
    "fill",
    "hierarchy",
    "mesh",
    "natural_metric",
    "read",
    "read_metric",
    "read_surface",
    "remesh",
    "set_threads",
    "settings",
    "target_metric",
    "threads",
    "transfer",
]

Progress = Callable[[float, str], object]


class Cancel(Protocol):
    """What can be asked whether to stop, from any thread: a threading.Event."""

    def is_set(self) -> bool: ...


def read(path: str | PathLike[str], *, repair: bool = True, ridge_angle: float = 60.0) -> Mesh:
    """Reads a mesh in any format of `ameco formats`.

    With `repair`, boundary faces that are missing are added (in patches bounded by edges that turn
    by more than `ridge_angle` degrees), faces are turned outwards, and nodes that no element uses
    are dropped; `Mesh.repairs` says what was done. Raises FileError or InputError.
    """
    return _core.read(path, repair, ridge_angle)


def mesh(
    nodes: ArrayLike,
    elements: ArrayLike,
    *,
    faces: ArrayLike | None = None,
    patches: ArrayLike | None = None,
    patch_names: Mapping[int, str] | None = None,
    regions: ArrayLike | None = None,
    labels: ArrayLike | None = None,
    edges: ArrayLike | None = None,
    edge_labels: ArrayLike | None = None,
    corners: ArrayLike | None = None,
    ridges: ArrayLike | None = None,
    required_nodes: ArrayLike | None = None,
    required_edges: ArrayLike | None = None,
    required_faces: ArrayLike | None = None,
    required_elements: ArrayLike | None = None,
    repair: bool = True,
    ridge_angle: float = 60.0,
) -> Mesh:
    """A mesh from arrays, which are copied.

    `nodes` (n, 2) or (n, 3); `elements` (m, 3) or (m, 4) node numbers from 0; `faces` (k, 2) or
    (k, 3) of the boundary, with their `patches` (k,), and `regions` (m,) of the elements. The rest
    is what files may declare besides (docs/user/formats.md). `repair` as for `read`. The mesh need
    not be valid: `Mesh.check` says what is wrong, and computations refuse it.
    """
    given = dict(
        nodes=nodes,
        elements=elements,
        faces=faces,
        patches=patches,
        patch_names=dict(patch_names or {}),
        regions=regions,
        labels=labels,
        edges=edges,
        edge_labels=edge_labels,
        corners=corners,
        ridges=ridges,
        required_nodes=required_nodes,
        required_edges=required_edges,
        required_faces=required_faces,
        required_elements=required_elements,
    )
    return _core.make_mesh(given, repair, ridge_angle)


def _from_pieces(pieces: dict[str, Any]) -> Mesh:
    return _core.make_mesh(pieces, False, 0)


def _pieces_of(given: Mesh) -> tuple[Callable[[dict[str, Any]], Mesh], tuple[dict[str, Any]]]:
    """A mesh as pickle stores it, for multiprocessing, MPI and copies."""
    return _from_pieces, ({name: getattr(given, name) for name in _PIECES},)


_PIECES = (
    "nodes",
    "elements",
    "faces",
    "patches",
    "patch_names",
    "regions",
    "labels",
    "edges",
    "edge_labels",
    "corners",
    "ridges",
    "required_nodes",
    "required_edges",
    "required_faces",
    "required_elements",
)
copyreg.pickle(Mesh, _pieces_of)


def case(name: str, **parameters: Union[str, float, int]) -> Mesh:
    """A mesh by formula: those of `ameco case --list`, which `cases()` names, too.

    Parameters are those of `ameco case NAME --help`: case("onera-m6", preset="m6-8k").
    """
    words = {key.replace("_", "-"): str(value) for key, value in parameters.items()}
    return _core.case(name, words)


def natural_metric(
    mesh: Mesh,
    *,
    mean: str = "blended",
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> MetricField:
    """The metric in which the mesh is unit, at its nodes (docs/theory/means.md)."""
    return _core.natural_metric(mesh, dict(mean=mean), progress, cancel)


def target_metric(
    mesh: Mesh,
    metric: MetricField | None = None,
    *,
    factor: float = 2.0,
    slack: float = 1.0,
    isotropic_below: float = 1.6,
    algorithm: str = "basic",
    gradation: float = 1.5,
    mean: str = "blended",
) -> MetricField:
    """The metric of the next coarser level, from the natural one (docs/theory/coarsening.md).

    `metric` is the natural metric if it is there already.
    """
    if metric is None:
        metric = natural_metric(mesh, mean=mean)
    options = dict(
        factor=factor,
        slack=slack,
        isotropic_below=isotropic_below,
        algorithm=algorithm,
        gradation=gradation,
    )
    return _core.target_metric(mesh, metric, options)


def coarsen(
    fine: Mesh | Level,
    *,
    factor: float = 2.0,
    target_ratio: float | None = None,
    slack: float = 1.0,
    isotropic_below: float = 1.6,
    algorithm: str = "basic",
    gradation: float = 1.5,
    mean: str = "blended",
    surface_deviation: float = 0.1,
    ridge_angle: float = 60.0,
    nodes: str = "nested",
    boundary: str = "coarsen",
    rebuild: str = "none",
    freeze: Sequence[int | str] = (),
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Level:
    """Makes the next coarser level of a mesh, or of a level.

    From a mesh, the result is level 1. A level remembers the corners, ridges and patches of its
    finest mesh, so make a level from the level before it, not from that level's mesh. Raises
    Cancelled when stopped, and CheckFailed when hardly any node can be removed.
    """
    options = dict(
        factor=factor,
        target_ratio=target_ratio,
        slack=slack,
        isotropic_below=isotropic_below,
        algorithm=algorithm,
        gradation=gradation,
        mean=mean,
        surface_deviation=surface_deviation,
        ridge_angle=ridge_angle,
        nodes=nodes,
        boundary=boundary,
        rebuild=rebuild,
        freeze=freeze,
    )
    if isinstance(fine, Level):
        return _core.coarsen_level(fine, options, progress, cancel)
    return _core.coarsen_mesh(fine, options, progress, cancel)


class Hierarchy(Sequence[Level]):
    """The levels of a mesh, finest first.

    `status` is "complete", "cannot be coarsened further" (as many levels as the mesh allows) or
    "cancelled" (stopped early; the levels that are there are good).
    """

    def __init__(self, levels: Sequence[Level], status: str, options: dict[str, Any]) -> None:
        self._levels = tuple(levels)
        self._options = options
        self.status = status

    def __len__(self) -> int:
        return len(self._levels)

    @overload
    def __getitem__(self, index: int) -> Level: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[Level]: ...

    def __getitem__(self, index: int | slice) -> Level | Sequence[Level]:
        return self._levels[index]

    def __iter__(self) -> Iterator[Level]:
        return iter(self._levels)

    def __repr__(self) -> str:
        nodes = " > ".join(str(len(level.mesh.nodes)) for level in self)
        return f"<ameco.Hierarchy: {nodes} nodes, {self.status}>"

    def transfer(self, k: int) -> csr_matrix:
        """Prolongation from level k + 1 to level k."""
        if not 0 <= k < len(self) - 1:
            raise IndexError(f"there are transfers 0 to {len(self) - 2}")
        return transfer(self[k], self[k + 1])

    def write(
        self, folder: str | PathLike[str], *, transfer: bool = False, force: bool = False
    ) -> None:
        """Writes the folder that `ameco coarsen` would: for `ameco report`, and other programs.

        `transfer` adds the prolongations. A folder that is not empty is replaced with `force` only.
        """
        target = Path(folder)
        if not force and target.exists() and any(target.iterdir()):
            raise UsageError(f"{target}: the folder is not empty: name another one, or force=True")
        with tempfile.TemporaryDirectory() as workspace:
            finest = Path(workspace) / "finest.meshb"
            self[0].mesh.write(finest)
            _core.write_hierarchy(
                target, finest, self._levels, self.status, self._options, transfer
            )


def hierarchy(
    mesh: Mesh,
    levels: int = 4,
    *,
    until_isotropic: bool = False,
    factor: float | Sequence[float] = 2.0,
    target_ratio: float | None = None,
    slack: float = 1.0,
    isotropic_below: float = 1.6,
    algorithm: str = "basic",
    gradation: float = 1.5,
    mean: str = "blended",
    surface_deviation: float = 0.1,
    ridge_angle: float = 60.0,
    nodes: str = "nested",
    boundary: str = "coarsen",
    rebuild: str = "none",
    freeze: Sequence[int | str] = (),
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Hierarchy:
    """Makes up to `levels` coarser levels: what `ameco coarsen` does.

    `factor` may be a list with one per level. When stopped after the first coarser level, the
    finished levels are returned with the status "cancelled"; before it, Cancelled is raised.
    """
    options = dict(
        levels=levels,
        until_isotropic=until_isotropic,
        factor=factor,
        target_ratio=target_ratio,
        slack=slack,
        isotropic_below=isotropic_below,
        algorithm=algorithm,
        gradation=gradation,
        mean=mean,
        surface_deviation=surface_deviation,
        ridge_angle=ridge_angle,
        nodes=nodes,
        boundary=boundary,
        rebuild=rebuild,
        freeze=freeze,
    )
    made, status = _core.hierarchy(mesh, options, progress, cancel)
    return Hierarchy(made, status, options)


class Filled(NamedTuple):
    """A filled surface, as `fill` makes it."""

    mesh: Mesh
    """Tets; the first nodes are those of the surface, in their order."""
    report: dict[str, Any]
    """Counts, and conformity to the metric: as `ameco fill --json` gives them."""


def fill(
    surface: Mesh,
    metric: MetricField | ArrayLike | None = None,
    *,
    size: float | None = None,
    growth: float = 0.2,
    farfield: str | None = None,
    holes: ArrayLike = (),
    regions: Sequence[tuple[Sequence[float], int] | tuple[Sequence[float], int, float]] = (),
    boundary: str = "keep",
    radius_edge: float = 1.6,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Filled:
    """Fills a closed surface, or the space around it, with tets: what `ameco fill` does.

    `surface` is one of `read_surface`, or a mesh whose boundary is meant. `metric` is known at the
    nodes of the surface, and grows with the distance. `farfield` is "box", "sphere", "box:20" or
    "sphere:20"; `holes` are points, `regions` points with a region and, perhaps, a size. Raises
    InputError that names the faces when the surface bounds no volume.
    """
    given = metric if metric is None or isinstance(metric, MetricField) else MetricField(metric)
    options = dict(
        size=size,
        growth=growth,
        farfield=farfield,
        holes=holes,
        regions=regions,
        boundary=boundary,
        radius_edge=radius_edge,
    )
    return Filled(*_core.fill(surface, given, options, progress, cancel))


class Remeshed(NamedTuple):
    """An adapted mesh, as `remesh` makes it."""

    mesh: Mesh
    """The adapted mesh."""
    metric: MetricField
    """The metric it was adapted to, at its nodes."""
    report: dict[str, Any]
    """Counts, conformity before and after, verdicts: as `ameco remesh --json` gives them."""


def remesh(
    mesh: Mesh,
    metric: MetricField | ArrayLike | None = None,
    *,
    size: float | None = None,
    interpolation: str = "corrected",
    node_nested: bool = False,
    engine: str = "fast",
    quality: str | None = None,
    passes: int = 20,
    surface_deviation: float = 0.1,
    ridge_angle: float = 60.0,
    freeze: Sequence[int | str] = (),
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Remeshed:
    """Adapts a mesh to any metric, finer or coarser: what `ameco remesh` does.

    `metric` has one tensor per node of `mesh`: a MetricField, or an array as `MetricField.tensors`;
    `size` stands for the same edge length everywhere. `quality` None is that of the engine. Raises
    Cancelled when stopped.
    """
    given = metric if metric is None or isinstance(metric, MetricField) else MetricField(metric)
    options = dict(
        interpolation=interpolation,
        node_nested=node_nested,
        engine=engine,
        quality=quality,
        passes=passes,
        surface_deviation=surface_deviation,
        ridge_angle=ridge_angle,
        freeze=freeze,
    )
    return Remeshed(*_core.remesh(mesh, given, size, options, progress, cancel))


def transfer(
    fine: Mesh | Level,
    coarse: Mesh | Level,
    *,
    check: bool = True,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> csr_matrix:
    """Prolongation from a coarse mesh to a fine one of the same domain (docs/theory/transfer.md).

    Row i holds the weights of fine node i at the coarse nodes; the restriction is the transpose.
    With `check`, raises CheckFailed unless rows sum to 1, linear functions are reproduced and
    every coarse node is referred to.
    """
    from scipy.sparse import csr_matrix

    parent: Any = coarse.parent if isinstance(coarse, Level) else ()
    fine_mesh = fine.mesh if isinstance(fine, Level) else fine
    coarse_mesh = coarse.mesh if isinstance(coarse, Level) else coarse
    shape, data, indices, indptr = _core.transfer(
        fine_mesh, coarse_mesh, parent, check, progress, cancel
    )
    return csr_matrix((data, indices, indptr), shape=shape, copy=False)
