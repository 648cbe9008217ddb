"""meshio reads what the commands write: read_with_meshio.py BIN_FOLDER WORK_FOLDER."""
import json
import pathlib
import sys

import files
import meshio
import numpy

work = pathlib.Path(sys.argv[2])
diagram, points, faces = files.write_files(sys.argv[1], work)


def check_labels(name, vertices, triangles, labels, vertex_labels, distances):
    mesh = meshio.read(work / name)
    assert (mesh.points == numpy.array(vertices)).all(), "positions are not the same doubles"
    assert [block.type for block in mesh.cells] == ["triangle"]
    assert (mesh.cells[0].data == numpy.array(triangles)).all()
    assert list(mesh.cell_data["label"][0]) == labels
    assert list(mesh.point_data["label"]) == vertex_labels
    assert (mesh.point_data["distance"] == numpy.array(files.unnull(distances), dtype=numpy.float32)).all()
    return mesh


def check_vtu(name, vertices, triangles, labels, vertex_labels, distances):
    mesh = meshio.read(work / name)
    assert [block.type for block in mesh.cells] == ["triangle", "line"]
    count = len(vertices)
    assert (mesh.points[:count] == numpy.array(vertices)).all(), "positions are not the same doubles"
    assert (mesh.cells[0].data == numpy.array(triangles)).all()
    assert mesh.cell_data["Label"][0].tolist() == labels
    assert mesh.point_data["Label"][:count].tolist() == vertex_labels
    assert mesh.point_data["Distance"][:count].tolist() == files.unnull(distances), "distances are not the same doubles"
    assert len(mesh.cells[1].data) == files.segments(diagram)
    return mesh


def check_obj():
    """The groups are the regions, in the order of their labels."""
    mesh = meshio.read(work / "whole.obj")
    counts = [(numpy.array(diagram["face_labels"]) == label).sum() for label in range(len(files.GENERATORS))]
    counts.append(diagram["face_labels"].count(-1))
    assert [len(block.data) for block in mesh.cells] == counts
    assert (mesh.points[: len(points)] == numpy.array(points)).all()


cut = json.loads((work / "cut.json").read_text())["cut_mesh"]
check_labels("text.ply", points, faces, diagram["face_labels"], diagram["vertex_labels"], diagram["vertex_distances"])
parts = check_labels("cut.ply", cut["vertices"], cut["faces"], cut["labels"], cut["vertex_labels"], cut["vertex_distances"])
assert list(parts.cell_data["parent"][0]) == cut["parents"]
check_obj()
check_vtu("whole.vtu", points, faces, diagram["face_labels"], diagram["vertex_labels"], diagram["vertex_distances"])
parts = check_vtu("cut.vtu", cut["vertices"], cut["faces"], cut["labels"], cut["vertex_labels"], cut["vertex_distances"])
assert parts.cell_data["Parent"][0].tolist() == cut["parents"]
plain = meshio.read(work / "whole.off")
assert (plain.points == numpy.array(points)).all() and (plain.cells[0].data == numpy.array(faces)).all()
assert len(meshio.read(work / "whole.stl").cells[0].data) == len(faces)
