#!/usr/bin/env python3
"""A chain of 20 alanines that winds up into an alpha helix: 16 frames of XYZ, in angstrom.

usage: helix.py > helix.xyz

Every atom is placed by the bond to the atom before it, the angle of that bond with the one before, and the torsion between them;
the two torsions of the backbone, phi and psi, go from those of a stretched strand to those of the helix.
"""
from math import cos, radians, sin, sqrt

RESIDUES = 20
FRAMES = 16
STRAND, HELIX = (-120.0, 130.0), (-57.0, -47.0)  # phi, psi
TETRAHEDRAL = 109.5


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def unit(a):
    length = sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def place(a, b, c, bond, angle, torsion):
    """The atom at `bond` from c, with the angle b-c-atom and the torsion a-b-c-atom in degrees."""
    along = unit(minus(c, b))
    normal = unit(cross(minus(b, a), along))
    side = cross(normal, along)
    angle, torsion = radians(angle), radians(torsion)
    x, y, z = -bond * cos(angle), bond * sin(angle) * cos(torsion), bond * sin(angle) * sin(torsion)
    return tuple(c[i] + x * along[i] + y * side[i] + z * normal[i] for i in range(3))


def chain(phi, psi):
    """(element, place) of every atom."""
    atoms = []
    n, alpha = (0.0, 0.0, 0.0), (1.458, 0.0, 0.0)
    carbonyl = place((0.0, 1.0, 0.0), n, alpha, 1.525, 111.0, phi)
    for _ in range(RESIDUES):
        beta = place(n, carbonyl, alpha, 1.53, 110.1, 122.5)
        atoms += [("N", n), ("C", alpha), ("C", carbonyl), ("O", place(n, alpha, carbonyl, 1.231, 120.1, psi + 180.0)), ("C", beta)]
        atoms.append(("H", place(carbonyl, alpha, n, 1.01, 119.0, phi + 180.0)))
        atoms.append(("H", place(n, carbonyl, alpha, 1.09, TETRAHEDRAL, -118.5)))
        atoms += [("H", place(n, alpha, beta, 1.09, TETRAHEDRAL, torsion)) for torsion in (60.0, 180.0, 300.0)]
        next_n = place(n, alpha, carbonyl, 1.329, 116.6, psi)
        next_alpha = place(alpha, carbonyl, next_n, 1.458, 121.7, 180.0)
        n, alpha, carbonyl = next_n, next_alpha, place(carbonyl, next_n, next_alpha, 1.525, 111.0, phi)
    return atoms


def centered(atoms):
    middle = [sum(place[i] for _, place in atoms) / len(atoms) for i in range(3)]
    return [(element, minus(place, middle)) for element, place in atoms]


def main():
    for frame in range(FRAMES):
        part = frame / (FRAMES - 1)
        phi, psi = (a + part * (b - a) for a, b in zip(STRAND, HELIX))
        atoms = centered(chain(phi, psi))
        print(f"{len(atoms)}\n{RESIDUES} alanines, phi {phi:.1f}, psi {psi:.1f}")
        for element, place in atoms:
            print(element, *(f"{round(x, 3) + 0.0:.3f}" for x in place))


if __name__ == "__main__":
    main()
