"""What programs keep of each format, as the table of the notes says: check_readers.py BIN_FOLDER WORK_FOLDER [--write].

Each program that is installed reads the files of files.py. What it holds then is compared with the diagram, and the rows with
those of docs/notes/readers.md; --write puts them there. Rows of programs that are missing stay.
"""
import dataclasses
import json
import pathlib
import shutil
import subprocess
import sys

import files
import numpy

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "docs" / "notes" / "readers.md"
BEGIN, END = "<!-- what programs keep: begin -->\n", "<!-- what programs keep: end -->\n"
HEAD = ["program", "format", "coordinates", "order of faces", "labels of faces", "labels of vertices", "distances", "colours", "bisectors", "texture"]
FORMATS = [".ply", ".ply (text)", ".obj", ".off", ".coff as .off", ".stl", ".vtp", ".vtu", ".glb"]


# Cut meshes with texture coordinates, without and with a seam.
PAINTED = {".ply": "{}.ply", ".ply (text)": "{}_text.ply", ".obj": "{}.obj", ".glb": "{}.glb"}


def file_of(name):
    return {".ply (text)": "text.ply", ".coff as .off": "colored.off"}.get(name, f"whole{name}")


@dataclasses.dataclass
class Content:
    """What a program holds of a file. Arrays have a row for each face or point, colours are 0 to 255 in sRGB."""
    points: numpy.ndarray
    faces: numpy.ndarray
    face_arrays: dict = dataclasses.field(default_factory=dict)
    point_arrays: dict = dataclasses.field(default_factory=dict)
    corner_colors: numpy.ndarray = None  # (faces, 3, 3)
    face_colors: numpy.ndarray = None
    point_colors: numpy.ndarray = None
    corner_texture: numpy.ndarray = None  # (faces, 3, 2)
    segments: int = 0


class Truth:
    def __init__(self, diagram, points, faces, work):
        self.points, self.faces = numpy.array(points), numpy.array(faces)
        self.labels = numpy.array(diagram["face_labels"])
        self.vertex_labels = numpy.array(diagram["vertex_labels"])
        self.distances = numpy.array(files.unnull(diagram["vertex_distances"]))
        self.segments = files.segments(diagram)
        self.palette = files.palette(work)
        self.corners = self.points[self.faces]

    def find_points(self, content):
        """The vertex at each point."""
        distances = numpy.linalg.norm(content.points[:, None] - self.points[None], axis=2)
        return distances.argmin(axis=1)

    def find_faces(self, content):
        """The number of each face of the content, by its corners; none where they are not those of the sheet."""
        def turned(face):
            least = face.index(min(face))
            return (*face[least:], *face[:least])
        known = {turned(face): f for f, face in enumerate(self.faces.tolist())}
        return [known.get(turned(face)) for face in self.find_points(content)[content.faces].tolist()]

    def colors(self, labels):
        return numpy.array([self.palette[label] for label in labels.tolist()])


def same(values, wanted):
    values = numpy.asarray(values)
    return values.shape == wanted.shape and bool((values == wanted).all())


def same_parts(values, wanted):
    """Whether there is one value for each of the wanted ones."""
    pairs = set(zip(numpy.asarray(values).tolist(), wanted.tolist())) if numpy.ndim(values) == 1 else ()
    return len(pairs) == len({a for a, _ in pairs}) == len(set(wanted.tolist()))


def first(candidates):
    return next((name for name, holds in candidates if holds), "")


