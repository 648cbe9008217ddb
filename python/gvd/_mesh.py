"""Meshes, and what is measured on them."""
from __future__ import annotations

import os
import warnings
from collections.abc import Iterator, Sequence
from typing import Any, Literal, Optional, Union, overload

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _gvd, _vtk
from ._diagram import Balanced, Diagram, Segmentation
from ._error import refuse
from ._files import PathLike, Writable, forward
from ._options import checked
from ._path import Path
from ._points import Curves, Points, as_array, make_entries, one_of
from ._progress import Callback, Progress, part_of, reporting
from ._remesh import Relaxation, Remesh

Floats = NDArray[numpy.float64]

_ROW_BYTES = 1 << 26
"""Rows of distances are computed in batches of about so many bytes."""


class Mesh(Writable):
    """A triangle mesh: `vertices` (n, 3), float64, in mesh units, and `faces` (m, 3), int32.

    Mesh(V, F) takes arrays or lists: V (n, 3) numbers, F (m, k) integers, k >= 3; polygons are cut into triangles.
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

    _native: _gvd.Mesh

    @checked
    def __init__(self, vertices: ArrayLike, faces: ArrayLike, *,
                 on_defect: Literal["error", "repair", "largest"] = "error") -> None:
        at, corners = as_array("vertices", vertices), as_array("faces", faces)
        if at.ndim != 2 or at.shape[1] != 3:
            refuse(f"vertices: an array (n, 3) is needed, not {at.shape}")
        if corners.dtype.kind == "f" or corners.ndim != 2 or corners.shape[1] < 3:
            refuse(f"faces: an array (m, 3) of integers is needed, not {corners.dtype} {corners.shape}")
        self._native = _gvd.Mesh.from_arrays(at, corners, on_defect)
        self._warn()

    def _warn(self) -> None:
        """Tells what was repaired, as of the line that called Mesh or read."""
        for note in self._native.notes():
            warnings.warn(note, stacklevel=4)

    @classmethod
    def _wrap(cls, native: _gvd.Mesh) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._native = native
        return mesh

    def __repr__(self) -> str:
        return f"gvd.Mesh({len(self.vertices)} vertices, {len(self.faces)} faces)"

    vertices = forward(_gvd.Mesh.vertices, "Positions (n, 3), a view.")
    faces = forward(_gvd.Mesh.faces, "Vertices of the faces (m, 3), a view.")
    input_vertex = forward(_gvd.Mesh.input_vertex,
                           "The input's vertex for each vertex, -1 for the midpoint of a split edge; a view.")
    input_face = forward(_gvd.Mesh.input_face, "The input's polygon for each face; a view.")
    @property
    def texture_coordinates(self) -> Optional[Floats]:
        """u and v of the faces' corners (m, 3, 2), v upwards, NaN where there are none; a view. None without a texture."""
        corners = self._native.texture_coordinates()
        return corners.reshape(-1, 3, 2) if len(corners) else None

    summary = forward(_gvd.Mesh.summary, "Numbers of vertices, edges, faces, components and boundary loops, "
                                         "Euler characteristic, area and diagonal, by their names.")

    def to_vtk(self) -> Any:
        """The mesh as vtkPolyData."""
        return _vtk.surface(self.vertices, self.faces)

    def _resolve(self, name: str, points: Any, *, coincident: str = "keep",
                 max_snap: Optional[float] = None) -> _gvd.PointList:
        entries = make_entries(name, points)
        return self._native.resolve(name, entries[:3], max_snap, coincident)

    def _resolve_one(self, name: str, point: Any) -> _gvd.PointList:
        at = self._resolve(name, point)
        if len(at) != 1:
            refuse(f"{name}: one point is needed, not {len(at)}")
        return at

    @checked
    def points(self, points: Any, *, max_snap: Optional[float] = None) -> Points:
        """Points as faces and barycentric coordinates. `max_snap`: the farthest that a position may be, mesh units."""
        return Points(*self._resolve("points", points, max_snap=max_snap).arrays())

    def positions(self, points: Any) -> Floats:
        """Positions (n, 3) of points."""
        return self._native.positions(self._resolve("points", points))

    @checked
    def curves(self, curves: Union[PathLike, Sequence[Any]], *, closed: bool = False, angle: Optional[float] = None,
               max_snap: Optional[float] = None) -> Curves:
        """Curves as generators, which `voronoi`, `distances` and `nearest` take in place of points.

        "boundary" or "creases", whose faces differ by more than `angle` degrees (default 40); the path of a file, as
        --curves reads it; or a list of polylines, each of points in their order. Shortest paths join those that have no
        face in common. `closed` joins the last point of each polyline to its first.

        >>> import gvd
        >>> mesh = gvd.read("data/half_sphere.off")
        >>> rim, arch = mesh.curves("boundary"), mesh.curves([[0, 9, 40]])
        >>> len(rim), float(mesh.distances(rim).max().round(2))
        (1, 1.57)
        """
        if isinstance(curves, (str, os.PathLike)):
            if closed:
                refuse("closed: it is for polylines")
            if angle is not None and curves != "creases":
                refuse('angle: it is for "creases"')
            if isinstance(curves, str) and curves in ("boundary", "creases"):
                return Curves(self._native, _gvd.CurveSet.find(self._native, curves, angle))
            return Curves(self._native, _gvd.CurveSet.read(self._native, os.fspath(curves), max_snap))
        polylines: list[Any] = [make_entries(f"curves[{i}]", line)[:3] for i, line in enumerate(curves)]
        if not polylines:
            refuse("curves: empty")
        return Curves(self._native, _gvd.CurveSet.join(self._native, polylines, closed, max_snap))

    def _sources(self, points: Any, **options: Any) -> Union[_gvd.PointList, _gvd.CurveSet]:
        return points._native if isinstance(points, Curves) else self._resolve("points", points, **options)

    @checked
    def sample(self, n: Optional[int] = None, *, sampling: str = "farthest", seed: int = 0,
               radius: Optional[float] = None, progress: Progress = None) -> Points:
        """Points that are spread over the surface: `n` of them, or as many as leave no point farther than `radius`.

        `sampling`: "farthest", "random" (by area), "vertices" or "poisson" (evenly spaced).
        """
        one_of("sample", n, None, radius)
        return Points(*self._sample(_sampler(n, sampling, seed, radius), progress).arrays())

    @checked
    def farthest(self, n: int, *, seed: int = 0, progress: Progress = None) -> Points:
        """`n` points, each as far as possible from all before it.

        >>> import gvd
        >>> gvd.read("data/figure.obj").farthest(3).face
        array([ 541, 3833, 3438], dtype=int32)
        """
        return self.sample(n, seed=seed, progress=progress)

    def _sample(self, sampler: _gvd.Sampler, progress: Progress) -> _gvd.PointList:
        with reporting(progress) as callback:
            return self._native.sample(sampler, callback)

    @checked
    def distances(self, points: Any, *, each: bool = False, at: Any = None, out: Any = None, threads: int = 0,
                  progress: Progress = None) -> Floats:
        """Exact distances of all vertices (or of the points `at`) to the nearest of `points` or curves: an array (n).

        With `each`, one row for each point: an array (points, n). `out`: an array or numpy.memmap of this shape that
        gets the rows, so that memory holds a few of them only. What no point reaches is infinitely far.
        """
        if not each:
            if out is not None:
                refuse("out: only rows are written to it; add each=True")
            return self.nearest(points, at=at, threads=threads, progress=progress)[0]
        source, targets = self._resolve("points", points), None if at is None else self._resolve("at", at)
        shape = (len(source), len(self.vertices) if targets is None else len(targets))
        if out is not None and getattr(out, "shape", None) != shape:
            refuse(f"out: an array {shape} is needed, not {getattr(out, 'shape', type(out).__name__)}")
        if out is not None and numpy.dtype(getattr(out, "dtype", object)).kind != "f":
            refuse(f"out: an array of floats is needed, not of {getattr(out, 'dtype', 'objects')}")
        matrix: Floats = numpy.empty(shape) if out is None else out
        with reporting(progress) as callback:
            for begin, rows in self._batches(source, targets, threads, callback):
                matrix[begin : begin + len(rows)] = rows
        return matrix

    @checked
    def distance_rows(self, points: Any, *, at: Any = None, threads: int = 0,
                      progress: Progress = None) -> Iterator[Floats]:
        """The rows of `distances(points, each=True)`, one after the other, in bounded memory and with all cores.

        >>> import gvd
        >>> square = gvd.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
        >>> [float(row.max().round(3)) for row in square.distance_rows([0, (1, (0.5, 0.5, 0.0))])]
        [1.414, 0.707]
        """
        source, targets = self._resolve("points", points), None if at is None else self._resolve("at", at)

        def rows() -> Iterator[Floats]:
            with reporting(progress) as callback:
                for _, batch in self._batches(source, targets, threads, callback):
                    yield from batch

        return rows()

    def _batches(self, source: _gvd.PointList, targets: Optional[_gvd.PointList], threads: int,
                 callback: Optional[Callback]) -> Iterator[tuple[int, Floats]]:
        """Rows of distances, a batch at a time: eight for each core where these take little memory."""
        if threads < 0:
            refuse(f"threads: {threads} is negative; 0 takes all cores")
        columns = len(self.vertices) if targets is None else len(targets)
        cores = threads or os.cpu_count() or 1
        size = max(cores, min(8 * cores, _ROW_BYTES // (8 * columns)))
        for begin in range(0, len(source), size):
            end = min(begin + size, len(source))
            part = part_of(callback, begin / len(source), end / len(source))
            yield begin, _gvd.rows(self._native, source.part(begin, end), targets, threads, part)

    @checked
    def nearest(self, points: Any, *, at: Any = None, threads: int = 0,
                progress: Progress = None) -> tuple[Floats, NDArray[numpy.int32]]:
        """Distances to the nearest of `points` or curves, and which one it is (-1: none reaches), both (n)."""
        source, targets = self._sources(points), None if at is None else self._resolve("at", at)
        with reporting(progress) as callback:
            return _gvd.nearest(self._native, source, targets, threads, callback)

    @overload
    def path(self, start: Union[int, tuple[int, Any], tuple[float, float, float]], end: Any, *, threads: int = ...,
             progress: Progress = ...) -> Path: ...

    @overload
    def path(self, start: Any, end: Any, *, threads: int = ..., progress: Progress = ...) -> Union[Path, list[Path]]: ...

    @checked
    def path(self, start: Any, end: Any, *, threads: int = 0, progress: Progress = None) -> Union[Path, list[Path]]:
        """A shortest path from `start` to `end`, or to the nearest of several ends. Several starts: a list of paths.

        >>> import gvd
        >>> square = gvd.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
        >>> square.path(1, 3).positions
        array([[1. , 0. , 0. ],
               [0.5, 0.5, 0. ],
               [0. , 1. , 0. ]])
        """
        starts, ends = make_entries("start", start), self._resolve("end", end)
        from_vertex, to_vertex = starts.vertices(), make_entries("end", end).vertices()
        source = self._native.resolve("start", starts[:3], None, "keep")
        with reporting(progress) as callback:
            traced = _gvd.paths(self._native, source, ends, threads, callback)
        paths = [Path(Points(*points.arrays()), self._native.positions(points), length, complete, end,
                      from_vertex[i], to_vertex[end] if end >= 0 else -1)
                 for i, (points, end, length, complete) in enumerate(traced)]
        return paths[0] if starts.single else paths

    @checked
    def log_map(self, point: Any, *, threads: int = 0, progress: Progress = None) -> Floats:
        """The logarithm of every vertex at a point, (n, 2): the vector in whose direction the shortest path departs.

        Its length is the distance, in mesh units. The x axis is the direction of the first edge at the point: see
        gvd/geodesic_tracing.hpp. NaN where no path leads.
        """
        at = self._resolve_one("point", point)
        with reporting(progress) as callback:
            return _gvd.logs(self._native, at, threads, callback)

    @checked
    def voronoi(self, points: Any, *, method: Literal["exact", "gbgvd", "paper"] = "exact",
                front: Optional[Literal["planar", "circle"]] = None, chord_tolerance: Optional[float] = None,
                max_snap: Optional[float] = None, merge_coincident: bool = False, weights: Optional[ArrayLike] = None,
                threads: int = 0, progress: Progress = None) -> Diagram:
        """The geodesic Voronoi diagram of points or curves. `weights` (m): distances count as longer by them, mesh units.

        >>> import gvd
        >>> diagram = gvd.read("data/figure.obj").voronoi([0, 1000, 2000])
        >>> len(diagram.cells), diagram.check()
        (3, [])
        """
        generators = self._sources(points, max_snap=max_snap, coincident="merge" if merge_coincident else "refuse")
        compute = _gvd.ComputeOptions(method, front, chord_tolerance, threads)
        return self._diagram(generators, compute, progress, weights)

    def _diagram(self, generators: Union[_gvd.PointList, _gvd.CurveSet], compute: _gvd.ComputeOptions, progress: Progress,
                 weights: Optional[ArrayLike] = None) -> Diagram:
        with reporting(progress) as callback:
            return Diagram(self, _gvd.diagram(self._native, generators, _numbers("weights", weights), compute, callback))

    @checked
    def balance(self, points: Any, *, density: Optional[ArrayLike] = None, shares: Optional[ArrayLike] = None,
                weights: Optional[ArrayLike] = None, threads: int = 0, progress: Progress = None) -> Balanced:
        """The diagram of points with weights by which all cells have the same area.

        `density`: a number above 0 for each vertex or face, of which cells have equal integrals instead. `shares` (m):
        their ratios are those of the cells. `weights` (m): those that the search starts from.

        >>> import gvd
        >>> mesh = gvd.read("data/figure.obj")
        >>> areas = mesh.balance(mesh.farthest(24)).masses
        >>> bool(areas.std() < 1e-6 * areas.mean())
        True
        """
        options: dict[str, Any] = {name: _numbers(name, values) for name, values in (("shares", shares), ("weights", weights))
                                   if values is not None}
        if density is not None:
            options["density"] = self._of_elements("density", density)
        generators = self._resolve("points", points, coincident="refuse")
        with reporting(progress) as callback:
            native, masses, targets, tied, converged = _gvd.balance(
                self._native, generators, options, _gvd.ComputeOptions("exact", None, None, threads), callback)
            return Balanced(Diagram(self, native), masses, targets, tied, converged)

    @checked
    def segment(self, n: Optional[int] = None, *, generators: Any = None, sampling: str = "farthest", seed: int = 0,
                radius: Optional[float] = None, within: Any = None, mask: Any = None, per_region: Optional[int] = None,
                levels: Optional[Sequence[int]] = None, disc: bool = False, labels: Literal["smooth", "nearest"] = "smooth",
                method: Literal["exact", "gbgvd", "paper"] = "exact", front: Optional[Literal["planar", "circle"]] = None,
                chord_tolerance: Optional[float] = None, threads: int = 0, progress: Progress = None) -> Segmentation:
        """A label for every face: the regions of `n` sampled points, of given `generators`, or of a covering `radius`.

        As gvd-segment does it. `labels`: "smooth" for short borders, "nearest" for the largest share of each face.
        `within`: a whole number for each face or vertex; no region crosses the borders between them, `n` is shared out by
        area, or each has `per_region`. `mask`: not 0 for each face or vertex to leave out. `levels`: ascending numbers of
        points, each level inside the one before. `disc`: adds points until each cell is a disc. Docs: docs/guide/segment.md.

        >>> import gvd
        >>> mesh = gvd.read("data/figure.obj")
        >>> regions = mesh.segment(30)
        >>> regions.labels.shape, regions.labels.max()
        ((5876,), 29)
        >>> mesh.segment(per_region=2, within=regions.labels).labels.max()
        59
        """
        if levels is not None:
            levels = _ascending(levels)
        one_of("segment", n, generators, radius, per_region=per_region, levels=levels)
        compute = _gvd.ComputeOptions(method, front, chord_tolerance, threads)
        if per_region is not None and within is None:
            refuse("per_region: give the regions, as within=...")
        count = per_region or (levels[-1] if levels else n)
        points: Union[_gvd.Sampler, _gvd.PointList] = (
            _sampler(count, sampling, seed, radius, compute) if generators is None
            else self._resolve("generators", generators, coincident="refuse"))
        if within is None and mask is None and not levels:
            sampled = self._sample(points, progress) if isinstance(points, _gvd.Sampler) else points
            diagram = self._diagram(sampled, compute, progress)
            return self._segment(diagram, disc, compute, labels, progress)
        if numpy.asarray(mask).dtype.kind == "b":
            mask = numpy.asarray(mask, numpy.uint8)
        options = {"within": self._of_elements("within", within), "mask": self._of_elements("mask", mask), "levels": levels,
                   "per_region": per_region, "labels": labels, "sampler" if generators is None else "generators": points}
        with reporting(progress) as callback:
            diagram = Diagram(self, _gvd.diagram_inside(self._native, options, compute, callback))
        return self._segment(diagram, disc, compute, labels, progress)

    def _segment(self, diagram: Diagram, disc: bool, compute: _gvd.ComputeOptions, labels: Literal["smooth", "nearest"],
                 progress: Progress) -> Segmentation:
        if disc:
            with reporting(progress) as callback:
                diagram = Diagram(self, diagram._native.discs(compute, callback))
        return diagram.segment(labels=labels, progress=progress)

    def _of_elements(self, name: str, given: Any) -> Optional[NDArray[Any]]:
        """A number for each face or vertex."""
        if given is None:
            return None
        values = as_array(name, given)
        if values.shape not in ((len(self.vertices),), (len(self.faces),)):
            refuse(f"{name}: a number for each of {len(self.vertices)} vertices or {len(self.faces)} faces is needed, not "
                   f"{values.shape}")
        return values

    @checked
    def lloyd(self, n: Optional[int] = None, *, generators: Any = None, sampling: str = "farthest", seed: int = 0,
              radius: Optional[float] = None, fixed: Any = None, features: Union[None, str, float] = None,
              keep_boundary: bool = False, density: Any = None, gradation: Optional[float] = None,
              coarse: Optional[int] = None, accelerate: Literal["lbfgs", "anderson", "none"] = "lbfgs",
              relocate: Optional[bool] = None, iterations: Optional[int] = None, tolerance: Optional[float] = None,
              move_tolerance: Optional[float] = None, step: Optional[float] = None,
              method: Literal["exact", "gbgvd", "paper"] = "exact", front: Optional[Literal["planar", "circle"]] = None,
              chord_tolerance: Optional[float] = None, threads: int = 0, progress: Progress = None) -> Relaxation:
        """Moves generators to the centroids of their cells: evenly spread samples. As gvd-lloyd does it.

        `fixed`: points that stay. `features`: angle of creases that generators keep to, degrees, or "auto".
        `density`: "curvature", or a number above 0 for each vertex or face; larger ones make smaller cells. `coarse`:
        faces of a copy to relax on first, 0 for none. Docs: docs/guide/lloyd.md.

        >>> import gvd
        >>> samples = gvd.read("data/figure.obj").lloyd(50)
        >>> bool(samples.energies[-1] < samples.energies[0])
        True
        """
        compute = _gvd.ComputeOptions(method, front, chord_tolerance, threads)
        options = self._start("lloyd", compute, n, generators, sampling, seed, radius)
        options.update(self._constraints(fixed, features, keep_boundary, density, gradation, coarse))
        options.update(accelerate=accelerate, relocate=relocate, iterations=iterations, tolerance=tolerance,
                       move_tolerance=move_tolerance, step=step)
        with reporting(progress) as callback:
            return Relaxation(self, _gvd.relax(self._native, options, compute, callback))

    @checked
    def remesh(self, n: Optional[int] = None, *, generators: Any = None, sampling: str = "farthest", seed: int = 0,
               radius: Optional[float] = None, target_edge: Optional[float] = None, error: Optional[float] = None,
               relax: Optional[int] = None, fixed: Any = None, features: Union[None, str, float] = None,
               keep_boundary: bool = False, loose_boundary: bool = False, density: Any = None,
               gradation: Optional[float] = None, coarse: Optional[int] = None,
               place: Optional[Literal["generator", "quadric", "fit"]] = None, shape: Optional[float] = None,
               exact_count: bool = False, max_added: Optional[int] = None, no_refine: bool = False,
               allow_intersections: bool = False, method: Literal["exact", "gbgvd", "paper"] = "exact",
               front: Optional[Literal["planar", "circle"]] = None, chord_tolerance: Optional[float] = None,
               threads: int = 0, progress: Progress = None) -> Remesh:
        """A coarse mesh with the topology of this one: `n` vertices or a few more. As gvd-remesh does it.

        In place of `n`: `generators`, a covering `radius`, `target_edge` (mean length of its edges) or `error` (as few
        vertices as keep within this distance), all in mesh units. `relax`: iterations before. `place`: where vertices
        are; `shape`: from 0, near the surface, to 1, good triangles. Docs: docs/guide/remesh.md.

        >>> import gvd
        >>> coarse = gvd.read("data/figure.obj").remesh(200)
        >>> coarse.mesh.summary["euler_characteristic"], coarse.map().one_to_one
        (0, True)
        """
        if sum(given is not None for given in (n, generators, radius, target_edge, error)) != 1:
            refuse("remesh: give one of n, generators, radius, target_edge and error")
        compute = _gvd.ComputeOptions(method, front, chord_tolerance, threads)
        if target_edge is not None:
            n = self._native.count_for(target_edge)
        options = self._start("remesh", compute, 1 if error is not None else n, generators, sampling, seed, radius)
        options.update(self._constraints(fixed, features, keep_boundary, density, gradation, coarse))
        options.update(relax=relax, prefers_boundary=not loose_boundary, place=place, shape=shape, exact_count=exact_count,
                       max_added=max_added, refine=not no_refine, allow_intersections=allow_intersections)
        with reporting(progress) as callback:
            return Remesh(self, _gvd.remesh(self._native, options, compute, error, callback))

    def _start(self, name: str, compute: _gvd.ComputeOptions, n: Optional[int], generators: Any, sampling: str, seed: int,
               radius: Optional[float]) -> dict[str, Any]:
        """The generators of a relaxation, as `_gvd` takes them."""
        one_of(name, n, generators, radius)
        if generators is not None:
            return {"generators": self._resolve("generators", generators, coincident="refuse")}
        return {"sampler": _sampler(n, sampling, seed, radius, compute)}

    def _constraints(self, fixed: Any, features: Union[None, str, float], keep_boundary: bool, density: Any,
                     gradation: Optional[float], coarse: Optional[int]) -> dict[str, Any]:
        """What restricts and weighs a relaxation, as `_gvd` takes it."""
        options: dict[str, Any] = {"features": features, "keep_boundary": keep_boundary, "gradation": gradation,
                                   "coarse": coarse, "weighs_curvature": isinstance(density, str)}
        if fixed is not None:
            options["fixed"] = self._resolve("fixed", fixed, coincident="refuse")
        if isinstance(density, str):
            if density != "curvature":
                refuse(f"density: 'curvature' or an array is needed, not {density!r}")
        elif density is not None:
            options["density"] = self._of_elements("density", density)
        return options


def _numbers(name: str, given: Optional[ArrayLike]) -> Optional[list[float]]:
    """A list of numbers, or None."""
    if given is None:
        return None
    values = as_array(name, given)
    if values.ndim != 1:
        refuse(f"{name}: a list of numbers is needed, not {values.shape}")
    return [float(value) for value in values]


def _ascending(levels: Sequence[int]) -> list[int]:
    """Numbers of generators, each above the one before."""
    values = as_array("levels", levels)
    is_list = values.ndim == 1 and values.dtype.kind in "iu" and len(values) > 0
    if not is_list or values[0] < 1 or (numpy.diff(values) <= 0).any():
        refuse(f"levels: ascending whole numbers from 1 on are needed, not {levels!r}")
    return [int(value) for value in values]


def _sampler(n: Optional[int], sampling: str, seed: int, radius: Optional[float],
             compute: Optional[_gvd.ComputeOptions] = None) -> _gvd.Sampler:
    """How points are sampled, once `one_of` has passed."""
    for name, value in (("n", n), ("seed", seed)):
        if value is not None and (isinstance(value, bool) or not isinstance(value, (int, numpy.integer))):
            refuse(f"{name}: a whole number is needed, not {value!r}")
    if not 0 <= seed < 1 << 64:
        refuse(f"seed: {seed} is not in 0 ... 2^64 - 1")
    return _gvd.Sampler(sampling, max(-1, min(int(n or 0), (1 << 31) - 1)), int(seed), radius,
                        compute or _gvd.ComputeOptions("exact", None, None, 0))


def _weld_tolerance(weld: Union[None, bool, float]) -> Optional[float]:
    if weld is None or weld is False:
        return None
    return 0.0 if weld is True else float(weld)


@checked
def read(path: PathLike, *, on_defect: Literal["error", "repair", "largest"] = "repair",
         input_format: Optional[Literal["ply", "obj", "off", "stl", "vtp", "vtu", "vtk", "glb", "gltf", "gii", "mni", "fs"]] = None,
         weld: Union[None, bool, float] = None) -> Mesh:
    """Reads an OBJ, PLY, OFF, STL, VTP, VTU, legacy VTK, glTF, GIFTI, MNI or FreeSurfer file, packed by gzip or not.

    Defects are repaired where that loses nothing, with a warning for each kind. `weld`: True joins vertices at the
    same place, a number also those at most so many mesh units apart.

    >>> import gvd
    >>> gvd.read("data/torus.ply").summary["euler_characteristic"]
    0
    """
    try:
        name = os.fspath(path)
    except TypeError:
        refuse(f"read: a path is needed, not {type(path).__name__}")
    mesh = Mesh._wrap(_gvd.Mesh.from_file(name, input_format, on_defect, _weld_tolerance(weld)))
    mesh._warn()
    return mesh


@checked
def read_values(path: PathLike) -> Floats:
    """The numbers of a file that has one for each vertex, or each face.

    .label.gii, .shape.gii, .func.gii, FreeSurfer's .annot and values such as lh.curv, .npy, .csv, or text.
    """
    return _gvd.read_values(os.fspath(path))


@checked
def read_properties(path: PathLike) -> dict[str, dict[str, Floats]]:
    """The properties of a PLY but coordinates and texture: of "vertex" and of "face", by their names.

    There is a number for each vertex and each polygon of the file. `mesh.input_vertex` and `mesh.input_face` lead to them
    from the mesh that `read` makes of it. Lists are left out. Other formats have none.
    """
    found: dict[str, dict[str, Floats]] = {"vertex": {}, "face": {}}
    for element, name, values in _gvd.read_properties(os.fspath(path)):
        found[element][name] = values
    return found
