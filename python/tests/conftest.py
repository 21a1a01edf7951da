"""What the tests share. They run against whichever sphereview is installed, or in PYTHONPATH."""

import os
import subprocess
import sys
from pathlib import Path

import numpy
import pytest

pytest_plugins = ["pytester"]

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def plain_environment(monkeypatch):
    monkeypatch.delenv("SPHEREVIEW_BACKEND", raising=False)


@pytest.fixture
def seed_scene():
    """The fourth of the first scenes, as its file has it: centers, radii, colors."""
    words = (ROOT / "scenes" / "input4.txt").read_text().split()
    table = numpy.array(words[1:], dtype=numpy.float64).reshape(int(words[0]), 7)
    return table[:, 3:6].copy(), table[:, 6].copy(), table[:, :3].astype(numpy.uint8)


@pytest.fixture
def run_program():
    """Runs the program with these arguments and returns its exit status, output and error output."""
    def run(*arguments, **options):
        done = subprocess.run([sys.executable, "-m", "sphereview", *map(os.fspath, arguments)], capture_output=True, text=True, **options)
        return done.returncode, done.stdout, done.stderr

    return run
