# SPDX-License-Identifier: MIT
"""Closed surfaces in millimetres, and the bodies that objects are put together from.

A list of objects is a file make_objects.py beside its .obj files: functions that return surfaces.
"""
import argparse
import math
import pathlib

SIDES = 24  # of a swept section


class Surface:
    """Loops of vertices joined by bands; every face is counter-clockwise from outside."""

    def __init__(self):
        self.vertices, self.faces = [], []

    def loop(self, points):
        self.vertices += points
        return list(range(len(self.vertices) - len(points), len(self.vertices)))

    def band(self, below, above, skipped=()):
        """Two triangles a column between two loops, but for the columns `skipped`."""
        count = len(below)
        skipped = {column % count for column in skipped}
        for i in (i for i in range(count) if i not in skipped):
            j = (i + 1) % count
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

    def obj(self, what, decimals):
        """The text of an .obj file."""
        vertex = " ".join(["v"] + [f"%.{decimals}f"] * 3)
        lines = [f"# {what} Millimetres. Made by make_objects.py, MIT."]
        lines += [vertex % v for v in self.vertices]
        lines += ["f %d %d %d" % tuple(i + 1 for i in face) for face in self.faces]
        return "\n".join(lines) + "\n"


def circle(radius, z, count=64):
    """Round z, counter-clockwise from above."""
    turn = 2 * math.pi / count
    return [(radius * math.cos(i * turn), radius * math.sin(i * turn), z) for i in range(count)]


def turned(surface, profile, sides=32):
    """A body round z: (radius, z) from the middle of its bottom to that of its top."""
    sections = [circle(r, z, sides) for r, z in profile]
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


def write_objects(place, makers, decimals=4):
    """Writes each maker's surface to a file of the maker's name, its docstring in the first line.

    They go to the folder of the file `place` or to the one that the command line names.
    """
    parser = argparse.ArgumentParser(description="Makes the .obj files of this folder.")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path(place).parent)
    folder = parser.parse_args().folder
    for make in makers:
        text = make().obj(make.__doc__, decimals)
        (folder / f"{make.__name__}.obj").write_text(text)
