"""The commands read what VTK and meshio write: write_with_vtk.py BIN_FOLDER WORK_FOLDER. VTK 9.1 writes no GLB.

Every file holds the sheet of files.py, some with triangles as strips or quads, or with lines beside them.
"""
import gzip
import json
import pathlib
import subprocess
import sys

import files
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkPolyDataNormals, vtkStripper
from vtkmodules.vtkIOExport import vtkGLTFExporter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkUnstructuredGridWriter
from vtkmodules.vtkIOMINC import vtkMNIObjectWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

work = pathlib.Path(sys.argv[2])
work.mkdir(parents=True, exist_ok=True)
segment = pathlib.Path(sys.argv[1]) / "gvd-segment"
points, faces = files.make_sheet()


def make_polydata(with_line):
    data = vtkPolyData()
    held = vtkPoints()
    held.SetDataTypeToDouble()
    extra = [(0.0, 0.0, 200.0), (1.0, 0.0, 200.0)] if with_line else []
    held.SetData(numpy_to_vtk(numpy.array(points + extra), deep=True))
    data.SetPoints(held)
    cells = numpy.hstack([numpy.full((len(faces), 1), 3), numpy.array(faces)]).astype(numpy.int64).ravel()
    polys = vtkCellArray()
    polys.SetCells(len(faces), numpy_to_vtkIdTypeArray(cells, deep=True))
    data.SetPolys(polys)
    if with_line:
        lines = vtkCellArray()
        lines.InsertNextCell(2, [len(points), len(points) + 1])
        data.SetLines(lines)
    height = numpy_to_vtk(numpy.array([p[2] for p in points + extra]), deep=True)
    height.SetName("height")
    data.GetPointData().SetScalars(height)
    return data


def write(writer, name, data, **settings):
    for setting, value in settings.items():
        getattr(writer, setting)(*(value if isinstance(value, tuple) else (value,)))
    writer.SetFileName(str(work / name))
    writer.SetInputData(data)
    assert writer.Write() == 1, name
    return name


def check(name, within=0.0):
    """The mesh of a file, as the command writes it again, has the sheet's vertices and faces."""
    report, out = work / "report.json", work / "again.off"
    run = subprocess.run([segment, work / name, "-n", "1", "-q", "--on-defect", "repair", "--report", report, "-o", out],
                         capture_output=True, text=True)
    assert run.returncode == 0, (name, run.stderr)
    summary = json.loads(report.read_text())["input"]
    assert (summary["vertices"], summary["faces"]) == (len(points), len(faces)), (name, summary)
    assert (summary["components"], summary["boundary_loops"]) == (2, 2), (name, summary)
    lines = out.read_text().split("\n")[2 : 2 + len(points)]
    found = numpy.array([[float(word) for word in line.split()[:3]] for line in lines])
    assert numpy.abs(found - numpy.array(points)).max() <= within, name


def refuse(name, part):
    run = subprocess.run([segment, work / name, "-n", "1", "-q"], capture_output=True, text=True)
    assert run.returncode == 3 and part in run.stderr and run.stderr.count("\n") == 1, (name, run)


for with_line in (False, True):
    data = make_polydata(with_line)
    for mode in ("Ascii", "Binary", "Appended"):
        for compressor in ("None", "ZLib"):
            for words in ("UInt32", "UInt64"):
                for order in ("SetByteOrderToLittleEndian", "SetByteOrderToBigEndian"):
                    writer = vtkXMLPolyDataWriter()
                    getattr(writer, f"SetDataModeTo{mode}")()
                    getattr(writer, f"SetCompressorTypeTo{compressor}")()
                    getattr(writer, f"SetHeaderTypeTo{words}")()
                    getattr(writer, order)()
                    writer.SetBlockSize(1024)
                    for encoded in (0, 1) if mode == "Appended" else (0,):
                        writer.SetEncodeAppendedData(encoded)
                        check(write(writer, "sheet.vtp", data))
    for version in (42, 51):
        for binary in (False, True):
            writer = vtkPolyDataWriter()
            writer.SetFileVersion(version)
            writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
            check(write(writer, "sheet.vtk", data), 0 if binary else 1e-8)  # text has 11 digits

data = make_polydata(False)
writer = vtkXMLPolyDataWriter()
writer.SetCompressorTypeToLZ4()
refuse(write(writer, "lz4.vtp", data), "vtkLZ4DataCompressor")

stripper = vtkStripper()
stripper.SetInputData(data)
stripper.Update()
check(write(vtkXMLPolyDataWriter(), "strips.vtp", stripper.GetOutput()))
check(write(vtkPolyDataWriter(), "strips.vtk", stripper.GetOutput()), 1e-8)

grid = vtkAppendFilter()
grid.AddInputData(data)
grid.Update()
for version in (42, 51):
    writer = vtkUnstructuredGridWriter()
    writer.SetFileVersion(version)
    writer.SetFileTypeToBinary()
    check(write(writer, "grid.vtk", grid.GetOutput()))
for mode in ("Ascii", "Binary", "Appended"):
    for compressor in ("None", "ZLib"):
        writer = vtkXMLUnstructuredGridWriter()
        getattr(writer, f"SetDataModeTo{mode}")()
        getattr(writer, f"SetCompressorTypeTo{compressor}")()
        for encoded in (0, 1) if mode == "Appended" else (0,):
            writer.SetEncodeAppendedData(encoded)
            check(write(writer, "grid.vtu", grid.GetOutput()))

mapper, actor, renderer, window = vtkPolyDataMapper(), vtkActor(), vtkRenderer(), vtkRenderWindow()
mapper.SetInputData(data)
actor.SetMapper(mapper)
renderer.AddActor(actor)
window.AddRenderer(renderer)
for inline in (0, 1):  # the numbers in files beside it, or in it
    exporter = vtkGLTFExporter()
    exporter.SetRenderWindow(window)
    exporter.SetFileName(str(work / "scene.gltf"))
    exporter.SetInlineData(inline)
    exporter.Write()
    check("scene.gltf", 1e-5)

normals = vtkPolyDataNormals()
normals.SetInputData(data)
normals.SplittingOff()
normals.ConsistencyOff()
normals.Update()
writer = vtkMNIObjectWriter()
check(write(writer, "surface.obj", normals.GetOutput()), 1e-3)  # six digits
writer.SetFileTypeToBinary()
refuse(write(writer, "binary.obj", normals.GetOutput()), "a binary object of MNI")

for name in ("sheet.vtk", "sheet.vtp"):
    (work / f"{name}.gz").write_bytes(gzip.compress((work / name).read_bytes()))
    check(f"{name}.gz")

try:
    import meshio
except ImportError:
    meshio = None
if meshio is not None:
    mesh = meshio.Mesh(numpy.array(points), [("triangle", numpy.array(faces))])
    for version in ("42", "51"):
        for binary in (False, True):
            meshio.write(work / "meshio.vtk", mesh, file_format=f"vtk{version}", binary=binary)
            check("meshio.vtk", 1e-9)
    for binary in (False, True):
        for compression in ("zlib", None):
            meshio.write(work / "meshio.vtu", mesh, binary=binary, compression=compression)
            check("meshio.vtu", 0 if binary else 1e-8)
