"""Points of a mesh as users give them: a vertex, a face with barycentric coordinates, or a position; one or many."""
from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn, Optional, Union, overload

import numpy
from numpy.typing import NDArray

from ._error import Error, refuse

if TYPE_CHECKING:
    from ._mesh import Mesh


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
        self.face: NDArray[numpy.int32] = _numbers("face", face)
        self.bary: NDArray[numpy.float64] = _numbers("bary", bary)
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
        face = self.face[index]
        if face.ndim > 1 or index is Ellipsis:
            raise IndexError(f"an index of points is a number, a slice, a mask or an array of numbers, not {index!r}")
        bary = self.bary[index]
        return Points(face, bary, self._mesh) if face.ndim else _point(int(face), bary.tolist())

    def __iter__(self) -> Iterator[Point]:
        return (_point(face, bary) for face, bary in zip(self.face.tolist(), self.bary.tolist()))

    def __array__(self, *_: Any, **__: Any) -> NoReturn:
        refuse("points are no array; they have three: .face, .bary and .position")

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
    """Points as the library takes them, in one list after the other: vertices (n), positions (n, 3), or faces with barycentric
    coordinates (n, 4). `single`: one that was not in a list."""

    parts: list[NDArray[Any]]
    single: bool = False

    def size(self) -> int:
        return sum(map(len, self.parts))

    def option(self, arrays: list[NDArray[Any]]) -> Any:
        """The value of an option, whose arrays are added to `arrays`."""
        arrays.extend(self.parts)
        places = range(len(arrays) - len(self.parts), len(arrays))
        made = [{"array" if arrays[i].ndim > 1 else "mesh_vertices": i} for i in places]
        return made if len(made) > 1 else made[0]


def join(lists: Sequence[Entries]) -> Entries:
    """One list of several; what follows each other in it is one array if it is of one kind."""
    rows = [rows for one in lists for rows in one.parts]
    kinds = itertools.groupby(rows, key=lambda one: one.shape[1:])
    return Entries([numpy.concatenate(list(same)) for _, same in kinds])


def as_array(name: str, given: Any, kinds: str = "iuf") -> NDArray[Any]:
    """An array of numbers, at least one."""
    array = _numbers(name, given, kinds)
    return array if array.size else refuse(f"{name}: empty")


def _numbers(name: str, given: Any, kinds: str = "iuf") -> NDArray[Any]:
    """Refuses text, ragged lists and what holds no numbers."""
    if isinstance(given, (str, bytes)):
        refuse(f"{name}: numbers are needed, not the text {given[:40]!r}")
    if isinstance(given, numpy.ma.MaskedArray) and numpy.any(given.mask):
        refuse(f"{name}: some items are masked; leave these out, or fill them in")
    try:
        array = numpy.asarray(given)
    except (ValueError, TypeError):
        refuse(f"{name}: the rows have different lengths")
    if array.dtype.kind not in kinds:
        refuse(f"{name}: numbers are needed, not {type(given).__name__ if array.ndim == 0 else array.dtype}")
    return array


def plain(array: NDArray[Any]) -> NDArray[Any]:
    """The same numbers in a type that the library has."""
    kind, size = array.dtype.kind, array.dtype.itemsize
    return numpy.asarray(array, "u1" if kind == "b" else f"{kind}{min(max(size, 4 if kind == 'f' else 1), 8)}")


def _is_pair(given: Any) -> bool:
    return isinstance(given, tuple) and len(given) == 2 and hasattr(given[1], "__len__")


def _is_mixed(given: Any) -> bool:
    """Whether some items are numbers and others have several: vertices among positions."""
    return len({isinstance(item, (list, tuple, numpy.ndarray)) for item in given}) > 1


def _from_pair(name: str, face: Any, bary: Any) -> Entries:
    """(face, barycentric) of one point, or two arrays of many."""
    faces, weights = as_array(name, face), as_array(name, bary)
    if faces.dtype.kind == "f" or faces.ndim > 1 or weights.shape != (*faces.shape, 3):
        refuse(f"{name}: a point (face, barycentric) is an integer and three weights, or arrays (n) and (n, 3) of them; "
               f"these are {faces.dtype} {faces.shape} and {weights.shape}")
    return Entries([numpy.column_stack([faces, weights]) if faces.ndim else numpy.array([[faces, *weights]])], faces.ndim == 0)


def make_entries(name: str, given: Any) -> Entries:
    """Tells apart what was given. Throws Error where it is nothing of it."""
    if isinstance(given, Entries):
        return given
    if isinstance(given, Points):
        return _from_pair(name, given.face, given.bary)
    if _is_pair(given):
        return _from_pair(name, *given)
    if isinstance(given, (list, tuple)) and (any(_is_pair(item) for item in given) or _is_mixed(given)):
        parts = [make_entries(f"{name}[{i}]", item) for i, item in enumerate(given)]
        if not all(part.single for part in parts):
            refuse(f"{name}: each item of a list is one point")
        return join(parts)
    array = as_array(name, given)
    if array.dtype.kind in "iu":
        if array.ndim > 1:
            refuse(f"{name}: integers are vertices, in one dimension, not {array.shape}; positions are floats")
        return Entries([plain(numpy.atleast_1d(array))], array.ndim == 0)
    if array.ndim not in (1, 2) or array.shape[-1] != 3:
        refuse(f"{name}: positions are (3) or (n, 3) floats, not {array.shape}; vertices are integers")
    return Entries([numpy.atleast_2d(array).astype(numpy.float64)], array.ndim == 1)


def one_point(name: str, given: Any) -> Entries:
    entries = make_entries(name, given)
    if entries.size() != 1:
        refuse(f"{name}: one point is needed, not {entries.size()}")
    return entries
