#!/usr/bin/env python3
"""Writes the inputs that libFuzzer starts from: make_seeds.py FOLDER makes FOLDER/TARGET/*.

Small files that are valid, or break one rule each. libFuzzer mutates them, and keeps what reaches new branches.
"""
import base64
import gzip
import pathlib
import struct
import sys
import zlib

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
    yield obj(*TETRAHEDRON).encode("utf-16")
    yield "o a\r\nv 0 0 0 1 # c\r\nv 1 0 0\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\nf 1/1/1 2//1 3/1\r\nl 1 2 3\r\n"
    yield "f -3 -2 -1\nf 1 2 \\\n3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\ng x\nusemtl y\n"
    yield ("mtllib a.mtl\nusemtl a b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 1\nvt 1 0.5 0\nvt nan\nf 1/1 2/2 3/-2 4/9\nusemtl c\n"
           "f 1/1/1 2/2/1 4/2\n")
    yield "v 0 0 0 1 0.5 0\nv 1 0 0 0 1 0 1\nv 0 1 0 255 0 0\nsurf 0 1 0 1 1 2\nf 1 2 3\n"
    yield "v 0 0 0\nv 1 0 0\nv 0 1 0\n#MRGB ff0a0b0cff01020300ffffff\nf 1 2 3\n"
    yield "v 1e-310 -0 +1e400\nv 1e75 1e-75 0\nv 0 0 1\nf 1 2 3\nf 1 2 9999999999\n"


def ply_seeds():
    yield ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
           "property list uchar int ids\nelement face 1\nproperty list uchar int vertex_indices\n"
           "property list uchar float texcoord\nend_header\n"
           "0 0 0 1 7\n1 0 0 0\n0 1 0 2 1 2\n3 0 1 2 6 0 0 1 0 0 1\n")
    yield ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float s\n"
           "property float t\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 0.5 1\n1 0 0 0 0\n"
           "0 1 0 2 3\n3 0 1 2\n")
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


def vtk(points, faces, version="3.0"):
    lists = "\n".join(f"{len(f)} {numbers(f)}" for f in faces)
    if version >= "5":
        ends = [sum(map(len, faces[:i])) for i in range(len(faces) + 1)]
        cells = f"POLYGONS {len(ends)} {ends[-1]}\nOFFSETS vtktypeint64\n{numbers(ends)}\nCONNECTIVITY vtktypeint64\n"
        lists = numbers([v for f in faces for v in f])
    else:
        cells = f"POLYGONS {len(faces)} {sum(len(f) + 1 for f in faces)}\n"
    return (f"# vtk DataFile Version {version}\nt\nASCII\nDATASET POLYDATA\nPOINTS {len(points)} float\n"
            f"{numbers([x for p in points for x in p])}\nMETADATA\nx\n\n{cells}{lists}\nPOINT_DATA {len(points)}\n")


def binary_vtk(points, faces):
    head = "# vtk DataFile Version 4.2\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nFIELD f 1\na 1 1 short\n"
    cells = [v for f in faces for v in (len(f), *f)]
    return (head.encode() + b"\0\1\n" + f"POINTS {len(points)} double\n".encode()
            + struct.pack(f">{3 * len(points)}d", *[x for p in points for x in p])
            + f"\nCELLS {len(faces)} {len(cells)}\n".encode() + struct.pack(f">{len(cells)}i", *cells)
            + f"\nCELL_TYPES {len(faces)}\n".encode() + struct.pack(f">{len(faces)}i", *[7] * len(faces)))


def vtk_seeds():
    for shape in SHAPES:
        yield vtk(*shape)
        yield vtk(*shape, "5.1")
        yield binary_vtk(*shape)
    yield vtk(*TETRAHEDRON).replace("POLYGONS", "TRIANGLE_STRIPS")
    yield vtk(*TETRAHEDRON).replace("POLYGONS", "LINES 1 3\n2 0 1\nPOLYGONS")
    yield vtk(*TETRAHEDRON).replace("POINTS 4", "POINTS 4294967295")


