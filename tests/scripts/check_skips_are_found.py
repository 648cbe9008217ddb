#!/usr/bin/env python3
"""scripts/check_skips.py finds each kind of skip, and lets those of the list pass: check_skips_are_found.py SCRIPT WORK_FOLDER"""
import pathlib
import shutil
import subprocess
import sys

script, work = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
shutil.rmtree(work, ignore_errors=True)
(work / "build/Testing/Temporary").mkdir(parents=True)
(work / "tests").mkdir()
(work / "scripts").mkdir()
for name in (script, script.with_name("tracked_files.py")):
    shutil.copy(name, work / "scripts")
failures = 0


def expect(code, log, allowed="# none\n"):
    """Runs the check on a log that is as CTest writes it."""
    global failures
    (work / "tests/allowed_skips.txt").write_text(allowed)
    (work / "build/Testing/Temporary/LastTest.log").write_text(
        "Start testing: now\n----\n" + "".join(f"{i}/9 Testing: {name}\n{i}/9 Test: {name}\nCommand: \"x\"\nOutput:\n----\n{output}"
                                               f"<end of output>\nTest time =   0.01 sec\n----\nTest {end}.\n\"{name}\" end time: now\n"
                                               for i, (name, output, end) in enumerate(log)))
    done = subprocess.run([sys.executable, work / "scripts/check_skips.py", work / "build"], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    if done.returncode != code:
        failures += 1
        print(f"expected {code} for {log}, allowed {allowed!r}: {done.returncode}\n{done.stdout}")


PASSED = ("a: works", "All tests passed\n", "Passed")
expect(0, [PASSED])
expect(1, [PASSED, ("b: browser", "skipped: no browser\n", "Skipped")])
expect(1, [("b: quiet", "", "Skipped")])
expect(1, [("c: part", "t.cpp:1: warning:\n  skipped: no model\n\nAll tests passed\n", "Passed")])
expect(1, [("python: part", "Ran 3 tests in 0.1s\n\nOK (skipped=1)\n", "Passed")])
expect(1, [("io: node", "# pass 3\n# skipped 2\n", "Passed")])
expect(0, [("io: node", "# pass 3\n# skipped 0\n", "Passed")])
expect(0, [("d: other words", "two lines were skipped: see above\n", "Passed")])
expect(0, [("b: browser", "skipped: no browser\n", "Skipped")], "b: browser | Debian has none\n")
expect(1, [("b: browser", "skipped: no browser\n", "Skipped"), ("e: other", "skipped: x\n", "Passed")], "b: browser | Debian has none\n")
expect(1, [PASSED], "b: browser\n")
sys.exit(1 if failures else 0)
