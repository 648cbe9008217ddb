"""Files of the commands for the readers beside this one: files.py BIN_FOLDER WORK_FOLDER.

    whole.*   gvd-segment      text.ply   the same as text      plain.*   the same with --no-curves
    cut.*     gvd-segment --cut           coarse.*   gvd-remesh           ball.off, sheet.off   the inputs
    painted.* gvd-segment --cut of painted.obj, the sheet with texture coordinates; seam.* with a seam; *_text.ply as text
"""
import json
import math
import pathlib
import subprocess
import sys

WIDTH, HEIGHT = 14, 11
GENERATORS = [0, 13, 45, 77, 80, 118, 121, 140, 153]  # vertices of the sheet; its second component has none


def write_off(path, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(repr(x) for x in p) for p in points] + [f"3 {a} {b} {c}" for a, b, c in faces]
    path.write_text("\n".join(lines) + "\n")


def make_sheet():
    """A gently curved sheet away from the origin, and a triangle beside it."""
    points = [(x / 3, y / 7, 100 + math.sin(x / 5) * math.cos(y / 4) / 9) for y in range(HEIGHT) for x in range(WIDTH)]
    faces = []
    for y in range(HEIGHT - 1):
        for x in range(WIDTH - 1):
            a = y * WIDTH + x
            faces += [(a, a + 1, a + WIDTH), (a + 1, a + WIDTH + 1, a + WIDTH)]
    first = len(points)
    points += [(6.0, 0.0, 100.0), (7.0, 0.1, 100.0), (6.5, 1.0 / 3, 100.0)]
    return points, faces + [(first, first + 1, first + 2)]


def make_ball(rings=9, sectors=14):
    points = [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0)]
    for i in range(1, rings):
        for k in range(sectors):
            t, u = math.pi * i / rings, 2 * math.pi * k / sectors
            points.append((math.sin(t) * math.cos(u), math.sin(t) * math.sin(u), math.cos(t)))
    at = lambda i, k: 2 + (i - 1) * sectors + k % sectors
    faces = [(0, at(1, k), at(1, k + 1)) for k in range(sectors)]
    faces += [(1, at(rings - 1, k + 1), at(rings - 1, k)) for k in range(sectors)]
    for i in range(1, rings - 1):
        for k in range(sectors):
            faces += [(at(i, k), at(i + 1, k), at(i + 1, k + 1)), (at(i, k), at(i + 1, k + 1), at(i, k + 1))]
    return points, faces


def texture(x, y, seam):
    """Texture coordinates at x and y; `seam`: on the right side of the seam."""
    return x / 10 + (0.25 if seam else 0), 1 - y / 3


def write_painted(path, points, faces, with_seam):
    """The sheet as OBJ with texture coordinates, of which those to the right of x = 2 may lie elsewhere."""
    lines = ["v " + " ".join(repr(x) for x in p) for p in points]
    lines += ["vt {!r} {!r}".format(*texture(x, y, seam)) for seam in (False, True) for x, y, _ in points]
    for face in faces:
        shift = len(points) if with_seam and sum(points[v][0] for v in face) > 6 else 0
        lines.append("f " + " ".join(f"{v + 1}/{v + 1 + shift}" for v in face))
    path.write_text("\n".join(lines) + "\n")


def run(bin_folder, work, *arguments):
    subprocess.run([str(pathlib.Path(bin_folder) / arguments[0]), *map(str, arguments[1:]), "-q"], cwd=work, check=True)


def has_viewer(bin_folder, work):
    """Whether the commands were built with the page of --view."""
    line = [str(pathlib.Path(bin_folder) / "gvd-segment"), "ball.off", "-n", "2", "--view", "page.html"]
    return "not part of this build" not in subprocess.run(line, cwd=work, capture_output=True, text=True).stderr


def outputs(name, *suffixes):
    return [word for suffix in suffixes for word in ("-o", f"{name}.{suffix}")]


def write_files(bin_folder, work):
    """Writes all files. Returns the diagram of whole.json and the positions of the sheet's vertices."""
    work = pathlib.Path(work)
    points, faces = make_sheet()
    write_off(work / "sheet.off", points, faces)
    write_off(work / "ball.off", *make_ball())
    sheet = ["gvd-segment", "sheet.off", "--vertices", ",".join(map(str, GENERATORS))]
    run(bin_folder, work, *sheet, *outputs("whole", "ply", "obj", "off", "coff", "stl", "vtp", "vtu", "glb", "json"),
        "--adjacency", "whole.graphml")
    run(bin_folder, work, *sheet, *outputs("text", "ply"), "--ascii-ply")
    run(bin_folder, work, *sheet, *outputs("plain", "obj", "vtp", "vtu", "glb"), "--no-curves")
    run(bin_folder, work, *sheet, "--cut", *outputs("cut", "vtp", "vtu", "glb", "json"))
    run(bin_folder, work, *sheet, "--cut", *outputs("cut", "ply"), "--ascii-ply")
    run(bin_folder, work, "gvd-remesh", "ball.off", "-n", "30", *outputs("coarse", "ply", "glb"))
    write_off(work / "far-in.off", [(x + 431234.5, y + 5412345.25, z) for x, y, z in points], faces)
    run(bin_folder, work, "gvd-segment", "far-in.off", *sheet[2:], *outputs("far", "glb"))
    for name in ("painted", "seam"):
        write_painted(work / f"{name}-in.obj", points, faces, name == "seam")
        painted = ["gvd-segment", f"{name}-in.obj", *sheet[2:], "--cut"]
        run(bin_folder, work, *painted, "--no-curves", *outputs(name, "ply", "obj", "glb"))
        run(bin_folder, work, *painted, "--ascii-ply", *outputs(f"{name}_text", "ply"))
    diagram = json.loads((work / "whole.json").read_text())
    assert -1 in diagram["face_labels"] and None in diagram["vertex_distances"], "nothing is unreached"
    return diagram, points, faces


def unnull(distances):
    return [math.inf if d is None else d for d in distances]


def segments(diagram):
    """Number of straight pieces of all bisectors, as written to OBJ, VTP and GLB."""
    return sum(len(b["points"]) - (0 if b["closed"] else 1) for b in diagram["bisectors"])


def region_vertices(labels, faces):
    """The number of pairs of a label and a vertex of its faces."""
    return len({(label, v) for label, face in zip(labels, faces) for v in face})


def srgb(linear):
    """A linear factor of light as a channel of sRGB, 0 to 255."""
    return round(255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055))


def one_color_each(labels, colors):
    """The colour of each label, where every element with the label has the same one."""
    of_label = {}
    for label, color in zip(labels, colors):
        assert of_label.setdefault(label, tuple(color)) == tuple(color), f"label {label} has several colours"
    return of_label


def palette(work):
    """The colour of each label in whole.ply, from its text: of the vertices."""
    lines = (pathlib.Path(work) / "text.ply").read_text().split("end_header\n")[1].split("\n")[: WIDTH * HEIGHT + 3]
    rows = [line.split() for line in lines]
    return one_color_each([int(row[4]) for row in rows], [tuple(map(int, row[5:8])) for row in rows])


if __name__ == "__main__":
    write_files(sys.argv[1], sys.argv[2])
