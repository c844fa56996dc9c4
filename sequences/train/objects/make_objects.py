#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the .obj files beside this file: closed surfaces round z, in millimetres."""
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[3] / "scripts/objects"))
# pylint: disable=wrong-import-position
from surface import Surface, write_objects

ROUND = 2  # exponent of a cross-section that is an ellipse; larger ones are rounded boxes
COUNT = 36  # vertices of a cross-section


def outline(half_x, half_y, z, exponent):
    """A superellipse, counter-clockwise from above."""
    points = []
    for i in range(COUNT):
        c, s = (f(2 * math.pi * i / COUNT) for f in (math.cos, math.sin))
        size = (abs(c) ** exponent + abs(s) ** exponent) ** (-1 / exponent)
        points.append((half_x * c * size, half_y * s * size, z))
    return points


def finer(sections, step=5.0):
    """More cross-sections, so that no triangle is much longer than `step`."""
    fine = [sections[0]]
    for a, b in zip(sections, sections[1:]):
        count = max(1, math.ceil(max(abs(p - q) for p, q in zip(a[:3], b[:3])) / step))
        fine += [tuple(p + (q - p) * k / count for p, q in zip(a, b)) for k in range(1, count + 1)]
    return fine


def shrunk(section):
    return (*(0.02 * width for width in section[:2]), *section[2:])


def through(sections):
    """The surface of cross-sections (half width, half depth, z, exponent), z not falling."""
    sections = finer(sections)
    sections = [shrunk(sections[0]), *sections, shrunk(sections[-1])]
    surface = Surface()
    loops = [surface.loop(outline(*section)) for section in sections]
    for below, above in zip(loops, loops[1:]):
        surface.band(below, above)
    bottom, top = surface.loop([(0, 0, sections[0][2]), (0, 0, sections[-1][2])])
    for i in range(COUNT):
        j = (i + 1) % COUNT
        surface.faces += [(loops[0][j], loops[0][i], bottom), (loops[-1][i], loops[-1][j], top)]
    return surface


def turned(*profile):
    """What comes from a lathe: (diameter, z)."""
    return through([(d / 2, d / 2, z, ROUND) for d, z in profile])


def egg():
    """A hen's egg, 44 mm across, 58 mm high."""
    heights = [math.pi * k / 24 for k in range(1, 24)]
    return turned(*((44 * math.sin(a) * (1 + 0.12 * math.cos(a)), -29 * math.cos(a)) for a in heights))


def torch():
    """A torch, 185 mm long: a tube of 33 mm, a head of 50 mm."""
    return turned((30, 0), (33, 2), (33, 130), (50, 146), (50, 183), (47, 185))


def door_knob():
    """A door knob of 58 mm on a neck of 22 mm."""
    return turned((48, 0), (48, 5), (22, 6), (22, 28), (40, 33), (54, 40), (58, 48), (54, 56),
                  (42, 62), (20, 65))


def knife_handle():
    """A knife's handle, 125 mm long, 30 x 20 mm."""
    return through([(13, 8, 0, 2.5), (15, 10, 4, 2.5), (15, 10, 60, 2.5), (13, 9, 90, 2.5),
                    (15, 9.5, 118, 2.5), (12, 8, 125, 2.5)])


def perfume():
    """A perfume bottle, 62 x 30 mm, with a round cap."""
    return through([(30, 14, 0, 8), (31, 15, 2, 8), (31, 15, 70, 8), (24, 13, 76, 4),
                    (11, 11, 80, ROUND), (11, 11, 104, ROUND), (10, 10, 105, ROUND)])


if __name__ == "__main__":
    write_objects(__file__, [egg, torch, door_knob, knife_handle, perfume])
