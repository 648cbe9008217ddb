"""The clock of running calls, and what ends them: the library is told ten times a second to call back."""
from __future__ import annotations

import atexit
import ctypes
import os
import threading
import time
from typing import Optional

_TICK = 0.1
"""Seconds between two looks for signals, and between two reports."""

_IDLE_TICKS = 20
"""The clock ends after so many ticks without a call."""

_PATIENCE = 2.0
"""Seconds that the end of Python waits for daemon threads to leave the library."""


class Flags:
    """What ends a running call: `due` lets the library call back, and `cancel` ends the call."""

    __slots__ = ("due", "cancel", "is_late")

    def __init__(self) -> None:
        self.due, self.cancel, self.is_late = ctypes.c_int32(1), ctypes.c_int32(0), False

    def expire(self) -> None:
        self.is_late, self.cancel.value = True, 1


_running: dict[int, Flags] = {}
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
    _is_ending, latest = True, time.monotonic() + _PATIENCE
    for flags in list(_running.values()):
        flags.cancel.value = 1
    while _running and time.monotonic() < latest:
        time.sleep(_TICK / 10)


def stay_at_end() -> None:
    """Where a daemon thread stays while Python ends: it has nobody to tell why its call has ended."""
    if _is_ending and threading.get_ident() != threading.main_thread().ident:
        threading.Event().wait()


def begin(flags: Flags) -> None:
    """A call begins."""
    _running[id(flags)] = flags
    if _clock is None:
        _start_clock()


def end(flags: Flags) -> None:
    del _running[id(flags)]
