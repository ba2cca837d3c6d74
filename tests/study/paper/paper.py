"""paper.py: named designs as printed paper, judged from outside.

Each design is drafted to a pattern file and printed on a roll; this program reads both with code of its own (the JSON of
the file, the content stream of the PDF) and shares nothing with the library. It asks of each piece:

    place    the paper is the pattern: a rigid motion takes each edge of the file to its sew line on the paper
    inside   the cut line encloses every sew line
    mouth    the cut line never runs further into a dart than the allowance beside it
    fold     a dart folded shut: its cut edges lie on each other, layer on layer
    fair     a dart folded shut: step and angle between the sew edges on both sides of its mouth
    turn     a hem turned up: its ends lie on the cut lines of its neighbours
    unfold   the halves of a print on the fold, each a right or a left one, upright or turned, unfold to the whole pieces
    pages    on A4, pages without a line of their own: one that no other page shows
    nest     three sizes on one sheet: each layer has the cut lines of that size's own sheet, in dashes of its own
    seam     both edges of a seam are as long as each other, but for the ease that the seam says
    notch    both edges of a seam have notches alike in number, kind and place, but for one at an end, which stands for the
             joint of two edges that are sewn to a long one; the paper has them all
    piece    every piece that sewing needs is there, by the words of the design: a table by closure, neck, pocket, waist

    python3 tests/study/paper/paper.py --command build/bin/muslin [--sizes W40,M50,C116] [--every 10] [--jobs 2] [--table]

With --table the pieces alone are asked, of the pattern files: a minute for all designs. With --pages the pages of A4 are
counted, of whole pieces and of halves, of each family of designs in the first of its sizes: some minutes.

Limits are beside the checks. Exit 1 when one is passed. Needs no package.
"""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import zlib

