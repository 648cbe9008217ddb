#!/usr/bin/env python3
"""Hashes every output of the three commands over folders of meshes: two builds that print the same lines agree.

    scripts/hash_outputs.py BIN_FOLDER MESHES... > before.txt     MESHES are files and folders
    scripts/hash_outputs.py --quick ...                            one number of generators, one number of threads

Each line has an SHA-256, the run and the file. Each run writes all formats of its command, a diagram, a page and a report.
There is a run for each combination of command (gvd-segment with and without --cut), method and front, 2, 30 and 100
generators, and 1 and 2 threads. A report is hashed without its times and its peak memory. The exit code has a line of
its own. Standard error is not hashed.
"""
import argparse
import concurrent.futures
import hashlib
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

MESH_FORMATS = ["ply", "obj", "off", "stl", "vtp", "vtu", "glb", "json"]
COMMANDS = {
    "segment": (["gvd-segment"], MESH_FORMATS),
    "cut": (["gvd-segment", "--cut"], MESH_FORMATS),
    "lloyd": (["gvd-lloyd", "--iterations", "4"], ["txt", "csv"] + MESH_FORMATS),
    "remesh": (["gvd-remesh"], MESH_FORMATS),
}
METHODS = {
    "exact": ["--method", "exact"],
    "circle": ["--method", "gbgvd", "--front", "circle"],
    "planar": ["--method", "gbgvd", "--front", "planar"],
}
# gvd-remesh is stopped after this time: on a mesh whose dual it can't repair, it may try for minutes.
SECONDS = 600


def list_meshes(paths):
    suffixes = {".obj", ".ply", ".off", ".stl"}
    for path in map(pathlib.Path, paths):
        files = [path] if path.is_file() else sorted(p for p in path.iterdir() if p.suffix.lower() in suffixes)
        yield from (p.resolve() for p in files)


def stable_bytes(path):
    """The content of the file without what differs from run to run."""
    content = path.read_bytes()
    if path.name != "report.json":
        return content
    report = json.loads(content)
    for member in ("timings_ms", "peak_memory_bytes", "version"):
        report.pop(member, None)
    return json.dumps(report).encode()


def run_one(bin_folder, mesh, command, method, count, threads):
    program, formats = COMMANDS[command]
    line = [str(bin_folder / program[0]), str(mesh), *program[1:], *METHODS[method], "-n", str(count), "-q",
            "--threads", str(threads), "--diagram", "diagram.json", "--view", "view.html", "--report", "report.json"]
    for suffix in formats:
        line += ["-o", f"out.{suffix}"]
    name = f"{mesh.name} {command} {method} n={count} threads={threads}"
    with tempfile.TemporaryDirectory() as folder:
        try:
            code = subprocess.run(line, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                  timeout=SECONDS).returncode
        except subprocess.TimeoutExpired:
            code = "timeout"
        lines = [f"{'exit ' + str(code):64} {name}"]
        for path in sorted(pathlib.Path(folder).iterdir()):
            lines.append(f"{hashlib.sha256(stable_bytes(path)).hexdigest()} {name} {path.name}")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin_folder", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("meshes", nargs="+")
    parser.add_argument("--quick", action="store_true", help="30 generators and 2 threads only")
    parser.add_argument("--commands", default=",".join(COMMANDS), help="some of: " + ",".join(COMMANDS))
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    counts, threads = ([30], [2]) if options.quick else ([2, 30, 100], [1, 2])
    runs = list(itertools.product(list_meshes(options.meshes), options.commands.split(","), METHODS, counts, threads))
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for lines in pool.map(lambda run: run_one(options.bin_folder, *run), runs):
            print("\n".join(lines), flush=True)


if __name__ == "__main__":
    sys.exit(main())
