# SPDX-License-Identifier: MIT
"""A room for training pictures: walls, a table and many things of any shape and stuff, among them what looks like
skin and is none. World frame: x right, y away, z up."""
import math

import numpy as np
import photoreal_looks as looks
import photoreal_shading as shading
from photoreal_room import Room

# Of cork, cardboard, brick, leather, warm plaster, red cloth, pale wood and faces.
SKIN_LIKE = (
    (0.72, 0.55, 0.38), (0.68, 0.53, 0.37), (0.60, 0.34, 0.26), (0.45, 0.27, 0.17), (0.86, 0.72, 0.60),
    (0.62, 0.20, 0.17), (0.80, 0.65, 0.47), (0.82, 0.60, 0.50), (0.55, 0.37, 0.28), (0.90, 0.74, 0.66),
)  # fmt: skip
SKIN_LIKE_SHARE = 0.4


class Clutter(Room):
    def colour(self):
        if self.rng.random() < SKIN_LIKE_SHARE:
            base = np.array(SKIN_LIKE[self.rng.integers(len(SKIN_LIKE))])
            return np.clip(base * self.rng.uniform(0.85, 1.15, 3), 0, 1).tolist()
        return looks.any_colour(self.rng).tolist()

    def stuff(self):
        rng, kind = self.rng, self.rng.integers(6)
        scale = math.exp(rng.uniform(math.log(4), math.log(200)))
        if kind == 0:
            return shading.wood(self.colour(), scale=rng.uniform(3, 30))
        if kind == 1:
            return shading.print_like([self.colour() for _ in range(rng.integers(2, 5))], scale)
        if kind == 2:  # carpet, towel, felt
            return shading.plain(self.colour(), 1.0, mottled=0.35, bumps=1.0, scale=scale, specular=0.1)
        if kind == 3:
            wide = rng.uniform(0.05, 0.3)
            return shading.bricks(self.colour(), self.colour(), wide, wide * rng.uniform(0.3, 1), rng.choice([0, 0.5]))
        mottled, roughness = rng.uniform(0, 0.3), rng.uniform(0.1, 1)
        return shading.plain(self.colour(), roughness, rng.choice([0, 0, 1]), mottled, scale=scale)

    def turn(self):
        return tuple(self.rng.uniform(-math.pi, math.pi, 3))

    def thing(self, where, size):
        rng, kind = self.rng, self.rng.integers(6)
        x, y, z = where
        if kind == 0:
            sides = size * rng.uniform(0.2, 1, 3)
            self.box((x, y, z + sides[2] / 2), sides.tolist(), self.stuff(), rng.uniform(0, math.pi), rng.choice([0, 0.004]))
        elif kind == 1:
            top = size * rng.uniform(0, 0.5)
            self.cylinder(where, size * rng.uniform(0.1, 0.5), size * rng.uniform(0.1, 1.5), self.stuff(), top)
        elif kind == 2:
            self.ball((x, y, z + size * 0.4), size / 2, self.stuff(), rng.uniform(0.4, 1, 3).tolist())
        elif kind == 3:
            self.ring((x, y, z + size * 0.3), size * 0.4, size * rng.uniform(0.03, 0.15), self.stuff(), self.turn())
        elif kind == 4:
            steps = np.cumsum(rng.normal(0, size * 0.35, (6, 3)), axis=0) + where
            steps[:, 2] = np.maximum(steps[:, 2], z)
            self.tube(steps.tolist(), size * rng.uniform(0.01, 0.15), self.stuff())
        else:
            self.head(where, size)

    def head(self, where, size):
        """A face's colours and hair, which nobody will see sharply."""
        x, y, z = where
        skin = shading.plain(self.colour(), 0.5, mottled=0.15, scale=12)
        self.ball((x, y, z + size / 2), size / 2, skin, (0.72, 0.85, 1))
        hair = shading.plain(looks.any_colour(self.rng).tolist(), 0.7, mottled=0.4, scale=80)
        self.ball((x, y + size * 0.08, z + size * 0.62), size * 0.48, hair, (0.76, 0.85, 0.85))

    def surfaces(self):
        self.box((0, self.wall_y + 0.05, 0.4), (8.0, 0.1, 8), self.stuff())
        if self.rng.random() < 0.8:
            middle = (self.front + self.wall_y) / 2
            self.box((0, middle, self.desk_z - 0.02), (8.0, self.wall_y - self.front, 0.04), self.stuff())
        self.box((0, -1, self.desk_z - 0.75), (6, 8, 0.02), self.stuff())

    def fill(self):
        rng = self.rng
        for _ in range(rng.integers(4, 40)):
            y = rng.uniform(self.front + 0.05, self.wall_y)
            reach = y * self.view.half_width
            standing = rng.random() < 0.6
            z = self.desk_z if standing else rng.uniform(self.desk_z, y * (self.view.half_height - math.tan(self.view.down)))
            size = y * self.view.half_width * math.exp(rng.uniform(math.log(0.1), math.log(0.9)))
            if y - size < self.front:
                continue
            self.thing((rng.uniform(-reach, reach), y, z), size)


def build(look, rng, view):
    room = Clutter(look, rng, view)
    room.surfaces()
    room.fill()
    return room.things
