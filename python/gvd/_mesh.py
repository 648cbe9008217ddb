"""Meshes, and what is measured on them."""
from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal, Optional, Union, overload

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _vtk
from ._calls import name_bytes
from ._error import refuse
from ._handles import Handle
from ._object import Floats, Ids, Object, PathLike, Writable, figure, run, threads_of, view, warn
from ._options import described, file_name, flag, real
from ._points import Curves, Points, as_array, join, make_entries, one_point, plain
from ._progress import reporting
from ._results import Balanced, Diagram, Distances, Isoline, Path, Relaxation, Remesh, Segmentation

_ROW_BYTES = 1 << 26
"""Rows of distances are computed in batches of about so many bytes."""

_SAVED = ("vertex_positions", "face_vertices", "vertex_of_input", "input_vertex", "input_polygon", "texture", "face_materials")
_SAVED_TEXTS = ("repairs", "materials", "material_files")
"""Of a mesh that is pickled, as the operation `saved_mesh` takes them."""


_SUMMARY = ("vertices", "edges", "faces", "components", "boundary_loops", "euler_characteristic", "area", "bbox_diagonal")


class Mesh(Writable):
    """A triangle mesh: `vertices` (n, 3), float64, in mesh units, and `faces` (m, 3), int32.

    Mesh(V, F) takes arrays or lists: V (n, 3) numbers, F (m, k) integers, k >= 3; polygons are cut into triangles. Mesh(thing)
    takes what has `vertices` and `faces`, as trimesh has them, or `points` with `faces` or `cells`, as PyVista and meshio
    have them.
    `on_defect`: "error" refuses non-manifold edges, inconsistent orientation, unused vertices and the like; "repair"
    repairs what loses nothing and says so in a warning; "largest" also keeps the largest component only.
    `input_vertex` and `input_face` then say which rows of V and F the mesh's elements come from. The mesh of a result
    (a cut, a remesh) is its own input. Meshes can be pickled, for other processes.

    Points of a mesh are given in one of these ways, one or many:

    - a vertex: 7, or [3, 17, 99], integers;
    - (face, barycentric): (12, (0.2, 0.3, 0.5)), a list of such pairs, or Points(faces, weights);
    - a position: (0.5, 1.0, 0.0) or an array (n, 3) of floats, moved to the nearest point of the surface.

    Lengths are in the units of `vertices`. Results do not depend on `threads` (0: all cores).

    >>> import gvd
    >>> square = gvd.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
    >>> square
    gvd.Mesh(4 vertices, 2 faces)
    >>> square.distances(0).round(3)
    array([0.   , 1.   , 1.414, 1.   ])
    """

    _kind = "mesh"

    def __init__(self, vertices: Any, faces: Optional[ArrayLike] = None, *,
                 on_defect: Literal["error", "repair", "largest"] = "error", weld: Union[None, bool, float] = None) -> None:
        if faces is None:
            vertices, faces = _arrays_of(vertices)
        at, corners = as_array("vertices", vertices), as_array("faces", faces)
        if at.ndim != 2 or at.shape[1] != 3:
            refuse(f"vertices: an array (n, 3) is needed, not {at.shape}")
        if corners.dtype.kind == "f" or corners.ndim != 2 or corners.shape[1] < 3:
            refuse(f"faces: an array (m, 3) of integers is needed, not {corners.dtype} {corners.shape}")
        self._make({"on_defect": on_defect, "weld": weld}, [plain(at), plain(corners)])

    def _make(self, options: dict[str, Any], arrays: list[NDArray[Any]]) -> None:
        """Becomes the mesh of the operation `mesh`, and tells what was repaired."""
        if isinstance(options["weld"], bool):
            options["weld"] = 0.0 if options["weld"] else None
        super().__init__(run("mesh", None, options, {}, arrays)[0], ())
        for note in self.figures["repairs"]:
            warn(note)

    @classmethod
    def _wrap(cls, handle: Handle) -> Mesh:
        mesh = cls.__new__(cls)
        Object.__init__(mesh, handle, ())
        return mesh

    def _save(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        texts = {name: self.figures[name] for name in _SAVED_TEXTS if self.figures[name]}
        return ("saved_mesh", None, texts, [numpy.array(self._array(name)) for name in _SAVED]), {}

    def __repr__(self) -> str:
        return f"gvd.Mesh({len(self.vertices)} vertices, {len(self.faces)} faces)"

    vertices: Floats = view("vertex_positions", "Positions (n, 3), a view.")
    faces: Ids = view("face_vertices", "Vertices of the faces (m, 3), a view.")
    input_vertex: Ids = view("input_vertex", "The input's vertex for each vertex, -1 for the midpoint of a split edge; a view.")
    input_face: Ids = view("input_polygon", "The input's polygon for each face; a view.")
    vertex_of_input: Ids = view("vertex_of_input", "The vertex that each vertex of the input became, -1 for none; a view.")

    @property
    def texture_coordinates(self) -> Optional[Floats]:
        """u and v of the faces' corners (m, 3, 2), v upwards, NaN where there are none; a view. None without a texture."""
        corners = self._array("texture")
        return corners.reshape(-1, 3, 2) if len(corners) else None

    area: float = figure("area", "Of all faces, square mesh units.")

    @property
    def bounds(self) -> Floats:
        """The least and the largest coordinates (2, 3), mesh units."""
        return numpy.stack([self.vertices.min(axis=0), self.vertices.max(axis=0)])

    @property
    def summary(self) -> dict[str, Any]:
        """Numbers of vertices, edges, faces, components and boundary loops, Euler characteristic, area and diagonal, by
        their names."""
        return {name: self.figures[name] for name in _SUMMARY}

    def to_vtk(self) -> Any:
        """The mesh as vtkPolyData."""
        return _vtk.surface(self.vertices, self.faces)

    # ---- points and curves

    def points(self, points: Any, *, max_snap: Optional[float] = None) -> Points:
        """Points as faces and barycentric coordinates. `max_snap`: the farthest that a position may be, mesh units."""
        return self._sample({"points": make_entries("points", points), "max_snap": max_snap})

    def _sample(self, options: dict[str, Any], names: Mapping[str, str] = {}) -> Points:
        made, _ = run("sample", self, options, names=names)
        return Points(made.array("points_faces"), made.array("points_bary"), self)

    def positions(self, points: Any) -> Floats:
        """Positions (n, 3) of points."""
        return self.points(points).position

    def curves(self, curves: Union[PathLike, Sequence[Any]], *, closed: bool = False, angle: Optional[float] = None,
               max_snap: Optional[float] = None) -> Curves:
        """Curves as generators, which `voronoi`, `distances`, `nearest`, `path`, `isolines` and `segment` take.

        "boundary" or "creases", whose faces differ by more than `angle` degrees (default 40), or "creases:30" in one; the path
        of a file, as --curves reads it; or a list of polylines, each of points in their order. Shortest paths join those that have no
        face in common. `closed` joins the last point of each polyline to its first.

        >>> import gvd
        >>> mesh = gvd.read("data/half_sphere.off")
        >>> rim, arch = mesh.curves("boundary"), mesh.curves([[0, 9, 40]])
        >>> len(rim), float(mesh.distances(rim).max().round(2))
        (1, 1.57)
        """
        given = _make_curves(curves, closed, angle)
        made, _ = run("curves", self, {"curves": given, "max_snap": max_snap})
        offsets, at = made.array("offsets").tolist(), made.array("positions")
        given.positions.extend([] for _ in range(made.figures()["count"]))
        for curve, begin, end in zip(made.array("curve").tolist(), offsets, offsets[1:]):
            given.positions[curve].append(at[begin:end])
        return given

    @described("sample", without="points generators vertices max_snap merge_coincident")
    def sample(self, count: Optional[int] = None, **options: Any) -> Points:
        """Points that are spread over the surface: `count` of them, or as many as leave no point farther than `radius`."""
        if count is None and options.get("radius") is None:
            refuse("sample: how many points? Give a count or a radius")
        return self._sample({"count": count, **options})

    def farthest(self, count: int, *, seed: int = 0) -> Points:
        """`count` points, each as far as possible from all before it.

        >>> import gvd
        >>> gvd.read("data/figure.obj").farthest(3).face
        array([ 541, 3833, 3438], dtype=int32)
        """
        return self.sample(count, seed=seed)

    # ---- distances

    def _measure(self, points: Any, options: dict[str, Any], names: Mapping[str, str] = {}) -> tuple[Handle, tuple[Any, ...]]:
        """The operation `distances` from points or curves."""
        source = _sources("from", points, names.get("points", "points"))
        if not isinstance(points, Curves):
            source["keep_coincident"] = True
        return run("distances", self, {**source, **options}, names=names)

    @described("distances", without="from curves merge_coincident keep_coincident mesh_vertices paths isolines levels logarithm")
    def distances(self, points: Any, *, each: bool = False, out: Any = None, **options: Any) -> Floats:
        """Exact distances of all vertices (or of the points `to`) to the nearest of `points` or curves: an array (n).

        With `each`, one row for each point: an array (points, n). `out`: an array or numpy.memmap of this shape that
        gets the rows, so that memory holds a few of them only. What no point reaches is infinitely far.
        """
        if not flag("each", each):
            if out is not None:
                refuse("out: only rows are written to it; add each=True")
            return self.nearest(points, **options)[0]
        source = self.points(points)
        shape = (len(source), len(self.vertices) if options.get("to") is None else len(self._targets(options)["to"]))
        matrix: Floats = numpy.empty(shape) if out is None else out
        if getattr(matrix, "shape", None) != shape or matrix.dtype.kind != "f":
            refuse(f"out: an array {shape} of floats is needed, not {getattr(out, 'shape', type(out).__name__)} of {getattr(out, 'dtype', 'objects')}")
        for begin, rows in self._batches(source, {**options, "began": time.monotonic()}):
            matrix[begin : begin + len(rows)] = rows
        return matrix

    def _targets(self, options: dict[str, Any]) -> dict[str, Any]:
        """Moves the targets to the surface once."""
        if options.get("to") is not None and not isinstance(options["to"], Points):
            given = {"points": make_entries("to", options["to"]), "max_snap": options.get("max_snap")}
            options["to"] = self._sample(given, {"points": "to"})
        return options

    @described("distances", without="from curves each merge_coincident keep_coincident mesh_vertices paths isolines levels logarithm")
    def distance_rows(self, points: Any, **options: Any) -> Iterator[Floats]:
        """The rows of `distances(points, each=True)`, one after the other, in bounded memory and with all cores.

        >>> import gvd
        >>> square = gvd.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
        >>> [float(row.max().round(3)) for row in square.distance_rows([0, (1, (0.5, 0.5, 0.0))])]
        [1.414, 0.707]
        """
        source = self.points(points)
        self._targets(options)
        return (row for _, rows in self._batches(source, options) for row in rows)

    def _batches(self, source: Points, options: dict[str, Any]) -> Iterator[tuple[int, Floats]]:
        """Rows of distances, a batch at a time: eight for each core where these take little memory."""
        options = self._targets({**options, "each": True, "mesh_vertices": options.get("to") is None})
        columns = len(self.vertices) if options.get("to") is None else len(options["to"])
        cores = max(threads_of(options), 0) or os.cpu_count() or 1
        size = max(cores, min(8 * cores, _ROW_BYTES // (8 * columns)))
        with reporting(options.pop("progress", None)) as callback:
            for begin in range(0, len(source), size):
                end = min(begin + size, len(source))

                def part(step: str, fraction: float, begin: int = begin, end: int = end) -> Any:
                    return callback and callback(step, (begin + (end - begin) * fraction) / len(source))

                made, _ = self._measure(source[begin:end], {**options, "progress": part if callback else None})
                yield begin, made.array("rows")

    @described("distances", without="from curves each merge_coincident keep_coincident mesh_vertices paths isolines levels logarithm")
    def nearest(self, points: Any, **options: Any) -> tuple[Floats, Ids]:
        """Distances to the nearest of `points` or curves, and which one it is (-1: none reaches), both (n)."""
        made, _ = self._measure(points, options)
        if options.get("to") is None:
            return made.array("vertex_distances"), made.array("vertex_labels")
        return made.array("rows")[0], made.array("nearest")

    @overload
    def path(self, start: Union[int, tuple[int, Any], tuple[float, float, float]], end: Any, **options: Any) -> Path: ...

    @overload
    def path(self, start: Any, end: Any, **options: Any) -> Union[Path, list[Path]]: ...

    @described("distances", without="from to curves each paths isolines levels logarithm merge_coincident keep_coincident mesh_vertices")
    def path(self, start: Any, end: Any, **options: Any) -> Union[Path, list[Path]]:
        """A shortest path from `start` to `end`, or to the nearest of several ends or of curves. Several starts: a list.

        >>> import gvd
        >>> square = gvd.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
        >>> square.path(1, 3).positions
        array([[1. , 0. , 0. ],
               [0.5, 0.5, 0. ],
               [0. , 1. , 0. ]])
        """
        starts = make_entries("start", start)
        of = Distances(*self._measure(end, {**options, "to": starts, "paths": True}, {"to": "start", "points": "end"}))
        points, offsets = of._points("path"), of._array("path_offsets").tolist()
        rows = of.figures["paths"]
        paths = [Path(of, i, points[offsets[i]:offsets[i + 1]], numpy.inf if row["length"] is None else row["length"], row["complete"],
                      row["source"]) for i, row in enumerate(rows)]
        return paths[0] if starts.single else paths

    @described("distances", without="from to curves each paths levels logarithm merge_coincident keep_coincident mesh_vertices")
    def isolines(self, points: Any, isolines: Union[float, ArrayLike], **options: Any) -> list[Isoline]:
        """The curves of equal distance from the nearest of `points` or curves, at each multiple of `isolines`, mesh units, or at
        these distances, if they are a list.

        >>> import gvd
        >>> rings = gvd.read("data/half_sphere.off").isolines(0, 0.5)
        >>> sorted({ring.level for ring in rings})[:2]
        [0.5, 1.0]
        """
        if isolines is None:
            refuse("isolines: a distance, or a list of ascending ones, is needed, not None")
        option = "levels" if isinstance(isolines, (list, tuple)) or getattr(isolines, "ndim", 0) > 0 else "isolines"
        of = Distances(*self._measure(points, {**options, option: isolines}, {"levels": "isolines"}))
        at, offsets = of._points("isoline"), of._array("isoline_offsets").tolist()
        return [Isoline(level, bool(closed), at[begin:end]) for level, closed, begin, end in
                zip(of._array("isoline_levels").tolist(), of._array("isoline_closed").tolist(), offsets, offsets[1:])]

    @described("distances", without="from to curves each paths isolines levels logarithm merge_coincident keep_coincident mesh_vertices")
    def log_map(self, point: Any, **options: Any) -> Floats:
        """The logarithm of every vertex at a point, (n, 2): the vector in whose direction the shortest path departs.

        Its length is the distance, in mesh units. The x axis is the direction of the first edge at the point: see
        gvd/geodesic_tracing.hpp. NaN where no path leads.
        """
        given = one_point("point", point)
        return self._measure(given, {**options, "logarithm": True}, {"points": "point"})[0].array("logarithms")

    # ---- diagrams and what is made of them

    @described("diagram", without="count sampling seed radius generators vertices curves balance shares editable")
    def voronoi(self, points: Any, **options: Any) -> Diagram:
        """The geodesic Voronoi diagram of points or curves.

        >>> import gvd
        >>> diagram = gvd.read("data/figure.obj").voronoi([0, 1000, 2000])
        >>> len(diagram.cells), diagram.check()
        (3, [])
        """
        return Diagram(*run("diagram", self, {**options, **_sources("generators", points)}, names={"generators": "points"}))

    @described("diagram", without="count sampling seed radius generators vertices curves method front balance editable")
    def balance(self, points: Any, *, density: Optional[ArrayLike] = None, **options: Any) -> Balanced:
        """The diagram of points with weights by which all cells have the same area.

        `density`: a number above 0 for each vertex or face, of which cells have equal integrals instead.

        >>> import gvd
        >>> mesh = gvd.read("data/figure.obj")
        >>> areas = mesh.balance(mesh.farthest(24)).masses
        >>> bool(areas.std() < 1e-6 * areas.mean())
        True
        """
        balance = "area" if density is None else density
        given = {**options, "generators": make_entries("points", points), "balance": balance}
        diagram = Diagram(*run("diagram", self, given, names={"generators": "points", "balance": "density"}))
        found = diagram.figures["balance"]
        return Balanced(diagram, diagram._array("balance.masses"), diagram._array("balance.targets"),
                        [tuple(cells) for cells in found["tied"] or []], found["converged"])

    @described("segment", without="cut uv", cut="call diagram.cut() of the result", uv="call diagram.cut(uv=...) of the result")
    def segment(self, count: Optional[int] = None, **options: Any) -> Segmentation:
        """A label for every face: the regions of `count` sampled points, of given `generators`, or of a covering `radius`.

        As gvd-segment does it. `regions.diagram.cut()` splits the faces instead. Docs: docs/guide/segment.md.

        >>> import gvd
        >>> mesh = gvd.read("data/figure.obj")
        >>> regions = mesh.segment(30)
        >>> regions.labels.shape, regions.labels.max()
        ((5876,), 29)
        >>> mesh.segment(per_region=2, within=regions.labels).labels.max()
        59
        """
        return Segmentation(*run("segment", self, {"count": count, **options}))

    @described("lloyd")
    def lloyd(self, count: Optional[int] = None, **options: Any) -> Relaxation:
        """Moves generators to the centroids of their cells: evenly spread samples. As gvd-lloyd does it: docs/guide/lloyd.md.

        >>> import gvd
        >>> samples = gvd.read("data/figure.obj").lloyd(50)
        >>> bool(samples.energies[-1] < samples.energies[0])
        True
        """
        return Relaxation(*run("lloyd", self, {"count": count, **options}))

    @described("remesh", without="map", map="call map() of the result")
    def remesh(self, count: Optional[int] = None, **options: Any) -> Remesh:
        """A coarse mesh with the topology of this one: `count` vertices or a few more. As gvd-remesh does it.

        In place of `count`: `generators`, a covering `radius`, `target_edge` (mean length of its edges) or `error` (as few
        vertices as keep within this distance, in mesh units or as "1%" of the diagonal). Docs: docs/guide/remesh.md.

        >>> import gvd
        >>> coarse = gvd.read("data/figure.obj").remesh(200)
        >>> coarse.mesh.summary["euler_characteristic"], coarse.map().one_to_one
        (0, True)
        """
        return Remesh(*run("remesh", self, {"count": count, **options}))


def _sources(option: str, points: Any, name: str = "points") -> dict[str, Any]:
    """Points or curves as an option; `name` is that of the function's parameter."""
    return {"curves": points} if isinstance(points, Curves) else {option: make_entries(name, points)}


def _arrays_of(thing: Any) -> tuple[Any, Any]:
    """Vertices and faces of a mesh of another package."""
    at = getattr(thing, "vertices", getattr(thing, "points", None))
    faces = getattr(thing, "faces", getattr(thing, "regular_faces", None))
    if faces is None and isinstance(cells := getattr(thing, "cells", None), (list, tuple)):  # meshio: blocks of cells of one type
        blocks = [block if isinstance(block, tuple) else (getattr(block, "type", ""), getattr(block, "data", None)) for block in cells]
        polygons = [as_array("cells", block[1]) for block in blocks if len(block) == 2 and str(block[0]) in ("triangle", "quad", "polygon")]
        if len({block.shape[1:] for block in polygons}) == 1:
            faces = numpy.concatenate(polygons)
    if at is None or faces is None:
        refuse(f"Mesh: arrays of vertices and faces are needed, or a mesh with `vertices` and `faces`, or with `points` and `faces` "
               f"or `cells`, whose polygons have equally many corners; not {type(thing).__name__}")
    flat = as_array("faces", faces)
    if flat.ndim == 1:  # PyVista: each polygon after the number of its corners
        size = int(flat[0])
        if size < 3 or len(flat) % (size + 1) or (flat.reshape(-1, size + 1)[:, 0] != size).any():
            refuse("faces: polygons of equally many corners are needed, each behind the number of its corners; cut them into triangles")
        faces = flat.reshape(-1, size + 1)[:, 1:]
    return at, faces


def _make_curves(curves: Any, closed: bool, angle: Optional[float]) -> Curves:
    """Curves as the library takes them: a word, the name of a file, or points with the places where each curve begins."""
    arrays: list[NDArray[Any]] = []
    if isinstance(curves, (str, bytes, os.PathLike)):
        if closed:
            refuse("closed: it is for polylines")
        if angle is not None and curves != "creases":
            refuse('angle: it is for "creases"')
        if curves not in ("boundary", "creases") and not (isinstance(curves, str) and curves.startswith("creases:")):
            return Curves({"file": file_name(curves, arrays)}, arrays, [])
        if angle is not None and not 0 < float(real("angle", angle)) < 180:
            refuse(f"angle: a number above 0 and below 180, in degrees, is needed, not {angle}")
        return Curves(curves if angle is None else f"creases:{float(angle)}", [], [])
    if isinstance(curves, numpy.ndarray) or not isinstance(curves, Iterable):
        refuse(f"curves: a word, a path or a list of polylines is needed, not {type(curves).__name__}")
    lines = [make_entries(f"curves[{i}]", line) for i, line in enumerate(curves)]
    if not lines:
        refuse("curves: empty")
    offsets = numpy.cumsum([0, *(line.size() for line in lines)]).tolist()
    return Curves({"points": join(lines).option(arrays), "offsets": offsets, "closed": flag("closed", closed)}, arrays, [])


@described("mesh", without="file content weld")
def read(path: PathLike, *, weld: Union[None, bool, float] = None, **options: Any) -> Mesh:
    """Reads an OBJ, PLY, OFF, STL, VTP, VTU, legacy VTK, glTF, GIFTI, MNI or FreeSurfer file, packed by gzip or not.

    Defects are repaired where that loses nothing, with a warning for each kind. `weld`: True joins vertices at the
    same place, a number also those at most so many mesh units apart.

    >>> import gvd
    >>> gvd.read("data/torus.ply").summary["euler_characteristic"]
    0
    """
    mesh = Mesh.__new__(Mesh)
    mesh._make({**options, "file": name_bytes(path), "weld": weld}, [])
    return mesh


def read_values(path: PathLike) -> Floats:
    """The numbers of a file that has one for each vertex, or each face.

    .label.gii, .shape.gii, .func.gii, FreeSurfer's .annot and values such as lh.curv, .npy, .csv, or text.
    """
    return run("values", None, {"file": name_bytes(path)})[0].array("values")


def read_properties(path: PathLike) -> dict[str, dict[str, Floats]]:
    """The properties of a PLY but coordinates and texture: of "vertex" and of "face", by their names.

    There is a number for each vertex and each polygon of the file. `mesh.input_vertex` and `mesh.input_face` lead to them
    from the mesh that `read` makes of it. Lists are left out. Other formats have none.
    """
    made, _ = run("properties", None, {"file": name_bytes(path)})
    found: dict[str, dict[str, Floats]] = {"vertex": {}, "face": {}}
    for name in made.figures()["names"]:
        element, own = name.split(" ", 1)
        found[element][own] = made.array(name)
    return found
