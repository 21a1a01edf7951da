"""Frames a second of trajectories, one process and several, beside other programs; memory; and how soon the last frame of a large
file is there, with the index of its frames and without.
"""
import gzip
import os
import random
import shutil
import subprocess
import sys
from pathlib import Path

from harness import MILLION, ROOT, Bench, CannotRun, Case, Row, progress
from peer_scenes import SIDE, shift_into_view, write_tachyon

# Spheres, and frames of each.
SETS = {200: 1000, 10_000: 1000, MILLION: 8}
LIT_SHARE = 4  # a quarter of them is lit: a frame takes longer
SKY_RAYS = 16  # of each point toward the sky, ours and the others'
LIT = ["--shade", "studio", "--lights", str(SKY_RAYS)]
PEER_FRAMES = {200: 20, 10_000: 20, MILLION: 2}  # of the others, whose frames take longer
LARGE_BYTES = 2_000_000_000
GOAL = 10  # times OVITO's frames a second, at 10,000 atoms


def write_frames(path: Path, frames: int, spheres: int) -> None:
    """Atoms that drift, as XYZ: of every frame the same seeded places, a little farther on."""
    if path.exists():
        return
    generator = random.Random(spheres)
    side = 3.0 * spheres ** (1 / 3)
    atoms = [(generator.choice(["C", "O", "H", "N"]), generator.uniform(0, side), generator.uniform(0, side), generator.uniform(0, side))
             for _ in range(spheres)]
    progress(f"writing {path.name}")
    with path.open("w") as file:
        for frame in range(frames):
            shift = 0.01 * frame
            file.write(f"{spheres}\nframe {frame}\n")
            file.writelines(f"{element} {x + shift:.4f} {y - shift:.4f} {z:.4f}\n" for element, x, y, z in atoms)
    progress("")


def render(bench: Bench, path: Path, frames: int, *options: str) -> list[str]:
    return [bench.program("sphereview"), "render", str(path), "--frames", f":{frames}", "-o", str(bench.out / "frames" / "{frame:05}.png"),
            "--no-sync", *options]


def in_parts(command: list[str], parts: int) -> list[str]:
    """All parts at once, and the status of one that fails."""
    script = "".join(f'"$@" --part {part}/{parts} & p{part}=$!; ' for part in range(1, parts + 1))
    return ["sh", "-c", script + " && ".join(f"wait $p{part}" for part in range(1, parts + 1)), "sh", *command]


def ovito(path: Path, frames: int, lit: bool) -> list[str]:
    return [os.environ.get("OVITO_PYTHON", sys.executable), str(ROOT / "bench" / "ovito_frames.py"), str(path), str(frames), str(SIDE),
            str(SKY_RAYS if lit else 0)]


def tachyon(bench: Bench, path: Path, frames: int, lit: bool) -> list[str]:
    """The first frames, one after the other; what it reads is written before."""
    scenes = []
    for frame in range(frames):
        text, scene = bench.out / "frame.txt", bench.out / f"{path.stem}-{frame}-{'lit' if lit else 'flat'}.dat"
        subprocess.run([bench.program("sphereview"), "convert", str(path), str(text), "--frame", str(frame)], check=True,
                       stderr=subprocess.DEVNULL)
        write_tachyon(text, scene, lit, shift_into_view(text))
        scenes.append(scene)
    options = ["-fullshade", "-auto_skylight", "1", "-skylight_samples", str(SKY_RAYS)] if lit else ["-lowshade"]
    run = f'for scene in "$@"; do tachyon "$scene" {" ".join(options)} -format PNG -o "{bench.out}/tachyon.png" >/dev/null || exit 1; done'
    return ["sh", "-c", run, "sh", *map(str, scenes)]


def frames_a_second(bench: Bench, name: str, frames: int, command: list[str], environment: dict[str, str] | None = None) -> dict:
    """The best of some runs: others may use the machine."""
    runs = []
    for _ in range(min(bench.runs, 3)):
        progress(name)
        runs.append(bench.run(Case(name, command, environment or {})))
        shutil.rmtree(bench.out / "frames", ignore_errors=True)
    progress("")
    best = min(runs, key=lambda run: run["wall_s"])
    return {"frames": frames, "fps": frames / best["wall_s"], "wall_s": best["wall_s"], "cpu_s": best["cpu_s"],
            "peak_bytes": best["peak_bytes"]}


