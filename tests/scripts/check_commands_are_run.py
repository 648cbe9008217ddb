#!/usr/bin/env python3
"""scripts/check_commands.py finds each kind of command that nothing runs: check_commands_are_run.py SCRIPT WORK_FOLDER"""
import pathlib
import shutil
import subprocess
import sys

script, work = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
shutil.rmtree(work, ignore_errors=True)
guide = work / "docs/guide"
guide.mkdir(parents=True)
(work / "scripts").mkdir()
for name in ("check_commands.py", "check_examples.py", "tracked_files.py"):
    shutil.copy(script.with_name(name), work / "scripts")
(work / "scripts/release_check.sh").write_text('bare demo "\n    make demo\n    export PATH=\\$PWD/bin\n    venv/bin/pip install .\n"\n')
subprocess.run(["git", "init", "-q", work], check=True)
failures = 0


def expect(findings, text):
    global failures
    (work / "README.md").write_text("The project.\n")
    (guide / "page.md").write_text(text)
    done = subprocess.run([sys.executable, work / "scripts/check_commands.py"], capture_output=True, text=True)
    if done.returncode != (1 if findings else 0) or f" {findings} findings" not in done.stdout:
        failures += 1
        print(f"expected {findings} findings in {text!r}:\n{done.stdout}{done.stderr}")


expect(0, "    make demo   # and wait\n    export PATH=$PWD/bin\n\n    build/bin/gvd-segment mesh.ply\n")
expect(0, "Call `make demo` or `pip install .`; `make_demo` is no command.\n\n```text\n    nor is this\n```\n")
expect(1, "    make demo\n    make site\n")
expect(1, "    gzip mesh.ply\n    gzip -c a.ply > a.ply.gz && build/bin/gvd-segment a.ply.gz\n    d=$(build/bin/gvd-distance a.ply)\n")
expect(2, "Call `make dem` or `make demo FAST=1`.\n")
expect(2, "    snakemake -s Snakefile \\\n      --config meshes=/FOLDER\n")
expect(1, "Call `GVD_BUILD=build venv/bin/pip install .`.\n")
sys.exit(1 if failures else 0)
