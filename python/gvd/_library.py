"""The library: its calls, its arrays as NumPy's, and what ends a call.

One function, `call`, runs an operation by its name with options as JSON and arrays beside it (gvd/gvd.h). ctypes lets
other threads run meanwhile. Python runs handlers of signals only between steps of its own, so the library is told ten
times a second to call back: then a user's function hears of the progress, and Ctrl-C ends the call.
"""
from __future__ import annotations

import atexit
import contextlib
import ctypes
import json
import os
import pathlib
import threading
import time
import types
import weakref
# The functions of the module signal, without its enumerations: these take 10 us a call.
import _signal  # type: ignore[import]
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Callable, Optional

import numpy
from numpy.typing import NDArray

from . import _described
from ._error import Error, refuse

_TYPES = [numpy.dtype(name) for name in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8")]
_PLACES = {dtype: place for place, dtype in enumerate(_TYPES)}
_ABI, _PYTHON, _OUT_OF_MEMORY, _INTERRUPTED = 1, 1, 1, 130

Callback = Callable[[str, float], Any]


class _Array(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("type", ctypes.c_int32), ("dimensions", ctypes.c_int32),
                ("shape", ctypes.c_int64 * 2), ("strides", ctypes.c_int64 * 2)]


_PROGRESS = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double)


class _Run(ctypes.Structure):
    _fields_ = [("threads", ctypes.c_int), ("progress", _PROGRESS), ("data", ctypes.c_void_p), ("cancel", ctypes.c_void_p),
                ("note", ctypes.c_void_p), ("due", ctypes.c_void_p), ("door", ctypes.c_int32), ("iteration", ctypes.c_void_p)]


def _load() -> ctypes.CDLL:
    """The library beside this file or, without one, the system's. Its interface is that of one version."""
    beside = pathlib.Path(__file__).resolve().parent / _described.SONAME
    name = str(beside) if beside.exists() else _described.SONAME
    try:
        library = ctypes.CDLL(name)
    except OSError as error:
        raise ImportError(f"gvd needs the library {_described.SONAME}: {error}; build it with `make python`, and set PYTHONPATH "
                          "to the folder python of the build tree") from None
    library.gvd_version.restype = ctypes.c_char_p
    version = library.gvd_version().decode()
    if version != _described.VERSION:
        raise ImportError(f"gvd {_described.VERSION} needs its own library, and {name} is that of {version}: install both together")
    return library


_library = _load()
for _function in ("gvd_last_error", "gvd_last_error_code", "gvd_figures"):
    getattr(_library, _function).restype = ctypes.c_char_p
_library.gvd_last_error_element.restype = ctypes.c_int64
_library.gvd_figures.argtypes = [ctypes.c_void_p]
_library.gvd_release.argtypes = [ctypes.c_void_p]
_library.gvd_release.restype = None
_library.gvd_array_of.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
_library.gvd_object_of.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
_library.gvd_call.argtypes = [ctypes.c_int32, ctypes.c_char_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p, ctypes.c_int32,
                              ctypes.c_void_p, ctypes.c_void_p]
_library.gvd_write_as.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_void_p]


def _check(status: int) -> None:
    """Raises the last error of this thread, if there is one. Names of files need not be UTF-8, so neither do texts."""
    if status == 0:
        return
    text = os.fsdecode(_library.gvd_last_error())
    if status == _OUT_OF_MEMORY:
        raise MemoryError(text)
    code = _library.gvd_last_error_code().decode() or "internal_error"
    raise Error(text, code, _library.gvd_last_error_element())


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
        release = _Release(handle, _library.gvd_release)
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
        view = _Array()
        _check(_library.gvd_array_of(self.address, name.encode(), ctypes.byref(view)))
        shape, dtype = tuple(view.shape)[:view.dimensions], _TYPES[view.type]
        return numpy.asarray(types.SimpleNamespace(owner=self, __array_interface__={  # which the array keeps
            "data": (view.data or 1, True), "shape": shape, "typestr": dtype.str, "strides": tuple(view.strides)[:view.dimensions], "version": 3}))

    def part(self, name: str) -> Handle:
        """A part, such as the diagram of a result."""
        part = ctypes.c_void_p()
        _check(_library.gvd_object_of(self.address, name.encode(), ctypes.byref(part)))
        return Handle(part.value)

    def figures(self) -> dict[str, Any]:
        figures: dict[str, Any] = json.loads(_library.gvd_figures(self.address))
        return figures


# ---- what ends a call

_TICK = 0.1
"""Seconds between two looks for signals, and between two reports."""

_IDLE_TICKS = 20
"""The clock ends after so many ticks without a call."""

_PATIENCE = 2.0
"""Seconds that the end of Python waits for daemon threads to leave the library."""


class _Flags:
    """What ends a running call: `due` lets the library call back, and `cancel` ends the call."""

    __slots__ = ("due", "cancel", "is_late")

    def __init__(self) -> None:
        self.due, self.cancel, self.is_late = ctypes.c_int32(1), ctypes.c_int32(0), False

    def expire(self) -> None:
        self.is_late, self.cancel.value = True, 1


