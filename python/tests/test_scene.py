"""Reading files, cameras, explanations and PNGs."""

import errno
import os
import subprocess
import sys

import numpy
import pytest
from conftest import ROOT

import sphereview

WATER = """3
Properties=species:S:1:pos:R:3
O  0.000  0.000 0.000
H  0.757  0.586 0.000
H -0.757  0.586 0.000
3
second frame
O  0 0 1
H  1 0 1
H -1 0 1
"""

TOML = """
background = "transparent"
hidden = [1]
spheres = '''
2
255 220 0    50 50 300     20
0 255 0      100 100 600   60
'''
[camera]
eye = [0, 0, -10]
[names]
0 = "sun"
"""


def test_a_text_scene_is_its_arrays(seed_scene):
    scene = sphereview.read(ROOT / "scenes" / "input4.txt")
    for found, expected in zip((scene.centers, scene.radii, scene.colors), seed_scene):
        assert found.dtype == expected.dtype and numpy.array_equal(found, expected)
        assert found.flags.c_contiguous and found.flags.writeable
    assert scene.camera == sphereview.Camera()
    assert (scene.format, scene.frames, scene.hidden, scene.names, scene.background) == ("text", 1, None, {}, "black")


def test_a_native_scene_has_all_its_properties(tmp_path, run_program):
    path = tmp_path / "scene.toml"
    path.write_text(TOML)
    scene = sphereview.read(path)
    assert scene.camera.eye == (0, 0, -10)
    assert scene.background == "transparent"
    assert scene.names == {0: "sun"}
    assert scene.hidden.tolist() == [False, True]
    assert (scene.format, scene.source) == ("TOML", str(path))
    assert run_program("render", path, "-o", tmp_path / "picture.png", "-s", "60x40")[0] == 0
    assert numpy.array_equal(scene.render((60, 40)), sphereview.read_png(tmp_path / "picture.png"))
    assert numpy.array_equal(scene.render((60, 40), background="black")[..., :3], scene.render((60, 40))[..., :3])


def test_a_scenes_light_is_its_own(run_program, tmp_path):
    path = ROOT / "scenes" / "planets.toml"
    scene = sphereview.read(path)
    assert scene.light == sphereview.Light(sky=0.3, sun=(-8, 5, -6), sun_strength=0.65)
    assert sphereview.read(ROOT / "scenes" / "input4.txt").light == sphereview.Light()
    for light, options in [({}, []), ({"sun": (1, 2, -3), "key": 0.5}, ["--sun", "1,2,-3", "--key", "0.5"])]:
        words = ["-s", "80x60", "--shade", "studio", *options]
        assert run_program("render", path, "-o", tmp_path / "picture.png", *words)[0] == 0
        assert numpy.array_equal(scene.render((80, 60), shade="studio", **light), sphereview.read_png(tmp_path / "picture.png"))
        assert scene.explain((40, 30), (80, 60), "studio", **light) == run_program("explain", path, "-p", "40,30", *words)[1]
    same = sphereview.Scene(scene.centers, scene.radii, scene.colors, scene.camera, scene.background, scene.hidden)
    assert not numpy.array_equal(same.render((80, 60), shade="studio"), scene.render((80, 60), shade="studio"))


def test_columns_are_those_of_the_command_line(run_program, tmp_path):
    path = tmp_path / "table.csv"
    path.write_text("a,b,c,size\n0,0,0,1\n3,1,0,2\n")
    columns = {"x": "a", "y": 2, "z": "c", "radius": "size"}
    scene = sphereview.read(path, columns=columns)
    assert scene.centers.tolist() == [[0, 0, 0], [3, 1, 0]] and scene.radii.tolist() == [1, 2]
    assert run_program("render", path, "-o", tmp_path / "x.png", "-s", "60x40", "--columns", "x=a,y=2,z=c,radius=size")[0] == 0
    assert numpy.array_equal(scene.render((60, 40)), sphereview.read_png(tmp_path / "x.png"))
    path.write_text(path.read_text().replace("size", "other"))
    with pytest.warns(UserWarning, match="no radius in the file"):
        assert sphereview.read(path, columns="x=a,y=b,z=c").radii.tolist() == pytest.approx([10**0.5 / 4] * 2)
    with pytest.raises(ValueError):
        sphereview.read(path)
    words = run_program("render", path, "--columns", "q=a")[2].splitlines()[0]
    with pytest.raises(ValueError) as caught:
        sphereview.read(path, columns={"q": "a"})
    assert str(caught.value) == words.replace("sphereview: --columns", "columns").removesuffix(" (see 'sphereview render --help')")


