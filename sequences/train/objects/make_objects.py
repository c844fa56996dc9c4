#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the .obj files beside this file: closed surfaces round z, in millimetres."""
import math
import pathlib

ROUND = 2  # exponent of a cross-section that is an ellipse; larger ones are rounded boxes
COUNT = 36  # vertices of a cross-section


def loop(half_x, half_y, z, exponent):
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


def write(name, what, sections):
    """The surface through cross-sections (half width, half depth, z, exponent), z not falling."""
    sections = finer(sections)
    sections = [(*(0.02 * w for w in s[:2]), *s[2:]) if end else s
                for s, end in [(sections[0], True)] + [(s, False) for s in sections] + [(sections[-1], True)]]
    vertices = [point for section in sections for point in loop(*section)]
    faces = []
    for row in range(len(sections) - 1):
        for i in range(COUNT):
            a, b = row * COUNT + i, row * COUNT + (i + 1) % COUNT
            faces += [(a, b, b + COUNT), (a, b + COUNT, a + COUNT)]
    bottom, top = (0, 0, sections[0][2]), (0, 0, sections[-1][2])
    vertices += [bottom, top]
    last = (len(sections) - 1) * COUNT
    for i in range(COUNT):
        j = (i + 1) % COUNT
        faces += [(j, i, len(vertices) - 2), (last + i, last + j, len(vertices) - 1)]
    lines = [f"# {what} Millimetres. Made by make_objects.py, MIT."]
    lines += ["v %.4f %.4f %.4f" % v for v in vertices]
    lines += ["f %d %d %d" % tuple(i + 1 for i in face) for face in faces]
    (pathlib.Path(__file__).parent / name).write_text("\n".join(lines) + "\n")


def turned(*profile):
    """Cross-sections of what comes from a lathe: (diameter, z)."""
    return [(d / 2, d / 2, z, ROUND) for d, z in profile]


def egg():
    heights = [math.pi * k / 24 for k in range(1, 24)]
    return turned(*((44 * math.sin(a) * (1 + 0.12 * math.cos(a)), -29 * math.cos(a)) for a in heights))


if __name__ == "__main__":
    write("egg.obj", "A hen's egg, 44 mm across, 58 mm high.", egg())
    write("torch.obj", "A torch, 185 mm long: a tube of 33 mm, a head of 50 mm.",
          turned((30, 0), (33, 2), (33, 130), (50, 146), (50, 183), (47, 185)))
    write("door_knob.obj", "A door knob of 58 mm on a neck of 22 mm.",
          turned((48, 0), (48, 5), (22, 6), (22, 28), (40, 33), (54, 40), (58, 48), (54, 56),
                 (42, 62), (20, 65)))
    write("knife_handle.obj", "A knife's handle, 125 mm long, 30 x 20 mm.",
          [(13, 8, 0, 2.5), (15, 10, 4, 2.5), (15, 10, 60, 2.5), (13, 9, 90, 2.5), (15, 9.5, 118, 2.5),
           (12, 8, 125, 2.5)])
    write("perfume.obj", "A perfume bottle, 62 x 30 mm, with a round cap.",
          [(30, 14, 0, 8), (31, 15, 2, 8), (31, 15, 70, 8), (24, 13, 76, 4), (11, 11, 80, ROUND),
           (11, 11, 104, ROUND), (10, 10, 105, ROUND)])
