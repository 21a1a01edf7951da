"""From arrays to pictures."""

from __future__ import annotations

import atexit
import os
from typing import Any, Literal

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _native
from .arrays import path_bytes, sphere_arrays
from .camera import Camera
from .light import Light, Sun
from .light import arguments as light_arguments

# GL is closed while its driver still works; and what a child of fork() has of it is of no use there.
atexit.register(_native.close_renderers)
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_native.forget_renderers)


def render(
    centers: ArrayLike,
    radii: ArrayLike,
    colors: ArrayLike,
    camera: Camera | Literal["fit"] | None = None,
    size: tuple[int, int] = (1000, 1000),
    samples: int = 1,
    shade: str = "flat",
    backend: str = "auto",
    *,
    background: str = "black",
    hidden: ArrayLike | None = None,
    light: Light | None = None,
    lights: int | None = None,
    sky: float | None = None,
    key: float | None = None,
    sun: Sun | None = None,
    sun_strength: float | None = None,
) -> NDArray[numpy.uint8]:
    """The picture of N spheres: uint8, (height, width, 3), top row first; with a transparent background (height, width, 4).

    It is what `sphereview render` makes of a file with these spheres, byte for byte, whatever the backend.

    centers: (N, 3), in scene space: +x is right, +y up, +z into the picture. Finite.
    radii: (N,), or one for all, in the same unit. Above 0 and finite.
    colors: (N, 3), or (3,) for all: integers of any type from 0 to 255, or floats from 0 to 1, of which 255 c is rounded.
    camera: from where; None is the text format's eye (0, 0, 0) with the screen (-50, -50, 100) .. (50, 50, 100). "fit" looks the same
        way and sees everything.
    size: (width, height) in pixels. The array's shape has the height first.
    samples: points a pixel, whose colours are averaged: 1, 4 or 16.
    shade: "flat", "headlight", "normal", "depth", "id" or "studio".
    backend: "auto", "egl", "osmesa", "wgl" (Windows) or "cpu". "auto" is the variable SPHEREVIEW_BACKEND where that is set, else the best that works. One
        that you name is never replaced silently.
    background: "black", "white", "transparent" or "#rrggbb".
    hidden: (N,) bool; True: the sphere is not drawn, but counts where spheres are numbered (shade="id").
    light: with shade="studio"; None is Light().

    Also with shade="studio", each instead of what `light` says:

    lights: directions of the sky's light, 16 to 1024.
    sky: strength of the sky and of the key light in it, 0 to 1.
    key: how much brighter the sky is around the key light, 0 to 1.
    sun: a sun: (x, y, z), not all 0, from the scene to the sun; or (azimuth, elevation) in degrees, from where it shines as `fit`'s view
        looks. The sky makes room for it where neither says how strong it is.
    sun_strength: 0.001 to 4.

    Of spheres that a ray hits at the same place the first is seen. float64 arrays in C order are read in place; others are converted.
    Other threads of Python run meanwhile, and Ctrl+C interrupts.

    ValueError: what is wrong, in the command line's words. MemoryError: it does not fit. RuntimeError: nothing here can render it.
    """
    arrays = sphere_arrays(centers, radii, colors, hidden)
    fitted = isinstance(camera, str)
    if fitted and camera != "fit":
        raise ValueError(f"camera: found {camera!r}, expected a Camera, 'fit' or None")
    numbers = camera.numbers() if isinstance(camera, Camera) else None
    return _native.render(arrays, numbers, fitted, size, samples, shade, backend, background, *_lit(light, lights, sky, key, sun, sun_strength))


def explain(
    centers: ArrayLike,
    radii: ArrayLike,
    colors: ArrayLike,
    pixel: tuple[int, int],
    camera: Camera | None = None,
    size: tuple[int, int] = (1000, 1000),
    shade: str = "flat",
    *,
    background: str = "black",
    hidden: ArrayLike | None = None,
    light: Light | None = None,
    lights: int | None = None,
    sky: float | None = None,
    key: float | None = None,
    sun: Sun | None = None,
    sun_strength: float | None = None,
    names: dict[int, str] | None = None,
    name: str = "the scene",
) -> str:
    """The arithmetic of one pixel, in the words of `sphereview explain`: its ray, every sphere that the ray hits, and which one shows.

    pixel: (x, y): column from the left and row from the top, from 0. names: of spheres, by their numbers. name: how the text calls the
    scene. The rest is as for render().
    """
    arrays = sphere_arrays(centers, radii, colors, hidden)
    lit = _lit(light, lights, sky, key, sun, sun_strength)
    return _native.explain(arrays, (camera or Camera()).numbers(), names or {}, background, pixel, size, shade, *lit, name)


def _lit(light: Light | None, *instead: Any) -> tuple[Any, Any]:
    """The light, and what replaces parts of it, as the native module takes them."""
    return (light or Light()).numbers(), light_arguments(*instead)


def read_png(path: str | os.PathLike[str]) -> NDArray[numpy.uint8]:
    """The picture in a PNG of any kind with up to 8 bits a channel: uint8, (height, width, 3), or 4 where it has transparency."""
    return _native.read_png(path_bytes(path))


def write_png(path: str | os.PathLike[str], image: NDArray[numpy.uint8]) -> None:
    """Writes a picture, uint8 of the shape (height, width, 3 or 4). The file appears whole or not at all."""
    _native.write_png(path_bytes(path), image_array(image))


def image_array(image: ArrayLike) -> NDArray[numpy.uint8]:
    """The picture as the native module takes it."""
    array = numpy.asarray(image)
    if array.dtype != numpy.uint8:
        raise ValueError(f"found a picture of {array.dtype}, expected uint8")
    return numpy.ascontiguousarray(array)
