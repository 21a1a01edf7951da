"""sphereview.render: the picture of arrays is the program's picture of a file."""

import hashlib
import re
import signal
import subprocess
import sys
import threading
import time

import numpy
import pytest
from conftest import ROOT

import sphereview

SMALL = {"size": (64, 48)}


def test_gives_the_picture_that_the_program_writes(seed_scene, tmp_path, run_program):
    image = sphereview.render(*seed_scene)
    assert image.shape == (1000, 1000, 3) and image.dtype == numpy.uint8
    # As in tests/gl/picture_test.cpp: the sum of an independent implementation.
    assert hashlib.sha256(image.tobytes()).hexdigest() == "f47d8b3825145e19134b10371c92bd3e18107b26a701836e29cfac9b3f1433e1"
    assert run_program("render", ROOT / "scenes" / "input4.txt", "-o", tmp_path / "picture.png")[0] == 0
    assert numpy.array_equal(image, sphereview.read_png(tmp_path / "picture.png"))


@pytest.mark.parametrize(
    "shade, samples",
    [("flat", 1), ("flat", 16), ("headlight", 1), ("normal", 1), ("normal", 4), ("depth", 1), ("id", 1), ("studio", 1), ("studio", 4)],
)
def test_options_are_those_of_the_program(seed_scene, tmp_path, run_program, shade, samples):
    scene, picture = tmp_path / "scene.txt", tmp_path / "picture.png"
    rows = zip(*seed_scene)
    lines = [" ".join(str(x) for x in (*color, *map(float, center), float(radius))) for center, radius, color in rows]
    scene.write_text("\n".join([str(len(lines)), *lines]))
    options = ["-s", "70x50", "--shade", shade, "--samples", str(samples), "--background", "transparent", "--view", "iso"]
    status, _, words = run_program("render", scene, "-o", picture, "--backend", "cpu", *options)
    assert status == 0, words
    camera = sphereview.fit(*seed_scene[:2], view="iso")
    image = sphereview.render(*seed_scene, camera, (70, 50), samples, shade, "cpu", background="transparent")
    assert image.shape == (50, 70, 4)
    assert numpy.array_equal(image, sphereview.read_png(picture))


def test_light_is_that_of_the_program(seed_scene, tmp_path, run_program):
    def picture(*options):
        status, _, words = run_program(
            "render", ROOT / "scenes" / "input4.txt", "-o", tmp_path / "picture.png", "-s", "64x48", "--shade", "studio", *options
        )
        assert status == 0, words
        return sphereview.read_png(tmp_path / "picture.png")

    def draw(**options):
        return sphereview.render(*seed_scene, shade="studio", **SMALL, **options)

    plain = draw()
    assert numpy.array_equal(plain, picture())
    for light, options in [
        ({"lights": 16}, ["--lights", "16"]),
        ({"sky": 0.5, "key": 0}, ["--sky", "0.5", "--key", "0"]),
        ({"sun": (-8, 5, -6)}, ["--sun=-8,5,-6"]),
        ({"sun": numpy.array([1, 2.5, -3]), "sun_strength": 0.5, "sky": 0.25}, ["--sun", "1,2.5,-3", "--sun-strength", "0.5", "--sky", "0.25"]),
        ({"sun": "30,20", "camera": "fit"}, ["--sun", "30,20", "--fit"]),
        ({"sun": (30, 20), "camera": sphereview.fit(*seed_scene[:2], view="iso")}, ["--sun", "30,20", "--view", "iso"]),
    ]:
        lit = draw(**light)
        assert not numpy.array_equal(lit, plain), light
        assert numpy.array_equal(lit, picture(*options)), light
    sun = sphereview.Light(sun=(-8, 5, -6))
    assert (sun.sky, sun.key, sun.sun, sun.sun_strength, sun.lights) == (None, 1, (-8, 5, -6), None, None)
    assert numpy.array_equal(draw(light=sun), draw(sun=(-8, 5, -6)))
    assert numpy.array_equal(draw(light=sun, sun_strength=2, lights=20), picture("--sun=-8,5,-6", "--sun-strength", "2", "--lights", "20"))


