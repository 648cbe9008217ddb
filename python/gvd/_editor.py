"""Diagrams whose generators change one at a time."""
from __future__ import annotations

import threading
from typing import Any

import numpy

from ._error import Error, refuse
from ._mesh import Mesh
from ._object import run
from ._options import described, whole
from ._points import Points, make_entries, one_point
from ._results import Diagram


class DiagramEditor:
    """An exact diagram whose generators can be moved, added and removed: each change computes what it has an effect on.

    `points`: the generators, as `Mesh.voronoi` takes them, no curves. Each change returns the new diagram, with the bytes
    that `Mesh.voronoi` gives for `generators` unless shortest paths tie. Earlier diagrams stay as they are.

    Errors: `invalid_option` for what is no point; `precondition` for a generator that does not exist, a point that
    coincides with another generator, the last generator's removal, and a change during another one. A change that
    raises leaves generators and diagram as they were.
    Cost: the work of `Mesh.voronoi` in the cells of the generator and of its neighbours, and O(n) with small constants
    for n faces: a quarter of a new diagram for one of 100 generators, as much as that for one of ten. Memory: about 450
    bytes a face, twice that during a change, and each diagram kept.

    >>> import gvd
    >>> mesh = gvd.read("data/figure.obj")
    >>> editor = gvd.DiagramEditor(mesh, mesh.farthest(50))
    >>> moved = editor.move(7, 1234)
    >>> moved.length == mesh.voronoi(editor.generators).length
    True
    """

    @described("diagram", without="count sampling seed radius generators vertices curves method front balance shares weights within mask editable")
    def __init__(self, mesh: Mesh, points: Any, **options: Any) -> None:
        """The diagram of the first generators."""
        if not isinstance(mesh, Mesh):
            refuse(f"mesh: a gvd.Mesh is needed, not {type(mesh).__name__}")
        self.mesh: Mesh = mesh
        self._options: dict[str, Any] = {name: options[name] for name in ("chord_tolerance",) if options.get(name) is not None}
        self._run: dict[str, Any] = {"threads": options.get("threads")}
        self._change_lock: Any = threading.Lock()
        given = {**options, "generators": make_entries("points", points), "editable": True}
        self._diagram: Diagram = Diagram(*run("diagram", mesh, given, names={"generators": "points"}))

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "_change_lock"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state, _change_lock=threading.Lock())

    def __repr__(self) -> str:
        return f"gvd.DiagramEditor({len(self.generators)} generators)"

    @property
    def diagram(self) -> Diagram:
        """The diagram of the present generators."""
        return self._diagram

    @property
    def generators(self) -> Points:
        """The present generators, by their numbers; views."""
        return self._diagram.generators

    @described("edit", without="move to add remove max_snap")
    def move(self, generator: int, point: Any, **options: Any) -> Diagram:
        """Moves a generator to another point, near or far."""
        return self._change({"move": self._find(generator), "to": one_point("point", point)}, options)

    @described("edit", without="move to add remove max_snap")
    def add(self, point: Any, **options: Any) -> Diagram:
        """Adds a generator, which gets the next number."""
        return self._change({"add": one_point("point", point)}, options)

    @described("edit", without="move to add remove max_snap")
    def remove(self, generator: int, **options: Any) -> Diagram:
        """Removes a generator; the last one gets its number, and all others keep theirs."""
        return self._change({"remove": self._find(generator)}, options)

    def _find(self, generator: int) -> int:
        number = whole("generator", generator)
        if abs(number) >= 1 << 63:
            refuse(f"generator: {number} is too large")
        if not 0 <= number < len(self.generators):
            raise Error(f"generator: there is no generator {number}", "precondition", number)
        return number

    def _change(self, change: dict[str, Any], options: dict[str, Any]) -> Diagram:
        if not self._change_lock.acquire(blocking=False):
            raise Error("the editor is in the middle of a change", "precondition")
        try:
            made, _ = run("edit", self._diagram, {**self._run, **options, **change}, names={"to": "point", "add": "point"})
            points = numpy.column_stack([made.array("generators_faces"), made.array("generators_bary")])
            recipe = ("diagram", self.mesh, {"generators": {"array": 0}, **self._options}, [points])  # the edits before are not kept
            self._diagram = Diagram(made, recipe)
        finally:
            self._change_lock.release()
        return self._diagram
