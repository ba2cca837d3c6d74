"""Measure a printed pattern: test squares from pixels, seam lines from vector paths. Needs poppler and numpy.

Seam lines are found by their pen, which nothing else on the paper uses: dashes of 3 and 1.5 mm. Each edge is a path of
its own and is drawn whole, clipped, on each page that it touches; a page's lower left corner is at (x, y) of the sheet
(mus_sheet_page, or `muslin print --json`).

    squares(pdf)                    {100.0: (width, height), 101.6: ...} of the test squares, on the page that has them [mm]
    seams(pdf, pages, margin)       lengths of the edges on the joined tiles [mm], sorted; checks that the copies of an
                                    edge fall on each other and that the pages together show all of it
    compare(lengths, expected)      largest difference of two lists of lengths [mm]
"""
import math
import re
import subprocess
import xml.etree.ElementTree

import numpy

MM = 25.4 / 72.0
SEAM_DASH = (3.0, 1.5)
INK = 76  # darker than this is a line
TOKEN = re.compile(r"[MLCZ]|-?[0-9.]+(?:e-?[0-9]+)?")


def page_count(pdf):
    text = subprocess.run(["pdfinfo", str(pdf)], capture_output=True, text=True, check=True).stdout
    return int(re.search(r"^Pages:\s+(\d+)", text, re.M)[1])


# ---- squares ----

def raster(pdf, page, dpi=254):
    """A page as an array of darkness, 0 to 255."""
    out = subprocess.run(["pdftoppm", "-r", str(dpi), "-f", str(page), "-l", str(page), "-gray", str(pdf)],
                         capture_output=True, check=True).stdout
    width, height = map(int, out[:40].split(None, 4)[1:3])
    return 255 - numpy.frombuffer(out, numpy.uint8, offset=len(out) - width * height).reshape(height, width)


def long_runs(dark, least):
    """Level lines: (start, end, centre) in pixels for each run of ink of at least `least`; rows of one line are one."""
    dark = numpy.ascontiguousarray(dark)
    lines = []
    for y in numpy.flatnonzero(numpy.count_nonzero(dark > INK, axis=1) >= least):
        ink = numpy.concatenate(([0], (dark[y] > INK).astype(numpy.int8), [0]))
        change = numpy.diff(ink)
        for start, end in zip(numpy.flatnonzero(change == 1), numpy.flatnonzero(change == -1)):
            if end - start < least:
                continue
            weight = dark[y, start:end].mean()
            for line in lines:
                if line[2] == y - 1 and abs(line[0] - start) < 4 and abs(line[1] - end) < 4:
                    line[2:] = y, line[3] + weight, line[4] + weight * (y + 0.5)
                    break
            else:
                lines.append([start, end, y, weight, weight * (y + 0.5)])
    return [(line[0], line[1], line[4] / line[3]) for line in lines]


def side(dark, size):
    """Distance in pixels between the two level lines of a square of `size` pixels."""
    lines = [line for line in long_runs(dark, 0.95 * size) if abs(line[1] - line[0] - size) < 8]
    assert len(lines) == 2, f"{len(lines)} lines of {size} pixels"
    return abs(lines[1][2] - lines[0][2])


def squares(pdf, dpi=254):
    pages = subprocess.run(["pdftotext", str(pdf), "-"], capture_output=True, text=True, check=True).stdout.split("\f")
    page = next(i for i, text in enumerate(pages) if "outer square" in text)
    dark, found = raster(pdf, page + 1, dpi), {}
    for size in (100.0, 101.6):
        pixels = size * dpi / 25.4
        found[size] = tuple(side(image, pixels) * 25.4 / dpi for image in (dark.T, dark))
    return found


# ---- seam lines ----

def matrix(text):
    return tuple(map(float, re.findall(r"-?[0-9.]+(?:e-?\d+)?", text))) if text else (1, 0, 0, 1, 0, 0)


