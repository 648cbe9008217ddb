"""Options: each by its name and its kind, as the library describes them (_described.py, which the build makes)."""
from __future__ import annotations

import difflib
import functools
import inspect
import math
import numbers
import os
import reprlib
from collections.abc import Mapping
from typing import Any, Callable, NoReturn, TypeVar, cast

import numpy
from numpy.typing import NDArray

from . import _described
from ._calls import name_bytes
from ._error import refuse
from ._points import Curves, as_array, make_entries, plain

F = TypeVar("F", bound=Callable[..., Any])
Arrays = list[NDArray[Any]]

RUN = ("threads", "progress", "time_limit", "began")
"""How a call runs: options that are none of operations. Of a call in several parts, its time began before them."""


def _refuse_kind(name: str, needed: str, value: Any) -> NoReturn:
    refuse(f"{name}: {needed} needed, not {' '.join(reprlib.repr(value).split())}")


def _item(value: Any) -> Any:
    """The number of an array without dimensions."""
    return value[()] if isinstance(value, numpy.ndarray) and value.ndim == 0 else value


def whole(name: str, value: Any) -> int:
    value = _item(value)
    if isinstance(value, (bool, numpy.bool_)) or not isinstance(value, numbers.Integral):
        _refuse_kind(name, "a whole number is", value)
    return int(value)


def real(name: str, value: Any) -> Any:
    """A number; JSON has none that is infinite, so that is a text."""
    value = _item(value)
    if isinstance(value, (bool, numpy.bool_)) or not isinstance(value, numbers.Real) or math.isnan(value):
        _refuse_kind(name, "a number is", value)
    return float(value) if math.isfinite(value) else str(float(value))


def text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        _refuse_kind(name, "a text is", value)
    return value


def flag(name: str, value: Any) -> bool:
    value = _item(value)
    if not isinstance(value, (bool, numpy.bool_)):
        _refuse_kind(name, "True or False is", value)
    return bool(value)


def _counts(name: str, value: Any) -> list[int]:
    given = as_array(name, value)
    if given.ndim != 1 or given.dtype.kind not in "iu":
        _refuse_kind(name, "ascending whole numbers from 1 on are", value)
    return [int(count) for count in given]


def file_name(path: Any, arrays: Arrays) -> Any:
    """A name as a text, or where it is no UTF-8 as an array of its bytes."""
    name_bytes(path)
    name = os.fspath(path)
    try:
        return name.decode() if isinstance(name, bytes) else name.encode().decode()
    except UnicodeError:
        arrays.append(numpy.frombuffer(os.fsencode(name), numpy.uint8))
        return {"array": len(arrays) - 1}


def _values(name: str, given: Any, arrays: Arrays) -> Any:
    """A number for each vertex, face or generator."""
    array = as_array(name, given, "biuf")  # a mask has True and False
    if array.ndim != 1:
        refuse(f"{name}: a list of numbers is needed, not {array.shape}")
    arrays.append(plain(array))
    return {"array": len(arrays) - 1}


_SCALARS: dict[str, Callable[[str, Any], Any]] = {"flag": flag, "switch": flag, "counts": _counts, "whole number": whole, "choice": text}
"""What takes values of each kind; others are real numbers."""


def to_json(operation: str, options: Mapping[str, Any], arrays: Arrays) -> dict[str, Any]:
    """Options as JSON, with their arrays behind `arrays`. Those that are None are left out."""
    made: dict[str, Any] = {}
    for name, value in options.items():
        if value is None:
            continue
        kind, choices = _described.KINDS[operation][name]
        if kind in ("points", "vertices"):
            made[name] = make_entries("points" if name == "from" else name, value).option(arrays)
        elif kind == "curves":
            made[name] = _curves(value, arrays)
        elif kind == "input file":
            made[name] = file_name(value, arrays)
        elif isinstance(value, str) and (choices or kind in ("bound", "crease angle", "switch")):
            made[name] = value
        elif kind == "values":
            made[name] = _values(name, value, arrays)
        else:
            made[name] = _SCALARS.get(kind, real)(name, value)
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
        if isinstance(value, list) and value and isinstance(value[0], dict):
            return [shifted(one) for one in value]
        if isinstance(value, dict):
            return {key: first + one if key in ("array", "mesh_vertices") else shifted(one) for key, one in value.items()}
        return value

    return shifted(curves._option)


def described(operation: str, without: str = "", **instead: str) -> Callable[[F], F]:
    """A function whose **options are those of an operation, `without` some: `help` and editors show them. A wrong keyword
    gets the function's name, and the one that was probably meant, or what to do `instead`."""
    def decorate(function: F) -> F:
        signature = inspect.signature(function)
        own = [p for p in signature.parameters.values() if p.kind != p.VAR_KEYWORD]
        hidden = {*without.split(), *(p.name for p in own)}
        options = [option for option in _described.OPTIONS[operation] if option[0] not in hidden]
        parameters = [*own, *(inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=usual, annotation=kind)
                              for name, kind, usual, _ in options)]
        names = [p.name for p in parameters if p.name != "self"]

        @functools.wraps(function)
        def call(*args: Any, **kwargs: Any) -> Any:
            for name in kwargs:
                if name not in names:
                    meant = [now for now in names if name in _described.ALSO.get(now, ())] or difflib.get_close_matches(name, names, 1)
                    hint = f"; {instead[name]}" if name in instead else f"; did you mean {meant[0]!r}?" if meant else ""
                    raise TypeError(f"{function.__qualname__} has no option {name!r}{hint}")
            return function(*args, **kwargs)

        call.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
        lines = "".join(f"        {name}: {meaning}\n" for name, _, _, meaning in options)
        call.__doc__ = f"{(function.__doc__ or '').rstrip()}\n\n        Options:\n\n{lines}        "
        return cast(F, call)

    return decorate
