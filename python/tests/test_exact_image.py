"""The pytest plugin, seen from the outside: tests that use it are run by a pytest of their own."""

import numpy
import pytest
from conftest import ROOT

import sphereview
import sphereview.scene  # so that all pytests in this process know one Scene

SCENE = """
import numpy, pytest, sphereview
ball = sphereview.Scene([[0, 0, 300], [0, 0, 500]], [50, 200], [[255, 0, 0], [0, 0, 255]])
def test_ball(exact_image):
    exact_image.check(ball, "ball", size=(30, 20))
"""


@pytest.fixture
def tests(pytester):
    pytester.makepyfile(test_it=SCENE)
    return pytester


def run(pytester, *options):
    return pytester.runpytest_inprocess("-p", "no:xdist", *options)


def test_a_missing_golden_fails_and_says_how_to_make_it(tests):
    result = run(tests)
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(
        [
            "*goldens/ball.png is missing*",
            "*actual: *exact_image/test_it/ball.actual.png",
            "*pytest --update-images 'test_it.py::test_ball'",
        ]
    )
    assert not (tests.path / "goldens").exists()
    actual = tests.path / ".pytest_cache" / "d" / "exact_image" / "test_it" / "ball.actual.png"
    assert sphereview.read_png(actual).shape == (20, 30, 3)


def test_a_scenes_light_is_in_its_picture(pytester, run_program):
    scene = ROOT / "scenes" / "planets.toml"
    pytester.makepyfile(
        test_it=f"""
        def test_planets(exact_image):
            exact_image.check({str(scene)!r}, "planets", size=(60, 40), shade="studio", samples=4)
        """
    )
    golden = pytester.path / "goldens" / "planets.png"
    golden.parent.mkdir()
    assert run_program("render", scene, "-o", golden, "-s", "60x40", "--shade", "studio", "--samples", "4")[0] == 0
    run(pytester).assert_outcomes(passed=1)
    image = sphereview.read_png(golden)
    image[20, 30] += 1
    sphereview.write_png(golden, image)
    result = run(pytester)
    result.assert_outcomes(failed=1)
    words = run_program("explain", scene, "-p", "60,40", "-s", "120x80", "--shade", "studio", "--lights", "64")[1]
    result.stdout.fnmatch_lines([f"*{line}" for line in words.splitlines() if line.startswith("colour:")])


def test_update_makes_it_and_then_it_is_the_measure(tests):
    result = run(tests, "--update-images")
    result.assert_outcomes(passed=1)
    result.stdout.fnmatch_lines(["*golden images written*", "goldens/ball.png"])
    golden = tests.path / "goldens" / "ball.png"
    written = golden.stat().st_mtime_ns
    tests.runpytest_subprocess().assert_outcomes(passed=1)
    result = run(tests, "--update-images")
    result.assert_outcomes(passed=1)
    result.stdout.no_fnmatch_line("*golden images written*")
    assert golden.stat().st_mtime_ns == written


def test_one_pixel_by_one_is_a_failure_that_explains_itself(tests):
    run(tests, "--update-images").assert_outcomes(passed=1)
    golden = tests.path / "goldens" / "ball.png"
    image = sphereview.read_png(golden)
    image[10, 15, 0] -= 1
    sphereview.write_png(golden, image)
    result = run(tests)
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(
        [
            "*ball: differs from goldens/ball.png: 1 of 600 pixels differ, by at most R 1 G 0 B 0; the first at pixel 15,10:*",
            "*actual: *ball.actual.png",
            "*difference: *ball.difference.png",
            "*pixel 15,10 of the scene at 30x20*",
            "*discriminant*",
            "*visible: sphere 0*",
            "*pytest --update-images 'test_it.py::test_ball'",
        ]
    )
    # The difference is the actual picture, dimmed, with the pixel in white.
    difference = sphereview.read_png(tests.path / ".pytest_cache" / "d" / "exact_image" / "test_it" / "ball.difference.png")
    assert (difference[10, 15] == 255).all() and not (difference[10, 14] == 255).any()
    run(tests, "--update-images").assert_outcomes(passed=1)
    run(tests).assert_outcomes(passed=1)


