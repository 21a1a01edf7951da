#!/usr/bin/python3
"""Draws docs/peers.svg from docs/peers.json, which `./dev bench --peers --publish` writes."""
import json
import sys
from pathlib import Path

import matplotlib
matplotlib.use("svg")
import matplotlib.pyplot as plt

STYLES = {"cpu": ("sphereview, CPU", "#c1272d", "o-"), "egl": ("sphereview, llvmpipe", "#e08214", "s-"),
          "Embree": ("Embree (trace, float)", "#0571b0", "^--"), "Tachyon": ("Tachyon", "#7b3294", "v:"),
          "POV-Ray": ("POV-Ray", "#4d9221", "d:")}


def main() -> None:
    source = Path(sys.argv[1])
    results = json.loads(source.read_text())
    plt.rcParams["svg.hashsalt"] = "sphereview"  # the same file for the same data
    sets = results["data"]["peers"]["sets"]
    figure, panels = plt.subplots(1, len(sets), figsize=(10, 4.2), sharey=True)
    for panel, (name, points) in zip(panels, sets.items()):
        for key, (label, color, line) in STYLES.items():
            drawn = [(p["count"], p["median_s"][key]) for p in points if key in p["median_s"] and key not in p["more_than"]]
            if drawn:
                panel.loglog(*zip(*drawn), line, color=color, label=label, markersize=5)
        panel.set_title(f"`{name}`")
        panel.set_xlabel("spheres")
        panel.grid(True, which="major", alpha=0.3)
    panels[0].set_ylabel("seconds, scene file to PNG")
    panels[0].legend(fontsize=8)
    figure.suptitle("1000 x 1000, whole process", fontsize=11)
    machine = results["machine"]
    figure.text(0.5, 0.005, f"{machine['cpu']}, {machine['cores']} cores, {results['date'][:10]}, ./dev bench --peers; medians of "
                f"{results['runs']}, slow programs once", ha="center", fontsize=7)
    figure.tight_layout(rect=(0, 0.03, 1, 1))
    figure.savefig(source.with_suffix(".svg"), metadata={"Date": None})


if __name__ == "__main__":
    main()
