#!/usr/bin/env python3
"""Fails on a source of more than 600 lines, which rarely has one idea.

    scripts/check_long_files.py

A file that was longer when this check came stands in OLD with its lines. It may not grow, and leaves the list once it is short enough.
"""
import sys

from tracked_files import ROOT, report, tracked

MOST_LINES = 600
OLD = {"web/test/viewer.test.mjs": 851}
SOURCES = ("*.cpp", "*.hpp", "*.h", "*.c", "*.js", "*.mjs", "*.py", "*.sh")


def check(path):
    name = str(path.relative_to(ROOT))
    lines = len(path.read_text().splitlines())
    most = OLD.get(name, MOST_LINES)
    if lines > most:
        return f"{name} has {lines} lines (at most {most}): split it by its ideas"
    if name in OLD and lines <= MOST_LINES:
        return f"{name} has {lines} lines: take it out of OLD in scripts/check_long_files.py"
    return None


if __name__ == "__main__":
    sources = tracked(*SOURCES)
    sys.exit(report(sources, filter(None, map(check, sources)), "sources"))
