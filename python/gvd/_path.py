"""Shortest paths."""
from __future__ import annotations

import os
from typing import Any, NamedTuple

import numpy
from numpy.typing import NDArray

from . import _vtk
from ._error import refuse
from ._points import Points


class Path(NamedTuple):
    """A shortest path on a surface.

    `points` and `positions` (k, 3) run from start to end; `length` is in mesh units. `complete` is False where rounding
    ended the points at a vertex before the end; `length` is right nevertheless. `end` is the index of the end that was
    nearest, -1 where there is none: then the path has no points and its length is infinite.
    """

    points: Points
    positions: NDArray[numpy.float64]
    length: float
    complete: bool
    end: int

    def to_vtk(self) -> Any:
        """The path as a polyline of vtkPolyData."""
        return _vtk.lines([self.positions])

    def to_file(self, path: Any) -> None:
        """Writes the positions: .npy, .csv with a header, or .obj with one polyline (none for a path of one point)."""
        name = os.fsdecode(path)
        if name.endswith(".npy"):
            numpy.save(name, self.positions)
        elif name.endswith(".csv"):
            numpy.savetxt(name, self.positions, fmt="%.17g", delimiter=",", header="x,y,z", comments="")
        elif name.endswith(".obj"):
            with open(name, "w", encoding="ascii") as out:
                out.writelines("v %.17g %.17g %.17g\n" % tuple(p) for p in self.positions)
                if len(self.positions) > 1:
                    out.write("l " + " ".join(str(i + 1) for i in range(len(self.positions))) + "\n")
        else:
            refuse(f"{name}: a path is written as .npy, .csv or .obj")
