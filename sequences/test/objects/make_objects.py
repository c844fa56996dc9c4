#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the .obj files beside this file: closed surfaces, in millimetres.

An object may have several parts. They stand a hair apart, so that no surface cuts another.
"""
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[3] / "scripts/objects"))
# pylint: disable=wrong-import-position
from surface import SIDES, Surface, disc, dome, ring, smooth, swept, turned, write_objects

GAP = 0.2  # between two parts


def mirrored(stations):
    return [(x, -y, wide, high) for x, y, wide, high in stations]


def mug(radius=36.0, height=82.0, wall=4.5):
    """A mug, 72 mm across, 82 mm high, with a handle along x."""
    surface = Surface()
    steps = [height * k / 12 for k in range(1, 12)]
    outside = [(radius - 2, 0), (radius, 2)] + [(radius, z) for z in steps]
    rim = [(radius, height - 1.5), (radius - 1.5, height), (radius - wall + 1.5, height)]
    inside = [(radius - wall, height - 1.5), (radius - wall, 40), (radius - wall, 10),
              (radius - 10, 6)]
    turned(surface, outside + rim + inside, 48)
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
    surface.tube(sections, first, last)
    return surface


def cup():
    """A paper cup, 107 mm high, 79 mm across its lid, 52 mm across its foot."""
    surface = Surface()
    wall = [(26 + 11 * k / 10, 96 * k / 10) for k in range(1, 10)]
    lid = [(37, 96), (39.5, 97), (39.5, 101), (35, 107), (33, 107)]
    turned(surface, [(25, 0), (26, 1)] + wall + lid + [(32, 104)], 48)
    return surface


def bowl():
    """A rice bowl, 120 mm across and 60 mm high, its foot 56 mm across."""
    surface = Surface()
    quarter = [math.pi / 2 * k / 10 for k in range(1, 10)]
    outside = [(28 + 32 * math.sin(a), 60 - 54 * math.cos(a)) for a in quarter]
    foot = [(27, 0), (28, 1), (28, 5)]
    rim = [(60, 59), (59, 60), (56.5, 60), (55.5, 58)]
    inside = [(24 + 31 * math.sin(a), 60 - 50 * math.cos(a)) for a in quarter[::-1]]
    turned(surface, foot + outside + rim + inside, 48)
    return surface


def plate():
    """A plate, 210 mm across and 18 mm high."""
    surface = Surface()
    under = [(60, 0), (62, 1), (80, 6), (104, 15)]
    over = [(105, 16.5), (104, 18), (80, 10), (62, 5), (40, 4)]
    turned(surface, under + over, 64)
    return surface


def wine_glass():
    """A wine glass, 169 mm high, its stem 8 mm thick."""
    surface = Surface()
    foot = [(33, 0), (34, 1), (33, 2), (12, 4), (5, 9), (4, 16)]
    stem = [(4, z) for z in (30, 45, 60, 75)]
    outside = [(5, 84), (14, 90), (25, 98), (32, 110), (35, 125), (34, 145), (30, 168)]
    inside = [(29, 169), (28, 168), (32, 145), (33, 125), (30, 111), (23, 101), (10, 93)]
    turned(surface, foot + stem + outside + inside, 40)
    return surface


def screwdriver():
    """A watchmaker's screwdriver, 119 mm long, 10 mm thick, with a cap that turns."""
    surface = Surface()
    blade = [(1, -62), (1.6, -61), (1.6, -10), (3, -8), (4.5, -2)]
    grip = [(5, 10), (5, 25), (5, 40), (3.4, 44), (3.4, 47)]
    turned(surface, blade + grip + [(6.5, 49), (7, 51), (7, 55), (6, 57)])
    return surface


def microphone():
    """A microphone, 169 mm long, 37 mm thick, its ball 54 mm."""
    surface = Surface()
    body = [(15, 0), (17, 2), (17.5, 30), (18.5, 60), (19.5, 90), (21, 118), (22, 122)]
    ball = [(27 * math.sin(a), 142 - 27 * math.cos(a))
            for a in (math.pi * k / 20 for k in range(7, 20))]
    turned(surface, body + ball, 40)
    return surface


