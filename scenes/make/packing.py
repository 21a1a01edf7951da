#!/usr/bin/env python3
"""Balls packed at random into a larger one, half of which is cut away: CSV with radius and colour.

usage: packing.py [SEED] > packing.csv

Random sequential addition: a ball of the present radius is tried at random places and stays where it touches no other; after
many that did not fit, the radius becomes smaller.
"""
import random
import sys
from math import ceil

CONTAINER = 50.0
RADII = [9.0 * 0.85 ** step for step in range(14)]  # 9 .. 1.1
TRIES = 4000  # for each radius
CELL = 2 * RADII[0]


def color(radius):
    """From deep blue for the smallest to pale gold for the largest."""
    part = (radius - RADII[-1]) / (RADII[0] - RADII[-1])
    return [round(low + part * (high - low)) for low, high in ((35, 250), (70, 205), (160, 95))]


def main():
    generator = random.Random(int(sys.argv[1]) if len(sys.argv) > 1 else 1)
    grid = {}

    def fits(ball):
        x, y, z, r = ball
        if x * x + y * y + z * z > (CONTAINER - r) ** 2:
            return False
        cell = [ceil(v / CELL) for v in (x, y, z)]
        near = (grid.get((cell[0] + i, cell[1] + j, cell[2] + k), []) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1))
        return all((x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2 >= (r + s) ** 2 for balls in near for a, b, c, s in balls)

    print("x,y,z,radius,r,g,b")
    for radius in RADII:
        for _ in range(TRIES):
            # Rounded at once, so that what is written does not overlap.
            ball = tuple(round(CONTAINER * (2.0 * generator.random() - 1.0), 2) for _ in range(3)) + (round(radius, 2),)
            if ball[2] - ball[3] < 0.0 or not fits(ball):
                continue
            grid.setdefault(tuple(ceil(v / CELL) for v in ball[:3]), []).append(ball)
            print(*(f"{v + 0.0:.2f}" for v in ball), *color(radius), sep=",")


if __name__ == "__main__":
    main()
