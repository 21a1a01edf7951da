"""The same pictures by other programs: whole processes, scene file in, PNG out, 1000 x 1000.

Embree through embree_peer.cpp, the fastest known way on a CPU; Tachyon and POV-Ray as Debian has them. Each picture is compared
with sphereview's, so that nobody is timed for drawing something else.
"""
import json
import shutil
import statistics
import subprocess
from pathlib import Path

COUNTS = [4, 1_000, 10_000, 100_000, 1_000_000]
SETS = ["volume", "half"]
SLOW_LIMIT_S = 120
DIFFERENT_LIMIT = 50_000  # of a million pixels: the others round, and Tachyon aims elsewhere in a pixel
PEAK_LIMIT_MB = 250
CPU_LIMIT = 0.7  # of Embree's time, everywhere


def egl_limit(count: int) -> float:
    return 1.0 if count >= 10_000 else 1.5


def spheres(scene: Path):
    """(r, g, b, x, y, z, radius) of each sphere of a text scene, as words."""
    words = scene.read_text().split()
    for i in range(1, len(words), 7):
        yield words[i:i + 7]


def write_tachyon(scene: Path, out: Path) -> None:
    """Flat colours: ambient light alone. Tachyon cuts colours off, so they point to the middle of their steps."""
    with out.open("w") as file:
        file.write("BEGIN_SCENE\nRESOLUTION 1000 1000\nCAMERA\nZOOM 1.0\nASPECTRATIO 1.0\nANTIALIASING 0\nRAYDEPTH 1\n"
                   "CENTER 0 0 0\nVIEWDIR 0 0 1\nUPDIR 0 1 0\nEND_CAMERA\nBACKGROUND 0 0 0\n")
        for *color, x, y, z, radius in spheres(scene):
            r, g, b = ((int(c) + 0.5) / 255 for c in color)
            file.write(f"SPHERE CENTER {x} {y} {z} RAD {radius} TEXTURE AMBIENT 1 DIFFUSE 0 SPECULAR 0 OPACITY 1 "
                       f"COLOR {r:.5f} {g:.5f} {b:.5f} TEXFUNC 0\n")
        file.write("END_SCENE\n")


def write_povray(scene: Path, out: Path) -> None:
    with out.open("w") as file:
        file.write("#version 3.7;\nglobal_settings { assumed_gamma 1 ambient_light 1 }\ncamera { location 0 direction z right x up y }\n"
                   "background { rgb 0 }\n#default { finish { ambient 1 diffuse 0 } }\n")
        for r, g, b, x, y, z, radius in spheres(scene):
            file.write(f"sphere {{ <{x},{y},{z}>,{radius} pigment {{ rgb <{r}/255,{g}/255,{b}/255> }} }}\n")


def peer_cases(bench, case_type, scene: Path) -> list:
    """The peers that are installed, each with its scene file written."""
    name = scene.stem
    cases = []
    if Path(bench.program("embree_peer")).exists():
        cases.append(case_type("Embree", [bench.program("embree_peer"), str(scene), str(bench.out / f"{name}-Embree.png")]))
    if shutil.which("tachyon"):
        data = bench.out / f"{name}.dat"
        write_tachyon(scene, data)
        cases.append(case_type("Tachyon", ["tachyon", str(data), "-o", str(bench.out / f"{name}-Tachyon.png"), "-format", "PNG"]))
    if shutil.which("povray"):
        data = bench.out / f"{name}.pov"
        write_povray(scene, data)
        cases.append(case_type("POV-Ray", ["povray", f"+I{data}", f"+O{bench.out / f'{name}-POV-Ray.png'}", "+W1000", "+H1000", "-D", "-A",
                                           "-GA", "-V", "File_Gamma=1"]))
    return cases


def different_pixels(bench, scene: Path, picture: Path) -> int:
    done = subprocess.run([bench.program("sphereview"), "render", str(scene), "--backend", "cpu", "--json", "--expect", str(picture)],
                          capture_output=True, text=True)
    return json.loads(done.stdout)["comparison"]["different_pixels"]


def measure_scene(bench, case_type, scene: Path, runs: int) -> tuple[dict, dict]:
    """Samples of wall time and peak memory by program; and how many pixels of each peer's picture differ."""
    ours = [bench.render("cpu", scene, "--backend", "cpu"), bench.render("egl", scene, "--backend", "egl", LIBGL_ALWAYS_SOFTWARE="1")]
    peers = peer_cases(bench, case_type, scene)
    fast = ours + [case for case in peers if case.name == "Embree"]
    samples = bench.interleaved(fast, runs)
    differing = {}
    for case in peers:
        if case not in fast:
            try:
                samples[case.name] = [bench.run(case, SLOW_LIMIT_S)]
            except Exception as error:
                if getattr(error, "status", None) != 124:
                    raise
                samples[case.name] = [{"wall_s": SLOW_LIMIT_S, "more_than": True, "cpu_s": 0, "peak_bytes": 0}]
                continue
        differing[case.name] = different_pixels(bench, scene, bench.out / f"{scene.stem}-{case.name}.png")
    return samples, differing


def section(bench, case_type, row_type, counts: list[int]) -> tuple[list, dict]:
    rows, data = [], {"sets": {}}
    for scene_set in SETS:
        data["sets"][scene_set] = []
        for count in counts:
            scene = bench.out / f"{scene_set}-{count}.txt"
            with scene.open("wb") as file:
                subprocess.run([bench.program("make_scene"), scene_set, str(count)], stdout=file, check=True)
            samples, differing = measure_scene(bench, case_type, scene, bench.runs)
            median = {name: statistics.median(s["wall_s"] for s in all_of) for name, all_of in samples.items()}
            peak = statistics.median(s["peak_bytes"] for s in samples["cpu"]) / 1e6
            data["sets"][scene_set].append({"count": count, "median_s": median, "different_pixels": differing, "cpu_peak_mb": peak,
                                            "more_than": [n for n, s in samples.items() if s[0].get("more_than")]})
            what = f"{scene_set}, {count:,} spheres"
            rows.append(row_type(what, ", ".join(f"{name} {seconds * 1e3:.0f} ms" for name, seconds in median.items())))
            for name, pixels in differing.items():
                if pixels > DIFFERENT_LIMIT:
                    rows.append(row_type(f"  {name}'s picture", f"{pixels:,} pixels differ", f"at most {DIFFERENT_LIMIT:,}", False))
            for name, limit in [("cpu", CPU_LIMIT), ("egl", egl_limit(count))]:
                if "Embree" in median:
                    ratio = median[name] / median["Embree"]
                    rows.append(row_type(f"  {name} / Embree", f"{ratio:.2f}", f"at most {limit:g}", ratio <= limit))
                for slow in ["Tachyon", "POV-Ray"]:
                    if slow in median and median[name] >= median[slow]:
                        rows.append(row_type(f"  {name} / {slow}", f"{median[name] / median[slow]:.2f}", "below 1", False))
            if count == 1_000_000:
                rows.append(row_type("  peak memory, cpu", f"{peak:.0f} MB", f"at most {PEAK_LIMIT_MB} MB", peak <= PEAK_LIMIT_MB))
    return rows, data
