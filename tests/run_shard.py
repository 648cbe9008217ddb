#!/usr/bin/env python3
"""Runs every N-th test of a Catch2 program in one process.

    run_shard.py PROGRAM SHARD SHARDS [LEFT_OUT]

SHARD counts from 0. Tests whose name matches the regular expression LEFT_OUT do not run. A process for each test, as in other
builds, would take twice as long under sanitizers. Where the process ends early, as by a finding of a sanitizer, the test that it was
in is named.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ORDER = ["--order", "lex"]


def list_tests(program, left_out):
    # The exit code of Catch2 2.13 is the number of tests.
    listed = subprocess.run([program, "~[.]", "--list-test-names-only", *ORDER], stdout=subprocess.PIPE, text=True).stdout
    return [name for name in listed.splitlines() if name and not (left_out and re.search(left_out, name))]


def run_tests(program, tests):
    """What the tests print, the names of those that ended, and the exit code."""
    with tempfile.TemporaryDirectory() as folder:
        names = pathlib.Path(folder) / "tests"
        # Catch2 puts each line of this file in quotes.
        names.write_text("".join(re.sub(r'([\\",\[\]])', r"\\\1", name) + "\n" for name in tests))
        done = subprocess.run([program, "--input-file", str(names), "--durations", "yes", *ORDER],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    ended, printed = set(), []
    for line in done.stdout.splitlines():
        timed = re.fullmatch(r"[0-9.]+ s: (.*)", line)
        if timed:
            ended.add(timed[1].strip())
        else:
            printed.append(line)
    return printed, ended, done.returncode


def main():
    program, shard, shards = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    tests = list_tests(program, sys.argv[4] if len(sys.argv) > 4 else "")[shard::shards]
    if not tests:  # a program of few tests has empty shards, but the first one
        sys.exit(0 if shard > 0 else f"run_shard.py: {program} has no test")
    printed, ended, exit_code = run_tests(program, tests)
    print("\n".join(printed))
    missing = [name for name in tests if name.strip() not in ended]
    if missing:
        sys.exit(f"run_shard.py: exit code {exit_code}, and the test '{missing[0]}' did not end")
    sys.exit(1 if exit_code else 0)


if __name__ == "__main__":
    main()
