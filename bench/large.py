"""The real window at 4 to 1,000,000 spheres: a drag and an orbit, from the mouse to the picture; opening; memory.

What follows an edit apart from drawing is measured without a window; see live.cpp.
"""
import json
import shutil
import statistics
import time
from pathlib import Path

from harness import MILLION, Bench, Case, Row, at_most
from window import Viewer, drag, opening, viewer

SETS = ["volume", "half"]
COUNTS = [4, 1000, 100_000, MILLION]
MEMORY_MB = 400  # at MILLION


def peak_mb(shown: Viewer) -> float | None:
    """VmHWM, which Linux alone tells."""
    path = Path(f"/proc/{shown.process.pid}/status")
    lines = path.read_text().splitlines() if path.exists() else []
    return next((int(line.split()[1]) * 1024 / 1e6 for line in lines if line.startswith("VmHWM:")), None)


def orbit(shown: Viewer, runs: int) -> dict:
    """Orbits with nothing selected, and times each movement until a redraw of another camera has been swapped."""
    left, top, right, bottom = shown.rest()["picture"]
    x, y = (left + right) / 2, (top + bottom) / 2
    shown.mouse.move(x, y)
    shown.rest()
    shown.mouse.button(True)
    for _ in range(3):  # past what still counts as a click
        x += 4
        shown.mouse.move(x, y)
        time.sleep(0.05)
    shown.rest()
    answers, steps = [], []
    for number in range(runs):
        before = shown.redraws[-1]["camera"]
        x += 9 if number % 2 == 0 else -9
        begin = time.perf_counter()
        shown.mouse.move(x, y)
        redraw = shown.wait("the turned camera", lambda redraw: redraw["camera"] != before)
        answers.append((time.perf_counter() - begin) * 1e3)
        steps.append(redraw["step"])
    shown.mouse.button(False)
    shown.rest()
    return {"answer_ms": statistics.median(answers), "worst_ms": max(answers), "step": statistics.median(steps)}


def move_all(shown: Viewer, count: int) -> dict:
    """The peak of memory after opening, after selecting everything, and after moving it all and undoing that."""
    peaks = {"open": peak_mb(shown)}
    shown.mouse.key("Control_L", "a")
    redraw = shown.wait("everything selected",
                         lambda redraw: redraw["selected"] == count and redraw["resting"] and "slider x" in redraw["widgets"])
    peaks["select all"] = peak_mb(shown)
    left, top, right, bottom = redraw["widgets"]["slider x"]
    x, y, before = (left + right) / 2, (top + bottom) / 2, redraw["undo"]
    shown.mouse.move(x, y)
    shown.mouse.button(True)
    shown.rest()
    shown.mouse.move(x + 5, y)
    shown.wait("the move", lambda redraw: redraw["undo"] != before)
    shown.mouse.button(False)
    revision = shown.rest()["revision"]
    shown.mouse.key("Control_L", "z")
    shown.wait("the undo", lambda redraw: redraw["revision"] != revision and redraw["undo"] == before and redraw["resting"])
    peaks["move all, undo"] = peak_mb(shown)
    return peaks


def large(bench: Bench) -> tuple[list[Row], dict]:
    """The window from 4 to 1,000,000 spheres of both sets: dragging, orbiting, opening, memory."""
    if shutil.which("Xvfb") is None:
        return [Row("large", "needs Xvfb")], {}
    rows, data = [], {"counts": COUNTS, "sets": {}}
    for scene_set in SETS:
        points = data["sets"][scene_set] = []
        for count in COUNTS:
            scene = bench.scene(scene_set, count)
            opened = [opening(bench, scene, count) for _ in range(min(bench.runs, 3))]
            point = {"spheres": count, "open": {key: statistics.median(run[key] for run in opened) for key in opened[0]}}
            with viewer(bench, scene) as shown:
                shown.wait("the scene", lambda redraw: redraw["spheres"] == count and redraw["resting"])
                point["peak_mb"] = move_all(shown, count)
            with viewer(bench, scene) as shown:
                shown.wait("the scene", lambda redraw: redraw["spheres"] == count and redraw["resting"])
                point["orbit"] = orbit(shown, max(20, bench.runs))
                point["drag"] = drag(shown, max(20, bench.runs))
            case = Case(f"edit-{scene_set}-{count}", [bench.program("live"), scene_set, str(count), str(bench.runs), "edit"],
                        {"LIBGL_ALWAYS_SOFTWARE": "1"})
            point["edit_ms"] = json.loads(bench.run(case)["stdout"])["edit apart from drawing"]["wall_ms"]
            points.append(point)
            rows += rows_of(scene_set, point)
    return rows, data


def rows_of(scene_set: str, point: dict) -> list[Row]:
    opened, count = point["open"], point["spheres"]
    rows = [Row(f"{scene_set}, {count:,} spheres", f"opening: a window after {opened['window_ms']:.0f} ms, the scene's picture "
                f"after {opened['picture_ms']:.0f} ms, the final one after {opened['exact_ms']:.0f} ms")]
    for what, limit in [("drag", 30), ("orbit", 100)]:
        part = point[what]
        rows.append(at_most(f"  {what}, from the mouse to the picture", part["answer_ms"], limit, " ms"))
        rows.append(Row("    the worst", f"{part['worst_ms']:.0f} ms, every {part['step']:g}th pixel"))
    rows.append(at_most("  an edit apart from drawing", point["edit_ms"], 1, " ms"))
    for when, peak in point["peak_mb"].items():
        if peak is not None:
            what = f"  peak memory: {when}"
            rows.append(at_most(what, peak, MEMORY_MB, " MB") if count == MILLION else Row(what, f"{peak:.0f} MB"))
    return rows
