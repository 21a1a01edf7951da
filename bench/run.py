#!/usr/bin/env python3
"""Measures whole runs of the program against the yardstick (and other programs), and says which targets are met.

Every section below returns rows (what, measured, target, met) and the data behind them; a new comparison is a new
section in SECTIONS. Runs of one comparison take turns (A B C A B C ...), so that a busy machine slows all of them alike.
"""
import argparse
import datetime
import json
import math
import os
import platform
import shlex
import statistics
import subprocess
import sys
from dataclasses import asdict
from pathlib import Path

from harness import (MILLION, NOTHING_COULD_RENDER, ROOT, Bench, CannotRun, Case, Row, at_most, first_line, machine, median,
                     phases)
from large import large
from peers import COUNTS, SETS, light_peers, peers
from plot import draw_large, draw_peers
from trajectory import trajectory
from window import window


def whole_process(bench: Bench) -> tuple[list[Row], dict]:
    """input4.txt in, PNG out, against the yardstick; the pictures must be the same."""
    scene = ROOT / "scenes" / "input4.txt"
    golden = bench.out / "yardstick.png"
    cases = [
        Case("yardstick", [bench.program("yardstick"), str(scene), str(golden)]),
        bench.render("cpu", scene, "--backend", "cpu", "--json"),
        bench.render("egl", scene, "--backend", "egl", "--json", LIBGL_ALWAYS_SOFTWARE="1"),
    ]
    limits = {"cpu": 0.3, "egl": 1.0}
    rows = []
    bench.run(cases[0])
    for case in cases[1:]:
        try:
            bench.run(Case(case.name, [*case.command, "--expect", str(golden)], case.environment))
        except CannotRun as error:
            if error.status != NOTHING_COULD_RENDER:
                raise
            rows.append(Row(f"input4.txt, {case.name}", f"does not work here: {error}"))
            cases.remove(case)
    samples = bench.interleaved(cases)
    data = {"scene": scene.name, "samples": samples, "phases_ms": {}}
    for name, runs in samples.items():
        rows.append(Row(f"input4.txt, {name}", f"{median(runs, 'wall_s') * 1e3:.1f} ms, {median(runs, 'cpu_s') * 1e3:.1f} ms of "
                        f"CPU time, peak {median(runs, 'peak_bytes') / 1e6:.1f} MB"))
        if name != "yardstick":
            ratio = median(runs, "wall_s") / median(samples["yardstick"], "wall_s")
            rows.append(at_most(f"  {name} / yardstick", ratio, limits[name]))
            data["phases_ms"][name] = phases(runs)
    return rows, data


