"""Objects of the library: their arrays and figures, how they are made again, files and pages."""
from __future__ import annotations

import html
import os
import pathlib
import sys
import tempfile
import warnings
import webbrowser
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Callable, Optional, Union

import numpy
from numpy.typing import NDArray

from . import _calls, _described
from ._error import Error, naming, refuse, renamed
from ._handles import Handle
from ._options import RUN, described, real, text, to_json, whole
from ._points import Points
from ._progress import reporting

if TYPE_CHECKING:
    from ._mesh import Mesh

Floats = NDArray[numpy.float64]
Ids = NDArray[numpy.int32]
PathLike = Union[str, bytes, "os.PathLike[str]"]

_MOST_THREADS = (1 << 31) - 1
_HEIGHT = 600
"""Height of the page in a notebook, in pixels."""


def view(name: str, doc: str) -> Any:
    """A property: an array of the library."""
    return property(lambda self: self._array(name), doc=doc)


def figure(name: str, doc: str) -> Any:
    """A property: one of the figures."""
    return property(lambda self: self.figures[name], doc=doc)


class Object:
    """An object of the library: its handle, and how to make it again.

    Pickled, it is its mesh, options and arrays. What else is asked of it then, such as a file, makes it again first, which
    takes as long as the call did.
    """

    _kind = ""

    def __init__(self, handle: Optional[Handle], recipe: tuple[Any, ...], saved: Optional[dict[str, Any]] = None) -> None:
        self._handle, self._recipe = handle, recipe
        self._saved: dict[str, Any] = saved or {}
        self._kept: dict[str, Any] = {}

    @property
    def _mesh(self) -> Mesh:
        """The mesh that it was made of."""
        on: Any = self._recipe[1]
        mesh: Mesh = on if on._kind == "mesh" else on._mesh
        return mesh

    @property
    def _native(self) -> Handle:
        if self._handle is None:
            self._handle = _make_again(*self._recipe)
        return self._handle

    def _array(self, name: str) -> NDArray[Any]:
        """A view of an array of the library."""
        if name not in self._saved:
            self._saved[name] = self._native.array(name)
        found: NDArray[Any] = self._saved[name]
        return found

    def _keep(self, name: str, make: Callable[[], Any]) -> Any:
        """What was made when it was asked for first."""
        if name not in self._kept:
            self._kept[name] = make()
        return self._kept[name]

    def _points(self, name: str, mesh: Optional[Mesh] = None) -> Points:
        return Points(self._array(f"{name}_faces"), self._array(f"{name}_bary"), mesh or self._mesh)

    def _part(self, name: str) -> Mesh:
        """A mesh that is a part."""
        from ._mesh import Mesh

        mesh: Mesh = self._keep(name, lambda: Mesh._wrap(self._native.part(name)))
        return mesh

    @property
    def figures(self) -> dict[str, Any]:
        """What was measured, by its names in the reports of the commands; of a result with its `options` and `notes`."""
        if "{figures}" not in self._saved:
            self._saved["{figures}"] = self._native.figures()
        found: dict[str, Any] = self._saved["{figures}"]
        return found

    def _names_to_save(self) -> list[str]:
        return list(_described.ARRAYS[self._kind])

    def _save(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        """The recipe, and what is asked of a copy without making it again."""
        for name in self._names_to_save():
            self._array(name)
        arrays: dict[str, Any] = {name: numpy.array(value) for name, value in self._saved.items() if isinstance(value, numpy.ndarray)}
        return self._recipe, {**arrays, "{figures}": self.figures}

    def __reduce__(self) -> Any:
        own = {name: value for name, value in vars(self).items() if name not in _NOT_PICKLED}  # of the user's subclass
        return _unpickle, (type(self), *self._save()), own or None


_NOT_PICKLED = ("_handle", "_recipe", "_saved", "_kept")


def _make_again(operation: str, on: Any, options: Mapping[str, Any], arrays: Sequence[NDArray[Any]]) -> Handle:
    native: Optional[Handle] = None if on is None else on._native
    return native.part(options["part"]) if native and operation == "part" else _calls.call(operation, native, options, arrays)


def _unpickle(kind: type[Object], recipe: tuple[Any, ...], saved: dict[str, Any]) -> Object:
    for array in saved.values():
        if isinstance(array, numpy.ndarray):
            array.flags.writeable = False
    made = kind.__new__(kind)
    Object.__init__(made, None, recipe, saved)
    return made


def run(operation: str, on: Optional[Object], options: Mapping[str, Any], more: Mapping[str, Any] = {},
        first: Sequence[NDArray[Any]] = (), names: Mapping[str, str] = {}) -> tuple[Handle, tuple[Any, ...]]:
    """Runs an operation with options of the user's; `more` are JSON already, and `first` the first arrays. What the commands
    warn of is a warning of the line that called. `names`: what the function calls options, for errors and warnings. Returns
    what makes a result of it."""
    arrays = list(first)
    with naming(names), reporting(options.get("progress")) as callback:
        given = {**to_json(operation, {name: value for name, value in options.items() if name not in RUN}, arrays), **more}
        made = _calls.call(operation, None if on is None else on._native, given, arrays, threads=threads_of(options), progress=callback,
                             time_limit=_seconds(options.get("time_limit")), began=options.get("began"))
    if any(array.ndim == 2 and array.shape[1] == 3 for array in arrays):  # positions may be far away
        for line in made.figures()["warnings"]:
            warn(renamed(line, names))
    # The recipe has arrays of its own: the caller may write into theirs. Meshes are pickled without one.
    return made, (operation, on, given, [] if on is None else [numpy.array(array) for array in arrays])


def threads_of(options: Mapping[str, Any]) -> int:
    threads = 0 if options.get("threads") is None else whole("threads", options["threads"])
    return threads if abs(threads) <= _MOST_THREADS else refuse(f"threads: {threads} is too large")


def _seconds(given: Any) -> Optional[float]:
    seconds = None if given is None else float(real("time_limit", given))
    if seconds is not None and seconds <= 0:
        refuse(f"time_limit: a number of seconds above 0 is needed, not {given!r}")
    return seconds


def warn(line: str) -> None:
    """Warns of the line outside of the package that called it."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    warnings.warn(line, stacklevel=level)


class Writable(Object):
    """A result with a file for each extension and a page."""

    @described("file_options", without="part")
    def to_file(self, path: PathLike, **options: Any) -> None:
        """Writes a complete file or none, in the format of its extension, as the commands do.

        .ply, .obj, .off, .coff, .stl, .vtp, .vtu, .glb, .surf.gii and .fs (FreeSurfer) hold meshes, .label.gii and
        .annot labels of vertices, .shape.gii and .curv their distances, .html is the page.
        """
        self._write(path, **options)

    def _write(self, path: PathLike, **options: Any) -> None:
        for name in ("title", "part"):
            if name in options:
                text(name, options[name])
        _calls.write(self._native, path, to_json("file_options", options, []))

    def to_html(self, *, title: str = "gvd") -> str:
        """The page as text: one file that any browser opens, without network."""
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder, "page.html")
            self._write(page, title=title)
            return page.read_text(encoding="utf-8")

    def show(self, *, title: str = "gvd") -> None:
        """Opens the page in the browser."""
        text("title", title)
        with tempfile.NamedTemporaryFile(suffix=".html", delete=False) as file:
            pass
        self._write(file.name, title=title)
        webbrowser.open(pathlib.Path(file.name).as_uri())

    def _repr_html_(self) -> Optional[str]:
        try:
            page = html.escape(self.to_html())
        except Error as error:
            if error.code == "invalid_option":  # built without the page: a notebook then prints the object
                return None
            raise
        return f'<iframe srcdoc="{page}" style="width: 100%; height: {_HEIGHT}px; border: 0"></iframe>'
