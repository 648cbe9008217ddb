"""VTK reads what the commands write: read_with_vtk.py BIN_FOLDER WORK_FOLDER."""
import pathlib
import sys

import files
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

work = pathlib.Path(sys.argv[2])
diagram, points, faces = files.write_files(sys.argv[1], work)
labels = numpy.array(diagram["face_labels"])
vertex_labels = numpy.array(diagram["vertex_labels"])
distances = numpy.array(files.unnull(diagram["vertex_distances"]))


def read(reader, name):
    reader.SetFileName(str(work / name))
    reader.Update()
    return reader.GetOutput()


def array(data, name):
    values = data.GetArray(name)
    assert values is not None, f"there is no array {name}"
    return vtk_to_numpy(values)


def colors_by_label(colors, of_labels):
    """The one colour of each label."""
    assert colors.shape == (len(of_labels), 3)
    found = {label: {tuple(c) for c in colors[of_labels == label]} for label in set(of_labels)}
    assert all(len(c) == 1 for c in found.values()), found
    return {label: c.pop() for label, c in found.items()}


def check_ply(name):
    mesh = read(vtkPLYReader(), name)
    assert (mesh.GetNumberOfPoints(), mesh.GetNumberOfCells()) == (len(points), len(faces))
    assert (array(mesh.GetCellData(), "intensity") == labels % 256).all()
    of_faces = colors_by_label(array(mesh.GetCellData(), "RGB"), labels)
    of_vertices = colors_by_label(array(mesh.GetPointData(), "RGB"), vertex_labels)
    assert of_faces == of_vertices == files.palette(work)


def check_vtp():
    mesh = read(vtkXMLPolyDataReader(), "whole.vtp")
    lines = len(diagram["bisectors"])
    assert (mesh.GetNumberOfLines(), mesh.GetNumberOfPolys()) == (lines, len(faces))
    cells = mesh.GetCellData()
    assert (array(cells, "Label") == numpy.concatenate([numpy.full(lines, -1), labels])).all()
    assert list(array(cells, "Left")[:lines]) == [b["left"] for b in diagram["bisectors"]]
    assert list(array(cells, "Right")[:lines]) == [b["right"] for b in diagram["bisectors"]]
    assert (vtk_to_numpy(mesh.GetPoints().GetData())[: len(points)] == numpy.array(points)).all()
    assert (array(mesh.GetPointData(), "Distance")[: len(points)] == distances).all()
    assert (array(mesh.GetPointData(), "Label")[: len(points)] == vertex_labels).all()
    plain = read(vtkXMLPolyDataReader(), "plain.vtp")
    assert (plain.GetNumberOfLines(), plain.GetNumberOfPoints()) == (0, len(points))
    assert plain.GetCellData().GetArray("Left") is None


def check_vtu():
    mesh = read(vtkXMLUnstructuredGridReader(), "whole.vtu")
    lines = files.segments(diagram)
    assert mesh.GetNumberOfCells() == len(faces) + lines
    types = [mesh.GetCellType(i) for i in range(mesh.GetNumberOfCells())]
    assert types == [5] * len(faces) + [3] * lines
    cells = mesh.GetCellData()
    assert (array(cells, "Label") == numpy.concatenate([labels, numpy.full(lines, -1)])).all()
    pieces = [b for b in diagram["bisectors"] for _ in range(len(b["points"]) - (0 if b["closed"] else 1))]
    assert list(array(cells, "Left")[len(faces) :]) == [b["left"] for b in pieces]
    assert list(array(cells, "Right")[len(faces) :]) == [b["right"] for b in pieces]
    assert (vtk_to_numpy(mesh.GetPoints().GetData())[: len(points)] == numpy.array(points)).all()
    assert (array(mesh.GetPointData(), "Distance")[: len(points)] == distances).all()
    length = sum(
        numpy.linalg.norm(numpy.array(mesh.GetPoint(ids.GetId(0))) - numpy.array(mesh.GetPoint(ids.GetId(1))))
        for ids in (mesh.GetCell(i).GetPointIds() for i in range(len(faces), mesh.GetNumberOfCells())))
    assert abs(length - polyline_length()) < 1e-9 * length
    plain = read(vtkXMLUnstructuredGridReader(), "plain.vtu")
    assert (plain.GetNumberOfCells(), plain.GetNumberOfPoints()) == (len(faces), len(points))


def polyline_length():
    total = 0
    for bisector in diagram["bisectors"]:
        p = numpy.array([point["position"] for point in bisector["points"]])
        p = numpy.vstack([p, p[:1]]) if bisector["closed"] else p
        total += numpy.linalg.norm(numpy.diff(p, axis=0), axis=1).sum()
    return total


def check_obj():
    mesh = read(vtkOBJReader(), "whole.obj")
    assert (mesh.GetNumberOfLines(), mesh.GetNumberOfPolys()) == (files.segments(diagram), len(faces))
    assert vtk_to_numpy(mesh.GetLines().GetOffsetsArray())[-1] == 2 * files.segments(diagram)
    plain = read(vtkOBJReader(), "plain.obj")
    assert (plain.GetNumberOfLines(), plain.GetNumberOfPolys()) == (0, len(faces))


def leaves(data):
    """The data sets of a multi-block."""
    for i in range(data.GetNumberOfBlocks()):
        block = data.GetBlock(i)
        if block is None:
            continue
        if hasattr(block, "GetNumberOfBlocks"):
            yield from leaves(block)
        else:
            yield block


def check_glb():
    blocks = list(leaves(read(vtkGLTFReader(), "whole.glb")))
    (surface,) = [b for b in blocks if b.GetNumberOfPolys() > 0]
    assert surface.GetNumberOfPoints() == files.region_vertices(diagram["face_labels"], faces)
    data = surface.GetPointData()
    normals = vtk_to_numpy(data.GetNormals() or data.GetArray("NORMAL"))
    assert numpy.abs(numpy.linalg.norm(normals, axis=1) - 1).max() < 1e-5 and (normals[:, 2] > 0.8).all()
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    of_corners = array(data, "_LABEL")[corners]
    assert (of_corners == labels[:, None]).all(), "the corners of each face have its label"
    colors = [tuple(files.srgb(c) for c in color) for color in array(data, "COLOR_0").tolist()]
    assert files.one_color_each(array(data, "_LABEL").astype(int).tolist(), colors) == files.palette(work)
    assert sum(b.GetNumberOfLines() for b in blocks) == files.segments(diagram)
    assert sum(b.GetNumberOfLines() for b in leaves(read(vtkGLTFReader(), "plain.glb"))) == 0


def check_cut():
    mesh = read(vtkXMLPolyDataReader(), "cut.vtp")
    cut = files.json.loads((work / "cut.json").read_text())["cut_mesh"]
    vertices = len(cut["vertices"])
    assert vertices > len(points)
    assert (array(mesh.GetPointData(), "Distance")[:vertices] == numpy.array(files.unnull(cut["vertex_distances"]))).all()
    assert (array(mesh.GetPointData(), "Label")[:vertices] == numpy.array(cut["vertex_labels"])).all()
    assert list(array(mesh.GetCellData(), "Parent")[-len(cut["faces"]) :]) == cut["parents"]


check_ply("whole.ply")
check_ply("text.ply")
check_vtp()
check_vtu()
check_obj()
assert read(vtkSTLReader(), "whole.stl").GetNumberOfCells() == len(faces)
check_glb()
check_cut()
