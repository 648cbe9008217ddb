#!/usr/bin/env python3
"""Runs a command on a mesh, and leaves a folder: mesh.ply, page.html, report.json and thumbnail.png, or error.json.

    step.py FOLDER MEGABYTES TRY [--after FOLDER] [--up AXIS] -- COMMAND INPUT [options]

A mesh that the command refuses is a result: its error is recorded, and the step is done. What may end otherwise on another try is
a failure of the step, with the command's exit code: an output that can't be written, a crash, and too little memory. A crash and
too little memory are recorded on the last try, so that no mesh stops another. A failure leaves FOLDER.failed.json beside the folder,
which Snakemake removes, so that the table can say why. A step --after one that left an error does not run. A result whose picture
can't be drawn keeps its files, and picture_error.txt says why.
"""
import argparse
import contextlib
import json
import pathlib
import signal
import subprocess
import sys

TRIES = 3
REFUSED = range(2, 6)  # exit codes that tell of the mesh or of the options
UNWRITABLE = 6
INTERRUPTED = 130, -signal.SIGINT, -signal.SIGTERM


def parse_arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("megabytes", type=int)
    parser.add_argument("attempt", type=int)
    parser.add_argument("--after", type=pathlib.Path)
    parser.add_argument("--up", default="y")
    parser.add_argument("command", nargs="+")
    return parser.parse_args()


def record_error(path, exit_code, message):
    path.write_text(json.dumps({"exit_code": exit_code, "error": message}) + "\n")


def failure_of(folder):
    """The file that tells of a failed try."""
    return folder.with_name(folder.name + ".failed.json")


def describe_end(exit_code, message):
    """The error of a command that failed; a crash leaves no message of its own."""
    if exit_code >= 0:
        return message or f"the command ended with exit code {exit_code}, without a message"
    try:
        name = signal.Signals(-exit_code).name
    except ValueError:
        name = f"signal {-exit_code}"
    return f"the command crashed or was killed ({name})" + (f", after: {message}" if message else "")


def draw_picture(folder, up):
    """A result without its picture is one still."""
    try:
        import thumbnail  # not before, as numpy would add to the memory of the command
        image = thumbnail.draw(folder / "mesh.ply", up)
        (folder / "thumbnail.png").write_bytes(thumbnail.encode_png(image))
    except Exception as error:
        text = " ".join(str(error).split())
        (folder / "picture_error.txt").write_text(f"no picture: {type(error).__name__}: {text}\n")


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
        return record_error(asked.folder / "error.json", None, f"not run: there is no result of {asked.after.name}")
    for old in (asked.folder / "error.json", asked.folder / "picture_error.txt", failure_of(asked.folder)):
        old.unlink(missing_ok=True)
    exit_code, message = run_command(asked)
    told = describe_end(exit_code, message)
    is_of_mesh = exit_code in REFUSED and "out of memory" not in message
    is_last = asked.attempt >= TRIES and exit_code != UNWRITABLE and exit_code not in INTERRUPTED
    if exit_code == 0:
        draw_picture(asked.folder, asked.up)
    elif is_of_mesh or is_last:
        record_error(asked.folder / "error.json", exit_code, told)
    else:
        with contextlib.suppress(OSError):  # the disk may be full
            record_error(failure_of(asked.folder), exit_code, told)
        sys.exit(exit_code if exit_code > 0 else 128 - exit_code)


if __name__ == "__main__":
    main()