CHARGES = """4
Properties=species:S:1:pos:R:3:charge:R:1:id:I:1:group:I:1:forces:R:3
O  0.000  0.000 0.000 -0.8   10 1 0 0 0
H  0.757  0.586 0.000 0.4    20 2 3 4 0
H -0.757  0.586 0.000 0.4    30 2 1 0 0
Na 3.000  0.000 0.000 nan  -40 nan 0 2 0
"""


def test_a_scene_has_what_its_file_holds_of_each_sphere(tmp_path, run_program):
    path = tmp_path / "charges.xyz"
    path.write_text(CHARGES)
    scene = sphereview.read(path)
    properties = scene.properties
    assert list(properties) == ["element", "charge", "id", "group", "forces.x", "forces.y", "forces.z", "forces"]
    assert properties["element"].tolist() == ["O", "H", "H", "Na"]
    assert (properties["element"] == "H").tolist() == [False, True, True, False]
    numpy.testing.assert_array_equal(properties["charge"], [-0.8, 0.4, 0.4, numpy.nan])
    numpy.testing.assert_array_equal(properties["group"], [1, 2, 2, numpy.nan])
    assert properties["id"].tolist() == [10, 20, 30, -40] and properties["forces"].tolist() == [0, 5, 1, 2]
    assert [properties[name].dtype for name in ("charge", "id", "group")] == [numpy.float64, numpy.int32, numpy.float64]
    for values in properties.values():
        assert values.shape == (4,) and values.flags.c_contiguous and values.flags.writeable
    scene.colors[properties["element"] == "Na"] = (1, 2, 3)
    assert [1, 2, 3] in scene.render((60, 40)).reshape(-1, 3).tolist()

    assert list(sphereview.read(path, properties=["CHARGE"]).properties) == ["charge"]
    assert sphereview.read(path, properties=()).properties == {}
    with pytest.raises(ValueError) as caught:
        sphereview.read(path, properties=["mass"])
    assert str(caught.value) == run_program("convert", path, tmp_path / "x.toml", "--properties", "mass")[2].rstrip("\n")
    with pytest.raises(ValueError, match="^properties: found 'charge', expected a list of names$"):
        sphereview.read(path, properties="charge")


def test_properties_survive_the_native_format(tmp_path, run_program):
    path, native = tmp_path / "charges.xyz", tmp_path / "charges.toml"
    path.write_text(CHARGES)
    assert run_program("convert", path, native, "--properties", "all")[0] == 0
    first, again = sphereview.read(path).properties, sphereview.read(native).properties
    assert list(first) == list(again)
    for name, values in first.items():
        assert values.dtype == again[name].dtype
        numpy.testing.assert_array_equal(values, again[name])
    assert list(sphereview.read(native, properties=["charge"]).properties) == ["charge"]
    assert sphereview.read(ROOT / "scenes" / "input4.txt").properties == {}


def test_single_precision_and_no_spheres_have_properties_too(tmp_path):
    path = tmp_path / "points.ply"
    header = "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nproperty float heat\nend_header\n"
    path.write_text(header.format(2) + "0 0 0 0.1\n4 0 0 2\n")
    heat = sphereview.read(path, radius=1).properties["heat"]
    assert heat.dtype == numpy.float32 and heat.tolist() == [numpy.float32(0.1), 2]
    path.write_text(header.format(0))
    assert [values.shape for values in sphereview.read(path).properties.values()] == [(0,)]


@pytest.mark.parametrize(
    "options, words",
    [
        ({"color_by": "charge"}, ["--color-by", "charge"]),
        (
            {"color_by": "ID", "colormap": "coolwarm", "range": (40, 10), "log": True},
            ["--color-by", "ID", "--colormap", "coolwarm", "--range", "40:10", "--log"],
        ),
        ({"color_by": "element", "radii": "vdw"}, ["--color-by", "element", "--radii", "vdw"]),
        ({"size_by": "id", "scale": 0.05, "radius_scale": 2}, ["--size-by", "id", "--scale", "0.05", "--radius-scale", "2"]),
    ],
)
def test_colors_and_sizes_are_those_of_the_command_line(tmp_path, run_program, options, words):
    path = tmp_path / "charges.xyz"
    path.write_text(CHARGES)
    scene = sphereview.read(path, properties=(), **options)
    assert scene.properties == {}
    assert run_program("render", path, "-o", tmp_path / "picture.png", "-s", "60x40", *words)[0] == 0
    picture = sphereview.read_png(tmp_path / "picture.png")
    assert numpy.array_equal(scene.render((60, 40)), picture)
    assert not numpy.array_equal(sphereview.read(path).render((60, 40)), picture)


