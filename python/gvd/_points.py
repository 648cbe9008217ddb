"""Points of a mesh as users give them: a vertex, a face with barycentric coordinates, or a position; one or many."""
from __future__ import annotations

import numbers
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union, overload

import numpy
from numpy.typing import NDArray

from ._error import Error, refuse

if TYPE_CHECKING:
    from ._mesh import Mesh

_VERTEX, _FACE, _POSITION = range(3)
_LARGEST_INDEX = numpy.iinfo(numpy.int64).max


class Point(NamedTuple):
    """A point of a mesh: barycentric coordinates in a face."""

    face: int
    bary: tuple[float, float, float]


def _point(face: int, bary: list[float]) -> Point:
    return Point(face, (bary[0], bary[1], bary[2]))


class Points(Sequence[Point]):
    """Points of a mesh: `face` (n), int32, and `bary` (n, 3), float64, barycentric coordinates in these faces.

    What takes points takes this too: the same points come back bit by bit. An index gives one point, and a slice, a mask
    or an array of indices gives some. `position` (n, 3) needs the mesh, which points that a mesh has made know.

    >>> import gvd
    >>> spread = gvd.read("data/figure.obj").farthest(5)
    >>> len(spread), spread[0].face, spread[1:3].position.shape
    (5, 541, (2, 3))
    """

    def __init__(self, face: Any, bary: Any, mesh: Optional[Mesh] = None) -> None:
        self.face: NDArray[numpy.int32] = numpy.asarray(face)
        self.bary: NDArray[numpy.float64] = numpy.asarray(bary)
        self._mesh = mesh

    def __len__(self) -> int:
        return len(self.face)

    @overload
    def __getitem__(self, index: int) -> Point: ...

    @overload
    def __getitem__(self, index: slice) -> Points: ...

    @overload
    def __getitem__(self, index: Union[Sequence[int], NDArray[Any]]) -> Points: ...

    def __getitem__(self, index: Any) -> Union[Point, Points]:
        face, bary = self.face[index], self.bary[index]
        if face.ndim == 0:
            return _point(int(face), bary.tolist())
        return Points(face, bary, self._mesh)

    def __iter__(self) -> Iterator[Point]:
        return (_point(face, bary) for face, bary in zip(self.face.tolist(), self.bary.tolist()))

    def __repr__(self) -> str:
        return f"gvd.Points({len(self)})"

    @property
    def position(self) -> NDArray[numpy.float64]:
        """Positions (n, 3), mesh units."""
        if self._mesh is None:
            raise Error("these points know no mesh; ask that one: mesh.positions(points)", "precondition")
        at = self._mesh.vertices[self._mesh.faces[self.face]]
        bary = self.bary[:, :, None]
        positions: NDArray[numpy.float64] = bary[:, 0] * at[:, 0] + bary[:, 1] * at[:, 1] + bary[:, 2] * at[:, 2]
        return positions


class Curves:
    """Curves of a mesh as generators: `Mesh.curves` makes them. `positions`: for each its polylines, arrays (n, 3)."""

    def __init__(self, option: Any, arrays: list[NDArray[Any]], positions: list[list[NDArray[numpy.float64]]]) -> None:
        self._option, self._arrays, self.positions = option, arrays, positions

    def __len__(self) -> int:
        return len(self.positions)

    def __repr__(self) -> str:
        return f"gvd.Curves({len(self)})"


class Entries(NamedTuple):
    """What points are: kinds, vertices or faces, coordinates, and whether there is one that was not given in a list."""

    kinds: NDArray[numpy.int8]
    ids: NDArray[numpy.int64]
    values: NDArray[numpy.float64]
    single: bool

    def option(self, mesh: Mesh, arrays: list[NDArray[Any]]) -> Any:
        """The value of an option, whose array is added to `arrays`: rows of 1, 3 or 4 numbers, as the library tells points
        apart. Its vertices are those of the mesh's input."""
        kinds, ids, values = self.kinds.copy(), self.ids.copy(), self.values.copy()
        vertices = numpy.flatnonzero(kinds == _VERTEX)
        if len(vertices):
            ids[vertices] = mesh._to_input(ids[vertices])
            for i in vertices[ids[vertices] < 0]:  # that the input has not
                kinds[i], (ids[i], values[i]) = _FACE, mesh._corner(int(self.ids[i]))
        if len(set(kinds.tolist())) > 1:
            rows = zip(kinds.tolist(), ids.tolist(), values.tolist())
            return [{"vertex": i} if kind == _VERTEX else {"position": at} if kind == _POSITION else {"face": i, "bary": at}
                    for kind, i, at in rows]
        arrays.append(ids if kinds[0] == _VERTEX else values if kinds[0] == _POSITION else numpy.column_stack([ids, values]))
        return {"array": len(arrays) - 1}


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
    if isinstance(given, Points):
        return _from_pair(name, given.face, given.bary)
    if _is_pair(given):
        return _from_pair(name, *given)
    if isinstance(given, (list, tuple)) and (any(_is_pair(item) for item in given) or _is_mixed(given)):
        parts = [make_entries(f"{name}[{i}]", item) for i, item in enumerate(given)]
        if not all(part.single for part in parts):
            refuse(f"{name}: each item of a list is one point")
        kinds, ids, values = (numpy.concatenate(column) for column in list(zip(*parts))[:3])
        return Entries(kinds, ids, values, False)
    return _from_array(name, as_array(name, given))
