"""Writes scenes for Tachyon and POV-Ray: the picture that sphereview draws of them, in flat colours without shadows, or lit from
many directions."""
from collections.abc import Iterator
from pathlib import Path

SIDE = 1000  # of the pictures, in pixels

TACHYON_BEGIN = f"""BEGIN_SCENE
RESOLUTION {SIDE} {SIDE}
CAMERA
  ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 1
  CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0
END_CAMERA
BACKGROUND 0 0 0
"""

POVRAY_BEGIN = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, 0> direction <0, 0, 100> right <100, 0, 0> up <0, 100, 0> }
"""


def spheres(scene: Path) -> Iterator[tuple[list[int], list[str], str]]:
    """Colour, centre and radius of each; of a scene as make_scene writes it, with three lines for every sphere."""
    with scene.open() as file:
        next(file)  # their number
        for color, center, radius in zip(file, file, file):
            yield [int(channel) for channel in color.split()], center.split(), radius.strip()


def shift_into_view(scene: Path) -> tuple[float, float, float]:
    """What brings a scene of any place before the camera that looks from (0, 0, 0) along z, as large as it is seen whole."""
    places = [([float(coordinate) for coordinate in center], float(radius)) for _, center, radius in spheres(scene)]
    low = [min(center[axis] - radius for center, radius in places) for axis in range(3)]
    high = [max(center[axis] + radius for center, radius in places) for axis in range(3)]
    return (-0.5 * (low[0] + high[0]), -0.5 * (low[1] + high[1]), max(high[0] - low[0], high[1] - low[1]) - low[2])


# An area light that is this wide, from where the key light comes: so many lights along a side, all of them asked for each point.
POVRAY_LIGHT = """#default { finish { ambient 0.1 diffuse 0.8 } }
light_source { <-45e3, 75e3, -55e3> rgb 1 parallel point_at <0, 0, 400> area_light <40e3, 0, 0>, <0, 0, 40e3>, {side}, {side} }
"""


def write_tachyon(scene: Path, path: Path, lit: bool = False, shift: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> None:
    """`shift`: of all centres."""
    # Its rays go through the corners of the pixels; the whole scene is sheared by half a pixel to make up for that. It rounds
    # colours down.
    half_pixel = 0.5 / SIDE
    finish = "AMBIENT 0 DIFFUSE 1" if lit else "AMBIENT 1 DIFFUSE 0"
    with path.open("w") as out:
        out.write(TACHYON_BEGIN)
        for color, center, radius in spheres(scene):
            x, y, z = (float(coordinate) + by for coordinate, by in zip(center, shift))
            rgb = " ".join(f"{(channel + 0.5) / 255:.6f}" for channel in color)
            out.write(f"SPHERE CENTER {x + half_pixel * z!r} {y + half_pixel * z!r} {z!r} RAD {radius} "
                      f"TEXTURE {finish} SPECULAR 0 OPACITY 1 COLOR {rgb} TEXFUNC 0\n")
        out.write("END_SCENE\n")


def write_povray(scene: Path, path: Path, lights_along: int = 0) -> None:
    """Lit by lights_along x lights_along lights, if there are any."""
    with path.open("w") as out:
        out.write(POVRAY_BEGIN)
        if lights_along:
            out.write(POVRAY_LIGHT.replace("{side}", str(lights_along)))
        for color, center, radius in spheres(scene):
            rgb = ",".join(f"{channel / 255:.6f}" for channel in color)
            out.write(f"sphere{{<{','.join(center)}>,{radius} pigment{{rgb<{rgb}>}}}}\n")
