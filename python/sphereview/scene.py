"""Scenes with all their properties, and reading them."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy
from numpy.typing import NDArray

from . import _native
from .arrays import path_bytes
from .camera import Camera, View, view_text
from .camera import fit as fit_camera
from .light import Light, Sun
from .pictures import explain, render


@dataclass(frozen=True, eq=False)
class Scene:
    """Spheres, and how they are seen. `read` makes one; so can you, of any arrays that `render` takes."""

    centers: NDArray[numpy.float64]  #: (N, 3), in scene space
    radii: NDArray[numpy.float64]  #: (N,), in the same unit
    colors: NDArray[Any]  #: (N, 3), 0..255 or 0..1
    camera: Camera | Literal["fit"] | None = None
    background: str = "black"
    hidden: NDArray[numpy.bool_] | None = None  #: (N,) bool; None: no sphere is
    names: dict[int, str] = field(default_factory=dict)  #: by the spheres' numbers, only of those that have one
    source: str = "the scene"  #: the file, as messages call it
    format: str | None = None  #: of that file: "text", "TOML", "XYZ", and so on, as `sphereview --help` lists them
    frames: int = 1  #: in that file
    light: Light = Light()  #: for shade="studio"
    properties: dict[str, NDArray[Any]] = field(default_factory=dict)  #: what the file holds of each sphere besides: (N,) each

    def __post_init__(self) -> None:
        for name in ("centers", "radii", "colors"):
            object.__setattr__(self, name, numpy.asarray(getattr(self, name)))

    def render(
        self,
        size: tuple[int, int] = (1000, 1000),
        samples: int = 1,
        shade: str = "flat",
        backend: str = "auto",
        *,
        background: str | None = None,
        lights: int | None = None,
        sky: float | None = None,
        key: float | None = None,
        sun: Sun | None = None,
        sun_strength: float | None = None,
    ) -> NDArray[numpy.uint8]:
        """The picture, as the function `render` makes it; `background` and what concerns light replace the scene's own."""
        shown = self.background if background is None else background
        return render(
            self.centers,
            self.radii,
            self.colors,
            self.camera,
            size,
            samples,
            shade,
            backend,
            background=shown,
            hidden=self.hidden,
            light=self.light,
            lights=lights,
            sky=sky,
            key=key,
            sun=sun,
            sun_strength=sun_strength,
        )

    def explain(
        self,
        pixel: tuple[int, int],
        size: tuple[int, int] = (1000, 1000),
        shade: str = "flat",
        *,
        background: str | None = None,
        lights: int | None = None,
        sky: float | None = None,
        key: float | None = None,
        sun: Sun | None = None,
        sun_strength: float | None = None,
    ) -> str:
        """The arithmetic of one pixel, as the function `explain` says it."""
        return explain(
            self.centers,
            self.radii,
            self.colors,
            pixel,
            self.seen_from(),
            size,
            shade,
            background=self.background if background is None else background,
            hidden=self.hidden,
            light=self.light,
            lights=lights,
            sky=sky,
            key=key,
            sun=sun,
            sun_strength=sun_strength,
            names=self.names,
            name=self.source,
        )

    def seen_from(self) -> Camera:
        """The camera, fitted where "fit" stands for it."""
        if isinstance(self.camera, Camera):
            return self.camera
        if self.camera is None:
            return Camera()
        return fit_camera(self.centers, self.radii, hidden=self.hidden)


def columns_text(columns: str | Mapping[str, str | int] | None) -> str | None:
    """As the command line spells it."""
    if columns is None or isinstance(columns, str):
        return columns
    return ",".join(f"{column}={field}" for column, field in columns.items())


def read(
    path: str | os.PathLike[str],
    *,
    frame: int = 0,
    radius: float | None = None,
    virtual: bool = True,
    columns: str | Mapping[str, str | int] | None = None,
    fit: bool | None = None,
    view: View | None = None,
    properties: Iterable[str] | None = None,
    color_by: str | None = None,
    colormap: str | None = None,
    range: tuple[float, float] | None = None,
    log: bool = False,
    size_by: str | None = None,
    scale: float | None = None,
    radii: str | None = None,
    radius_scale: float | None = None,
) -> Scene:
    """The scene in a file of any format that the program reads, also packed with gzip.

    frame: which of several frames or models, from 0.
    radius: of each sphere for which a data file says none; None: the element's, and of points without an
        element a quarter of the median distance between neighbours.
    virtual: False leaves out what files of atoms call one and is none: virtual sites, lone pairs, Drude particles, ghosts, dummies.
    columns: which fields of a CSV file are which columns: {"x": "Position X", "y": 2, "radius": "size"}, by the names in its header or by
        numbers from 1, or as the command line spells it, "x=Position X,y=2,radius=size". Columns are x, y, z, radius, diameter, r, g, b,
        color, element and name.
    fit: True moves the camera until it sees everything; False looks at data, too, from (0, 0, 0) along z. None: data is fitted, a scene
        keeps its camera.
    view: fits from a side: as for the function `fit`. Or the name of one of the file's saved views, whose camera is taken as it is.

    properties: names of those to keep in the scene's `properties`, in any letter case; () keeps none, which takes less time and memory.
        None: all that the file holds of each sphere, as docs/formats.md lists them. Numbers are float64 with nan, float32, or int32; where
        a sphere has no whole number all are float64. Words are Python's, "" where a sphere has none, in an array of objects.
    color_by: colours the spheres by a property of that name, or by "x", "y", "z" or "radius". Of numbers with the `colormap` "viridis",
        "plasma", "cividis", "turbo", "coolwarm" or "grey", over the `range` (a, b), None: from the least to the greatest, with `log` by
        their logarithm.
    size_by: radii by a property: `scale` times the value; None: by the distances of the spheres.
    radii: of atoms, by element: "covalent", "vdw" or "ionic".
    radius_scale: every radius, times so much.

    The scene's arrays are new and yours: centers float64 (N, 3), radii float64 (N,), colors uint8 (N, 3), hidden bool (N,) or None. Its
    camera is the one that `sphereview render` takes with the same options, so `read(path).render()` is that picture.

    ValueError: what is wrong with the file, with its line and column. OSError, such as FileNotFoundError: it cannot be read.
    UserWarning: what is wrong with a file that is read all the same.
    """
    if isinstance(properties, str):
        raise ValueError(f"properties: found {properties!r}, expected a list of names")
    kept = None if properties is None else list(properties)
    look = (color_by, colormap, range, log, size_by, scale, radii, radius_scale)
    columns_chosen = columns_text(columns)
    found: dict[str, Any] = _native.read(path_bytes(path), frame, radius, virtual, columns_chosen, fit, view_text(view), kept, look)
    for warning in found.pop("warnings"):
        warnings.warn(warning, stacklevel=2)
    found["camera"] = Camera.from_numbers(found["camera"])
    found["light"] = Light.from_numbers(found["light"])
    found["source"] = os.fsdecode(found["source"])
    return Scene(**found)
