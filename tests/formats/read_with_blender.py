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
palette = files.palette(work)
# Debian 12's Blender uses a name that its NumPy does not have any more.
if "bool" not in dir(numpy):
    numpy.bool = bool


def load(name, *importers):
    """The meshes of a file by the names of their objects, by the first of the importers that this Blender has."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    for area, operator in importers:
        if operator in dir(getattr(bpy.ops, area)):
            getattr(getattr(bpy.ops, area), operator)(filepath=str(work / name))
            return {o.name: o.data for o in bpy.context.scene.objects if o.type == "MESH"}
    raise AssertionError(f"no importer for {name}")


def check_ply():
    (mesh,) = load("whole.ply", ("wm", "ply_import"), ("import_mesh", "ply")).values()
    assert (len(mesh.vertices), len(mesh.polygons)) == (len(points), len(faces))
    assert len(mesh.color_attributes) == 1, "no colours"
    assert len({tuple(c.color) for c in mesh.color_attributes[0].data}) == len(set(palette.values()))


def check_obj():
    """The bisectors are an object of their own, and materials have the colours of the regions."""
    meshes = load("whole.obj", ("wm", "obj_import"), ("import_scene", "obj"))
    assert sorted(meshes) == ["bisectors", "whole"], sorted(meshes)
    surface, lines = meshes["whole"], meshes["bisectors"]
    assert len(surface.polygons) == len(faces)
    assert len(surface.edges) == len({tuple(sorted(k)) for p in surface.polygons for k in p.edge_keys}), "loose edges"
    assert (len(lines.polygons), len(lines.edges)) == (0, files.segments(diagram))
    for material in surface.materials:
        (shader,) = [n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED"]
        color = tuple(files.srgb(c) for c in list(shader.inputs["Base Color"].default_value)[:3])
        label = -1 if material.name == "unlabelled" else int(material.name.removeprefix("region_"))
        assert color == palette[label], f"{material.name} is shown as {color} instead of {palette[label]}"


def check_glb():
    """The surface is one mesh with the colours of the regions, which its material shows."""
    meshes = load("whole.glb", ("import_scene", "gltf"))
    surface, lines = meshes["surface"], meshes["bisectors"]
    assert len(meshes) == 2 and len(surface.polygons) == len(faces)
    assert (len(lines.polygons), len(lines.edges)) == (0, files.segments(diagram))
    (attribute,) = surface.color_attributes
    of_corners = [tuple(round(255 * c) for c in list(d.color_srgb)[:3]) for d in attribute.data]
    # Blender keeps the order of the faces and of their corners.
    of_labels = [label for label in diagram["face_labels"] for _ in range(3)]
    assert files.one_color_each(of_labels, of_corners) == palette
    (material,) = surface.materials
    assert any(link.from_node.type == "VERTEX_COLOR" and link.to_socket.name == "Base Color"
               for link in material.node_tree.links), "the material does not show the colours"


check_ply()
check_obj()
check_glb()