os.environ["LC_ALL"] = "C.UTF-8"  # paper in English, whatever the machine speaks
MM = 25.4 / 72.0
LIMITS = {  # [mm], angles [degrees]
    "place": 0.05,   # cairo writes three decimals of a point, and edges end at corners
    "inside": 0.05,  # a sew line without allowance lies on the cut line
    "mouth": 0.1,    # beyond the allowance
    "fold": 0.15,    # two layers of paper
    "fair": 0.5,     # step in the sewn edge
    "angle": 20.0,   # corner in the sewn edge: the drafts, not the paper, decide it
    "turn": 0.15,
    "unfold": 0.1,   # as the task of paper on the fold asks
    "pages": 0.0,    # pages without a line where no other page shows it
    "nest": 0.1,     # as the task of nested sizes asks
    "seam": 0.5,     # the check of the library allows as much
    "notch": 1.0,
}
NESTS = {"W40": ["W36", "W40", "W44"], "M50": ["M46", "M50", "M54"], "C116": ["C104", "C116", "C128"]}
CUT, SEW, NOTCH = (0.5, ()), (0.25, (3.0, 1.5)), (0.4, ())  # pens: width and dashes [mm]
TOKEN = re.compile(rb"\[[^\]]*\]|/?[A-Za-z'\"*]+[0-9]*|-?[0-9.]+|<[^>]*>|\((?:\\.|[^\\)])*\)")
WEIGHTS = [((1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t * t, t ** 3) for t in (k / 32.0 for k in range(1, 33))]


# ---- the PDF: objects, pages, strokes ----

def pdf_pages(path):
    """Pages in order: (height in points, content stream)."""
    data = pathlib.Path(path).read_bytes()
    objects = {int(m[1]): m[2] for m in re.finditer(rb"(?:^|\n)(\d+) 0 obj\s(.*?)\nendobj", data, re.S)}
    pages = []
    for body in objects.values():
        if not re.search(rb"/Type\s*/Page\b(?!s)", body):
            continue
        box = [float(x) for x in re.search(rb"/MediaBox\s*\[([^\]]*)\]", body)[1].split()]
        streams = []
        for number in re.findall(rb"(\d+) 0 R", re.search(rb"/Contents\s+(\[[^\]]*\]|\d+ 0 R)", body)[1]):
            head, stream = re.split(rb"stream\r?\n", objects[int(number)], maxsplit=1)
            stream = stream[:stream.rindex(b"endstream")]
            streams.append(zlib.decompressobj().decompress(stream) if b"FlateDecode" in head else stream)
        pages.append((box[3], b"\n".join(streams)))
    return pages


def layer_names(path):
    """Names of the layers in the order of a reader's list; empty unless all are on by default."""
    data = pathlib.Path(path).read_bytes()
    objects = {int(m[1]): m[2] for m in re.finditer(rb"(?:^|\n)(\d+) 0 obj\s(.*?)\nendobj", data, re.S)}
    catalogue = next((body for body in objects.values() if b"/OCProperties" in body), b"")
    lists = {key: re.findall(rb"(\d+) 0 R", m[1]) for key in (b"OCGs", b"ON", b"Order")
             if (m := re.search(rb"/" + key + rb" \[([^\]]*)\]", catalogue))}
    if len(lists) < 3 or sorted(lists[b"ON"]) != sorted(lists[b"OCGs"]) or b"/OFF" in catalogue:
        return []
    return [bytes.fromhex(re.search(rb"/Name <FEFF([0-9A-F]*)>", objects[int(k)])[1].decode()).decode("utf-16-be")
            for k in lists[b"Order"]]


def layer_cuts(path, tiles, layer):
    """Cut lines of a layer, in order, (closed, points) in mm on the sheet, and the dashes they are drawn in."""
    found, dashes, pages = {}, set(), pdf_pages(path)
    for page, x, y, _ in tiles:
        height, stream = pages[page]
        for part in re.findall(rb"/OC /S%d BDC\n(.*?)EMC" % layer, stream, re.S):
            for pen, parts in strokes((height, part)):
                if pen[0] == 0.5 and parts:
                    dashes.add(pen[1])
                    points = [(p[0] + x, p[1] + y) for p in parts[0][1]]
                    found.setdefault(place_of(found, points), (parts[0][0], points))
    return list(found.values()), dashes


def strokes(page):
    """Stroked paths of a page: (pen, [(closed, points)]) with points in mm, y up; curves as 32 chords."""
    _, stream = page
    state, stack, found, parts, numbers = {"w": 0.0, "d": (), "J": 0, "m": (1, 0, 0, 1, 0, 0)}, [], [], [], []

    def place(x, y):
        a, b, c, d, e, f = state["m"]
        return (MM * (a * x + c * y + e), MM * (b * x + d * y + f))

    for token in TOKEN.findall(stream):
        first = token[:1]
        if first in b"-.0123456789":
            numbers.append(float(token))
            continue
        if first == b"[":
            # dashes; an array with strings is text
            numbers.append(() if b"<" in token or b"(" in token else tuple(float(x) for x in token[1:-1].split()))
            continue
        n = [x for x in numbers]
        if token == b"q":
            stack.append(dict(state))
        elif token == b"Q":
            state = stack.pop()
        elif token == b"cm":
            a, b, c, d, e, f = n[-6:]
            p, q, r, s, t, u = state["m"]
            state["m"] = (a * p + b * r, a * q + b * s, c * p + d * r, c * q + d * s, e * p + f * r + t, e * q + f * s + u)
        elif token == b"w":
            state["w"] = n[-1]
        elif token == b"d":
            state["d"] = n[-2]
        elif token == b"J":
            state["J"] = int(n[-1])
        elif token == b"m":
            parts.append([False, [place(*n[-2:])]])
        elif token == b"l":
            parts[-1][1].append(place(*n[-2:]))
        elif token == b"c":
            p = [parts[-1][1][-1]] + [place(n[i], n[i + 1]) for i in (-6, -4, -2)]
            (ax, ay), (bx, by), (cx, cy), (dx, dy) = p
            parts[-1][1].extend((e * ax + f * bx + g * cx + h * dx, e * ay + f * by + g * cy + h * dy) for e, f, g, h in WEIGHTS)
        elif token == b"re":
            x, y, w, h = n[-4:]
            parts.append([True, [place(x, y), place(x + w, y), place(x + w, y + h), place(x, y + h)]])
        elif token == b"h":
            parts[-1][0] = True
        elif token in (b"S", b"s"):
            pen = (round(MM * state["w"], 3), tuple(round(MM * x, 2) for x in state["d"]))
            if state["J"] == 0:  # letters have round ends
                found.append((pen, [(closed, points) for closed, points in parts if len(points) > 1]))
            parts = []
        elif token in (b"f", b"f*", b"n", b"B"):
            parts = []
        numbers = []
    return found


def place_of(known, points):
    """The box of a cut line, or that of a known one that is the same line on another page."""
    box = tuple(f(p[d] for p in points) for f in (min, max) for d in (0, 1))
    return next((k for k in known if max(abs(a - b) for a, b in zip(k, box)) < 0.5), box)


def paper_pieces(path, tiles):
    """Pieces in order: {"cut": [loops], "sew": [polylines], "slits": [(outer, inner)]} in mm on the sheet. `tiles`: (page,
    x, y, height) of each page that shows a part of it. A path that touches a page is on it whole."""
    pieces, pages, seen = {}, pdf_pages(path), set()
    for page, x, y, _ in tiles:
        piece = None
        for pen, parts in strokes(pages[page]):
            parts = [(closed, [(p[0] + x, p[1] + y) for p in points]) for closed, points in parts]
            key = (pen, tuple((round(p[0], 1), round(p[1], 1)) for _, points in parts for p in points[::5]))
            if pen == CUT and parts and all(closed for closed, _ in parts):
                corner = place_of(pieces, parts[0][1])
                piece = pieces.setdefault(corner, {"cut": [points for _, points in parts], "sew": [], "slits": []})
            elif piece is not None and (corner, key) not in seen and pen in (SEW, NOTCH):
                for _, points in parts:
                    if pen == NOTCH:
                        if all(math.dist(points[0], old[0]) > 0.05 for old in piece["slits"]):
                            piece["slits"].append((points[0], points[-1]))
                    elif all(math.dist(points[k], old[k]) > 0.05 for old in piece["sew"] for k in (0, -1)) or \
                            all(math.dist(points[0], old[0]) + math.dist(points[-1], old[-1]) > 0.1
                                for old in piece["sew"]):
                        piece["sew"].append(points)
            seen.add((piece and corner, key))
    return list(pieces.values())


def halves(path, tiles):
    """Cut lines of a print on the fold, in order: (closed, points) in mm on the sheet."""
    found, pages = {}, pdf_pages(path)
    for page, x, y, _ in tiles:
        for pen, parts in strokes(pages[page]):
            if pen == CUT and parts:
                points = [(p[0] + x, p[1] + y) for p in parts[0][1]]
                found.setdefault(place_of(found, points), (parts[0][0], points))
    return list(found.values())


def unfolded(whole, points):
    """Worst distance of the whole's cut line from a half and its mirror image; the half lies on the right."""
    right, top = (max(p[d] for p in whole) - max(p[d] for p in points) for d in (0, 1))
    line = [(p[0] + right, p[1] + top) for p in points]
    axis = (line[0][0] + line[-1][0]) / 2
    worst = abs(min(p[0] for p in whole) + max(p[0] for p in whole) - 2.0 * axis)
    if worst > 1.0:
        return worst
    return max(worst, worst_of([(axis + abs(p[0] - axis), p[1]) for p in whole], Line(line, closed=False)))


def quarter(points):
    """Points turned by a quarter: a sheet of halves has pieces that lie."""
    return [(-p[1], p[0]) for p in points]


def check_halves(pieces, half, note):
    """A half and its mirror image make up the whole: worst distance of the whole's cut line."""
    if len(half) != len(pieces):
        note("unfold", 99.0, f"{len(half)} pieces on the fold for {len(pieces)}")
        return
    def extent(points):
        return [max(p[d] for p in points) - min(p[d] for p in points) for d in (0, 1)]

    def unlike(piece, other):
        width, height = extent(piece["cut"][0])
        return min(abs(height - h) + abs(width - w * (1 if other[0] else 2))
                   for w, h in (extent(points) for points in (other[1], quarter(other[1]))))
    rest = list(half)
    for piece in pieces:
        whole = piece["cut"][0]
        closed, points = rest.pop(min(range(len(rest)), key=lambda k: unlike(piece, rest[k])))
        if closed:
            continue
        if math.dist(points[0], points[-1]) < 1.0:
            note("unfold", 99.0, "the fold is drawn as a line to cut")
        note("unfold", min(unfolded(whole, [(fx * p[0], fy * p[1]) for p in line])
                           for line in (points, quarter(points)) for fx in (1, -1) for fy in (1, -1)))


def check_nest(command, design, sizes, folder, note):
    """Three sizes on one sheet against a sheet of each."""
    ask = ["--design", design, "--paper", "roll", "--fold", "--json"]
    nest, told = f"{folder}/nest.pdf", {}
    for pdf, words in [(nest, ["--sizes", ",".join(sizes)])] + [(f"{folder}/{k}.pdf", ["--size", k]) for k in sizes]:
        done = subprocess.run([command, "print", *ask, "--pdf", pdf, *words], capture_output=True, text=True)
        if done.returncode != 0:
            note("nest", 99.0, done.stderr.strip()[:120])
            return
        told[pdf] = [(t["page"], 1000.0 * t["x_m"], 1000.0 * t["y_m"], 0.0) for t in json.loads(done.stdout)["tiles"]]
    if layer_names(nest) != sizes:
        note("nest", 99.0, f"layers {layer_names(nest)}")
    pens = []
    for k, size in enumerate(sizes):
        mine, dashes = layer_cuts(nest, told[nest], k)
        own = halves(f"{folder}/{size}.pdf", told[f"{folder}/{size}.pdf"])
        pens.append(dashes)
        if len(mine) != len(own) or len(dashes) != 1:
            note("nest", 99.0, f"{size}: {len(mine)} cut lines for {len(own)}")
            continue
        for closed, points in mine:
            best = min(unlike(points, other[1]) for other in own if other[0] == closed)
            note("nest", best, size)
    if len({tuple(sorted(p)) for p in pens}) != len(sizes):
        note("nest", 99.0, "two sizes in the same dashes")


def unlike(points, other):
    """Worst distance of two lines that may be moved, mirrored and turned by a quarter."""
    best, ground = 1e9, Line(other)
    for way in (points, quarter(points)):
        for fx, fy in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            turned = [(fx * p[0], fy * p[1]) for p in way]
            move = [min(p[d] for p in other) - min(p[d] for p in turned) for d in (0, 1)]
            line = [(p[0] + move[0], p[1] + move[1]) for p in turned]
            if max(abs(max(p[d] for p in other) - max(p[d] for p in line)) for d in (0, 1)) < 1.0:
                best = min(best, max(worst_of(line, ground, best), worst_of(other, Line(line), best)))
    return best


def in_order(sew, lengths):
    """The sew lines of a piece as a ring, from the edge whose lengths match."""
    ring, rest = [sew[0]], list(sew[1:])
    while rest:
        near = min(rest, key=lambda line: math.dist(line[0], ring[-1][-1]))
        if math.dist(near[0], ring[-1][-1]) > 0.1:
            return sew
        ring.append(near)
        rest.remove(near)
    own = [length(line) for line in ring]
    turns = range(len(ring))
    best = min(turns, key=lambda k: (round(max(abs(own[(i + k) % len(own)] - lengths[i]) for i in turns), 1), k))
    return ring[best:] + ring[:best]


# ---- the pattern file ----

def edge_points(pattern, index):
    """An edge as points [mm], curves as 64 chords."""
    edge = pattern["edges"][index]
    start, end = (tuple(1000.0 * x for x in pattern["points"][edge[k]]["at"]) for k in ("start", "end"))
    pieces = edge.get("pieces") or [{"kind": "line"}]
    out, at = [start], start
    for k, piece in enumerate(pieces):
        controls = [tuple(1000.0 * x for x in p) for p in piece.get("controls", [])]
        to = tuple(1000.0 * x for x in piece["end"]) if "end" in piece else end
        p = [at, *controls, to]
        if piece["kind"] == "arc":
            out += arc_points(*p)
        else:
            n = 1 if len(p) == 2 else 64
            for i in range(1, n + 1):
                t, q = i / n, p
                while len(q) > 1:
                    q = [tuple((1 - t) * a + t * b for a, b in zip(u, v)) for u, v in zip(q, q[1:])]
                out.append(q[0])
        at = to
    return out


def arc_points(s, m, e):
    ax, ay, bx, by = m[0] - s[0], m[1] - s[1], e[0] - s[0], e[1] - s[1]
    cross = 2.0 * (ax * by - ay * bx)
    if abs(cross) < 1e-9:
        return [m, e]
    aa, bb = ax * ax + ay * ay, bx * bx + by * by
    cx, cy = s[0] + (by * aa - ay * bb) / cross, s[1] + (ax * bb - bx * aa) / cross
    r, f, g = math.hypot(s[0] - cx, s[1] - cy), math.atan2(s[1] - cy, s[0] - cx), math.atan2(e[1] - cy, e[0] - cx)
    sweep = (g - f) % (2 * math.pi) if cross > 0 else -((f - g) % (2 * math.pi))
    return [(cx + r * math.cos(f + sweep * k / 64), cy + r * math.sin(f + sweep * k / 64)) for k in range(1, 65)]


def length(points):
    return sum(math.dist(a, b) for a, b in zip(points, points[1:]))


def rim(outline):
    """The outline without lines inside the panel: an edge that is followed by itself backwards is taken out."""
    word = [tuple(step) for step in outline]
    changed = True
    while changed and word:
        changed = False
        for i in range(len(word)):
            a, b = word[i], word[(i + 1) % len(word)]
            if len(word) > 1 and a[0] == b[0] and a[1] != b[1]:
                word = [w for k, w in enumerate(word) if k not in (i, (i + 1) % len(word))]
                changed = True
                break
    return word


def seams_of(pattern):
    of = {}
    for seam in pattern["seams"]:
        for edge in (seam["a"], seam["b"]):
            of.setdefault(edge, []).append(seam)
    return of


# ---- plane geometry ----

def rigid(source, target):
    """The rigid motion, with or without a mirror, that takes points to points best: (map, worst distance)."""
    best = None
    n = len(source)
    sx, sy = sum(p[0] for p in source) / n, sum(p[1] for p in source) / n
    tx, ty = sum(p[0] for p in target) / n, sum(p[1] for p in target) / n
    for flip in (1.0, -1.0):
        c = s = 0.0
        for p, q in zip(source, target):
            x, y, u, v = flip * (p[0] - sx), p[1] - sy, q[0] - tx, q[1] - ty
            c += x * u + y * v
            s += x * v - y * u
        h = math.hypot(c, s) or 1.0
        c, s = c / h, s / h

        def move(p, c=c, s=s, flip=flip):
            x, y = flip * (p[0] - sx), p[1] - sy
            return (c * x - s * y + tx, s * x + c * y + ty)
        worst = max(math.dist(move(p), q) for p, q in zip(source, target))
        if best is None or worst < best[1]:
            best = (move, worst)
    return best


class Line:
    """A polyline whose chords are filed by squares of the plane, so that a distance asks those nearby alone."""
    SQUARE = 8.0  # [mm]

    def __init__(self, points, closed=True):
        ring = points + points[:1] if closed else points
        self.box = tuple(f(p[d] for p in points) for f in (min, max) for d in (0, 1))
        self.filed = {}
        for a, b in zip(ring, ring[1:]):
            (i, k), (j, l) = (sorted(int(q[d] // self.SQUARE) for q in (a, b)) for d in (0, 1))
            for u in range(i, k + 1):
                for v in range(j, l + 1):
                    self.filed.setdefault((u, v), []).append((a, b))

    def distance(self, p, most=1e9):
        """Distance of p to the line, or one of at least `most` when it is no nearer."""
        best, u, v = most, int(p[0] // self.SQUARE), int(p[1] // self.SQUARE)
        edge = min(p[0] - u * self.SQUARE, p[1] - v * self.SQUARE, (u + 1) * self.SQUARE - p[0], (v + 1) * self.SQUARE - p[1])
        far = max(self.box[2] - p[0], p[0] - self.box[0], self.box[3] - p[1], p[1] - self.box[1]) + 2.0 * self.SQUARE
        r = 0
        while best > edge + (r - 1) * self.SQUARE and (r - 1) * self.SQUARE < far:  # squares of a ring are as far as that
            for i in range(u - r, u + r + 1):
                for j in (range(v - r, v + r + 1) if i in (u - r, u + r) else (v - r, v + r)):
                    for a, b in self.filed.get((i, j), ()):
                        best = min(best, to_chord(p, a, b))
            r += 1
        return best


def to_chord(p, a, b):
    """Distance of p to the chord from a to b."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    d = dx * dx + dy * dy
    t = max(0.0, min(1.0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / d)) if d > 0 else 0.0
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def to_line(p, points, closed=True):
    """Distance of p to a polyline."""
    ring = points + points[:1] if closed else points
    return min((to_chord(p, a, b) for a, b in zip(ring, ring[1:])), default=1e9)


def worst_of(points, line, most=1e9):
    """Distance of the point farthest from a Line, or one of at least `most` as soon as that is sure."""
    worst = 0.0
    for p in points:
        worst = max(worst, line.distance(p, most))
        if worst >= most:
            break
    return worst


def inside(p, loops):
    odd = False
    for points in loops:
        for a, b in zip(points, points[1:] + points[:1]):
            if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]):
                odd = not odd
    return odd


def crossings(o, through, points):
    """Points where the ray from o through a point meets a closed line: (distance from o, point), near first."""
    dx, dy = through[0] - o[0], through[1] - o[1]
    d = math.hypot(dx, dy)
    dx, dy, found = dx / d, dy / d, []
    for a, b in zip(points, points[1:] + points[:1]):
        f, g = dx * (a[1] - o[1]) - dy * (a[0] - o[0]), dx * (b[1] - o[1]) - dy * (b[0] - o[0])
        if (f <= 0.0) == (g <= 0.0):
            continue
        t = f / (f - g)
        p = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
        run = dx * (p[0] - o[0]) + dy * (p[1] - o[1])
        if run > 0.0:
            found.append((run, p))
    return sorted(found)


def turned(o, a, b):
    """The turn about o that takes the direction of a to that of b."""
    ux, uy, vx, vy = a[0] - o[0], a[1] - o[1], b[0] - o[0], b[1] - o[1]
    h = math.hypot(ux, uy) * math.hypot(vx, vy)
    c, s = (ux * vx + uy * vy) / h, (ux * vy - uy * vx) / h
    return lambda p: (o[0] + c * (p[0] - o[0]) - s * (p[1] - o[1]), o[1] + s * (p[0] - o[0]) + c * (p[1] - o[1]))


def mirrored(o, a):
    """The mirror in the line through o and a."""
    ux, uy = a[0] - o[0], a[1] - o[1]
    h = ux * ux + uy * uy
    c, s = (ux * ux - uy * uy) / h, 2 * ux * uy / h
    return lambda p: (o[0] + c * (p[0] - o[0]) + s * (p[1] - o[1]), o[1] + s * (p[0] - o[0]) - c * (p[1] - o[1]))


# ---- the checks of a piece ----

def darts_of(pattern, word, seams):
    """Positions of pairs of neighbouring edges that are sewn to each other, without an allowance of their own."""
    for i in range(len(word)):
        a, b = word[i][0], word[(i + 1) % len(word)][0]
        own = [seam for seam in seams.get(a, []) if a != b and {seam["a"], seam["b"]} == {a, b} and not seam.get("laid")]
        if own and not any(pattern["edges"][e].get("allowance") for e in (a, b)):
            yield i


def check_dart(sew, cut, i, width):
    """(depth in the mouth beyond the allowance, worst distance of layers, step and angle of the closed sew edge)."""
    n = len(sew)
    a, o, b = sew[i][0], sew[i][-1], sew[(i + 1) % n][-1]
    before, after = sew[i - 1], sew[(i + 2) % n]
    half = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
    out = (half[0] - o[0], half[1] - o[1])
    h = math.hypot(*out)
    out = (out[0] / h, out[1] / h)

    # into the dart: points of the cut line between the legs, below the line of the mouth
    side_a, side_b = turned(o, a, b)(a), turned(o, b, a)(b)
    across = (b[0] - a[0]) * (o[1] - a[1]) - (b[1] - a[1]) * (o[0] - a[0])
    depth = 0.0
    for p in cut:
        la = (o[0] - a[0]) * (p[1] - a[1]) - (o[1] - a[1]) * (p[0] - a[0])
        lb = (b[0] - o[0]) * (p[1] - o[1]) - (b[1] - o[1]) * (p[0] - o[0])
        lm = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
        if la * across < 0.0 and lb * across < 0.0 and lm * across > 0.0:
            depth = max(depth, abs(lm) / math.dist(a, b))
    del side_a, side_b

    # folded to either side: the halves of the cap lie on the cut line beside the dart
    layers = []
    for mouth, other in ((a, b), (b, a)):
        worst = 0.0
        halves = [(mirrored(o, mouth), mouth), (turned(o, other, mouth), other)]
        for t in range(1, 20):
            for move, leg in halves:
                ray = (leg[0] + t / 20 * (half[0] - leg[0]), leg[1] + t / 20 * (half[1] - leg[1]))
                hit = crossings(o, ray, cut)
                worst = max(worst, to_line(move(hit[0][1]), cut) if hit else 99.0)
        layers.append(worst)

    # the closed sew edge: a step between the mouth's ends, an angle between the edges there
    u = (before[-1][0] - before[-2][0], before[-1][1] - before[-2][1])
    v = turned(o, b, a)((o[0] + after[1][0] - after[0][0], o[1] + after[1][1] - after[0][1]))
    v = (v[0] - o[0], v[1] - o[1])
    angle = math.degrees(math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]))
    return depth - width, min(layers), abs(math.dist(o, a) - math.dist(o, b)), abs(angle)


def check_hem(line, inwards, cut, depth, ends):
    """Worst difference of a straight hem's ends (start, end, or both of `ends`), turned up, from the cut line that they
    come to lie on; None without any."""
    a, b = line[0], line[-1]
    h = math.dist(a, b)
    if h < 3.0 * depth or max(to_line(p, [a, b], closed=False) for p in line) > 0.02:
        return None
    u = ((b[0] - a[0]) / h, (b[1] - a[1]) / h)
    worst, middle = 0.0, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
    for sign in ends:
        for t in (0.2, 0.5, 0.8):
            runs = []
            for side in (t * depth, -t * depth):
                o = (middle[0] + side * inwards[0], middle[1] + side * inwards[1])
                runs.append(crossings(o, (o[0] + sign * u[0], o[1] + sign * u[1]), cut))
            if runs[0] and runs[1] and runs[0][0][0] < h / 2 + 3.0 * depth:
                worst = max(worst, abs(runs[0][0][0] - runs[1][0][0]))
    return worst


def is_hem(edge):
    return "hem" in edge.get("label", "") or "hem" in edge.get("name", "")


def hem_ends(pattern, word, sew, i):
    """The ends of the hem at position i that are turned up: -1.0 its start, 1.0 its end. An end beside another hem of the
    same depth is mitred, and so is one that leans by more than 38 degrees from square."""
    ends = []
    for sign, k in ((-1.0, (i - 1) % len(word)), (1.0, (i + 1) % len(word))):
        edge, own = pattern["edges"][word[k][0]], pattern["edges"][word[i][0]]
        if is_hem(edge) and edge.get("allowance") == own.get("allowance"):
            continue
        p, q, r = (sew[k][-2], sew[i][0], sew[i][1]) if sign < 0 else (sew[i][-2], sew[i][-1], sew[k][1])
        u, v = (q[0] - p[0], q[1] - p[1]), (r[0] - q[0], r[1] - q[1])
        if abs(u[0] * v[0] + u[1] * v[1]) < 0.6 * math.hypot(*u) * math.hypot(*v):
            ends.append(sign)
    return ends


def edge_allowance(pattern, edge):
    own = pattern["edges"][edge].get("allowance")
    return 10.0 if own is None else 1000.0 * own


def check_piece(pattern, panel, piece, seams, note, lengths):
    word = rim(panel["outline"])
    sew = piece["sew"]
    if len(sew) != len(word):
        note("place", 99.0, f"{len(sew)} sew lines for {len(word)} edges")
        return
    drawn = []
    for edge, direction in word:
        points = edge_points(pattern, edge)
        drawn.append(points if direction > 0 else points[::-1])
    sew = in_order(sew, [length(points) for points in drawn])
    for (edge, _), line in zip(word, sew):
        lengths[edge] = length(line)
    ends = [(p, q) for points, line in zip(drawn, sew) for p, q in ((points[0], line[0]), (points[-1], line[-1]))]
    move, worst = rigid([p for p, _ in ends], [q for _, q in ends])
    for points, line in zip(drawn, sew):
        worst = max([worst] + [to_line(move(p), line, closed=False) for p in points[::8]])
    note("place", worst)

    outer = piece["cut"][0]
    for line in sew:
        for p in line[::4] + line[-1:]:
            if not inside(p, piece["cut"]):
                note("inside", to_line(p, outer))
    note("inside", 0.0)
    for i in darts_of(pattern, word, seams):
        widths = [edge_allowance(pattern, word[k % len(word)][0]) for k in (i - 1, i + 2)]
        depth, fold, step, angle = check_dart(sew, outer, i, max(widths))
        where = pattern["edges"][word[i][0]].get("name", "")
        note("mouth", depth, where), note("fold", fold, where), note("fair", step, where), note("angle", angle, where)

    mouths = {(i + k) % len(word) for i in darts_of(pattern, word, seams) for k in (-1, 0, 1, 2)}
    for i, ((edge, _), line) in enumerate(zip(word, sew)):
        if not is_hem(pattern["edges"][edge]) or mouths & {(i - 1) % len(word), i, (i + 1) % len(word)}:
            continue
        a, b = line[0], line[-1]
        out = ((b[1] - a[1]) / math.dist(a, b), (a[0] - b[0]) / math.dist(a, b))
        middle = ((a[0] + b[0]) / 2 - 2.0 * out[0], (a[1] + b[1]) / 2 - 2.0 * out[1])
        sign = -1.0 if inside(middle, [[p for part in sew for p in part]]) else 1.0
        worst = check_hem(line, (sign * out[0], sign * out[1]), outer, edge_allowance(pattern, edge),
                          hem_ends(pattern, word, sew, i))
        if worst is not None:
            note("turn", worst, pattern["edges"][edge].get("name", ""))

    slits = sum(n["kind"] for n in pattern.get("notches", []) if n["edge"] in [e for e, _ in word])
    note("notch", 99.0 if slits != len(piece["slits"]) else 0.0, f"{len(piece['slits'])} slits for {slits}")
    for a, b in piece["slits"]:
        note("notch", min(to_line(a, line) for line in piece["cut"]))  # a keyhole is cut too
        if not inside(b, piece["cut"]):
            note("notch", 99.0, "a slit outside the piece")


def check_seams(pattern, lengths, note):
    at = {}
    for notch in pattern.get("notches", []):
        at.setdefault(notch["edge"], []).append((1000.0 * notch["s"], notch["kind"]))
    for seam in pattern["seams"]:
        a, b = seam["a"], seam["b"]
        la, lb = (lengths.get(e) or length(edge_points(pattern, e)) for e in (a, b))
        ease = 1000.0 * seam.get("ease", 0.0)
        if not seam.get("laid"):
            note("seam", abs(lb - la - ease), f"{pattern['edges'][a].get('name')}")
        # a notch at the end of an edge stands for the joint of the edges that are sewn on, and has no partner
        one, two = (sorted((s, kind) for s, kind in at.get(e, []) if 0.01 < s < length(edge_points(pattern, e)) - 0.01)
                    for e in (a, b))
        if seam.get("direction", "reversed") == "reversed":
            two = sorted((lb - s, kind) for s, kind in two)
        where = f"{pattern['edges'][a].get('name')}: {len(one)} and {len(two)} notches"
        if [kind for _, kind in one] != [kind for _, kind in two]:
            note("notch", 99.0, where)
        else:
            for (s, _), (t, _) in zip(one, two):
                note("notch", max(0.0, abs(s - t) - abs(ease)), where)


def goes_on(one, two):
    """Do two lines, the second from the end of the first, meet without a corner: by less than 15 degrees?"""
    u = (one[-1][0] - one[-2][0], one[-1][1] - one[-2][1])
    v = (two[1][0] - two[0][0], two[1][1] - two[0][1])
    return u[0] * v[0] + u[1] * v[1] > 0.966 * math.hypot(*u) * math.hypot(*v)


def check_joints(pattern, note):
    """A long edge that is sewn to two edges of other panels, which do not go on as one, has a notch at their joint, or one
    within 12 mm of it."""
    seams, rims = seams_of(pattern), [rim(panel["outline"]) for panel in pattern["panels"]]
    lines = {e: edge_points(pattern, e) for word in rims for e, _ in word}
    follows = {frozenset((w[k][0], w[(k + 1) % len(w)][0])): (w, k) for w in rims for k in range(len(w))}
    panel_of = {e: i for i, word in enumerate(rims) for e, _ in word}

    def drawn(step):
        return lines[step[0]] if step[1] > 0 else lines[step[0]][::-1]

    def sewn(edge):
        own = seams.get(edge, [])
        if len(own) != 1 or own[0].get("laid") or own[0].get("closure"):
            return None
        other = own[0]["a"] + own[0]["b"] - edge
        return other if panel_of.get(other) != panel_of[edge] else None

    for word in rims:
        for k, step in enumerate(word):
            after = word[(k + 1) % len(word)]
            p, q = sewn(step[0]), sewn(after[0])
            if p is None or q is None or not goes_on(drawn(step), drawn(after)):
                continue
            beside = follows.get(frozenset((p, q)))
            if beside and goes_on(drawn(beside[0][beside[1]]), drawn(beside[0][(beside[1] + 1) % len(beside[0])])):
                continue
            # places of the notches on the outline, from the joint on
            own, run = [], 0.0
            for edge, way in word[k + 1:] + word[:k + 1]:
                long = length(lines[edge])
                own += [run + (1000.0 * n["s"] if way > 0 else long - 1000.0 * n["s"])
                        for n in pattern.get("notches", []) if n["edge"] == edge]
                run += long
            if not any(s < 13.0 or s > run - 13.0 for s in own):
                note("notch", 99.0, f"{pattern['edges'][step[0]].get('name')}: no notch at the joint of two edges")


def printed(command, file, folder, paper, *options):
    """(PDF, tiles, page's width and height) of a pattern [mm]."""
    pdf = f"{folder}/{paper}.pdf"
    done = subprocess.run([command, "print", "--pattern", file, "--paper", paper, "--pdf", pdf, "--json", *options],
                          capture_output=True, text=True, check=True)
    tiles = json.loads(done.stdout)["tiles"]
    size = tuple(1000.0 * tiles[0][k] for k in ("width_m", "height_m"))
    return pdf, [(t["page"], 1000.0 * t["x_m"], 1000.0 * t["y_m"], t["height_m"]) for t in tiles], size


def lone_pages(pdf, tiles, size):
    """Number of pages all of whose lines other pages show too. A page prints its paper less margins of 10 mm."""
    windows = [(x + 10.0, y + 10.0, x + size[0] - 10.0, y + size[1] - 10.0) for _, x, y, _ in tiles]
    pages, count = pdf_pages(pdf), 0
    for i, (page, x, y, _) in enumerate(tiles):
        own = len(tiles) == 1
        for pen, parts in strokes(pages[page]):
            if own or pen[0] in (0.15, 0.1):  # frame and joins
                continue
            for _, points in parts:
                for a, b in zip(points, points[1:]):
                    n = max(2, int(math.dist(a, b) / 2.0))
                    for k in range(n + 1):
                        p = (x + a[0] + (b[0] - a[0]) * k / n, y + a[1] + (b[1] - a[1]) * k / n)
                        shown = [j for j, w in enumerate(windows) if w[0] < p[0] < w[2] and w[1] < p[1] < w[3]]
                        own = own or shown == [i]
                    if own:
                        break
        count += not own
    return count


def in_panels_order(panels, pieces):
    """Pieces in the order of their panels: a page shows them in the order of the sheet, several pages do not. Panels are
    told apart by the lengths of their edges, and those of one shape, as the front and back of a band, by their notches."""
    rest, out = list(pieces), []
    for part, panel in panels:
        word = {edge for edge, _ in rim(panel["outline"])}
        own = sorted(length(edge_points(part, edge)) for edge, _ in rim(panel["outline"]))
        slits = sum(notch["kind"] for notch in part.get("notches", []) if notch["edge"] in word)

        def unlike(piece, own=own):
            other = sorted(length(line) for line in piece["sew"])
            return max(abs(a - b) for a, b in zip(own, other)) if len(own) == len(other) else 1e9
        if rest:
            best = min(range(len(rest)), key=lambda k, slits=slits: (round(unlike(rest[k]), 1),
                                                                     abs(len(rest[k]["slits"]) - slits), k))
            out.append(rest.pop(best))
    return out + rest


# ---- what sewing needs ----

def axes_of(command, design, garment):
    """{axis: option} of a design, with the options that its words leave out."""
    shown = subprocess.run([command, "designs", "--show", design, "--json"], capture_output=True, check=True).stdout
    return {"garment": garment, **json.loads(shown)["axes"]}


def needed(axes):
    """[(row of the table, name of the panel as an expression, {material: least count})] of a design's words. Written
    from what a sewing book asks for, not from the library's rules."""
    at = axes.get
    upper, block = "neck" in axes, at("ease") == "block" or at("skirt") in ("block", "plain")
    knit, need = at("cloth") == "knit", []
    if block:
        return need
    collar, neck = at("collar", "none"), at("neck", "none")
    if upper and at("shape") == "neck_gathers":
        need.append(("neck: gathered into a band", "neck_band", {"main": 1, "interfacing": 1}))
    elif upper and collar in ("none", "peter_pan", "shawl", "sailor"):
        if knit and collar == "none" and neck in ("jewel", "scoop", "v", "deep_v", "square", "boat"):
            need.append(("neck: knit, no collar", "neckband", {"rib": 1}))
        else:
            where = "no collar" if collar == "none" else "flat collar"
            need.append((f"neck: {where}, front", "front.*_facing", {"main": 1, "interfacing": 1}))
            need.append((f"neck: {where}, behind", "(back|back_left|strap)(_yoke)?_facing" if neck != "halter" else "strap",
                         {"main": 1}))
    if collar in ("mandarin", "shirt", "peter_pan", "shawl", "sailor"):
        need.append((f"collar: {collar}", "collar(_left)?", {"main": 2 if collar == "shirt" else 1, "interfacing": 1}))
        need.append((f"collar: {collar}, under-collar", "under_collar(_leaf|_left)?", {"main": 1}))
    if collar == "shirt":
        need.append(("collar: shirt, the leaf on its stand", "collar_leaf", {"main": 1, "interfacing": 1}))
        need.append(("collar: shirt, its stand laps as the front", "mark stand end", {"mark": 1}))
    if collar == "turtleneck":
        need.append(("collar: turtleneck", "collar", {"rib": 1} if knit else {"main": 1}))
    if collar == "hood":
        need.append(("collar: hood, lined", "hood_left", {"main": 2, "lining": 2}))
    if upper and axes["garment"] != "cape" and at("sleeve", "none") == "none" and neck != "strapless":
        if knit and neck != "halter":
            need.append(("armhole: knit, no sleeve", "armhole_band", {"rib": 2}))
        else:
            need.append(("armhole: no sleeve", "(front|back).*_armhole_facing", {"main": 2, "interfacing": 2}))
    cuff = at("cuff", "none")
    if cuff == "none" and at("sleeve") in ("puff", "bishop"):
        cuff = "cuff"
    if cuff != "none":
        if cuff == "cuff" and at("sleeve") in ("long", "bishop", "gigot", "raglan"):
            need.append(("sleeve: a long one opens above its cuff", "mark slit", {"mark": 1}))
            need.append(("sleeve: a placket for its slit", "sleeve_placket", {"main": 2}))
            need.append(("sleeve: the cuff opens, with an underlap", "mark underlap", {"mark": 1}))
        need.append((f"sleeve: {cuff}", "cuff_left", {"rib": 2} if cuff == "rib" else {"main": 2, "interfacing": 2}))
    if at("yoke") == "yoke":
        if axes["garment"] == "trousers":
            need.append(("yoke: of trousers, left and right", "back_yoke_left", {"main": 2}))
        else:
            need.append(("yoke: two layers", "back_yoke", {"main": 2}))
    if at("hem") == "ribbed":
        need.append(("hem: rib, front", "front_rib(_left)?", {"rib": 1}))
        need.append(("hem: rib, back", "back_rib", {"rib": 1}))
    if at("pocket") == "kangaroo":
        need.append(("pocket: kangaroo, its place", "mark kangaroo pocket", {"mark": 1}))
        need.append(("pocket: kangaroo", "kangaroo_pocket(_left)?", {"main": 1}))
    if upper and at("closure") == "front":
        need.append(("closure: buttons in front", "button_stand", {"interfacing": 2}))
        need += [(f"closure: buttons in front, {word}", f"mark {mark}", {"mark": 1})
                 for word, mark in (("their buttonholes", "buttonhole"), ("where the interfacing lies", "interfacing"))]
    if at("pocket") == "patch":
        need.append(("pocket: patch", "pocket(_left)?", {"main": 1}))
    if at("pocket") in ("welt", "flap"):
        need.append((f"pocket: {at('pocket')}, its place", f"mark {at('pocket')}", {"mark": 1}))
        need.append((f"pocket: {at('pocket')}", "welt", {"main": 2, "interfacing": 2}))
        need.append((f"pocket: {at('pocket')}, bag of two layers", "welt_bag", {"lining": 4}))
        if at("pocket") == "flap":
            need.append(("pocket: flap of two layers", "flap", {"main": 4, "interfacing": 2}))
    if at("pocket", "none") != "none":
        if axes["garment"] == "trousers":
            need.append(("pocket: front, where it is cut away", "mark pocket opening", {"mark": 1}))
            need.append(("pocket: front, facing", "pocket_facing_left", {"main": 2}))
            need.append(("pocket: front, bag of two layers", "pocket_bag_left", {"lining": 4}))
    if at("skirt") == "wrap":
        need.append(("wrap: ties", "tie_long", {"main": 1}))
        need.append(("wrap: ties", "tie_short", {"main": 1}))
    if at("ease") == "coat":
        need.append(("coat: lining of the body", "front(_left)?", {"lining": 1}))
        need.append(("coat: lining of the body", "back(_left)?", {"lining": 1}))
        if at("sleeve", "none") != "none":
            need.append(("coat: lining of the sleeve", "sleeve(_left)?", {"lining": 2}))
    if axes["garment"] in ("skirt", "trousers"):
        band = at("band", "straight")
        if band in ("straight", "contour"):
            need.append((f"waist: {band} band, front", "band_front(_left)?", {"main": 2, "interfacing": 1}))
            need.append((f"waist: {band} band, back", "band_back(_left)?", {"main": 2, "interfacing": 1}))
        elif band == "elastic":
            need.append(("waist: elastic in its casing", "band_front", {"main": 1}))
            need.append(("waist: elastic, its length", "elastic", {"elastic": 1}))
        elif band == "facing":
            need.append(("waist: faced, or a narrow band", ".*_waist_facing|band_front(_left)?", {"main": 1, "interfacing": 1}))
        if at("closure", "none") != "none" and band != "elastic":
            need.append(("closure: a zip below the waist", "seam zip", {"seam": 1}))
            if band in ("straight", "contour"):
                need.append(("closure: the band opens, with an underlap", "mark underlap", {"mark": 1}))
    if axes["garment"] == "trousers" and at("closure") == "front":
        need.append(("closure: fly", "fly_facing", {"main": 1, "interfacing": 1}))
        need.append(("closure: fly", "fly_shield", {"main": 1}))
        if at("band") in ("straight", "contour"):
            need.append(("waist: belt loops", "belt_loops", {"main": 1}))
    if at("leg") in ("jogger", "harem"):
        need.append(("leg: rib", "leg_rib_left", {"rib": 2}))
    return need


def needs(axes, pattern):
    """[(row, pieces, name of one that is there or None)] of a pattern file. Marks and closures count as pieces: "mark
    slit", "seam zip"."""
    cut = {f"mark {m['name']}": {"mark": 1} for m in pattern.get("marks", [])}
    cut.update({f"seam {seam['closure']}": {"seam": 1} for seam in pattern["seams"] if "closure" in seam})
    for part in (pattern, pattern.get("cut_only", {"panels": []})):
        for panel in part["panels"]:
            if panel.get("mirror_of") is None:
                cut[panel["name"]] = {"main": panel["cut"], **panel.get("materials", {})}
    rows = [("facing, under-collar: notches of their edge", "every one", None if wrong else "all")
            for wrong in [notches_missing(pattern)]]
    for row, name, least in needed(axes):
        own = [k for k, counts in cut.items() if re.fullmatch(name, k)
               and all(counts.get(m, 0) >= n for m, n in least.items())]
        rows.append((row, " + ".join(f"{n} {m}" for m, n in least.items()), own[0] if own else None))
    return rows


def notches_missing(pattern):
    """Names of facings and under-collars with an edge that has other notches than the edge of the garment it lies on: an
    edge of the same panel, name and length."""
    extra = pattern.get("cut_only", {"panels": []})

    def edges(part, panel):
        at, out = {}, {}
        for notch in part.get("notches", []):
            at.setdefault(notch["edge"], []).append((notch["s"], notch["kind"]))
        for edge, direction in rim(panel["outline"]):
            whole = length(edge_points(part, edge)) / 1000.0
            own = sorted((s if direction > 0 else whole - s, kind) for s, kind in at.get(edge, []))
            out[part["edges"][edge].get("name", "")] = (whole, own)
        return out
    panels = {panel["name"]: panel for panel in pattern["panels"]}
    wrong = []
    for panel in extra["panels"]:
        found = re.fullmatch(r"under_(.*)|(.*?)(_armhole|_waist)?_facing(_\d+)?", panel["name"])
        source = panels.get(found[1] or found[2]) if found else None
        if source is None or panel.get("label") not in ("facing", "layer"):
            continue
        own, of = edges(extra, panel), edges(pattern, source)
        for name, (whole, notches) in own.items():
            other = of.get(name, (0.0, []))
            if abs(other[0] - whole) < 5e-4 and ([k for _, k in notches] != [k for _, k in other[1]] or any(
                    abs(a - b) > 1e-3 for (a, _), (b, _) in zip(notches, other[1]))):
                wrong.append(f"{panel['name']}.{name}")
    return wrong


def print_needs(table):
    """The table: each row with what it needs, the designs that need it and those that have it; returns what is missing."""
    print(f"  {'needed by':38} {'pieces':28} designs  there  for example")
    missing = 0
    for (row, least), (asked, there, example) in sorted(table.items()):
        missing += asked - there
        print(f"  {row:38} {least:28} {asked:7} {there:6}  {example}")
    return missing


def table_of(job):
    """check_design() of the pieces alone, of the pattern file."""
    command, design, garment, size = job
    done = subprocess.run([command, "draft", "--design", design, "--size", size, "-o", "-"], capture_output=True, check=True)
    return design, size, {}, {"darts": 0, "pieces": 0, "needs": needs(axes_of(command, design, garment),
                                                                      json.loads(done.stdout))}


def check_design(job):
    """{check: (worst, where)} of one design in one size, and the number of darts."""
    command, design, garment, size = job
    worst = {}
    count = {"darts": 0, "pieces": 0, "needs": []}
    with tempfile.TemporaryDirectory() as folder:
        file, pdf = f"{folder}/p.json", f"{folder}/p.pdf"
        for words in (["draft", "--design", design, "--size", size, "-o", file],
                      ["print", "--pattern", file, "--paper", "roll", "--pdf", pdf, "--json"]):
            done = subprocess.run([command, *words], capture_output=True, text=True)
            if done.returncode != 0:
                return design, size, {"place": (99.0, done.stderr.strip()[:120])}, count
        pattern = json.loads(pathlib.Path(file).read_text())
        tiles = [(t["page"], 1000.0 * t["x_m"], 1000.0 * t["y_m"], t["height_m"]) for t in json.loads(done.stdout)["tiles"]]
        pieces = paper_pieces(pdf, tiles)
        fold = printed(command, file, folder, "a4", "--fold")
        half, lone = halves(*fold[:2]), lone_pages(*fold)
        if size in NESTS:
            check_nest(command, design, NESTS[size], folder,
                       lambda check, value, where="": worst.__setitem__(check, max((value, where), worst.get(check, (-1.0, "")))))
    # the panels of the garment, then those that are cut and not draped, which are a pattern of their own
    lengths = {}
    panels = [(part, panel) for part in (pattern, pattern.get("cut_only", {"panels": []})) for panel in part["panels"]
              if panel.get("mirror_of") is None]
    pieces = in_panels_order(panels, pieces)
    for k, (part, panel) in enumerate(panels):
        def note(check, value, where="", panel=panel):
            if check == "mouth":
                count["darts"] += 1
            if check not in worst or value > worst[check][0]:
                worst[check] = (value, f"{panel['name']} {where}".strip())
        if k < len(pieces):
            check_piece(part, panel, pieces[k], seams_of(part), note, lengths if part is pattern else {})
    count["pieces"], count["halves"] = len(pieces), sum(not closed for closed, _ in half)
    count["needs"] = needs(axes_of(command, design, garment), pattern)
    if len(panels) != len(pieces):
        worst["place"] = (99.0, f"{len(pieces)} pieces for {len(panels)} panels")

    def note_seam(check, value, where=""):
        if check not in worst or value > worst[check][0]:
            worst[check] = (value, where)
    check_seams(pattern, lengths, note_seam)
    check_joints(pattern, note_seam)
    check_halves(pieces, half, note_seam)
    note_seam("pages", float(lone))
    return design, size, worst, count


def pages_of(job):
    """Pages of A4 of a design: of whole pieces, and with halves on the fold."""
    command, design, _, size = job
    count = []
    with tempfile.TemporaryDirectory() as folder:
        for options in ([], ["--fold"]):
            done = subprocess.run([command, "print", "--design", design, "--size", size, "--pdf", f"{folder}/a4.pdf", "--json",
                                   *options], capture_output=True, text=True, check=True)
            count.append(json.loads(done.stdout)["pages"])
    return count


def print_pages(jobs, rows, pool):
    """A line for each family, and one for all."""
    family, told, first = {row["name"]: row["family"] for row in rows}, {}, {}
    for job in jobs:
        first.setdefault(job[1], job)
    for job, count in zip(first.values(), pool.map(pages_of, first.values(), chunksize=4)):
        for name in (family[job[1]], "all"):
            told[name] = [a + b for a, b in zip(told.get(name, [0, 0, 0]), [1, *count])]
    print(f"{'family':24}{'designs':>8}{'whole':>8}{'on fold':>8}")
    for name, numbers in sorted(told.items(), key=lambda row: (row[0] == "all", row[0])):
        print(f"{name:24}" + "".join(f"{n:8}" for n in numbers))


def main():
    ask = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    ask.add_argument("--command", required=True)
    ask.add_argument("--sizes", default="W40,M50,C116", help="a design is drafted in those that it is made for")
    ask.add_argument("--every", type=int, default=1, help="every n-th design")
    ask.add_argument("--designs", default="", help="these alone")
    ask.add_argument("--table", action="store_true", help="the table of needed pieces alone")
    ask.add_argument("--pages", action="store_true", help="the number of pages alone, by family")
    ask.add_argument("--jobs", type=int, default=1)
    args = ask.parse_args()
    rows = json.loads(subprocess.run([args.command, "designs", "--json"], capture_output=True, check=True).stdout)
    group = {"W": "women", "M": "men", "C": "children"}
    names = args.designs.split(",") if args.designs else [row["name"] for row in rows[::args.every]]
    jobs = [(args.command, row["name"], row["words"].split()[0], size) for row in rows if row["name"] in names for size in args.sizes.split(",")
            if group[size[0]] in row.get("groups", ["women"])]
    worst, over, darts, pieces, table = {}, 0, 0, 0, {}
    with concurrent.futures.ProcessPoolExecutor(args.jobs) as pool:
        if args.pages:
            return print_pages(jobs, rows, pool)
        for design, size, found, count in pool.map(table_of if args.table else check_design, jobs, chunksize=4):
            darts += count["darts"]
            for row, least, own in count["needs"]:
                asked, there, example = table.get((row, least), (0, 0, ""))
                table[row, least] = (asked + 1, there + (own is not None), example or f"{design}: {own}")
                if own is None:
                    print(f"{design} {size}: no piece for \"{row}\": {least}")
            pieces += count["pieces"]
            for check, (value, where) in found.items():
                if value > LIMITS[check]:
                    over += 1
                    print(f"{design} {size}: {check} {value:.3f} (limit {LIMITS[check]}): {where}")
                if check not in worst or value > worst[check][0]:
                    worst[check] = (value, f"{design} {size} {where}")
    print(f"{len(jobs)} patterns" + ("" if args.table else f", {pieces} pieces, {darts} darts, {over} over a limit"))
    for check, limit in LIMITS.items():
        if check in worst:
            print(f"  {check:7} worst {worst[check][0]:8.3f} of {limit}: {worst[check][1]}")
    return 1 if print_needs(table) or over else 0


if __name__ == "__main__":
    sys.exit(main())