@pytest.mark.parametrize(
    "options, words",
    [
        ({"color_by": "charge", "colormap": "jet"}, "colormap: found 'jet', expected viridis, plasma, cividis, turbo, coolwarm or grey"),
        ({"color_by": "charge", "range": (1, 1)}, "range: found '(1, 1)', expected (a, b), two different numbers"),
        ({"color_by": "charge", "range": (0, 1), "log": True}, "range: found '(0, 1)', expected numbers above 0 with log"),
        ({"colormap": "grey"}, "colormap: expected color_by as well"),
        ({"range": (0, 1)}, "range: expected color_by as well"),
        ({"log": True}, "log: expected color_by as well"),
        ({"scale": 2}, "scale: expected size_by as well"),
        ({"size_by": "id", "scale": 0}, "scale: found '0', expected a number above 0"),
        ({"size_by": "id", "radii": "vdw"}, "radii: expected no size_by beside it"),
        ({"radii": "atomic"}, "radii: found 'atomic', expected covalent, vdw or ionic"),
        ({"radius_scale": float("inf")}, "radius_scale: found 'inf', expected a number above 0"),
    ],
)
def test_wrong_colors_and_sizes_are_told(tmp_path, options, words):
    path = tmp_path / "charges.xyz"
    path.write_text(CHARGES)
    with pytest.raises(ValueError) as caught:
        sphereview.read(path, **options)
    assert str(caught.value) == words


