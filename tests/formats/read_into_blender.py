"""Writes what Blender holds of the files of files.py, run by it: ... --python read_into_blender.py -- WORK_FOLDER."""
import json
import pathlib
import sys

import bpy
import numpy

work = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
# Debian 12's Blender uses a name that its NumPy does not have any more.
if "bool" not in dir(numpy):
    numpy.bool = bool
IMPORTERS = {".ply": [("wm", "ply_import"), ("import_mesh", "ply")], ".obj": [("wm", "obj_import"), ("import_scene", "obj")],
             ".stl": [("wm", "stl_import"), ("import_mesh", "stl")], ".glb": [("import_scene", "gltf")]}


def load(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    for area, operator in IMPORTERS[path.suffix]:
        if operator in dir(getattr(bpy.ops, area)):
            # Files and Blender's scene have the same axes.
            axes = {"axis_forward": "Y", "axis_up": "Z"} if area == "import_scene" and operator == "obj" else {}
            axes = {"forward_axis": "Y", "up_axis": "Z"} if operator == "obj_import" else axes
            getattr(getattr(bpy.ops, area), operator)(filepath=str(path), **axes)
            return [o for o in bpy.context.scene.objects if o.type == "MESH"]
    raise AssertionError(f"no importer for {path.name}")


def label_of(material):
    name = material.name.split(".")[0]
    return int(name.removeprefix("region_")) if name.startswith("region_") else -1


def hold(path):
    objects = load(path)
    (surface,) = [o.data for o in objects if o.data.polygons]
    lines = [o.data for o in objects if not o.data.polygons]
    points = [list(v.co) for v in surface.vertices]
    if path.suffix == ".glb":  # Blender turns glTF's y axis to its z axis
        points = [[x, z, -y] for x, y, z in points]
    regions = len(surface.materials) > 1
    held = {"points": points, "faces": [list(p.vertices) for p in surface.polygons],
            "materials": [label_of(surface.materials[p.material_index]) for p in surface.polygons] if regions else [],
            "segments": sum(len(m.edges) for m in lines), "corner_colors": [], "point_colors": [], "corner_texture": []}
    if surface.uv_layers:
        held["corner_texture"] = [[list(surface.uv_layers[0].data[i].uv) for i in p.loop_indices] for p in surface.polygons]
    for attribute in surface.color_attributes:
        colors = [[round(255 * c) for c in list(d.color_srgb)[:3]] for d in attribute.data]
        if attribute.domain == "POINT":
            held["point_colors"] = colors
        else:
            held["corner_colors"] = [[colors[i] for i in p.loop_indices] for p in surface.polygons]
    if regions:
        colors = {}
        for material in surface.materials:
            (shader,) = [n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED"]
            linear = list(shader.inputs["Base Color"].default_value)[:3]
            colors[label_of(material)] = [round(255 * (12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055)) for c in linear]
        held["corner_colors"] = [[colors[label]] * 3 for label in held["materials"]]
    return held


held = {}
painted = [f"{name}{end}" for name in ("painted", "seam") for end in (".ply", "_text.ply", ".obj", ".glb")]
for name in ("whole.ply", "text.ply", "whole.obj", "whole.stl", "whole.glb", *painted):
    held[name] = hold(work / name)
(work / "blender.json").write_text(json.dumps(held))