def test_another_size_is_a_failure(tests):
    run(tests, "--update-images")
    tests.makepyfile(test_it=SCENE.replace("(30, 20)", "(30, 21)"))
    result = run(tests)
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*ball: differs from goldens/ball.png: *30x21*30x20*"])


def test_samples_are_explained_by_a_point(tests):
    tests.makepyfile(test_it=SCENE.replace("size=(30, 20)", "size=(30, 20), samples=4"))
    run(tests, "--update-images")
    golden = tests.path / "goldens" / "ball.png"
    image = sphereview.read_png(golden)
    image[10, 15] = 0
    sphereview.write_png(golden, image)
    run(tests).stdout.fnmatch_lines(["*The first of the pixel's 4 points*", "*pixel 30,20 of the scene at 60x40*"])


def test_pictures_and_files_are_compared_too(pytester):
    (pytester.path / "scene.txt").write_text("1  0 255 0  0 0 300  50")
    pytester.makepyfile(
        """
        import numpy, pytest
        def test_array(exact_image):
            exact_image.check(numpy.full((4, 5, 3), 9, numpy.uint8), "folder/array")
        def test_opaque(exact_image):
            exact_image.check(numpy.dstack([numpy.full((4, 5, 3), 9), numpy.full((4, 5), 255)]).astype(numpy.uint8), "folder/array")
        def test_file(exact_image):
            exact_image.check("scene.txt", "file", size=(8, 8))
        def test_options_are_for_scenes(exact_image):
            with pytest.raises(TypeError, match="^size: only a scene"):
                exact_image.check(numpy.zeros((4, 5, 3), numpy.uint8), "folder/array", size=(5, 4))
        def test_floats_are_no_picture(exact_image):
            with pytest.raises(ValueError, match="found a picture of float64, expected uint8"):
                exact_image.check(numpy.zeros((4, 5, 3)), "folder/array")
        @pytest.mark.parametrize("name", ["", "../out", "/abs", "x/"])
        def test_names_stay_in_the_folder(exact_image, name):
            with pytest.raises(ValueError, match="name"):
                exact_image.check(numpy.zeros((4, 5, 3), numpy.uint8), name)
        """
    )
    run(pytester, "--update-images").assert_outcomes(passed=9)
    run(pytester).assert_outcomes(passed=9)
    assert (pytester.path / "goldens" / "folder" / "array.png").exists()


def test_two_pictures_cannot_both_become_one_golden(pytester):
    pytester.makepyfile(
        """
        import numpy, pytest
        @pytest.mark.parametrize("color", [1, 1, 2])
        def test_same(exact_image, color):
            exact_image.check(numpy.full((4, 5, 3), color, numpy.uint8), "same")
        """
    )
    run(pytester, "--update-images").assert_outcomes(passed=2, failed=1)


def test_folders_can_be_chosen(tests):
    tests.makeini("[pytest]\nexact_image_goldens = pictures\n")
    run(tests, "--image-results", "out", "--update-images").assert_outcomes(passed=1)
    golden = tests.path / "pictures" / "ball.png"
    sphereview.write_png(golden, numpy.zeros((20, 30, 3), numpy.uint8))
    run(tests, "--image-results", "out", "-p", "no:cacheprovider").assert_outcomes(failed=1)
    assert (tests.path / "out" / "test_it" / "ball.difference.png").exists()
    run(tests, "-p", "no:cacheprovider").stdout.fnmatch_lines(["*ball.actual.png"])


def test_a_broken_golden_is_named(tests):
    (tests.path / "goldens").mkdir()
    (tests.path / "goldens" / "ball.png").write_bytes(b"no picture")
    result = run(tests)
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*ValueError: *goldens/ball.png*"])
