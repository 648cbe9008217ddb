#!/usr/bin/env python3
"""The C interface through Python's ctypes: the same bytes as the commands, and two threads at once.

    check_ctypes.py LIBRARY BIN_FOLDER DATA_FOLDER
"""
import ctypes
import pathlib
import subprocess
import sys
import tempfile
import threading

LIBRARY, BIN, DATA = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
gvd = ctypes.CDLL(LIBRARY)
gvd.gvd_last_error.restype = ctypes.c_char_p
gvd.gvd_sample.argtypes = [ctypes.c_void_p, ctypes.c_int32, ctypes.c_int, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_void_p]


class Point(ctypes.Structure):
    _fields_ = [("face", ctypes.c_int32), ("bary", ctypes.c_double * 3)]


def call(function, *arguments):
    status = getattr(gvd, function)(*arguments)
    assert status == 0, f"{function}: {status}: {gvd.gvd_last_error().decode()}"


def handle(function, *arguments):
    made = ctypes.c_void_p()
    call(function, *arguments, ctypes.byref(made))
    return made


def read(name):
    return handle("gvd_mesh_read", str(DATA / name).encode(), 1)


def check_weld(folder):
    """Four faces of a tetrahedron with vertices of their own, some of them .25 off, are joined as by --weld."""
    corners = [(0, 0, 0), (0, 1, 0), (1, 0, 0), (0, 0, 0), (1, 0, 0), (0, 0, 1), (0, 0, 0), (0, 0, 1), (0, 1, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    path = folder / "loose.obj"
    for gap, tolerance in ((0, 0), (0.25, 0.25)):
        moved = [(x, y, z + gap * (i in (3, 4, 9))) for i, (x, y, z) in enumerate(corners)]
        lines = ["v %g %g %g" % corner for corner in moved] + [f"f {i} {i + 1} {i + 2}" for i in (1, 4, 7, 10)]
        path.write_text("\n".join(lines) + "\n")
        mesh = handle("gvd_mesh_read_welded", str(path).encode(), 1, ctypes.c_double(tolerance))
        assert gvd.gvd_mesh_vertex_count(mesh) == 4, (gap, tolerance)
        gvd.gvd_mesh_free(mesh)
    made = ctypes.c_void_p()
    assert gvd.gvd_mesh_read_welded(str(path).encode(), 1, ctypes.c_double(-1), ctypes.byref(made)) == 2
    assert gvd.gvd_last_error() == b"weld: the tolerance -1 is not a finite number from 0 on"


def run(*command):
    subprocess.run([str(BIN / command[0]), *map(str, command[1:])], check=True, stderr=subprocess.DEVNULL)


def check_segment(folder, name, count):
    mesh, points = read(name), (Point * count)()
    call("gvd_sample", mesh, count, 0, 0, None, points)
    diagram = handle("gvd_diagram_compute", mesh, points, count, 0, None)
    for extension in ("ply", "json", "vtp"):
        mine, theirs = folder / f"mine.{extension}", folder / f"theirs.{extension}"
        call("gvd_segment_write", diagram, str(mine).encode(), None)
        run("gvd-segment", DATA / name, "-n", count, "-o", theirs)
        assert mine.read_bytes() == theirs.read_bytes(), (name, extension)
    gvd.gvd_diagram_free(diagram)
    gvd.gvd_mesh_free(mesh)


def check_lloyd(folder, name, count):
    mesh, points, energy = read(name), (Point * count)(), ctypes.c_double()
    call("gvd_lloyd", mesh, None, count, None, None, points, ctypes.byref(energy))
    run("gvd-lloyd", DATA / name, "-n", count, "-o", folder / "relaxed.txt")
    rows = [line.split() for line in (folder / "relaxed.txt").read_text().splitlines() if line[0] != "#"]
    theirs = [(int(face), *map(float, bary)) for face, *bary in rows]
    assert theirs == [(p.face, *p.bary) for p in points], name
    gvd.gvd_mesh_free(mesh)


def check_remesh(folder, name, count):
    mesh = read(name)
    coarse = handle("gvd_remesh", mesh, None, count, None, None)
    call("gvd_mesh_write", coarse, str(folder / "mine.ply").encode())
    run("gvd-remesh", DATA / name, "-n", count, "-o", folder / "theirs.ply")
    assert (folder / "mine.ply").read_bytes() == (folder / "theirs.ply").read_bytes(), name
    points = (Point * gvd.gvd_mesh_vertex_count(coarse))()
    call("gvd_mesh_generators", coarse, points)
    assert all(0 <= p.face < gvd.gvd_mesh_face_count(mesh) for p in points)
    gvd.gvd_mesh_free(coarse)
    gvd.gvd_mesh_free(mesh)


def check_threads():
    """Threads share a mesh; each has its own message of an error."""
    mesh, results, messages = read("torus.ply"), [None, None], [None, None]

    def work(i):
        source, count = Point(), gvd.gvd_mesh_vertex_count(mesh)
        distances = (ctypes.c_double * count)()
        call("gvd_point_at_vertex", mesh, ctypes.c_int64(5), ctypes.byref(source))
        for _ in range(10):
            call("gvd_distances", mesh, ctypes.byref(source), 1, None, distances, None)
        results[i] = bytes(distances)
        gvd.gvd_point_at_vertex(mesh, ctypes.c_int64(10**9 + i), ctypes.byref(source))
        messages[i] = gvd.gvd_last_error().decode()

    threads = [threading.Thread(target=work, args=(i,)) for i in range(2)]
    [t.start() for t in threads], [t.join() for t in threads]
    assert results[0] is not None and results[0] == results[1]
    assert all(str(10**9 + i) in message for i, message in enumerate(messages)), messages
    gvd.gvd_mesh_free(mesh)


with tempfile.TemporaryDirectory() as made:
    folder = pathlib.Path(made)
    for name in ("figure.obj", "half_sphere.off", "plate.stl"):
        check_segment(folder, name, 30)
        check_lloyd(folder, name, 25)
        check_remesh(folder, name, 120)
    check_threads()
    check_weld(folder)
print("all checks passed")
