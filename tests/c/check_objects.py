#!/usr/bin/env python3
"""Objects of the C interface through ctypes: meshes of arrays, of files and saved ones, files of parts, how a run says who
reads its texts and how often it reports, and what one operation has as the others do.

    check_objects.py LIBRARY BIN_FOLDER DATA_FOLDER
"""
import ctypes
import json
import pathlib
import tempfile
import threading
import time

from check_calls import DATA, INTERRUPTED, INVALID, NOTE, OK, PRECONDITION, PROGRESS, Run, array, call, diagram_parts, figures, gvd, handle, make_ball, numbers, read, refused, release, result


def check_meshes(folder):
    """Meshes of arrays, of files and of what was saved of them; numbers of files."""
    corners = array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (5, 5, 5)])
    square = array([(0, 1, 2, 3)], ctypes.c_int32)
    assert refused("mesh", None, {"on_defect": "error"}, corners, square, status=PRECONDITION).startswith("1 vertex is in no face")
    mesh = result("mesh", None, {}, corners, square)
    assert figures(mesh)["repairs"] and figures(mesh)["faces"] == 2 and figures(mesh)["edges"] == 5
    saved = [array(numbers(mesh, name)) for name in ("vertex_positions", "face_vertices", "vertex_of_input", "input_vertex",
                                                     "input_polygon", "texture", "face_materials")]
    again = result("saved_mesh", None, {"repairs": figures(mesh)["repairs"]}, *saved)
    assert numbers(again, "vertex_of_input") == [0, 1, 2, 3, -1] and figures(again)["repairs"] == figures(mesh)["repairs"]
    assert refused("saved_mesh", None, {}, *saved[:3]) == "a saved mesh has 7 arrays; 3 given"
    for i in (2, 3, 4, 5, 6):
        wrong = saved[:i] + [array([7.5])] + saved[i + 1:]
        assert refused("saved_mesh", None, {}, *wrong, status=PRECONDITION) == f"array {i} does not belong to a saved mesh"
    assert refused("mesh", None, {}) == "a mesh needs two arrays, positions and faces, or a file; 0 given"
    assert refused("mesh", None, {}, corners, array([0.5])) == "positions have three columns, and faces have three or more"
    assert refused("mesh", None, {}, corners, array([(0, 1, 2.5)])) == "a face has the vertex 2.5"
    assert refused("mesh", None, {}, corners, array([(0, 1, 9)]), status=PRECONDITION).startswith("face 0 has the vertex 9")
    assert refused("mesh", None, {"input_format": "ply"}, corners, square) == '"input_format" needs "file": add it, or leave "input_format" out'
    name = (folder / "values.txt")
    name.write_text("1\n2.5\n")
    values = result("values", None, {"file": {"array": 0}}, array(list(str(name).encode()), ctypes.c_uint8))
    assert numbers(values, "values") == [1, 2.5]
    properties = result("properties", None, {"file": str(DATA / "torus.ply")})
    assert figures(properties)["names"] == [], figures(properties)["names"]
    status, message = call("values", None, {"file": "/no/such"})
    assert (status, gvd.gvd_last_error_code(), gvd.gvd_last_error_element()) == (3, b"unreadable_input", -1), message
    assert refused("mesh", None, {"on_defect": "error"}, corners, array([(0, 1, 2), (0, 1, 2)]), status=PRECONDITION)
    assert gvd.gvd_last_error_element() == 1
    release(mesh, again, values, properties)


def check_words():
    """Texts stand in their own quotes only, no line is told of a list that has none, and options that do nothing are told."""
    ball = make_ball()
    bad = lambda options: refused("lloyd", ball, options)
    assert bad({"generators": "V 0"}).startswith("\"generators\": 'V 0' is not a list of points")
    assert bad({"vertices": ["V 0"]}) == "\"vertices\": 'V 0' is not a number"
    assert bad({"generators": [{"vertex": "V 0"}]}) == '"generators": "vertex" must be a whole number from 0'
    assert bad({"count": 3, "gradation": 0.5}) == '"gradation" needs "density": "curvature": add it, or leave "gradation" out'
    release(ball)


