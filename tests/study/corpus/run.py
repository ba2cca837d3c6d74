#!/usr/bin/env python3
"""run.py: dress every GarmentCode specification on the body that it was made for, and write a table.

All are dressed by `muslin dress --batch`: each in a process of its own with a limit of CPU seconds, so that a crash or
a hang is a row and not the end, and a run that was stopped goes on where it was. Written: OUT/results.jsonl and what
else the batch writes, OUT/table.csv (a row each), OUT/summary.txt.

A garment is "good" when it is settled, every seam is closed to 1 mm, nothing is deeper than 1 mm in the body, and, with
--self-contact, no cloth crosses cloth. One is "invalid" when the checks of the library refuse its pattern before
anything is sewn; invalid ones are named with the reason, and "good" is told as a share of the valid ones. CPU seconds
are those that the system counts for the process of a garment, all of it: reading, body, cutting, sewing, settling;
of two runs the fewer.

Exit 1 when a run crashed, hung, wrote a number that is not finite, a panel count differs from facts.csv, or a second
run (--again) gave another state; a garment that does not drape, and says why, is no fault of the run.
"""
import argparse
import collections
import csv
import json
import math
import pathlib
import shlex
import shutil
import statistics
import subprocess
import sys
import time

COLUMNS = ["file", "type", "sleeves", "status", "reason", "good", "valid", "panels", "nodes", "seams", "seams_closed",
           "max_seam_gap_mm", "max_penetration_mm", "max_strain", "crossings", "worn", "worn_why", "steps", "cpu_s",
           "thrown_s", "state_hash", "fault"]
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


def name_of(row):
    return row["file"].removesuffix("_specification.json")


def not_finite(value):
    if isinstance(value, dict):
        return any(map(not_finite, value.values()))
    return isinstance(value, float) and not math.isfinite(value)


def tell(folder, since, told):
    """A line for each garment that has been finished since then and is not told yet."""
    for part in sorted(folder.glob("parts/[!.]*")):
        if part.suffix == ".new" or part.name in told or part.stat().st_mtime < since:
            continue
        told.add(part.name)
        head, result = part.read_text().split("\n")[:2]
        report = json.loads(result)
        print(f"{len(told):4} {part.name:44} {float(head.split()[3]):6.1f} s  {report['status']} "
              f"{report.get('reason', '')}", flush=True)


def thrown(used):
    """CPU seconds of the starts that were not kept: the report has wall seconds, so their share of all of them."""
    seconds = dict(used.get("seconds", {}))
    away = seconds.pop("thrown_away", 0)
    return used["cpu_s"] * away / sum(seconds.values()) if away else 0


def dress_all(jobs, options, out, place):
    """{name: (report, CPU seconds)} of all garments, dressed by one batch in the folder `out`."""
    out.mkdir(parents=True, exist_ok=True)
    (out / "list").write_text("".join(
        shlex.join(["--name", name_of(row), "--pattern", str(spec), "--tape", str(tape)]) + "\n"
        for spec, tape, row in jobs))
    asked = ["--spacing", f"{options.spacing:g}"] if options.spacing else []
    asked += ["--self-contact"] if options.self_contact else []
    asked += ["--place", place] if place else []
    if options.png:
        asked += ["--png", "--view", "20,5,1.2", "--view", "200,5,1.2", "--pixels", "640x480"]
    told, since = set(), time.time()
    batch = subprocess.Popen([options.command, "dress", "--batch", out / "list", "-o", out, "--quiet",
                              "--limit", f"{options.limit:g}", "--jobs", str(options.jobs), *asked],
                             stdout=subprocess.DEVNULL)
    while batch.poll() is None:
        tell(out, since, told)
        time.sleep(0.5)
    if batch.returncode not in (0, 1):
        sys.exit(f"the batch ended with {batch.returncode}")
    tell(out, since, told)
    results, times = (list(map(json.loads, (out / name).read_text().splitlines()))
                      for name in ("results.jsonl", "times.jsonl"))
    for one, used in zip(results, times):
        one["thrown_s"] = thrown(used)
    return {one["name"]: (one, used["cpu_s"]) for one, used in zip(results, times)}


