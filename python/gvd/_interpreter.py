"""Whether this interpreter can use the package: it needs NumPy, and files that the build makes."""
from __future__ import annotations

import importlib.util
import os
import pathlib
import sys

_FOLDER = pathlib.Path(__file__).resolve().parent


def check_interpreter() -> None:
    """Raises an ImportError that says in one line what to do, if something is missing."""
    here, version = sys.executable, f"{sys.version_info.major}.{sys.version_info.minor}"
    if not (_FOLDER / "_described.py").exists():
        raise ImportError(f"{_FOLDER} is not built: build the package with `make python`, and set PYTHONPATH to the folder python of "
                          "the build tree")
    if importlib.util.find_spec("numpy") is not None:
        return
    system, in_environment = "/usr/bin/python3", sys.prefix != sys.base_prefix
    if os.path.realpath(system) == os.path.realpath(here) and not in_environment:
        raise ImportError(f"gvd needs NumPy, which {here} does not have: run `apt-get install python3-numpy`")
    raise ImportError(f"gvd needs NumPy, which {here} (Python {version}) does not have: run `{here} -m pip install numpy`, or use {system}")
