#!/usr/bin/env python3
"""No target of the Makefile that builds some programs needs Catch2, and none takes the tests from a tree that has them.

    check_new_trees.py MAKEFILE WORK_FOLDER
"""
import os
import pathlib
import shutil
import subprocess
import sys

# In place of cmake: prints how it is called, and ends make where the build would begin.
CMAKE = """#!/bin/sh
echo "cmake $*"
[ "$1" != --build ]
"""
TARGETS = ("python", "figures", "count", "performance", "bench", "bench-lloyd", "bench-remesh", "why-exact", "paper")


def configured(makefile, work, target, build):
    """How `make TARGET` configures the tree."""
    path = f"{work / 'bin'}:{os.environ['PATH']}"
    ran = subprocess.run(["make", "-f", makefile, "-C", makefile.parent, target, "NO_INSTALL=1", f"BUILD={build}"], text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env={**os.environ, "PATH": path, "MAKEFLAGS": "", "CMAKE_FLAGS": ""})
    return next(line for line in ran.stdout.splitlines() if line.startswith("cmake --preset"))


def main():
    makefile, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(work, ignore_errors=True)
    (work / "bin").mkdir(parents=True)
    (work / "bin/cmake").write_text(CMAKE)
    (work / "bin/cmake").chmod(0o755)
    (work / "tested").mkdir()
    (work / "tested/CMakeCache.txt").write_text("GVD_BUILD_TESTS:BOOL=ON\n")
    for target in TARGETS:
        assert "-DGVD_BUILD_TESTS=OFF" in configured(makefile, work, target, work / "new"), f"make {target} builds tests in a new tree"
        assert "GVD_BUILD_TESTS" not in configured(makefile, work, target, work / "tested"), f"make {target} switches tests off"


if __name__ == "__main__":
    main()
