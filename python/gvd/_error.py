"""The one exception of the package."""
from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
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


def renamed(line: str, names: Mapping[str, str]) -> str:
    """Calls the option that a line begins with by the name of a function's own parameter."""
    option, colon, rest = line.partition(": ")
    return names.get(option, option) + colon + rest


@contextlib.contextmanager
def naming(names: Mapping[str, str]) -> Iterator[None]:
    """The same for errors."""
    try:
        yield
    except Error as error:
        line = renamed(str(error), names)
        if line == str(error):
            raise
        raise Error(line, error.code, error.element) from None
