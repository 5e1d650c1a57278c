# SPDX-License-Identifier: AGPL-3.0-or-later
"""The compiled part: its classes, and functions whose arguments ameco/__init__.py names."""

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

version: str

class Error(Exception):
    """Trouble from outside: a file, an option, a mesh, a request to stop."""

    exit_code: int
    """That of the program in the same case."""

class FileError(Error, OSError):
    """A file cannot be opened, read or written."""

class InputError(Error, ValueError):
    """A mesh or metric is not usable."""

class UsageError(Error, ValueError):
    """An argument makes no sense."""

class NotConverged(Error, RuntimeError):
    """An iteration that was chosen does not converge."""

class CheckFailed(Error, RuntimeError):
    """What was made is not what it must be, and is not delivered."""

class Cancelled(Error):
    """The computation was asked to stop."""

class Finding:
    """One kind of defect: its name, how often it occurs, and the first place."""

    @property
    def defect(self) -> str: ...
    @property
    def count(self) -> int: ...
    @property
    def example(self) -> str: ...

class CheckReport:
    """What was found in a mesh: errors, and warnings of what is unusual but workable."""

    @property
    def valid(self) -> bool: ...
    @property
    def errors(self) -> list[Finding]: ...
    @property
    def warnings(self) -> list[Finding]: ...
    @property
    def interior_faces(self) -> int: ...
    @property
    def volume(self) -> float: ...
    @property
    def boundary_flux(self) -> float: ...

class Mesh:
    """Triangles (d = 2) or tetrahedra (d = 3); its arrays cannot be written to.

    Elements are positively oriented, the normals of faces point outwards.
    """

    __hash__: ClassVar[None]  # type: ignore[assignment]
    @property
    def dimension(self) -> int:
        """d, 2 or 3."""
    @property
    def nodes(self) -> NDArray[np.float64]:
        """(n, d) coordinates."""
    @property
    def elements(self) -> NDArray[np.int32]:
        """(m, d + 1) node numbers, from 0."""
    @property
    def regions(self) -> NDArray[np.int32]:
        """(m,) reference of each element."""
    @property
    def faces(self) -> NDArray[np.int32]:
        """(k, d) nodes of the boundary's faces."""
    @property
    def patches(self) -> NDArray[np.int32]:
        """(k,) patch (reference) of each face."""
    @property
    def patch_names(self) -> dict[int, str]: ...
    @property
    def labels(self) -> NDArray[np.int32]:
        """(n,) reference of each node, or (0,)."""
    @property
    def edges(self) -> NDArray[np.int32]:
        """(e, 2) nodes of curves on the boundary that the file lists; d = 3 only."""
    @property
    def edge_labels(self) -> NDArray[np.int32]:
        """(e,) reference of each."""
    @property
    def corners(self) -> NDArray[np.int32]:
        """Nodes that must stay."""
    @property
    def ridges(self) -> NDArray[np.int32]:
        """Sharp edges: places in `edges` (d = 3) or `faces` (d = 2)."""
    @property
    def required_nodes(self) -> NDArray[np.int32]: ...
    @property
    def required_edges(self) -> NDArray[np.int32]: ...
    @property
    def required_faces(self) -> NDArray[np.int32]: ...
    @property
    def required_elements(self) -> NDArray[np.int32]: ...
    @property
    def repairs(self) -> list[str]:
        """What was mended when the mesh was read or made, a line each."""
    def check(self) -> CheckReport:
        """Tests everything that must hold of a valid mesh, with exact orientations."""
    def write(self, path: str | PathLike[str], format: str = ...) -> None:
        """Writes in the format of the suffix, or in the one named (`ameco formats`)."""
    def __eq__(self, other: object) -> bool: ...

