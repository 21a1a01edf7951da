#!/usr/bin/env python3
"""Writes a drop that swings, as balls on its surface, in extended XYZ: each with how far the drop reaches there.

usage: drop.py [BALLS]
"""

import math
import sys


def main():
    balls = int(sys.argv[1]) if len(sys.argv) > 1 else 4000
    turn = math.pi * (3.0 - math.sqrt(5.0))  # the golden angle spreads the balls evenly
    print(balls)
    print("Properties=pos:R:3:radius:R:1:height:R:1")
    for i in range(balls):
        z = 1.0 - (2.0 * i + 1.0) / balls
        across = math.sqrt(1.0 - z * z)
        angle = turn * i
        x, y = across * math.cos(angle), across * math.sin(angle)
        # The fourth mode of a sphere with the symmetry of a cube.
        height = 5.0 * (x**4 + y**4 + z**4) - 3.0
        reach = 10.0 + 1.5 * height
        print(f"{reach * x:.3f} {reach * z:.3f} {reach * y:.3f} 0.34 {1.5 * height:.4f}")


if __name__ == "__main__":
    main()
