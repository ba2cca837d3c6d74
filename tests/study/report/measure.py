"""measure.py: how the report measures: CPU time, points in processes of their own, rows of one table.

Time is that of the process (all its threads), which other work on the machine lengthens little; the process is pinned
to one core for each thread that it is told to use. A cheap run is repeated, and the median, the least and the number of
repeats are kept. Counts stand beside the seconds, and do not depend on the machine.
"""
import csv
import json
import os
import pathlib
import platform
import statistics
import subprocess
import sys
import time

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "bindings" / "python"))

# one row a point; "error" says which it is: time, mesh, model, energy, or rest (distance from the shape at rest)
FIELDS = ["scene", "error", "quantity", "variant", "integrator", "precision", "bending", "contact", "threads",
          "spacing_mm", "nodes", "step_s", "step_of_bound", "simulated_s", "steps", "node_evaluations",
          "spring_evaluations", "contact_queries", "cpu_s", "cpu_least_s", "repeats", "cpu_s_per_s", "wall_s",
          "error_mm", "error_rms_mm", "motion_mm", "motion_median_mm", "value", "exact", "floor_mm", "status", "note"]
EVALUATIONS = {"rk4": 4, "verlet": 1, "euler": 1}  # of the forces, a step


def row(**values):
    """One row of the table; unknown names are refused."""
    unknown = set(values) - set(FIELDS)
    if unknown:
        raise KeyError(f"no column {sorted(unknown)}")
    return {"status": "ok", **values}


def write_csv(path, rows):
    def cell(value):
        return f"{value:.6g}" if isinstance(value, float) else "" if value is None else value

    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows({name: cell(value) for name, value in line.items()} for line in rows)


# ---- processes ----

def apart(module, function, threads=1, **arguments):
    """Rows of module.function(**arguments), run in a process of its own on `threads` cores."""
    cores = sorted(os.sched_getaffinity(0))[-threads:]  # the first core has the most other work
    work = json.dumps([module, function, arguments])
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run([sys.executable, str(HERE / "measure.py"), work], stdout=subprocess.PIPE, check=False,
                          env=environment, preexec_fn=lambda: os.sched_setaffinity(0, cores))
    if done.returncode != 0:
        raise RuntimeError(f"{module}.{function}({arguments}) ended with {done.returncode}")
    return json.loads(done.stdout)


def _serve(work):
    module, function, arguments = json.loads(work)
    rows = getattr(__import__(module), function)(**arguments)
    json.dump(rows, sys.stdout, default=float)


# ---- time ----

def seconds_of(run, enough=0.3, most=11):
    """{cpu_s, cpu_least_s, repeats, wall_s} of run(); repeated until `enough` CPU seconds are spent."""
    taken, walls = [], []
    while not taken or (sum(taken) < enough and len(taken) < most):
        start, wall = time.process_time(), time.perf_counter()
        run()
        taken.append(time.process_time() - start)
        walls.append(time.perf_counter() - wall)
    return {"cpu_s": statistics.median(taken), "cpu_least_s": min(taken), "repeats": len(taken),
            "wall_s": statistics.median(walls)}


def calibration():
    """CPU seconds of a fixed loop: how much the machine's own speed swings during the report."""
    def loop():
        values = np.arange(1.0, 20001.0)
        for _ in range(400):
            values = np.sqrt(values * values + 1.0)

    return seconds_of(loop, enough=0.2)["cpu_least_s"]


# ---- runs of a drape ----

def steps_in(interval, bound, share):
    """(least number of equal steps of an interval that are at most share x bound, their length)."""
    count = max(1, int(np.ceil(interval / (share * bound) - 1e-9)))
    return count, interval / count


def path_of(drape, state, steps, h, samples):
    """Positions (samples x nodes x 3) at `samples` equal times, `steps` steps of h between them."""
    drape.set_state(*state)
    path = np.empty((samples, len(drape), 3))
    for i in range(samples):
        drape.step(steps, h)
        path[i] = drape.positions
    return path


def distance(path, reference):
    """{error_mm, error_rms_mm}: greatest and root mean square distance of nodes over all times."""
    apart_by = np.linalg.norm(np.asarray(path) - reference, axis=-1)
    return {"error_mm": 1e3 * float(apart_by.max()), "error_rms_mm": 1e3 * float(np.sqrt(np.mean(apart_by ** 2)))}


def motion(reference, start):
    """{motion_mm, motion_median_mm}: how far the farthest node went from its start on the reference path, and the
    median node: what an error is measured by."""
    went = np.linalg.norm(np.asarray(reference) - np.asarray(start).reshape(-1, 3), axis=-1).max(0)
    return {"motion_mm": 1e3 * float(went.max()), "motion_median_mm": 1e3 * float(np.median(went))}


def counts(drape, before, integrator):
    """Counts of a run from the drape's reports before and after."""
    after = drape.report
    steps = after["steps"] - before["steps"]
    return {"steps": steps, "node_evaluations": steps * EVALUATIONS[integrator] * len(drape),
            "spring_evaluations": after["spring_evaluations"] - before["spring_evaluations"],
            "contact_queries": after["contact_queries"] - before["contact_queries"]}


def point(drape, integrator, state, h, steps, samples, reference, enough=0.1):
    """One point: the path against the reference, and then the same steps timed in one call."""
    found = {**distance(path_of(drape, state, steps, h, samples), reference), **motion(reference, state[0])}
    drape.set_state(*state)
    before = drape.report
    drape.step(steps * samples, h)
    found.update(counts(drape, before, integrator))

    def again():
        drape.step(steps * samples, h)

    drape.set_state(*state)
    found.update(seconds_of(again, enough=enough))
    span = steps * samples * h
    return {**found, "simulated_s": span, "cpu_s_per_s": found["cpu_s"] / span}


# ---- machine ----

def _first(pattern_lines, key):
    for line in pattern_lines:
        if line.lower().startswith(key):
            return line.split(":", 1)[1].strip()
    return "unknown"


def _says(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True, cwd=ROOT).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def machine():
    """What the seconds belong to: processor, cores, system, compiler, flags, commit."""
    try:
        cpu = _first(pathlib.Path("/proc/cpuinfo").read_text().splitlines(), "model name")
    except OSError:
        cpu = platform.processor() or "unknown"
    caches = [line.split(":", 1)[0].replace(" cache", "") + " " + line.split(":", 1)[1].strip()
              for line in _says("lscpu").splitlines() if "cache:" in line]
    dirty = " with changes" if _says("git", "status", "--porcelain", "-uno") else ""
    return {"processor": cpu, "cores": os.cpu_count(), "caches": ", ".join(caches) or "unknown",
            "system": f"{platform.system()} {platform.machine()}",
            "compiler": _says(os.environ.get("CC", "cc"), "--version").split("\n")[0],
            "flags": os.environ.get("REPORT_FLAGS", "those of the Makefile"),
            "commit": _says("git", "rev-parse", "--short=12", "HEAD") + dirty,
            "python": f"Python {platform.python_version()}, numpy {np.__version__}"}


if __name__ == "__main__":
    sys.path.insert(0, str(HERE))
    _serve(sys.argv[1])
