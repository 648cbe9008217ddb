#!/usr/bin/env python3
"""Measures what each step of the workflow costs on meshes of many sizes, and fits the formula of cost.py to it.

    measure.py run BIN WORK MESH... > costs.tsv     steps with 30, 300 and 1000 generators; MESH@2: each face cut in four, twice
    measure.py fit costs.tsv [OTHERS.tsv]            constants for cost.py, and how far the measured costs are from the formula

Memory is the largest that a process of the step held; time is that of the processor, with one thread. Needs numpy.
"""
import importlib.util
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
COUNTS = 30, 300, 1000
COLUMNS = "mesh", "faces", "n", "step", "megabytes", "seconds"


def refine(text, times, target):
    """Cuts each triangle of an .off into four, `times` times, and writes a binary .ply."""
    import numpy as np
    with open(text) as file:
        words = [word for line in file for word in line.split("#")[0].split() if word not in ("OFF", "NOFF")]
    vertices, faces = int(words[0]), int(words[1])
    points = np.array(words[3:3 + 3 * vertices], float).reshape(-1, 3)
    corners = np.array(words[3 + 3 * vertices:3 + 3 * vertices + 4 * faces], int).reshape(-1, 4)[:, 1:]
    for _ in range(times):
        edges, index = np.unique(np.sort(np.stack([corners, np.roll(corners, -1, 1)], 2).reshape(-1, 2), 1), axis=0, return_inverse=True)
        (a, b, c), (ab, bc, ca) = corners.T, index.reshape(-1, 3).T + len(points)
        points = np.concatenate([points, points[edges].mean(1)])
        corners = np.stack([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca], 1).reshape(-1, 3)
    header = "ply\nformat binary_little_endian 1.0\nelement vertex %d\n" % len(points)
    header += "".join(f"property double {axis}\n" for axis in "xyz") + "element face %d\n" % len(corners)
    rows = np.empty(len(corners), [("corners", "u1"), ("face", "<i4", 3)])
    rows["corners"], rows["face"] = 3, corners
    target.write_bytes((header + "property list uchar int vertex_indices\nend_header\n").encode() + points.tobytes() + rows.tobytes())


def find_mesh(name, work):
    """The file of MESH or MESH@TIMES. Another process refines it: the memory of this one would count for its children."""
    path, _, times = name.partition("@")
    if not times:
        return path
    target = work / f"{pathlib.Path(path).stem}@{times}.ply"
    if not target.exists():
        subprocess.run([sys.executable, __file__, "refine", path, times, str(target)], check=True)
    return str(target)


def measure(folder, command):
    """Megabytes, seconds and the report of one step."""
    step = [sys.executable, str(HERE / "step.py"), str(folder), "100000", "1", "--", *command, "-q", "--threads", "1"]
    _, status, usage = os.wait4(os.spawnvp(os.P_NOWAIT, step[0], step), 0)
    if status or (folder / "error.json").exists():
        return None
    report = json.loads((folder / "report.json").read_text())
    return usage.ru_maxrss / 1024, usage.ru_utime + usage.ru_stime, report["input"]["faces"]


def run(binaries, work, *meshes):
    work = pathlib.Path(work)
    work.mkdir(parents=True, exist_ok=True)
    print(*COLUMNS, sep="\t", flush=True)
    for name in meshes:
        mesh = find_mesh(name, work)
        for n in COUNTS:
            commands = {"segment": ["gvd-segment", mesh, "-n", str(n)], "relax": ["gvd-lloyd", mesh, "-n", str(n)],
                        "remesh": ["gvd-remesh", mesh, "--generators", str(work / "relax/report.json")]}
            for step, command in commands.items():
                measured = measure(work / step, [f"{binaries}/{command[0]}", *command[1:]])
                if measured is None:
                    break
                megabytes, seconds, faces = measured
                print(pathlib.Path(name).name, faces, n, step, f"{megabytes:.1f}", f"{seconds:.3f}", sep="\t", flush=True)


def fit_constants(terms, costs):
    """Least squares of relative errors, by constants that are not negative."""
    import numpy as np
    used = [0, 1, 2]
    while True:
        found = np.linalg.lstsq(terms[:, used] / costs[:, None], np.ones(len(costs)), rcond=None)[0]
        if (found >= 0).all():
            return np.array([found[used.index(k)] if k in used else 0 for k in range(3)])
        used = [k for k, value in zip(used, found) if value >= 0]


def print_table(rows):
    """Costs with 300 generators, a row for each mesh."""
    meshes = list(dict.fromkeys((row["mesh"], int(row["faces"])) for row in rows))
    for mesh, faces in meshes:
        of_mesh = {row["step"]: row for row in rows if row["mesh"] == mesh and row["n"] == "300"}
        print(f"| {mesh} | {faces:,} |", " | ".join(f'{float(of_mesh[s]["megabytes"]):.0f}, {float(of_mesh[s]["seconds"]):.1f}'
                                                    for s in ("segment", "relax", "remesh")), "|")


def fit(table, *others):
    """Fits the first table; the others only show how far other meshes are from the formula."""
    import csv
    import numpy as np
    tables = [list(csv.DictReader(open(name), delimiter="\t")) for name in (table, *others)]
    for what in ("megabytes", "seconds"):
        for step in ("segment", "relax", "remesh"):
            constants = None
            for name, rows in zip((table, *others), tables):
                chosen = [row for row in rows if row["step"] == step]
                terms = np.array([(1, int(row["faces"]) / 1e6, int(row["n"]) / 1e3) for row in chosen])
                costs = np.array([float(row[what]) for row in chosen])
                constants = fit_constants(terms, costs) if constants is None else constants
                ratios = costs / (terms @ constants)
                print(f"{what} {step}: {constants.round(2)}; {name}: {ratios.min():.2f} to {ratios.max():.2f} of the formula")
    for rows in tables:
        print_table(rows)


if __name__ == "__main__":
    if importlib.util.find_spec("numpy") is None:
        sys.exit(f"measure.py: {sys.executable} has no NumPy; call /usr/bin/python3 {sys.argv[0]} ... with Debian's python3-numpy")
    if sys.argv[1] == "refine":
        refine(sys.argv[2], int(sys.argv[3]), pathlib.Path(sys.argv[4]))
    else:
        {"run": run, "fit": fit}[sys.argv[1]](*sys.argv[2:])
