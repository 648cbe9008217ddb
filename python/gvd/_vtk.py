"""Surfaces and curves as vtkPolyData, where VTK's Python package is installed (python3-vtk9)."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy
from numpy.typing import NDArray

from ._error import Error


def _import_vtk() -> tuple[Any, Any]:
    try:
        from vtkmodules.util import numpy_support  # type: ignore[import]
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData  # type: ignore[import]
    except ImportError as error:
        raise Error("to_vtk needs VTK for Python: install python3-vtk9", "precondition") from error
    return numpy_support, (vtkCellArray, vtkPolyData)


def _make(positions: NDArray[Any], offsets: NDArray[Any], corners: NDArray[Any], kind: str,
          data: Mapping[str, Mapping[str, NDArray[Any]]]) -> Any:
    support, (vtk_cells, vtk_data) = _import_vtk()
    from vtkmodules.vtkCommonCore import vtkPoints  # type: ignore[import]

    def copy(array: NDArray[Any], dtype: Any = None) -> Any:
        return support.numpy_to_vtk(numpy.ascontiguousarray(array, dtype), deep=True)

    points, cells, result = vtkPoints(), vtk_cells(), vtk_data()
    points.SetDataTypeToDouble()
    points.SetData(copy(positions))
    offsets, corners = (support.numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(a, numpy.int64), deep=True)
                        for a in (offsets, corners))
    cells.SetData(offsets, corners)
    result.SetPoints(points)
    (result.SetPolys if kind == "faces" else result.SetLines)(cells)
    for where, arrays in data.items():
        for name, array in arrays.items():
            values = copy(array)
            values.SetName(name)
            (result.GetPointData() if where == "points" else result.GetCellData()).AddArray(values)
    return result


def surface(vertices: NDArray[Any], faces: NDArray[Any], points: Mapping[str, NDArray[Any]] = {},
            cells: Mapping[str, NDArray[Any]] = {}) -> Any:
    """Triangles with arrays over their vertices and over the triangles."""
    return _make(vertices, 3 * numpy.arange(len(faces) + 1), faces.ravel(), "faces", {"points": points, "cells": cells})


def lines(curves: Sequence[NDArray[Any]], cells: Mapping[str, NDArray[Any]] = {}) -> Any:
    """A polyline for each array of positions (k, 3)."""
    offsets = numpy.cumsum([0, *(len(curve) for curve in curves)])
    positions = numpy.concatenate(curves) if curves else numpy.zeros((0, 3))
    return _make(positions, offsets, numpy.arange(len(positions)), "lines", {"cells": cells})
