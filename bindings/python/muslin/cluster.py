"""cluster.py: the garments of a list on many machines, by Dask and the command `muslin dress --batch`.

    python -m muslin.cluster LIST -o FOLDER [--scheduler ADDRESS | --workers N] [options of dress]

The list is cut into parts; a task dresses one by `muslin dress --batch LIST --part I/N -o FOLDER/tasks/I`. Dask gives a
task that a dead worker had to another one, and the command goes on after the last garment that was finished; so does
a second run. FOLDER/results.jsonl has the bytes of `muslin dress --batch LIST -o FOLDER`. All machines see LIST and
FOLDER at the same path. Needs pip install muslin[cluster] and the command `muslin` (or MUSLIN_COMMAND).
"""
from __future__ import annotations

import argparse
import json
import math
import os
import pathlib
import subprocess
import time
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ._types import PathLike

WAIT = 120.0  # [s] for the command of a dead worker, which may still be at work on the same part


def dress_part(garments: str, folder: str, part: int, of: int, options: Sequence[str]) -> int:
    """Dress one part (from 1) of a list in this process; returns its number."""
    command = [os.environ.get("MUSLIN_COMMAND", "muslin"), "dress", "--batch", garments, "--part", f"{part}/{of}",
               "-o", f"{folder}/tasks/{part}", "--quiet", *options]
    end = time.monotonic() + WAIT
    while True:
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode == 0:
            return part
        if "another batch is at work" not in done.stderr or time.monotonic() > end:
            raise RuntimeError(done.stderr.strip() or f"{command[0]} ended with {done.returncode}")
        time.sleep(0.2)


def merge(folder: PathLike, of: int) -> pathlib.Path:
    """Write FOLDER/results.jsonl from the results of all parts, in the order of the list; returns its path."""
    lines: list[tuple[int, bytes]] = []
    for part in range(1, of + 1):
        for line in pathlib.Path(folder, "tasks", str(part), "results.jsonl").read_bytes().splitlines(True):
            lines.append((json.loads(line)["line"], line))
    made = pathlib.Path(folder, "results.jsonl")
    beside = made.with_suffix(".new")
    beside.write_bytes(b"".join(line for _, line in sorted(lines)))
    beside.rename(made)
    return made


def dress_list(garments: PathLike, folder: PathLike, scheduler: str | None = None, workers: int = 2,
               per_task: int = 8, options: Sequence[str] = (), client: Any = None) -> pathlib.Path:
    """Dress all garments of a list; returns the path of the results.

    scheduler: address of a Dask scheduler; without one, and without a client, `workers` processes are started here.
    per_task: garments that a task has. options: of `muslin dress`, for all lines.
    """
    import dask
    import distributed

    garments, folder = pathlib.Path(garments).resolve(), pathlib.Path(folder).resolve()
    lines = [line for line in garments.read_text().splitlines() if line.split("#")[0].strip()]
    of = max(1, math.ceil(len(lines) / per_task))
    (folder / "tasks").mkdir(parents=True, exist_ok=True)
    own = None
    if client is None:
        # the death of a worker is no garment's fault
        dask.config.set({"distributed.scheduler.allowed-failures": 1000})
        here = {"n_workers": workers, "threads_per_worker": 1}
        own = client = distributed.Client(scheduler) if scheduler else distributed.Client(**here)
    try:
        tasks = client.map(lambda part: dress_part(str(garments), str(folder), part, of, list(options)),
                           range(1, of + 1), pure=False, retries=2)
        client.gather(tasks)
    finally:
        if own is not None:
            own.close()
    return merge(folder, of)


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m muslin.cluster", description="Dress a list on many machines.")
    parser.add_argument("list")
    parser.add_argument("-o", dest="folder", required=True)
    parser.add_argument("--scheduler", help="address of a Dask scheduler")
    parser.add_argument("--workers", type=int, default=2, help="processes here, without a scheduler")
    parser.add_argument("--per-task", type=int, default=8, help="garments of a task")
    given, options = parser.parse_known_args()
    print(dress_list(given.list, given.folder, given.scheduler, given.workers, given.per_task, options))


if __name__ == "__main__":
    main()
