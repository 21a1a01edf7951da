#!/usr/bin/env python3
"""Eric Haines' sphereflake: each sphere carries nine of a third of its radius, six around its middle and three on top of it.

usage: sphereflake.py [DEPTH] > sphereflake.txt

Depth 6, the default, has 597,871 spheres, depth 7 has 5,380,840; they appear before the default camera.
"""
import sys
from math import sqrt

COLORS = [(240, 190, 60), (200, 80, 60), (120, 60, 140), (60, 110, 190), (70, 170, 150), (170, 200, 90), (240, 240, 220)]


def unit(v):
    length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    return (v[0] / length, v[1] / length, v[2] / length)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def child_directions():
    """With the parent's axis as third coordinate: the nine of twelve neighbours in a close packing that do not lie below."""
    around = [(1.0, 0.0), (0.5, sqrt(0.75)), (-0.5, sqrt(0.75)), (-1.0, 0.0), (-0.5, -sqrt(0.75)), (0.5, -sqrt(0.75))]
    top = [(0.0, 1.0), (-sqrt(0.75), -0.5), (sqrt(0.75), -0.5)]
    return [(x, y, 0.0) for x, y in around] + [(x / sqrt(3.0), y / sqrt(3.0), sqrt(2.0 / 3.0)) for x, y in top]


def flake(center, radius, axis, depth, level, write):
    write("%d %d %d\n%.9g %.9g %.9g\n%.9g\n" % (*COLORS[level % len(COLORS)], *center, radius))
    if level == depth:
        return
    # Any two directions that are perpendicular to the axis and to each other.
    right = unit(cross(axis, (0.0, 0.0, 1.0) if abs(axis[2]) < 0.9 else (1.0, 0.0, 0.0)))
    up = cross(axis, right)
    for x, y, z in DIRECTIONS:
        out = tuple(x * right[i] + y * up[i] + z * axis[i] for i in range(3))
        place = tuple(center[i] + radius * 4.0 / 3.0 * out[i] for i in range(3))
        flake(place, radius / 3.0, out, depth, level + 1, write)


DIRECTIONS = child_directions()


def main():
    depth = int(sys.argv[1]) if len(sys.argv) > 1 else 6
    sys.stdout.write(f"{(9 ** (depth + 1) - 1) // 8}\n")
    flake((0.0, 0.0, 320.0), 65.0, unit((0.15, 0.8, -0.6)), depth, 0, sys.stdout.write)


if __name__ == "__main__":
    main()