class MetricField:
    """One metric per node: symmetric positive definite tensors M = V diag(h)^-2 V^T."""

    def __init__(self, tensors: ArrayLike) -> None:
        """From tensors as `tensors` gives them."""
    @property
    def sizes(self) -> NDArray[np.float64]:
        """(n, d) half axes h of the unit balls, ascending: lengths."""
    @property
    def directions(self) -> NDArray[np.float64]:
        """(n, d, d) orthonormal frames V: directions[i, :, k] belongs to sizes[i, k]."""
    @property
    def tensors(self) -> NDArray[np.float64]:
        """(n, 3) xx xy yy, or (n, 6) xx xy xz yy yz zz."""
    @property
    def aspect_ratio(self) -> NDArray[np.float64]:
        """(n,) largest over smallest size."""
    def write(self, path: str | PathLike[str]) -> None:
        """Writes .solb (Medit binary) or .sol (Medit text)."""
    def __len__(self) -> int: ...

class Level:
    """A mesh of a hierarchy with what was measured on it."""

    @property
    def number(self) -> int:
        """0 is the finest."""
    @property
    def mesh(self) -> Mesh: ...
    @property
    def metric(self) -> MetricField:
        """Natural metric of the mesh."""
    @property
    def parent(self) -> NDArray[np.int32]:
        """(n,) node of the next finer level at the same place; -1 for none. Empty on level 0."""
    @property
    def statistics(self) -> dict[str, Any]:
        """Nodes, ratio, prediction, aspect ratios, conformity, verdicts: as in hierarchy.json."""
    @property
    def seconds(self) -> dict[str, Any]:
        """What the level cost: as in timing.json."""

def settings() -> dict[str, dict[str, Any]]:
    """Options that coarsen takes, by name: "default", "accepts", "help"."""

def cases() -> dict[str, str]:
    """Names and summaries of the meshes that `case` makes."""

def set_threads(threads: int) -> None:
    """Threads to compute with; 0: all of the machine's. Results do not depend on it."""

def threads() -> int: ...
def read_metric(path: str | PathLike[str]) -> MetricField:
    """Reads .sol or .solb."""

def conformity(mesh: Mesh, metric: MetricField) -> dict[str, Any]:
    """How well a mesh fits a metric: lengths of its edges, quality of its elements."""

def complexity(mesh: Mesh, metric: MetricField) -> float:
    """Integral of sqrt(det M): the number of elements goes with it."""

def read(path: str | PathLike[str], repair: bool, ridge_angle: float) -> Mesh: ...
def make_mesh(given: Mapping[str, Any], repair: bool, ridge_angle: float) -> Mesh: ...
def case(name: str, parameters: Mapping[str, str]) -> Mesh: ...
def natural_metric(
    mesh: Mesh, options: Mapping[str, Any], progress: object, cancel: object
) -> MetricField: ...
def target_metric(
    mesh: Mesh, metric: MetricField, options: Mapping[str, Any]
) -> MetricField: ...
def coarsen_mesh(
    fine: Mesh, options: Mapping[str, Any], progress: object, cancel: object
) -> Level: ...
def coarsen_level(
    fine: Level, options: Mapping[str, Any], progress: object, cancel: object
) -> Level: ...
def hierarchy(
    mesh: Mesh, options: Mapping[str, Any], progress: object, cancel: object
) -> tuple[list[Level], str]: ...
def read_surface(path: str | PathLike[str]) -> Mesh:
    """Reads a surface, or the boundary of a mesh, as a mesh of faces without elements."""

def fill(
    surface: Mesh,
    metric: MetricField | None,
    options: Mapping[str, Any],
    progress: object,
    cancel: object,
) -> tuple[Mesh, dict[str, Any]]: ...
def remesh(
    mesh: Mesh,
    metric: MetricField | None,
    size: float | None,
    options: Mapping[str, Any],
    progress: object,
    cancel: object,
) -> tuple[Mesh, MetricField, dict[str, Any]]: ...
def write_hierarchy(
    folder: PathLike[str],
    source: PathLike[str],
    levels: Sequence[Level],
    status: str,
    options: Mapping[str, Any],
    transfer: bool,
) -> None: ...
def transfer(
    fine: Mesh,
    coarse: Mesh,
    parent: ArrayLike,
    check: bool,
    progress: object,
    cancel: object,
) -> tuple[
    tuple[int, int],
    NDArray[np.float64],
    NDArray[np.int32],
    NDArray[np.int32],
]: ...
