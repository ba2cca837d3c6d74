#!/usr/bin/env python3
"""cluster.py [GARMENTS [DATASET]]: muslin.cluster with workers that are killed, GNU parallel, and muslin.dataset.

GARMENTS (500) by two workers of Dask, one of which is killed three times at random moments: as many results, and the
bytes of `muslin dress --batch`; the overhead of a garment, in seconds and in CPU seconds (start of Dask and garments
begun twice are in it). DATASET (2000) garments as a data set: seconds, bytes, and
what 100,000 would take. Runs itself in an environment with distributed, numpy and pyarrow in MUSLIN_OUT/hosts/cluster.
"""
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import venv

import hosts

HOME = hosts.OUT / "cluster"
OPTIONS = ["--spacing", "45"]
MUSLIN = hosts.BIN / "muslin"
SIZES = ["W36", "W40", "W44", "W48", "M48", "M54"]


def jobs(count):
    """(design, size) of as many garments, spread over all designs."""
    import muslin
    rows = muslin.designs()
    return [(rows[(7 * i) % len(rows)]["name"], SIZES[i % len(SIZES)]) for i in range(count)]


def claim(holds, told):
    """Say what was asked for; for results: that the bytes are those of `muslin dress --batch`."""
    print(f"{'ok  ' if holds else 'FAIL'} {told}", flush=True)
    return holds


def clocks():
    """Seconds, and CPU seconds of this process and of those that it has waited for."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return time.time(), sum(one.ru_utime + one.ru_stime for one in used)


def kill(client, times, pause):
    """Kill a worker of the cluster at random moments."""
    draw = random.Random(1)
    for _ in range(times):
        time.sleep(draw.uniform(0.5, 1.5) * pause)
        while not (pids := list(client.run(os.getpid).values())):
            time.sleep(0.1)  # those killed before are not back yet
        victim = draw.choice(pids)
        print(f"     worker {pids.index(victim) + 1} of {len(pids)} is killed", flush=True)
        os.kill(victim, 9)


def by_dask(garments, folder, batch, count):
    """The list by Dask; batch: seconds and CPU seconds that `--batch` took."""
    import dask
    import distributed
    from muslin.cluster import dress_list
    dask.config.set({"distributed.scheduler.allowed-failures": 1000})
    start = clocks()
    with distributed.Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
        killer = threading.Thread(target=kill, args=(client, 3, batch[0] / 5), daemon=True)
        killer.start()
        made = dress_list(garments, folder / "dask", options=OPTIONS, client=client)
        killer.join()
    spent = [now - then for now, then in zip(clocks(), start)]
    more = [1000 * (own - plain) / count for own, plain in zip(spent, batch)]
    same = made.read_bytes() == (folder / "batch/results.jsonl").read_bytes()
    lines = len(made.read_text().splitlines())
    told = f"{lines} results, {spent[0]:.1f} s, {spent[1]:.1f} CPU s; " \
           f"a garment {more[0]:.0f} ms, {more[1]:.0f} CPU ms more"
    return claim(same, f"Dask, workers killed three times: {told}")


def by_parallel(garments, folder):
    if shutil.which("parallel") is None:
        print("skipped: GNU parallel is not installed")
        return True
    path = {**os.environ, "PATH": f"{hosts.BIN}:{os.environ['PATH']}"}
    short = folder / "short"
    short.write_text("".join(f"{line} {' '.join(OPTIONS)}\n" for line in garments.read_text().splitlines()[:20]))
    subprocess.run([MUSLIN, "dress", "--batch", short, "-o", folder / "one"], check=True, capture_output=True)
    subprocess.run(["sh", hosts.BINDINGS / "python/examples/cluster/parallel.sh", short, folder / "parallel", "3"],
                   check=True, capture_output=True, env=path)
    same = (folder / "one/results.jsonl").read_bytes() == (folder / "parallel/results.jsonl").read_bytes()
    return claim(same, "GNU parallel, 20 garments in 3 parts")


def as_dataset(folder, count):
    import pyarrow.parquet
    from muslin.dataset import dataset
    start = clocks()
    paths = dataset(folder / "set", jobs(count), jobs=2, spacing=0.045, picture=(64, 96))
    spent, cpu = (now - then for now, then in zip(clocks(), start))
    size = sum(file.stat().st_size for file in (folder / "set").iterdir())
    rows = [row for path in paths for row in pyarrow.parquet.read_table(path, columns=["status"]).to_pylist()]
    ended = {status: sum(row["status"] == status for row in rows) for status in sorted({row["status"] for row in rows})}
    again = time.time()
    dataset(folder / "set", jobs(count), jobs=2, spacing=0.045, picture=(64, 96))
    told = f"{spent:.1f} s, {cpu:.1f} CPU s, {size / 1e6:.1f} MB, {ended}; again {time.time() - again:.1f} s; " \
           f"100,000 would take {spent / count * 1e5 / 3600:.1f} h, {cpu / count * 1e5 / 3600:.1f} CPU h and " \
           f"{size / count * 1e5 / 1e9:.1f} GB"
    return claim(len(rows) == count, f"data set of {len(rows)} garments, {len(paths)} shards: {told}")


def main(count=500, rows=2000):
    sys.path.insert(0, str(hosts.BINDINGS / "python"))
    os.environ.update(MUSLIN_COMMAND=str(MUSLIN), PYTHONPATH=str(hosts.BINDINGS / "python"), MUSLIN_LIB=str(hosts.LIB))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        garments = folder / "list"
        garments.write_text("".join(f"--design {design} --size {size}\n" for design, size in jobs(count)))
        start = clocks()
        subprocess.run([MUSLIN, "dress", "--batch", garments, "-o", folder / "batch", "--jobs", "2", *OPTIONS],
                       check=True)
        batch = [now - then for now, then in zip(clocks(), start)]
        print(f"     {count} garments by --batch --jobs 2: {batch[0]:.1f} s, {batch[1]:.1f} CPU s", flush=True)
        held = [by_dask(garments, folder, batch, count), by_parallel(garments, folder), as_dataset(folder, rows)]
    return not all(held)


if __name__ == "__main__":
    python = HOME / "bin/python"
    if pathlib.Path(sys.prefix) != HOME:
        if not python.exists():
            venv.create(HOME, with_pip=True)
            hosts.fetch.install(python, "-m", "pip", "install", "-q", "distributed", "numpy", "pyarrow", made=HOME)
        os.execv(python, [str(python), __file__, *sys.argv[1:]])
    sys.exit(main(*map(int, sys.argv[1:])))
