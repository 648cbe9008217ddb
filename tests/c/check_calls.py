#!/usr/bin/env python3
"""Operations of the C interface through ctypes: every described option well and badly, mistakes in JSON and arrays, the
same bytes as the commands.

    check_calls.py LIBRARY BIN_FOLDER DATA_FOLDER
"""
import ctypes
import json
import math
import pathlib
import subprocess
import sys
import tempfile

LIBRARY, BIN, DATA = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
ABI, OK, INVALID, PRECONDITION, INTERRUPTED = 1, 0, 2, 4, 130
TYPES = [ctypes.c_int8, ctypes.c_uint8, ctypes.c_int16, ctypes.c_uint16, ctypes.c_int32, ctypes.c_uint32, ctypes.c_int64,
         ctypes.c_uint64, ctypes.c_float, ctypes.c_double]

gvd = ctypes.CDLL(LIBRARY)
for function in ("gvd_last_error", "gvd_last_error_code", "gvd_figures", "gvd_describe", "gvd_describe_for"):
    getattr(gvd, function).restype = ctypes.c_char_p
gvd.gvd_last_error_element.restype = ctypes.c_int64


class Array(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("type", ctypes.c_int32), ("dimensions", ctypes.c_int32),
                ("shape", ctypes.c_int64 * 2), ("strides", ctypes.c_int64 * 2)]


PROGRESS = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double)
NOTE = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p)


class Run(ctypes.Structure):
    _fields_ = [("threads", ctypes.c_int), ("progress", PROGRESS), ("data", ctypes.c_void_p),
                ("cancel", ctypes.POINTER(ctypes.c_int32)), ("note", NOTE), ("due", ctypes.POINTER(ctypes.c_int32)),
                ("door", ctypes.c_int32), ("iteration", ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int32, ctypes.c_double, ctypes.c_void_p))]


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
        assert message and all(character >= " " for character in message), message
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
        return {"mask": [1] + [0] * 7, "levels": [0.5, 1, 1.5]}.get(name, [1] * per)
    if kind == "input file":
        return str(DATA / "torus.ply")
    return {"flag": True, "switch": "on", "vertices": [0, 1, 2], "points": [0, 1], "curves": "creases", "counts": [2, 3], "bound": "50%", "crease angle": 30, "bytes": "1G"}[kind]


def subject(operation, ball):
    """What an operation works on."""
    if operation["on"] == "remesh":
        return result("remesh", ball, {"vertices": [0, 1, 2, 3, 4, 5]})
    of_diagram = str(operation["on"]).startswith("diagram")  # or one of several
    return result("diagram", ball, {"count": 4}) if of_diagram else ball if operation["on"] else None


def least_options(operation):
    """Options without which an operation can't be called."""
    if operation["on"] is None:
        return {"file": str(DATA / "torus.ply")}
    return {"distances": {"from": [0]}, "edit": {"remove": 0}, "curves": {"curves": "creases"}, "label": {}, "map": {},
            "check": {}, "scene": {}}.get(operation["name"], {"count": 4})


