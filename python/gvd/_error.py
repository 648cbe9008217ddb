"""The one exception of the package."""
from __future__ import annotations

import contextlib
from collections.abc import Iterator
from typing import NoReturn


class Error(Exception):
    """What could not be done, in one line.

    `code` is one of "invalid_option", "unreadable_input", "precondition", "no_valid_result", "unwritable_output",
    "reader_gone" and "interrupted". `element` is the 0-based index of the first offending element, -1 for none.

    >>> import gvd
    >>> try:
    ...     gvd.read("nothing.ply")
    ... except gvd.Error as error:
    ...     print(error.code)
    unreadable_input
    """

    def __init__(self, message: str, code: str = "invalid_option", element: int = -1) -> None:
        super().__init__(message, code, element)  # all three, so that a pickled error comes back whole
        self.code = code
        self.element = element

    def __str__(self) -> str:
        return str(self.args[0])


def refuse(message: str, element: int = -1) -> NoReturn:
    """Refuses an argument."""
    raise Error(message, "invalid_option", element)


@contextlib.contextmanager
def naming(**names: str) -> Iterator[None]:
    """Calls options by the names of a function's own parameters, where an error begins with one."""
    try:
        yield
    except Error as error:
        option, colon, rest = str(error).partition(": ")
        if option not in names:
            raise
        raise Error(names[option] + colon + rest, error.code, error.element) from None
