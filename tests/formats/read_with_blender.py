"""Blender reads what the commands write, run by it: ... --python read_with_blender.py -- WORK_FOLDER."""
import json
import pathlib
import sys

import bpy
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import files  # noqa: E402  Blender's Python does not look beside the script

work = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
diagram = json.loads((work / "whole.json").read_text())
points, faces = files.make_sheet()
# Debian 12's Blender uses a name that its NumPy does not have any more.
if "bool" not in dir(numpy):
    numpy.bool = bool


def load(name, *importers):
    """The meshes of a file, by the first of the importers that this version of Blender has."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    for area, operator in importers:
        if operator in dir(getattr(bpy.ops, area)):
            getattr(getattr(bpy.ops, area), operator)(filepath=str(work / name))
            return [o.data for o in bpy.context.scene.objects if o.type == "MESH"]
    raise AssertionError(f"no importer for {name}")


def check_ply():
    (mesh,) = load("whole.ply", ("wm", "ply_import"), ("import_mesh", "ply"))
    assert (len(mesh.vertices), len(mesh.polygons)) == (len(points), len(faces))
    assert len(mesh.color_attributes) == 1, "no colours"
    assert len({tuple(c.color) for c in mesh.color_attributes[0].data}) == len(files.GENERATORS) + 1


def check_obj():
    meshes = load("whole.obj", ("wm", "obj_import"), ("import_scene", "obj"))
    assert sum(len(m.polygons) for m in meshes) == len(faces)
    of_faces = sum(len({tuple(sorted(k)) for p in m.polygons for k in p.edge_keys}) for m in meshes)
    assert sum(len(m.edges) for m in meshes) == of_faces + files.segments(diagram)


def check_glb():
    meshes = load("whole.glb", ("import_scene", "gltf"))
    assert sum(len(m.polygons) for m in meshes) == len(faces)
    assert sum(len(m.edges) for m in meshes if not m.polygons) == files.segments(diagram)


check_ply()
check_obj()
check_glb()