def describe(truth, content, lost_bits=0):
    """The cells of a row behind program and format. `lost_bits`: of each channel of a colour, that the format lacks."""
    order = truth.find_faces(content)
    if sorted(f for f in order if f is not None) != list(range(len(truth.faces))):
        return ["other faces"] + [""] * 6
    corners = content.points[content.faces]
    exact = same(corners, truth.corners[order])
    labels, at = truth.labels[order], truth.find_points(content)
    used = numpy.unique(content.faces)  # not those of lines
    corner_values = lambda values: numpy.asarray(values)[content.faces]
    float_distances = truth.distances.astype(numpy.float32)
    of_faces = [(f"`{n}`", same(v, labels)) for n, v in content.face_arrays.items()]
    of_faces += [(f"`{n}`, low byte", same(v, labels % 256)) for n, v in content.face_arrays.items()]
    of_faces += [(f"`{n}`, other numbers", same_parts(v, labels)) for n, v in content.face_arrays.items()]
    of_faces += [(f"`{n}` of corners", same(corner_values(v), numpy.repeat(labels[:, None], 3, 1))) for n, v in content.point_arrays.items()]
    of_points = [(f"`{n}`", same(numpy.asarray(v)[used], truth.vertex_labels[at[used]])) for n, v in content.point_arrays.items()]
    distances = [(f"`{n}`", same(numpy.asarray(v)[used], truth.distances[at[used]])) for n, v in content.point_arrays.items()]
    distances += [(f"`{n}`, floats", same(numpy.asarray(v)[used].astype(numpy.float32), float_distances[at[used]]))
                  for n, v in content.point_arrays.items()]
    of_region = numpy.repeat(truth.colors(labels)[:, None], 3, 1)
    of_vertex = truth.colors(truth.vertex_labels)[at]
    held_colors = [(content.face_colors, truth.colors(labels), "faces"), (content.corner_colors, of_region, "faces"),
                   (content.corner_colors, of_vertex[content.faces], "vertices")]
    if content.point_colors is not None:
        held_colors += [(content.point_colors[content.faces], of_region, "faces"), (content.point_colors[used], of_vertex[used], "vertices")]
    colors = [(kind, found is not None and same(found >> lost_bits, wanted >> lost_bits)) for found, wanted, kind in held_colors]
    held = list(dict.fromkeys(name for name, holds in colors if holds))
    return ["doubles" if exact else "floats", "kept" if order == sorted(order) else "by region", first(of_faces), first(of_points),
            first(distances), " and ".join(held), "lines" if content.segments == truth.segments else ""]


def keeps_texture(content):
    """Whether a program has the texture coordinates of the corners, in arrays of points or of its own."""
    of_points = content.point_arrays
    found = [numpy.asarray(v) for v in of_points.values() if numpy.ndim(v) == 2 and numpy.shape(v)[1] == 2]
    found += [numpy.stack([of_points["s"], of_points["t"]], 1)] if "s" in of_points else []
    held = [v[content.faces] for v in found if len(v) == len(content.points)]
    held += [content.corner_texture] if content.corner_texture is not None else []
    corners = content.points[content.faces]
    for seam in (False, True):
        right = (corners[:, :, 0].mean(1) > 2) & seam
        wanted = numpy.array([[files.texture(x, y, r) for x, y, _ in face] for face, r in zip(corners, right)])
        downwards = wanted * (1, -1) + (0, 1)  # as glTF has it
        if any(numpy.abs(v - w).max() < 1e-5 for v in held for w in (wanted, downwards)):
            return True
    return False


def describe_texture(reader, work, extension):
    """The last cell of a row."""
    kept = []
    for name in ("painted", "seam"):
        try:
            kept.append(keeps_texture(reader(work / PAINTED[extension].format(name))))
        except (Exception, SystemExit):  # as in `measure`; a format without texture coordinates, too
            kept.append(False)
    return {(True, True): "kept", (True, False): "without seams", (False, True): "with seams", (False, False): ""}[tuple(kept)]