def check_described_options():
    """Each option alone beside what it needs: taken, and told so that it can be given back, or refused for another reason
    than its value; and a wrong value."""
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
                told = figures(made)
                assert name in told["options"], name
                again = result(operation["name"], on, told["options"])  # which say the same
                assert figures(again) == told, (operation["name"], given, told["options"])
                release(made, again)
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
        if operation["name"] in ("saved_mesh", "values"):
            continue  # check_meshes
        options = {"segment": {"count": 4, "cut": True}, "label": {"cut": True}}.get(operation["name"], least_options(operation))
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
    assert bad(b"[]").startswith("options: the JSON is not an object; write one")
    assert bad(b'{"count": 3, "count": 4}') == '"count" is given twice; keep one'
    assert bad(b'{"radius": 1e309}') == "options: the JSON has a number that is too large for a double"
    assert bad(b'\xff{"count": 3}').startswith("options: not valid JSON at line 1")
    assert bad({"cuont": 3}) == 'there is no option "cuont"; did you mean "count"?'
    assert bad({"count": 0}) == "\"count\": '0' is not a whole number from 1 to 2147483647"
    release(result("lloyd", ball, {"count": 3.0, "iterations": 2e0, "move_tolerance": 1.0}))
    assert bad({"count": 2.5}).startswith("\"count\": '2.5' is not a whole number")
    assert bad({"count": True}).startswith("\"count\": 'true' is not a whole number")
    assert bad({"count": 3, "radius": 1}) == '"count" and "radius" exclude each other: keep one'
    assert bad({}) == 'no generators: give one of "count", "generators", "vertices" or "radius"'
    assert bad(None).startswith("no generators")
    assert bad({"count": None}).startswith("no generators")
    assert bad({"count": 3, "keep_boundary": 1}) == "\"keep_boundary\": '1' is neither true nor false"
    assert bad({"count": 3, "accelerate": "lbgfs"}).endswith("did you mean lbfgs?")
    assert bad({"count": 3, "move_tolerance": "nan"}) == "\"move_tolerance\": 'nan' is not a finite number from 0 on"
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
    assert bad({"generators": [[0, 0]]}).startswith('"generators": points have 2 columns')
    assert bad({"generators": [[1, 0, 0], [0, 1]]}) == "\"generators\": '[0,1]' is not a row of 3 numbers like the first point"
    assert bad({"generators": [[1, 0, 0], 2]}).startswith("\"generators\": '2' is not a row of 3 numbers")
    assert bad({"generators": [[0.5, 1, 0, 0]]}) == '"generators": element 0 is 0.5; give whole numbers from 0 on'
    # Numbers that no double has are told as they were given.
    large = 2 ** 53 + 1
    for value, *arrays in ((("vertices", [large]),), (("vertices", {"array": 0}), array([large], ctypes.c_int64))):
        assert str(large) in bad(dict([value]), *arrays, status=PRECONDITION), value
    assert bad({"vertices": {"array": 0}}, array([float(large)])).startswith('"vertices": element 0 is 9007199254740992;')
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
    # What an operation takes is told before its options; and which part would do.
    whole = result("segment", ball, {"count": 3})
    assert refused("label", whole, {}) == 'this takes a diagram, and the object is a segment; take its part "diagram"'
    assert gvd.gvd_object_of(whole, b"cut_mesh", ctypes.byref(ctypes.c_void_p())) == INVALID
    assert gvd.gvd_last_error() == b"there is no cut_mesh here: the pieces of the faces, made with cut"
    # Offsets of curves are checked before anything is made by them.
    curves = lambda offsets: refused("diagram", ball, {"curves": {"points": [0, 2, 1], "offsets": offsets}})
    assert curves([0, 50000000, 3]) == '"curves": curve 1 has no point: it is from offset 50000000 to 3'
    assert curves([0, 2, 2, 3]) == '"curves": curve 1 has no point: it is from offset 2 to 2'
    assert curves([1, 3]) == curves([0, 2]) == curves([]) == (
        '"curves": the offsets of curves begin with 0 and end with the number of points, 3')
    # Charts need points as generators.
    of_curve = result("diagram", ball, {"curves": {"points": [0, 2, 1]}})
    assert refused("label", of_curve, {"uv": "logmap"}).startswith('"uv": the generators are curves, and charts')
    release(relaxed, whole, of_curve, ball, None)