def hammer():
    """A hammer along x, 293 mm long, its handle 23 x 32 mm where it is gripped."""
    surface = Surface()
    handle = smooth([(-125, 0, 16, 12), (-105, 0, 17, 13), (-60, 0, 15.5, 11.5), (0, 0, 16, 11.5),
                     (60, 0, 14, 10.5), (110, 0, 13, 10), (130 - GAP, 0, 13, 10)])
    swept(surface, dome(handle[1], handle[0])[::-1] + handle, rounded=False)
    head = [(143, -42, 10, 10), (143, -40, 12, 12), (143, -28, 13, 13), (143, 10, 13, 13),
            (143, 22, 12, 12), (143, 45, 7, 13), (143, 60, 2.5, 13)]
    swept(surface, head, rounded=False)
    return surface


def pliers():
    """Pliers along x, 177 mm long, 56 mm across their handles."""
    surface = Surface()
    disc(surface, 0, 0, 12, 7)
    handle = smooth([(-17.5, 6.5, 5, 5), (-28, 13, 5.5, 6), (-55, 21, 6, 7), (-90, 22, 6, 7),
                     (-120, 19, 6, 7)])
    jaw = [(18, 4.8, 4.5, 6), (30, 5.6, 5, 5.5), (48, 4, 3.4, 4)]
    for half in (handle, mirrored(handle), jaw, mirrored(jaw)):
        swept(surface, half)
    return surface


def scissors():
    """Household scissors along x, closed, 183 mm long, blades 14 mm wide."""
    surface = Surface()
    disc(surface, 0, 0, 6, 4)
    for side in (1, -1):
        shank = [(-6.5 - GAP - 3, 3 * side, 2.8, 3), (-25, 6 * side, 3, 3.2),
                 (-47, 13 * side, 3, 3.2)]
        swept(surface, shank)
        ring(surface, -68.5, 19 * side, 15, 3)
    swept(surface,
          [(9, 0, 7, 1.8), (30, 0, 7, 1.8), (60, 0, 5.5, 1.6), (85, 0, 3, 1.4), (95, 0, 1, 1)])
    return surface


def spoon():
    """A table spoon along x, 194 mm long, flat along y."""
    surface = Surface()
    handle = [(-95, 6, 1.2, 7), (-80, 6, 1.4, 9), (-50, 4, 1.6, 6.5), (-10, 1, 1.8, 4)]
    hollow = [(30, 3, 2, 3.6), (45, 3, 1.8, 7), (60, 0, 1.5, 17), (75, -1, 1.4, 20),
              (88, 1, 1.4, 16), (97, 4, 1.2, 6)]
    swept(surface, smooth(handle + hollow, 5))
    return surface


def banana():
    """A banana along x, bent towards -y, 35 mm thick."""
    surface = Surface()
    stations = []
    for k in range(25):
        a = math.radians(-48 + 96 * k / 24)
        size = 17.5 * min(1, 0.3 + 2.2 * (1 - abs(k - 11) / 13.5)) ** 0.8
        stations.append((115 * math.sin(a), 115 * (math.cos(a) - 1), size, size))
    stem = [(100, -56, 4.2, 4.2), (109, -71, 4.6, 4.6)]
    swept(surface, stations + stem)
    return surface


def bat():
    """A table tennis bat, its handle along -x, its blade 152 mm across."""
    surface = Surface()
    disc(surface, 0, 0, 76, 6)
    handle = smooth([(-76.6 - GAP, 0, 13, 9), (-95, 0, 12, 10), (-130, 0, 12.5, 10.5),
                     (-172, 0, 15, 11.5)])
    swept(surface, handle + dome(handle[-2], handle[-1]), rounded=False)
    return surface


if __name__ == "__main__":
    write_objects(__file__, [mug, cup, bowl, plate, wine_glass, screwdriver, microphone, hammer,
                             pliers, scissors, spoon, banana, bat], decimals=3)
