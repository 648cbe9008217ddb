#!/usr/bin/env python3
"""Measures a call of the library through Python and through C: what ctypes, JSON and the watch for Ctrl-C add.

    call_overhead.py PACKAGE_FOLDER

The mesh is an icosahedron, and its diagram's faces are labelled with empty options. A C program, which this compiles
with cc, makes the same calls. Both print microseconds: the least of 20 averages over 2,000 calls.
"""
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
PACKAGE = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(PACKAGE))

import numpy  # noqa: E402
import gvd  # noqa: E402
from gvd import _described, _library  # noqa: E402

ROUNDS, CALLS = 20, 2000

PROGRAM = r"""
#include <stdio.h>
#include <time.h>
#include "gvd/gvd.h"
static double now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return t.tv_sec + 1e-9 * t.tv_nsec; }
int main(int count, char** names) {
  gvd_object *mesh, *diagram, *made;
  gvd_mesh_read(names[1], 1, &mesh);
  gvd_call(GVD_ABI, "diagram", mesh, "{\"vertices\": [0, 3]}", NULL, 0, NULL, &diagram);
  double best = 1;
  for (int round = 0; round < ROUNDS; ++round) {
    double start = now();
    for (int i = 0; i < CALLS; ++i) { gvd_call(GVD_ABI, "label", diagram, NULL, NULL, 0, NULL, &made); gvd_release(made); }
    double each = (now() - start) / CALLS;
    if (each < best) best = each;
  }
  printf("%.9f\n", best);
  return 0;
}
"""


def icosahedron():
    g = (1 + 5 ** 0.5) / 2
    at = [(s, t * g, 0) for s in (-1, 1) for t in (-1, 1)]
    at = numpy.array(at + [(0, x, y) for x, y, _ in at] + [(y, 0, x) for x, y, _ in at])
    near = lambda i, j: abs(numpy.linalg.norm(at[i] - at[j]) - 2) < 1e-9
    faces = [(i, j, k) for i in range(12) for j in range(i) for k in range(j) if near(i, j) and near(j, k) and near(k, i)]
    return at, [f if numpy.linalg.det(at[list(f)]) > 0 else f[::-1] for f in faces]


def best_of(call):
    best = 1.0
    for _ in range(ROUNDS):
        start = time.perf_counter()
        for _ in range(CALLS):
            call()
        best = min(best, (time.perf_counter() - start) / CALLS)
    return best


mesh = gvd.Mesh(*icosahedron())
diagram = mesh.voronoi([0, 3])
with tempfile.TemporaryDirectory() as folder:
    (pathlib.Path(folder) / "call.c").write_text(PROGRAM)
    mesh.to_file(f"{folder}/mesh.ply")
    (pathlib.Path(folder) / _described.SONAME).symlink_to(PACKAGE / "gvd" / _described.SONAME)
    subprocess.run(["cc", "-O2", f"-DROUNDS={ROUNDS}", f"-DCALLS={CALLS}", f"-I{ROOT}/libgvd/c/include", f"{folder}/call.c",
                    f"{folder}/{_described.SONAME}", f"-Wl,-rpath,{folder}", "-o", f"{folder}/call"], check=True)
    in_c = float(subprocess.run([f"{folder}/call", f"{folder}/mesh.ply"], check=True, capture_output=True, text=True).stdout)
call, method = best_of(lambda: _library.call("label", diagram._native)), best_of(diagram.segment)
view = best_of(lambda: diagram._native.array("vertex_labels"))
print(f"C {in_c * 1e6:.1f} us; Python's call {call * 1e6:.1f} us, {(call - in_c) * 1e6:.1f} more; Diagram.segment "
      f"{method * 1e6:.1f} us, {(method - in_c) * 1e6:.1f} more; a view of an array {view * 1e6:.1f} us")
