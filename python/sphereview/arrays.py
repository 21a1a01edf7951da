"""What callers pass, as the arrays that the native module takes."""

from __future__ import annotations

import os
from typing import Any

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _native


def path_bytes(path: str | os.PathLike[str]) -> bytes:
    """The path as the program takes it, for which "-" alone would be a standard stream."""
    name = os.fsencode(path)
    if not name:
        raise ValueError("found no name of a file")
    return b"./-" if name == b"-" else name


def numbers(name: str, values: ArrayLike) -> NDArray[numpy.float64]:
    """The values as float64, themselves where they are that already."""
    array = numpy.asarray(values)
    if array.dtype.kind in "biufO":
        return numpy.asarray(array, dtype=numpy.float64)
    raise ValueError(f"{name}: found an array of {array.dtype}, expected numbers")


def _table(name: str, array: NDArray[Any], count: int | None) -> NDArray[Any]:
    rows = "N" if count is None else count
    if array.ndim != 2 or array.shape[1] != 3 or (count is not None and array.shape[0] != count):
        raise ValueError(f"{name}: found an array of shape {array.shape}, expected ({rows}, 3)")
    return numpy.ascontiguousarray(array)


def _row(name: str, array: NDArray[Any], count: int) -> NDArray[Any]:
    if array.ndim == 0:
        array = numpy.broadcast_to(array, (count,))
    if array.shape != (count,):
        raise ValueError(f"{name}: found an array of shape {array.shape}, expected ({count},)")
    return numpy.ascontiguousarray(array)


def _colors(values: ArrayLike, count: int) -> NDArray[Any]:
    array = numpy.asarray(values)
    if array.size == 0 and count == 0:
        array = numpy.zeros((0, 3), numpy.uint8)
    if array.dtype.kind == "f":
        array = numpy.asarray(array, dtype=numpy.float64)
    elif array.dtype.kind in "iu":
        array = array if array.dtype == numpy.uint8 else numpy.asarray(array, dtype=numpy.int64)
    else:
        raise ValueError(f"colors: found an array of {array.dtype}, expected whole numbers from 0 to 255 or numbers from 0 to 1")
    if array.shape == (3,):
        array = numpy.broadcast_to(array, (count, 3))
    return _table("colors", array, count)


def sphere_arrays(centers: ArrayLike, radii: ArrayLike, colors: ArrayLike, hidden: ArrayLike | None = None) -> _native.SphereArrays:
    """Checks the shapes; the values are checked where they are read."""
    places = numbers("centers", centers)
    if places.size == 0:
        places = places.reshape(0, 3)
    places = _table("centers", places, None)
    count = places.shape[0]
    hides = None if hidden is None else _row("hidden", numpy.asarray(hidden, dtype=numpy.bool_), count)
    return _native.SphereArrays(places, _row("radii", numbers("radii", radii), count), _colors(colors, count), hides)
