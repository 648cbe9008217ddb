"""Diagrams, and faces labelled or cut by them."""
from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Optional

import numpy
from numpy.typing import NDArray

from . import _gvd, _vtk
from ._files import Writable, forward
from ._options import checked
from ._points import Points
from ._progress import Progress, reporting

if TYPE_CHECKING:
    from ._mesh import Mesh

Floats = NDArray[numpy.float64]


class Bisector(NamedTuple):
    """The polyline between two cells.

    `left` and `right` are the cells beside it, seen from outside along `points`. `ends` are the branch points at its
    ends, -1 for an end on the boundary. A `closed` one has no ends and does not repeat its first point.
    """

    left: int
    right: int
    closed: bool
    ends: tuple[int, int]
    points: Points
    positions: Floats


class BranchPoints(NamedTuple):
    """The n points of three and more cells: `positions` (n, 3), `distances` (n) to their generators, and `generators`,
    a tuple for each, counter-clockwise."""

    points: Points
    positions: Floats
    distances: Floats
    generators: list[tuple[int, ...]]


class Cell(NamedTuple):
    """The points that are nearest to one generator. `area` is in square mesh units; the Euler characteristic is 1 for a
    disc; `neighbours` are the cells with a bisector in common, ascending."""

    generator: int
    area: float
    euler_characteristic: int
    components: int
    boundary_loops: int
    neighbours: tuple[int, ...]


class Diagram(Writable):
    """A geodesic Voronoi diagram. Ids of generators are their places in the list that it was made of.

    `to_file` writes what gvd-lloyd writes with -o: also .json (everything), and .txt and .csv (the generators).
    """

    _native: _gvd.Diagram

    def __init__(self, mesh: Mesh, native: _gvd.Diagram) -> None:
        self.mesh = mesh
        self._native = native

    def __repr__(self) -> str:
        return (f"gvd.Diagram({len(self.cells)} cells, {len(self.branch_points.distances)} branch points, "
                f"{self._native.bisector_count()} bisectors)")

    labels = forward(_gvd.Diagram.labels, "The nearest generator of each vertex (n), -1 where none reaches; a view.")
    distances = forward(_gvd.Diagram.distances,
                        "The distance of each vertex to its generator (n), infinite where none reaches; a view.")
    face_labels = forward(_gvd.Diagram.face_labels,
                          "The generator of each face that lies in one cell (m), -1 for faces that bisectors cut; a view.")
    weights = forward(_gvd.Diagram.weights, "The weights of the generators, mesh units; empty without; a view.")
    length = forward(_gvd.Diagram.length, "Length of all bisectors, mesh units.")

    @property
    def generators(self) -> Points:
        """The generators; views."""
        return Points(*self._native.generators())

    @functools.cached_property
    def branch_points(self) -> BranchPoints:
        """The points where three or more cells meet; views."""
        points, positions, distances, generators = self._native.branch_points()
        return BranchPoints(Points(*points), positions, distances, generators)

    @functools.cached_property
    def bisectors(self) -> list[Bisector]:
        """The curves between cells."""
        found = (self._native.bisector(i) for i in range(self._native.bisector_count()))
        return [Bisector(left, right, closed, ends, Points(*points), positions)
                for left, right, closed, ends, points, positions in found]

    @functools.cached_property
    def cells(self) -> list[Cell]:
        """A cell for each generator."""
        return [Cell(*cell) for cell in self._native.cells()]

    def check(self) -> list[str]:
        """What violates the invariants of a diagram, one line each: normally nothing (see gvd/check.hpp)."""
        return self._native.check()

    @checked
    def segment(self, *, labels: Literal["smooth", "nearest"] = "smooth", progress: Progress = None) -> Segmentation:
        """A label for every face: see Mesh.segment."""
        with reporting(progress) as callback:
            return Segmentation(self, self._native.segment(labels, callback))

    @checked
    def cut(self, *, uv: Optional[Literal["logmap", "flat"]] = None, progress: Progress = None) -> Cut:
        """The mesh with its faces split along the bisectors, so that each lies in one cell. `uv` gives it texture
        coordinates, as gvd-segment --uv does: see Cut.charts. "flat" needs cells that are discs. An .obj then has the
        regions' own materials: the images of the mesh's do not fit."""
        with reporting(progress) as callback:
            return Cut(self, self._native.cut(uv, callback))

    def to_vtk(self) -> Any:
        """The surface as vtkPolyData, with Label and Distance of its vertices."""
        return _vtk.surface(self.mesh.vertices, self.mesh.faces,
                            points={"Label": self.labels, "Distance": self.distances})

    def bisectors_to_vtk(self) -> Any:
        """The bisectors as polylines of vtkPolyData, with Left and Right."""
        curves = [numpy.concatenate([b.positions, b.positions[:1]]) if b.closed else b.positions for b in self.bisectors]
        sides = {"Left": numpy.array([b.left for b in self.bisectors], numpy.int32),
                 "Right": numpy.array([b.right for b in self.bisectors], numpy.int32)}
        return _vtk.lines(curves, cells=sides)


