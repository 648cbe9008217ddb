#!/usr/bin/env python3
"""Files in memory, scenes for the page, and iterations, through the C interface.

    check_memory.py LIBRARY BIN_FOLDER DATA_FOLDER
"""
import ctypes
import json
import pathlib
import tempfile

from check_calls import DATA, INVALID, OK, Run, array, figures, gvd, handle, make_ball, numbers, read, refused, release, result


def bytes_of(thing, name="bytes"):
    return bytes(int(number) for number in numbers(thing, name))


def file_in_memory(thing, extension, options=None):
    file = handle("gvd_file_of", thing, extension.encode(), json.dumps(options or {}).encode(), None)
    made = bytes_of(file)
    release(file)
    return made


def check_memory(folder):
    """Files in memory are those on a disk, both ways."""
    mesh = read("torus.ply")
    regions, path = result("segment", mesh, {"count": 9}), folder / "regions.ply"
    for extension, options in (("ply", {}), ("ply", {"ascii_ply": True}), ("json", {}), ("glb", {})):
        path = folder / f"a.{extension}"
        assert gvd.gvd_write_as(regions, str(path).encode(), json.dumps(options).encode(), None) == OK
        assert file_in_memory(regions, extension, options) == file_in_memory(regions, f".{extension}", options) == path.read_bytes()
    file = ctypes.c_void_p()
    assert gvd.gvd_file_of(regions, b"doc", None, None, ctypes.byref(file)) == INVALID
    assert gvd.gvd_last_error().startswith(b"'doc': the extension must be one of .ply"), gvd.gvd_last_error()
    assert gvd.gvd_file_of(regions, None, None, None, ctypes.byref(file)) == INVALID
    content = array((DATA / "torus.ply").read_bytes(), ctypes.c_uint8)
    again = result("mesh", None, {"file": "torus.ply", "content": True}, content)
    assert numbers(again, "vertex_positions") == numbers(mesh, "vertex_positions")
    assert refused("mesh", None, {"file": "a.doc", "content": True}, array(b"hello", ctypes.c_uint8), status=3).startswith("a.doc: neither")
    assert refused("mesh", None, {"file": "a.ply", "content": True}) == 'give the bytes of the file as an array, as "content" says'
    assert "does not contain bytes" in refused("mesh", None, {"file": "a.ply", "content": True}, array([1.0]))
    assert '"content"' in refused("mesh", None, {"content": True}, content)
    values = result("values", None, {"file": "a.txt", "content": True}, array(b"3 1\n4", ctypes.c_uint8))
    assert numbers(values, "values") == [3, 1, 4]
    properties = result("properties", None, {"file": "a.ply", "content": True}, array(path.read_bytes() and file_in_memory(regions, "ply"), ctypes.c_uint8))
    assert "face label" in figures(properties)["names"], figures(properties)
    curves = result("curves", mesh, {"curves": {"file": "a.txt", "content": {"array": 0}}}, array(b"0\n1\n", ctypes.c_uint8))
    assert figures(curves)["count"] == 1
    assert "content" in refused("curves", mesh, {"curves": {"file": "a.txt", "contents": {"array": 0}}}, array(b"0", ctypes.c_uint8))
    release(curves, properties, values, again, regions, mesh)


def check_scenes():
    """A picture of each object; its arrays, colours that stay, and one frame."""
    mesh = read("torus.ply")
    diagram = result("diagram", mesh, {"count": 9, "editable": True})
    scene = result("scene", diagram, {})
    manifest, offsets, colors = json.loads(figures(scene)["manifest"]), numbers(scene, "offsets"), numbers(scene, "colors")
    assert manifest["schema"] == "gvd-view/1" and offsets[0] == 0 and offsets[-1] == len(bytes_of(scene)) and len(colors) == 9
    edited = result("edit", diagram, {"add": [100]})
    after = result("scene", edited, {"colors": {"array": 0}}, array([int(byte) for color in colors for byte in color], ctypes.c_uint8))
    assert numbers(after, "colors")[:9] == colors and len(numbers(after, "colors")) == 10
    frame = {key: manifest[key] for key in ("origin", "scale")}
    distances, remesh = result("distances", mesh, {"from": [0]}), result("remesh", mesh, {"count": 60})
    for one, options in ((distances, {"isolines": 4}), (distances, {}), (remesh, {}), (edited, {})):
        other = result("scene", one, options)
        told = json.loads(figures(other)["manifest"])
        assert {key: told[key] for key in frame} == frame and len(told["scenes"]) == 1
        assert ("isolines" in json.dumps(told)) == bool(options), options
        release(other)
    assert refused("scene", mesh, {}) == "this takes a diagram, distances or remesh, and the object is a mesh"
    assert '"colors": three whole numbers' in refused("scene", diagram, {"colors": [1, 2]})
    pieces = handle("gvd_object_of", diagram, b"pieces")
    assert len(numbers(pieces, "positions")) == 3 * len(numbers(pieces, "faces")) == 3 * len(numbers(pieces, "labels")) > 0
    release(pieces, remesh, distances, after, edited, scene, diagram, mesh)


def check_levels():
    """Isolines at listed distances."""
    ball = make_ball()
    lines = result("distances", ball, {"from": [0], "levels": [0.25, 0.5]})
    assert set(numbers(lines, "isoline_levels")) == {0.25, 0.5}
    assert refused("distances", ball, {"from": [0], "levels": [0.5, 0.25]}).startswith('"levels": ')
    release(lines, ball)


def check_iterations():
    seen = []

    def hear(data, iterations, energy, points):
        seen.append((iterations, energy, len(numbers(ctypes.c_void_p(points), "points_faces"))))

    mesh = read("torus.ply")
    made = result("lloyd", mesh, {"count": 9, "iterations": 3}, run=Run(iteration=dict(Run._fields_)["iteration"](hear)))
    energies = figures(made)["energies"]
    assert seen[0] == (0, energies[0], 9) and seen[-1] == (len(energies) - 1, energies[-1], 9), (seen, energies)
    release(made, mesh)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as scratch:
        check_memory(pathlib.Path(scratch))
    check_scenes()
    check_levels()
    check_iterations()
    print("all checks passed")