def described(result: dict) -> str:
    return (f"{result['fps']:.3g} frames/s, {1e3 * result['cpu_s'] / result['frames']:.3g} ms of CPU time a frame, "
            f"peak {result['peak_bytes'] / 1e6:.0f} MB")


def throughput(bench: Bench) -> tuple[list[Row], dict]:
    rows, data = [], {}
    one_core = ["taskset", "-c", str(min(os.sched_getaffinity(0)))] if hasattr(os, "sched_getaffinity") else []
    for spheres, all_frames in SETS.items():
        path = bench.out / f"drift-{spheres}.xyz"
        write_frames(path, all_frames, spheres)
        for shade, more in [("flat", []), ("lit", LIT)]:
            frames = all_frames // (LIT_SHARE if shade == "lit" else 1)
            cpu = render(bench, path, frames, "--backend", "cpu", *more)
            cases = {"one process": (frames, cpu, {}), "one process, one core": (frames, [*one_core, *cpu], {}),
                     "2 parts": (frames, in_parts(cpu, 2), {}),
                     "egl": (frames, render(bench, path, frames, "--backend", "egl", *more), {"LIBGL_ALWAYS_SOFTWARE": "1"}),
                     "ovito": (PEER_FRAMES[spheres], ovito(path, PEER_FRAMES[spheres], shade == "lit"), {"QT_QPA_PLATFORM": "offscreen"})}
            if shutil.which("tachyon"):
                cases["tachyon"] = (PEER_FRAMES[spheres], tachyon(bench, path, PEER_FRAMES[spheres], shade == "lit"), {})
            for name, (count, command, environment) in cases.items():
                key = f"{spheres:,} spheres, {shade}, {name}"
                try:
                    data[key] = frames_a_second(bench, key, count, command, environment)
                    rows.append(Row(key, described(data[key])))
                except CannotRun as error:
                    rows.append(Row(key, f"does not work here: {str(error).splitlines()[-1]}"))
            ours, theirs = (data.get(f"{spheres:,} spheres, {shade}, {name}") for name in ["one process", "ovito"])
            if ours and theirs:
                ratio = ours["fps"] / theirs["fps"]
                goal = spheres == 10_000
                rows.append(Row("  times OVITO's", f"{ratio:.3g}", f"at least {GOAL}" if goal else "", ratio >= GOAL if goal else None))
    return rows, data


def last_frame(bench: Bench) -> tuple[list[Row], dict]:
    """Of a large file, and of it packed: the first time, which keeps the index, and then."""
    rows, data = [], {}
    small = bench.out / "drift-10000.xyz"
    write_frames(small, SETS[10_000], 10_000)
    large, packed = bench.out / "large.xyz", bench.out / "large.xyz.gz"
    with large.open("wb") as out:
        while out.tell() < LARGE_BYTES:
            with small.open("rb") as file:
                shutil.copyfileobj(file, out, 1 << 22)
    with large.open("rb") as file, gzip.open(packed, "wb", 1) as out:
        shutil.copyfileobj(file, out, 1 << 22)
    for path in [large, packed]:
        os.utime(path, (0, 0))
        state = bench.out / "state"
        shutil.rmtree(state, ignore_errors=True)
        command = [bench.program("sphereview"), "render", str(path), "--frames", "-1", "-o", str(bench.out / "last.png"),
                   "--backend", "cpu", "--no-sync"]
        environment = {"XDG_STATE_HOME": str(state)}
        for name, options in [("without index", ["--no-index"]), ("makes the index", []), ("with index", [])]:
            key = f"last frame, {path.name}, {path.stat().st_size / 1e9:.2g} GB, {name}"
            run = data[key] = bench.run(Case(key, [*command, *options], environment))
            rows.append(Row(key, f"{run['wall_s']:.2f} s, peak {run['peak_bytes'] / 1e6:.0f} MB"))
        path.unlink()
    return rows, data


def trajectory(bench: Bench) -> tuple[list[Row], dict]:
    rows, data = throughput(bench)
    more, times = last_frame(bench)
    return rows + more, data | times