def fault_of(report):
    """What is a fault of the run, and not an end that a garment may have."""
    if report["status"] in ("crashed", "out of time"):
        return f"{report['status']}: {report['reason']}"
    if report["status"] == "bad input" and not report.get("reason"):
        return "failed without a sentence"
    return "a number is not finite" if not_finite(report) else ""


def is_good(report, self_contact):
    return int(report.get("status") == "settled" and report["seams_closed"] == report["seams"]
               and report["max_seam_gap_mm"] <= GAP_MM and report["max_penetration_mm"] <= DEPTH_MM
               and (not self_contact or report.get("crossings") == 0))


def row_of(job, first, second, options, panels):
    """A row of the table: of the first run, and what the second one (or None) has to say against it."""
    row = job[2]
    (report, cpu), (again, cpu_again) = first, second or first
    result = dict.fromkeys(COLUMNS, "")
    result.update(file=row["file"], type=row["type"], sleeves="no" if "sleeveless" in row["styles"] else "")
    result.update({key: report[key] for key in COLUMNS if key in report})
    result.update(cpu_s=f"{min(cpu, cpu_again):.2f}", fault=fault_of(report) or fault_of(again))
    other = [f"{key} {report.get(key)} and {again.get(key)}" for key in SAME if report.get(key) != again.get(key)]
    if other and not result["fault"]:
        result["fault"] = "a second run is not the same: " + ", ".join(other)
    if report.get("panels", panels.get(row["file"])) != panels.get(row["file"]):
        result["fault"] = f"{report['panels']} panels, facts.csv has {panels.get(row['file'])}"
    result["valid"] = int(report["status"] not in REFUSED)
    result["good"] = is_good(report, options.self_contact)
    return result


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
    away, worked = (sum(float(row[key] or 0) for row in rows) for key in ("thrown_s", "cpu_s"))
    lines.append(f"CPU seconds of starts that were thrown away: {away:.0f}" +
                 (f" ({100 * away / worked:.1f} % of all)" if worked else ""))
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
    parser.add_argument("--limit", type=float, default=900, help="CPU seconds that a garment may take")
    parser.add_argument("--spacing", type=float, help="of the lattice [mm], default that of the command")
    parser.add_argument("--self-contact", action="store_true", help="cloth does not go through cloth")
    parser.add_argument("--again", action="store_true", help="run each twice: the state must be the same")
    parser.add_argument("--place", choices=["file", "found"],
                        help="file: from the start of the file alone; found: starts are found, and each garment is dressed "
                        "from that of its file too; default: as `muslin dress`, of the file, then found")
    parser.add_argument("--every", type=int, default=1, help="take each n-th specification only")
    parser.add_argument("--png", action="store_true", help="draw each, from the front and from behind")
    parser.add_argument("--only", help="those whose file name contains this, of the ones taken")
    options = parser.parse_args()
    if not (options.data / "garmentcode" / "index.json").exists():
        print(f"skipped: no {options.data / 'garmentcode'} (set MUSLIN_DATA)")
        return 0

    with open(options.data / "garmentcode" / "facts.csv", newline="") as file:
        panels = {row["file"]: int(row["panels"]) for row in csv.DictReader(file)}
    jobs = [job for job in list(corpus(options.data))[::options.every] if (options.only or "") in job[2]["file"]]
    names = [name_of(job[2]) for job in jobs]
    first, second = dress_all(jobs, options, options.out, options.place), {}
    if options.again:
        # nothing of an earlier run
        shutil.rmtree(options.out / "again", ignore_errors=True)
        second = dress_all(jobs, options, options.out / "again", options.place)
    rows = [row_of(job, first[name], second.get(name), options, panels) for job, name in zip(jobs, names)]
    if options.place == "found":
        given = dress_all(jobs, options, options.out / "file", "file")
        for row, name in zip(rows, names):
            row.update(file_status=given[name][0]["status"], file_good=is_good(given[name][0], options.self_contact))
    with open(options.out / "table.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    text = "\n".join(summary(rows, options))
    (options.out / "summary.txt").write_text(text + "\n")
    print(text)
    return 1 if any(row["fault"] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
