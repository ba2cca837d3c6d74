#!/usr/bin/env python3
"""run.py: dress every GarmentCode specification on the body that it was made for, and write a table.

Each specification of the corpus runs in a process of its own with a time limit, so that a crash or a hang is a row and
not the end. Written: OUT/table.csv (a row each), OUT/summary.txt, and a report a garment. A garment is "good" when it
is settled, every seam is closed to 1 mm and nothing is deeper than 2 mm in the body.

Exit 1 when a run crashed, hung, wrote a number that is not finite, or a panel count differs from facts.csv; a garment
that does not drape, and says why, is no fault of the run.
"""
import argparse
import collections
import concurrent.futures
import csv
import json
import math
import pathlib
import subprocess
import sys
import time

COLUMNS = ["file", "type", "sleeves", "status", "reason", "good", "panels", "nodes", "seams", "seams_closed",
           "max_seam_gap_mm", "max_penetration_mm", "max_strain", "steps", "wall_s", "state_hash", "fault"]
GAP_MM, DEPTH_MM = 1.0, 2.0


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


def dress(job, options, panels):
    spec, tape, row = job
    report_path = options.out / "reports" / row["file"]
    report_path.unlink(missing_ok=True)
    result = dict.fromkeys(COLUMNS, "")
    result.update(file=row["file"], type=row["type"], sleeves="no" if "sleeveless" in row["styles"] else "")
    start = time.monotonic()
    try:
        spacing = ["--spacing", str(options.spacing)] if options.spacing else []
        done = subprocess.run([options.command, "dress", "--pattern", spec, "--tape", tape, "--quiet", *spacing,
                               "--report", report_path], capture_output=True, text=True, timeout=options.limit)
        code, said = done.returncode, done.stderr.strip().splitlines()
    except subprocess.TimeoutExpired:
        code, said = None, []
    result["wall_s"] = f"{time.monotonic() - start:.1f}"
    report = {}
    if code is None:
        result["fault"] = f"no end after {options.limit} s"
    elif code < 0 or code > 2:
        result["fault"] = f"crashed ({code})"
    elif report_path.exists():
        report = json.loads(report_path.read_text())
        if not_finite(report):
            result["fault"] = "a number is not finite"
    else:
        report = {"status": "bad input", "reason": said[-1] if said else ""}
        if not said:
            result["fault"] = "failed without a sentence"
    result.update({key: report[key] for key in COLUMNS if key in report})
    if report.get("panels", panels.get(row["file"])) != panels.get(row["file"]):
        result["fault"] = f"{report['panels']} panels, facts.csv has {panels.get(row['file'])}"
    result["good"] = int(report.get("status") == "settled" and report["seams_closed"] == report["seams"]
                         and report["max_seam_gap_mm"] <= GAP_MM and report["max_penetration_mm"] <= DEPTH_MM)
    return result


def summary(rows):
    lines = []
    kinds = {"skirts": lambda row: row["type"] == "skirt", "trousers": lambda row: row["type"] == "pants",
             "sleeveless tops": lambda row: row["type"] == "upper_garment" and row["sleeves"] == "no",
             "all": lambda row: True}
    for name, belongs in kinds.items():
        part = [row for row in rows if belongs(row)]
        counts = collections.Counter(row["status"] or "none" for row in part)
        lines.append(f"{name}: {sum(row['good'] for row in part)} good of {len(part)}; "
                     + ", ".join(f"{status} {n}" for status, n in counts.most_common()))
    faults = [f"{row['file']}: {row['fault']}" for row in rows if row["fault"]]
    return lines + [f"{len(faults)} faults", *faults]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", required=True)
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--limit", type=float, default=900, help="seconds a garment may take")
    parser.add_argument("--spacing", type=float, help="of the lattice [mm], default that of the command")
    parser.add_argument("--every", type=int, default=1, help="take each n-th specification only")
    options = parser.parse_args()
    if not (options.data / "garmentcode" / "index.json").exists():
        print(f"skipped: no {options.data / 'garmentcode'} (set MUSLIN_DATA)")
        return 0

    (options.out / "reports").mkdir(parents=True, exist_ok=True)
    with open(options.data / "garmentcode" / "facts.csv", newline="") as file:
        panels = {row["file"]: int(row["panels"]) for row in csv.DictReader(file)}
    jobs = list(corpus(options.data))[::options.every]
    rows = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row in pool.map(lambda job: dress(job, options, panels), jobs):
            rows.append(row)
            print(f"{len(rows):4}/{len(jobs)} {row['file'][:44]:44} {row['wall_s']:>6} s  {row['status']} "
                  f"{row['reason']}{' FAULT ' + row['fault'] if row['fault'] else ''}", flush=True)
    with open(options.out / "table.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
    text = "\n".join(summary(rows))
    (options.out / "summary.txt").write_text(text + "\n")
    print(text)
    return 1 if any(row["fault"] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
