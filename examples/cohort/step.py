#!/usr/bin/env python3
"""Runs a command on a mesh, and leaves a folder: mesh.ply, page.html, report.json and thumbnail.png, or error.json.

    step.py FOLDER MEGABYTES TRY [--after FOLDER] [--up AXIS] -- COMMAND INPUT [options]

A mesh that the command refuses is a result: its error is recorded, and the step is done. What may end otherwise on another try is
a failure of the step, with the command's exit code: an output that can't be written, a signal, and too little memory before the
last try. A step --after one that left an error does not run.
"""
import argparse
import json
import pathlib
import subprocess
import sys

TRIES = 3
REFUSED = range(2, 6)  # exit codes that tell of the mesh or of the options


def parse_arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("megabytes", type=int)
    parser.add_argument("attempt", type=int)
    parser.add_argument("--after", type=pathlib.Path)
    parser.add_argument("--up", default="y")
    parser.add_argument("command", nargs="+")
    return parser.parse_args()


def record_error(folder, exit_code, message):
    (folder / "error.json").write_text(json.dumps({"exit_code": exit_code, "error": message}) + "\n")


def run_command(asked):
    """Runs the command with its outputs in the folder. Returns its exit code and its last line of standard error."""
    files = {"-o": "mesh.ply", "--report": "report.json", "--view": "page.html"}
    outputs = [word for option, name in files.items() for word in (option, str(asked.folder / name))]
    command = [*asked.command, *outputs, "--up", asked.up, "--max-memory", f"{asked.megabytes}M"]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace")
    sys.stderr.write(done.stderr)
    return done.returncode, (done.stderr.strip().splitlines() or [""])[-1]


def main():
    asked = parse_arguments()
    asked.folder.mkdir(parents=True, exist_ok=True)
    if asked.after and (asked.after / "error.json").exists():
        return record_error(asked.folder, None, f"not run: there is no result of {asked.after.name}")
    exit_code, message = run_command(asked)
    if exit_code == 0:
        import thumbnail  # not before, as numpy would add to the memory of the command
        image = thumbnail.draw(asked.folder / "mesh.ply", asked.up)
        (asked.folder / "thumbnail.png").write_bytes(thumbnail.encode_png(image))
    elif exit_code in REFUSED and (asked.attempt >= TRIES or "out of memory" not in message):
        record_error(asked.folder, exit_code, message)
    else:
        sys.exit(exit_code if exit_code > 0 else 128 - exit_code)


if __name__ == "__main__":
    main()