def check_vertices_of_meshes():
    """Two triangles that meet in one vertex, which becomes two: the second has no number of the input's."""
    at = array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (9, 9, 9)])
    mesh = result("mesh", None, {"on_defect": "repair"}, at, array([(0, 1, 2), (0, 3, 4)], ctypes.c_int32))
    positions = numbers(mesh, "vertex_positions")
    for options in ({"points": {"mesh_vertices": 0}}, {"points": [{"mesh_vertices": 1}, {"mesh_vertices": 2}, {"array": 3}]}):
        made = result("sample", mesh, options, array(list(range(6))), array([0, 1, 2]), array([3, 4], ctypes.c_uint8), array([positions[5]]))
        corners = [numbers(mesh, "face_vertices")[f][b.index(1)] for f, b in zip(numbers(made, "points_faces"), numbers(made, "points_bary"))]
        assert [positions[v] for v in corners] == positions, corners
        release(made)
    made = result("segment", mesh, {"vertices": {"mesh_vertices": 0}}, array([1, 3]))
    assert figures(result("segment", mesh, figures(made)["options"], array([1, 3])))["options"] == figures(made)["options"]
    assert refused("segment", mesh, {"vertices": {"mesh_vertices": 0}}, array([1, 6]), status=PRECONDITION) == \
        '"vertices": there is no vertex 6; the mesh has 6, numbered from 0'
    assert gvd.gvd_last_error_element() == 1
    release(mesh, made)


def check_doors():
    """Errors and notes write options as the door of a run does."""
    ball = make_ball()
    told = {}
    for door in range(3):
        run = Run(0, PROGRESS(), None, None, NOTE(), None, door)
        told[door] = call("lloyd", ball, {"vertices": [0, 0]}, run=run)[1].rsplit(" ", 1)[1], call("remesh", ball, {"count": 3}, run=run)[1]
    assert [told[door][0] for door in range(3)] == ['"merge_coincident"', "merge_coincident", "merge_coincident"], told
    described = [json.loads(gvd.gvd_describe_for(door)) for door in range(3)]
    help_of = lambda d: next(o["help"] for one in d["operations"] if one["name"] == "lloyd" for o in one["options"] if o["name"] == "sampling")
    assert [help_of(d)[:18] for d in described] == ['How "count" places', "How count places g", "How count places g"]
    assert gvd.gvd_describe_for(3) == b"null"
    release(ball)


def check_files_of_parts(folder):
    """Pages, parts with files of their own, and options of files."""
    mesh = read("torus.ply")
    relaxed, paths = result("lloyd", mesh, {"count": 9}), result("distances", mesh, {"from": [0], "to": [9, 300], "paths": True})
    coarse = result("remesh", mesh, {"count": 90})
    mapped, segments = result("map", coarse, {}), result("segment", mesh, {"count": 9})

    def write(thing, name, options):
        status = gvd.gvd_write_as(thing, str(folder / name).encode(), json.dumps(options).encode(), None)
        return gvd.gvd_last_error().decode() if status else (folder / name).read_bytes()

    assert write(relaxed, "p.npy", {"part": "points"}).startswith(b"\x93NUMPY")
    assert write(mapped, "m.json", {"part": "map"}).startswith(b"{")
    assert write(paths, "one.csv", {"part": "path 1"}).count(b"\n") < write(paths, "all.csv", {}).count(b"\n")
    assert b"ascii" in write(segments, "a.ply", {"ascii_ply": True})[:40]
    # What does nothing in a format is refused, as the commands refuse it.
    def lost(made, name, options=None):
        path = str(folder / name).encode()
        assert gvd.gvd_write_as(made, path, json.dumps(options or {}).encode(), None) == INVALID and not (folder / name).exists(), name
        return gvd.gvd_last_error().decode()
    assert lost(segments, "c.off", {"no_curves": True}) == (
        '"no_curves": only .obj, .vtp, .vtu and .glb hold curves; write one or leave "no_curves" out')
    assert lost(segments, "c.ply", {"region_materials": True}) == (
        '"region_materials": only .obj holds materials; write one or leave "region_materials" out')
    for name in ("c.obj", "c.json", "c.html"):
        assert lost(segments, name, {"ascii_ply": True}) == '"ascii_ply": no .ply is written; write one or leave "ascii_ply" out', name
    charts, carried = result("segment", mesh, {"count": 9, "uv": "logmap"}), result("remesh", mesh, {"count": 90, "carry": True})
    for name in ("c.off", "c.json", "c.vtp"):
        assert lost(charts, name) == '"uv": only .ply, .obj and .glb hold texture coordinates; write one or leave "uv" out', name
    for name in ("c.off", "c.json"):
        assert lost(carried, name) == '"carry": only .ply, .obj and .glb hold what is carried over; write one or leave "carry" out', name
    for name in ("c.ply", "c.obj", "c.glb"):
        assert all(isinstance(write(made, name, {}), bytes) for made in (charts, carried)), name
    release(charts, carried)
    assert write(segments, "b.obj", {"no_curves": True}).count(b"\nl ") == 0 < write(segments, "c.obj", {}).count(b"\nl ")
    assert write(relaxed, "p.doc", {"part": "points"}).endswith("the extension must be one of .npy, .ply or .xyz")
    assert write(coarse, "m.json", {"part": "map"}) == "\"part\": a remesh has no part 'map'"
    assert write(paths, "one.csv", {"part": "path 2"}) == "\"part\": a distances has no part 'path 2'"
    assert write(mesh, "a.ply", {"asci_ply": True}) == 'there is no option "asci_ply"; did you mean "ascii_ply"?'
    release(mesh, relaxed, paths, coarse, mapped, segments)


