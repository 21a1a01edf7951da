"""From where a scene is seen."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from numpy.typing import ArrayLike

from . import _native
from .arrays import sphere_arrays

Vector = tuple[float, float, float]

Projection = Literal["perspective", "orthographic"]

# "front", "back", "left", "right", "top", "bottom", "iso", or azimuth and elevation in degrees.
View = str | tuple[float, float]


@dataclass(frozen=True)
class Camera:
    """An eye and a screen, in the scene's coordinates and unit: +x is right, +y up, +z into the picture.

    `right` and `up` lead from the screen's centre to the middle of its edges. They are perpendicular and equally long (within 1e-6), and
    the eye lies off the screen's plane; otherwise ValueError. The defaults are those of the text format. The ray through the centre of
    pixel (i, j) of a W x H picture, (0, 0) at the top left, is eye + t D with m = min(W, H) and

        D = (center - eye) + (2i + 1 - W) / m right + (H - 1 - 2j) / m up

    With projection="orthographic" all rays are parallel: D = center - eye, from the point eye + (2i + 1 - W) / m right +
    (H - 1 - 2j) / m up.
    """

    eye: Vector = (0.0, 0.0, 0.0)
    center: Vector = (0.0, 0.0, 100.0)
    right: Vector = (50.0, 0.0, 0.0)
    up: Vector = (0.0, 50.0, 0.0)
    projection: Projection = "perspective"

    def __post_init__(self) -> None:
        for name in ("eye", "center", "right", "up"):
            vector = tuple(float(x) for x in getattr(self, name))
            if len(vector) != 3:
                raise ValueError(f"{name}: found {len(vector)} numbers, expected 3")
            object.__setattr__(self, name, vector)
        if self.projection not in ("perspective", "orthographic"):
            raise ValueError(f"projection: found {self.projection!r}, expected 'perspective' or 'orthographic'")
        _native.check_camera(self.numbers())

    def numbers(self) -> tuple[float, ...]:
        """Eye, center, right and up, and 0 for perspective or 1 for orthographic."""
        return (*self.eye, *self.center, *self.right, *self.up, float(self.projection == "orthographic"))

    @classmethod
    def from_numbers(cls, numbers: tuple[float, ...]) -> Camera:
        """The camera with the numbers that numbers() gives."""
        x = tuple(numbers)
        projection: Projection = "orthographic" if x[12] else "perspective"
        return cls(x[0:3], x[3:6], x[6:9], x[9:12], projection)  # type: ignore[arg-type]


def view_text(view: View | None) -> str | None:
    """As the command line spells it."""
    if view is None or isinstance(view, str):
        return view
    azimuth, elevation = view
    return f"{float(azimuth)!r},{float(elevation)!r}"


def fit(
    centers: ArrayLike,
    radii: ArrayLike,
    view: View | None = None,
    *,
    camera: Camera | None = None,
    right_handed: bool = False,
    hidden: ArrayLike | None = None,
) -> Camera:
    """The nearest camera that sees all spheres, with the default camera's field of view.

    centers: (N, 3), radii: (N,) or one for all, in the scene's unit.
    view: from where: "front", "back", "left", "right", "top", "bottom", "iso", or (azimuth, elevation) in degrees; (0, 0) is the front,
        azimuth goes round towards +x, elevation up. None: the way that `camera` looks.
    camera: what `view` and the hand are relative to, and whose projection is kept; None is the default camera.
    right_handed: with camera=None: the coordinates are right-handed, as those of molecules usually are; the camera is mirrored, so that
        the picture is not.

    hidden: (N,) bool; True: the sphere does not count.

    The camera is the same doubles on every machine. It does not depend on a picture's size.
    """
    arrays = sphere_arrays(centers, radii, (0, 0, 0), hidden)
    right_handed = right_handed and camera is None
    return Camera.from_numbers(_native.fit(arrays, (camera or Camera()).numbers(), right_handed, view_text(view)))