def reading(bench: Bench) -> tuple[list[Row], dict]:
    """A million spheres: how long reading takes, and what memory a sphere costs the whole process."""
    scenes = {"empty": bench.out / "empty.txt", "volume": bench.out / "volume.txt", "half": bench.out / "half.txt"}
    for name, arguments in [("empty", ["volume", "0"]), ("volume", ["volume", str(MILLION)]), ("half", ["half", str(MILLION)])]:
        with scenes[name].open("wb") as file:
            subprocess.run([bench.program("make_scene"), *arguments], stdout=file, check=True)
    scenes["volume, TOML"] = bench.out / "volume.toml"
    subprocess.run([bench.program("sphereview"), "convert", str(scenes["volume"]), str(scenes["volume, TOML"])], check=True)
    data_formats = {"volume, XYZ": "xyz", "volume, extended XYZ": "extxyz", "volume, CSV": "csv", "volume, PDB": "pdb",
                    "volume, mmCIF": "mmcif", "volume, crystal in CIF": "cif", "volume, LAMMPS": "lammps",
                    "volume, GROMACS": "gro", "volume, POSCAR": "poscar", "volume, SDF": "sdf", "volume, PQR": "pqr",
                    "volume, PLY": "ply", "volume, binary PLY": "binary_ply"}
    for name, kind in data_formats.items():
        scenes[name] = bench.out / f"volume.{kind}"
        with scenes[name].open("wb") as file:
            subprocess.run([bench.program("make_scene"), "volume", str(MILLION), "1", kind], stdout=file, check=True)
    tiny = ["--backend", "cpu", "--json", "-s", "1x1"]
    samples = bench.interleaved([bench.render(name, scene, *tiny) for name, scene in scenes.items()])
    rows, data = [], {"samples": samples, "file_bytes": {}, "read_ms": {}}
    for name in list(scenes)[1:]:
        size = scenes[name].stat().st_size
        read_ms = phases(samples[name])["read"]
        data["file_bytes"][name], data["read_ms"][name] = size, read_ms
        per_sphere = (median(samples[name], "peak_bytes") - median(samples["empty"], "peak_bytes")) / MILLION
        speed = size / read_ms / 1e3
        if name in data_formats:
            text_ms = data["read_ms"]["volume"]
            rows.append(Row(f"1,000,000 spheres, {name}, {size / 1e6:.1f} MB",
                            f"{speed:.0f} MB/s, {read_ms / text_ms:.2f} times the text format's time, {per_sphere:.0f} bytes a sphere",
                            "at least 100 MB/s", speed >= 100))
            continue
        if "TOML" in name:
            rows.append(Row(f"1,000,000 spheres, {name}", f"{size / 1e6:.1f} MB, {speed:.0f} MB/s"))
        else:
            rows.append(Row(f"1,000,000 spheres, {name}, {size / 1e6:.1f} MB", f"{speed:.0f} MB/s", "at least 250 MB/s", speed >= 250))
        rows.append(at_most("  reading", read_ms / 1e3, 1.0, " s"))
        rows.append(at_most("  peak memory of the process, a sphere", per_sphere, 100, " bytes"))
    return rows, data


def certificate(bench: Bench) -> tuple[list[Row], dict]:
    """What certifying costs, also with the eye on a surface, and what spheres cost that are copies of one."""
    pairs = []
    for count in [4, 100, 1000]:
        text = subprocess.run([bench.program("make_scene"), "volume", str(count)], capture_output=True, text=True, check=True).stdout
        spheres = text.split("\n", 1)[1]
        # The eye lies on this one's surface, which it does not hide: it is behind the eye.
        for name, scene in [("", text), (", eye on a surface", f"{count + 1}\n0 0 9 0 0 -10 10\n{spheres}")]:
            path = bench.out / f"certify-{count}{name.replace(', ', '-').replace(' ', '-')}.txt"
            path.write_text(scene)
            for backend in ["cpu", "egl"]:
                options = ["--backend", backend]
                pairs.append((f"{count} spheres{name}, {backend}: certified / not", 1.5,
                              bench.render(f"{path.stem}-{backend}", path, *options),
                              bench.render(f"{path.stem}-{backend}-not", path, *options, "--no-certify")))
    one = "255 0 0 0 0 300 120\n"
    for name, scene in [("one", f"1\n{one}"), ("copies", f"1000\n{one * 1000}"), ("twins", f"2\n{one}0 255 0 0 0 300 120\n")]:
        (bench.out / f"{name}.txt").write_text(scene)
    for name in ["copies", "twins"]:
        pairs.append((f"1 sphere, {name}: with / without", 3.0, bench.render(name, bench.out / f"{name}.txt", "--backend", "cpu"),
                      bench.render(f"one-{name}", bench.out / "one.txt", "--backend", "cpu")))
    rows, data = [], {}
    for what, limit, with_it, without in pairs:
        samples = bench.interleaved([with_it, without])
        rows.append(at_most(what, median(samples[with_it.name], "wall_s") / median(samples[without.name], "wall_s"), limit))
        data |= samples
    return rows, data


