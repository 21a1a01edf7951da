"""The pytest fixture `exact_image`: compares pictures, without any tolerance, with PNGs that lie beside the tests.

    def test_scene(exact_image):
        exact_image.check(sphereview.read("scene.toml"), "scene")       # a scene: rendered and compared with goldens/scene.png
        exact_image.check(image, "mine")                                # or any picture: uint8, (height, width, 3 or 4)

`pytest --update-images` accepts what differs or is missing. A failure names the picture that was made and a picture of the difference,
and of a scene explains the first pixel that differs.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from . import Scene

_updated = pytest.StashKey[list[str]]()

# A ray that hits thousands of spheres must not fill the terminal.
_most_lines = 60


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("sphereview")
    group.addoption("--update-images", action="store_true", help="accept the pictures of exact_image that differ or are missing")
    group.addoption("--image-results", metavar="FOLDER", help="where pictures of exact_image go that differ [pytest's cache]")
    parser.addini("exact_image_goldens", "the folder of golden images, below pytest's root [goldens/ beside each test's file]")


def pytest_configure(config: pytest.Config) -> None:
    config.stash[_updated] = []


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    updated = config.stash[_updated]
    if updated:
        terminalreporter.section("golden images written")
        for line in updated:
            terminalreporter.write_line(line)


@pytest.fixture
def exact_image(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> ExactImage:
    """Compares pictures with golden images, byte for byte: exact_image.check(image_or_scene, "name")."""
    config = request.config
    folder = config.getini("exact_image_goldens")
    goldens = config.rootpath / folder if folder else request.path.parent / "goldens"
    results = config.getoption("--image-results")
    if results:
        beside = Path(config.invocation_params.dir, results)
    elif hasattr(config, "cache"):
        beside = Path(config.cache.mkdir("exact_image"))
    else:  # -p no:cacheprovider
        beside = tmp_path_factory.mktemp("exact_image", numbered=True)
    return ExactImage(request.node.nodeid, config, goldens, beside / request.path.stem)


class ExactImage:
    """What the fixture gives."""

    def __init__(self, test: str, config: pytest.Config, goldens: Path, results: Path) -> None:
        self._test = test
        self._config = config
        self._goldens = goldens
        self._results = results

    def check(self, picture: Scene | ArrayLike | str | os.PathLike[str], name: str, **options: Any) -> None:
        """Fails unless the picture is that of the golden image NAME.png, pixel for pixel.

        picture: an array or anything that NumPy makes one of (uint8, (height, width, 3 or 4)); a Scene; or the path of a scene's file.
        name: of the golden image without its ending; may hold folders.
        options: of a scene: what Scene.render() takes, such as size=(640, 480).

        A picture without alpha counts as opaque.
        """
        __tracebackhide__ = True
        from . import _native
        from .pictures import image_array
        from .scene import Scene, read

        golden = self._golden(name)
        source: Any = read(picture, properties=()) if isinstance(picture, (str, os.PathLike)) else picture
        scene = source if isinstance(source, Scene) else None
        if scene is not None:
            actual = scene.render(**options)
        elif options:
            raise TypeError(f"{', '.join(options)}: only a scene is rendered, and takes options")
        else:
            actual = image_array(source)
        if not golden.exists():
            words, first, difference = f"{self._shown(golden)} is missing", None, None
        else:
            equal, what, first, difference = _native.compare_with_png(actual, os.fsencode(golden))
            if equal:
                return
            words = f"{name}: differs from {self._shown(golden)}: {what}"
        if self._config.getoption("--update-images") and self._accept(golden, actual):
            return
        lines = [words, *self._write_results(name, actual, difference)]
        if scene is not None and first is not None:
            lines += ["", *_explanation(scene, first, actual, options)]
        lines += ["", f"to accept the picture: pytest --update-images '{self._test}'"]
        raise AssertionError("\n".join(lines))

    def _golden(self, name: str) -> Path:
        path = self._goldens / f"{name}.png"
        if not name or name.endswith("/") or self._goldens.resolve() not in path.resolve().parents:
            raise ValueError(f"found the name {name!r} of a golden image, expected one below {self._goldens}")
        return path

    def _shown(self, path: Path) -> str:
        try:
            return str(path.relative_to(self._config.invocation_params.dir))
        except ValueError:
            return str(path)

    def _accept(self, golden: Path, actual: NDArray[Any]) -> bool:
        """False where another check of this run wrote the golden image: of two different pictures none is right."""
        from . import write_png

        written = self._config.stash[_updated]
        if self._shown(golden) in written:
            return False
        golden.parent.mkdir(parents=True, exist_ok=True)
        write_png(golden, actual)
        written.append(self._shown(golden))
        return True

    def _write_results(self, name: str, actual: NDArray[Any], difference: NDArray[Any] | None) -> list[str]:
        from . import write_png

        lines = []
        for kind, image in (("actual", actual), ("difference", difference)):
            path = self._results / f"{name}.{kind}.png"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.unlink(missing_ok=True)  # of an earlier run
            if image is not None:
                write_png(path, image)
                lines.append(f"{kind + ':':<12}{path}")
        return lines


def _explanation(scene: Scene, pixel: tuple[int, int], actual: NDArray[Any], options: dict[str, Any]) -> list[str]:
    """What `sphereview explain` says of the pixel; of one with several samples, of the first of its points."""
    from . import _native

    options = {name: value for name, value in options.items() if name != "backend"}
    samples = options.pop("samples", 1)
    side = {1: 1, 4: 2, 16: 4}[samples]
    if options.get("shade") == "studio" and options.get("lights") is None:  # as many as the picture has, which depends on its samples
        options["lights"] = _native.sky_lights(scene.light.numbers(), len(scene.radii), samples)
    height, width = actual.shape[:2]
    options["size"] = (side * width, side * height)
    said = scene.explain((side * pixel[0], side * pixel[1]), **options).splitlines()
    if side > 1:
        said.insert(0, f"The first of the pixel's {side * side} points, which is")
    if len(said) > _most_lines:
        said = [*said[: _most_lines - 5], f"... ({len(said) - _most_lines} more lines)", *said[-5:]]
    return said
