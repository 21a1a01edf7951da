"""Whole runs on the two seeded sets of scenes, against the other programs that can draw them.

Each is told to do as little as it can: flat colours, no shadows, no antialiasing; on all cores; a PNG out.
"""
import json
import os
import subprocess
from pathlib import Path

from harness import MILLION, Bench, CannotRun, Case, Row, at_most, first_line, median, progress
from peer_scenes import SIDE, write_povray, write_tachyon

SETS = ["volume", "half"]
COUNTS = [4, 1000, 10_000, 100_000, MILLION]
PACKAGES = ["libembree-dev", "tachyon", "povray", "libgl1-mesa-dri"]  # for the report
LIMIT_S = 120  # of one run; whoever takes longer is "more than" that
LONG_S = 10  # a run that takes longer is not repeated
SLOW_PEERS = {"tachyon": 3, "povray": 3}  # the most runs of each
SHARE_OF_PIXELS = 0.001  # that may differ from the exact picture: the peers compute in float, or round


def versions() -> dict[str, str]:
    return {package: first_line(["dpkg-query", "-W", "-f", "${Version}", package]) for package in PACKAGES}


def cases_for(bench: Bench, scene: Path) -> list[Case]:
    files = {name: bench.out / f"{name}.{kind}" for name, kind in [("tachyon", "dat"), ("povray", "pov")]}
    write_tachyon(scene, files["tachyon"])
    write_povray(scene, files["povray"])
    picture = {name: str(bench.out / f"{name}.png") for name in ["embree", *files]}
    return [
        bench.render("cpu", scene, "--backend", "cpu"),
        bench.render("egl", scene, "--backend", "egl", LIBGL_ALWAYS_SOFTWARE="1"),
        Case("embree", [bench.program("embree_peer"), str(scene), picture["embree"]]),
        Case("tachyon", ["tachyon", str(files["tachyon"]), "-lowshade", "-format", "PNG", "-o", picture["tachyon"]]),
        # -D: no display; +Q0: flat colours; +BM2: the faster of its trees here; -GA: prints nothing.
        Case("povray", ["povray", str(files["povray"]), f"+W{SIDE}", f"+H{SIDE}", f"+WT{os.cpu_count()}", "-D", "-GA", "-A", "+Q0",
                        "+BM2", "+FN", "File_Gamma=1", f"+O{picture['povray']}"]),
    ]


def measure(bench: Bench, cases: list[Case]) -> dict[str, dict]:
    """Of each case its runs, in turns, or why there are none. The first of several runs warms the caches up."""
    results: dict[str, dict] = {}
    samples: dict[str, list[dict]] = {}
    for case in cases:
        progress(f"{case.name}: first run")
        try:
            samples[case.name] = [bench.run(case, LIMIT_S)]
        except subprocess.TimeoutExpired:
            results[case.name] = {"more_than_s": LIMIT_S}
        except CannotRun as error:
            results[case.name] = {"refused": str(error).splitlines()[-1]}
    repeated = [case for case in cases if case.name in samples and samples[case.name][0]["wall_s"] <= LONG_S]
    for case in repeated:
        samples[case.name].clear()
    for number in range(bench.runs):
        progress(f"{', '.join(case.name for case in repeated)}: run {number + 1} of {bench.runs}")
        for case in repeated:
            if number < SLOW_PEERS.get(case.name, bench.runs):
                samples[case.name].append(bench.run(case))
    progress("")
    for name, runs in samples.items():
        results[name] = {**{key: median(runs, key) for key in ["wall_s", "cpu_s", "peak_bytes"]},
                         "all_wall_s": [run["wall_s"] for run in runs]}
    return {case.name: results[case.name] for case in cases}


