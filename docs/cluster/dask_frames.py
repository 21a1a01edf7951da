"""python3 dask_frames.py TRAJECTORY PARTS [SCHEDULER]: renders a trajectory's frames on the workers of a Dask cluster.

Without the address of a scheduler the workers are this machine's. Each worker runs part.sh in this folder, which all of them see.
A part whose worker dies is given to another; the frames that it had written are kept.
"""

import pathlib
import subprocess
import sys

from dask.distributed import Client, as_completed


def render(folder, trajectory, part, parts):
    subprocess.run(["sh", "./part.sh", trajectory, str(part), str(parts)], cwd=folder, check=True)
    return part


if __name__ == "__main__":
    trajectory, parts = sys.argv[1], int(sys.argv[2])
    folder = str(pathlib.Path(__file__).parent.resolve())
    with Client(*sys.argv[3:4], **({} if sys.argv[3:] else {"threads_per_worker": 1})) as client:
        jobs = client.map(lambda part: render(folder, trajectory, part, parts), range(1, parts + 1), retries=2, pure=False)
        for done in as_completed(jobs):
            print("part", done.result(), "of", parts, "is done", flush=True)
