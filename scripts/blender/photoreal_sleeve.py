# SPDX-License-Identifier: MIT
"""A sleeve, or a bare arm, from where the visible forearm ends, over the elbow, out of the picture."""
import numpy as np
import photoreal_hand

SIDES = 40
ELBOW_M = 0.26  # from the wrist
STEP_M = 0.008


class Sleeve:
    """Vertices in the camera frame."""

    def __init__(self, meshes, material, rng, upper_arm_m, bare=False):
        self.meshes = meshes
        self.centre, self.radii = forearm_section(meshes)
        down = -meshes.camera_from_forearm[:, :, 1].mean(axis=0)
        down[2] = 0.0  # out of the picture, neither towards the camera nor into the wall
        self.body = down / np.linalg.norm(down)
        self.distances = np.arange(0, ELBOW_M + upper_arm_m, STEP_M)
        self.folds = np.ones((len(self.distances), SIDES)) if bare else folds(rng, len(self.distances))
        self.thing = photoreal_hand.add_mesh("sleeve", self.vertices(0), self.triangles(), material)
        if bare:
            photoreal_hand.store(self.thing, "bind", self.in_forearm(0))

    def move_to(self, frame):
        photoreal_hand.move_vertices(self.thing, self.vertices(frame))

    def vertices(self, frame):
        pose = self.meshes.camera_from_forearm[frame]
        along = -pose[:, 1]
        start = pose[:, 3] + along * self.meshes.visible_forearm
        start = start + pose[:, 0] * self.centre[0] + pose[:, 2] * self.centre[1]
        points, tangents = self.arm(start, along)
        rings = [self.ring(points[0], tangents[0], pose, np.ones(SIDES), 0)]
        for i, (point, tangent) in enumerate(zip(points, tangents)):
            rings.append(self.ring(point, tangent, pose, self.folds[i], self.distances[i]))
        return np.concatenate(rings)

    def in_forearm(self, frame):
        pose = self.meshes.camera_from_forearm[frame]
        return (self.vertices(frame) - pose[:, 3]) @ pose[:, :3]

    def arm(self, start, along):
        """The arm's axis: straight to the elbow, then bent towards the body."""
        elbow = max(ELBOW_M - self.meshes.visible_forearm, 0.05)
        bend = np.clip((self.distances - elbow + 0.04) / 0.08, 0, 1)[:, None]
        upper = along + 1.2 * self.body
        upper /= np.linalg.norm(upper)
        tangents = along * (1 - bend) + upper * bend
        tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
        steps = np.vstack([np.zeros(3), tangents[:-1] * STEP_M])
        return start + np.cumsum(steps, axis=0), tangents

    def ring(self, point, tangent, pose, folds, distance):
        side = pose[:, 0] - tangent * (pose[:, 0] @ tangent)
        side /= np.linalg.norm(side)
        front = np.cross(side, tangent)
        turn = np.linspace(0, 2 * np.pi, SIDES, endpoint=False)
        wider = 1 + 0.9 * min(distance, 0.3)
        x = np.cos(turn) * self.radii[0] * wider * folds
        z = np.sin(turn) * self.radii[1] * wider * folds
        return point + x[:, None] * side + z[:, None] * front

    def triangles(self):
        rings = len(self.distances) + 1
        ring, i = np.meshgrid(np.arange(rings - 1), np.arange(SIDES), indexing="ij")
        a, b = ring * SIDES + i, ring * SIDES + (i + 1) % SIDES
        quads = np.stack([a, b, b + SIDES, a + SIDES], axis=-1).reshape(-1, 4)
        return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.uint32)


def forearm_section(meshes):
    """Centre and half widths, x and z of the forearm's frame, of its last visible centimetre, or of the ring of
    vertices before that where it has none."""
    pose = meshes.bones["forearm"]
    local = (meshes.hand_bind - pose[:, 3]) @ pose[:, :3]
    beyond = -local[:, 1] - meshes.visible_forearm
    visible = beyond < -1e-4
    first = min(-0.012, beyond[visible].max() - 0.001)
    rim = local[visible & (beyond > first)][:, [0, 2]]
    low, high = rim.min(axis=0), rim.max(axis=0)
    return (low + high) / 2, (high - low) / 2


def folds(rng, rings):
    """How much wider than the arm the cloth is: a hem, then folds that run around and askew."""
    distance = np.arange(rings)[:, None] * STEP_M
    turn = np.linspace(0, 2 * np.pi, SIDES, endpoint=False)[None, :]
    wide = np.full((rings, SIDES), 1.22)
    for _ in range(9):
        waves, length = rng.integers(1, 4), rng.uniform(0.025, 0.08)
        phase = rng.uniform(0, 2 * np.pi)
        wave = np.sin(waves * turn + 2 * np.pi * distance / length + phase)
        wide = wide + 0.022 * wave * np.clip((distance - 0.02) / 0.05, 0, 1)
    hem = (distance < 0.025) * 0.03
    return wide + hem