def path_points(text):
    """One path as a list of (kind, points): the start, then lines and cubics."""
    steps, numbers = [], {"M": 2, "L": 2, "C": 6, "Z": 0}
    tokens = TOKEN.findall(text)
    at = 0
    while at < len(tokens):
        kind = tokens[at]
        n = numbers[kind]
        steps.append((kind, [float(t) for t in tokens[at + 1:at + 1 + n]]))
        at += 1 + n
    return steps


def page_seams(pdf, page, height):
    """Seam paths of a page (0 is the first): arrays of control points with their kinds [mm], y up from the lower edge."""
    out = subprocess.run(["pdftocairo", "-svg", "-f", str(page + 1), "-l", str(page + 1), str(pdf), "-"],
                         capture_output=True, text=True, check=True).stdout
    paths = []
    for element in xml.etree.ElementTree.fromstring(out).iter("{http://www.w3.org/2000/svg}path"):
        style = element.get("style") or ""
        dash = re.search(r"stroke-dasharray:([0-9.]+),([0-9.]+)", style)
        if dash is None:
            continue
        a, b, c, d, e, f = matrix(element.get("transform"))
        scale = MM * math.sqrt(abs(a * d - b * c))
        if any(abs(float(got) * scale - want) > 0.01 for got, want in zip(dash.groups(), SEAM_DASH)):
            continue
        kinds, points = "", []
        for kind, numbers in path_points(element.get("d")):
            assert kind != "Z", "a seam path is open: one edge"
            kinds += kind
            for x, y in zip(numbers[::2], numbers[1::2]):
                points.append((MM * (a * x + c * y + e), height - MM * (b * x + d * y + f)))
        paths.append((kinds, numpy.array(points)))
    return paths


def curve(kinds, points, step=0.1):
    """A path as points about `step` mm apart (exact ends)."""
    out, at = [points[0]], 1
    for kind in kinds[1:]:
        p = points[at - 1:at + (1 if kind == "L" else 3)]
        n = max(8, int(numpy.abs(numpy.diff(p, axis=0)).sum() / step))
        t = numpy.arange(1, n + 1)[:, None] / n
        if kind == "L":
            out.extend(p[0] + t * (p[1] - p[0]))
            at += 1
        else:
            s = 1.0 - t
            out.extend(s ** 3 * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t ** 3 * p[3])
            at += 3
    return numpy.array(out)


def seams(pdf, pages, margin, tolerance=0.02):
    """`pages`: (page, x, y, width, height) [mm] as mus_sheet_page gives them; `margin` [mm]."""
    edges = []  # kinds, control points on the sheet, windows of the pages that draw it
    for page, x, y, width, height in pages:
        window = (x + margin, y + margin, x + width - margin, y + height - margin)
        for kinds, points in page_seams(pdf, page, height):
            points = points + numpy.array((x, y))
            for own_kinds, own_points, windows in edges:
                if own_kinds == kinds and numpy.abs(own_points - points).max() < tolerance:
                    windows.append(window)
                    break
            else:
                edges.append((kinds, points, [window]))
    lengths = []
    for kinds, points, windows in edges:
        line = curve(kinds, points)
        shown = numpy.zeros(len(line), bool)
        for left, low, right, high in windows:
            shown |= ((line[:, 0] >= left - 0.01) & (line[:, 0] <= right + 0.01) &
                      (line[:, 1] >= low - 0.01) & (line[:, 1] <= high + 0.01))
        assert shown.all(), f"{(~shown).sum()} of {len(line)} points of an edge are on no page"
        lengths.append(float(numpy.hypot(*numpy.diff(line, axis=0).T).sum()))
    return sorted(lengths)


def compare(lengths, expected):
    assert len(lengths) == len(expected), f"{len(lengths)} edges on the paper, {len(expected)} in the pattern"
    return max(abs(a - b) for a, b in zip(sorted(lengths), sorted(expected)))
