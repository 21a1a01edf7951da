"""Starts the program that is in this package."""

import os
import subprocess
import sys
from pathlib import Path


def main() -> int:
    """Becomes the program, with this process's arguments. On Windows, which has no exec, waits for it and returns its exit status."""
    program = Path(__file__).parent / "bin" / ("sphereview.exe" if os.name == "nt" else "sphereview")
    if os.name != "nt":
        os.execv(program, ["sphereview", *sys.argv[1:]])
    with subprocess.Popen([program, *sys.argv[1:]]) as process:
        while True:
            try:
                return process.wait()
            except KeyboardInterrupt:
                continue  # Ctrl+C reaches the program as well, which ends
