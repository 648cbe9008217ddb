"""Calls of the library. ctypes lets other threads run meanwhile; a user's function hears of the progress, and Ctrl-C ends a
call."""
from __future__ import annotations

import ctypes
import json
import os
import threading
import time
from collections.abc import Mapping, Sequence
from typing import Any, Callable, Optional

from numpy.typing import NDArray

from ._clock import Flags, begin, end, stay_at_end
from ._error import Error, refuse
from ._handles import Handle
from ._library import ABI, INTERRUPTED, PROGRESS, PYTHON, TYPES, Array, Run, check, library
from ._signals import keeping_signals

Callback = Callable[[str, float], Any]

_PLACES = {dtype: place for place, dtype in enumerate(TYPES)}
_KEEP_GOING = PROGRESS(lambda data, step, fraction: 1)  # handlers of signals have run on the way here
_NO_PROGRESS: Any = PROGRESS()  # type: ignore[call-overload]


def _run(function: Callable[[Any], int], threads: int, progress: Optional[Callback] = None, time_limit: Optional[float] = None,
         began: Optional[float] = None) -> None:
    """Calls a function of the library with a run, and raises what ended it."""
    stay_at_end()
    flags, raised = Flags(), list[BaseException]()

    def report(data: Any, step: bytes, fraction: float) -> int:
        try:
            return 0 if progress and progress(step.decode(), fraction) == False else 1  # noqa: E712, NumPy has a False of its own
        except BaseException as error:  # raised again when the call has ended
            raised.append(error)
            return 0

    timer = None
    if time_limit is not None:
        left = time_limit if began is None else time_limit - (time.monotonic() - began)
        timer = threading.Timer(min(left, threading.TIMEOUT_MAX), flags.expire)
        timer.daemon = True
        timer.start()
    begin(flags)
    try:
        with keeping_signals(flags, raised) as handlers:
            callback = PROGRESS(report) if progress is not None else _KEEP_GOING if handlers else _NO_PROGRESS
            run = Run(threads, callback, None, ctypes.addressof(flags.cancel), None, ctypes.addressof(flags.due), PYTHON)
            status = function(ctypes.byref(run))
    finally:
        end(flags)
        if timer is not None:
            timer.cancel()
        stay_at_end()
    if raised:
        raise raised[0]
    if status == INTERRUPTED and flags.is_late:
        raise Error(f"the time limit of {time_limit:g} s is over", "interrupted")
    check(status)


def call(operation: str, on: Optional[Handle] = None, options: Optional[Mapping[str, Any]] = None,
         arrays: Sequence[NDArray[Any]] = (), *, threads: int = 0, progress: Optional[Callback] = None,
         time_limit: Optional[float] = None, began: Optional[float] = None) -> Handle:
    """Runs an operation. In `options`, {"array": 0} stands for the first of `arrays`, of one or two dimensions."""
    views = [Array(array.ctypes.data, _PLACES[array.dtype], array.ndim, (*array.shape, 1, 1)[:2], (*array.strides, 0, 0)[:2])
             for array in arrays]
    given = (Array * len(views))(*views) if views else None
    made = ctypes.c_void_p()
    name, text = operation.encode(), json.dumps(options).encode() if options else None
    address = None if on is None else on.address
    try:
        _run(lambda run: int(library.gvd_call(ABI, name, address, text, given, len(views), run, ctypes.byref(made))), threads,
              progress, time_limit, began)
    finally:  # Ctrl-C may come behind a result
        handle = Handle(made.value)
    return handle


def name_bytes(path: Any) -> bytes:
    """The name of a file for the library, for which a NUL would end it."""
    if not isinstance(path, (str, bytes, os.PathLike)):
        refuse(f"a path is needed, not {type(path).__name__}")
    name = os.fsencode(path)
    if not name:
        refuse("the path is empty; name a file")
    if b"\0" in name:
        refuse(f"{os.fsdecode(name)!r}: a name of a file has no NUL in it")
    return name


def write(handle: Handle, path: Any, options: Mapping[str, Any], threads: int = 0) -> None:
    """Writes a complete file or none."""
    text, name = json.dumps(options).encode(), name_bytes(path)
    _run(lambda run: int(library.gvd_write_as(handle.address, name, text, run)), threads)