def check_clock():
    """Without `due`, reports come as they are; with it, one for each time that it is set."""
    mesh, calls = read("figure.obj"), []
    due = ctypes.c_int32(1)
    run = Run(1, PROGRESS(lambda *_: calls.append(1) or 1), None, None, NOTE(), ctypes.pointer(due))
    release(result("diagram", mesh, {"count": 20}, run=run))
    assert len(calls) == 1 and due.value == 0, calls
    run.due = None
    release(result("diagram", mesh, {"count": 20}, run=run))
    assert len(calls) > 2
    release(mesh)


def check_runs():
    """Notes as they happen; a function and a flag that cancel."""
    mesh, notes, steps = read("figure.obj"), [], set()
    run = Run(1, PROGRESS(lambda data, step, done: steps.add(step.decode()) is None), None, None,
              NOTE(lambda data, text: notes.append(text.decode())))
    made = result("lloyd", mesh, {"count": 10}, run=run)
    assert notes == figures(made)["notes"] and notes and steps, notes
    release(made)
    status, message = call("lloyd", mesh, {"count": 10}, run=Run(0, PROGRESS(lambda *_: 0), None, None, NOTE()))
    assert status == INTERRUPTED, message
    flag = ctypes.c_int32(0)
    found = []
    work = threading.Thread(target=lambda: found.append(call(
        "lloyd", mesh, {"count": 2000, "accelerate": "none", "iterations": 1000000, "tolerance": 0, "move_tolerance": 0},
        run=Run(1, PROGRESS(), None, ctypes.pointer(flag), NOTE()))))
    work.start()
    time.sleep(0.3)
    flag.value = 1
    work.join(60)
    assert found and found[0][0] == INTERRUPTED, found
    assert call("lloyd", mesh, {"count": 3}, run=Run(-1, PROGRESS(), None, None, NOTE()))[0] == INVALID
    release(mesh)


