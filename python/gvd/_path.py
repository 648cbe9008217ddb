"""Shortest paths."""
from __future__ import annotations

import io
import os
from typing import Any, NamedTuple

import numpy
from numpy.typing import NDArray

from . import _gvd, _vtk
from ._error import refuse
from ._points import Points


class Path(NamedTuple):
    """A shortest path on a surface.

    `points` and `positions` (k, 3) run from start to end; `length` is in mesh units. `complete` is False where rounding
    ended the points at a vertex before the end; `length` is right nevertheless. `end` is the index of the end that was
    nearest, -1 where there is none: then the path has no points and its length is infinite. `start_vertex` and
    `end_vertex`: the vertices that start and end were given as, -1 for points that were given otherwise.
    """

    points: Points
    positions: NDArray[numpy.float64]
    length: float
    complete: bool
    end: int
    start_vertex: int = -1
    end_vertex: int = -1

    def to_vtk(self) -> Any:
        """The path as a polyline of vtkPolyData."""
        return _vtk.lines([self.positions])

    def to_file(self, path: Any) -> None:
        """Writes .npy or .obj (the positions, as one polyline) or .csv (as gvd-distance --paths does).

        A complete file or none, as the other results do. A path of one point has no line in .obj."""
        name, out = os.fsdecode(path), io.BytesIO()
        if name.endswith(".npy"):
            numpy.save(out, self.positions)
        elif name.endswith(".csv"):
            out.write(_gvd.format_path(*self.points, self.positions, self.length, self.end, self.start_vertex, self.end_vertex))
        elif name.endswith(".obj"):
            numpy.savetxt(out, self.positions, fmt="v %.17g %.17g %.17g")
            if len(self.positions) > 1:
                out.write(b"l " + b" ".join(b"%d" % (i + 1) for i in range(len(self.positions))) + b"\n")
        else:
            refuse(f"{name}: a path is written as .npy, .csv or .obj")
        _gvd.write_file(name, out.getvalue())