def stress(bench: Bench) -> tuple[list[Row], dict]:
    """5,000 spheres that double cannot tell apart at most pixels: some of tests/oracle/stress_scenes.cpp."""
    count = 5000
    ulp = math.ulp
    kinds = {
        "very far": lambda i: (0, 0, 1e300 * (i + 1), 1e305),
        "through nearly one point": lambda i: (0, 0, 1e15 + i, 1e15 + i - 100),
        "radii one unit apart": lambda i: (0, 0, 200, 130 + i * ulp(130)),
        "depths one unit apart": lambda i: (0, 0, 200 + (count - i) * ulp(200), 130),
        "centres and radii some units apart": lambda i: (30 + i * 7 % 17 * ulp(30), -40 + i * 5 % 13 * ulp(40),
                                                         200 + i * 3 % 11 * ulp(200), 100 + i % 19 * ulp(100)),
    }
    cases = []
    for name, sphere in kinds.items():
        path = bench.out / f"stress-{name.replace(' ', '-')}.txt"
        lines = [" ".join(map(repr, (i % 256, i // 256, 0, *map(float, sphere(i))))) for i in range(count)]
        path.write_text("\n".join([str(count), *lines, ""]))
        cases += [bench.render(f"{name}, {backend}", path, "-s", "200x200", "--backend", backend) for backend in ["cpu", "egl"]]
    samples = bench.interleaved(cases, most_runs=3)  # each takes seconds, and a bound needs no finer median
    return [at_most(f"5,000 spheres, {name}", median(runs, "wall_s"), 2, " s") for name, runs in samples.items()], samples


def micro(bench: Bench) -> tuple[list[Row], dict]:
    """The parts one by one; see micro.cpp."""
    command = [bench.program("micro_benchmarks"), "--benchmark_format=json", "--benchmark_repetitions=10",
               "--benchmark_min_time=0.1", "--benchmark_enable_random_interleaving=true"]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    if done.returncode != 0:
        raise CannotRun("micro_benchmarks", done.returncode)
    data = json.loads(done.stdout)
    data["benchmarks"].sort(key=lambda b: (b["family_index"], b["per_family_instance_index"]))
    medians = {b["run_name"].removesuffix("/real_time"): b for b in data["benchmarks"] if b.get("aggregate_name") == "median"}
    rows = []
    for name, result in medians.items():
        size = f", {result['file_bytes']:,.0f} bytes" if "file_bytes" in result else ""
        speed = f", {result['bytes_per_second'] / 1e6:.0f} MB/s" if "bytes_per_second" in result else ""
        rows.append(Row(name, f"{result['real_time']:.3g} ms{speed}{size}"))
    for picture in ["input4", "10000_half"]:
        ours, stb = medians[f"encode/ours/{picture}"], medians[f"encode/stb/{picture}"]
        rows.append(at_most(f"encoding {picture}, time / stb's", ours["real_time"] / stb["real_time"], 0.25))
        rows.append(at_most(f"encoding {picture}, size / stb's", ours["file_bytes"] / stb["file_bytes"], 1.0))
    return rows, data


def frames(bench: Bench) -> tuple[list[Row], dict]:
    """Frames with lists built, and the building of lists; see frames.cpp."""
    rows, data, frame_ms = [], {}, {}
    for scene_set in SETS:
        for count in COUNTS:
            name = f"{scene_set}-{count}"
            case = Case(name, [bench.program("frames"), scene_set, str(count), str(bench.runs)], {"LIBGL_ALWAYS_SOFTWARE": "1"})
            result = json.loads(bench.run(case)["stdout"])
            data[name] = result
            wall = {what: cost["wall_ms"] for what, cost in result.items() if isinstance(cost, dict)}
            frame_ms[name] = wall["gpu frame with read back"]
            rows.append(Row(f"{scene_set}, {count:,} spheres", ", ".join(f"{what} {ms:.1f}" for what, ms in wall.items()) + " ms"))
            if count == MILLION:
                rows += [
                    at_most("  gpu frame with read back", frame_ms[name], {"volume": 40, "half": 150}[scene_set], " ms"),
                    at_most("  building the lists, gpu", wall["gpu lists"], 100, " ms"),
                    at_most("  building the lists, cpu", wall["cpu lists"], 100, " ms"),
                    at_most("  scene and lists, bytes a sphere", result["bytes_per_sphere"], 120),
                    at_most("  of it on the GPU, bytes a sphere", result["gpu_bytes_per_sphere"], 80),
                ]
        rows.append(at_most(f"{scene_set}, gpu frame, 1,000 / 4 spheres", frame_ms[f"{scene_set}-1000"] / frame_ms[f"{scene_set}-4"], 2))
    return rows, data


def samples(bench: Bench) -> tuple[list[Row], dict]:
    """What 4 and 16 samples a pixel cost an export, and the window (see live.cpp)."""
    scenes = {"input4.txt": ROOT / "scenes" / "input4.txt"}
    for scene_set in SETS:
        scenes[f"{scene_set}, {MILLION:,} spheres"] = bench.scene(scene_set, MILLION)
    rows, data = [], {}
    for name, scene in scenes.items():
        for backend in ["cpu", "egl"]:
            cases = [bench.render(f"{scene.stem}-{backend}-{count}", scene, "--backend", backend, "--samples", str(count),
                                  LIBGL_ALWAYS_SOFTWARE="1") for count in [1, 4, 16]]
            taken = bench.interleaved(cases)
            data |= taken
            seconds = [median(taken[case.name], "wall_s") for case in cases]
            rows.append(Row(f"{name}, {backend}, 1, 4, 16 samples", ", ".join(f"{s * 1e3:.0f}" for s in seconds) + " ms"))
            rows.append(at_most("  16 samples / 1", seconds[2] / seconds[0], 16))
    for count in [4, 1000, MILLION]:
        case = Case(f"window-{count}", [bench.program("live"), "half", str(count), str(bench.runs)], {"LIBGL_ALWAYS_SOFTWARE": "1"})
        result = data[case.name] = json.loads(bench.run(case)["stdout"])
        wall = {what: cost["wall_ms"] for what, cost in result.items() if "samples" in what}
        rows.append(Row(f"window, {count:,} spheres", ", ".join(f"{what} {ms:.0f}" for what, ms in wall.items()) + " ms"))
    return rows, data


def live(bench: Bench) -> tuple[list[Row], dict]:
    """The viewer's picture while a sphere is dragged, and while the camera moves; see live.cpp."""
    rows, data = [], {}
    for count in [4, 1000]:
        case = Case(f"live-{count}", [bench.program("live"), "volume", str(count), str(bench.runs)], {"LIBGL_ALWAYS_SOFTWARE": "1"})
        result = data[case.name] = json.loads(bench.run(case)["stdout"])
        wall = {what: cost["wall_ms"] for what, cost in result.items() if isinstance(cost, dict) and "samples" not in what}
        rows.append(Row(f"live, {count:,} spheres", ", ".join(f"{what} {ms:.1f}" for what, ms in wall.items()) + " ms"))
        rows.append(at_most("  drag, from the edit to the pixels", min(wall[f"drag, step {step}"] for step in [1, 2, 4, 8]), 30, " ms"))
    for scene in ["volume", "half"]:
        for count in [4, 1000, 100_000, 1_000_000]:
            case = Case(f"orbit-{scene}-{count}", [bench.program("live"), scene, str(count), str(bench.runs), "orbit"],
                        {"LIBGL_ALWAYS_SOFTWARE": "1"})
            result = data[case.name] = json.loads(bench.run(case)["stdout"])
            wall = {what: cost["wall_ms"] for what, cost in result.items() if isinstance(cost, dict)}
            rows.append(Row(f"{scene}, {count:,} spheres", ", ".join(f"{what} {ms:.1f}" for what, ms in wall.items()) + " ms"))
            rows.append(at_most("  orbit, from the camera to the pixels", min(wall[f"orbit, step {step}"] for step in [1, 2, 4, 8]),
                                100, " ms"))
    return rows, data


def lights(bench: Bench) -> tuple[list[Row], dict]:
    """The light of pictures of 1000 x 1000 pixels, a light at a time; see lights.cpp. Also of spheres that cover everything, of
    spheres nearly in one place, and of scenes with sizes far apart, or at the ends of double's range. The memory is that of a
    whole run beside the same run without light."""
    rows, data = [], {}
    many = 64
    limits = {("volume", 1000): 6, ("half", 1000): 6, ("volume", 100_000): 22, ("half", 100_000): 22, ("volume", MILLION): 60,
              ("half", MILLION): 60, ("huge", 1000): 60, ("equal", 100_000): 60,
              ("far", 1000): 12, ("background", 1000): 20, ("scaled", 1000): 12, ("giant", 1000): 20}
    for (scene_set, count), limit in limits.items():
        case = Case(f"lights-{scene_set}-{count}", [bench.program("lights"), scene_set, str(count), str(many), str(min(bench.runs, 5))])
        result = data[case.name] = json.loads(bench.run(case)["stdout"])
        wall = result["light"]["wall_ms"]
        rows.append(Row(f"{scene_set}, {count:,} spheres, {many} lights", f"{wall:.0f} ms"))
        rows.append(at_most("  a light", wall / many, limit, " ms"))
        first = result["first light"]
        rows.append(Row("  until there is a first one to show", f"{first['wall_ms']:.0f} ms, {first['cpu_ms']:.0f} ms of CPU time"))
    for count in [1000, MILLION]:
        scene = bench.scene("volume", count)
        flat, lit = (bench.render(f"{scene.stem}-{name}", scene, "--backend", "cpu", *options)
                     for name, options in [("flat", []), ("lit", ["--shade", "studio", "--lights", str(many)])])
        taken = bench.interleaved([flat, lit], 5)
        data |= taken
        seconds = median(taken[lit.name], "wall_s")
        rows.append(Row(f"volume, {count:,} spheres, {many} lights, a whole run", f"{seconds:.2f} s"))
        if count == 1000:
            rows.append(at_most("  all of it", seconds, 0.5, " s"))
        more = median(taken[lit.name], "peak_bytes") - median(taken[flat.name], "peak_bytes")
        rows.append(at_most("  memory beside the flat picture's", more / 1e6, 60, " MB"))
    return rows, data


def arrays(bench: Bench) -> tuple[list[Row], dict]:
    """Python: a million spheres in arrays to a picture in one, beside what the program takes from the scene that it has read to the
    picture that it has yet to write; see arrays.py."""
    modules = sorted(bench.build.glob("python/sphereview/_native.cpython-3*.so"))
    if not modules:
        return [Row("a million spheres in arrays", "the Python module was not built")], {}
    python = "python3." + modules[0].name.removeprefix("_native.cpython-3").partition("-")[0]
    rows, data = [], {}
    for scene_set in SETS:
        scene = bench.scene(scene_set, MILLION)
        program = bench.render(f"arrays-{scene_set}-program", scene, "--backend", "cpu", "--json")
        module = Case(f"arrays-{scene_set}", [python, str(ROOT / "bench" / "arrays.py"), str(scene), "3"],
                      {"PYTHONPATH": str(bench.build / "python")})
        try:
            taken = bench.interleaved([program, module], 10)
        except CannotRun as error:
            return [Row("a million spheres in arrays", f"does not work here: {error}")], {}
        data |= taken
        of_program = phases(taken[program.name])
        program_ms = sum(of_program[phase] for phase in ["lists", "prepare", "trace", "resolve", "light"])
        module_ms = statistics.median(json.loads(sample["stdout"])["render_ms"] for sample in taken[module.name])
        rows.append(Row(f"{scene_set}, 1,000,000 spheres in arrays, cpu", f"{module_ms:.0f} ms; the program {program_ms:.0f} ms"))
        rows.append(at_most("  arrays / program's own scene", module_ms / program_ms, 1.1))  # no slower, but for what runs differ by
    return rows, data


SECTIONS = {"whole": whole_process, "reading": reading, "certificate": certificate, "stress": stress, "frames": frames, "live": live,
            "samples": samples, "arrays": arrays, "lights": lights, "window": window, "large": large, "trajectory": trajectory,
            "micro": micro}
PEER_SECTIONS = {"peers": peers, "light-peers": light_peers}


def numbers(text: str) -> list[int]:
    return [int(number) for number in text.split(",")]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "bench", help="where the bench preset was built")
    parser.add_argument("--runs", type=int, default=20, help="runs of each case (default: %(default)s)")
    parser.add_argument("--only", choices=[*SECTIONS, *PEER_SECTIONS], action="append", help="only this section; may be repeated")
    parser.add_argument("--peers", action="store_true", help="compare with Embree, Tachyon and POV-Ray too")
    parser.add_argument("--counts", type=numbers, default=COUNTS, metavar="N,N,...",
                        help="how many spheres the comparison with peers draws (default: %(default)s)")
    parser.add_argument("--plot", action="store_true",
                        help="put what was measured of the sections peers and large into docs/, as data and as plots")
    options = parser.parse_args()
    if options.runs < 1 or min(options.counts) < 1:
        parser.error("--runs, --counts: expected at least 1")
    sections = dict(SECTIONS)
    if options.peers:
        sections |= {name: lambda bench, section=section: section(bench, options.counts) for name, section in PEER_SECTIONS.items()}
    for name in set(options.only or []) & set(PEER_SECTIONS):
        if not options.peers:
            parser.error(f"--only {name}: expected with --peers")
    if not (options.build / "measure").exists():
        parser.error(f"--build: {options.build} is not built: cmake --preset bench && cmake --build --preset bench")

    bench = Bench(options.build, options.runs)
    versions = {"sphereview": first_line([bench.program("sphereview"), "--version"]),
                "commit": first_line(["git", "describe", "--always", "--dirty"]), "python": platform.python_version()}
    results = {"date": datetime.datetime.now().astimezone().isoformat(timespec="seconds"), "machine": machine(),
               "command": shlex.join([os.path.relpath(sys.argv[0], ROOT), *sys.argv[1:]]), "versions": versions,
               "runs": options.runs, "rows": [], "data": {}}
    status = 0
    for name, section in sections.items():
        if options.only and name not in options.only:
            continue
        try:
            rows, results["data"][name] = section(bench)
        except (CannotRun, OSError, subprocess.CalledProcessError) as error:
            rows, status = [Row(name, f"could not run: {error}")], 1
        for row in rows:
            verdict = "" if row.met is None else "met" if row.met else "NOT MET"
            print(f"{row.what:<42} {row.measured:<52} {row.target:<18} {verdict}", flush=True)
        results["rows"] += [asdict(row) for row in rows]
    path = options.build / "results.json"
    path.write_text(json.dumps(results, indent=1) + "\n")
    for section, name, draw in [("peers", "peers", draw_peers), ("large", "live", draw_large)]:
        if options.plot and results["data"].get(section):
            measured = {key: results[key] for key in ["date", "command", "machine", "versions", "runs"]}
            measured[section] = results["data"][section]
            (ROOT / "docs" / f"{name}.json").write_text(json.dumps(measured, indent=1) + "\n")
            (ROOT / "docs" / f"{name}.svg").write_text(draw(measured))
    print(f"{results['machine']['cpu']}, {results['machine']['cores']} cores; medians of {options.runs}; all of it in {path}")
    return status


if __name__ == "__main__":
    sys.exit(main())
