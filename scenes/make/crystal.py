#!/usr/bin/env python3
"""Rock salt with a corner broken off: extended XYZ, in angstrom.

usage: crystal.py > crystal.extxyz
"""

SIDE = 11        # ions
DISTANCE = 2.82  # between neighbours


def main():
    ions = [(x, y, z) for x in range(SIDE) for y in range(SIDE) for z in range(SIDE) if x + y + SIDE - 1 - z < 21]
    edge = SIDE * DISTANCE
    print(len(ions))
    print(f'Lattice="{edge:.2f} 0 0 0 {edge:.2f} 0 0 0 {edge:.2f}" Properties=species:S:1:pos:R:3')
    for place in ions:
        print("Na" if sum(place) % 2 == 0 else "Cl", *(f"{DISTANCE * i:.2f}" for i in place))


if __name__ == "__main__":
    main()
