#!/usr/bin/env python3
"""Operations of the C interface through ctypes: every described option well and badly, mistakes in JSON and arrays, the
same bytes as the commands, notes, and a flag that cancels.

    check_calls.py LIBRARY BIN_FOLDER DATA_FOLDER
"""
import ctypes
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

LIBRARY, BIN, DATA = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
ABI, OK, INVALID, PRECONDITION, INTERRUPTED = 1, 0, 2, 4, 130
TYPES = [ctypes.c_int8, ctypes.c_uint8, ctypes.c_int16, ctypes.c_uint16, ctypes.c_int32, ctypes.c_uint32, ctypes.c_int64,
         ctypes.c_uint64, ctypes.c_float, ctypes.c_double]

gvd = ctypes.CDLL(LIBRARY)
for function in ("gvd_last_error", "gvd_figures", "gvd_describe"):
    getattr(gvd, function).restype = ctypes.c_char_p


class Array(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("type", ctypes.c_int32), ("dimensions", ctypes.c_int32),
                ("shape", ctypes.c_int64 * 2), ("strides", ctypes.c_int64 * 2)]


PROGRESS = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double)
NOTE = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p)


class Run(ctypes.Structure):
    _fields_ = [("threads", ctypes.c_int), ("progress", PROGRESS), ("data", ctypes.c_void_p),
                ("cancel", ctypes.POINTER(ctypes.c_int32)), ("note", NOTE)]


def array(rows, kind=ctypes.c_double):
    """An Array of numbers, or of rows of numbers."""
    wide = bool(rows) and isinstance(rows[0], (tuple, list))
    columns = len(rows[0]) if wide else 1
    flat = [number for row in rows for number in row] if wide else list(rows)
    data = (kind * max(1, len(flat)))(*flat)
    size = ctypes.sizeof(kind)
    made = Array(ctypes.cast(data, ctypes.c_void_p), TYPES.index(kind), 2 if wide else 1, (len(rows), columns),
                 (size * columns, size))
    made.keep = data
    return made


def handle(function, *arguments):
    made = ctypes.c_void_p()
    status = getattr(gvd, function)(*arguments, ctypes.byref(made))
    assert status == OK, f"{function}: {status}: {gvd.gvd_last_error().decode()}"
    return made


def call(operation, on, options, *arrays, run=None, abi=ABI):
    """The status and the result, or the message."""
    text = options if isinstance(options, (bytes, type(None))) else json.dumps(options).encode()
    made = ctypes.c_void_p()
    status = gvd.gvd_call(abi, operation.encode(), on, text, (Array * len(arrays))(*arrays) if arrays else None, len(arrays),
                          ctypes.byref(run) if run else None, ctypes.byref(made))
    if status != OK:
        assert not made, "a result beside an error"
        message = gvd.gvd_last_error().decode()
        assert message and "\n" not in message and "{option" not in message, message
        return status, message
    return status, made


def result(operation, on, options, *arrays, run=None):
    status, made = call(operation, on, options, *arrays, run=run)
    assert status == OK, made
    return made


def refused(operation, on, options, *arrays, status=INVALID):
    found, message = call(operation, on, options, *arrays)
    assert found == status, (options, found, message)
    return message


def numbers(thing, name):
    """The rows of an array of an object."""
    view = Array()
    assert gvd.gvd_array_of(thing, name.encode(), ctypes.byref(view)) == OK, gvd.gvd_last_error()
    kind = TYPES[view.type]
    at = lambda i, j: kind.from_address(view.data + i * view.strides[0] + j * view.strides[1]).value
    rows = [tuple(at(i, j) for j in range(view.shape[1])) for i in range(view.shape[0])]
    return rows if view.dimensions == 2 else [row[0] for row in rows]


def figures(thing):
    return json.loads(gvd.gvd_figures(thing))


def release(*things):
    for thing in things:
        gvd.gvd_release(thing)


def read(name):
    return handle("gvd_mesh_read", str(DATA / name).encode(), 1)


def make_ball():
    """An octahedron: 6 vertices, 8 faces."""
    corners = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    vertices = (ctypes.c_double * 18)(*[x for corner in corners for x in corner])
    triangles = (ctypes.c_int32 * 24)(*[v for face in faces for v in face])
    return handle("gvd_mesh_create", vertices, ctypes.c_int64(6), triangles, ctypes.c_int64(8), 1)