def test_wrong_light_has_the_command_lines_words(seed_scene, tmp_path, run_program):
    for option, value in [
        ("lights", 15), ("lights", 1025), ("sky", -0.5), ("sky", float("nan")), ("key", 1.5), ("sun_strength", 0), ("sun_strength", 5),
        ("sun", "0,0,0"), ("sun", "front"), ("sun", "1,2,3,4"), ("sun", "0,91"),
    ]:
        flag = "--" + option.replace("_", "-")
        words = run_program("render", ROOT / "scenes" / "input4.txt", "--shade", "studio", f"{flag}={value}")[2].splitlines()[0]
        assert words.startswith(f"sphereview: {flag}: found '{value}', expected "), words
        expected = words.replace(f"sphereview: {flag}", option).removesuffix(" (see 'sphereview render --help')")
        with pytest.raises(ValueError) as caught:
            sphereview.render(*seed_scene, shade="studio", **{option: value})
        assert str(caught.value) == expected
        with pytest.raises(ValueError, match="sun: found " if option == "sun" else re.escape(expected)):
            sphereview.Light(**{option: value})
    with pytest.raises(ValueError, match="^shade: found 'flat', expected studio with sky$"):
        sphereview.render(*seed_scene, sky=0.5)
    with pytest.raises(ValueError, match="^sun_strength: the scene has no sun, expected sun as well$"):
        sphereview.render(*seed_scene, shade="studio", sun_strength=0.5)
    with pytest.raises(ValueError, match=r"^sun: found \(30, 20\), expected \(x, y, z\)$"):
        sphereview.Light(sun=(30, 20))


def test_a_camera_that_fits_sees_everything():
    image = sphereview.render([[1e6, 0, 0], [1e6 + 2, 0, 0]], 1, [[255, 0, 0], [0, 255, 0]], "fit", **SMALL)
    assert {tuple(color) for color in image.reshape(-1, 3)} == {(0, 0, 0), (255, 0, 0), (0, 255, 0)}


def test_arrays_of_other_types_and_orders_are_converted(seed_scene):
    centers, radii, colors = seed_scene
    expected = sphereview.render(*seed_scene, **SMALL)
    wide = numpy.zeros((len(radii), 5), numpy.float64)
    wide[:, 1:4] = centers
    others = [
        (centers.tolist(), radii.tolist(), colors.tolist()),
        (numpy.asfortranarray(centers), radii.astype(numpy.float32), colors.astype(numpy.int64)),
        (wide[:, 1:4], numpy.repeat(radii, 2)[::2], colors.astype(numpy.uint16)),
        (centers.astype(">f8"), radii.astype(int), colors / 255),
        (centers.astype(numpy.float32), radii, (colors / 255).astype(numpy.float32)),
    ]
    for arrays in others:
        assert numpy.array_equal(sphereview.render(*arrays, **SMALL), expected)


def test_one_radius_or_colour_is_for_all(seed_scene):
    centers, radii, _ = seed_scene
    one = sphereview.render(centers, 30, (1.0, 0.5, 0.0), **SMALL)
    each = sphereview.render(centers, numpy.full(len(radii), 30.0), numpy.full((len(radii), 3), (255, 128, 0)), **SMALL)
    assert numpy.array_equal(one, each)


def test_no_spheres_are_a_background():
    for nothing in ([], numpy.zeros((0, 3))):
        assert (sphereview.render(nothing, [], [], background="#010203", **SMALL) == (1, 2, 3)).all()


def test_hidden_spheres_keep_their_numbers(seed_scene):
    centers, radii, colors = seed_scene
    hidden = numpy.zeros(len(radii), bool)
    hidden[0] = True
    shown = sphereview.render(centers, radii, colors, shade="id", hidden=hidden, **SMALL)
    assert not numpy.array_equal(shown, sphereview.render(centers, radii, colors, shade="id", **SMALL))
    assert not numpy.array_equal(shown, sphereview.render(centers[1:], radii[1:], colors[1:], shade="id", **SMALL))
    flat = sphereview.render(centers, radii, colors, hidden=hidden, **SMALL)
    assert numpy.array_equal(flat, sphereview.render(centers[1:], radii[1:], colors[1:], **SMALL))