_running: dict[int, _Flags] = {}
_clock: Optional[threading.Thread] = None
_is_ending = False


def _tick() -> None:
    global _clock
    idle = 0
    while True:
        time.sleep(_TICK)
        for flags in list(_running.values()):
            flags.due.value = 1
        idle = 0 if _running else idle + 1
        if idle > _IDLE_TICKS:
            _clock = None  # a call that begins from now on starts another one
            if not _running:
                return


def _start_clock() -> None:
    global _clock
    _clock = threading.Thread(target=_tick, name="gvd clock", daemon=True)
    _clock.start()


def _forget_clock() -> None:
    """In a new process, which has no other thread."""
    global _clock
    _clock = None
    _running.clear()


os.register_at_fork(after_in_child=_forget_clock)


@atexit.register
def _end_calls() -> None:
    """Ends what daemon threads compute: a callback that finds Python gone would abort the process."""
    global _is_ending
    _is_ending, end = True, time.monotonic() + _PATIENCE
    for flags in list(_running.values()):
        flags.cancel.value = 1
    while _running and time.monotonic() < end:
        time.sleep(_TICK / 10)


def _stay_at_end() -> None:
    """Where a daemon thread stays while Python ends: it has nobody to tell why its call has ended."""
    if _is_ending and threading.get_ident() != threading.main_thread().ident:
        threading.Event().wait()


_KEEP_GOING = _PROGRESS(lambda data, step, fraction: 1)  # handlers of signals have run on the way here
_NO_PROGRESS: Any = _PROGRESS()  # type: ignore[call-overload]


# Signals that programs handle. Those of errors, such as SIGSEGV, have nothing to return to.
_SIGNALS = [getattr(_signal, f"SIG{name}") for name in ("INT", "TERM", "HUP", "QUIT", "ALRM", "VTALRM", "PROF", "USR1", "USR2")
            if hasattr(_signal, f"SIG{name}")]


@contextlib.contextmanager
def _keeping_signals(flags: _Flags, raised: list[BaseException]) -> Iterator[dict[int, Any]]:
    """Signals during a call in the main thread. The user's handlers run on the way to a callback, where ctypes would lose
    what they raise: it is kept, and ends the call. Ctrl-C ends it in any case. Yields the handlers."""
    before: dict[int, Any] = {}

    def catch(number: int, frame: Any) -> None:
        if number == _signal.SIGINT:  # whatever its handler does
            flags.cancel.value = 1
        try:
            before[number](number, frame)
        except BaseException as error:  # raised again when the call has ended
            raised.append(error)
            flags.cancel.value = 1

    try:
        if threading.get_ident() == threading.main_thread().ident:
            for number in _SIGNALS:
                handler = _signal.getsignal(number)
                if callable(handler):
                    before[number] = handler
                    with contextlib.suppress(ValueError):  # an interpreter beside the main one takes no signals
                        _signal.signal(number, catch)
        yield before
    finally:
        for number, handler in before.items():
            if _signal.getsignal(number) == catch:  # a callback may have put another one in its place
                _signal.signal(number, handler)


def _run(function: Callable[[Any], int], threads: int, progress: Optional[Callback] = None, time_limit: Optional[float] = None,
         began: Optional[float] = None) -> None:
    """Calls a function of the library with a run, and raises what ended it."""
    _stay_at_end()
    flags, raised = _Flags(), list[BaseException]()

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
    _running[id(flags)] = flags
    if _clock is None:
        _start_clock()
    try:
        with _keeping_signals(flags, raised) as handlers:
            callback = _PROGRESS(report) if progress is not None else _KEEP_GOING if handlers else _NO_PROGRESS
            run = _Run(threads, callback, None, ctypes.addressof(flags.cancel), None, ctypes.addressof(flags.due), _PYTHON)
            status = function(ctypes.byref(run))
    finally:
        del _running[id(flags)]
        if timer is not None:
            timer.cancel()
        _stay_at_end()
    if raised:
        raise raised[0]
    if status == _INTERRUPTED and flags.is_late:
        raise Error(f"the time limit of {time_limit:g} s is over", "interrupted")
    _check(status)


def call(operation: str, on: Optional[Handle] = None, options: Optional[Mapping[str, Any]] = None,
         arrays: Sequence[NDArray[Any]] = (), *, threads: int = 0, progress: Optional[Callback] = None,
         time_limit: Optional[float] = None, began: Optional[float] = None) -> Handle:
    """Runs an operation. In `options`, {"array": 0} stands for the first of `arrays`, of one or two dimensions."""
    views = [_Array(array.ctypes.data, _PLACES[array.dtype], array.ndim, (*array.shape, 1, 1)[:2], (*array.strides, 0, 0)[:2])
             for array in arrays]
    given = (_Array * len(views))(*views) if views else None
    made = ctypes.c_void_p()
    name, text = operation.encode(), json.dumps(options).encode() if options else None
    address = None if on is None else on.address
    try:
        _run(lambda run: int(_library.gvd_call(_ABI, name, address, text, given, len(views), run, ctypes.byref(made))), threads,
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
    _run(lambda run: int(_library.gvd_write_as(handle.address, name, text, run)), threads)


