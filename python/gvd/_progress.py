"""Progress of long calls: a function of the user's, a bar of tqdm, or a line on standard error."""
from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator
from typing import Any, Optional, Union

from ._calls import Callback
from ._error import refuse

Progress = Union[None, bool, Callback]
"""None or False: silent. True: a bar. A function of (step, fraction) is called some ten times a second, and ends the call
where it returns False."""


class _Bar:
    """A bar for each step."""

    def __init__(self) -> None:
        self.step = ""
        self.bar: Any = None
        try:
            from tqdm.auto import tqdm  # type: ignore[import]
            self.make: Any = tqdm
        except ImportError:
            self.make = None

    def __call__(self, step: str, fraction: float) -> None:
        if self.make is None:
            sys.stderr.write(f"\r{step} {fraction:4.0%}\x1b[K")
            sys.stderr.flush()
            self.bar = sys.stderr
            return
        if step != self.step:
            self.close()
            self.step, self.bar = step, self.make(total=1.0, desc=step, leave=False, bar_format="{l_bar}{bar}")
        self.bar.update(max(0.0, fraction - self.bar.n))

    def close(self) -> None:
        if self.make is None and self.bar is not None:
            sys.stderr.write("\r\x1b[K")
        elif self.bar is not None:
            self.bar.close()


@contextlib.contextmanager
def reporting(progress: Progress) -> Iterator[Optional[Callback]]:
    """The callback for one call of the library."""
    if progress is True:
        bar = _Bar()
        try:
            yield bar
        finally:
            bar.close()
    elif progress is None or progress is False or callable(progress):
        yield progress or None
    else:
        refuse(f"progress: True, None or a function of (step, fraction), not {type(progress).__name__}")