class Balanced(NamedTuple):
    """A diagram whose weights give each cell its share: `masses` and `targets` of the cells, and `tied` sets of cells
    that have their targets together, but not each for itself. `converged`: all others have theirs."""

    diagram: Diagram
    masses: Floats
    targets: Floats
    tied: list[tuple[int, ...]]
    converged: bool


class Segmentation(Writable):
    """A label for every face of a mesh. `to_file` writes what gvd-segment writes with -o, .json included."""

    _native: _gvd.Segmentation

    def __init__(self, diagram: Diagram, native: _gvd.Segmentation) -> None:
        self.diagram = diagram
        self._native = native

    def __repr__(self) -> str:
        return f"gvd.Segmentation({len(self.diagram.generators.face)} regions, {len(self.labels)} faces)"

    labels = forward(_gvd.Segmentation.labels, "The label of each face (m), -1 where no generator reaches; a view.")
    without_face = forward(_gvd.Segmentation.without_face,
                           "Generators that own no face, because their cells lie inside faces of others; a view.")
    border_length = forward(_gvd.Segmentation.border_length,
                            "Length of the edges between labels, mesh units; of those inside regions, where these were given.")

    @property
    def regions(self) -> Optional[NDArray[numpy.int32]]:
        """The region of each face as `within` gave it (m), negative where it is left out; a view. None without `within`."""
        return self._native.numbers().get("region")

    @property
    def levels(self) -> list[NDArray[numpy.int32]]:
        """The labels of the faces at each level of `levels`, from the coarsest to `labels`; views."""
        return [labels for name, labels in self._native.numbers().items() if name.startswith("label_")]

    def to_vtk(self) -> Any:
        """The surface as vtkPolyData, with Label of its faces and Distance of its vertices."""
        mesh = self.diagram.mesh
        return _vtk.surface(mesh.vertices, mesh.faces, points={"Distance": self.diagram.distances},
                            cells={"Label": self.labels})


class Chart(NamedTuple):
    """A connected part of a region in the unit square. Areas are those of faces on the surface, square mesh units."""

    label: int
    faces: int
    area: float
    flipped_area: float
    torn_area: float
    unplaced_area: float
    stretch: float
    box: tuple[tuple[float, float], tuple[float, float]]
    origin: tuple[float, float]


class Cut(Writable):
    """A mesh that was split along bisectors. `to_file` writes what gvd-segment --cut writes, .json included."""

    _native: _gvd.Cut

    def __init__(self, diagram: Diagram, native: _gvd.Cut) -> None:
        self.diagram = diagram
        self._native = native

    def __repr__(self) -> str:
        return f"gvd.Cut({len(self.labels)} faces)"

    @functools.cached_property
    def mesh(self) -> Mesh:
        """The mesh: first the vertices of the input, in their order."""
        return self.diagram.mesh._wrap(self._native.mesh())

    labels = forward(_gvd.Cut.labels, "The label of each face, -1 where no generator reaches; a view.")
    parents = forward(_gvd.Cut.parents, "The face of the input that each face is a part of; a view.")
    vertex_labels = forward(_gvd.Cut.vertex_labels, "A nearest generator of each vertex; a view.")
    distances = forward(_gvd.Cut.distances, "The distance of each vertex to its generator, mesh units; a view.")

    scale = forward(_gvd.Cut.scale, "Texture units per mesh unit, the same for all charts; 0 without `uv`.")

    @property
    def charts(self) -> list[Chart]:
        """The charts whose texture coordinates `mesh` has, by their first face (see gvd/charts.hpp); none without `uv`."""
        return [Chart(*chart) for chart in self._native.charts()]

    def to_vtk(self) -> Any:
        """The mesh as vtkPolyData, with Label and Parent of its faces and Distance of its vertices."""
        return _vtk.surface(self.mesh.vertices, self.mesh.faces, points={"Distance": self.distances},
                            cells={"Label": self.labels, "Parent": self.parents})
