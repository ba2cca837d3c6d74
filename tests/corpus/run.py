#!/usr/bin/env python3
"""run.py: dress every GarmentCode specification on the body that it was made for, and write a table.

Each specification of the corpus runs in a process of its own with a time limit, so that a crash or a hang is a row and
not the end. Written: OUT/table.csv (a row each), OUT/summary.txt, and a report a garment.

A garment is "good" when it is settled, every seam is closed to 1 mm, nothing is deeper than 1 mm in the body, and, with
--self-contact, no cloth crosses cloth. One is "invalid" when the checks of the library refuse its pattern before
anything is sewn; invalid ones are named with the reason, and "good" is told as a share of the valid ones. CPU seconds
are those that the system counts for the process of a garment, all of it: reading, body, cutting, sewing, settling.

Exit 1 when a run crashed, hung, wrote a number that is not finite, a panel count differs from facts.csv, or a second
run (--again) gave another state; a garment that does not drape, and says why, is no fault of the run.
"""
import argparse
import collections
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time

COLUMNS = ["file", "type", "sleeves", "status", "reason", "good", "valid", "panels", "nodes", "seams", "seams_closed",
           "max_seam_gap_mm", "max_penetration_mm", "max_strain", "crossings", "steps", "cpu_s", "wall_s", "state_hash",
           "fault"]
GAP_MM, DEPTH_MM = 1.0, 1.0
# what the checks of a pattern say before anything is sewn
REFUSED = {"twisted seam", "panel crosses itself", "bad input"}
# what two runs must have in common
SAME = ["status", "reason", "state_hash", "steps", "crossings"]


def corpus(data):
    """(specification, tape, row of the index) of all; the two originals go with mean_all."""
    folder = data / "garmentcode"
    rows = json.loads((folder / "index.json").read_text())
    for row in rows:
        yield folder / "specs" / row["file"], folder / "bodies" / f"{row['body']}.yaml", row
    for path in sorted((folder / "originals").glob("*.json")):
        yield path, folder / "bodies" / "mean_all.yaml", {"file": path.name, "type": "original", "styles": []}


def not_finite(value):
    if isinstance(value, dict):
        return any(map(not_finite, value.values()))
    return isinstance(value, float) and not math.isfinite(value)


def run(command, limit):
    """(exit code, None when stopped after `limit` seconds; lines on standard error; CPU seconds; wall seconds)."""
    with tempfile.TemporaryFile("w+") as said:
        start = time.monotonic()
        child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=said)
        stopped = threading.Event()

        # Popen.kill() would wait for the child itself, and the CPU seconds would be lost
        def stop():
            stopped.set()
            os.kill(child.pid, signal.SIGKILL)
        timer = threading.Timer(limit, stop)
        timer.start()
        _, status, used = os.wait4(child.pid, 0)
        timer.cancel()
        child.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        return (None if stopped.is_set() else child.returncode, said.read().strip().splitlines(),
                used.ru_utime + used.ru_stime, time.monotonic() - start)


def dress_once(job, options, report_path, place):
    """(report, fault, CPU seconds, wall seconds) of one run."""
    spec, tape, _ = job
    report_path.unlink(missing_ok=True)
    asked = ["--spacing", str(options.spacing)] if options.spacing else []
    asked += ["--self-contact"] if options.self_contact else []
    asked += ["--place", place] if place else []
    code, said, cpu, wall = run([options.command, "dress", "--pattern", spec, "--tape", tape, "--quiet", *asked,
                                 "--report", report_path], options.limit)
    report, fault = {}, ""
    if code is None:
        fault = f"no end after {options.limit:g} s"
    elif code < 0 or code > 2:
        fault = f"crashed ({code})"
    elif report_path.exists():
        report = json.loads(report_path.read_text())
        if not_finite(report):
            fault = "a number is not finite"
    else:
        report = {"status": "bad input", "reason": said[-1] if said else ""}
        if not said:
            fault = "failed without a sentence"
    return report, fault, cpu, wall


def is_good(report, self_contact):
    return int(report.get("status") == "settled" and report["seams_closed"] == report["seams"]
               and report["max_seam_gap_mm"] <= GAP_MM and report["max_penetration_mm"] <= DEPTH_MM
               and (not self_contact or report.get("crossings") == 0))


def dress(job, options, panels, place=None):
    _, _, row = job
    result = dict.fromkeys(COLUMNS, "")
    result.update(file=row["file"], type=row["type"], sleeves="no" if "sleeveless" in row["styles"] else "")
    report, fault, cpu, wall = dress_once(job, options, options.out / "reports" / row["file"], place)
    if options.again and not fault:
        again, fault, cpu_again, _ = dress_once(job, options, options.out / "again" / row["file"], place)
        cpu = min(cpu, cpu_again)
        other = [f"{key} {report.get(key)} and {again.get(key)}" for key in SAME if report.get(key) != again.get(key)]
        if other and not fault:
            fault = "a second run is not the same: " + ", ".join(other)
    result.update({key: report[key] for key in COLUMNS if key in report})
    result.update(cpu_s=f"{cpu:.2f}", wall_s=f"{wall:.1f}", fault=fault)
    if report.get("panels", panels.get(row["file"])) != panels.get(row["file"]):
        result["fault"] = f"{report['panels']} panels, facts.csv has {panels.get(row['file'])}"
    result["valid"] = int(report.get("status") not in REFUSED)
    result["good"] = is_good(report, options.self_contact)
    return result


