#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the .obj files beside this file: closed surfaces, in millimetres.

An object may have several parts. They stand a hair apart, so that no surface cuts another.
"""
import math
import pathlib

GAP = 0.2  # between two parts
SIDES = 24


class Surface:
    """Loops of vertices joined by bands; every face is counter-clockwise from outside."""

    def __init__(self):
        self.vertices, self.faces = [], []

    def loop(self, points):
        self.vertices += points
        return list(range(len(self.vertices) - len(points), len(self.vertices)))

    def band(self, below, above):
        for i in range(len(below)):
            j = (i + 1) % len(below)
            self.faces += [(below[i], below[j], above[j]), (below[i], above[j], above[i])]

    def cap(self, loop, point):
        (middle,) = self.loop([point])
        self.faces += [(loop[i - 1], loop[i], middle) for i in range(len(loop))]

    def tube(self, sections, first, last):
        """Through sections of equally many points, closed by fans round two points."""
        loops = [self.loop(points) for points in sections]
        for below, above in zip(loops, loops[1:]):
            self.band(below, above)
        self.cap(loops[0][::-1], first)
        self.cap(loops[-1], last)

    def write(self, name, what):
        lines = [f"# {what} Millimetres. Made by make_objects.py, MIT."]
        lines += ["v %.3f %.3f %.3f" % v for v in self.vertices]
        lines += ["f %d %d %d" % tuple(i + 1 for i in face) for face in self.faces]
        (pathlib.Path(__file__).parent / name).write_text("\n".join(lines) + "\n")


def turned(surface, profile, sides=32):
    """A body round z: (radius, z) from the middle of its bottom to that of its top."""
    angles = [2 * math.pi * i / sides for i in range(sides)]
    sections = [[(r * math.cos(a), r * math.sin(a), z) for a in angles] for r, z in profile]
    surface.tube(sections, (0, 0, profile[0][1]), (0, 0, profile[-1][1]))


def swept(surface, stations, rounded=True):
    """Elliptic sections along a path in the xy plane: (x, y, half in the plane, half along z)."""
    if rounded:
        ends = dome(stations[1], stations[0]), dome(stations[-2], stations[-1])
        stations = ends[0][::-1] + stations + ends[1]
    sections = []
    for i, (x, y, wide, high) in enumerate(stations):
        x0, y0 = stations[max(i - 1, 0)][:2]
        x1, y1 = stations[min(i + 1, len(stations) - 1)][:2]
        length = math.hypot(x1 - x0, y1 - y0)
        nx, ny = (y1 - y0) / length, (x0 - x1) / length
        angles = [2 * math.pi * k / SIDES for k in range(SIDES)]
        sections.append([(x + wide * math.cos(a) * nx, y + wide * math.cos(a) * ny,
                          -high * math.sin(a))
                         for a in angles])
    surface.tube(sections, (*stations[0][:2], 0), (*stations[-1][:2], 0))


def dome(before, end, steps=4):
    """Stations that close a swept body by a round end."""
    length = math.hypot(end[0] - before[0], end[1] - before[1])
    dx, dy = (end[0] - before[0]) / length, (end[1] - before[1]) / length
    depth = min(end[2], end[3])
    return [(end[0] + dx * depth * math.sin(a), end[1] + dy * depth * math.sin(a),
             end[2] * math.cos(a), end[3] * math.cos(a))
            for a in (math.pi / 2 * k / (steps + 0.5) for k in range(1, steps + 1))]


def ring(surface, x, y, radius, wire, rounds=40, sides=12):
    """In the xy plane, radius to the middle of its wire."""
    loops = []
    for i in range(rounds):
        a = 2 * math.pi * i / rounds
        section = []
        for j in range(sides):
            b = 2 * math.pi * j / sides
            r = radius + wire * math.cos(b)
            section.append((x + r * math.cos(a), y + r * math.sin(a), wire * math.sin(b)))
        loops.append(surface.loop(section))
    for i in range(rounds):
        surface.band(loops[(i + 1) % rounds], loops[i])


def disc(surface, x, y, radius, half_height):
    """A short round block in the xy plane."""
    block = Surface()
    turned(block, [(radius - 1, -half_height), (radius, 1 - half_height), (radius, half_height - 1),
                   (radius - 1, half_height)])
    start = len(surface.vertices)
    surface.vertices += [(x + px, y + py, pz) for px, py, pz in block.vertices]
    surface.faces += [tuple(start + v for v in face) for face in block.faces]


def smooth(points, steps=6):
    """Catmull-Rom through stations."""
    result = []
    for i in range(len(points) - 1):
        p = [points[max(i - 1, 0)], points[i], points[i + 1], points[min(i + 2, len(points) - 1)]]
        for k in range(steps):
            t = k / steps
            result.append(tuple(
                b + t * (c - a) / 2 + t * t * (2 * a - 5 * b + 4 * c - d) / 2
                + t * t * t * (3 * b - a - 3 * c + d) / 2 for a, b, c, d in zip(*p)))
    return result + [points[-1]]


def mirrored(stations):
    return [(x, -y, wide, high) for x, y, wide, high in stations]


def make_mug(radius=36.0, height=82.0, wall=4.5):
    mug = Surface()
    steps = [height * k / 12 for k in range(1, 12)]
    outside = [(radius - 2, 0), (radius, 2)] + [(radius, z) for z in steps]
    rim = [(radius, height - 1.5), (radius - 1.5, height), (radius - wall + 1.5, height)]
    inside = [(radius - wall, height - 1.5), (radius - wall, 40), (radius - wall, 10),
              (radius - 10, 6)]
    turned(mug, outside + rim + inside, 48)
    # The handle is bent in the xz plane and ends in front of the wall.
    path = smooth([(0, 66), (12, 66), (24, 58), (26, 44), (24, 30), (12, 20), (0, 20)], 4)
    sections = []
    for i, (out, z) in enumerate(path):
        (o0, z0), (o1, z1) = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
        length = math.hypot(o1 - o0, z1 - z0)
        nx, nz = (z0 - z1) / length, (o1 - o0) / length
        section = []
        for k in range(SIDES):
            u, v = 7 * math.cos(2 * math.pi * k / SIDES), 4 * math.sin(2 * math.pi * k / SIDES)
            at_wall = math.sqrt((radius + GAP) ** 2 - u * u)
            section.append((at_wall + max(out + v * nx, 0), u, z + v * nz))
        sections.append(section)
    first, last = ((radius + GAP, 0, z) for z in (66, 20))
    mug.tube(sections, first, last)
    mug.write("mug.obj", "A mug, 72 mm across, 82 mm high, with a handle along x.")


def make_cup():
    cup = Surface()
    wall = [(26 + 11 * k / 10, 96 * k / 10) for k in range(1, 10)]
    lid = [(37, 96), (39.5, 97), (39.5, 101), (35, 107), (33, 107)]
    turned(cup, [(25, 0), (26, 1)] + wall + lid + [(32, 104)], 48)
    cup.write("cup.obj", "A paper cup, 107 mm high, 79 mm across its lid, 52 mm across its foot.")


def make_bowl():
    bowl = Surface()
    quarter = [math.pi / 2 * k / 10 for k in range(1, 10)]
    outside = [(28 + 32 * math.sin(a), 60 - 54 * math.cos(a)) for a in quarter]
    foot = [(27, 0), (28, 1), (28, 5)]
    rim = [(60, 59), (59, 60), (56.5, 60), (55.5, 58)]
    inside = [(24 + 31 * math.sin(a), 60 - 50 * math.cos(a)) for a in quarter[::-1]]
    turned(bowl, foot + outside + rim + inside, 48)
    bowl.write("bowl.obj", "A rice bowl, 120 mm across and 60 mm high, its foot 56 mm across.")


def make_plate():
    plate = Surface()
    under = [(60, 0), (62, 1), (80, 6), (104, 15)]
    over = [(105, 16.5), (104, 18), (80, 10), (62, 5), (40, 4)]
    turned(plate, under + over, 64)
    plate.write("plate.obj", "A plate, 210 mm across and 18 mm high.")


def make_wine_glass():
    glass = Surface()
    foot = [(33, 0), (34, 1), (33, 2), (12, 4), (5, 9), (4, 16)]
    stem = [(4, z) for z in (30, 45, 60, 75)]
    outside = [(5, 84), (14, 90), (25, 98), (32, 110), (35, 125), (34, 145), (30, 168)]
    inside = [(29, 169), (28, 168), (32, 145), (33, 125), (30, 111), (23, 101), (10, 93)]
    turned(glass, foot + stem + outside + inside, 40)
    glass.write("wine_glass.obj", "A wine glass, 169 mm high, its stem 8 mm thick.")


def make_screwdriver():
    driver = Surface()
    blade = [(1, -62), (1.6, -61), (1.6, -10), (3, -8), (4.5, -2)]
    grip = [(5, 10), (5, 25), (5, 40), (3.4, 44), (3.4, 47)]
    turned(driver, blade + grip + [(6.5, 49), (7, 51), (7, 55), (6, 57)])
    driver.write("screwdriver.obj",
                 "A watchmaker's screwdriver, 119 mm long, 10 mm thick, with a cap that turns.")


def make_microphone():
    microphone = Surface()
    body = [(15, 0), (17, 2), (17.5, 30), (18.5, 60), (19.5, 90), (21, 118), (22, 122)]
    ball = [(27 * math.sin(a), 142 - 27 * math.cos(a))
            for a in (math.pi * k / 20 for k in range(7, 20))]
    turned(microphone, body + ball, 40)
    microphone.write("microphone.obj", "A microphone, 169 mm long, 37 mm thick, its ball 54 mm.")


def make_hammer():
    hammer = Surface()
    handle = smooth([(-125, 0, 16, 12), (-105, 0, 17, 13), (-60, 0, 15.5, 11.5), (0, 0, 16, 11.5),
                     (60, 0, 14, 10.5), (110, 0, 13, 10), (130 - GAP, 0, 13, 10)])
    swept(hammer, dome(handle[1], handle[0])[::-1] + handle, rounded=False)
    head = [(143, -42, 10, 10), (143, -40, 12, 12), (143, -28, 13, 13), (143, 10, 13, 13),
            (143, 22, 12, 12), (143, 45, 7, 13), (143, 60, 2.5, 13)]
    swept(hammer, head, rounded=False)
    hammer.write("hammer.obj",
                 "A hammer along x, 293 mm long, its handle 23 x 32 mm where it is gripped.")


def make_pliers():
    pliers = Surface()
    disc(pliers, 0, 0, 12, 7)
    handle = smooth([(-17.5, 6.5, 5, 5), (-28, 13, 5.5, 6), (-55, 21, 6, 7), (-90, 22, 6, 7),
                     (-120, 19, 6, 7)])
    jaw = [(18, 4.8, 4.5, 6), (30, 5.6, 5, 5.5), (48, 4, 3.4, 4)]
    for half in (handle, mirrored(handle), jaw, mirrored(jaw)):
        swept(pliers, half)
    pliers.write("pliers.obj", "Pliers along x, 177 mm long, 56 mm across their handles.")


def make_scissors():
    scissors = Surface()
    disc(scissors, 0, 0, 6, 4)
    for side in (1, -1):
        shank = [(-6.5 - GAP - 3, 3 * side, 2.8, 3), (-25, 6 * side, 3, 3.2),
                 (-47, 13 * side, 3, 3.2)]
        swept(scissors, shank)
        ring(scissors, -68.5, 19 * side, 15, 3)
    swept(scissors,
          [(9, 0, 7, 1.8), (30, 0, 7, 1.8), (60, 0, 5.5, 1.6), (85, 0, 3, 1.4), (95, 0, 1, 1)])
    scissors.write("scissors.obj",
                   "Household scissors along x, closed, 183 mm long, blades 14 mm wide.")


def make_spoon():
    spoon = Surface()
    handle = [(-95, 6, 1.2, 7), (-80, 6, 1.4, 9), (-50, 4, 1.6, 6.5), (-10, 1, 1.8, 4)]
    hollow = [(30, 3, 2, 3.6), (45, 3, 1.8, 7), (60, 0, 1.5, 17), (75, -1, 1.4, 20),
              (88, 1, 1.4, 16), (97, 4, 1.2, 6)]
    swept(spoon, smooth(handle + hollow, 5))
    spoon.write("spoon.obj", "A table spoon along x, 194 mm long, flat along y.")


def make_banana():
    banana = Surface()
    stations = []
    for k in range(25):
        a = math.radians(-48 + 96 * k / 24)
        size = 17.5 * min(1, 0.3 + 2.2 * (1 - abs(k - 11) / 13.5)) ** 0.8
        stations.append((115 * math.sin(a), 115 * (math.cos(a) - 1), size, size))
    stem = [(100, -56, 4.2, 4.2), (109, -71, 4.6, 4.6)]
    swept(banana, stations + stem)
    banana.write("banana.obj", "A banana along x, bent towards -y, 35 mm thick.")


def make_bat():
    bat = Surface()
    disc(bat, 0, 0, 76, 6)
    handle = smooth([(-76.6 - GAP, 0, 13, 9), (-95, 0, 12, 10), (-130, 0, 12.5, 10.5),
                     (-172, 0, 15, 11.5)])
    swept(bat, handle + dome(handle[-2], handle[-1]), rounded=False)
    bat.write("bat.obj", "A table tennis bat, its handle along -x, its blade 152 mm across.")


if __name__ == "__main__":
    for make in (make_mug, make_cup, make_bowl, make_plate, make_wine_glass, make_screwdriver,
                 make_microphone, make_hammer, make_pliers, make_scissors, make_spoon, make_banana,
                 make_bat):
        make()
