"""The kinds of plain options. A wrong one is refused in one line; pybind11's TypeError would list every signature."""
from __future__ import annotations

import functools
import inspect
import math
import numbers
import re
from collections.abc import Callable
from typing import Any, TypeVar, cast

from ._error import refuse

_MOST = {"threads": (1 << 31) - 1, "coarse": (1 << 63) - 1, "iterations": (1 << 31) - 1, "relax": (1 << 31) - 1,
         "max_added": (1 << 63) - 1, "generator": (1 << 63) - 1}
"""What the library's integers hold; the others are limited where they are used."""

F = TypeVar("F", bound=Callable[..., Any])


def _check(name: str, value: Any, kind: str) -> None:
    """Refuses a value that is not of the kind that the annotation says: a whole number, a number, or a text."""
    if kind == "int":
        if isinstance(value, bool) or not isinstance(value, numbers.Integral):
            refuse(f"{name}: a whole number is needed, not {value!r}")
        if abs(int(value)) > _MOST.get(name, abs(int(value))):
            refuse(f"{name}: {value} is too large")
    elif kind == "float" and (isinstance(value, bool) or not isinstance(value, numbers.Real) or math.isnan(value)):
        refuse(f"{name}: a number is needed, not {value!r}")
    elif (kind == "str" or kind.startswith("Literal")) and not isinstance(value, str):
        refuse(f"{name}: a text is needed, not {value!r}")


def checked(function: F) -> F:
    """A function that first checks the kinds of its options. None stands for the default where that is None."""
    signature = inspect.signature(function)
    kinds = {name: re.sub(r"^Optional\[(.*)\]$", r"\1", str(p.annotation)) for name, p in signature.parameters.items()}

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        for name, value in signature.bind(*args, **kwargs).arguments.items():
            if value is not None or signature.parameters[name].default is not None:
                _check(name, value, kinds[name])
        return function(*args, **kwargs)

    return cast(F, call)
