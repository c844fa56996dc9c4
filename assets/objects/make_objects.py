#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the .obj files beside this file: closed surfaces, in millimetres."""
import itertools
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "scripts/objects"))
# pylint: disable=wrong-import-position
from surface import Surface, circle, write_objects

HOLE = 4  # cells a side that are cut out of a surface where another part joins it
THUMB_RING = (9, 35)  # of scissors: its middle towards the blades, and off the fingers


def border(loops, row, column):
    """The vertices round a hole whose lowest cell is (row, column), by their place round its middle."""
    half, found = HOLE // 2, {}
    for r in range(-half, half + 1):
        for c in range(-half, half + 1):
            if max(abs(r), abs(c)) == half:
                loop = loops[(row + half + r) % len(loops)]
                found[c, r] = loop[(column + half + c) % len(loop)]
    return found


def turn_order(places):
    """Counter-clockwise, as seen from where the surface faces."""
    return sorted(places, key=lambda place: math.atan2(place[1], place[0]))


def handle_path(radius, reach, middle, half, steps=24):
    """Points and directions in the xz plane, from the top end to the lower one."""
    def point(angle):
        c, s = math.cos(angle), math.sin(angle)
        return radius + reach * max(c, 0) ** 0.6, middle + half * math.copysign(abs(s) ** 0.6, s)

    for k in range(1, steps):
        angle = math.pi * (0.5 - k / steps)
        (x0, z0), (x1, z1) = point(angle + 1e-4), point(angle - 1e-4)
        length = math.hypot(x1 - x0, z1 - z0)
        yield point(angle), ((x1 - x0) / length, (z1 - z0) / length)


