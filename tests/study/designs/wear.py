#!/usr/bin/env python3
"""wear.py: every named design on bodies of its groups, and 100 of them on ten people each; how many come to rest.

A design is dressed on women's 40, men's 50 and child 116 as its groups allow; each eighth or so, 100 in all, on ten people
of ANSUR II too (children's designs on ten sizes). The garments are a list for `muslin dress --batch`, so that a run that
was stopped goes on where it was. Written into OUT: list, results.jsonl, times.jsonl. Exit 1 when fewer than 98 in 100
settle with every seam closed.
"""
import argparse
import collections
import csv
import json
import pathlib
import shlex
import subprocess
import sys

SIZE = {"women": "W40", "men": "M50", "children": "C116"}
CHILDREN = ["C74", "C80", "C92", "C98", "C104", "C122", "C134", "C146", "C158", "C164"]
MANY, PEOPLE, ENOUGH = 100, 10, 0.98


# (measure of a tape, column, what ANSUR II has too much of women and of men [cm]): its waist is at the navel
COLUMNS = [("stature", "stature", 0, 0), ("nape_height", "cervicale_h", 0, 0), ("inleg", "crotch_h", 0, 0),
           ("bust", "chest_circ", 0, 0), ("waist", "waist_circ", 7, 1), ("hip", "hip_circ", 0, 0),
           ("neck", "neck_base_circ", 0, 0), ("thigh", "thigh_circ", 0, 0), ("calf", "calf_circ", 0, 0),
           ("ankle", "ankle_circ", 0, 0), ("wrist", "wrist_circ", 0, 0)]


def people(path, out):
    """The tapes of ten women and ten men of the table, evenly by stature."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    chosen = {}
    for number, (group, sex, word) in enumerate((("women", "F", "female"), ("men", "M", "male"))):
        tall = sorted((row for row in rows if row["sex"] == sex), key=lambda row: float(row["stature"]))
        chosen[group] = []
        for i in range(PEOPLE):
            row = tall[(2 * i + 1) * len(tall) // (2 * PEOPLE)]
            tape = out / f"{row['id']}.tape"
            tape.write_text(f"name {row['id']}\nsex {word}\n" + "".join(
                f"{measure} {float(row[column]) - over[number]:.2f} cm\n" for measure, column, *over in COLUMNS))
            chosen[group].append(tape)
    return chosen


def listed(designs, table, out):
    """The lines: every design on its sizes, then 100 designs on people."""
    for design in designs:
        for group in design["groups"]:
            yield ["--design", design["name"], "--size", SIZE[group]]
    if not table.exists():
        print(f"skipped: the {PEOPLE} people, no {table} (set MUSLIN_DATA)")
        return
    chosen = people(table, out)
    for design in designs[::max(1, len(designs) // MANY)][:MANY]:
        groups = [group for group in ("women", "men") if group in design["groups"]]
        for i in range(PEOPLE):
            body = ["--tape", str(chosen[groups[i % len(groups)]][i])] if groups else ["--size", CHILDREN[i]]
            yield ["--design", design["name"], *body]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", required=True)
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--spacing", type=float, default=30, help="of the lattice [mm]")
    parser.add_argument("--limit", type=float, default=120, help="CPU seconds that a garment may take")
    parser.add_argument("--every", type=int, default=1, help="take each n-th garment only")
    parser.add_argument("--self-contact", action="store_true", help="cloth does not go through cloth")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    said = subprocess.run([options.command, "designs", "--json"], stdout=subprocess.PIPE, check=True)
    lines = list(listed(json.loads(said.stdout), options.data / "anthropometry" / "ansur2_garment_cm.csv",
                        options.out))
    (options.out / "list").write_text("".join(shlex.join(line) + "\n" for line in lines[::options.every]))
    done = subprocess.run([options.command, "dress", "--batch", options.out / "list", "-o", options.out, "--quiet",
                           "--spacing", f"{options.spacing:g}", "--limit", f"{options.limit:g}", "--jobs",
                           str(options.jobs), *(["--self-contact"] if options.self_contact else [])])
    if done.returncode not in (0, 1):
        return done.returncode
    results = [json.loads(line) for line in (options.out / "results.jsonl").read_text().splitlines()]
    good = [result for result in results
            if result["status"] == "settled" and result["seams_closed"] == result["seams"]]
    for result in results:
        if result not in good:
            print(f"{result['name']}: {result['status']}: {result.get('reason', '')}")
    counts = collections.Counter(result["status"] for result in results)
    print(f"{len(good)} of {len(results)} at rest, every seam closed; "
          + ", ".join(f"{status} {n}" for status, n in counts.most_common()))
    return 0 if len(good) >= ENOUGH * len(results) else 1


if __name__ == "__main__":
    sys.exit(main())
