# SPDX-License-Identifier: MIT
"""What `graspdb sequence --meshes` and `graspdb scenes` write (docs/sequences.md)."""
import json

import numpy as np


class Meshes:
    """Arrays in metres; the camera frame is OpenCV's: x right, y down, z forward."""

    def __init__(self, folder):
        header = json.loads((folder / "meshes.json").read_text())
        self.name = header["name"]
        self.camera = header["camera"]
        self.skin_bgr = np.array(header["skin_bgr"]) / 255
        self.object_bgr = np.array(header["object_bgr"]) / 255
        self.visible_forearm = header["visible_forearm_m"]
        frames = header["frames"]
        self.frame_count = len(frames)
        self.camera_from_forearm = poses(frames, "camera_from_forearm")
        self.camera_from_object = poses(frames, "camera_from_object")
        self.towards_light = np.array([frame["towards_light"] for frame in frames])
        self.bones = {
            bone["name"]: np.array(bone["hand_from_bone"]).reshape(3, 4) for bone in header["bones"]
        }
        self.hand_triangles = np.fromfile(folder / "hand_triangles.u32", "<u4").reshape(-1, 3)
        self.hand_bind = np.fromfile(folder / "hand_bind.f32", "<f4").reshape(-1, 3)
        self.hand_bones = np.fromfile(folder / "hand_bones.u8", "u1")
        vertices = np.fromfile(folder / "hand_vertices.f32", "<f4")
        self.hand_vertices = vertices.reshape(self.frame_count, -1, 3)
        self.has_object = header["object"] is not None
        if self.has_object:
            triangles = np.fromfile(folder / "object_triangles.u32", "<u4")
            self.object_triangles = triangles.reshape(-1, 3)
            self.object_vertices = np.fromfile(folder / "object_vertices.f32", "<f4").reshape(-1, 3)


def poses(frames, key):
    """frames x 3 x 4."""
    return np.array([frame[key] for frame in frames]).reshape(-1, 3, 4)
