#!/usr/bin/env python3
"""wear.py: every named design on bodies of its groups, and 100 of them on ten people each; how many come to rest.

A design is dressed on women's 40, men's 50 and child 116 as its groups allow; each eighth or so, 100 in all, on ten people
of ANSUR II too (children's designs on ten sizes). The garments are a list for `muslin dress --batch`, so that a run that
was stopped goes on where it was. Written into OUT: list, results.jsonl, times.jsonl. Exit 1 when fewer than 98 in 100
settle with every seam closed.

--unusual: instead 60 designs, evenly over the list, on twelve people made up (far from the table of sizes: short and
heavy, tall and thin, waist above hip, wedge, pear, children, 2.25 m), whatever groups they are drafted for. Told too:
how many are worn, patterns that the library refuses to draft, and the share of seconds in starts thrown away.
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
UNUSUAL_DESIGNS = 60

# (name, sex, stature, bust, waist, hip [cm]); the rest of a tape is derived
UNUSUAL = [("short-heavy-woman", "female", 150, 150, 150, 160), ("short-heavy-man", "male", 155, 150, 165, 155),
           ("tall-thin-woman", "female", 188, 76, 58, 82), ("tall-thin-man", "male", 200, 86, 70, 86),
           ("waist-above-hip-woman", "female", 165, 120, 130, 112), ("waist-above-hip-man", "male", 175, 118, 132, 110),
           ("wedge-woman", "female", 172, 105, 72, 88), ("wedge-man", "male", 180, 125, 80, 95),
           ("pear", "female", 165, 84, 72, 125), ("toddler", "child", 98, 54, 52, 56),
           ("stout-child", "child", 140, 85, 85, 90), ("giant", "male", 225, 115, 100, 115)]


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


def unusual(designs, out):
    """The lines: 60 designs, each on the twelve people made up."""
    for name, sex, *measures in UNUSUAL:
        text = "".join(f"{key} {value} cm\n" for key, value in zip(("stature", "bust", "waist", "hip"), measures))
        (out / f"{name}.tape").write_text(f"name {name}\nsex {sex}\n{text}")
    for i in range(UNUSUAL_DESIGNS):
        design = designs[i * len(designs) // UNUSUAL_DESIGNS]["name"]
        for name, *_ in UNUSUAL:
            yield ["--name", f"{design}-{name}", "--design", design, "--tape", str(out / f"{name}.tape")]


def tell_unusual(results, times):
    """What only `--unusual` tells; returns the results that are settled and worn."""
    drafted = [result for result in results if "panels" in result]
    worn = [result for result in drafted if result["status"] == "settled" and (
        result.get("worn") or "cloth goes through the body" in result.get("worn_why", ""))]
    whole = sum(bool(result.get("worn")) for result in worn)
    away = cpu = 0.0
    for one in times:  # seconds are wall time: the share of them that was thrown away, of the CPU time
        seconds = dict(one.get("seconds", {}))
        thrown = seconds.pop("thrown_away", 0)
        cpu += one["cpu_s"]
        away += one["cpu_s"] * thrown / sum(seconds.values()) if thrown else 0
    print(f"{len(drafted)} of {len(results)} drafted; {len(worn)} settled and worn, {whole} of them with cloth at most "
          f"1 mm in the body; {away:.0f} of {cpu:.0f} CPU seconds in starts thrown away")
    return worn


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
    parser.add_argument("--unusual", action="store_true", help="60 designs on twelve people made up, in self-contact")
    parser.add_argument("--png", action="store_true", help="draw each, from the front and from behind")
    options = parser.parse_args()
    options.self_contact |= options.unusual
    options.out.mkdir(parents=True, exist_ok=True)
    said = subprocess.run([options.command, "designs", "--json"], stdout=subprocess.PIPE, check=True)
    designs, table = json.loads(said.stdout), options.data / "anthropometry" / "ansur2_garment_cm.csv"
    lines = list(unusual(designs, options.out) if options.unusual else listed(designs, table, options.out))
    (options.out / "list").write_text("".join(shlex.join(line) + "\n" for line in lines[::options.every]))
    done = subprocess.run([options.command, "dress", "--batch", options.out / "list", "-o", options.out, "--quiet",
                           "--spacing", f"{options.spacing:g}", "--limit", f"{options.limit:g}", "--jobs",
                           str(options.jobs), *(["--self-contact"] if options.self_contact else []),
                           *(["--png", "--view", "20,5,1.2", "--view", "200,5,1.2", "--pixels", "640x480"]
                             if options.png else [])])
    if done.returncode not in (0, 1):
        return done.returncode
    results, times = ([json.loads(line) for line in (options.out / name).read_text().splitlines()]
                      for name in ("results.jsonl", "times.jsonl"))
    good = [result for result in results
            if result["status"] == "settled" and result["seams_closed"] == result["seams"]]
    for result in results:
        if result not in good:
            print(f"{result['name']}: {result['status']}: {result.get('reason', '')}")
    if options.unusual:
        good = tell_unusual(results, times)
    counts = collections.Counter(result["status"] for result in results)
    print(f"{len(good)} of {len(results)} {'worn' if options.unusual else 'at rest, every seam closed'}; "
          + ", ".join(f"{status} {n}" for status, n in counts.most_common()))
    return 0 if len(good) >= ENOUGH * len(results) else 1


if __name__ == "__main__":
    sys.exit(main())