DESCRIBED = json.loads(gvd.gvd_describe())


def good_value(option):
    """A value that the option takes."""
    kind, name = option["kind"], option["name"]
    if name in ("to", "add", "move"):
        return 3 if kind == "whole number" else [5]
    if "choices" in option and kind != "values":
        return [option["choices"][0]] if kind == "choices" else option["choices"][0]
    if kind == "number":
        return 0.5 if option.get("most", 2) < 1 else 1
    if kind == "whole number":
        return 50 if option.get("least", 1) > 1 else 3
    if kind == "values":
        per = 3 if option["of"] == "generators" else 8
        return [1] + [0] * 7 if name == "mask" else [1] * per
    return {"flag": True, "switch": "on", "vertices": [0, 1, 2], "points": [0, 1], "curves": "creases", "counts": [2, 3], "bound": "50%", "crease angle": 30, "bytes": "1G"}[kind]


def subject(operation, ball):
    """What an operation works on."""
    return result("diagram", ball, {"count": 4}) if operation["on"] == "diagram" else ball


def check_described_options():
    """Each option alone beside what it needs: taken, or refused for another reason than its value; and a wrong value."""
    ball = make_ball()
    for operation in DESCRIBED["operations"]:
        options = {option["name"]: option for option in operation["options"]}
        on = subject(operation, ball)
        for name, option in options.items():
            given = {need: good_value(options[need]) for need in option["needs"]}
            given[name] = good_value(option)
            sources = ("count", "vertices", "generators", "from", "add", "move", "remove")
            if not any(n in given for n in sources):
                fitting = [s for s in sources if s in options and s not in option["excludes"]]
                if fitting:
                    given[fitting[0]] = good_value(options[fitting[0]])
            status, made = call(operation["name"], on, given)
            if status == OK:
                assert name in figures(made)["options"], name
                release(made)
            else:
                assert not made.startswith(f'"{name}": ') and "no option" not in made, (operation["name"], given, made)
            for wrong in ({"a": 1}, [[]]):
                message = refused(operation["name"], on, {name: wrong})
                assert message.startswith(f'"{name}": '), (name, wrong, message)
    release(ball)


def check_described_results():
    """What the description says of results is what they have."""
    ball = make_ball()
    for operation in DESCRIBED["operations"]:
        options = {"distances": {"from": [0]}, "segment": {"count": 4, "cut": True}, "label": {"cut": True}, "edit": {"remove": 0}}.get(operation["name"], {"count": 4})
        made = result(operation["name"], subject(operation, ball), options)
        described = operation["result"]
        for one in described["arrays"]:
            view = Array()
            assert gvd.gvd_array_of(made, one["name"].encode(), ctypes.byref(view)) == OK, one
            assert TYPES[view.type] is getattr(ctypes, "c_" + {"float64": "double", "float32": "float"}.get(
                one["type"], one["type"])), one
            assert view.dimensions == 1 or one["columns"] in (None, view.shape[1]), one
        found = figures(made)
        for one in described["figures"]:
            at = found
            for level in one["name"].split("."):
                assert at is None or level in at, one
                at = at and at[level]
        for one in described["parts"]:
            release(handle("gvd_object_of", made, one["name"].encode()))
        release(made)
    release(ball)


