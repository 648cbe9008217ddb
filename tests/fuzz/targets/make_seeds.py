#!/usr/bin/env python3
"""Writes the inputs that libFuzzer starts from: make_seeds.py FOLDER makes FOLDER/TARGET/*.

Small files that are valid, or break one rule each. libFuzzer mutates them, and keeps what reaches new branches.
"""
import pathlib
import struct
import sys

TETRAHEDRON = ([(0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1)], [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)])
# Three pages on one edge, one of them turned round.
BOOK = ([(0, 0, 0), (0, 0, 1), (1, 0, 0), (-1, 1, 0), (-1, -1, 0)], [(0, 1, 2), (0, 1, 3), (1, 0, 4)])
# A concave polygon, a square that crosses itself, and a vertex in no face.
POLYGONS = ([(0, 0, 0), (2, 0, 0), (2, 2, 0), (1, 0.5, 0), (0, 2, 0), (5, 0, 0), (6, 0, 0), (5, 1, 0), (6, 1, 0), (9, 9, 9)],
            [(0, 1, 2, 3, 4), (5, 6, 7, 8)])
# Two triangles that touch in a vertex, a doubled face, a face with a repeated corner and one on a line.
BOW_TIE = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (2, 0, 0)],
           [(0, 1, 2), (0, 3, 4), (2, 0, 1), (0, 1, 1), (0, 1, 5)])
MOEBIUS = ([(0, 0, 0), (1, 0, 0), (2, 1, 0), (1, 2, 1), (0, 1, 1)], [(0, 1, 2), (1, 2, 3), (2, 3, 4), (3, 4, 0), (4, 0, 1)])
SHAPES = [TETRAHEDRON, BOOK, POLYGONS, BOW_TIE, MOEBIUS]


def numbers(values):
    return " ".join(repr(v) for v in values)


def off(points, faces, keyword="OFF"):
    lines = [keyword, f"{len(points)} {len(faces)} 0"]
    lines += [numbers(p) for p in points] + [f"{len(f)} {numbers(f)}" for f in faces]
    return "\n".join(lines) + "\n"


def obj(points, faces):
    return "".join(f"v {numbers(p)}\n" for p in points) + "".join(f"f {numbers([v + 1 for v in f])}\n" for f in faces)


def stl(points, faces):
    text = "solid s\n"
    for face in faces:
        corners = "".join(f"vertex {numbers(points[v])}\n" for v in face[:3])
        text += f"facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n"
    return text + "endsolid s\n"


def binary_stl(points, faces):
    data = bytes(80) + struct.pack("<I", len(faces))
    for face in faces:
        data += struct.pack("<3f", 0, 0, 1) + b"".join(struct.pack("<3f", *points[v]) for v in face[:3]) + bytes(2)
    return data


def ply_header(form, points, faces, real="float", extra=""):
    return (f"ply\nformat {form} 1.0\ncomment c\nelement vertex {len(points)}\nproperty {real} x\nproperty {real} y\n"
            f"property {real} z\n{extra}element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")


def ply(points, faces):
    body = "".join(numbers(p) + "\n" for p in points) + "".join(f"{len(f)} {numbers(f)}\n" for f in faces)
    return ply_header("ascii", points, faces) + body


def binary_ply(points, faces, order, real):
    name = "binary_little_endian" if order == "<" else "binary_big_endian"
    data = ply_header(name, points, faces, "double" if real == "d" else "float").encode()
    for p in points:
        data += struct.pack(f"{order}3{real}", *p)
    for f in faces:
        data += struct.pack(f"{order}B{len(f)}i", len(f), *f)
    return data


def ply_strip():
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0)]
    return ("ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
            "property list uchar float extra\nelement other 2\nproperty short a\nelement empty 3\n"
            "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
            + "".join(numbers(p) + " 2 0.5 0.5\n" for p in points) + "7\n8\n9 0 1 2 -1 1 2 3 4 4\n")


def off_seeds():
    yield from (off(*shape) for shape in SHAPES)
    yield off(*TETRAHEDRON).replace("OFF\n", "", 1)
    yield off(*TETRAHEDRON, "COFF").replace("\n", " 0.1 0.2 0.3 1 # colour\r\n").replace("COFF 0.1 0.2 0.3 1", "COFF")
    yield "OFF 3 1 0\n0 0 0 1 0\n0 0 1 0\n3 0 1 2 255 0 0\nmore\n"
    yield "OFF\n4294967295 4294967295 0\n0 0 0\n"
    yield "OFF BINARY\n"
    yield "4OFF\n1 1 1\n"


