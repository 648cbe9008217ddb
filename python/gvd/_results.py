"""What calls give: diagrams, labelled and cut faces, relaxed generators, coarse meshes, paths and isolines."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy
from numpy.typing import NDArray

from . import _calls, _vtk
from ._object import Floats, Ids, Object, PathLike, Writable, figure, run, view
from ._options import described
from ._points import Points

if TYPE_CHECKING:
    from ._mesh import Mesh


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

    @property
    def positions(self) -> Floats:
        """Positions of the points (k, 3)."""
        return self.points.position

    def __repr__(self) -> str:
        return f"gvd.Bisector({self.left} | {self.right}, {len(self.points)} points)"


class BranchPoints(NamedTuple):
    """The n points of three and more cells: `positions` (n, 3), `distances` (n) to their generators, and the generators of
    point i, counter-clockwise: `generator_array[offsets[i]:offsets[i + 1]]`."""

    points: Points
    positions: Floats
    distances: Floats
    generator_array: Ids
    offsets: NDArray[numpy.int64]

    @property
    def generators(self) -> list[tuple[int, ...]]:
        """The generators of each, as a tuple."""
        return [tuple(self.generator_array[begin:end].tolist()) for begin, end in zip(self.offsets[:-1], self.offsets[1:])]

    def __repr__(self) -> str:
        return f"gvd.BranchPoints({len(self.distances)})"


class Cell(NamedTuple):
    """The points that are nearest to one generator. `area` is in square mesh units; the Euler characteristic is 1 for a
    disc; `neighbours` are the cells with a bisector in common, ascending."""

    generator: int
    area: float
    euler_characteristic: int
    components: int
    boundary_loops: int
    neighbours: tuple[int, ...]


class Cells(Sequence[Cell]):
    """The cells of a diagram: an index gives one, and their numbers are arrays: `area`, `euler_characteristic`,
    `components`, `boundary_loops`, and `neighbour_array[offsets[i]:offsets[i + 1]]` for the neighbours of cell i."""

    def __init__(self, diagram: Diagram) -> None:
        self.area: Floats = diagram._array("cell_areas")
        self.euler_characteristic: Ids = diagram._array("cell_euler_characteristics")
        self.components: Ids = diagram._array("cell_components")
        self.boundary_loops: Ids = diagram._array("cell_boundary_loops")
        self.neighbour_array: Ids = diagram._array("cell_neighbours")
        self.offsets: NDArray[numpy.int64] = diagram._array("cell_neighbours_offsets")

    def __len__(self) -> int:
        return len(self.area)

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        i = range(len(self))[index]
        neighbours = self.neighbour_array[self.offsets[i]:self.offsets[i + 1]]
        return Cell(i, float(self.area[i]), int(self.euler_characteristic[i]), int(self.components[i]), int(self.boundary_loops[i]),
                    tuple(neighbours.tolist()))

    def __repr__(self) -> str:
        return f"gvd.Cells({len(self)})"


class Diagram(Writable):
    """A geodesic Voronoi diagram. Ids of generators are their places in the list that it was made of.

    `to_file` writes what gvd-lloyd writes with -o: also .json (everything), and .txt and .csv (the generators).
    """

    _kind = "diagram"

    @property
    def mesh(self) -> Mesh:
        """The mesh that it is on."""
        return self._mesh

    def __repr__(self) -> str:
        return (f"gvd.Diagram({len(self._array('cell_areas'))} cells, {len(self._array('branch_point_distances'))} branch points, "
                f"{len(self._array('bisector_left'))} bisectors)")

    labels: Ids = view("vertex_labels", "The nearest generator of each vertex (n), -1 where none reaches; a view.")
    distances: Floats = view("vertex_distances",
                             "The distance of each vertex to its generator (n), infinite where none reaches; a view.")
    face_labels: Ids = view("face_labels",
                            "The generator of each face that lies in one cell (m), -1 for faces that bisectors cut; a view.")
    weights: Floats = view("weights", "The weights of the generators, mesh units; empty without; a view.")
    areas: Floats = view("cell_areas", "The area of each cell, square mesh units; a view.")
    length: float = figure("length", "Length of all bisectors, mesh units.")

    @property
    def generators(self) -> Points:
        """The generators; views."""
        return self._points("generators")

    @property
    def branch_points(self) -> BranchPoints:
        """The points where three or more cells meet; views."""
        arrays = (self._array(f"branch_point_{name}") for name in ("positions", "distances", "generators", "generators_offsets"))
        return BranchPoints(self._points("branch_point"), *arrays)

    @property
    def bisectors(self) -> list[Bisector]:
        """The curves between cells."""
        found: list[Bisector] = self._keep("bisectors", self._make_bisectors)
        return found

    def _make_bisectors(self) -> list[Bisector]:
        points, offsets = self._points("bisector"), self._array("bisector_offsets").tolist()
        sides = zip(self._array("bisector_left").tolist(), self._array("bisector_right").tolist(),
                    self._array("bisector_closed").tolist(), self._array("bisector_ends").tolist())
        return [Bisector(left, right, bool(closed), (ends[0], ends[1]), points[offsets[i]:offsets[i + 1]])
                for i, (left, right, closed, ends) in enumerate(sides)]

    @property
    def cells(self) -> Cells:
        """A cell for each generator."""
        return Cells(self)

    def check(self) -> list[str]:
        """What violates the invariants of a diagram, one line each: normally nothing (see gvd/check.hpp)."""
        violations: list[str] = run("check", self, {})[0].figures()["violations"]
        return violations

    @described("label", without="cut uv")
    def segment(self, **options: Any) -> Segmentation:
        """A label for every face: see Mesh.segment."""
        return Segmentation(*run("label", self, options))

    @described("label", without="cut labels")
    def cut(self, **options: Any) -> Cut:
        """The mesh with its faces split along the bisectors, so that each lies in one cell.

        With `uv`, .charts are those of the regions. "flat" needs cells that are discs. An .obj then has the regions' own
        materials: the images of the mesh's do not fit.
        """
        return Cut(*run("label", self, options, {"cut": True}))

    def to_vtk(self) -> Any:
        """The surface as vtkPolyData, with Label and Distance of its vertices."""
        return _vtk.surface(self.mesh.vertices, self.mesh.faces, points={"Label": self.labels, "Distance": self.distances})

    def bisectors_to_vtk(self) -> Any:
        """The bisectors as polylines of vtkPolyData, with Left and Right."""
        curves = [numpy.concatenate([b.positions, b.positions[:1]]) if b.closed else b.positions for b in self.bisectors]
        return _vtk.lines(curves, cells={"Left": self._array("bisector_left"), "Right": self._array("bisector_right")})


class Balanced(NamedTuple):
    """A diagram whose weights give each cell its share: `masses` and `targets` of the cells, and `tied` sets of cells
    that have their targets together, but not each for itself. `converged`: all others have theirs."""

    diagram: Diagram
    masses: Floats
    targets: Floats
    tied: list[tuple[int, ...]]
    converged: bool

    def __repr__(self) -> str:
        return f"gvd.Balanced({len(self.masses)} cells, {'converged' if self.converged else 'not converged'})"


class Result(Writable):
    """A result that has a mesh, a diagram and labels of regions."""

    @property
    def diagram(self) -> Diagram:
        """The diagram of the generators."""
        diagram: Diagram = self._keep("diagram", lambda: Diagram(None, ("part", self, {"part": "diagram"}, [])))
        return diagram

    @property
    def generators(self) -> Points:
        """The generators; views."""
        return self._points("generators")


class Labelled(Result):
    """A result that has regions."""

    labels: Ids = view("face_labels", "The label of each face (m), -1 where no generator reaches; a view.")

    @property
    def colors(self) -> Floats:
        """The colour of each face (m, 4) for matplotlib, as in files and on the page: red, green, blue, alpha."""
        palette = self._native.part("colors").array("colors")  # the last one is that of faces without a label
        return numpy.column_stack([palette[self.labels] / 255.0, numpy.ones(len(self.labels))])


class Segmentation(Labelled):
    """A label for every face of a mesh. `to_file` writes what gvd-segment writes with -o, .json included."""

    _kind = "segment"

    def __repr__(self) -> str:
        return f"gvd.Segmentation({len(self._array('generators_faces'))} regions, {len(self.labels)} faces)"

    @property
    def without_face(self) -> Ids:
        """Generators that own no face, because their cells lie inside faces of others."""
        return numpy.array(self.figures["generators_without_face"] or [], numpy.int32)

    border_length: float = figure("border_length",
                                  "Length of the edges between labels, mesh units; of those inside regions, where these were given.")
    areas: Floats = view("regions.area", "The area of the faces of each label, square mesh units; a view.")

    @property
    def regions(self) -> Ids:
        """The region of each face as `within` gave it (m), negative where it is left out; without `within` 0; a view."""
        return self._array("region") if "within" in self._recipe[2] else numpy.zeros(len(self.labels), numpy.int32)

    @property
    def levels(self) -> list[Ids]:
        """The labels of the faces at each level of `levels`, from the coarsest to `labels`; views."""
        return [self._array(f"label_{i + 1}") for i in range(len(self._recipe[2].get("levels", ())))]

    def _names_to_save(self) -> list[str]:
        levels = [f"label_{i + 1}" for i in range(len(self._recipe[2].get("levels", ())))]
        return [*super()._names_to_save(), "regions.area", *levels] + (["region"] if "within" in self._recipe[2] else [])

    def to_vtk(self) -> Any:
        """The surface as vtkPolyData, with Label of its faces and Distance of its vertices."""
        return _vtk.surface(self._mesh.vertices, self._mesh.faces, points={"Distance": self._array("vertex_distances")},
                            cells={"Label": self.labels})


class Chart(NamedTuple):
    """A connected part of a region in the unit square: its share that is flipped or torn off, its largest stretch, the least
    and the largest corner of its `box`, and the place of its generator."""

    label: int
    faces: int
    area: float
    flipped_share: float
    torn_share: float
    stretch: float
    box: tuple[tuple[float, ...], tuple[float, ...]]
    origin: tuple[float, ...]


class Cut(Labelled):
    """A mesh that was split along bisectors. `to_file` writes what gvd-segment --cut writes, .json included."""

    _kind = "segment"

    def __repr__(self) -> str:
        return f"gvd.Cut({len(self.labels)} faces)"

    @property
    def mesh(self) -> Mesh:
        """The mesh: first the vertices of the input, in their order."""
        return self._part("cut_mesh")

    parents: Ids = view("face_parents", "The face of the input that each face is a part of; a view.")
    vertex_labels: Ids = view("vertex_labels", "A nearest generator of each vertex; a view.")
    distances: Floats = view("vertex_distances", "The distance of each vertex to its generator, mesh units; a view.")

    @property
    def scale(self) -> float:
        """Texture units per mesh unit, the same for all charts; 0 without `uv`."""
        return float((self.figures["charts"] or {"scale": 0})["scale"])

    @property
    def charts(self) -> list[Chart]:
        """The charts whose texture coordinates `mesh` has, by their first face (see gvd/charts.hpp); none without `uv`."""
        rows = (self.figures["charts"] or {"charts": []})["charts"]
        return [Chart(row["label"], row["faces"], row["area"], row["flipped_share"], row.get("torn_share", 0.0), row["stretch"],
                      (tuple(row.get("box", ())[:2]), tuple(row.get("box", ())[2:])), tuple(row.get("origin", (0.0, 0.0)))) for row in rows]

    def to_vtk(self) -> Any:
        """The mesh as vtkPolyData, with Label and Parent of its faces and Distance of its vertices."""
        return _vtk.surface(self.mesh.vertices, self.mesh.faces, points={"Distance": self.distances},
                            cells={"Label": self.labels, "Parent": self.parents})


class Relaxation(Result):
    """Generators at the centroids of their cells. `to_file` writes what gvd-lloyd writes with -o, .txt and .csv (the
    generators) and .json included."""

    _kind = "lloyd"

    def __repr__(self) -> str:
        return f"gvd.Relaxation({len(self.generators)} generators, energy {self.energies[-1]:.6g})"

    energies: Floats = view("energies", "The energy at the start and after each iteration, mesh units to the fourth; a view.")
    areas: Floats = view("areas", "The area of each cell, square mesh units; a view.")
    cell_energies: Floats = view("cell_energies",
                                 "The squared distance over each cell, integrated; mesh units to the fourth; a view.")
    residual: float = figure("residual", "The largest distance of a generator from its centroid, mesh units.")
    stop: str = figure("stop", 'Why it ended: "centroids", "energy", "no descent", "prediction" or "iterations".')

    def _names_to_save(self) -> list[str]:
        return [*super()._names_to_save(), "energies"]

    def points_to_file(self, path: PathLike) -> None:
        """Writes the generators with normals, areas and energies (.ply, .xyz, .npy), as gvd-lloyd --points does."""
        self._write(path, part="points")

    def to_vtk(self) -> Any:
        """The surface as vtkPolyData, with Label and Distance of its vertices."""
        return self.diagram.to_vtk()


class Remesh(Result):
    """A coarse mesh: a vertex for each generator, a triangle for each branch point. `to_file` writes what gvd-remesh
    writes with -o, .json included."""

    _kind = "remesh"

    def __repr__(self) -> str:
        return f"gvd.Remesh({len(self.mesh.vertices)} vertices, {len(self.mesh.faces)} faces)"

    @property
    def surface(self) -> Mesh:
        """The mesh that it was made of."""
        return self._mesh

    @property
    def mesh(self) -> Mesh:
        """The coarse mesh."""
        return self._part("mesh")

    @described("map")
    def map(self, **options: Any) -> RemeshMap:
        """The map between the surface and the coarse mesh."""
        return RemeshMap(*run("map", self, options))

    def to_vtk(self) -> Any:
        """The coarse mesh as vtkPolyData."""
        return self.mesh.to_vtk()


class RemeshMap(Object):
    """Where the vertices of a surface are on its remesh, and where those of the remesh come from."""

    _kind = "remesh"

    def __repr__(self) -> str:
        return f"gvd.RemeshMap({len(self.points)} vertices to {len(self.origins)})"

    @property
    def points(self) -> Points:
        """For each vertex of the surface its point of the remesh; views."""
        return self._points("map_points", self._recipe[1].mesh)

    @property
    def origins(self) -> Points:
        """For each vertex of the remesh its point of the surface; views."""
        return self._points("map_origins")

    @property
    def one_to_one(self) -> bool:
        """Whether both come from a map that was checked to be one-to-one."""
        return bool(self.figures["map"]["one_to_one"])

    def to_file(self, path: PathLike) -> None:
        """Writes what gvd-remesh --map writes (JSON)."""
        _calls.write(self._native, path, {"part": "map"})


class Distances(Writable):
    """Distances with paths and isolines: what gvd-distance computes. `to_file` writes what it writes with -o."""

    _kind = "distances"


class Path:
    """A shortest path on a surface.

    `points` and `positions` (k, 3) run from start to end; `length` is in mesh units. `complete` is False where rounding
    ended the points at a vertex before the end; `length` is right nevertheless. `end` is the index of the end that was
    nearest, -1 where there is none: then the path has no points and its length is infinite.
    """

    def __init__(self, of: Distances, place: int, points: Points, length: float, complete: bool, end: int) -> None:
        self._of, self._place = of, place
        self.points: Points = points
        self.length: float = length
        self.complete: bool = complete
        self.end: int = end

    def __repr__(self) -> str:
        return f"gvd.Path({len(self.points)} points, length {self.length:.6g})"

    @property
    def positions(self) -> Floats:
        """Positions (k, 3) of the points."""
        return self.points.position

    def to_vtk(self) -> Any:
        """The path as a polyline of vtkPolyData."""
        return _vtk.lines([self.positions])

    def to_file(self, path: PathLike) -> None:
        """Writes .npy or .obj (the positions, as one polyline) or .csv (as gvd-distance --paths does).

        A complete file or none, as the other results do. A path of one point has no line in .obj."""
        self._of._write(path, part=f"path {self._place}")


class Isoline(NamedTuple):
    """A curve of equal distance, `level` from the sources. A `closed` one does not repeat its first point."""

    level: float
    closed: bool
    points: Points

    @property
    def positions(self) -> Floats:
        """Positions (k, 3) of the points."""
        return self.points.position

    def __repr__(self) -> str:
        return f"gvd.Isoline({self.level:.6g}, {len(self.points)} points)"