def check_what_all_have():
    """What one operation has, the others have, too; what can't be says why."""
    mesh = read("torus.ply")
    faces = len(numbers(mesh, "face_vertices"))
    halves = array([int(face >= faces // 2) for face in range(faces)], ctypes.c_uint8)
    vertices = len(numbers(mesh, "vertex_positions"))
    for operation, options in (
            ("segment", {"count": 6, "balance": [1 + v % 3 for v in range(vertices)], "shares": [1, 2, 3, 4, 5, 6]}),
            ("segment", {"count": 3, "weights": [0, 0.01, 0.02]}), ("segment", {"within": {"array": 0}, "per_region": 3}),
            ("segment", {"count": 6, "mask": {"array": 0}, "balance": "area"}), ("segment", {"levels": [2, 8], "cut": True}),
            ("segment", {"count": 2, "disc": True}), ("segment", {"count": 8, "disc": True, "uv": "flat"}),
            ("diagram", {"count": 6, "within": {"array": 0}}), ("diagram", {"count": 6, "mask": {"array": 0}, "balance": "area"}),
            ("lloyd", {"count": 6, "balance": "area", "iterations": 5}), ("lloyd", {"count": 6, "within": {"array": 0}}),
            ("lloyd", {"count": 6, "mask": {"array": 0}, "balance": "area", "iterations": 5}),
            ("distances", {"from": [3], "within": {"array": 0}, "to": [9], "paths": True, "isolines": 0.2}),
            ("distances", {"curves": {"points": [3, 40], "offsets": [0, 2]}, "to": [9], "paths": True, "isolines": 0.2}),
            ("remesh", {"error": "5%"})):
        made = result(operation, mesh, options, halves)
        found = figures(made)
        kept = "within" in options or "mask" in options
        assert not kept or found["within"]["regions"] >= 1, (operation, options)
        release(made)
    diagram = result("diagram", mesh, {"count": 2})
    labels = result("label", diagram, {"disc": True, "uv": "flat"})
    assert figures(labels)["disc"]["rounds"] >= 0 and figures(labels)["charts"]["flipped_share"] == 0
    release(diagram, labels)
    half = read("half_sphere.off")
    for operation, options, why in (
            ("segment", {"balance": "area"}, "bisectors with weights are computed between points alone"),
            ("diagram", {"weights": [0]}, "bisectors with weights are computed between points alone"),
            ("segment", {"within": [0] * len(numbers(half, "face_vertices"))}, "a curve may leave its region"),
            ("segment", {"disc": True}, "the cell of a closed curve is not a disc, however many generators are added"),
            ("segment", {"uv": "flat"}, "charts need points as generators")):
        assert refused(operation, half, {"curves": "boundary", **options}).endswith(f"exclude each other: {why}; keep one")
    release(mesh, half)


class Point(ctypes.Structure):
    _fields_ = [("face", ctypes.c_int32), ("bary", ctypes.c_double * 3)]


def check_typed():
    """The functions for people give what operations give, and refuse in the same words."""
    mesh, count = read("figure.obj"), 30
    rows = lambda points: [(p.face, *p.bary) for p in points]
    called = lambda thing, name: [(f, *b) for f, b in zip(numbers(thing, name + "_faces"), numbers(thing, name + "_bary"))]
    points = (Point * count)()
    for kind, name in enumerate(("farthest", "random", "poisson", "vertices")):
        assert gvd.gvd_sample(mesh, count, kind, ctypes.c_uint64(2**63 + 5), None, points) == OK
        made = result("sample", mesh, {"count": count, "sampling": name, "seed": str(2**63 + 5)})
        assert rows(points) == called(made, "points")
        release(made)
    given = array(rows(points))
    diagram = handle("gvd_diagram_compute", mesh, points, count, 0, None)
    made = result("diagram", mesh, {"generators": {"array": 0}}, given)
    assert diagram_parts(diagram) == diagram_parts(made)
    labels = (ctypes.c_int32 * len(numbers(mesh, "face_vertices")))()
    assert gvd.gvd_segment(diagram, 0, None, labels) == OK
    labelled = result("label", diagram, {"labels": "nearest"})
    assert list(labels) == numbers(labelled, "face_labels")
    release(diagram, made, labelled)
    path = handle("gvd_path_compute", mesh, ctypes.byref(points[3]), ctypes.byref(points[9]), None)
    on_path = (Point * gvd.gvd_path_point_count(path))()
    gvd.gvd_path_points(path, on_path)
    gvd.gvd_path_free(path)
    made = result("distances", mesh, {"from": {"array": 0}, "to": {"array": 1}, "paths": True}, array(rows(points)[9:10]),
                  array(rows(points)[3:4]))
    assert rows(on_path) == called(made, "path") and on_path[0].face == points[3].face
    release(made)
    relaxed, energy = (Point * count)(), ctypes.c_double()
    assert gvd.gvd_lloyd(mesh, points, count, None, None, relaxed, ctypes.byref(energy)) == OK
    made = result("lloyd", mesh, {"generators": {"array": 0}}, given)
    assert rows(relaxed) == called(made, "generators") and energy.value == figures(made)["final_energy"]
    release(made)
    coarse = handle("gvd_remesh", mesh, None, 90, None, None)
    made = result("remesh", mesh, {"count": 90})
    part = handle("gvd_object_of", made, b"mesh")
    assert numbers(coarse, "vertex_positions") == numbers(part, "vertex_positions")
    generators = (Point * len(numbers(coarse, "vertex_positions")))()
    assert gvd.gvd_mesh_generators(coarse, generators) == OK and rows(generators) == called(made, "generators")
    release(coarse, made, part)
    assert gvd.gvd_sample(mesh, 0, 0, ctypes.c_uint64(0), None, points) == INVALID
    assert gvd.gvd_last_error().startswith(b"\"count\": '0' is not a whole number from 1")
    release(mesh)


with tempfile.TemporaryDirectory() as scratch:
    check_meshes(pathlib.Path(scratch))
    check_words()
    check_vertices_of_meshes()
    check_doors()
    check_files_of_parts(pathlib.Path(scratch))
    check_clock()
    check_runs()
    check_what_all_have()
    check_typed()
print("all checks passed")
