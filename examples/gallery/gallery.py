#!/usr/bin/env python3
"""gallery.py: the strip of pictures on the first page of README.md, made by `make gallery`.

    gallery.py --bin build/bin --out FOLDER [--strip PNG]

Five pictures of one garment: the body with the tape round it, the pattern, the sewn garment, its fit map, a page of
paper. FOLDER gets the pictures and what they are made of, PNG the strip (default: FOLDER/strip.png). Needs the Python
package of bindings/python, numpy, matplotlib, and pdftoppm of poppler.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
import numpy as np  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings" / "python"))
import muslin  # noqa: E402

os.environ["LC_ALL"] = "C.UTF-8"  # paper in English, whatever the machine speaks
TAPE = ROOT / "examples" / "tapes" / "w40.tape"
GARMENT = ["--design", "tshirt", "--tape", str(TAPE)]
CLOTH = ["--colour", "#a8433a"]
VIEW, WIDTH, HEIGHT = "25,4,1.32,0.88", 520, 960  # of the three pictures with a body: yaw, pitch, zoom; pixels
# the girths drawn round the body: measure, limb, contour
PAGE = 19  # of the PDF
GIRTHS = [("bust", "torso", "bust"), ("waist", "torso", "waist"), ("hip", "torso", "hip")]
PIECES = ["#f0d5ca", "#dbe5cf", "#cfdeea", "#efe2bb", "#e2d5ea", "#cfe6e2"]


def run(*command):
    subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL)


def band(points, width=0.011, off=0.003):
    """A tape round a closed line of points, as the lines of an OBJ: `width` high, `off` the skin [m]."""
    away = points - points.mean(0)
    away[:, 1] = 0.0
    points = points + off * away / np.linalg.norm(away, axis=1)[:, None]
    n = len(points)
    lines = [f"v {x:.5f} {y + side * width / 2:.5f} {z:.5f}" for x, y, z in points for side in (-1, 1)]
    for k in range(n):
        a, b, c, d = (2 * i % (2 * n) + 1 for i in (k, k + 0.5, k + 1, k + 1.5))
        lines.append(f"f {int(a)} {int(c)} {int(d)} {int(b)}")
    return "\n".join(lines) + "\n"


def body_picture(programs, out):
    """The body with a tape round bust, waist and hip; the girths that were made of them."""
    body = muslin.Body(muslin.Tape.read(str(TAPE)))
    run(programs / "muslin", "body", "--tape", TAPE, "--obj", out / "body.obj")
    draw = [programs / "muslin-render", "--body", out / "body.obj", "--colour", "#d8b23a"]
    for measure, limb, contour in GIRTHS:
        path = out / f"{measure}.obj"
        path.write_text(band(np.array(body.contour(limb, contour))))
        draw += ["--garment", path]
    run(*draw, "--view", VIEW, "--size", f"{WIDTH}x{HEIGHT}", "-o", out / "body.png")
    return [f"{measure} {100 * body.made[measure]:.0f}" for measure, _, _ in GIRTHS]


def pieces(pattern):
    """The outline (n x 2) of each panel, at its own place."""
    found = []
    for panel in range(len(pattern.panels)):
        found.append(np.vstack([np.array(pattern.edge_polyline(edge))[::direction]
                                for edge, direction in pattern.rim(panel)]))
    return [outline - outline.min(0) for outline in found]


def shelves(outlines, width, gap=0.04):
    """Pieces side by side in rows not wider than `width` [m], tall ones first: their corners, and the height."""
    corners, x, y, row = {}, 0.0, 0.0, 0.0
    for k in sorted(range(len(outlines)), key=lambda k: -outlines[k][:, 1].max()):
        wide, high = outlines[k].max(0)
        if x > 0.0 and x + wide > width:
            x, y, row = 0.0, y + row + gap, 0.0
        corners[k] = (x, y)
        x, row = x + wide + gap, max(row, high)
    return corners, y + row


def pattern_picture(axes):
    """All pieces, in the rows that fill the picture best."""
    tape = muslin.Tape.read(str(TAPE))
    outlines = pieces(muslin.draft(GARMENT[1], tape))
    aspect = HEIGHT / WIDTH
    widths = np.linspace(0.6, 4.0, 200)
    width = min(widths, key=lambda w: max(w * aspect, shelves(outlines, w)[1]))
    corners, height = shelves(outlines, width)
    for k, outline in enumerate(outlines):
        x, y = corners[k]
        top = height - y - outline[:, 1].max()
        axes.fill(outline[:, 0] + x, outline[:, 1] + top, facecolor=PIECES[k % len(PIECES)], edgecolor="#333333",
                  linewidth=0.9)
    axes.margins(0.06)
    axes.set_aspect("equal")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=pathlib.Path, required=True, help="folder of muslin and muslin-render")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--strip", type=pathlib.Path)
    options = parser.parse_args()
    out, command = options.out, options.bin / "muslin"
    out.mkdir(parents=True, exist_ok=True)
    strip = options.strip or out / "strip.png"

    girths = body_picture(options.bin, out)
    worn = [command, "dress", *GARMENT, *CLOTH, "--view", VIEW, "--pixels", f"{WIDTH}x{HEIGHT}", "--quiet"]
    run(*worn, "--png", out / "worn.png", "--report", out / "worn.json")
    run(*worn, "--map", "ease", "--png", out / "map.png")
    run(command, "print", *GARMENT, "--pdf", out / "paper.pdf")
    run("pdftoppm", "-r", "80", "-f", str(PAGE), "-l", str(PAGE), "-singlefile", "-png", out / "paper.pdf", out / "page")

    report = json.loads((out / "worn.json").read_text())
    figure, row = plt.subplots(1, 5, figsize=(15, 5.6), dpi=100)
    figure.subplots_adjust(left=0.005, right=0.995, bottom=0.01, top=0.92, wspace=0.03)
    titles = ["tape: " + ", ".join(girths) + " cm", "pattern, drafted for her",
              f"sewn and draped: {report['nodes']} nodes", "fit: ease over the skin", "paper: A4 at true scale"]
    for axes, title in zip(row, titles):
        box = axes.get_position()
        figure.text((box.x0 + box.x1) / 2, 0.955, title, fontsize=11, color="#333333", ha="center")
        axes.set_axis_off()
    pattern_picture(row[1])
    for axes, name in ((row[0], "body"), (row[2], "worn"), (row[3], "map"), (row[4], "page")):
        axes.imshow(plt.imread(out / f"{name}.png"))
    strip.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(strip)
    print(f"{strip}: {strip.stat().st_size // 1024} kB")


if __name__ == "__main__":
    main()