def read_vtk(path):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkSTLReader
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
    readers = {".ply": vtkPLYReader, ".obj": vtkOBJReader, ".stl": vtkSTLReader, ".vtp": vtkXMLPolyDataReader,
               ".vtu": vtkXMLUnstructuredGridReader, ".glb": vtkGLTFReader}
    reader = readers[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()

    def leaves(data):
        if not hasattr(data, "GetNumberOfBlocks"):
            yield data
            return
        for i in range(data.GetNumberOfBlocks()):
            if data.GetBlock(i) is not None:
                yield from leaves(data.GetBlock(i))

    segments, surface = 0, None
    for data in leaves(reader.GetOutput()):
        triangles = []
        for i in range(data.GetNumberOfCells()):
            cell = data.GetCell(i)
            if cell.GetNumberOfPoints() == 3 and cell.GetCellType() == 5:
                triangles.append((i, [cell.GetPointId(k) for k in range(3)]))
            elif cell.GetCellType() in (3, 4):
                segments += cell.GetNumberOfPoints() - 1
        if triangles:
            surface = (data, triangles)
    data, triangles = surface
    cells = [i for i, _ in triangles]

    def arrays(of, rows):
        found = {of.GetArrayName(k): vtk_to_numpy(of.GetArray(k)) for k in range(of.GetNumberOfArrays())}
        return {name: values if len(values) == len(rows) else values[rows] for name, values in found.items()}

    points = vtk_to_numpy(data.GetPoints().GetData())
    content = Content(points, numpy.array([f for _, f in triangles]), arrays(data.GetCellData(), cells),
                      arrays(data.GetPointData(), range(len(points))), segments=segments)
    content.face_colors, content.point_colors = content.face_arrays.pop("RGB", None), content.point_arrays.pop("RGB", None)
    if path.suffix == ".obj":  # an array for each material, -1 where another one has the numbers
        pairs = [content.point_arrays.pop(n) for n, v in list(content.point_arrays.items()) if v.ndim == 2 and v.shape[1] == 2]
        content.point_arrays.update({"of each material": numpy.max(pairs, axis=0)} if pairs else {})
    if "COLOR_0" in content.point_arrays:
        content.point_colors = numpy.vectorize(files.srgb)(content.point_arrays.pop("COLOR_0"))
    return content


def read_meshio(path):
    import meshio
    mesh = meshio.read(path)
    blocks = [i for i, block in enumerate(mesh.cells) if block.type == "triangle"]
    faces = numpy.concatenate([mesh.cells[i].data for i in blocks])
    arrays = {n: numpy.concatenate([numpy.asarray(v[i]) for i in blocks]) for n, v in mesh.cell_data.items()}
    segments = sum(len(block.data) for block in mesh.cells if block.type == "line")
    content = Content(mesh.points, faces, arrays, dict(mesh.point_data), segments=segments)
    colors = lambda of: numpy.stack([of[c] for c in ("red", "green", "blue")], 1) if "red" in of else None
    content.face_colors, content.point_colors = colors(arrays), colors(mesh.point_data)
    return content


def read_open3d(path):
    import open3d
    open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Error)
    mesh = open3d.io.read_triangle_mesh(str(path))
    if not mesh.has_triangles():
        raise ValueError("no triangles")
    materials = {"triangle_material_ids": numpy.asarray(mesh.triangle_material_ids)} if mesh.has_triangle_material_ids() else {}
    content = Content(numpy.asarray(mesh.vertices), numpy.asarray(mesh.triangles), materials)
    if mesh.has_triangle_uvs():
        content.corner_texture = numpy.asarray(mesh.triangle_uvs).reshape(-1, 3, 2)
    if mesh.has_vertex_colors():
        colors = numpy.asarray(mesh.vertex_colors)
        content.point_colors = numpy.vectorize(files.srgb)(colors) if path.suffix == ".glb" else numpy.rint(255 * colors).astype(int)
    return content


def read_nibabel(path):
    import nibabel
    nibabel.load(path)
    raise AssertionError("nibabel reads it: say in this file what it keeps")


def read_meshlab(path):
    """By MeshLab's server, which writes what it holds as PLY, in text with seven digits."""
    out = path.parent / f"meshlab-{path.name}.ply"
    out.unlink(missing_ok=True)
    subprocess.run(["xvfb-run", "-a", "meshlabserver", "-i", path, "-o", out, "-m", "vc", "fc", "wt", "sa"], cwd=path.parent, check=True,
                   capture_output=True, timeout=60)
    head, body = out.read_text().split("end_header\n")
    counts = [int(line.split()[-1]) for line in head.splitlines() if line.startswith("element")]
    rows = [line.split() for line in body.splitlines()]
    vertices, triangles = rows[: counts[0]], rows[counts[0] : sum(counts)]
    properties = [[line.split()[-1] for line in part.splitlines() if line.startswith("property")] for part in head.split("element face")]

    texture = None
    if "texcoord" in properties[1]:  # behind the corners
        texture = numpy.array([row[5:11] for row in triangles], float).reshape(-1, 3, 2)
        properties[1].remove("texcoord")
        for row in triangles:
            del row[4:11]

    def colors(table, names, extra):
        return numpy.array([[int(row[names.index(c) + extra]) for c in ("red", "green", "blue")] for row in table]) if "red" in names else None

    return Content(numpy.array([row[:3] for row in vertices], float), numpy.array([row[1:4] for row in triangles], int),
                   face_colors=colors(triangles, properties[1], 3), point_colors=colors(vertices, properties[0], 0), corner_texture=texture)