def check_mistakes():
    ball = make_ball()
    bad = lambda options, *arrays, **more: refused("lloyd", ball, options, *arrays, **more)
    assert bad(b"{") == "options: not valid JSON at line 1, column 2"
    assert bad(b'{"count": 3,\n "seed" 4}') == "options: not valid JSON at line 2, column 9"
    assert bad(b"[]").startswith("options: the JSON is no object; write one")
    assert bad(b'{"count": 3, "count": 4}') == '"count" is given twice; keep one'
    assert bad(b'{"radius": 1e309}') == "options: the JSON has a number that is too large for a double"
    assert bad(b'\xff{"count": 3}').startswith("options: not valid JSON at line 1")
    assert bad({"cuont": 3}) == 'there is no option "cuont"; did you mean "count"?'
    assert bad({"count": 0}) == "\"count\": '0' is not a whole number from 1 to 2147483647"
    assert bad({"count": 2.5}).startswith("\"count\": '2.5' is not a whole number")
    assert bad({"count": True}).startswith("\"count\": 'true' is not a whole number")
    assert bad({"count": 3, "radius": 1}) == '"count" and "radius" exclude each other: keep one'
    assert bad({}) == 'no generators: give one of "count", "generators", "vertices" or "radius"'
    assert bad(None).startswith("no generators")
    assert bad({"count": None}).startswith("no generators")
    assert bad({"count": 3, "keep_boundary": 1}) == "\"keep_boundary\": '1' is neither true nor false"
    assert bad({"count": 3, "accelerate": "lbgfs"}).endswith("did you mean lbfgs?")
    assert bad({"count": 3, "step": "nan"}).startswith("\"step\": 'nan' is not a number")
    assert bad({"generators": {"array": 0}}) == '"generators": there is no array 0; 0 arrays are given'
    assert bad({"generators": {"array": -1}}, array([1.0])).startswith('"generators": there is no array -1; 1 array is given')
    assert bad({"generators": {"array": 0}}, array([(1.0, 2.0)])).startswith('"generators": points have 2 columns')
    assert bad({"generators": {"array": 0}}, array([])) == '"generators": there is no point'
    assert bad({"generators": {"array": 0}}, array([0.5])) == '"generators": element 0 is 0.5; give whole numbers from 0 on'
    assert bad({"generators": {"array": 0}}, Array(None, 9, 1, (3, 1), (8, 0))) == '"generators": array 0 is NULL'
    assert bad({"generators": {"array": 0}}, Array(None, 77, 1, (0, 1), (8, 0))).startswith('"generators": array 0 has no known type')
    assert bad({"generators": {"array": 0}}, Array(None, 9, 3, (0, 1), (8, 0))).startswith('"generators": array 0 has 3 dimensions')
    assert bad({"generators": {"array": 0}}, Array(None, 9, 1, (-1, 1), (8, 0))) == '"generators": array 0 has a negative length'
    assert bad({"vertices": [99]}, status=PRECONDITION).startswith('"vertices"')
    assert bad({"vertices": [-1]}) == '"vertices": element 0 is -1; give whole numbers from 0 on'
    assert bad({"vertices": [0, 0]}, status=PRECONDITION).endswith('"merge_coincident"')
    assert bad({"count": 3, "density": [1, 2, 3]}) == '"density": 3 numbers; give one for each vertex (6) or face (8)'
    assert bad({"count": 3, "density": "heat"}).startswith('"density": \'heat\' is not one of curvature')
    assert bad({"count": 3, "density": [1, 1, 1, 1, 1, -2]}, status=PRECONDITION).startswith('"density": the density of vertex 5 is -2')
    assert refused("loyd", ball, {}) == "there is no operation 'loyd'; did you mean 'lloyd'?"
    assert refused("lloyd", None, {"count": 3}) == "the object is NULL"
    assert call("lloyd", ball, {"count": 3}, abi=99) == (INVALID, "this program was compiled for interface 99, and the library "
                                                        "has 1: compile it with the library's gvd.h")
    assert gvd.gvd_call(ABI, None, ball, b"{}", None, 0, None, ctypes.byref(ctypes.c_void_p())) == INVALID
    assert gvd.gvd_call(ABI, b"lloyd", ball, b'{"count": 3}', None, 0, None, None) == INVALID
    assert gvd.gvd_last_error() == b"result is NULL"
    assert gvd.gvd_call(ABI, b"lloyd", ball, b"{}", None, 1, None, ctypes.byref(ctypes.c_void_p())) == INVALID
    assert gvd.gvd_last_error() == b"arrays is NULL"
    assert gvd.gvd_call(ABI, b"lloyd", ball, b"{}", None, -1, None, ctypes.byref(ctypes.c_void_p())) == INVALID
    relaxed = result("lloyd", ball, {"count": 3})
    assert gvd.gvd_array_of(relaxed, b"energie", ctypes.byref(Array())) == INVALID
    assert gvd.gvd_last_error() == b"there is no array 'energie'; did you mean 'energies'?"
    assert gvd.gvd_object_of(relaxed, b"mesh", ctypes.byref(ctypes.c_void_p())) == INVALID
    assert refused("lloyd", relaxed, {"count": 3}) == "this takes a mesh, and the object is a lloyd"
    release(relaxed, ball, None)