def check_values():
    """Numbers may be strings; points and numbers may be arrays of any type, or lists; null is as if nothing were there."""
    ball = make_ball()
    listed = [
        ({"generators": [0, 2]},), ({"vertices": [0, 2]},), ({"vertices": {"array": 0}}, array([0, 2], ctypes.c_int64)),
        ({"generators": {"array": 0}}, array([0, 2], ctypes.c_uint8)),
        ({"generators": {"array": 0}}, array([(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])),
        ({"generators": {"array": 0}}, array([(0, 1, 0, 0), (0, 0, 1, 0)], ctypes.c_float)),
        ({"generators": [{"vertex": 0}, {"position": [0, 1, 0]}]},), ({"generators": [[1, 0, 0], [0, 1.0, "0"]]},),
        ({"generators": [[0, 1, 0, 0], [0, 0, 1, 0]]},), ({"generators": [0.0, 2.0]},),
    ]
    found = []
    for options, *arrays in listed:
        made = result("lloyd", ball, {"iterations": "3", "density": None, **options}, *arrays)
        found.append((numbers(made, "generators_faces"), numbers(made, "generators_bary"), figures(made)["final_energy"]))
        release(made)
    assert all(one == found[0] for one in found), found
    made = result("lloyd", ball, {"vertices": [0, 2], "density": [1] * 8, "iterations": 0})
    assert figures(made)["options"]["vertices"] == [0, 2] and figures(made)["options"]["density"] == [1] * 8
    release(made)
    for levels in ([2, 4], [2.0, 4.0], {"array": 0}):
        made = result("segment", ball, {"levels": levels}, array([2, 4], ctypes.c_int32))
        assert len(set(numbers(made, "face_labels"))) == 4, levels
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


def check_options_come_back():
    """The options that figures tell can be given back as they are, and give the same result."""
    ball = make_ball()
    corners, whole = array([(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]), array([0, 2, 4], ctypes.c_int32)
    weights = array([1.0] * 8)
    tried = {
        "distances": [{"from": [0]}, {"from": {"array": 0}, "to": {"array": 1}, "paths": True}, {"from": [0, 1], "each": True},
                      {"curves": {"points": {"array": 1}, "offsets": [0, 2, 3]}, "isolines": 0.5},
                      {"from": [[1, 0, 0]], "mask": [1] + [0] * 7, "max_distance": 1.5}, {"from": [0], "logarithm": True}],
        "sample": [{"count": 3}, {"radius": 0.9}, {"vertices": {"array": 1}}, {"generators": {"array": 0}, "max_snap": 0.1},
                   {"count": 3, "sampling": "random", "seed": 2 ** 60 + 1}],
        "diagram": [{"count": 3}, {"vertices": [0, 2]}, {"vertices": [0, 2, 4], "method": "paper"},
                    {"vertices": [0, 2, 4], "method": "gbgvd", "front": "planar"}, {"count": 4, "balance": "area"},
                    {"generators": {"array": 0}, "weights": [0, 0.1, 0]}, {"curves": "creases:30"}, {"count": 3, "chord_tolerance": 0.1}],
        "label": [{}, {"labels": "nearest"}, {"cut": True}, {"uv": "logmap"}],
        "segment": [{"count": 4}, {"count": 4, "labels": "nearest"}, {"count": 4, "cut": True}, {"count": 4, "uv": "flat"},
                    {"vertices": [0, 2, 4]}, {"generators": {"array": 0}}, {"radius": 0.9}, {"levels": [2, 4]},
                    {"within": {"array": 2}, "per_region": 2}, {"count": 4, "disc": True}, {"count": 3, "balance": {"array": 2}}],
        "lloyd": [{"count": 3}, {"vertices": [0, 2, 4]}, {"generators": {"array": 0}, "iterations": 2}, {"count": 3, "accelerate": "none"},
                  {"count": 3, "density": "curvature", "gradation": 1.5}, {"count": 3, "density": {"array": 2}, "features": 80},
                  {"count": 3, "features": "none", "keep_boundary": True}, {"count": 3, "balance": "area", "coarse": 50},
                  {"count": 3, "fixed": [0], "method": "gbgvd"}, {"count": 3, "relocate": "off"}],
        "remesh": [{"count": 6}, {"count": 6, "relax": "none"}, {"count": 6, "relax": 2, "features": "none"},
                   {"generators": [0, 1, 2, 3, 4, 5]}, {"vertices": [0, 1, 2, 3, 4, 5]}, {"target_edge": 1.4}, {"error": "50%"},
                   {"count": 6, "place": "generator", "refine": False}, {"count": 6, "map": True, "carry": True, "features": 20}]}
    others = {"edit", "map", "check", "curves", "scene", "mesh", "saved_mesh", "values", "properties"}  # few options, or files
    assert {*tried, *others} == {operation["name"] for operation in DESCRIBED["operations"]}
    for operation in DESCRIBED["operations"]:
        on = subject(operation, ball)
        for options in tried.get(operation["name"], ()):
            first = result(operation["name"], on, options, corners, whole, weights)
            told = figures(first)
            again = result(operation["name"], on, told["options"], corners, whole, weights)
            assert figures(again) == told, (operation["name"], options, told["options"])
            for one in operation["result"]["arrays"]:
                assert repr(numbers(first, one["name"])) == repr(numbers(again, one["name"])), (options, one["name"])
            release(first, again)
    release(ball)


def check_defaults():
    """A described default is a value that the option takes, and says nothing by itself."""
    ball = make_ball()
    for operation in DESCRIBED["operations"]:
        options = {option["name"]: option for option in operation["options"]}
        if operation["name"] in ("saved_mesh", "values"):
            continue  # of arrays and numbers alone
        usual = least_options(operation)
        on = subject(operation, ball)
        plain = result(operation["name"], on, usual)
        for name, option in options.items():
            assert option["usual"] is None or isinstance(option["usual"], str), option
            given = {name: option["default"]}
            status, made = call(operation["name"], on, {**given, **usual})
            if status == OK:
                assert {**figures(made), "options": 0} == {**figures(plain), "options": 0}, (operation["name"], option)
                release(made)
            else:  # it goes with other options only
                assert not made.startswith(f'"{name}": \'') and any(why in made for why in ("exclude each other", "has no effect", " needs ")), (option, made)
        release(plain)
    defaults = lambda operation: {o["name"]: o["default"] for one in DESCRIBED["operations"] if one["name"] == operation for o in one["options"]}
    assert defaults("diagram")["curves"] is None and defaults("diagram")["seed"] == 0 and defaults("diagram")["method"] == "exact"
    assert defaults("remesh")["features"] == "auto" and defaults("lloyd")["features"] == "none" and defaults("remesh")["refine"] is True
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
    assert refused("distances", ball, {"from": [0, 1], "logarithm": True}).startswith('"logarithm" needs exactly one source')
    assert refused("distances", ball, {"from": [0], "paths": True}).startswith('"paths" has no effect here: add "to"')
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
        "there is no generator 50; the diagram has 50 generators"
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
    assert b"a sample can't be written" in gvd.gvd_last_error(), gvd.gvd_last_error()
    assert gvd.gvd_write(ball, str(folder / "a.doc").encode(), None) == INVALID
    assert b"the extension must be one of .ply" in gvd.gvd_last_error(), gvd.gvd_last_error()
    # No file has nothing but what the object lacks, and none loses what was asked for: as the commands say.
    def unwritten(operation, options, extension, *words):
        made, path = result(operation, ball, options), folder / f"lost.{extension}"
        assert gvd.gvd_write(made, str(path).encode(), None) == INVALID and not path.exists(), (options, extension)
        release(made)
        mine = gvd.gvd_last_error().decode()
        if words:
            done = subprocess.run([str(BIN / "gvd-distance"), str(folder / "ball.off"), *words, "-o", str(path)], stderr=subprocess.PIPE)
            theirs = done.stderr.decode().strip().split(": error: ")[1]
            spelled = theirs.replace(f"-o {path}", str(path)).replace(", --view and --report hold", " hold")
            for option in ("to", "each", "paths", "isolines"):
                spelled = spelled.replace(f"--{option}", f'"{option}"')
            commas = lambda text: text.replace(" and ", ", ").replace(" or ", ", ")
            assert commas(mine) == commas(spelled), (mine, spelled)
        return mine
    assert gvd.gvd_write(ball, str(folder / "ball.off").encode(), None) == OK
    for extension in ("ply", "vtp", "curv"):
        unwritten("distances", {"from": [0], "each": True}, extension, "--from", "0", "--each")
    for extension in ("csv", "ply", "npy", "txt", "shape.gii"):
        unwritten("distances", {"from": [0], "isolines": 0.5}, extension, "--from", "0", "--isolines", "0.5")
    for extension in ("npy", "txt", "ply"):
        unwritten("distances", {"from": [0], "to": [1], "paths": True}, extension, "--from", "0", "--to", "1", "--paths")
    for extension in ("curv", "shape.gii", "ply", "vtp", "obj", "glb"):
        unwritten("distances", {"from": [0], "to": [1]}, extension, "--from", "0", "--to", "1")
    unwritten("distances", {"from": [0]}, "obj", "--from", "0")
    for operation, options in (("distances", {"from": [0]}), ("lloyd", {"count": 3}), ("segment", {"count": 3}), ("remesh", {"count": 6})):
        listed = unwritten(operation, options, "doc").split("must be one of ")[1].replace(" or ", ", ").split(", ")
        formats = {format["extensions"][0]: format for format in DESCRIBED["formats"] if format["is_written"]}
        assert all(extension[1:] in formats for extension in listed), listed
        assert (".obj" in listed) and (".csv" in listed) == (operation in ("distances", "lloyd")), (operation, listed)
        assert (".off" in listed) == (operation != "distances") and (".annot" in listed) == (operation in ("lloyd", "segment"))
        made = result(operation, ball, options)
        for extension in listed:
            path = folder / f"any{extension}"
            status = gvd.gvd_write(made, str(path).encode(), None)
            assert status == OK or b"holds no distances" in gvd.gvd_last_error(), (operation, extension, gvd.gvd_last_error())
        release(made)
    # A name with the character that begins a placeholder is no name of a file, and is shown without it.
    assert gvd.gvd_write(ball, str(folder / "a\1count\2.ply").encode(), None) != OK
    assert b"a?count?.ply': the name has a control character" in gvd.gvd_last_error(), gvd.gvd_last_error()
    assert gvd.gvd_mesh_read(str(folder / "{option:count}.obj").encode(), 1, ctypes.byref(ctypes.c_void_p())) != OK
    assert b"{option:count}.obj: there is no such file" in gvd.gvd_last_error(), gvd.gvd_last_error()
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


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as scratch:
        check_mistakes()
        check_values()
        check_options_come_back()
        check_defaults()
        check_parts()
        check_distances()
        check_edits()
        check_described_options()
        check_described_results()
        check_files(pathlib.Path(scratch))
        check_same_as_commands(pathlib.Path(scratch))
    print("all checks passed")