def vtp(points, faces, form, packed):
    """PolyData with arrays as `form`: ascii, binary, raw or base64 (the last two appended)."""
    appended = b""

    def array(name, kind, values):
        nonlocal appended
        head = f'<DataArray Name="{name}" type="{"Float64" if kind == "d" else "Int32"}" NumberOfComponents="3" '
        if form == "ascii":
            return f'{head}format="ascii">{numbers(values)}</DataArray>'
        data = struct.pack(f"<{len(values)}{kind}", *values)
        header = struct.pack("<I", len(data))
        if packed:
            block = zlib.compress(data)
            header, data = struct.pack("<4I", 1, len(data), 0, len(block)), block
        text = base64.b64encode(header) + base64.b64encode(data) if packed else base64.b64encode(header + data)
        if form == "binary":
            return f'{head}format="binary">{text.decode()}</DataArray>'
        offset, appended = len(appended), appended + (text if form == "base64" else header + data)
        return f'{head}format="appended" offset="{offset}"/>'

    ends = [sum(map(len, faces[: i + 1])) for i in range(len(faces))]
    compressor = ' compressor="vtkZLibDataCompressor"' if packed else ""
    body = (f'<VTKFile type="PolyData"{compressor}><PolyData>'
            f'<Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(faces)}" NumberOfLines="0"><Points>'
            + array("Points", "d", [x for p in points for x in p]) + "</Points><Polys>"
            + array("connectivity", "i", [v for f in faces for v in f]) + array("offsets", "i", ends)
            + "</Polys></Piece></PolyData>").encode()
    if appended:
        body += f'<AppendedData encoding="{form}">_'.encode() + appended + b"</AppendedData>"
    return body + b"</VTKFile>"


def vtp_seeds():
    for shape in SHAPES:
        for form in ("ascii", "binary", "raw", "base64"):
            yield vtp(*shape, form, False)
    for form in ("binary", "raw", "base64"):
        yield vtp(*TETRAHEDRON, form, True)
    yield vtp(*TETRAHEDRON, "ascii", False).replace(b"Polys", b"Strips")


def glb(points, faces, kind, nodes='[{"mesh":0}]', texture=False):
    component = {"B": 5121, "H": 5123, "I": 5125}[kind]
    triangles = [v for f in faces for k in range(1, len(f) - 1) for v in (f[0], f[k], f[k + 1])]
    first = struct.pack(f"<{3 * len(points)}f", *[x for p in points for x in p])
    second = struct.pack(f"<{len(triangles)}{kind}", *triangles)
    binary = first + second + bytes(-len(second) % 4)
    text = ('{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":' + nodes
            + ',"meshes":[{"primitives":[{"attributes":{"POSITION":0' + (',"TEXCOORD_0":2' if texture else "")
            + '},"indices":1,"mode":4}]}],"accessors":['
            + f'{{"bufferView":0,"componentType":5126,"count":{len(points)},"type":"VEC3"}},'
            + f'{{"bufferView":1,"byteOffset":0,"componentType":{component},"count":{len(triangles)},"type":"SCALAR"}}'
            + (f',{{"bufferView":0,"componentType":5126,"count":{len(points)},"type":"VEC2"}}' if texture else "") + "],"
            + f'"bufferViews":[{{"buffer":0,"byteLength":{len(first)},"byteStride":12}},'
            + f'{{"buffer":0,"byteOffset":{len(first)},"byteLength":{len(second)}}}],"buffers":[{{"byteLength":{len(binary)}}}]}}')
    text += " " * (-len(text) % 4)
    return (struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(binary), len(text), 0x4E4F534A) + text.encode()
            + struct.pack("<II", len(binary), 0x004E4942) + binary)


def vtu(points, faces, form, packed):
    """An UnstructuredGrid: PolyData with other names, and types of cells."""
    types = f'<DataArray Name="types" type="UInt8" format="ascii">{numbers([7] * len(faces))}</DataArray></Cells>'
    made = vtp(points, faces, form, packed)
    for old, new in (("PolyData", "UnstructuredGrid"), ("NumberOfPolys", "NumberOfCells"), ("<Polys>", "<Cells>"), ("</Polys>", types)):
        made = made.replace(old.encode(), new.encode())
    return made


def vtu_seeds():
    for shape in SHAPES:
        for form in ("ascii", "binary", "raw", "base64"):
            yield vtu(*shape, form, False)
    yield vtu(*TETRAHEDRON, "binary", True)


def gltf(binary_gltf):
    """A binary glTF as JSON, with its numbers in Base64."""
    length = struct.unpack("<I", binary_gltf[12:16])[0]
    numbers_of = base64.b64encode(binary_gltf[28 + length:])
    return binary_gltf[20:20 + length].replace(b'"buffers":[{', b'"buffers":[{"uri":"data:;base64,' + numbers_of + b'",')


def gltf_seeds():
    for seed in glb_seeds():
        yield gltf(seed)


def mni_seeds():
    for points, faces in SHAPES:
        ends = [sum(map(len, faces[: i + 1])) for i in range(len(faces))]
        lines = lambda rows: "".join(f" {numbers(row)}\n" for row in rows)
        for colors in ("0 1 1 1 1\n", "1\n" + lines([(1, 0, 0, 1)] * len(faces)), "2\n" + lines([(1, 0, 0, 1)] * len(points))):
            yield (f"P 0.3 0.3 0.4 10 1 {len(points)}\n{lines(points)}\n{lines([(0, 0, 1)] * len(points))}\n {len(faces)}\n {colors}\n"
                   f"{lines([ends])}\n{lines(faces)}")


