"""Surfaces and lines as VTK's, where VTK's Python package is installed (python3-vtk9)."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy
from numpy.typing import NDArray

from ._error import Error

Arrays = Mapping[str, NDArray[Any]]


def _make(positions: NDArray[Any], offsets: NDArray[Any], corners: NDArray[Any], kind: str, of_points: Arrays, of_cells: Arrays) -> Any:
    try:
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray  # type: ignore[import]
        from vtkmodules.vtkCommonCore import vtkPoints  # type: ignore[import]
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData  # type: ignore[import]
    except ImportError as error:
        raise Error("to_vtk needs VTK for Python: install python3-vtk9", "precondition") from error
    points, cells, result = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(positions), deep=True))
    cells.SetData(*(numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(a, numpy.int64), deep=True) for a in (offsets, corners)))
    result.SetPoints(points)
    (result.SetPolys if kind == "faces" else result.SetLines)(cells)
    for data, arrays in ((result.GetPointData(), of_points), (result.GetCellData(), of_cells)):
        for name, array in arrays.items():
            values = numpy_to_vtk(numpy.ascontiguousarray(array), deep=True)
            values.SetName(name)
            data.AddArray(values)
    return result


def surface(vertices: NDArray[Any], faces: NDArray[Any], points: Arrays = {}, cells: Arrays = {}) -> Any:
    """Triangles with arrays over their vertices and over the triangles."""
    return _make(vertices, 3 * numpy.arange(len(faces) + 1), faces.ravel(), "faces", points, cells)


def lines(curves: Sequence[NDArray[Any]], cells: Arrays = {}) -> Any:
    """A polyline for each array of positions (k, 3)."""
    offsets = numpy.cumsum([0, *(len(curve) for curve in curves)])
    positions = numpy.concatenate(curves) if curves else numpy.zeros((0, 3))
    return _make(positions, offsets, numpy.arange(len(positions)), "lines", {}, cells)
