#!/usr/bin/env python3
"""page.py: 24 GarmentCode garments of every kind, dressed and drawn as pages of pictures to be looked at one by one.

The garments are a list for `muslin dress --batch`, so that a page that was stopped goes on where it was. Written into
OUT: list, results.jsonl, NAME.png of each garment from the front and from behind, and page1.png and page2.png with the
name, the kind and what became of it under each picture. Needs matplotlib, as `make report` does.
"""
import argparse
import json
import pathlib
import shlex
import subprocess
import sys
import textwrap

# (kind, specification, body): sleeves, collars, hoods, cuffs, tiers, godets, legs; women, men, both
GARMENTS = [
    ("shirt", "shirt_mean", "mean_all"),
    ("pencil dress", "dress_pencil", "mean_all"),
    ("top, sleeves to the elbow", "d11_046_mean_female", "mean_female"),
    ("one-sided top, flared cuff", "d11_043_mean_female", "mean_female"),
    ("one-sided dress, cuffs", "d11_005_mean_female", "mean_female"),
    ("one-sided dress, sleeves", "d11_011_m_smpl_average_A40", "m_smpl_average_A40"),
    ("long dress, short sleeves", "d11_038_mean_female", "mean_female"),
    ("dress, short sleeves, cuffs", "d11_049_mean_all", "mean_all"),
    ("hooded short dress", "d11_006_mean_all", "mean_all"),
    ("hooded dress, godets", "d11_035_m_smpl_average_A40", "m_smpl_average_A40"),
    ("hooded long dress, godets", "d11_042_mean_female", "mean_female"),
    ("one-sided dress, godets", "d11_022_mean_female", "mean_female"),
    ("top, collar, band", "d11_003_mean_female", "mean_female"),
    ("top, collar", "d11_041_m_smpl_average_A40", "m_smpl_average_A40"),
    ("long dress, tiers, collar", "d11_028_mean_all", "mean_all"),
    ("tunic, tiers", "d11_027_mean_female", "mean_female"),
    ("short skirt, 14 gores", "d11_044_mean_female", "mean_female"),
    ("skirt, godets", "d11_018_mean_all", "mean_all"),
    ("long skirt, godets", "d11_036_mean_female", "mean_female"),
    ("short skirt, band", "d11_002_m_smpl_average_A40", "m_smpl_average_A40"),
    ("trousers, cuffs", "d11_010_mean_all", "mean_all"),
    ("trousers, flounces", "d11_013_mean_female", "mean_female"),
    ("jumpsuit, flounces", "d11_040_m_smpl_average_A40", "m_smpl_average_A40"),
    ("jumpsuit, short legs", "d11_004_mean_female", "mean_female"),
]
COLUMNS, ROWS = 4, 3


def listed(data):
    """The lines of the list."""
    for _, name, body in GARMENTS:
        folder = "specs" if name.startswith("d11_") else "originals"
        yield " ".join(map(shlex.quote, [
            "--name", name, "--pattern", str(data / "garmentcode" / folder / f"{name}_specification.json"),
            "--tape", str(data / "garmentcode" / "bodies" / f"{body}.yaml")]))


def words(kind, result):
    """Three lines under a picture."""
    became = result["status"]
    if became == "settled":
        became += (f", gap {result['max_seam_gap_mm']:.1f} mm, depth {result['max_penetration_mm']:.1f} mm, "
                   f"{result.get('crossings', '-')} crossings")
    elif result["reason"].startswith(became):
        became = result["reason"]
    else:
        became += f": {result['reason']}"
    return f"{result['name']}: {kind}\n" + "\n".join(textwrap.wrap(became, 64)[:3])


def draw(results, out):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    each = COLUMNS * ROWS
    for page in range(0, len(results), each):
        figure, places = plt.subplots(ROWS, COLUMNS, figsize=(3.2 * COLUMNS, 2.95 * ROWS), dpi=200)
        for place in places.flat:
            place.axis("off")
        for place, (kind, *_), result in zip(places.flat, GARMENTS[page:page + each], results[page:page + each]):
            picture = out / f"{result['name']}.png"
            if picture.exists() and ("state_hash" in result or result["status"] == "out of time"):
                place.imshow(plt.imread(picture))
            colour = "black" if result["status"] == "settled" else "firebrick"
            place.text(0, -0.02, words(kind, result), transform=place.transAxes, va="top", fontsize=5.5, color=colour)
        figure.subplots_adjust(left=0.01, right=0.99, top=0.995, bottom=0.05, wspace=0.03, hspace=0.17)
        path = out / f"page{page // each + 1}.png"
        figure.savefig(path)
        print(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", required=True)
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--spacing", type=float, default=15, help="of the lattice [mm]")
    parser.add_argument("--limit", type=float, default=900, help="CPU seconds that a garment may take")
    parser.add_argument("--loose", action="store_true", help="cloth may go through cloth")
    options = parser.parse_args()
    if not (options.data / "garmentcode" / "index.json").exists():
        print(f"skipped: no {options.data / 'garmentcode'} (set MUSLIN_DATA)")
        return 0
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "list").write_text("\n".join(listed(options.data)) + "\n")
    done = subprocess.run([options.command, "dress", "--batch", options.out / "list", "-o", options.out, "--png",
                           "--spacing", f"{options.spacing:g}", "--limit", f"{options.limit:g}", "--jobs",
                           str(options.jobs), "--view", "20,5,1.2", "--view", "200,5,1.2", "--pixels", "640x480",
                           *([] if options.loose else ["--self-contact"])])
    if done.returncode not in (0, 1):
        return done.returncode
    results = [json.loads(line) for line in (options.out / "results.jsonl").read_text().splitlines()]
    draw(results, options.out)
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