def test_the_arrays_are_left_alone_and_the_picture_owns_its_memory(seed_scene):
    before = [array.copy() for array in seed_scene]
    for array in seed_scene:
        array.setflags(write=False)
    image = sphereview.render(*seed_scene, **SMALL)
    image[:] = 7
    assert all(numpy.array_equal(a, b) for a, b in zip(seed_scene, before))


def put(array, place, value):
    changed = array.astype(object)
    changed[place] = value
    return changed.astype(type(value) if isinstance(value, int) else float)


@pytest.mark.parametrize(
    "which, place, value, words",
    [
        (0, (1, 2), float("nan"), "centers[1, 2]: found 'nan', expected the centre's z of sphere 2 of {n}, a finite number"),
        (0, (0, 0), float("-inf"), "centers[0, 0]: found '-inf', expected the centre's x of sphere 1 of {n}, a finite number"),
        (1, 1, 0.0, "radii[1]: found '0', expected the radius of sphere 2 of {n} above 0"),
        (1, 0, -2.5, "radii[0]: found '-2.5', expected the radius of sphere 1 of {n} above 0"),
        (1, 0, float("inf"), "radii[0]: found 'inf', expected the radius of sphere 1 of {n}, a finite number"),
        (2, (1, 0), 256, "colors[1, 0]: found '256', expected the red of sphere 2 of {n} from 0 to 255"),
        (2, (1, 2), -1, "colors[1, 2]: found '-1', expected the blue of sphere 2 of {n} from 0 to 255"),
        (2, (0, 1), 1.5, "colors[0, 1]: found '1.5', expected the green of sphere 1 of {n} from 0 to 1"),
    ],
)
def test_a_wrong_value_is_named_with_its_place(seed_scene, which, place, value, words):
    arrays = list(seed_scene)
    if isinstance(value, float) and which == 2:
        arrays[2] = arrays[2] / 255
    arrays[which] = put(arrays[which], place, value)
    with pytest.raises(ValueError) as caught:
        sphereview.render(*arrays, **SMALL)
    assert str(caught.value) == words.format(n=len(arrays[1]))


@pytest.mark.parametrize(
    "arguments, words",
    [
        (dict(size=(0, 5)), "size: found '0x5', expected (width, height), such as (1000, 1000): sides of at least 1 pixel, at most "),
        (dict(size=(1 << 40, 5)), "size: found '1099511627776x5', expected "),
        (dict(samples=3), "samples: found '3', expected 1, 4 or 16"),
        (dict(shade="phong"), "shade: found 'phong', expected flat, headlight, normal, depth, id or studio"),
        (dict(backend="vulkan"), "backend: found 'vulkan', expected auto, egl, osmesa, wgl or cpu"),
        (dict(background="mauve"), "background: found 'mauve', expected black, white, transparent or #rrggbb"),
        (dict(camera="fat"), "camera: found 'fat', expected a Camera, 'fit' or None"),
    ],
)
def test_a_wrong_option_is_named(seed_scene, arguments, words):
    with pytest.raises(ValueError) as caught:
        sphereview.render(*seed_scene, **{**SMALL, **arguments})
    assert str(caught.value).startswith(words)


@pytest.mark.parametrize(
    "centers, radii, colors, words",
    [
        ([1, 2, 3], 1, (0, 0, 0), "centers: found an array of shape (3,), expected (N, 3)"),
        ([[1, 2, 3]], [1, 2], (0, 0, 0), "radii: found an array of shape (2,), expected (1,)"),
        ([[1, 2, 3]], 1, [[0, 0, 0, 255]], "colors: found an array of shape (1, 4), expected (1, 3)"),
        ([[1, 2, 3j]], 1, (0, 0, 0), "centers: found an array of complex128, expected numbers"),
        ([[1, 2, 3]], 1, (True, False, True), "colors: found an array of bool, expected whole numbers"),
        ([[1, 2, 3]], 1, ("r", "g", "b"), "colors: found an array of <U1, expected whole numbers"),
    ],
)
def test_a_wrong_shape_is_named(centers, radii, colors, words):
    with pytest.raises(ValueError) as caught:
        sphereview.render(centers, radii, colors, **SMALL)
    assert str(caught.value).startswith(words)


