# SPDX-License-Identifier: MIT
"""The scene: camera, light, room, and the hand with what it holds in one frame after another."""
import tempfile
import zlib
from pathlib import Path

import bpy
import numpy as np
import photoreal_clutter
import photoreal_hand
import photoreal_room
import photoreal_shading as shading
from mathutils import Matrix, Vector
from photoreal_sleeve import Sleeve

BLENDER_FROM_OPENCV = Matrix(((1, 0, 0, 0), (0, -1, 0, 0), (0, 0, -1, 0), (0, 0, 0, 1)))
BORDER_PX = 6
ROOMS = {"desk": photoreal_room.build, "clutter": photoreal_clutter.build}


class Studio:
    """World: z up, y away from the camera, which stands in the origin and looks down a little."""

    def __init__(self, meshes, look):
        self.meshes, self.look = meshes, look
        self.seed = zlib.crc32(meshes.name.encode())
        self.rng = np.random.default_rng(self.seed)
        self.work = tempfile.TemporaryDirectory(prefix="photoreal-")
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.scene = bpy.context.scene
        self.camera = self.add_camera()
        self.world_from_opencv = self.camera.matrix_world @ BLENDER_FROM_OPENCV
        self.hand = photoreal_hand.add_hand(meshes, shading.skin(look))
        self.hand.matrix_world = self.world_from_opencv
        self.sleeve = self.add_sleeve()
        self.object = self.add_object()
        self.held = [thing for thing in (self.hand, self.sleeve_thing(), self.object) if thing]
        self.room = []
        self.add_lights()
        self.set_cycles()

    def add_camera(self):
        k = self.meshes.camera
        width, height = k["width_px"], k["height_px"]
        data = bpy.data.cameras.new("camera")
        data.sensor_fit, data.sensor_width = "HORIZONTAL", 36.0
        data.lens = k["fx_px"] / width * 36.0
        # Blender's picture is centred between pixels; a shift is in widths.
        data.shift_x = ((width - 1) / 2 - k["cx_px"]) / width
        data.shift_y = (k["cy_px"] - (height - 1) / 2) / width
        data.clip_start = 0.01
        data.dof.aperture_fstop = self.look["fstop"]
        data.dof.focus_distance = float(self.meshes.hand_vertices[:, :, 2].mean())
        camera = bpy.data.objects.new("camera", data)
        bpy.context.collection.objects.link(camera)
        tilt = np.radians(90 - self.look["camera_down_deg"])
        camera.matrix_world = Matrix.Rotation(tilt, 4, "X")
        self.scene.camera = camera
        self.scene.render.resolution_x, self.scene.render.resolution_y = width, height
        self.scene.render.resolution_percentage = 100
        return camera

    def add_sleeve(self):
        if not self.look["sleeve"]:
            return None
        bare = self.look["arm"] == "bare"
        material = shading.skin(self.look) if bare else shading.cloth(self.look["sleeve"])
        sleeve = Sleeve(self.meshes, material, self.rng, self.look["upper_arm_m"], bare)
        sleeve.thing.matrix_world = self.world_from_opencv
        return sleeve

    def sleeve_thing(self):
        return self.sleeve.thing if self.sleeve else None

    def add_object(self):
        if not self.meshes.has_object:
            return None
        vertices, triangles = self.meshes.object_vertices, self.meshes.object_triangles
        half_extents = np.abs(vertices).max(axis=0).tolist()
        material = shading.held_object(self.look["object_kind"], self.look["object"], half_extents)
        return photoreal_hand.add_mesh("object", vertices, triangles, material)

    def view(self):
        """What the room must fit: behind all that moves, and as wide as the picture."""
        k = self.meshes.camera
        depths = [self.meshes.hand_vertices[:, :, 2].max()]
        if self.sleeve:
            ends = self.meshes.camera_from_forearm
            depths.append((ends[:, 2, 3] - ends[:, 2, 1] * 0.30).max() + 0.06)
        return photoreal_room.View(
            near=float(max(depths)) + 0.06,
            half_width=k["width_px"] / 2 / k["fx_px"],
            half_height=k["height_px"] / 2 / k["fy_px"],
            down=np.radians(self.look["camera_down_deg"]),
        )

    def add_lights(self):
        look = self.look
        hand = self.world_from_opencv @ Vector(self.meshes.hand_vertices[:, :, :].mean(axis=(0, 1)))
        towards = self.world_from_opencv.to_3x3() @ Vector(self.meshes.towards_light[0])
        towards.z = max(towards.z, -0.2)  # no lamp under the desk
        add_area("key", hand + towards.normalized() * 1.5, hand, look["key_size"], 60, look["key"])
        self.scene.world = shading.daylight(look["fill"], look["ambient"])

    def set_cycles(self):
        scene = self.scene
        scene.render.engine = "CYCLES"
        scene.render.use_persistent_data = True
        scene.render.threads_mode = "FIXED"
        scene.render.threads = self.look["threads"]
        scene.render.image_settings.file_format = "OPEN_EXR"
        scene.render.image_settings.color_mode = "RGBA"
        scene.render.image_settings.exr_codec = "NONE"
        scene.view_settings.view_transform = "Raw"
        cycles = scene.cycles
        cycles.use_denoising = False
        cycles.use_adaptive_sampling = False
        cycles.caustics_reflective = cycles.caustics_refractive = False
        cycles.sample_clamp_indirect = 2.0
        cycles.pixel_filter_type = "BLACKMAN_HARRIS"
        cycles.filter_width = 1.3

    def place(self, frame):
        photoreal_hand.move_vertices(self.hand, self.meshes.hand_vertices[frame])
        if self.sleeve:
            self.sleeve.move_to(frame)
        if self.object:
            self.object.matrix_world = self.world_from_opencv @ self.object_pose(frame)

    def object_pose(self, frame):
        return Matrix([*self.meshes.camera_from_object[frame].tolist(), [0, 0, 0, 1]])

    def show(self, seen):
        for thing in [*self.held, *self.room]:
            thing.hide_render = thing not in seen

    def plate(self):
        """The room without anybody, height x width x 3, linear."""
        self.room = self.room or ROOMS[self.look["room"]](self.look, self.rng, self.view())
        self.show(self.room)
        self.scene.render.film_transparent = False
        self.scene.render.use_border = False
        self.camera.data.dof.use_dof = True
        self.set_bounces(3)
        self.scene.cycles.seed = 0
        picture = self.render(self.look["plate_samples"])
        self.camera.data.dof.use_dof = False
        return picture[:, :, :3]

    def foreground(self, frame):
        """Hand, sleeve and object, linear, alpha premultiplied."""
        self.place(frame)
        self.show(self.held)
        self.scene.render.film_transparent = True
        self.set_border(frame)
        self.set_bounces(1)
        self.scene.cycles.seed = frame
        return self.render(self.look["samples"])

    def set_bounces(self, bounces):
        cycles = self.scene.cycles
        cycles.max_bounces = cycles.diffuse_bounces = bounces
        cycles.glossy_bounces = 1

    def meter(self):
        return self.foreground(self.meshes.frame_count // 2)

    def set_border(self, frame):
        points = [self.meshes.hand_vertices[frame]]
        if self.sleeve:
            points.append(self.sleeve.vertices(frame))
        if self.object:
            pose = self.meshes.camera_from_object[frame]
            points.append(self.meshes.object_vertices @ pose[:, :3].T + pose[:, 3])
        points = np.concatenate(points)
        points = points[points[:, 2] > 0.05]
        k = self.meshes.camera
        x = k["fx_px"] * points[:, 0] / points[:, 2] + k["cx_px"]
        y = k["fy_px"] * points[:, 1] / points[:, 2] + k["cy_px"]
        render, width, height = self.scene.render, k["width_px"], k["height_px"]
        render.use_border = True
        render.border_min_x = max(0.0, (x.min() - BORDER_PX) / width)
        render.border_max_x = min(1.0, (x.max() + BORDER_PX) / width)
        render.border_min_y = max(0.0, 1 - (y.max() + BORDER_PX) / height)
        render.border_max_y = min(1.0, 1 - (y.min() - BORDER_PX) / height)

    def render(self, samples):
        file = Path(self.work.name) / "picture.exr"
        self.scene.cycles.samples = samples
        self.scene.render.filepath = str(file)
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(str(file))
        image.colorspace_settings.name = "Raw"
        width, height = image.size
        pixels = np.empty(width * height * 4, np.float32)
        image.pixels.foreach_get(pixels)
        bpy.data.images.remove(image)
        return pixels.reshape(height, width, 4)[::-1]

    def silhouette(self, frame, seen, others=()):
        self.place(frame)
        self.show(seen)
        for thing in others:
            thing.hide_render = False
            thing.is_holdout = True
        self.scene.render.film_transparent = True
        self.scene.render.use_border = False
        alpha = self.render(16)[:, :, 3]
        for thing in others:
            thing.is_holdout = False
        return alpha

    def hand_silhouette(self, frame):
        """The visible hand without the sleeve, as graspdb has it."""
        return self.silhouette(frame, [self.hand], [self.object] if self.object else [])

    def visible_sleeve(self, frame):
        """How much of each pixel it covers."""
        if not self.sleeve:
            return np.zeros((self.meshes.camera["height_px"], self.meshes.camera["width_px"]))
        return self.silhouette(frame, [self.sleeve.thing], [thing for thing in (self.hand, self.object) if thing])

    def hidden_by_sleeve(self, frame):
        """The share of the visible hand."""
        if not self.sleeve:
            return 0.0
        hand = self.hand_silhouette(frame) > 0.5
        others = [thing for thing in (self.object, self.sleeve.thing) if thing]
        covered = self.silhouette(frame, [self.hand], others) > 0.5
        return (hand & ~covered).sum() / hand.sum()


def add_area(name, where, target, size, watts, colour):
    data = bpy.data.lights.new(name, "AREA")
    data.energy, data.size, data.color = watts, size, shading.linear(colour)[:3]
    light = bpy.data.objects.new(name, data)
    light.location = where
    light.rotation_euler = (where - target).to_track_quat("Z", "Y").to_euler()
    light.visible_camera = False
    bpy.context.collection.objects.link(light)
