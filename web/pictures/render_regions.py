"""Renders the regions of an OBJ file with Blender, each in its material.

    blender --background --factory-startup --python render_regions.py -- REGIONS.obj PICTURE.webp
"""
import math
import sys

import bpy
from mathutils import Vector

source, picture = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.object.select_all(action="SELECT")
bpy.ops.object.delete()
bpy.ops.wm.obj_import(filepath=source, import_vertex_groups=True)
figure = bpy.context.object
bpy.ops.object.shade_smooth()
corners = [figure.matrix_world @ Vector(corner) for corner in figure.bound_box]
centre = sum(corners, Vector()) / 8
radius = max((corner - centre).length for corner in corners)

direction = Vector((0.45, -1.0, 0.35)).normalized()
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.location = centre + direction * radius * 2.5
camera.rotation_euler = direction.to_track_quat("Z", "Y").to_euler()
bpy.context.collection.objects.link(camera)
sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
sun.data.energy, sun.data.angle = 1.6, math.radians(10)
sun.rotation_euler = (math.radians(50), math.radians(10), math.radians(20))
bpy.context.collection.objects.link(sun)

scene = bpy.context.scene
scene.camera = camera
background = scene.world.node_tree.nodes["Background"].inputs
background["Color"].default_value, background["Strength"].default_value = (0.9, 0.9, 0.88, 1), 0.55
scene.view_settings.view_transform = "Standard"
scene.render.engine = "CYCLES"
scene.cycles.samples = 64
scene.cycles.use_denoising = False
scene.render.resolution_x, scene.render.resolution_y = 800, 640
scene.render.image_settings.file_format = "WEBP"
scene.render.image_settings.quality = 85
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)