def mug(radius=40.0, height=95.0, wall=4.0):
    """A mug, 80 mm across, 95 mm high, with a handle along x."""
    surface = Surface()
    profile = [(radius - 3, 0), (radius - 0.9, 0.9), (radius, 3)]
    profile += [(radius, 3 + 90 * i / 22) for i in range(1, 23)]
    outside = [surface.loop(circle(r, z)) for r, z in profile]
    holes = {row: border(outside, row, -HOLE // 2) for row in (4, 17)}
    for row in range(len(outside) - 1):
        cut = any(hole <= row < hole + HOLE for hole in holes)
        surface.band(outside[row], outside[row + 1], range(-HOLE // 2, HOLE // 2) if cut else ())

    edge = wall / 2
    rim = [math.pi * i / 6 for i in range(1, 7)]
    profile = [(radius - edge + edge * math.cos(a), height - edge + edge * math.sin(a)) for a in rim]
    profile += [(radius - wall, z) for z in (70, 50, 30, 10)]
    profile += [(30 + 6 * math.cos(a), 10 - 6 * math.sin(a)) for a in (0.5, 1.0, math.pi / 2)]
    profile += [(15, 4)]
    last = outside[-1]
    for r, z in profile:
        following = surface.loop(circle(r, z))
        surface.band(last, following)
        last = following
    surface.cap(last, (0, 0, 4))
    inner = surface.loop(circle(18, 0))
    surface.band(inner, outside[0])
    surface.cap(inner[::-1], (0, 0, 0))

    top, bottom = holes[17], holes[4]
    order = turn_order(top)
    z = [sum(surface.vertices[v][2] for v in hole.values()) / len(hole) for hole in (bottom, top)]
    last = [top[place] for place in order]
    for (x, at), (dx, dz) in handle_path(radius, 32, sum(z) / 2, (z[1] - z[0]) / 2):
        section = []
        for c, r in order:
            u, v = 6 * c / math.hypot(c, r), 4 * r / math.hypot(c, r)
            section.append((x - v * dz, u, at + v * dx))
        following = surface.loop(section)
        surface.band(last, following)
        last = following
    surface.band(last, [bottom[c, -r] for c, r in order])
    return surface


def ring_with_hole(surface, y, towards, inner=28.0, wire=7.0, rounds=48, sides=16):
    """A ring round z; the hole in its outside at the angle `towards` is returned as by border()."""
    middle, loops = (inner + wire) / 2, []
    for i in range(rounds):
        a, points = -2 * math.pi * i / rounds, []
        for j in range(sides):
            b = 2 * math.pi * j / sides
            r = middle + wire / 2 * math.cos(b)
            points.append((r * math.cos(a), y + r * math.sin(a), wire / 2 * math.sin(b)))
        loops.append(surface.loop(points))
    row = round(-towards / (2 * math.pi) * rounds) % rounds - HOLE // 2
    for i in range(rounds):
        cut = row <= i < row + HOLE
        surface.band(loops[i], loops[(i + 1) % rounds], range(-HOLE // 2, HOLE // 2) if cut else ())
    return border(loops, row, -HOLE // 2)


def finger_rings():
    """Two finger rings of 28 mm, joined, as on a pair of scissors."""
    surface = Surface()
    one = ring_with_hole(surface, -24, math.pi / 2)
    other = ring_with_hole(surface, 24, -math.pi / 2)
    order = turn_order(one)
    surface.band([one[place] for place in order], [other[c, -r] for c, r in order])
    return surface


def to_segment(x, y, start, end):
    """Distance in the plane, and how far along the segment the nearest point is, 0 to 1."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    t = ((x - start[0]) * dx + (y - start[1]) * dy) / (dx * dx + dy * dy)
    t = min(max(t, 0), 1)
    return math.hypot(x - start[0] - t * dx, y - start[1] - t * dy), t


def scissors_distance(x, y, z, wire=3.0):
    """Closed scissors in the xy plane: below 0 inside. The fingers' bow is round the origin."""
    bow = abs(to_segment(x, y, (-26, 0), (26, 0))[0] - 16)
    thumb = abs(math.hypot(x + THUMB_RING[0], y - THUMB_RING[1]) - 19)
    shanks = [to_segment(x, y, start, (-82, 16))[0] for start in ((-41, 5), (-25, 45))]
    solid = math.hypot(min(bow, thumb, *shanks), z) - wire
    across, t = to_segment(x, y, (-78, 16), (-150, 16))
    return min(solid, (math.hypot(across, z * (1.6 + t)) - 6 + 4 * t) / (1.6 + t))


def scissors(step=2.0):
    """Scissors: a bow for four fingers and a thumb ring."""
    # Marching tetrahedra: each cube is cut into the six that share its diagonal.
    low, counts = (-155.1, -21.7, -5.05), (102, 42, 6)
    around = (1, 3, 2, 6, 4, 5, 1)  # corners of a cube round its diagonal from 0 to 7
    tetrahedra = [(0, a, b, 7) for a, b in itertools.pairwise(around)]
    surface, values, cuts = Surface(), {}, {}

    def place(corner):
        return tuple(a + step * i for a, i in zip(low, corner))

    def value(corner):
        if corner not in values:
            d = scissors_distance(*place(corner))
            values[corner] = math.copysign(max(abs(d), step / 30), d)  # no slivers
        return values[corner]

    def cut(inside, outside):
        if (inside, outside) not in cuts:
            t = value(inside) / (value(inside) - value(outside))
            pair = zip(place(inside), place(outside))
            cuts[inside, outside] = surface.loop([tuple(a + t * (b - a) for a, b in pair)])[0]
        return cuts[inside, outside]

    for x, y, z in itertools.product(*map(range, counts)):
        cube = [(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2)) for k in range(8)]
        if len({value(corner) < 0 for corner in cube}) == 1:
            continue
        for tetrahedron in tetrahedra:
            surface.faces += cut_tetrahedron([cube[k] for k in tetrahedron], value, cut)
    return surface


def cut_tetrahedron(corners, value, cut):
    """The faces between the corners inside and those outside; corners as a right-handed frame."""
    inside = [i for i in range(4) if value(corners[i]) < 0]
    outside = [i for i in range(4) if i not in inside]
    if not inside or not outside:
        return []
    order = inside + outside
    even = sum(a > b for a, b in itertools.combinations(order, 2)) % 2 == 0
    ring = [cut(corners[i], corners[o]) for i in inside for o in outside]
    if len(ring) == 4:
        ring[2], ring[3] = ring[3], ring[2]
    if not even:
        ring.reverse()
    return [(ring[0], ring[i], ring[i + 1]) for i in range(1, len(ring) - 1)]


if __name__ == "__main__":
    write_objects(__file__, [mug, finger_rings, scissors])
