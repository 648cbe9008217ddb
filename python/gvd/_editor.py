"""Diagrams whose generators change one at a time."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any, Optional

from . import _gvd
from ._diagram import Diagram
from ._mesh import Mesh
from ._options import checked
from ._points import Points
from ._progress import Callback, Progress, reporting


class DiagramEditor:
    """An exact diagram whose generators can be moved, added and removed: each change computes what it has an effect on.

    `points`: the generators, as `Mesh.voronoi` takes them, no curves. `chord_tolerance`, `max_snap`, `merge_coincident`
    and `threads` are those of `Mesh.voronoi`, too. Each change returns the new diagram, with the bytes that
    `Mesh.voronoi` gives for `generators` unless shortest paths tie. Earlier diagrams stay as they are.

    Errors: `invalid_option` for what is no point; `precondition` for a generator that does not exist, a point that
    coincides with another generator, the last generator's removal, and a change during another one. A change that
    raises leaves generators and diagram as they were.
    Cost: the work of `Mesh.voronoi` in the cells of the generator and of its neighbours, and O(n) with small constants
    for n faces: a quarter of a new diagram for one of 100 generators, as much as that for one of ten. 4 % of it copies the
    diagram, so that earlier ones stay. Memory: about 450 bytes a face, twice that during a change, and each diagram kept.

    >>> import gvd
    >>> mesh = gvd.read("data/figure.obj")
    >>> editor = gvd.DiagramEditor(mesh, mesh.farthest(50))
    >>> moved = editor.move(7, 1234)
    >>> moved.length == mesh.voronoi(editor.generators).length
    True
    """

    @checked
    def __init__(self, mesh: Mesh, points: Any, *, chord_tolerance: Optional[float] = None,
                 max_snap: Optional[float] = None, merge_coincident: bool = False, threads: int = 0,
                 progress: Progress = None) -> None:
        self.mesh = mesh
        generators = mesh._resolve("points", points, max_snap=max_snap, coincident="merge" if merge_coincident else "refuse")
        with reporting(progress) as callback:
            self._native = _gvd.DiagramEditor(mesh._native, generators,
                                              _gvd.ComputeOptions("exact", None, chord_tolerance, threads), callback)
        self._diagram = Diagram(mesh, self._native.diagram())

    def __repr__(self) -> str:
        return f"gvd.DiagramEditor({len(self.generators.face)} generators)"

    @property
    def diagram(self) -> Diagram:
        """The diagram of the present generators."""
        return self._diagram

    @property
    def generators(self) -> Points:
        """The present generators, by their numbers; views."""
        return self._diagram.generators

    @checked
    def move(self, generator: int, point: Any, *, progress: Progress = None) -> Diagram:
        """Moves a generator to another point, near or far."""
        to = self.mesh._resolve_one("point", point)
        return self._change(progress, lambda callback: self._native.move(generator, to, callback))

    @checked
    def add(self, point: Any, *, progress: Progress = None) -> Diagram:
        """Adds a generator, which gets the next number."""
        at = self.mesh._resolve_one("point", point)
        return self._change(progress, lambda callback: self._native.add(at, callback))

    @checked
    def remove(self, generator: int, *, progress: Progress = None) -> Diagram:
        """Removes a generator; the last one gets its number, and all others keep theirs."""
        return self._change(progress, lambda callback: self._native.remove(generator, callback))

    def _change(self, progress: Progress, change: Callable[[Optional[Callback]], _gvd.Diagram]) -> Diagram:
        with reporting(progress) as callback:
            self._diagram = Diagram(self.mesh, change(callback))
        return self._diagram
