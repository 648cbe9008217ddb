"""Whether this interpreter can use the package: the module was built for one version of Python, and needs NumPy."""
from __future__ import annotations

import importlib
import os
import pathlib
import re
import sys

_FOLDER = pathlib.Path(__file__).resolve().parent


def _built_for() -> str | None:
    """The version that the module beside this file was built for, as "3.11". None without a module, or if its name has no version."""
    for module in _FOLDER.glob("_gvd.*"):
        version = re.match(r"_gvd\.(?:cpython-|cp)(\d)(\d+)", module.name)
        if version:
            return f"{version[1]}.{version[2]}"
    return None


def _system_python(version: str) -> str:
    """The interpreter of this version that Debian's packages belong to, or else the name that any has."""
    path = f"/usr/bin/python{version}"
    return path if os.path.exists(path) else f"python{version}"


def check_interpreter() -> None:
    """Raises an ImportError that says in one line what to do, if the module or NumPy can't be imported."""
    here, running = sys.executable, f"{sys.version_info.major}.{sys.version_info.minor}"
    version = _built_for()
    try:
        importlib.import_module("._gvd", __package__)
    except ModuleNotFoundError as error:
        if error.name != f"{__package__}._gvd":
            raise
        if version is None or version == running:
            raise ImportError(f"{_FOLDER} has no module _gvd for {here}: build the package with `make python`, and set PYTHONPATH to "
                              "the folder python of the build tree") from None
        raise ImportError(f"gvd was built for Python {version}, and {here} is Python {running}: use {_system_python(version)}, or "
                          "install gvd for this one with its own `pip install .`") from None
    try:
        importlib.import_module("numpy")
    except ModuleNotFoundError as error:
        if error.name != "numpy":
            raise
        other = _system_python(version or running)
        in_environment = sys.prefix != sys.base_prefix
        if os.path.realpath(other) == os.path.realpath(here) and not in_environment:
            raise ImportError(f"gvd needs NumPy, which {here} does not have: run `apt-get install python3-numpy`") from None
        raise ImportError(f"gvd was built for Python {version or running} and needs NumPy, which {here} does not have: run "
                          f"`{here} -m pip install numpy`, or use {other}") from None
