#!/usr/bin/env python3
"""tests/run_shard.py runs each test once, and names the one in which a program ends: check_shards.py RUN_SHARD WORK_FOLDER"""
import pathlib
import subprocess
import sys

run_shard, work = sys.argv[1], pathlib.Path(sys.argv[2])
work.mkdir(parents=True, exist_ok=True)
program = work / "program"
# Behaves as a Catch2 program: lists its tests, or runs those of the file, and ends at the one with "bad" in its name.
program.write_text(r'''#!/usr/bin/env python3
import os, sys
TESTS = ["a, b [c]", 'says "hello"', "is bad", "last", "left out"]
if "--list-test-names-only" in sys.argv:
    print("\n".join(TESTS)); sys.exit(len(TESTS))
names = open(sys.argv[sys.argv.index("--input-file") + 1]).read().splitlines()
for name in names:
    name = "".join(c for i, c in enumerate(name) if c != "\\")
    assert name in TESTS, name
    print("runs", name, flush=True)
    if "bad" in name and "BAD" in os.environ: os._exit(1)
    print("0.001 s: " + name, flush=True)
''')
program.chmod(0o755)


def run(shard, shards, **environment):
    return subprocess.run([sys.executable, run_shard, program, str(shard), str(shards), "left out$"], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, env={"PATH": "/usr/bin:/bin", **environment})


ran = [line[5:] for shard in range(3) for line in run(shard, 3).stdout.splitlines() if line.startswith("runs ")]
assert sorted(ran) == ['a, b [c]', 'is bad', 'last', 'says "hello"'], ran
assert all(run(shard, 3).returncode == 0 for shard in range(3))
bad = run(0, 1, BAD="1")
assert bad.returncode == 1 and "exit code 1, and the test 'is bad' did not end" in bad.stdout, bad.stdout
assert run(7, 8).returncode == 0  # a program of few tests has empty shards
program.write_text("#!/bin/sh\n")
none = run(0, 4)
assert none.returncode == 1 and "has no test" in none.stdout, none.stdout
