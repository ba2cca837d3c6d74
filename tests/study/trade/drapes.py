#!/usr/bin/env python3
"""Ten of Valentina's DXF files, sewn and draped by the command: `make drapes`.

The files have outlines alone: no names, no seams, no word on which piece is a half on the fold and which is cut twice.
What a tailor sees in each drawing is in the table below, as options of muslin seams; the seams are found, none is given.
A waist that the drawing means for elastic gets it through the library. For each file: seams that were found and the
least confidence of them, how many are wrong by the table's own count, how the drape ended, its CPU seconds, a picture
from front and back in --out.

    python3 tests/study/trade/drapes.py --data DATA --lib LIB --command build/bin/muslin [--only NAME] [--out FOLDER]
"""
import argparse
import json
import os
import pathlib
import re
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "bindings" / "python"))

JACKET = {"splits": {"440_1640": "24:251", "500_1760": "24:272.6", "560_1880": "15:295.9"},
          "pieces": ["piece_1 leave", "piece_2 leave", "piece_3=back fold", "piece_4=front_left pair",
                     "piece_5=sleeve_left pair arm"],
          # the largest size has its pieces in another order
          "560_1880": ["piece_4 leave", "piece_5 leave", "piece_2=back fold", "piece_1=front_left pair",
                       "piece_3=sleeve_left pair arm"]}
TROUSERS = {"440_1640": ["det=leg_front_right pair", "det_2=leg_back_left pair"],
            "500_1760": ["det=leg_front_right pair", "det_2=leg_back_left pair"],
            "560_1880": ["det_2=leg_front_right pair", "det=leg_back_left pair"]}


def drawings():
    """name of the file: (options of muslin seams, body, seams that the garment has, edges with elastic by label)"""
    out = {"tshirt": (["--piece", "detail leave", "--piece", "detail_2 leave", "--piece", "detail_3=back fold",
                       "--piece", "detail_4=front fold", "--piece", "detail_5=sleeve_left pair arm",
                       "--split", "22:206.6"], "--size M46", 10, None),
           "keiko_skirt": (["--piece", "detail=skirt_front fold", "--piece", "detail_2=skirt_back fold"],
                           "--size W38", 2, None),
           "blusa": (["--piece", "detalle=front fold", "--piece", "piece_2=back fold", "--split", "4:250",
                      "--split", "6:250"], "--size C104", 4, None),
           "male_shirt": (["--piece", "frontpanel=front_left pair", "--piece", "backpanel=back fold",
                           "--piece", "yoke fold:4", "--piece", "shortsleeve=sleeve_left pair arm",
                           "--split", "27:257,331"]
                          + [x for name in ("collarbase", "pocketflapround", "plackettop", "collarbaseinterface",
                                            "pocketround", "pocket", "fullsleeve", "collar", "placketunder",
                                            "pocketflap", "cuffinterface", "collartop", "collartopinterface")
                             for x in ("--piece", f"{name} leave")], "--size M50", 16, None)}
    for size in ("440_1640", "500_1760", "560_1880"):
        tape = f"--tape {{data}}/valentina/measurements/gost_man_{size}.vit"
        pieces = JACKET.get(size, JACKET["pieces"])
        out[f"jacketM1_{size}"] = ([x for p in pieces for x in ("--piece", p)] + ["--split", JACKET["splits"][size]], tape,
                                   11, None)
        out[f"pantsM1_{size}"] = ([x for p in TROUSERS[size] for x in ("--piece", p)], tape, 6, "waist")
    return out


def run(words, limit=600):
    """(exit status, output, CPU seconds) of a command"""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, capture_output=True, text=True, timeout=limit)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.returncode, done.stdout + done.stderr, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def add_elastic(path):
    """elastic in the free edges that look up: a waist that the drawing leaves to it"""
    from muslin.pattern import Pattern
    pattern = Pattern.read(path)
    sewn = {e for s in range(pattern.seam_count) for e in (pattern.seam(s)["edge_a"], pattern.seam(s)["edge_b"])}
    for panel in range(len(pattern.panels)):
        free = [e for e, _ in pattern.outline(panel) if e not in sewn]
        top = max(free, key=lambda e: pattern.edge_polyline(e)[:, 1].mean())
        pattern.set_elastic(top, 0.75, 60.0)  # as the trousers of muslin with elastic: 60 N; 0.75: waist by hip
        pattern.set_label(top, "waist")
    pattern.write(path)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--data", required=True, type=pathlib.Path)
    parser.add_argument("--command", default=str(ROOT / "build/bin/muslin"))
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build/out/drapes")
    parser.add_argument("--only", default="")
    parser.add_argument("--spacing", default="15")
    args = parser.parse_args()
    folder = args.data / "valentina"
    if not folder.is_dir():
        print("drapes: skipped, no folder valentina in the data")
        return 0
    args.out.mkdir(parents=True, exist_ok=True)
    good = found_all = files = 0
    for name, (options, body, seams, elastic) in sorted(drawings().items()):
        if args.only not in name:
            continue
        files += 1
        pattern = args.out / f"{name}.json"
        status, text, _ = run([args.command, "seams", str(folder / f"{name}.astm.dxf"), "-o", str(pattern)] + options)
        if status != 0:
            print(f"{name}: {text.strip()}")
            continue
        sure = [float(x) for x in re.findall(r"^([01]\.\d\d)  ", text.split("second choices:")[0], re.M)]
        found = int(re.search(r"(\d+) seams sewn", text).group(1))
        if elastic:
            add_elastic(pattern)
        report = args.out / f"{name}.report.json"
        picture = args.out / f"{name}.png"
        status, text, cpu = run([args.command, "dress", "--pattern", str(pattern), "--place", "found", "--self-contact",
                                 "--spacing", args.spacing, "--png", str(picture), "--view", "20,5", "--view", "200,5",
                                 "--pixels", "500x700", "--quiet", "--report", str(report)]
                                + body.format(data=args.data).split())
        lines = [line for line in text.strip().splitlines() if "warning" not in line]
        print(f"{name}: {found} of {seams} seams, least confidence {min(sure, default=0.0):.2f}; "
              f"{lines[-1] if lines else 'no word'}; {cpu:.1f} CPU s")
        found_all += found == seams
        good += status == 0
    print(f"drapes: {files} files, {found_all} with the number of seams that the garment has, {good} settled")
    return 0 if good == files else 1


if __name__ == "__main__":
    sys.exit(main())
