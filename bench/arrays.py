"""Times sphereview.render() of arrays: arrays.py SCENE RUNS. Prints the median's milliseconds, after one run to warm up, as JSON."""
import json
import statistics
import sys
import time

import sphereview

scene = sphereview.read(sys.argv[1])
times = []
for _ in range(1 + int(sys.argv[2])):
    begin = time.perf_counter()
    sphereview.render(scene.centers, scene.radii, scene.colors, scene.camera, backend="cpu")
    times.append(1e3 * (time.perf_counter() - begin))
print(json.dumps({"render_ms": statistics.median(times[1:])}))
