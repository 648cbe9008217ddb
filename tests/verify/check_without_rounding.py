#!/usr/bin/env python3
"""Valgrind's processor only rounds to nearest. Commands work there, and --verify refuses: check_without_rounding.py BIN_FOLDER MESH."""
import shutil
import subprocess
import sys

program, mesh = sys.argv[1] + "/gvd-segment", sys.argv[2]
if not shutil.which("valgrind"):
    print("skipped: no valgrind")
    sys.exit(77)


def run(machine, *options):
    line = [*machine, program, mesh, "-n", "3", "--threads", "1", "-q", "-o", "-", "--output-format", "off"]
    return subprocess.run([*line, *options], text=True, capture_output=True)


valgrind = ["valgrind", "-q", "--tool=none"]
plain, verified = run(valgrind), run(valgrind, "--verify")
assert plain.returncode == 0 and plain.stdout.startswith("OFF"), plain.stderr
assert run([], "--verify").returncode == 0
assert verified.returncode == 5 and "only rounds to nearest" in verified.stderr, verified.stderr
