"""The window as a person feels it: from a movement of the mouse to the picture that shows it, and what resting costs.

Drives the real program in Xvfb, with the mouse moved through XTest. A redraw counts when its buffers have been swapped.
"""
import ctypes
import json
import os
import shutil
import statistics
import subprocess
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path

from harness import MILLION, Bench, CannotRun, Row, at_most

WINDOW = (1366, 1098)  # leaves the picture about 1000 x 1000
PATIENCE_S = 60.0


class Mouse:
    """XTest: no process to start for each movement."""

    def __init__(self, display: str):
        self.x11, self.xtst = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(display.encode()))

    def move(self, x: float, y: float) -> None:
        self.xtst.XTestFakeMotionEvent(self.display, -1, round(x), round(y), 0)
        self.x11.XFlush(self.display)

    def button(self, pressed: bool) -> None:
        self.xtst.XTestFakeButtonEvent(self.display, 1, int(pressed), 0)
        self.x11.XFlush(self.display)

    def key(self, *names: str) -> None:
        """Presses these keys together, by their X names."""
        self.x11.XStringToKeysym.restype = ctypes.c_ulong
        codes = [self.x11.XKeysymToKeycode(self.display, ctypes.c_ulong(self.x11.XStringToKeysym(name.encode()))) for name in names]
        for pressed, order in [(1, codes), (0, codes[::-1])]:
            for code in order:
                self.xtst.XTestFakeKeyEvent(self.display, code & 0xff, pressed, 0)
        self.x11.XFlush(self.display)


class Viewer:
    def __init__(self, process: subprocess.Popen, log: Path, mouse: Mouse):
        self.process, self.log, self.mouse = process, log, mouse
        self.started = time.perf_counter()
        self.stream = None
        self.part = ""
        self.redraws: list[dict] = []

    def read(self) -> None:
        if self.stream is None:
            if not self.log.exists():
                return
            self.stream = self.log.open(encoding="utf-8")
        self.part += self.stream.read()
        *lines, self.part = self.part.split("\n")
        self.redraws += [json.loads(line) for line in lines]

    def wait(self, what: str, condition) -> dict:
        end = time.perf_counter() + PATIENCE_S
        while time.perf_counter() < end:
            self.read()
            if self.redraws and condition(self.redraws[-1]):
                return self.redraws[-1]
            if self.process.poll() is not None:
                raise CannotRun("the viewer", self.process.returncode, self.process.stderr.read().strip())
            time.sleep(0.0002)
        raise CannotRun(f"the viewer, waiting for {what}", -1)

    def rest(self) -> dict:
        return self.wait("rest", lambda redraw: redraw["resting"])

    def cpu_seconds(self) -> float:
        fields = Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@contextmanager
def viewer(bench: Bench, scene: Path, *options: str):
    """With flat colours and one sample a pixel, unless the options say otherwise."""
    options = options or ("--shade", "flat", "--samples", "1")
    with tempfile.TemporaryDirectory() as home:
        xvfb = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", f"{WINDOW[0]}x{WINDOW[1]}x24"], stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, text=True)
        process = None
        try:
            display = ":" + xvfb.stdout.readline().strip()
            log = Path(home) / "redraws.log"
            environment = {**os.environ, "DISPLAY": display, "HOME": home, "XDG_CONFIG_HOME": home, "XDG_STATE_HOME": home,
                           "LIBGL_ALWAYS_SOFTWARE": "1"}
            process = subprocess.Popen([bench.program("sphereview"), str(scene), "--redraw-log", str(log), *options], env=environment,
                                       stderr=subprocess.PIPE, text=True)
            yield Viewer(process, log, Mouse(display))
        finally:
            for program in (process, xvfb):
                if program is not None:
                    program.kill()
                    program.wait()