def check_values():
    """Numbers may be strings; points and numbers may be arrays of any type, or lists; null is as if nothing were there."""
    ball = make_ball()
    listed = [
        ({"generators": [0, 2]},), ({"vertices": [0, 2]},), ({"vertices": {"array": 0}}, array([0, 2], ctypes.c_int64)),
        ({"generators": {"array": 0}}, array([0, 2], ctypes.c_uint8)),
        ({"generators": {"array": 0}}, array([(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])),
        ({"generators": {"array": 0}}, array([(0, 1, 0, 0), (0, 0, 1, 0)], ctypes.c_float)),
        ({"generators": [{"vertex": 0}, {"position": [0, 1, 0]}]},),
    ]
    found = []
    for options, *arrays in listed:
        made = result("lloyd", ball, {"iterations": "3", "density": None, **options}, *arrays)
        found.append((numbers(made, "generators_faces"), numbers(made, "generators_bary"), figures(made)["final_energy"]))
        release(made)
    assert all(one == found[0] for one in found), found
    made = result("lloyd", ball, {"vertices": [0, 2], "density": [1] * 8, "iterations": 0})
    assert figures(made)["options"]["vertices"] == [0, 2] and figures(made)["options"]["density"] == {"numbers": 8}
    release(made)
    # Strides of any length: every other number, from behind.
    wide = array([2, 7, 0], ctypes.c_int32)
    back = Array(wide.data + 8, wide.type, 1, (2, 1), (-8, 0))
    made = result("lloyd", ball, {"vertices": {"array": 0}, "iterations": 0}, back)
    assert numbers(made, "generators_bary") == [(1, 0, 0), (0, 1, 0)] or len(numbers(made, "generators_bary")) == 2
    release(made)
    # A density of faces, of vertices, and of the file's vertices.
    for count in (8, 6):
        release(result("lloyd", ball, {"count": 3, "density": {"array": 0}}, array([2.0] * count)))
    release(ball)


def check_parts():
    """A part keeps alive what it is a part of."""
    ball = make_ball()
    relaxed = result("lloyd", ball, {"count": 4, "balance": "area"})
    diagram = handle("gvd_object_of", relaxed, b"diagram")
    areas = numbers(relaxed, "areas")
    report = figures(relaxed)
    release(ball, relaxed)
    cells = numbers(diagram, "cell_areas")
    assert len(cells) == 4 and all(map(math.isclose, cells, areas)) and math.isclose(sum(areas), 4 * math.sqrt(3))
    offsets, points = numbers(diagram, "bisector_offsets"), numbers(diagram, "bisector_bary")
    assert offsets[0] == 0 and offsets[-1] == len(points) and len(offsets) == figures(diagram)["bisectors"] + 1
    assert report["balance"]["converged"] is True and len(report["weights"]) == 4
    assert report["options"]["balance"] == "area" and report["options"]["iterations"] == 300
    assert any("areas of the cells" in note for note in report["notes"]), report["notes"]
    release(diagram)


def check_distances():
    """Rows, paths, isolines and logarithms of one operation."""
    ball = make_ball()
    made = result("distances", ball, {"from": [0], "to": [1], "paths": True, "isolines": 0.5, "logarithm": True})
    assert len(numbers(made, "rows")) == 1 and math.isclose(numbers(made, "rows")[0][0], math.sqrt(6))
    offsets = numbers(made, "path_offsets")
    assert offsets[0] == 0 and offsets[1] == len(numbers(made, "path_faces")) > 1
    assert len(numbers(made, "isoline_levels")) == len(numbers(made, "isoline_offsets")) - 1 > 0
    for distance, (x, y) in zip(numbers(made, "vertex_distances"), numbers(made, "logarithms")):
        assert math.isclose(distance, math.hypot(x, y), abs_tol=1e-12)
    release(made)
    made = result("distances", ball, {"from": [0, 1], "each": True})
    rows = numbers(made, "rows")
    assert len(rows) == 2 and rows[0][1] == rows[1][0] and rows[0][0] == 0
    assert refused("distances", ball, {"from": [0, 1], "logarithm": True}).startswith('"logarithm" is that at one source')
    assert refused("distances", ball, {"from": [0], "paths": True}).startswith('"paths" does nothing here: add "to"')
    assert "neither true nor false" in refused("distances", ball, {"curves": {"points": [0, 2], "closed": 1}})
    release(made, ball)


def diagram_parts(diagram):
    """All arrays and figures of a diagram."""
    described = DESCRIBED["objects"]["diagram"]
    return ({one["name"]: numbers(diagram, one["name"]) for one in described["arrays"]},
            {one["name"]: figures(diagram)[one["name"]] for one in described["figures"]})


def check_edits():
    """Edits give new diagrams with the bits of those that are computed at once; earlier ones stay. Handles in any order."""
    mesh = read("figure.obj")
    first = result("diagram", mesh, {"count": 50, "editable": True})
    before = diagram_parts(first)
    points = list(zip(numbers(first, "generators_faces"), *zip(*numbers(first, "generators_bary"))))

    def check(edited, expected):
        made = result("diagram", mesh, {"generators": {"array": 0}}, array(expected))
        assert diagram_parts(edited) == diagram_parts(made)
        assert list(zip(numbers(edited, "generators_faces"), *zip(*numbers(edited, "generators_bary")))) == expected
        release(made)

    moved = result("edit", first, {"move": 7, "to": {"array": 0}}, array([(100, 0.25, 0.25, 0.5)]))
    points[7] = (100, 0.25, 0.25, 0.5)
    check(moved, points)
    assert 0 < figures(moved)["propagated"] < 50 and figures(moved)["options"]["move"] == 7
    assert diagram_parts(first) == before
    release(first)
    added = result("edit", moved, {"add": [{"face": 9, "bary": [0.5, 0.25, 0.25]}]})
    release(moved)
    check(added, points + [(9, 0.5, 0.25, 0.25)])
    removed = result("edit", added, {"remove": 3})  # the last generator gets its number
    check(removed, points[:3] + [(9, 0.5, 0.25, 0.25)] + points[4:])
    again = result("edit", added, {"remove": 50})  # of a diagram whose editor went on
    check(again, points)
    release(added)
    assert refused("edit", removed, {"move": 50, "to": [0]}, status=PRECONDITION) == \
        "there is no generator 50 among 50 generators"
    assert refused("edit", removed, {"move": -1, "to": [0]}).startswith("\"move\": '-1' is not a whole number from 0")
    assert refused("edit", removed, {"move": 1, "to": [0, 1]}) == 'one point is needed in "to", and there are 2 points'
    assert refused("edit", removed, {}) == 'no change: give one of "move", "add" or "remove"'
    assert refused("edit", removed, {"remove": 1, "to": [0]}) == '"to" needs "move": add it, or leave "to" out'
    assert refused("edit", removed, {"add": [{"position": [0, 0, 99]}], "max_snap": 0.5}, status=PRECONDITION)
    assert refused("edit", mesh, {"remove": 0}) == "this takes a diagram, and the object is a mesh"
    status, message = call("edit", removed, {"remove": 0}, run=Run(0, PROGRESS(lambda *_: 0), None, None, NOTE()))
    assert status == INTERRUPTED, message
    edited = result("edit", removed, {"move": 3, "to": [8]})
    release(removed, mesh)
    labels = result("label", edited, {})
    release(edited)
    assert set(numbers(labels, "face_labels")) == set(range(50))
    release(labels, again)
    mesh = read("figure.obj")
    for options, message in (({"method": "gbgvd"}, "only diagrams of the exact method can be edited"),
                             ({"weights": [0, 0.01, 0]}, "a diagram with weights can't be edited")):
        diagram = result("diagram", mesh, {"vertices": [0, 900, 1800], **options})
        assert refused("edit", diagram, {"remove": 0}) == message
        release(diagram)
    release(mesh)


def check_what_all_have():
    """What one operation has, the others have, too; what can't be says why."""
    mesh = read("figure.obj")
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
            ("segment", {"disc": True}, "the cell of a closed curve is no disc, however many generators are added"),
            ("segment", {"uv": "flat"}, "charts are laid around points")):
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