def different_pixels(bench: Bench, scene: Path, picture: Path) -> float:
    """The share of the picture's pixels that are not as the CPU backend has them."""
    done = subprocess.run([bench.program("sphereview"), "render", str(scene), "--backend", "cpu", "--expect", str(picture),
                           "--json"], capture_output=True, text=True)
    if done.returncode > 1:
        raise CannotRun(f"comparing {picture.name}", done.returncode, done.stderr.strip())
    return json.loads(done.stdout)["comparison"]["different_pixels"] / SIDE**2


def check_pictures(bench: Bench, scene: Path, results: dict[str, dict]) -> list[Row]:
    """That everyone has drawn the same, so that no time is that of a wrong picture."""
    drawn = [name for name, result in results.items() if "wall_s" in result]
    if "cpu" not in drawn:
        return [Row("  pixels that differ", "not checked, without a picture by cpu")]
    for name in drawn:
        results[name]["different_pixels"] = different_pixels(bench, scene, bench.out / f"{name}.png")
    worst = max(drawn, key=lambda name: results[name]["different_pixels"])
    share = results[worst]["different_pixels"]
    rows = [at_most(f"  pixels that differ, most by {worst}", 100 * share, 100 * SHARE_OF_PIXELS, " %")]
    if "egl" in drawn and results["egl"]["different_pixels"] != 0:
        rows.append(Row("  egl's picture", "is not cpu's", "the same", False))
    return rows


def shown(result: dict) -> str:
    if "wall_s" in result:
        return f"{result['wall_s'] * 1e3:,.0f} ms"
    return f"more than {result['more_than_s']} s" if "more_than_s" in result else "none"


def against(results: dict[str, dict], ours: str, theirs: list[str], limit: float) -> Row:
    """Our time over the fastest of theirs. Who takes more than a limit is compared as if taking just that long."""
    times = [results[name].get("wall_s", results[name].get("more_than_s")) for name in theirs]
    what = f"  {ours} / {', '.join(theirs)}"
    known = [time for time in times if time is not None]
    if "wall_s" not in results[ours] or not known:
        missing = ours if "wall_s" not in results[ours] else theirs[0]
        return Row(what, results[missing].get("refused", shown(results[missing])), f"at most {limit:g}", False)
    return at_most(what, results[ours]["wall_s"] / min(known), limit)


# Of sphereview's directions half face a point, on average: so many rays are asked for. The others ask for this many at each point.
LIGHTS = 64
RAYS = LIGHTS // 2
POVRAY_SIDE = 8  # of its area light; half of the points face that


def lit_cases(bench: Bench, scene: Path) -> dict[str, tuple[Case, Case]]:
    """Of each program a run without light and a run with it."""
    files = {name: bench.out / f"{name}.{kind}" for name, kind in
             [("tachyon", "dat"), ("tachyon-lit", "dat"), ("povray", "pov"), ("povray-lit", "pov")]}
    write_tachyon(scene, files["tachyon"])
    write_tachyon(scene, files["tachyon-lit"], lit=True)
    write_povray(scene, files["povray"])
    write_povray(scene, files["povray-lit"], POVRAY_SIDE)

    def out(name: str) -> str:
        return str(bench.out / f"{name}.png")

    def tachyon(name: str, *options: str) -> Case:
        return Case(name, ["tachyon", str(files[name]), *options, "-format", "PNG", "-o", out(name)])

    def povray(name: str, quality: int) -> Case:
        return Case(name, ["povray", str(files[name]), f"+W{SIDE}", f"+H{SIDE}", f"+WT{os.cpu_count()}", "-D", "-GA", "-A",
                           f"+Q{quality}", "+BM2", "+FN", "File_Gamma=1", f"+O{out(name)}"])

    embree = [bench.program("embree_peer"), str(scene)]
    return {
        "sphereview": (bench.render("sphereview", scene, "--backend", "cpu"),
                       bench.render("sphereview-lit", scene, "--backend", "cpu", "--shade", "studio", "--lights", str(LIGHTS))),
        "embree": (Case("embree", [*embree, out("embree")]), Case("embree-lit", [*embree, out("embree-lit"), str(LIGHTS)])),
        # Ambient occlusion: each of its rays goes to the upper side.
        "tachyon": (tachyon("tachyon", "-lowshade"),
                    tachyon("tachyon-lit", "-fullshade", "-auto_skylight", "1", "-skylight_samples", str(RAYS))),
        # Quality 5: shadows of area lights.
        "povray": (povray("povray", 0), povray("povray-lit", 5)),
    }


