# SPDX-License-Identifier: MIT
"""What is behind the hand: a wall, a desk, and things on both. World frame: x right, y away, z up."""
import math
from dataclasses import dataclass

import bpy
import photoreal_shading as shading

COVERS = (
    (0.10, 0.16, 0.30), (0.16, 0.32, 0.26), (0.85, 0.84, 0.80), (0.22, 0.22, 0.24),
    (0.45, 0.52, 0.60), (0.55, 0.14, 0.12), (0.70, 0.62, 0.40), (0.30, 0.42, 0.18),
    (0.12, 0.40, 0.48), (0.38, 0.30, 0.45), (0.78, 0.45, 0.16), (0.62, 0.66, 0.66),
)  # fmt: skip


@dataclass
class View:
    """Of the camera in the origin: `near` is the distance from which on the room may hold things."""

    near: float
    half_width: float  # tangents
    half_height: float
    down: float  # radians


class Room:
    def __init__(self, look, rng, view):
        self.look, self.rng, self.view = look, rng, view
        self.things = []
        self.front = view.near
        # The front edge is just out of the picture.
        self.desk_z = -self.front * math.tan(view.down + math.atan(view.half_height)) - 0.01
        self.wall_y = self.front + look["depth"]

    def keep(self, material, smooth=False):
        thing = bpy.context.object
        thing.data.materials.append(material)
        if smooth:
            bpy.ops.object.shade_smooth()
            thing.data.use_auto_smooth = True
        self.things.append(thing)
        return thing

    def box(self, centre, size, material, turn=0.0, bevel=0.0):
        bpy.ops.mesh.primitive_cube_add(size=1, location=centre, rotation=(0, 0, turn))
        bpy.context.object.scale = size
        bpy.ops.object.transform_apply(location=False, rotation=False, scale=True)
        if bevel:
            modifier = bpy.context.object.modifiers.new("bevel", "BEVEL")
            modifier.width, modifier.segments = bevel, 2
        return self.keep(material)

    def cylinder(self, base, radius, height, material, top=None, tilt=(0, 0, 0)):
        bpy.ops.mesh.primitive_cone_add(
            vertices=48,
            radius1=radius,
            radius2=radius if top is None else top,
            depth=height,
            location=(base[0], base[1], base[2] + height / 2),
            rotation=tilt,
        )
        return self.keep(material, smooth=True)

    def ball(self, centre, radius, material, scale=(1, 1, 1)):
        bpy.ops.mesh.primitive_uv_sphere_add(radius=radius, location=centre, segments=40, ring_count=24)
        bpy.context.object.scale = scale
        return self.keep(material, smooth=True)

    def ring(self, centre, radius, thickness, material, tilt):
        bpy.ops.mesh.primitive_torus_add(
            location=centre, rotation=tilt, major_radius=radius, minor_radius=thickness
        )
        return self.keep(material, smooth=True)

    def tube(self, points, radius, material):
        curve = bpy.data.curves.new("tube", "CURVE")
        curve.dimensions, curve.bevel_depth, curve.bevel_resolution = "3D", radius, 4
        spline = curve.splines.new("NURBS")
        spline.points.add(len(points) - 1)
        for point, where in zip(spline.points, points):
            point.co = (*where, 1)
        spline.use_endpoint_u, spline.order_u = True, 4
        thing = bpy.data.objects.new("tube", curve)
        bpy.context.collection.objects.link(thing)
        curve.materials.append(material)
        self.things.append(thing)

    def colour(self):
        base = COVERS[self.rng.integers(len(COVERS))]
        return [min(1.0, c * self.rng.uniform(0.85, 1.15)) for c in base]

    def card(self, colour):
        return shading.plain(colour, 0.7, mottled=0.08, scale=50)

    # Each of these stands in a slot `width` wide around (x, y) on a surface at z.

    def books(self, x, y, z, width):
        at = x - width / 2
        while True:
            thick, height = self.rng.uniform(0.014, 0.05), self.rng.uniform(0.17, 0.26)
            if at + thick > x + width / 2:
                return
            depth = self.rng.uniform(0.12, 0.17)
            self.box((at + thick / 2, y, z + height / 2), (thick, depth, height), self.card(self.colour()))
            if self.rng.random() < 0.6:  # a label on the spine
                where = (at + thick / 2, y - depth / 2, z + height * self.rng.uniform(0.6, 0.8))
                size = (thick * 0.75, 0.001, height * self.rng.uniform(0.06, 0.2))
                self.box(where, size, self.card([0.85, 0.83, 0.76]))
            at += thick + 0.001

    def stack(self, x, y, z, width):
        for _ in range(self.rng.integers(3, 7)):
            thick = self.rng.uniform(0.015, 0.045)
            size = (min(width, self.rng.uniform(0.2, 0.27)), self.rng.uniform(0.14, 0.19), thick)
            turn = self.rng.uniform(-0.25, 0.25)
            self.box((x, y, z + thick / 2), size, self.card(self.colour()), turn)
            pages = (size[0] * 0.985, size[1] * 1.005, thick * 0.75)
            self.box((x, y, z + thick / 2), pages, self.card([0.86, 0.83, 0.74]), turn)
            z += thick

    def mug(self, x, y, z, width):
        material = shading.plain(self.colour(), 0.2, mottled=0.03)
        self.cylinder((x, y, z), 0.04, 0.095, material)
        self.cylinder((x, y, z + 0.0952), 0.036, 0.0005, shading.plain([0.12, 0.07, 0.05], 0.2))
        side = self.rng.choice([-1, 1])
        self.ring((x + side * 0.042, y, z + 0.05), 0.026, 0.006, material, (math.pi / 2, 0, 0))

    def plant(self, x, y, z, width):
        pot = self.look["pot"]
        self.cylinder((x, y, z), 0.05, 0.1, shading.plain(pot, 0.8, mottled=0.2, scale=40), 0.065)
        self.cylinder((x, y, z + 0.098), 0.06, 0.004, shading.plain([0.1, 0.07, 0.05], 1.0, bumps=1.0))
        greens = ([0.14, 0.34, 0.12], [0.22, 0.45, 0.16], [0.33, 0.5, 0.22])
        leaves = [shading.plain(green, 0.4, mottled=0.3, scale=60) for green in greens]
        for i in range(26):
            turn, rise = self.rng.uniform(0, 2 * math.pi), self.rng.uniform(0.3, 1.3)
            reach = self.rng.uniform(0.05, 0.14)
            across = math.cos(rise) * reach * min(1.0, width / 0.25)
            tip = (x + math.cos(turn) * across, y + math.sin(turn) * across, z + 0.1 + math.sin(rise) * reach)
            self.tube([(x, y, z + 0.1), (x, y, (z + 0.1 + tip[2]) / 2 + 0.02), tip], 0.0015, leaves[0])
            leaf = self.ball(tip, 0.035, leaves[i % 3], (1, 0.45, 0.06))
            leaf.rotation_euler = (self.rng.uniform(-0.5, 0.5), rise - 0.9, turn)

    def boxes(self, x, y, z, width):
        card = shading.plain(self.look["box"], 0.9, mottled=0.12, bumps=0.2, scale=25)
        tape = shading.plain([min(1.0, c * 1.25) for c in self.look["box"]], 0.3, mottled=0.02)
        size = (width * 0.85, 0.16, self.rng.uniform(0.12, 0.2))
        self.box((x, y, z + size[2] / 2), size, card)
        self.box((x, y, z + size[2] / 2), (0.045, size[1] * 1.004, size[2] * 1.004), tape)
        if self.rng.random() < 0.7:
            small = (size[0] * 0.6, 0.12, 0.08)
            where = (x + self.rng.uniform(-0.02, 0.02), y, z + size[2] + small[2] / 2)
            self.box(where, small, self.card(self.colour()), self.rng.uniform(-0.3, 0.3))

    def bottle(self, x, y, z, width):
        material = shading.plain(self.colour(), 0.12, mottled=0.05)
        self.cylinder((x, y, z), 0.036, 0.16, material)
        self.cylinder((x, y, z + 0.16), 0.036, 0.035, material, 0.014)
        self.cylinder((x, y, z + 0.195), 0.014, 0.045, material)
        self.cylinder((x, y, z + 0.225), 0.016, 0.022, shading.plain([0.85, 0.85, 0.85], 0.4))
        label = shading.print_like([[0.9, 0.9, 0.86], self.colour(), [0.2, 0.2, 0.2]], 30)
        self.cylinder((x, y, z + 0.05), 0.0365, 0.07, label)

    def jar(self, x, y, z, width):
        self.cylinder((x, y, z), 0.045, 0.1, shading.plain(self.colour(), 0.15, mottled=0.35, scale=90))
        self.cylinder((x, y, z + 0.1), 0.046, 0.018, shading.plain([0.75, 0.75, 0.77], 0.3, 0.9))

    def pens(self, x, y, z, width):
        self.cylinder((x, y, z), 0.036, 0.09, shading.plain([0.15, 0.15, 0.17], 0.5), 0.038)
        for _ in range(7):
            lean = (self.rng.uniform(-0.2, 0.2), self.rng.uniform(-0.2, 0.2), 0)
            where = (x + lean[1] * 0.08, y - lean[0] * 0.08, z + 0.03)
            self.cylinder(where, 0.004, 0.14, shading.plain(self.colour(), 0.4), tilt=lean)

    def lamp(self, x, y, z, width):
        metal = shading.plain([0.8, 0.8, 0.78], 0.35, mottled=0.02)
        self.cylinder((x, y, z), 0.07, 0.015, metal)
        arm = [(x, y, z), (x, y, z + 0.2), (x - 0.04, y, z + 0.34), (x - 0.1, y - 0.04, z + 0.36)]
        self.tube(arm, 0.006, metal)
        self.cylinder((x - 0.11, y - 0.05, z + 0.29), 0.07, 0.09, metal, 0.03)

    def monitor(self, x, y, z, width):
        black = shading.plain([0.05, 0.05, 0.055], 0.35, mottled=0.05)
        wide, high = width * 1.1, width * 0.65
        self.box((x, y + 0.03, z + 0.1 + high / 2), (wide, 0.03, high), black, bevel=0.004)
        screen = shading.print_like([[0.12, 0.2, 0.32], [0.75, 0.8, 0.85], [0.3, 0.5, 0.55]], 5)
        self.box((x, y + 0.0145, z + 0.1 + high / 2), (wide * 0.96, 0.002, high * 0.93), screen)
        self.cylinder((x, y + 0.04, z), 0.02, 0.14, black)
        self.cylinder((x, y + 0.04, z), 0.1, 0.01, black)

    def keyboard(self, x, y, z, width):
        y = self.front + 0.17
        self.box((x, y, z + 0.008), (width, 0.12, 0.016), shading.plain([0.2, 0.2, 0.22], 0.5), 0.06)
        keys = shading.plain([0.75, 0.76, 0.78], 0.5, mottled=0.05)
        for row in range(5):
            for column in range(int(width / 0.021)):
                where = (x - width / 2 + 0.014 + column * 0.02, y - 0.045 + row * 0.022, z + 0.018)
                self.box(where, (0.016, 0.016, 0.008), keys)

    def paper(self, x, y, z, width):
        sheet = shading.print_like([[0.9, 0.9, 0.88], [0.55, 0.56, 0.6]], 60)
        for _ in range(3):
            where = (x + self.rng.uniform(-0.03, 0.03), self.front + 0.2, z + 0.001)
            self.box(where, (0.2, 0.28, 0.0008), sheet, self.rng.uniform(-0.5, 0.5))
            z += 0.001

    def fruit(self, x, y, z, width):
        bowl = shading.plain([0.85, 0.87, 0.88], 0.2, mottled=0.02)
        self.cylinder((x, y, z), 0.05, 0.05, bowl, 0.1)
        skins = ([0.45, 0.6, 0.15], [0.85, 0.7, 0.15], [0.75, 0.35, 0.1], [0.5, 0.62, 0.2])
        for i, colour in enumerate(skins):
            where = (x + 0.045 * math.cos(1.6 * i), y + 0.045 * math.sin(1.6 * i), z + 0.07)
            self.ball(where, 0.037, shading.plain(colour, 0.4, mottled=0.15, bumps=0.2))

    def cable(self):
        start, points = self.rng.uniform(-0.5, 0.5) * self.front, []
        for i in range(8):
            y = self.wall_y - 0.03 - i * (self.look["depth"] - 0.1) / 7
            points.append((start + self.rng.uniform(-0.07, 0.07), y, self.desk_z + 0.004))
        self.tube(points, 0.003, shading.plain([0.06, 0.06, 0.06], 0.5))

    def wall(self):
        look, wide = self.look, 4.0
        colour = look["wall_colour"]
        if look["wall"] == "bricks":
            material = shading.bricks(colour, [0.6, 0.58, 0.55], 0.24, 0.075)
        elif look["wall"] == "tiles":
            material = shading.bricks(colour, [0.55, 0.55, 0.54], 0.15, 0.15, offset=0.0)
        else:
            material = shading.plain(colour, 0.9, mottled=0.06, bumps=0.25, scale=12)
        self.box((0, self.wall_y + 0.05, 0.4), (wide, 0.1, 4), material)

    def desk(self):
        look = self.look
        colour = look["desk_colour"]
        wooden = look["desk"] == "wood"
        material = shading.wood(colour) if wooden else shading.plain(colour, 0.4, mottled=0.08, scale=14)
        middle = (self.front + self.wall_y) / 2
        self.box((0, middle, self.desk_z - 0.02), (4.0, self.wall_y - self.front, 0.04), material)
        # The floor that light falls on before the desk.
        self.box((0, -1, self.desk_z - 0.75), (6, 8, 0.02), shading.plain([0.4, 0.39, 0.38], 0.8))

    def pictures(self):
        for x, z, wide, high in self.look["posters"]:
            where = (x * self.wall_y * self.view.half_width, self.wall_y - 0.008, z)
            self.box(where, (wide, 0.016, high), shading.plain([0.1, 0.1, 0.1], 0.4))
            colours = [self.colour() for _ in range(4)]
            inner = (where[0], where[1] - 0.009, z)
            self.box(inner, (wide - 0.03, 0.002, high - 0.03), shading.print_like(colours, 6))

    def shelf(self):
        """A board on the wall at the height of look["shelf_z"], with books and more on it."""
        z = self.look["shelf_z"]
        reach = self.wall_y * self.view.half_width + 0.1
        board = shading.plain(self.look["shelf_colour"], 0.5, mottled=0.05)
        self.box((0, self.wall_y - 0.1, z - 0.012), (2 * reach, 0.2, 0.024), board)
        self.stand(self.look["shelf_things"], self.wall_y - 0.1, z, reach)

    def stand(self, names, y, z, reach):
        """One beside the other from left to right."""
        slot = 2 * reach / max(len(names), 1)
        for i, name in enumerate(names):
            if name == "":
                continue
            x = -reach + (i + 0.5) * slot
            getattr(self, name)(x, y, z, min(slot * 0.9, 0.4))


def build(look, rng, view):
    room = Room(look, rng, view)
    room.wall()
    room.desk()
    room.pictures()
    if look["shelf_things"]:
        room.shelf()
    middle = (room.front + room.wall_y) / 2 + 0.08
    room.stand(look["desk_things"], middle, room.desk_z, room.wall_y * view.half_width)
    room.stand(look["front_things"], room.front + 0.12, room.desk_z, room.front * view.half_width * 0.9)
    for _ in range(look["cables"]):
        room.cable()
    return room.things