def dress_found(job, options, panels):
    """The row of a garment whose start is found, with what became of it from the start of its file."""
    given = dress(job, options, panels, "file")
    return {**dress(job, options, panels, "found"), "file_status": given["status"], "file_good": given["good"]}


def share(rows):
    good, valid = sum(row["good"] for row in rows), sum(row["valid"] for row in rows)
    return f"{good} good of {valid} valid of {len(rows)}" + (f" ({100 * good / valid:.1f} %)" if valid else "")


def seconds(rows):
    """Median and 95th percentile of the CPU seconds of those that were dressed."""
    cpu = sorted(float(row["cpu_s"]) for row in rows if row["valid"])
    if not cpu:
        return "none"
    return (f"median {statistics.median(cpu):.1f}, p95 {cpu[math.ceil(0.95 * len(cpu)) - 1]:.1f}, most {cpu[-1]:.1f}, "
            f"all {sum(cpu):.0f}")


def lack(row, self_contact):
    """Why a valid garment is not good, in a few words."""
    if row["status"] != "settled":
        return row["reason"] if row["reason"].startswith(row["status"]) else f"{row['status']}: {row['reason']}"
    words = [f"{row['seams_closed']} of {row['seams']} seams closed"] * (row["seams_closed"] != row["seams"])
    words += [f"gap {row['max_seam_gap_mm']:.2f} mm"] * (row["max_seam_gap_mm"] > GAP_MM)
    words += [f"depth {row['max_penetration_mm']:.2f} mm"] * (row["max_penetration_mm"] > DEPTH_MM)
    words += [f"{row['crossings']} crossings"] * (self_contact and row["crossings"] != 0)
    return ", ".join(words)


def summary(rows, options):
    lines = []
    kinds = {"skirts": lambda row: row["type"] == "skirt", "trousers": lambda row: row["type"] == "pants",
             "jumpsuits": lambda row: row["type"] == "jumpsuit", "dresses": lambda row: row["type"] == "dress",
             "tops": lambda row: row["type"] == "upper_garment",
             "sleeveless tops": lambda row: row["type"] == "upper_garment" and row["sleeves"] == "no",
             "all": lambda row: True}
    for name, belongs in kinds.items():
        part = [row for row in rows if belongs(row)]
        counts = collections.Counter(row["status"] or "none" for row in part)
        lines.append(f"{name}: {share(part)}; " + ", ".join(f"{status} {n}" for status, n in counts.most_common()))
    given = [row for row in rows if row.get("file_good")]
    if given:
        both = sum(row["good"] for row in given)
        lines.append(f"starts found: {both} good of the {len(given)} that the start of the file makes good "
                     f"({100 * both / len(given):.1f} %)")
    lines.append(f"CPU seconds: {seconds(rows)}")
    lines += [f"invalid: {row['file']}: {row['status']}: {row['reason']}" for row in rows if not row["valid"]]
    lines += [f"not good: {row['file']}: {lack(row, options.self_contact)}" for row in rows
              if row["valid"] and not row["good"] and row["status"]]
    if options.again:
        lines.append(f"{sum('second run' not in row['fault'] for row in rows)} of {len(rows)} the same on a second run")
    faults = [f"{row['file']}: {row['fault']}" for row in rows if row["fault"]]
    return lines + [f"{len(faults)} faults", *faults]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", required=True)
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--limit", type=float, default=900, help="seconds that a run of a garment may take")
    parser.add_argument("--spacing", type=float, help="of the lattice [mm], default that of the command")
    parser.add_argument("--self-contact", action="store_true", help="cloth does not go through cloth")
    parser.add_argument("--again", action="store_true", help="run each twice: the state must be the same")
    parser.add_argument("--place", choices=["file", "found"], default="file",
                        help="found: starts are found; each garment is dressed from the start of its file too")
    parser.add_argument("--every", type=int, default=1, help="take each n-th specification only")
    parser.add_argument("--only", help="those whose file name contains this, of the ones taken")
    options = parser.parse_args()
    if not (options.data / "garmentcode" / "index.json").exists():
        print(f"skipped: no {options.data / 'garmentcode'} (set MUSLIN_DATA)")
        return 0

    for folder in ("reports", "again") if options.again else ("reports",):
        (options.out / folder).mkdir(parents=True, exist_ok=True)
    with open(options.data / "garmentcode" / "facts.csv", newline="") as file:
        panels = {row["file"]: int(row["panels"]) for row in csv.DictReader(file)}
    jobs = [job for job in list(corpus(options.data))[::options.every] if (options.only or "") in job[2]["file"]]
    rows = []
    one, more = (dress_found, ["file_status", "file_good"]) if options.place == "found" else (dress, [])
    # the table grows a row at a time: what is there stays there when the run is stopped
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool, \
            open(options.out / "table.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS + more)
        writer.writeheader()
        for row in pool.map(lambda job: one(job, options, panels), jobs):
            rows.append(row)
            writer.writerow(row)
            file.flush()
            print(f"{len(rows):4}/{len(jobs)} {row['file'][:44]:44} {row['cpu_s']:>6} s  {row['status']} "
                  f"{row['reason']}{' FAULT ' + row['fault'] if row['fault'] else ''}", flush=True)
    text = "\n".join(summary(rows, options))
    (options.out / "summary.txt").write_text(text + "\n")
    print(text)
    return 1 if any(row["fault"] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
