"""python3 dask_frames.py TRAJECTORY PARTS [SCHEDULER]: renders a trajectory's frames on the workers of a Dask cluster.

Without the address of a scheduler the workers are this machine's. Each worker runs part.sh in this folder, which all of them see.
A part whose worker dies is given to another; the frames that it had written are kept. A part that fails stops no other; the exit
status is the highest of all.
"""

import pathlib
import subprocess
import sys

from dask.distributed import Client, as_completed


def render(folder, trajectory, part, parts):
    done = subprocess.run(["sh", "./part.sh", trajectory, str(part), str(parts)], cwd=folder)
    # Ended by a signal, as a shell has it.
    return part, done.returncode if done.returncode >= 0 else 128 - done.returncode


if __name__ == "__main__":
    trajectory, parts = sys.argv[1], int(sys.argv[2])
    folder = str(pathlib.Path(__file__).parent.resolve())
    worst = 0
    with Client(*sys.argv[3:4], **({} if sys.argv[3:] else {"threads_per_worker": 1})) as client:
        jobs = client.map(lambda part: render(folder, trajectory, part, parts), range(1, parts + 1), retries=2, pure=False)
        for job in as_completed(jobs):
            if job.status != "finished":  # its workers died
                print("a part is lost:", job.exception(), file=sys.stderr, flush=True)
                worst = max(worst, 3)
                continue
            part, status = job.result()
            worst = max(worst, status)
            print("part", part, "of", parts, "is done" if status == 0 else f"failed with status {status}", flush=True)
    sys.exit(worst)
