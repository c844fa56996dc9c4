# SPDX-License-Identifier: MIT
"""Views a second of Blender's engines: the male hand, 128 x 128, one process, nothing written.

    blender -b -noaudio --factory-startup -t 2 -P bench/blender_views.py

The peer of bench/render_bench: the same hand and size, a camera that is moved for each view, settings that leave an
engine as little to do as it lets: one sample, no bounces, no denoising, the scene kept between views.
"""

import math
import pathlib
import statistics
import time

import bpy
import mathutils
import numpy

HAND = pathlib.Path(__file__).resolve().parents[1] / "assets/hands/male.glb"
VIEWS = 100
WARM_UP = 3
DISTANCE_M = 0.7
SIZE_PX = 128


def load_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if "bool" not in numpy.__dict__:
        numpy.bool = bool  # Debian 12: the importer of Blender 3.4 is older than its numpy
    bpy.ops.import_scene.gltf(filepath=str(HAND))
    scene = bpy.context.scene
    scene.render.resolution_x = scene.render.resolution_y = SIZE_PX
    scene.render.use_persistent_data = True
    scene.render.image_settings.color_mode = "BW"
    light = bpy.data.objects.new("light", bpy.data.lights.new("light", "SUN"))
    scene.collection.objects.link(light)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.angle = 2 * math.atan(0.15 / DISTANCE_M)
    scene.collection.objects.link(camera)
    scene.camera = camera
    return scene


def middle_of_hand():
    corners = [
        mesh.matrix_world @ mathutils.Vector(corner)
        for mesh in bpy.context.scene.objects
        if mesh.type == "MESH"
        for corner in mesh.bound_box
    ]
    return sum(corners, mathutils.Vector()) / len(corners)


def look_from(camera, direction, target):
    camera.location = target + DISTANCE_M * direction
    camera.rotation_euler = direction.to_track_quat("Z", "Y").to_euler()


def directions(count):
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        angle = i * math.pi * (3 - math.sqrt(5))
        radius = math.sqrt(1 - z * z)
        yield mathutils.Vector((radius * math.cos(angle), radius * math.sin(angle), z))


def use_workbench(scene):
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.display.render_aa = "OFF"


def use_cycles(scene):
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1
    scene.cycles.max_bounces = 0
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False


def milliseconds(scene, target):
    taken = []
    for direction in directions(WARM_UP + VIEWS):
        begin = time.perf_counter()
        look_from(scene.camera, direction, target)
        bpy.ops.render.render(write_still=False)
        taken.append(1000 * (time.perf_counter() - begin))
    return statistics.median(taken[WARM_UP:])


scene = load_scene()
target = middle_of_hand()
for name, use in (("Workbench", use_workbench), ("Cycles, 1 sample", use_cycles)):
    use(scene)
    median = milliseconds(scene, target)
    print(f"{name}: {median:.2f} ms a view, {1000 / median:.0f} views/s")