def check_files(folder):
    """Files of results are those of the commands."""
    for operation, options, words, extensions in (
            ("segment", {"count": 12, "cut": True}, "-n 12 --cut", "ply json vtp"),
            ("segment", {"levels": [3, 9]}, "--levels 3,9", "ply json"),
            ("lloyd", {"count": 9, "balance": "area"}, "-n 9 --balance area", "txt csv json ply"),
            ("remesh", {"count": 90}, "-n 90", "ply json"),
            ("distances", {"from": [3]}, "--from 3", "npy csv ply"),
            ("distances", {"from": [3], "isolines": 0.3}, "--from 3 --isolines 0.3", "json vtp")):
        mesh = read("figure.obj")
        made = result(operation, mesh, options)
        command = "gvd-distance" if operation == "distances" else f"gvd-{operation}"
        for extension in extensions.split():
            mine, theirs = folder / f"mine.{extension}", folder / f"theirs.{extension}"
            assert gvd.gvd_write(made, str(mine).encode(), None) == OK, gvd.gvd_last_error()
            subprocess.run([str(BIN / command), str(DATA / "figure.obj"), *words.split(), "-o", str(theirs)], check=True,
                           stderr=subprocess.DEVNULL)
            assert mine.read_bytes() == theirs.read_bytes(), (operation, extension)
        release(made, mesh)
    ball = make_ball()
    sampled = result("sample", ball, {"count": 2})
    assert gvd.gvd_write(sampled, str(folder / "a.ply").encode(), None) == INVALID
    assert b"a sample has no file" in gvd.gvd_last_error(), gvd.gvd_last_error()
    assert gvd.gvd_write(ball, str(folder / "a.doc").encode(), None) == INVALID
    assert b"the extension must be one of .ply" in gvd.gvd_last_error(), gvd.gvd_last_error()
    assert gvd.gvd_write(None, b"a.ply", None) == INVALID and gvd.gvd_last_error() == b"object is NULL"
    assert gvd.gvd_mesh_vertex_count(sampled) == 0 and gvd.gvd_diagram_bisector_count(None) == 0
    # The labels of a diagram are those of a segmentation at once.
    diagram = result("diagram", ball, {"count": 3})
    labels, whole = result("label", diagram, {}), result("segment", ball, {"count": 3})
    assert numbers(labels, "face_labels") == numbers(whole, "face_labels")
    assert refused("label", ball, {}) == "this takes a diagram, and the object is a mesh"
    release(sampled, labels, whole, diagram, ball)