def obj_seeds():
    yield from (obj(*shape) for shape in SHAPES)
    yield "o a\r\nv 0 0 0 1 # c\r\nv 1 0 0\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\nf 1/1/1 2//1 3/1\r\nl 1 2 3\r\n"
    yield "f -3 -2 -1\nf 1 2 \\\n3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\ng x\nusemtl y\n"
    yield "v 1e-310 -0 +1e400\nv 1e75 1e-75 0\nv 0 0 1\nf 1 2 3\nf 1 2 9999999999\n"


def ply_seeds():
    yield ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
           "property list uchar int ids\nelement face 1\nproperty list uchar int vertex_indices\n"
           "property list uchar float texcoord\nend_header\n"
           "0 0 0 1 7\n1 0 0 0\n0 1 0 2 1 2\n3 0 1 2 6 0 0 1 0 0 1\n")
    for shape in SHAPES:
        yield ply(*shape)
        yield binary_ply(*shape, "<", "f")
    yield binary_ply(*TETRAHEDRON, ">", "d")
    yield ply_strip()
    yield ply(*TETRAHEDRON).replace("\n", "\r\n")
    yield ply(*TETRAHEDRON).replace("vertex 4", "vertex 4294967295").replace("face 4", "face 4294967295")
    yield ply(*TETRAHEDRON).replace("list uchar", "list uint").replace("3 0 1 2", "4294967295 0 1 2")


def stl_seeds():
    for shape in SHAPES:
        yield stl(*shape)
        yield binary_stl(*shape)
    yield bytes(80) + struct.pack("<I", 4294967295) + bytes(50)
    yield binary_stl(*TETRAHEDRON) + b"more"
    yield stl(*TETRAHEDRON).replace("solid s", "SOLID s ", 1).replace("endsolid s", "EndSolid")


def generator_seeds():
    lists = ["0\n3\n8 # vertex\n", "p 0.5 0.5 2\np 1e300 0 0\n1 0.2 0.3 0.5\n4 1 0 0\n", "0 0 0\n1 1 1\n"]
    tables = ["vertex\n1\n2\n", "face,b0,b1,b2,x,y,z\n1,0.25,0.25,0.5,0,0,0\n", "x,y,z\n0,0,1\n\"1\",\"0\",\"0\"\n",
              "p,0,0,0\n3,0.1,0.2,0.7\n5\n"]
    documents = ['{"schema":"gvd-generators/1","generators":[\n{"face":0,"bary":[0.5,0.25,0.25],"position":[0,0,0]},\n'
                 '{"vertex":3},{"position":[1,2,3e4]}]}\n', '{"generators":[],"generators":[{"vertex":1}]}', "[[[[{}]]]]"]
    for choice, contents in enumerate([lists, tables, documents]):
        for content in contents:
            yield chr(choice) + content
            yield "\x03" + content


def config_seeds():
    yield 'input = "a.off"\ncount = 12\nvertices = [3, 17]\nradius = 0.5\ncut = true\nsampling = \'random\'\n'
    yield 'n = 1_000\nradius = 1e-3\nvertices = "3,17"\ninput = ["a", "b"]\n'
    yield 'sampling = """two\nlines"""\n"quoted \\u0041" = 0x1f\ncut = false # c\n'
    yield "day = 1979-05-27T07:32:00Z\nradius = inf\n[table]\na.b = {c = [1, [2, {}]]}\n[[array]]\nx = 1\n"
    yield "n = [ 12\n"
    yield "'a\\b' = 1\nn = 99999999999999999999\n"


SEEDS = {"off": off_seeds, "obj": obj_seeds, "ply": ply_seeds, "stl": stl_seeds, "generators": generator_seeds,
         "config": config_seeds}


def main():
    for target, seeds in SEEDS.items():
        folder = pathlib.Path(sys.argv[1]) / target
        folder.mkdir(parents=True, exist_ok=True)
        for number, content in enumerate(seeds()):
            (folder / f"seed-{number:02}").write_bytes(content if isinstance(content, bytes) else content.encode())


if __name__ == "__main__":
    main()
