"""Running programs and measuring them: what the sections of run.py share."""
import json
import os
import platform
import signal
import statistics
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MILLION = 1_000_000
NOTHING_COULD_RENDER = 3  # sphereview's exit status where a backend is missing


@dataclass
class Case:
    name: str
    command: list[str]
    environment: dict[str, str] = field(default_factory=dict)


@dataclass
class Row:
    what: str
    measured: str
    target: str = ""
    met: bool | None = None


class CannotRun(Exception):
    def __init__(self, what: str, status: int, why: str = ""):
        super().__init__(f"{what}: exit status {status}{why and ': '}{why}")
        self.status = status


class Bench:
    def __init__(self, build: Path, runs: int):
        self.build = build.resolve()
        self.runs = runs
        self.out = self.build / "bench-out"
        self.out.mkdir(exist_ok=True)

    def program(self, name: str) -> str:
        return str(self.build / name)

    def render(self, name: str, scene: Path, *options: str, **environment: str) -> Case:
        """Without waiting for the disk, for which no other program waits."""
        picture = self.out / f"{name}.png"
        return Case(name, [self.program("sphereview"), "render", str(scene), "-o", str(picture), "--no-sync", *options], environment)

    def run(self, case: Case, limit_s: float | None = None) -> dict:
        """One run: wall_s, cpu_s (user + system), peak_bytes, and what it printed on standard output."""
        result = self.out / "measure.json"
        # A session of its own: what `measure` started must end with it.
        with subprocess.Popen([self.program("measure"), str(result), *case.command], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, env={**os.environ, **case.environment},
                              start_new_session=True) as process:
            try:
                stdout, stderr = process.communicate(timeout=limit_s)
            except BaseException:
                os.killpg(process.pid, signal.SIGKILL)
                raise
        if process.returncode != 0:
            raise CannotRun(case.name, process.returncode, stderr.strip())
        return {**json.loads(result.read_text()), "stdout": stdout}

    def scene(self, scene_set: str, count: int) -> Path:
        """A scene of one of the two seeded sets, `volume` or `half`."""
        path = self.out / f"{scene_set}-{count}.txt"
        with path.open("wb") as file:
            subprocess.run([self.program("make_scene"), scene_set, str(count)], stdout=file, check=True)
        return path

    def interleaved(self, cases: list[Case], most_runs: int | None = None) -> dict[str, list[dict]]:
        """All runs of all cases, in turns, after one run each that warms the caches up (Mesa's of shaders too)."""
        runs = min(self.runs, most_runs or self.runs)
        for case in cases:
            self.run(case)
        samples: dict[str, list[dict]] = {case.name: [] for case in cases}
        for number in range(runs):
            progress(f"{', '.join(samples)}: run {number + 1} of {runs}")
            for case in cases:
                samples[case.name].append(self.run(case))
        progress("")
        return samples


def progress(text: str) -> None:
    """On one line of a terminal; elsewhere a line for each, so that a log shows what goes on."""
    if sys.stderr.isatty():
        print("\r\033[K" + text, end="", file=sys.stderr, flush=True)
    elif text:
        print(text, file=sys.stderr, flush=True)


def median(samples: list[dict], key: str) -> float:
    return statistics.median(sample[key] for sample in samples)


def at_most(what: str, measured: float, limit: float, unit: str = "") -> Row:
    return Row(what, f"{measured:.3g}{unit}", f"at most {limit:g}{unit}", measured <= limit)


def phases(samples: list[dict]) -> dict[str, float]:
    """Median milliseconds of each phase that `render --json` reports."""
    reports = [json.loads(sample["stdout"])["timings_ms"] for sample in samples]
    return {phase: statistics.median(report[phase] for report in reports) for phase in reports[0]}


def first_line(command: list[str]) -> str:
    try:
        return subprocess.run(command, capture_output=True, text=True, cwd=ROOT).stdout.partition("\n")[0]
    except OSError:
        return ""


def machine() -> dict:
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return {"cpu": models[0] if models else platform.processor(), "cores": os.cpu_count(), "load": os.getloadavg(),
            "system": platform.platform()}
