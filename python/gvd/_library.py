"""The library: what it is loaded from, its structures, and its errors.

Its interface is gvd/gvd.h. One function, `gvd_call`, runs an operation by its name with options as JSON and arrays beside it
(_calls.py). _handles.py has its objects, and _clock.py and _signals.py what ends a call.
"""
from __future__ import annotations

import ctypes
import os
import pathlib

import numpy

from . import _described
from ._error import Error

TYPES = [numpy.dtype(name) for name in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8")]
"""By the numbers that the interface has for them."""

ABI, PYTHON, INTERRUPTED = 1, 1, 130
_OUT_OF_MEMORY = 1


class Array(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("type", ctypes.c_int32), ("dimensions", ctypes.c_int32),
                ("shape", ctypes.c_int64 * 2), ("strides", ctypes.c_int64 * 2)]


PROGRESS = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double)


class Run(ctypes.Structure):
    _fields_ = [("threads", ctypes.c_int), ("progress", PROGRESS), ("data", ctypes.c_void_p), ("cancel", ctypes.c_void_p),
                ("note", ctypes.c_void_p), ("due", ctypes.c_void_p), ("door", ctypes.c_int32), ("iteration", ctypes.c_void_p)]


def _load() -> ctypes.CDLL:
    """The library beside this file or, without one, the system's. Its interface is that of one version."""
    beside = pathlib.Path(__file__).resolve().parent / _described.SONAME
    name = str(beside) if beside.exists() else _described.SONAME
    try:
        loaded = ctypes.CDLL(name)
    except OSError as error:
        raise ImportError(f"gvd needs the library {_described.SONAME}: {error}; build it with `make python`, and set PYTHONPATH "
                          "to the folder python of the build tree") from None
    loaded.gvd_version.restype = ctypes.c_char_p
    version = loaded.gvd_version().decode()
    if version != _described.VERSION:
        raise ImportError(f"gvd {_described.VERSION} needs its own library, and {name} is that of {version}: install both together")
    return loaded


library = _load()
for _function in ("gvd_last_error", "gvd_last_error_code", "gvd_figures"):
    getattr(library, _function).restype = ctypes.c_char_p
library.gvd_last_error_element.restype = ctypes.c_int64
library.gvd_figures.argtypes = [ctypes.c_void_p]
library.gvd_release.argtypes = [ctypes.c_void_p]
library.gvd_release.restype = None
library.gvd_array_of.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
library.gvd_object_of.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
library.gvd_call.argtypes = [ctypes.c_int32, ctypes.c_char_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p, ctypes.c_int32,
                              ctypes.c_void_p, ctypes.c_void_p]
library.gvd_write_as.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_void_p]


def check(status: int) -> None:
    """Raises the last error of this thread, if there is one. Names of files need not be UTF-8, so neither do texts."""
    if status == 0:
        return
    text = os.fsdecode(library.gvd_last_error())
    if status == _OUT_OF_MEMORY:
        raise MemoryError(text)
    code = library.gvd_last_error_code().decode() or "internal_error"
    raise Error(text, code, library.gvd_last_error_element())
