#!/usr/bin/env python3
"""twenty.py: 20 garments dressed by the command and by the Python package, with self-contact and retries: equal hashes.

The garments are named designs and, where MUSLIN_DATA has them, GarmentCode specifications; two designs need a second
start. Printed: a row a garment with its end, starts and hash. Exit 1 when a hash or an end differs.

    MUSLIN_BIN=build/bin MUSLIN_LIB=build/lib PYTHONPATH=bindings/python python3 tests/study/twenty.py [--spacing 25]
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys

import muslin

DESIGNS = ["tshirt", "skirt", "sleeveless", "tank", "tee_v", "oxford_shirt", "sheath", "jeans", "hoodie_zip", "kurta",
           "blouse_peter_pan_short", "gown_halter_gathered", "cape_hood_mini", "jumpsuit_v_flare"]
SPECIFICATIONS = 6


def specifications(data):
    """Every 20th GarmentCode specification: (pattern, tape)."""
    folder = data / "garmentcode"
    if not (folder / "index.json").exists():
        return []
    rows = json.loads((folder / "index.json").read_text())[::20][:SPECIFICATIONS]
    return [(folder / "specs" / row["file"], folder / "bodies" / f"{row['body']}.yaml") for row in rows]


def by_command(options, spacing):
    program = pathlib.Path(os.environ.get("MUSLIN_BIN", "build/bin"), "muslin")
    done = subprocess.run([program, "dress", *options, "--self-contact", "--spacing", str(spacing), "--json"],
                          capture_output=True, text=True)
    return json.loads(done.stdout)


def by_package(garment, tape, spacing):
    return muslin.dress(garment, tape, spacing=0.001 * spacing, self_contact=1, strict=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spacing", type=float, default=25.0, help="of the lattice [mm]")
    spacing = parser.parse_args().spacing
    data = pathlib.Path(os.environ.get("MUSLIN_DATA", "../shared/data"))
    garments = [(name, ["--design", name, "--size", "W40"], name, None) for name in DESIGNS]
    garments += [(pattern.stem.removesuffix("_specification"), ["--pattern", pattern, "--tape", tape], pattern, tape)
                 for pattern, tape in specifications(data)]
    bad = 0
    for name, options, garment, tape_file in garments:
        told = by_command(options, spacing)
        tape = muslin.Tape.size("W40") if tape_file is None else muslin.Tape.read(tape_file)
        dressed = by_package(garment if tape_file is None else muslin.Pattern.read(garment), tape, spacing)
        got = (dressed.reason["name"], dressed.drape.state_hash if dressed.drape is not None else None)
        equal = got == (told["status"], told.get("state_hash"))
        bad += not equal
        starts = ", ".join(f"{start['kind']}: {start['end']}" for start in dressed.starts)
        print(f"{name:34} {got[1]} {'equal' if equal else 'DIFFERS'}  {starts}", flush=True)
    print(f"{len(garments)} garments, {bad} differ")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