def glb_seeds():
    for shape in SHAPES:
        for kind in "BHI":
            yield glb(*shape, kind)
    yield glb(*TETRAHEDRON, "B", '[{"children":[1,2],"scale":[-1,2,3]},{"mesh":0,"rotation":[0,0,1,0],'
              '"translation":[5,0,0]},{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,9,1]}]')
    yield glb(*TETRAHEDRON, "H", texture=True)
    for mode in "0156":
        yield glb(*TETRAHEDRON, "H").replace(b'"mode":4', f'"mode":{mode}'.encode())


def gifti_array(intent, kind, rows, encoding, endian):
    """An array of rows of numbers, or of numbers; `kind` as in struct."""
    values = [x for row in rows for x in (row if isinstance(row, tuple) else (row,))]
    data = struct.pack(f"{'>' if endian == 'Big' else '<'}{len(values)}{kind}", *values)
    text = (numbers(values) if encoding == "ASCII"
            else base64.b64encode(zlib.compress(data) if encoding[0] == "G" else data).decode())
    columns = f'Dimensionality="2" Dim0="{len(rows)}" Dim1="3"' if isinstance(rows[0], tuple) else \
        f'Dimensionality="1" Dim0="{len(rows)}"'
    return (f'<DataArray Intent="NIFTI_INTENT_{intent}" DataType="NIFTI_TYPE_{"INT32" if kind == "i" else "FLOAT32"}" '
            f'ArrayIndexingOrder="RowMajorOrder" {columns} Encoding="{encoding}" Endian="{endian}Endian"><Data>{text}</Data>'
            "</DataArray>")


GIFTI_FORMS = [("ASCII", "Little"), ("Base64Binary", "Little"), ("Base64Binary", "Big"), ("GZipBase64Binary", "Little")]


def gifti(*arrays):
    return '<?xml version="1.0"?><GIFTI Version="1.0">' + "".join(arrays) + "</GIFTI>"


def triangles_of(faces):
    return [(f[0], f[k], f[k + 1]) for f in faces for k in range(1, len(f) - 1)]


def gii_seeds():
    for points, faces in SHAPES:
        for form in GIFTI_FORMS:
            yield gifti(gifti_array("POINTSET", "f", points, *form), gifti_array("TRIANGLE", "i", triangles_of(faces), *form))
    transform = ("<CoordinateSystemTransformMatrix><DataSpace>a</DataSpace><TransformedSpace>b</TransformedSpace><MatrixData>"
                 "1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1</MatrixData></CoordinateSystemTransformMatrix><Data>")
    yield gifti(*(gifti_array(*array, "ASCII", "Little") for array in
                  (("POINTSET", "f", TETRAHEDRON[0]), ("TRIANGLE", "i", TETRAHEDRON[1]), ("SHAPE", "f", [1, 2])))
                ).replace("<Data>", transform).replace("RowMajor", "ColumnMajor")


def fs_seeds():
    for points, faces in SHAPES:
        triangles = [v for f in triangles_of(faces) for v in f]
        yield (b"\xff\xff\xfecreated\n\n" + struct.pack(">2i", len(points), len(triangles) // 3)
               + struct.pack(f">{3 * len(points)}f", *[x for p in points for x in p])
               + struct.pack(f">{len(triangles)}i", *triangles))


def value_seeds():
    for form in GIFTI_FORMS:
        yield gifti(gifti_array("SHAPE", "f", [0.5, 2, -3], *form))
        yield gifti(gifti_array("LABEL", "i", [0, 3, 7], *form))
    yield b"\xff\xff\xff" + struct.pack(">3i2f", 2, 1, 1, 0.5, -2)
    text = lambda s: struct.pack(">i", len(s)) + s
    colors, entry = struct.pack(">7i", 3, 0, 1, 1, 256, 2, 7), lambda s, r, g: text(s) + struct.pack(">4i", r, g, 0, 0)
    yield (colors + struct.pack(">3i", 1, -2, 2) + text(b"a.txt") + struct.pack(">2i", 2, 0) + entry(b"???", 1, 0)
           + struct.pack(">i", 5) + entry(b"b", 0, 1))
    yield colors + struct.pack(">2i", 1, 2) + text(b"a.txt") + entry(b"???", 1, 0) + entry(b"b", 0, 1)
    for kind, shape, data in (("<f8", "(2,)", struct.pack("<2d", 1.5, -2)), (">i4", "(2, 1)", struct.pack(">2i", 1, -2)),
                              ("|u1", "(1, 3)", b"abc")):
        header = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}\n".encode()
        yield b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + data
    yield "1 2.5,-3e2 # four\n1e-310 inf nan\n"
    yield "face,label\n1,5\n0,3\n"
    yield "source,vertex,distance\n0,0,0.5\n0,1,inf\n"


