#!/usr/bin/env python3
"""Fails if a test, or a part of one, was skipped that tests/allowed_skips.txt does not name.

    scripts/check_skips.py BUILD_FOLDER

Reads what CTest kept of its last run. A test is skipped by its exit code. Parts of a test are skipped by what it prints: a line
"skipped: REASON", the count of unittest ("OK (skipped=1)"), or that of Node.js ("# skipped 1").
"""
import re
import sys
import pathlib

from tracked_files import ROOT

ALLOWED = ROOT / "tests/allowed_skips.txt"
SKIPPED = re.compile(r"^\s*(skipped: .*|OK \(.*skipped=\d+.*\)|(?:#|ℹ) skipped [1-9]\d*|Test Skipped\.)\s*$", re.MULTILINE)


def read_allowed(text):
    """The names of tests, each with its reason."""
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    pairs = [line.split(" | ", 1) for line in lines]
    for pair in pairs:
        if len(pair) != 2 or not pair[1].strip():
            sys.exit(f"{ALLOWED.name}: '{pair[0]}' has no reason: write NAME | REASON")
    return {name.strip(): reason for name, reason in pairs}


def find_skips(log):
    """Pairs of a test's name and what it says of a skip, from CTest's log."""
    for part in re.split(r"^\d+/\d+ Testing: ", log, flags=re.MULTILINE)[1:]:
        name, _, rest = part.partition("\n")
        for line in SKIPPED.findall(rest):
            yield name.strip(), line.strip()


def main():
    logs = sorted(pathlib.Path(sys.argv[1], "Testing/Temporary").glob("LastTest.log*"))
    if not logs:
        sys.exit(f"check_skips.py: no log of CTest below {sys.argv[1]}: run the tests first")
    allowed = read_allowed(ALLOWED.read_text())
    skips = list(find_skips(logs[0].read_text(errors="replace")))
    findings = [f"{name}: {line}" for name, line in skips if name not in allowed]
    for finding in findings:
        print(f"not in tests/{ALLOWED.name}: {finding}")
    print(f"{len(skips)} skips, {len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