def drag(shown: Viewer, runs: int) -> dict:
    """Selects the first sphere, drags its x slider, and times each movement."""
    def middle(widget: str) -> tuple[float, float]:
        left, top, right, bottom = shown.rest()["widgets"][widget]
        return (left + right) / 2, (top + bottom) / 2

    shown.wait("the list", lambda redraw: redraw["resting"] and "row 0" in redraw["widgets"])
    shown.mouse.move(*middle("row 0"))
    shown.mouse.button(True)
    shown.mouse.button(False)
    shown.wait("the selection", lambda redraw: redraw["selection"] == [0] and redraw["resting"] and "slider x" in redraw["widgets"])
    x, y = middle("slider x")
    shown.mouse.move(x, y)
    shown.mouse.button(True)
    # A press becomes a drag only after some pixels.
    x += 20
    before = shown.rest()["revision"]
    shown.mouse.move(x, y)
    shown.wait("the slider's drag", lambda redraw: redraw["revision"] > before and redraw["resting"])
    answers, seconds, steps = [], [], []
    for number in range(runs):
        before = shown.redraws[-1]["revision"]
        x += 3 if number % 2 == 0 else -3
        begin = time.perf_counter()
        shown.mouse.move(x, y)
        redraw = shown.wait("the moved sphere", lambda redraw: redraw["revision"] > before)
        answers.append((time.perf_counter() - begin) * 1e3)
        seconds.append(redraw["seconds"] * 1e3)
        steps.append(redraw["step"])
    shown.mouse.button(False)
    shown.rest()
    return {"answer_ms": statistics.median(answers), "worst_ms": max(answers), "redraw_ms": statistics.median(seconds),
            "step": statistics.median(steps)}


def first_light(bench: Bench, scene: Path, runs: int) -> dict:
    """From when the window rests to the first picture with shadows, and from a movement to the picture that shows it instead."""
    firsts, answers = [], []
    with viewer(bench, scene, "--shade", "studio", "--samples", "1") as shown:
        left, top, width, height = shown.rest()["picture"]
        for number in range(runs):
            shown.mouse.move(left + width / 2, top + height / 2)
            shown.mouse.button(True)
            begin = time.perf_counter()
            shown.mouse.move(left + width / 2 + (20 if number % 2 == 0 else -20), top + height / 2)
            shown.wait("a movement", lambda redraw: redraw["draft"] is None and not redraw["exact"])
            answers.append((time.perf_counter() - begin) * 1e3)
            shown.mouse.button(False)
            firsts.append(shown.wait("light", lambda redraw: redraw["draft"] is not None)["draft"] * 1e3)
    return {"first_light_ms": statistics.median(firsts), "answer_ms": statistics.median(answers), "worst_answer_ms": max(answers)}


def opening(bench: Bench, scene: Path, count: int) -> dict:
    """From the start of the program to its first redraw, and to the first picture of the whole scene."""
    with viewer(bench, scene) as shown:
        started = shown.started
        shown.wait("a first redraw", lambda redraw: True)
        first = time.perf_counter()
        shown.wait("the scene", lambda redraw: redraw["spheres"] == count)
        picture = time.perf_counter()
        shown.wait("rest", lambda redraw: redraw["spheres"] == count and redraw["resting"])
        return {"window_ms": (first - started) * 1e3, "picture_ms": (picture - started) * 1e3,
                "exact_ms": (time.perf_counter() - started) * 1e3}


def window(bench: Bench) -> tuple[list[Row], dict]:
    """From the mouse to the picture at 4 and 1,000 spheres, and an idle window; see large.py for more spheres."""
    if shutil.which("Xvfb") is None:
        return [Row("window", "needs Xvfb")], {}
    rows, data = [], {}
    for count, limit in [(1000, 100), (MILLION, 300)]:
        result = data[f"light-{count}"] = first_light(bench, bench.scene("volume", count), max(10, bench.runs))
        rows.append(Row(f"window, studio, {count:,} spheres", f"a movement is shown instead of growing light in {result['answer_ms']:.0f} "
                        f"ms (worst {result['worst_answer_ms']:.0f})"))
        rows.append(at_most("  the first light, from rest", result["first_light_ms"], limit, " ms"))
    for count in [4, 1000]:
        with viewer(bench, bench.scene("volume", count)) as shown:
            size = shown.rest()["picture_size"]
            result = drag(shown, max(20, bench.runs))
            before, begin, redraws = shown.cpu_seconds(), time.perf_counter(), len(shown.redraws)
            time.sleep(5.0)
            shown.read()
            result["idle_percent"] = 100.0 * (shown.cpu_seconds() - before) / (time.perf_counter() - begin)
            result["idle_redraws"] = len(shown.redraws) - redraws
            result["size"] = size
        data[str(count)] = result
        rows.append(Row(f"window, {count:,} spheres, {size[0]} x {size[1]}",
                        f"a slider's movement answered in {result['answer_ms']:.1f} ms (worst {result['worst_ms']:.0f}), "
                        f"of it the redraw {result['redraw_ms']:.1f} ms, every {result['step']:g}th pixel"))
        rows.append(at_most("  answer", result["answer_ms"], 30, " ms"))
        rows.append(at_most("  an idle window's part of a core", result["idle_percent"], 1, " %"))
    return rows, data
