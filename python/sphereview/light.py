"""What lights a scene with shade="studio"."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from . import _native
from .camera import Vector

# (x, y, z), from the scene to the sun; or (azimuth, elevation) in degrees, from where the sun shines as a view looks; or either as the
# command line spells it.
Sun = str | tuple[float, float, float] | tuple[float, float]


@dataclass(frozen=True)
class Light:
    """A sky all round with a soft key light in it, and perhaps a sun.

    sky: strength of the sky and of the key light in it, 0 to 1; None: 1, and 0.4 beside a sun.
    key: how much brighter the sky is around the key light, 0 to 1.
    sun: the direction from the scene to a sun: (x, y, z), of any length but 0. None: there is none.
    sun_strength: 0.001 to 4. None: 0.7, and 1 where the sky's is said.
    lights: directions of the sky's light, 16 to 1024; None: 256, and 64 with several samples a pixel or more than 300,000 spheres.

    The defaults are those of a native scene.
    """

    sky: float | None = None
    key: float = 1.0
    sun: Vector | None = None
    sun_strength: float | None = None
    lights: int | None = None

    def __post_init__(self) -> None:
        if self.sun is not None and (isinstance(self.sun, str) or len(self.sun) != 3):
            raise ValueError(f"sun: found {self.sun!r}, expected (x, y, z)")
        lights, sky, key, sun, strength = _native.light(arguments(self.lights, self.sky, self.key, self.sun, self.sun_strength))
        for name, value in (("lights", lights), ("sky", sky), ("key", key), ("sun", sun and tuple(sun)), ("sun_strength", strength)):
            object.__setattr__(self, name, value)

    def numbers(self) -> Any:
        """As the native module takes it: lights, sky, key, sun and sun_strength."""
        return (self.lights, self.sky, self.key, self.sun, self.sun_strength)

    @classmethod
    def from_numbers(cls, numbers: Any) -> Light:
        """The light with the numbers that numbers() gives."""
        lights, sky, key, sun, strength = numbers
        return cls(sky, key, sun and tuple(sun), strength, lights)


def arguments(lights: int | None, sky: float | None, key: float | None, sun: Sun | None, sun_strength: float | None) -> Any:
    """As the native module takes what replaces parts of a light."""
    direction = sun if sun is None or isinstance(sun, str) else ",".join(repr(float(x)).removesuffix(".0") for x in sun)
    return (lights, sky, key, direction, sun_strength)