class Blender:
    """Reads all files at once: a script inside it leaves what it holds in a file."""

    def __init__(self, work):
        subprocess.run(["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python",
                        str(HERE / "read_into_blender.py"), "--", str(work)], check=True, capture_output=True, timeout=120)
        self.held = json.loads((work / "blender.json").read_text())

    def __call__(self, path):
        held = self.held[path.name]
        arrays = {"materials": numpy.array(held["materials"])} if held["materials"] else {}
        content = Content(numpy.array(held["points"]), numpy.array(held["faces"]), arrays, {}, segments=held["segments"])
        if held["corner_texture"]:
            content.corner_texture = numpy.array(held["corner_texture"])
        if held["corner_colors"]:
            content.corner_colors = numpy.array(held["corner_colors"])
        if held["point_colors"]:
            content.point_colors = numpy.array(held["point_colors"])
        return content


def readers(work):
    """Name, version and function of each program that is installed."""
    def module(name, reader, label):
        try:
            version = __import__(name).__version__
        except ImportError:
            return None
        return label, ".".join(version.split(".")[:2]), reader

    def vtk():
        from vtkmodules.vtkCommonCore import vtkVersion
        return "VTK", ".".join(vtkVersion.GetVTKVersion().split(".")[:2]), read_vtk

    def command(name, label, make):
        if shutil.which(name) is None:
            return None
        version = subprocess.run(["dpkg-query", "-W", "-f=${Version}", label.lower()], capture_output=True, text=True).stdout
        return label, ".".join(version.split("+")[0].split(".")[:2]), make()

    try:
        yield vtk()
    except ImportError:
        pass
    yield module("meshio", read_meshio, "meshio")
    yield module("open3d", read_open3d, "Open3D")
    yield command("blender", "Blender", lambda: Blender(work))
    if shutil.which("xvfb-run"):  # it needs a display
        yield command("meshlabserver", "MeshLab", lambda: read_meshlab)
    yield module("nibabel", read_nibabel, "nibabel")


def measure(work, truth):
    """The lines of the table for each program that is installed."""
    lines = {}
    for name, version, reader in filter(None, readers(work)):
        rows, unread = [], []
        for extension in FORMATS:
            try:
                rows.append([extension, *describe(truth, reader(work / file_of(extension)), 3 if extension == ".stl" else 0),
                             describe_texture(reader, work, extension)])
            except AssertionError:
                raise
            except (Exception, SystemExit):  # whatever a reader raises, and meshio ends: it does not read the format
                unread.append(extension)
        lines[name] = [" | ".join([f"| {name} {version}", *row]) + " |" for row in rows]
        if unread:
            cells = " | ".join([", ".join(unread), "not read"] + [""] * 7)
            lines[name].append(f"| {name} {version} | {cells} |")
    return lines


def table_lines(text):
    return [line for line in text.splitlines() if line.startswith("| ") and not line.startswith("| program")]


def program_of(line):
    return line.split()[1]


def main():
    work = pathlib.Path(sys.argv[2])
    truth = Truth(*files.write_files(sys.argv[1], work), work)
    shutil.copy(work / "whole.coff", work / "colored.off")  # its readers go by the name
    measured = measure(work, truth)
    if not measured:
        print("skipped: none of the programs is installed")
        sys.exit(77)
    before, rest = PAGE.read_text().split(BEGIN)
    table, after = rest.split(END)
    documented = table_lines(table)
    if "--write" in sys.argv:
        names = list(dict.fromkeys([*measured, *map(program_of, documented)]))
        lines = [line for n in names for line in measured.get(n, [d for d in documented if program_of(d) == n])]
        head = [" | ".join(HEAD).join(["| ", " |"]), "|" + "---|" * len(HEAD)]
        PAGE.write_text(before + BEGIN + "\n".join(head + lines) + "\n" + END + after)
        return
    for name, lines in measured.items():
        said = [line.split("|", 2)[2] for line in documented if program_of(line) == name]
        found = [line.split("|", 2)[2] for line in lines]
        assert said == found, f"{name}: the table says\n" + "\n".join(said) + "\nand it keeps\n" + "\n".join(found)
    print("compared with the table:", ", ".join(measured))
    missing = {program_of(line) for line in documented} - set(measured)
    if missing:
        print("not installed:", ", ".join(sorted(missing)))


main()