def generator_seeds():
    lists = ["0\n3\n8 # vertex\n", "p 0.5 0.5 2\np 1e300 0 0\n1 0.2 0.3 0.5\n4 1 0 0\n", "0 0 0\n1 1 1\n"]
    tables = ["vertex\n1\n2\n", "face,b0,b1,b2,x,y,z\n1,0.25,0.25,0.5,0,0,0\n", "x,y,z\n0,0,1\n\"1\",\"0\",\"0\"\n",
              "p,0,0,0\n3,0.1,0.2,0.7\n5\n"]
    documents = ['{"schema":"gvd-generators/1","generators":[\n{"face":0,"bary":[0.5,0.25,0.25],"position":[0,0,0]},\n'
                 '{"vertex":3},{"position":[1,2,3e4]}]}\n', '{"generators":[],"generators":[{"vertex":1}]}', "[[[[{}]]]]"]
    head = "ply\nformat ascii 1.0\nelement vertex 2\n" + "".join(f"property double {n}\n" for n in "xyz")
    points = [head + "end_header\n0 0 0\n1 0.5 0\n",
              head + "property int face\n" + "".join(f"property double b{i}\n" for i in range(3))
              + "end_header\n0 0 0 1 0.25 0.25 0.5\n0 0 0 4 1 0 0\n"]
    clouds = ["0 0 0\n1 1 1 0 0 1\n"]
    for choice, contents in enumerate([lists, tables, documents, points, clouds]):
        for content in contents:
            yield chr(choice) + content
            yield "\x05" + content


def config_seeds():
    yield 'input = "a.off"\ncount = 12\nvertices = [3, 17]\nradius = 0.5\ncut = true\nsampling = \'random\'\n'
    yield 'n = 1_000\nradius = 1e-3\nvertices = "3,17"\ninput = ["a", "b"]\n'
    yield 'sampling = """two\nlines"""\n"quoted \\u0041" = 0x1f\ncut = false # c\n'
    yield "day = 1979-05-27T07:32:00Z\nradius = inf\n[table]\na.b = {c = [1, [2, {}]]}\n[[array]]\nx = 1\n"
    yield "n = [ 12\n"
    yield "'a\\b' = 1\nn = 99999999999999999999\n"


def call_seeds():
    yield '{"count": 30, "density": {"array": 0}, "features": 40}'
    yield '{"generators": {"array": 1}, "max_snap": "0.5", "method": "gbgvd"}'
    yield '{"vertices": [0, 2, 4], "weights": [1, "2", 0.5], "cut": true}'
    yield '{"from": [{"vertex": 1}, {"position": [0, 0, 1]}, {"face": 0, "bary": [1, 0, 0]}], "paths": true, "to": {"array": 2}}'
    yield '{"curves": {"points": {"array": 1}, "offsets": [0, 2], "closed": true}, "isolines": 0.25}'
    yield '{"curves": "creases:30", "each": false, "within": {"array": 0}, "mask": [0, 1, 0, 1, 0, 1]}'
    yield '{"move": 1, "to": {"array": 2}, "max_snap": 0.5}'
    yield '{"add": [{"face": 3, "bary": [0.5, 0.25, 0.25]}, {"vertex": 2}]}'
    yield '{"remove": 0}'
    yield '{"cut": true, "uv": "flat"}'
    yield '{"count": null, "error": "2%", "levels": [2, 8], "relax": "none"}'
    yield '{"count": 3, "count": 4}'
    yield '{"array": {"array": [[[{}]]]}}'


SEEDS = {"off": off_seeds, "obj": obj_seeds, "ply": ply_seeds, "stl": stl_seeds, "vtp": vtp_seeds, "vtu": vtu_seeds,
         "vtk": vtk_seeds, "glb": glb_seeds, "gltf": gltf_seeds, "gii": gii_seeds, "mni": mni_seeds, "fs": fs_seeds, "values": value_seeds, "generators": generator_seeds,
         "calls": call_seeds, "config": config_seeds}


def main():
    for target, seeds in SEEDS.items():
        folder = pathlib.Path(sys.argv[1]) / target
        folder.mkdir(parents=True, exist_ok=True)
        for number, content in enumerate(seeds()):
            content = content if isinstance(content, bytes) else content.encode()
            (folder / f"seed-{number:02}").write_bytes(content)
            if number == 0 and target not in ("generators", "values", "calls", "config"):
                (folder / "seed-packed").write_bytes(gzip.compress(content, mtime=0))


if __name__ == "__main__":
    main()
