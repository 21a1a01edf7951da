from typing import Any

import numpy
from numpy.typing import NDArray

# Eye, center, right and up of a camera, one behind the other, and 0 for perspective or 1 for orthographic.
_Camera = tuple[float, ...]

# Of a light: lights, sky, key, sun and sun_strength.
_Light = tuple[int | None, float | None, float, tuple[float, float, float] | None, float | None]

# The same, each instead of another light's; the sun as the command line spells it.
_LightArguments = tuple[int | None, float | None, float | None, str | None, float | None]

# color_by, colormap, range, log, size_by, scale, radii and radius_scale.
_Look = tuple[
    str | None, str | None, tuple[float, float] | None, bool, str | None, float | None, str | None, float | None
]

class SphereArrays:
    def __init__(
        self,
        centers: NDArray[numpy.float64],
        radii: NDArray[numpy.float64],
        colors: NDArray[Any],
        hidden: NDArray[numpy.bool_] | None,
    ) -> None: ...

def render(
    arrays: SphereArrays,
    camera: _Camera | None,
    fit: bool,
    size: tuple[int, int],
    samples: int,
    shade: str,
    backend: str,
    background: str,
    light: _Light,
    light_instead: _LightArguments,
) -> NDArray[numpy.uint8]: ...
def explain(
    arrays: SphereArrays,
    camera: _Camera,
    names: dict[int, str],
    background: str,
    pixel: tuple[int, int],
    size: tuple[int, int],
    shade: str,
    light: _Light,
    light_instead: _LightArguments,
    name: str,
) -> str: ...
def fit(arrays: SphereArrays, camera: _Camera, right_handed: bool, view: str | None) -> _Camera: ...
def read(
    path: bytes,
    frame: int,
    radius: float | None,
    virtual: bool,
    columns: str | None,
    fit: bool | None,
    view: str | None,
    properties: list[str] | None,
    look: _Look,
) -> dict[str, Any]: ...
def light(arguments: _LightArguments) -> _Light: ...
def sky_lights(light: _Light, spheres: int, samples: int) -> int: ...
def check_camera(camera: _Camera) -> None: ...
def compare_with_png(
    actual: NDArray[numpy.uint8], path: bytes
) -> tuple[bool, str, tuple[int, int] | None, NDArray[numpy.uint8]]: ...
def read_png(path: bytes) -> NDArray[numpy.uint8]: ...
def write_png(path: bytes, image: NDArray[numpy.uint8]) -> None: ...
def close_renderers() -> None: ...
def forget_renderers() -> None: ...