def test_the_variable_chooses_where_nobody_names_a_backend(seed_scene, monkeypatch):
    monkeypatch.setenv("SPHEREVIEW_BACKEND", "nonsense")
    sphereview.render(*seed_scene, backend="cpu", **SMALL)
    with pytest.raises(ValueError, match="^SPHEREVIEW_BACKEND: found 'nonsense', expected auto, egl, osmesa, wgl or cpu$"):
        sphereview.render(*seed_scene, **SMALL)


def test_backends_agree_also_in_turns_and_threads(seed_scene):
    expected = sphereview.render(*seed_scene, backend="cpu", **SMALL)
    usable = []
    for backend in ("egl", "osmesa", "auto"):
        try:
            assert numpy.array_equal(sphereview.render(*seed_scene, backend=backend, **SMALL), expected)
            usable.append(backend)
        except RuntimeError as error:
            assert f"the backend {backend} does not work here" in str(error)
    assert "auto" in usable
    wrong = []

    def draw(backend):
        for _ in range(5):
            if not numpy.array_equal(sphereview.render(*seed_scene, backend=backend, **SMALL), expected):
                wrong.append(backend)

    threads = [threading.Thread(target=draw, args=(backend,)) for backend in [*usable, "cpu"] * 2]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


LONG = """
import sys, threading, time, numpy, sphereview
rng = numpy.random.default_rng(1)
centers = rng.uniform(-50, 50, (200_000, 3)) + (0, 0, 200)
def tick():
    for _ in range(50):
        time.sleep(0.01)
    print("ticked", flush=True)
threading.Thread(target=tick, daemon=True).start()
print("begun", flush=True)
try:
    sphereview.render(centers, 20.0, (255, 0, 0), "fit", (20000, 20000), 1, "headlight", sys.argv[1])
except KeyboardInterrupt:
    print("interrupted", flush=True)
    image = sphereview.render(centers[:10], 20.0, (255, 0, 0), "fit", (50, 50), backend=sys.argv[1])
    print(image.max())
"""


@pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="needs POSIX signals")
@pytest.mark.parametrize("backend", ["cpu", "auto"])
def test_ctrl_c_interrupts_while_other_threads_run(backend):
    process = subprocess.Popen([sys.executable, "-c", LONG, backend], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begun\n"
    assert process.stdout.readline() == "ticked\n"
    assert process.poll() is None, "the picture was made too soon to be interrupted"
    sent = time.monotonic()
    process.send_signal(signal.SIGINT)
    assert process.stdout.readline() == "interrupted\n"
    assert time.monotonic() - sent < 2
    assert process.stdout.read() == "255\n"
    assert process.wait(60) == 0


FORKED = """
import os, sys, numpy, sphereview
def draw(backend):
    return sphereview.render([[0, 0, 300]], 50, (255, 0, 0), size=(64, 48), backend=backend)
expected = draw("cpu")
draw("auto")
child = os.fork()
if child == 0:
    assert numpy.array_equal(draw("cpu"), expected)
    assert numpy.array_equal(draw("auto"), expected)
    try:
        draw("egl")
    except RuntimeError as error:
        assert "does not work here" in str(error)
    sys.exit(7)
sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""


FORKED_AT_WORK = """
import os, sys, threading, numpy, sphereview
def draw():
    return sphereview.render([[0, 0, 300]], 50, (255, 0, 0), size=(400, 300), backend="cpu")
expected = draw()
ended = threading.Event()
def work():
    while not ended.is_set():
        draw()
threads = [threading.Thread(target=work) for _ in range(2)]
for thread in threads:
    thread.start()
statuses = set()
for _ in range(20):
    child = os.fork()
    if child == 0:
        os._exit(7 if all(numpy.array_equal(draw(), expected) for _ in range(5)) else 1)
    statuses.add(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
ended.set()
for thread in threads:
    thread.join()
sys.exit(statuses.pop() if len(statuses) == 1 else 1)
"""


@pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="needs fork()")
@pytest.mark.parametrize("script", [FORKED, FORKED_AT_WORK], ids=["after", "during"])
def test_a_forked_process_renders(script):
    assert subprocess.run([sys.executable, "-W", "ignore", "-c", script], timeout=120).returncode == 7