def check_same_as_commands(folder):
    """The points of gvd-lloyd, for options of many kinds."""
    for name, options, words in (
            ("figure.obj", {"count": 25}, ["-n", "25"]),
            ("plate.stl", {"count": 25, "features": 40, "seed": 3}, ["-n", "25", "--features", "40", "--seed", "3"]),
            ("half_sphere.off", {"radius": 0.4, "keep_boundary": True, "density": "curvature"},
             ["--radius", "0.4", "--keep-boundary", "--density", "curvature"])):
        mesh = read(name)
        made = result("lloyd", mesh, options)
        subprocess.run([str(BIN / "gvd-lloyd"), str(DATA / name), *words, "-o", str(folder / "theirs.txt"), "--report",
                        str(folder / "report.json")], check=True, stderr=subprocess.DEVNULL)
        rows = [line.split() for line in (folder / "theirs.txt").read_text().splitlines() if line[0] != "#"]
        theirs = [(int(face), *map(float, bary)) for face, *bary in rows]
        mine = [(face, *bary) for face, bary in zip(numbers(made, "generators_faces"), numbers(made, "generators_bary"))]
        assert mine == theirs, name
        reported, mine = json.loads((folder / "report.json").read_text())["results"], figures(made)
        assert all(mine[key] == value for key, value in reported.items()), name
        release(made, mesh)


with tempfile.TemporaryDirectory() as scratch:
    check_mistakes()
    check_values()
    check_parts()
    check_distances()
    check_edits()
    check_what_all_have()
    check_typed()
    check_runs()
    check_described_options()
    check_described_results()
    check_files(pathlib.Path(scratch))
    check_same_as_commands(pathlib.Path(scratch))
print("all checks passed")
