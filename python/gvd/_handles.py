"""Objects of the library: handles, which are released when nobody has them any more, and their arrays as NumPy's."""
from __future__ import annotations

import ctypes
import json
import types
import weakref
from typing import Any, Optional

import numpy
from numpy.typing import NDArray

from ._library import TYPES, Array, check, library


class _Release(weakref.ref):  # type: ignore[type-arg]
    """Calls gvd_release, with itself for the address, when the handle goes. No line of Python runs then: in a destructor, Python
    ignores what a signal's handler raises, and so Ctrl-C."""

    __slots__ = ("_as_parameter_",)
    _as_parameter_: Optional[int]


class _Releases:
    """Keeps those whose handle lives; others go in time."""

    def __init__(self) -> None:
        self._kept: dict[int, _Release] = {}
        self._most = 64

    def add(self, handle: Handle) -> None:
        release = _Release(handle, library.gvd_release)
        release._as_parameter_ = handle.address
        self._kept[id(release)] = release
        if len(self._kept) > self._most:
            for key, one in list(self._kept.items()):
                if one() is None:
                    self._kept.pop(key, None)
            self._most = 2 * len(self._kept) + 64


_releases = _Releases()


class Handle:
    """An object of the library, for as long as this lives. Handles may go in any order."""

    __slots__ = ("address", "__weakref__")

    def __init__(self, address: Optional[int]) -> None:
        self.address = address
        if address is not None:
            _releases.add(self)

    def array(self, name: str) -> NDArray[Any]:
        """A view of an array, which can't be written and keeps the object alive."""
        view = Array()
        check(library.gvd_array_of(self.address, name.encode(), ctypes.byref(view)))
        shape, dtype = tuple(view.shape)[:view.dimensions], TYPES[view.type]
        return numpy.asarray(types.SimpleNamespace(owner=self, __array_interface__={  # which the array keeps
            "data": (view.data or 1, True), "shape": shape, "typestr": dtype.str, "strides": tuple(view.strides)[:view.dimensions], "version": 3}))

    def part(self, name: str) -> Handle:
        """A part, such as the diagram of a result."""
        part = ctypes.c_void_p()
        check(library.gvd_object_of(self.address, name.encode(), ctypes.byref(part)))
        return Handle(part.value)

    def figures(self) -> dict[str, Any]:
        figures: dict[str, Any] = json.loads(library.gvd_figures(self.address))
        return figures
