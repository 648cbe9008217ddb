"""Options: each by its name and its kind, as the library describes them (_described.py, which the build makes)."""
from __future__ import annotations

import difflib
import functools
import inspect
import math
import numbers
import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Callable, Optional, TypeVar, cast

import numpy
from numpy.typing import NDArray

from . import _described
from ._error import refuse
from ._library import name_bytes
from ._points import Curves, as_array, make_entries

if TYPE_CHECKING:
    from ._mesh import Mesh

F = TypeVar("F", bound=Callable[..., Any])
Arrays = list[NDArray[Any]]

RUN = {"threads": (0, "int"), "progress": (None, "Progress"), "time_limit": (None, "Optional[float]")}
"""How a call runs: its options with their defaults and annotations."""

_RUN_HELP = """threads: for the work; 0: one a core. Results do not depend on it
progress: True for a bar, or a function of (step, fraction), which ends the call by returning False
time_limit: seconds after which the call ends with an error"""


def whole(name: str, value: Any) -> int:
    if isinstance(value, (bool, numpy.bool_)) or not isinstance(value, numbers.Integral):
        refuse(f"{name}: a whole number is needed, not {value!r}")
    return int(value)


def real(name: str, value: Any) -> Any:
    """A number; JSON has none that is infinite, so that is a text."""
    if isinstance(value, (bool, numpy.bool_)) or not isinstance(value, numbers.Real) or math.isnan(value):
        refuse(f"{name}: a number is needed, not {value!r}")
    return float(value) if math.isfinite(value) else str(float(value))


def text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        refuse(f"{name}: a text is needed, not {value!r}")
    return value


def _flag(name: str, value: Any) -> bool:
    if not isinstance(value, (bool, numpy.bool_)):
        refuse(f"{name}: True or False is needed, not {value!r}")
    return bool(value)


def _counts(name: str, value: Any) -> list[int]:
    given = as_array(name, value)
    if given.ndim != 1 or given.dtype.kind not in "iu":
        refuse(f"{name}: ascending whole numbers from 1 on are needed, not {value!r}")
    return [int(count) for count in given]


def file_name(path: Any, arrays: Arrays) -> Any:
    """A name as a text, or where it is no UTF-8 as an array of its bytes."""
    name = os.fspath(path)
    name_bytes(name)
    try:
        return name.decode() if isinstance(name, bytes) else name.encode().decode()
    except UnicodeError:
        arrays.append(numpy.frombuffer(os.fsencode(name), numpy.uint8))
        return {"array": len(arrays) - 1}


def values(name: str, given: Any, mesh: Optional[Mesh], arrays: Arrays) -> Any:
    """A number for each vertex, face or generator."""
    if isinstance(given, (list, tuple, numpy.ndarray)) and numpy.asarray(given).dtype.kind == "b":
        given = numpy.asarray(given, numpy.uint8)  # a mask
    array = as_array(name, given)
    if array.ndim != 1:
        refuse(f"{name}: a list of numbers is needed, not {array.shape}")
    if mesh is not None and len(array) not in (len(mesh.vertices), len(mesh.faces), len(mesh.vertex_of_input)):
        refuse(f"{name}: a number for each of {len(mesh.vertices)} vertices or {len(mesh.faces)} faces is needed, not "
               f"{len(array)}")
    arrays.append(plain(array))
    return {"array": len(arrays) - 1}


def plain(array: NDArray[Any]) -> NDArray[Any]:
    """The same numbers in a type that the library has."""
    types = {"f": "f8" if array.dtype.itemsize > 4 else "f4", "i": f"i{array.dtype.itemsize}", "u": f"u{array.dtype.itemsize}"}
    return numpy.asarray(array, types[array.dtype.kind]) if array.dtype.itemsize > 1 else array


def to_json(mesh: Optional[Mesh], operation: str, options: Mapping[str, Any], arrays: Arrays) -> dict[str, Any]:
    """Options as JSON, with their arrays behind `arrays`. Those that are None are left out."""
    made: dict[str, Any] = {}
    for name, value in options.items():
        if value is None:
            continue
        kind, choices, of = _described.KINDS[operation][name]
        if kind in ("points", "vertices"):
            made[name] = make_entries("points" if name == "from" else name, value).option(cast("Mesh", mesh), arrays)
        elif kind == "curves":
            made[name] = _curves(value, arrays)
        elif kind == "values" and not (isinstance(value, str) and choices):
            made[name] = values(name, value, None if of == "generators" else mesh, arrays)
        elif kind == "input file":
            made[name] = file_name(value, arrays)
        elif kind == "counts":
            made[name] = _counts(name, value)
        elif kind == "flag" or (kind == "switch" and not isinstance(value, str)):
            made[name] = _flag(name, value)
        elif isinstance(value, str) and (choices or kind in ("bound", "crease angle", "switch")):
            made[name] = value
        elif kind == "whole number":
            made[name] = whole(name, value)
        elif kind == "choice":
            made[name] = text(name, value)
        else:
            made[name] = real(name, value)
    return made


def _curves(curves: Any, arrays: Arrays) -> Any:
    """Curves of a mesh, or words for them."""
    if isinstance(curves, str):
        return curves
    if not isinstance(curves, Curves):
        refuse(f"curves: what Mesh.curves makes is needed, not {type(curves).__name__}")
    arrays.extend(curves._arrays)
    first = len(arrays) - len(curves._arrays)

    def shifted(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: first + one if key == "array" else shifted(one) for key, one in value.items()}
        return value

    return shifted(curves._option)


def expand(operation: str, own: Iterable[str], without: Iterable[str] = (), runs: bool = True) -> list[tuple[str, str, str, str]]:
    """The options of a function beside its `own` parameters: names, annotations, defaults and help."""
    hidden = {*own, *without}
    found = [option for option in _described.OPTIONS[operation] if option[0] not in hidden]
    helps = dict(line.split(": ", 1) for line in _RUN_HELP.splitlines())
    return found + [(name, annotation, repr(usual), helps[name])
                    for name, (usual, annotation) in RUN.items() if runs and name not in hidden]


def described(operation: str, without: str = "", runs: bool = True) -> Callable[[F], F]:
    """A function whose **options are those of an operation, `without` some: `help` and editors show them. A wrong keyword
    gets the function's name, and the one that was probably meant."""
    def decorate(function: F) -> F:
        signature = inspect.signature(function)
        own = [p for p in signature.parameters.values() if p.kind != p.VAR_KEYWORD]
        options = expand(operation, [p.name for p in own], without.split(), runs)
        parameters = [*own, *(inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=_described.value(usual), annotation=kind)
                              for name, kind, usual, _ in options)]
        names = [p.name for p in parameters if p.name != "self"]

        @functools.wraps(function)
        def call(*args: Any, **kwargs: Any) -> Any:
            for name in kwargs:
                if name not in names:
                    meant = difflib.get_close_matches(name, names, 1)
                    raise TypeError(f"{function.__qualname__} has no option {name!r}"
                                    + (f"; did you mean {meant[0]!r}?" if meant else ""))
            return function(*args, **kwargs)

        call.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
        lines = "".join(f"        {name}: {meaning}\n" for name, _, _, meaning in options)
        call.__doc__ = f"{(function.__doc__ or '').rstrip()}\n\n        Options:\n\n{lines}        "
        return cast(F, call)

    return decorate
