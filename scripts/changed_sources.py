#!/usr/bin/env python3
"""Prints the C++ sources that the last commits concern: those that they changed, and those whose own header they changed.

    scripts/changed_sources.py N

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
    changed = set(lines_of("log", "-n", sys.argv[1], "--format=", "--name-only", "--", "*.cpp", "*.hpp"))
    by_name = collections.defaultdict(list)
    for source in lines_of("ls-files", "*.cpp"):
        by_name[pathlib.Path(source).stem].append(source)
    found = {source for sources in by_name.values() for source in sources if source in changed}
    for header in changed:
        if header.endswith(".hpp"):
            found.update(source for source in by_name[pathlib.Path(header).stem] if includes(source, header))
    print("\n".join(sorted(found)))


if __name__ == "__main__":
    main()