def light_peers(bench: Bench, counts: list[int]) -> tuple[list[Row], dict]:
    """What light costs, at equal numbers of shadow rays: whole runs with light less those without, in seconds of CPU time, because
    that is what other work on the machine disturbs least. Of Embree the very same directions."""
    limits = {"embree": 1.0, "tachyon": 1 / 3, "povray": 1.0}
    rows, data = [], {"lights": LIGHTS, "counts": counts, "versions": versions(), "sets": {name: {} for name in SETS}}
    for scene_set in SETS:
        for count in counts:
            scene = bench.scene(scene_set, count)
            cases = lit_cases(bench, scene)
            results = measure(bench, [case for pair in cases.values() for case in pair])
            light = {}
            for name, (flat, lit) in cases.items():
                if "wall_s" in results[flat.name] and "wall_s" in results[lit.name]:
                    light[name] = {key: results[lit.name][key] - results[flat.name][key] for key in ["wall_s", "cpu_s"]}
                data["sets"][scene_set].setdefault(name, []).append(
                    {"spheres": count, "flat": results[flat.name], "lit": results[lit.name], "light": light.get(name)})
            rows.append(Row(f"light of {scene_set}, {count:,}", ", ".join(
                f"{name} {light[name]['cpu_s']:.2f} s" if name in light else f"{name} {shown(results[lit.name])}"
                for name, (_, lit) in cases.items())))
            for name, limit in limits.items():
                if "sphereview" in light and name in light:
                    rows.append(at_most(f"  sphereview / {name}", light["sphereview"]["cpu_s"] / light[name]["cpu_s"], limit))
                elif "sphereview" in light and "more_than_s" in results[cases[name][1].name]:
                    rows.append(at_most(f"  sphereview / {name}, at most", light["sphereview"]["cpu_s"] / LIMIT_S, limit))
                else:
                    rows.append(Row(f"  sphereview / {name}", "not known", f"at most {limit:.3g}", False))
            for path in [scene, *bench.out.glob("*.dat"), *bench.out.glob("*.pov")]:
                path.unlink()
    return rows, data


def peers(bench: Bench, counts: list[int]) -> tuple[list[Row], dict]:
    """Both backends against Embree, Tachyon and POV-Ray, with more and more spheres."""
    rows, data = [], {"counts": counts, "limit_s": LIMIT_S, "versions": versions(), "sets": {name: {} for name in SETS}}
    for scene_set in SETS:
        for count in counts:
            scene = bench.scene(scene_set, count)
            results = measure(bench, cases_for(bench, scene))
            rows.append(Row(f"{scene_set}, {count:,}", ", ".join(f"{name} {shown(result)}" for name, result in results.items())))
            rows += check_pictures(bench, scene, results)
            rows += [
                against(results, "cpu", ["embree"], 0.7),
                against(results, "egl", ["embree"], 1.0 if count >= 10_000 else 1.5),
                against(results, "cpu", list(SLOW_PEERS), 1.0),
                against(results, "egl", list(SLOW_PEERS), 1.0),
            ]
            if count == MILLION and "wall_s" in results["cpu"]:
                rows.append(at_most("  cpu, peak memory", results["cpu"]["peak_bytes"] / 1e6, 250, " MB"))
            for name, result in results.items():
                data["sets"][scene_set].setdefault(name, []).append({"spheres": count, **result})
            for path in [scene, bench.out / "tachyon.dat", bench.out / "povray.pov"]:
                path.unlink()  # a million spheres are some hundred megabytes
    return rows, data
