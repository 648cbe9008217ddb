"""Signals during a call. Python runs their handlers only between steps of its own, so the library calls back now and then."""
from __future__ import annotations

import contextlib
import threading
# The functions of the module signal, without its enumerations: these take 10 us a call.
import _signal  # type: ignore[import]
from collections.abc import Iterator
from typing import Any

from ._clock import Flags

# Signals that programs handle. Those of errors, such as SIGSEGV, have nothing to return to.
_SIGNALS = [getattr(_signal, f"SIG{name}") for name in ("INT", "TERM", "HUP", "QUIT", "ALRM", "VTALRM", "PROF", "USR1", "USR2")
            if hasattr(_signal, f"SIG{name}")]


@contextlib.contextmanager
def keeping_signals(flags: Flags, raised: list[BaseException]) -> Iterator[dict[int, Any]]:
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
