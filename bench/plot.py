#!/usr/bin/env python3
"""Draws time against the number of spheres from what `run.py --plot` measured. usage: plot.py IN.json OUT.svg"""
import json
import math
import sys
from pathlib import Path
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 1000, 470
TOP, BOTTOM = 84, 404  # of both panels
PANELS = [(70, 490), (560, 980)]  # left and right of each

# Name in the data, in the legend, colour (Okabe and Ito's, told apart by the colour-blind too), width of the line.
PROGRAMS = [
    ("cpu", "sphereview, CPU", "#d55e00", 3),
    ("egl", "sphereview, llvmpipe", "#e69f00", 3),
    ("embree", "Embree", "#0072b2", 1.8),
    ("tachyon", "Tachyon", "#009e73", 1.8),
    ("povray", "POV-Ray", "#888888", 1.8),
]
# The same of the window; see large.py.
ANSWERS = [
    ("drag", "drag of a sphere", "#d55e00", 3),
    ("orbit", "orbit", "#0072b2", 3),
    ("opening", "start to the scene's picture", "#009e73", 1.8),
    ("exact", "start to the final picture", "#888888", 1.8),
]
SETS = {"volume": "volume: N spheres of radius 130 N^(-1/3)", "half": "half: N spheres of radius 289 N^(-1/2)"}


def text(x: float, y: float, words: str, size: int = 13, anchor: str = "middle", color: str = "#222222") -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" fill="{color}">{escape(words)}</text>'


def line(x1: float, y1: float, x2: float, y2: float, color: str = "#dddddd", width: float = 1) -> str:
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{color}" stroke-width="{width}"/>'


def seconds(value: float) -> str:
    return f"{value:g} s" if value >= 1 else f"{value * 1e3:g} ms"


def seconds_of(point: dict) -> float | None:
    return point.get("wall_s", point.get("more_than_s"))


def curve(points: list[tuple[float, float, bool]], color: str, width: float) -> list[str]:
    """One program's line, with a dot at every time measured and an arrow where it took longer than can be said."""
    out = []
    if len(points) > 1:
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y, _ in points)
        out.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="{width}" stroke-linejoin="round"/>')
    for x, y, known in points:
        out.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{width + 1.5}" fill="{color}"/>' if known else
                   f'<path d="M{x:.1f} {y - 12:.1f}l5.5 9h-11z" fill="{color}"/>')
    return out


def draw_peers(measured: dict) -> str:
    data = measured["peers"]
    return draw(measured, data["counts"], data["sets"], PROGRAMS,
                "Scene file in, 1000 x 1000 PNG out: time of the whole process against the number of spheres",
                f"; a triangle: more than {data['limit_s']} s")


def draw_large(measured: dict) -> str:
    sets = {}
    for scene_set, points in measured["large"]["sets"].items():
        times = {"drag": ("drag", "answer_ms"), "orbit": ("orbit", "answer_ms"), "opening": ("open", "picture_ms"),
                 "exact": ("open", "exact_ms")}
        sets[scene_set] = {name: [{"spheres": point["spheres"], "wall_s": point[part][key] / 1e3} for point in points]
                           for name, (part, key) in times.items()}
    return draw(measured, measured["large"]["counts"], sets, ANSWERS,
                "The window, drawn by llvmpipe: time from the input to the picture against the number of spheres")


def draw(measured: dict, counts: list[int], sets: dict, lines: list[tuple], title: str, note: str = "") -> str:
    """`sets`: of each set of scenes, of each of `lines` by its name, points of "spheres" and "wall_s" or "more_than_s"."""
    points = [point for programs in sets.values() for runs in programs.values() for point in runs if seconds_of(point)]
    low = math.floor(math.log10(min(seconds_of(point) for point in points)))
    high = math.log10(max(seconds_of(point) for point in points)) + 0.2
    first, last = math.log10(min(counts)), math.log10(max(counts))
    machine = measured["machine"]
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
           'font-family="sans-serif">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
           text(WIDTH / 2, 24, title, 16)]

    x = 200
    for _, label, color, width in lines:
        out += [line(x, 46, x + 26, 46, color, width), text(x + 34, 50, label, 13, "start")]
        x += 60 + 7 * len(label)

    def y_of(time: float) -> float:
        return BOTTOM - (math.log10(time) - low) / (high - low) * (BOTTOM - TOP)

    for (left, right), (scene_set, programs) in zip(PANELS, sets.items()):
        def x_of(count: int) -> float:
            return left + 15 + (math.log10(count) - first) / max(last - first, 1) * (right - left - 45)

        out.append(text((left + right) / 2, TOP - 12, SETS[scene_set]))
        for power in range(low, math.floor(high) + 1):
            out += [line(left, y_of(part * 10.0**power), right, y_of(part * 10.0**power), "#bbbbbb" if part == 1 else "#eeeeee")
                    for part in range(1, 10) if math.log10(part) + power <= high]
            out.append(text(left - 8, y_of(10.0**power) + 4, seconds(10.0**power), 12, "end"))
        for count in counts:
            out += [line(x_of(count), TOP, x_of(count), BOTTOM), text(x_of(count), BOTTOM + 18, f"{count:,}", 12)]
        for name, _, color, width in reversed(lines):  # ours on top
            known = [(x_of(p["spheres"]), y_of(seconds_of(p)), "wall_s" in p) for p in programs.get(name, []) if seconds_of(p)]
            out += curve(known, color, width)
    out += [text(WIDTH / 2, BOTTOM + 38, "spheres"),
            text(WIDTH / 2, HEIGHT - 8, f"medians of {measured['runs']}; {machine['cpu']}, {machine['cores']} cores; "
                 f"{measured['date'][:10]}; {measured['command']}{note}", 11,
                 color="#666666"), "</svg>"]
    return "\n".join(out) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    read = json.loads(Path(sys.argv[1]).read_text())
    Path(sys.argv[2]).write_text(draw_peers(read) if "peers" in read else draw_large(read))