def test_a_saved_view_is_seen_by_its_name(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(TOML + "\n[[view]]\nname = 'from behind'\neye = [0, 0, 900]\ncenter = [0, 0, 800]\nup = [0, -50, 0]\n")
    assert sphereview.read(path, view="from behind").camera == sphereview.Camera((0, 0, 900), (0, 0, 800), up=(0, -50, 0))
    assert sphereview.read(path).camera.eye == (0, 0, -10)


@pytest.mark.parametrize(
    "options, words",
    [
        ({}, []),
        ({"frame": 1}, ["--frame", "1"]),
        ({"radius": 0.5, "view": "iso"}, ["--radius", "0.5", "--view", "iso"]),
        ({"view": (30, 20)}, ["--view", "30,20"]),
        ({"fit": False}, ["--no-fit"]),
    ],
)
def test_data_is_seen_as_the_program_sees_it(tmp_path, run_program, options, words):
    path = tmp_path / "water.xyz"
    path.write_text(WATER)
    scene = sphereview.read(path, **options)
    assert scene.frames == 2 and scene.format == "XYZ" and scene.names[0] == "O"
    assert run_program("render", path, "-o", tmp_path / "picture.png", "-s", "60x40", *words)[0] == 0
    assert numpy.array_equal(scene.render((60, 40)), sphereview.read_png(tmp_path / "picture.png"))


def test_what_the_command_line_warns_of_is_a_warning(tmp_path, run_program):
    path = tmp_path / "cut.xyz"
    path.write_text("2\n\nO 0 0 0\nMW 0 0 1\n1\n")
    with pytest.warns(UserWarning) as caught:
        scene = sphereview.read(path)
    assert list(scene.radii) == [0.66, 0.2]
    words = [str(warning.message) for warning in caught]
    assert words == run_program("convert", path, tmp_path / "x.toml")[2].splitlines() and len(words) == 2
    with pytest.warns(UserWarning, match="left out"):
        assert list(sphereview.read(path, virtual=False).radii) == [0.66]


def test_a_bad_scene_has_the_command_lines_words(tmp_path, run_program):
    path = tmp_path / "bad.txt"
    path.write_text("1\n255 0 0\n0 0 x\n5\n")
    with pytest.raises(ValueError) as caught:
        sphereview.read(path)
    assert str(caught.value) == run_program("render", path, "-o", tmp_path / "x.png")[2].rstrip("\n")
    assert str(caught.value).startswith(f"{path}:3:5: found 'x', expected the centre's z of sphere 1 of 1")
    path.write_text("0")
    for options, words in [
        ({"frame": 9}, "frame"),
        ({"frame": -1}, "frame: found '-1'"),
        ({"radius": 0}, "radius: found '0'"),
        ({"view": "under"}, "found no view 'under', expected front, back"),
        ({"view": "0,91"}, "view: found '0,91', expected front, back"),
    ]:
        with pytest.raises(ValueError, match=words):
            sphereview.read(path, **options)


def test_files_that_cannot_be_read_or_written_are_os_errors(tmp_path):
    image = numpy.zeros((2, 2, 3), numpy.uint8)
    missing, name = tmp_path / "missing", os.fsdecode(b"no utf-8 \xff") if os.name == "posix" else "missing"
    for kind, number, file, call in [
        (FileNotFoundError, errno.ENOENT, missing, sphereview.read),
        (FileNotFoundError, errno.ENOENT, tmp_path / name, sphereview.read),
        (IsADirectoryError, errno.EISDIR, tmp_path, sphereview.read),
        (FileNotFoundError, errno.ENOENT, missing, sphereview.read_png),
        (FileNotFoundError, errno.ENOENT, missing / "x.png", lambda path: sphereview.write_png(path, image)),
        (IsADirectoryError, errno.EISDIR, tmp_path, lambda path: sphereview.write_png(path, image)),
    ]:
        with pytest.raises(kind) as caught:
            call(file)
        assert (caught.value.errno, caught.value.filename) == (number, str(file))
        assert caught.value.strerror.startswith("cannot be ")
        assert str(caught.value).endswith(repr(str(file)))
    with pytest.raises(ValueError):
        sphereview.read("")


def test_names_of_files_are_any_that_the_system_allows(tmp_path, monkeypatch):
    for name in ("kugeln ä 球.txt", "-"):
        monkeypatch.chdir(tmp_path)
        with open(name, "w") as file:
            file.write("0")
        assert len(sphereview.read(name).radii) == 0
    if os.name == "posix":
        name = os.fsdecode(b"no utf-8 \xff.txt")
        with open(name, "w") as file:
            file.write("zero")
        with pytest.raises(ValueError, match="no utf-8 "):
            sphereview.read(name)


def test_cameras_are_checked():
    assert sphereview.Camera((0, 0, 1)).eye == (0.0, 0.0, 1.0)
    assert len({sphereview.Camera(), sphereview.Camera()}) == 1
    with pytest.raises(ValueError, match="^found a camera that cannot be used: 'up' is not perpendicular to 'right'; expected"):
        sphereview.Camera(up=(50, 50, 0))
    with pytest.raises(ValueError, match="its numbers are not all finite"):
        sphereview.Camera(eye=(0, 0, float("nan")))
    with pytest.raises(ValueError, match="^eye: found 2 numbers, expected 3$"):
        sphereview.Camera(eye=(0, 0))


def test_fit_looks_from_each_side():
    centers, radii = [[0, 0, 0], [10, 0, 0]], [1, 2]
    front = sphereview.fit(centers, radii)
    assert front.eye[2] < 0 and front.right[0] > 0
    assert sphereview.fit(centers, radii, "right").eye[0] > 10
    assert sphereview.fit(centers, radii, (90, 0)) == sphereview.fit(centers, radii, "right")
    mirrored = sphereview.fit(centers, radii, right_handed=True)
    assert mirrored.eye[2] > 0 and mirrored.right[0] > 0
    top = sphereview.fit(centers, radii, "top", camera=mirrored)
    assert top == sphereview.fit(centers, radii, "top", right_handed=True)
    assert sphereview.fit([], []) == sphereview.Camera()


def test_explain_says_what_the_program_says(tmp_path, run_program):
    path = tmp_path / "scene.toml"
    path.write_text(TOML)
    status, words, _ = run_program("explain", path, "-p", "33,15", "-s", "60x40", "--shade", "depth")
    assert status == 0
    assert sphereview.read(path).explain((33, 15), (60, 40), "depth") == words
    assert "sphere 0 'sun'" in sphereview.explain([[0, 0, 300]], 50, (255, 0, 0), (500, 500), names={0: "sun"})
    with pytest.raises(ValueError, match="^pixel: found '60,0', expected a pixel from 0,0 to 59,39$"):
        sphereview.read(path).explain((60, 0), (60, 40))


def test_pngs_come_back_as_they_went(tmp_path):
    for channels in (3, 4):
        image = numpy.random.default_rng(channels).integers(0, 256, (7, 5, channels), dtype=numpy.uint8)
        sphereview.write_png(tmp_path / "x.png", image[:, ::-1])
        assert numpy.array_equal(sphereview.read_png(tmp_path / "x.png"), image[:, ::-1])
    for bad in (numpy.zeros((2, 2, 3)), numpy.zeros((2, 2), numpy.uint8), numpy.zeros((0, 2, 3), numpy.uint8)):
        with pytest.raises(ValueError, match="picture"):
            sphereview.write_png(tmp_path / "x.png", bad)


def test_the_program_is_in_the_package(run_program, tmp_path):
    status, words, _ = run_program("--version")
    assert status == 0 and words.startswith("sphereview ")
    assert run_program("render", tmp_path / "missing.txt")[0] == 2


def test_importing_the_package_does_not_import_numpy():
    code = "import sys, sphereview.pytest_plugin as p; assert 'numpy' not in sys.modules; p.pytest; import sphereview; sphereview.render"
    code += "; assert 'numpy' in sys.modules"
    assert subprocess.run([sys.executable, "-c", code]).returncode == 0
    assert set(sphereview.__all__) <= set(dir(sphereview))
