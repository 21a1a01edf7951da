"""Ray traces scenes of spheres, exactly: the same bytes on every machine.

    import numpy, sphereview
    image = sphereview.render(centers, radii, colors, camera="fit")    # uint8, shape (1000, 1000, 3)
    sphereview.write_png("picture.png", image)

The program is in this package, too: `sphereview`, or `python -m sphereview`.
"""

from importlib import import_module
from typing import Any

# Whoever only starts the program, or runs pytest with the plugin in this package, should not wait for NumPy: what follows is imported
# when it is first used. __init__.pyi says the same to type checkers.
_HOMES = {
    "Camera": "camera",
    "Light": "light",
    "Scene": "scene",
    "explain": "pictures",
    "fit": "camera",
    "read": "scene",
    "read_png": "pictures",
    "render": "pictures",
    "write_png": "pictures",
}
__all__ = sorted(_HOMES)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'sphereview' has no attribute {name!r}")
    value = getattr(import_module(f"sphereview.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
