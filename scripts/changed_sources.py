#!/usr/bin/env python3
"""Prints the C++ sources that the last commits concern: those that they changed, and those whose own header they changed.

    scripts/changed_sources.py N [MOST]

The latest changes come first; with MOST, that many sources are listed, and standard error tells how many are left out.
A source's own header has its name and is included by it, wherever the two lie: `libgvd/include/gvd/mesh.hpp` is that of
`libgvd/src/mesh/mesh.cpp`, which has `#include "gvd/mesh.hpp"`. A shallow clone may have fewer commits than N; its oldest
one then adds all of its files.
"""
import collections
import pathlib
import re
import subprocess
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def lines_of(*command):
    return subprocess.run(["git", *command], check=True, capture_output=True, text=True).stdout.splitlines()


def includes(source, header):
    """Whether a source has an include that names this header, by the end of its path."""
    return any(f"/{header}".endswith(f"/{name}") for name in INCLUDE.findall(pathlib.Path(source).read_text()))


def main():
    commits, most = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else None
    changed = lines_of("log", "-n", commits, "--format=", "--name-only", "--", "*.cpp", "*.hpp")
    by_name = collections.defaultdict(list)
    for source in lines_of("ls-files", "*.cpp"):
        by_name[pathlib.Path(source).stem].append(source)
    found = {}  # in this order
    for name in dict.fromkeys(changed):
        for source in by_name[pathlib.Path(name).stem]:
            if source == name or (name.endswith(".hpp") and includes(source, name)):
                found[source] = None
    print("\n".join(list(found)[:most]))
    if most is not None and len(found) > most:
        print(f"changed_sources.py: left out {len(found) - most} of {len(found)} sources, which changed before the others", file=sys.stderr)


if __name__ == "__main__":
    main()
