"""Points of a mesh as users give them: a vertex, a face with barycentric coordinates, or a position; one or many."""
from __future__ import annotations

import numbers
from typing import Any, NamedTuple, Optional

import numpy
from numpy.typing import NDArray

from . import _gvd
from ._error import refuse

_VERTEX, _FACE, _POSITION = range(3)
_LARGEST_INDEX = numpy.iinfo(numpy.int64).max


class Points(NamedTuple):
    """Points of a mesh: `face` (n), int32, and `bary` (n, 3), float64, barycentric coordinates in these faces.

    What takes points takes this too: the same points come back bit by bit.
    """

    face: NDArray[numpy.int32]
    bary: NDArray[numpy.float64]


class Entries(NamedTuple):
    """Points for `_gvd.Mesh.resolve`, and whether there is one that was not given in a list."""

    kinds: NDArray[numpy.int8]
    ids: NDArray[numpy.int64]
    values: NDArray[numpy.float64]
    single: bool

    def vertices(self) -> list[int]:
        """The vertices that the points were given as, -1 for the others."""
        return [int(i) for i in numpy.where(self.kinds == _VERTEX, self.ids, -1)]


def _entries(kind: int, index: Any, values: Any, single: bool) -> Entries:
    count = 1 if single else len(index) if index is not None else len(values)
    return Entries(numpy.full(count, kind, numpy.int8),
                   numpy.zeros(count, numpy.int64) if index is None else numpy.array(index, numpy.int64).reshape(count),
                   numpy.zeros((count, 3)) if values is None else numpy.array(values, numpy.float64).reshape(count, 3),
                   single)


def as_array(name: str, given: Any) -> NDArray[Any]:
    """An array of numbers. Refuses text, ragged lists and what holds no numbers."""
    if isinstance(given, (str, bytes)):
        refuse(f"{name}: numbers are needed, not the text {given[:40]!r}")
    if isinstance(given, numpy.ma.MaskedArray) and numpy.any(given.mask):
        refuse(f"{name}: some items are masked; leave these out, or fill them in")
    try:
        array = numpy.asarray(given)
    except (ValueError, TypeError):
        refuse(f"{name}: the rows have different lengths")
    if array.dtype.kind not in "iuf":
        refuse(f"{name}: numbers are needed, not {array.dtype}")
    if array.size == 0:
        refuse(f"{name}: empty")
    return array


def _check_range(name: str, index: NDArray[Any]) -> None:
    """Refuses what is no index, or what would turn into another one as a signed integer."""
    if (index < 0).any():
        first = int(numpy.flatnonzero(numpy.atleast_1d(index) < 0)[0])
        refuse(f"{name}: {int(numpy.atleast_1d(index)[first])} is negative; vertices and faces are numbered from 0", first)
    if int(index.max()) > _LARGEST_INDEX:
        refuse(f"{name}: {index.max()} is too large for a vertex or a face", int(index.argmax()))


def _finite(name: str, values: NDArray[Any]) -> NDArray[Any]:
    if not numpy.isfinite(values).all():
        row = int(numpy.flatnonzero(~numpy.isfinite(numpy.atleast_2d(values)).all(axis=1))[0])
        refuse(f"{name}: the coordinates of point {row} are not finite", row)
    return values


def _is_pair(given: Any) -> bool:
    return isinstance(given, tuple) and len(given) == 2 and numpy.ndim(given[1]) > 0


def _is_mixed(given: Any) -> bool:
    """Whether some items are numbers and others have several: vertices among positions."""
    return len({isinstance(item, (list, tuple, numpy.ndarray)) for item in given}) > 1


def _from_pair(name: str, face: Any, bary: Any) -> Entries:
    """(face, barycentric) of one point, or two arrays of many."""
    faces, weights = as_array(name, face), as_array(name, bary)
    if faces.dtype.kind == "f" or faces.ndim > 1 or weights.shape != (*faces.shape, 3):
        refuse(f"{name}: a point (face, barycentric) is an integer and three weights, or arrays (n) and (n, 3) of them; "
               f"these are {faces.dtype} {faces.shape} and {weights.shape}")
    _check_range(name, faces)
    return _entries(_FACE, faces, _finite(name, weights), faces.ndim == 0)


def _from_array(name: str, array: NDArray[Any]) -> Entries:
    """Vertices are integers, positions are floats."""
    if array.dtype.kind in "iu":
        if array.ndim > 1:
            refuse(f"{name}: integers are vertices, in one dimension, not {array.shape}; positions are floats")
        _check_range(name, array)
        return _entries(_VERTEX, array, None, array.ndim == 0)
    if array.ndim not in (1, 2) or array.shape[-1] != 3:
        refuse(f"{name}: positions are (3) or (n, 3) floats, not {array.shape}; vertices are integers")
    return _entries(_POSITION, None, _finite(name, array), array.ndim == 1)


def make_entries(name: str, given: Any) -> Entries:
    """Tells apart what was given. Throws Error where it is nothing of it."""
    if isinstance(given, numbers.Integral) and not isinstance(given, bool):
        if not 0 <= int(given) < 1 << 63:
            refuse(f"{name}: there is no vertex {given}; vertices are numbered from 0")
        return _from_array(name, numpy.asarray(int(given)))
    if _is_pair(given):
        return _from_pair(name, *given)
    if isinstance(given, (list, tuple)) and (any(_is_pair(item) for item in given) or _is_mixed(given)):
        parts = [make_entries(f"{name}[{i}]", item) for i, item in enumerate(given)]
        if not all(part.single for part in parts):
            refuse(f"{name}: each item of a list is one point")
        kinds, ids, values = (numpy.concatenate(column) for column in list(zip(*parts))[:3])
        return Entries(kinds, ids, values, False)
    return _from_array(name, as_array(name, given))


class Curves:
    """Curves of a mesh as generators: `Mesh.curves` makes them. `positions`: for each its polylines, arrays (n, 3)."""

    def __init__(self, mesh: Any, native: _gvd.CurveSet) -> None:
        self._native = native
        self.positions: list[list[NDArray[numpy.float64]]] = native.polylines(mesh)

    def __len__(self) -> int:
        return len(self._native)

    def __repr__(self) -> str:
        return f"gvd.Curves({len(self)})"


def one_of(name: str, n: Optional[Any], generators: Optional[Any], radius: Optional[float], **others: Any) -> None:
    """Refuses any but one way to name generators."""
    if sum(given is not None for given in (n, generators, radius, *others.values())) != 1:
        refuse(f"{name}: give one of {', '.join(['n', 'generators', *others])} and radius")
