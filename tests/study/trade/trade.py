#!/usr/bin/env python3
"""Patterns through the files of the garment trade and back: `make trade`.

Eight parts, each with a line of its own at the end; the command fails when a part does.
  round trip: every named design in one size and every GarmentCode specification, through DXF AAMA and ASTM. Compared:
              pieces, edges, the distance of the outlines, allowances, notches, grain, marks, names, labels, quantities.
  audit:      the same files by ezdxf, which has to find no error and repair nothing (left out without ezdxf).
  valentina:  the DXF files of the data: pieces, and areas of the sew line or cut line, as its facts.csv has them.
  tools:      drawings of Valentina (from its Debian package, --valentina FOLDER) against its own export of them, 0.1 mm.
  rules:      designs in eight sizes: the sample graded by the RUL file against each size's own draft, at the ends of edges.
  garmentcode: the same patterns as GarmentCode specifications and back.
  drawings:   the same patterns as an SVG that drawing programs edit, and back.
  plots:      a dozen sheets as HPGL, at true size as hp2xx reads them (left out without hp2xx).

    MUSLIN_LIB=build/lib/libmuslin.so python3 tests/study/trade/trade.py --data DATA [--every 10] [--list]
"""
import argparse
import collections
import csv
import itertools
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "bindings" / "python"))
import muslin  # noqa: E402
from muslin._library import lib  # noqa: E402
from muslin.pattern import Pattern  # noqa: E402
from muslin.print import Sheet  # noqa: E402

OUTLINE_MM = 0.0105   # 0.01 mm of the chords, and the rounding of the file's last digit (1e-4 mm)
NOTCH_MM = 0.1        # a notch lies on the cut line and is read back along its slit
GRADE_MM = 0.1
PLOT_MM = 0.05        # two plotter units of 0.025 mm
CHORD_MM = 0.26       # Valentina draws a curve by chords that may stray by a pixel of 96 to the inch
SIZES = {"women": ["W40", "W34", "W36", "W38", "W42", "W44", "W46", "W48"],
         "men": ["M50", "M46", "M48", "M52", "M54", "M56", "M58", "M60"],
         "children": ["C116", "C92", "C98", "C104", "C110", "C122", "C128", "C134"]}
GRADED = ["tshirt", "skirt", "shirt_women", "trousers", "dress", "jacket", "blouse", "polo", "pencil_skirt", "chinos",
          "tank", "vest"]


def tape_of(size):
    return muslin.Tape.size(size)


def chords(ops, points):
    """Points [mm] of a line of a sheet, its cubics as 400 chords."""
    out, at, p = [], 0, None
    for op in ops:
        if op in "ml":
            p = points[at]
            out.append(p)
            at += 1
        elif op == "c":
            a, b, c, d = (np.array(x) for x in (p, *points[at:at + 3]))
            t = np.linspace(0, 1, 401)[1:, None]
            out += list(map(tuple, (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t * t * c + t ** 3 * d))
            p = points[at + 2]
            at += 3
    return 1e3 * np.array(out)


def distance(points, line):
    """Greatest distance of points from a polyline."""
    a, d = line[:-1], line[1:] - line[:-1]
    dd = np.maximum((d * d).sum(1), 1e-30)
    t = np.clip(((points[:, None] - a) * d).sum(2) / dd, 0, 1)
    return float(np.sqrt(((a + t[..., None] * d - points[:, None]) ** 2).sum(2).min(1)).max())


class Piece:
    """What a sheet shows of one piece, as the file should keep it [mm]."""

    def __init__(self, pattern, sheet, index, lines):
        self.struct = sheet.pieces[index]
        self.panel = self.struct.panel
        self.edges = [(edge, chords(ops, points)) for kind, edge, ops, points in lines if kind == 1]

    def place(self, points):
        turn, shift = np.array(self.struct.turn).reshape(2, 2), np.array(self.struct.shift)
        return 1e3 * (np.array(points) @ turn.T + shift)


def joined(pattern):
    """A pattern as a sheet takes it: the panels that are cut and not draped follow its own."""
    extra, all_panels = pattern.cut_only(), pattern.copy()
    if extra is not None:
        all_panels.join(extra, 0)
        all_panels.set_cut_only(None)
    return all_panels


def legs_of_darts(pattern, panel):
    """Edges of a panel between the ends of a dart's mouth: the cut line runs across the mouth, so that a leg without an
    allowance of its own has none."""
    legs, rim = set(), pattern.rim(panel)
    starts = np.array([pattern.point(pattern.edge_ends(edge)[0 if way > 0 else 1])[1:] for edge, way in rim])
    for mouth, _, other, _ in pattern.cut_line(panel)[1]:
        first, last = (int(np.hypot(*(starts - end).T).argmin()) for end in (mouth, other))
        legs.update(rim[(first + k) % len(rim)][0] for k in range((last - first) % len(rim)))
    return legs


class Trip:
    """One pattern through one dialect."""

    def __init__(self, pattern, sheet, pieces, data, name):
        self.faults = []
        self.worst = 0.0
        self.notch = 0.0
        again = Pattern.parse_dxf(data, name=name)
        own = [i for i in range(len(again.panels)) if again.cut(i)[1] is None]
        self.expect("pieces", len(pieces), len(own))
        if len(own) != len(pieces):
            return
        marks, old_marks = again.marks(), pattern.marks()
        for piece, panel in zip(pieces, own):
            self.outline(pattern, again, piece, panel)
            what = piece.struct.name.decode()
            if what.isascii() and what.lower() == what and len(what) <= 20 and what.replace("_", "").isalnum():
                self.expect(f"{what}: name", what, again.panels[panel])
            self.expect(f"{what}: label", pattern.get("panel_label", piece.panel), again.get("panel_label", panel))
            self.expect(f"{what}: copies", piece.struct.copies, again.cut(panel)[0])
            mirrors = sum(again.cut(i)[1] == panel for i in range(len(again.panels)))
            self.expect(f"{what}: mirrored", bool(piece.struct.mirrored), mirrors > 0)
            self.notches(what, pattern, again, piece, panel)
            grain = again.grain(panel)
            self.expect(f"{what}: grain up", True, abs(grain[0]) < 1e-4 and grain[1] > 0)
            self.marks(what, piece, [m for m in old_marks if m[0] == piece.panel], [m for m in marks if m[0] == panel])

    def expect(self, what, wanted, got):
        if wanted != got:
            self.faults.append(f"{what}: {got}, expected {wanted}")

    def outline(self, pattern, again, piece, panel):
        what = piece.struct.name.decode()
        new = {}
        for edge, _ in again.outline(panel):
            line = 1e3 * np.array(again.edge_polyline(edge, 1))
            new[edge] = line
        self.expect(f"{what}: edges", len(piece.edges), len(new))
        legs = legs_of_darts(pattern, piece.panel)
        for edge, line in piece.edges:
            near = min(new, key=lambda e: np.hypot(*(new[e][0] - line[0])) + np.hypot(*(new[e][-1] - line[-1])))
            off = max(distance(line, new[near]), distance(new[near], line))
            self.worst = max(self.worst, off)
            if off > OUTLINE_MM:
                self.faults.append(f"{what}: edge {edge} is off by {off:.4f} mm")
            allowance = pattern.edge_allowance(edge)
            allowance = allowance if allowance is not None else 0.0 if edge in legs else 0.01
            back = again.edge_allowance(near)
            back = 0.01 if back is None else back
            if abs(1e3 * (allowance - back)) > 0.03:
                self.faults.append(f"{what}: edge {edge} has {1e3 * back:.2f} mm allowance, expected {1e3 * allowance:.2f}")

    def notches(self, what, pattern, again, piece, panel):
        """Notches by place and kind: one at the end of an edge may come back on the edge beside it."""
        rim = [edge for edge, _ in pattern.rim(piece.panel)]
        new = [(k, 1e3 * np.array(again.edge_at(e, [min(1.0, s / again.edge_length(e))])[0]))
               for e, s, k in again.notches() if e in dict(again.outline(panel))]
        old = []
        for edge, s, kind in pattern.notches():
            if edge in rim:
                length, half = pattern.edge_length(edge), 0.002 * (kind - 1)  # slits near an end move inwards
                s = length / 2 if length < 2 * half else min(max(s, half), length - half)
                old.append((kind, piece.place(pattern.edge_at(edge, [s / length]))[0]))
        self.expect(f"{what}: notches", sorted(k for k, _ in old), sorted(k for k, _ in new))
        for kind, p in old:
            off = min((np.hypot(*(q - p)) for k, q in new if k == kind), default=math.inf)
            self.notch = max(self.notch, off if off < math.inf else 0.0)
            if off > NOTCH_MM:
                self.faults.append(f"{what}: a notch is off by {off:.3f} mm")

    def marks(self, what, piece, old, new):
        self.expect(f"{what}: marks", [m[1] for m in old], [m[1] for m in new])
        for a, b in zip(old, new):
            if len(a[2]) == len(b[2]):
                off = np.abs(piece.place(a[2]) - 1e3 * np.array(b[2])).max()
                if off > OUTLINE_MM:
                    self.faults.append(f"{what}: mark {a[1]} is off by {off:.3f} mm")


def patterns(data, every):
    """(name, pattern) of all named designs in one size, and of all specifications."""
    tapes = {}
    for i, row in enumerate(muslin.designs()):
        if i % every == 0:
            group = row["groups"][0]
            tapes[group] = tapes.get(group) or tape_of(SIZES[group][0])
            yield row["name"], muslin.draft(row["name"], tapes[group])
    specs = sorted((data / "garmentcode").rglob("*_specification.json"))
    for path in specs[::every]:
        yield path.name.removesuffix("_specification.json"), Pattern.read(path)


def audit(data):
    """Number of errors and fixes that ezdxf tells, None without it."""
    try:
        import io
        import ezdxf
        from ezdxf.lldxf.const import DXFError
    except ImportError:
        return None
    try:
        told = ezdxf.read(io.StringIO(data.decode("ascii"))).audit()
    except (DXFError, UnicodeDecodeError):
        return 1
    return len(told.errors) + len(told.fixes)


def round_trip(args):
    count = good = audited = told = refused = 0
    worst = notch = 0.0
    losses = collections.Counter()
    for name, pattern in patterns(args.data, args.every):
        pattern = joined(pattern)
        try:
            sheet = Sheet(pattern, paper="roll")
        except muslin.MuslinError as error:  # an outline that cannot be cut is told, and there is no file
            print(f"  {name}: {error}")
            refused += 1
            continue
        lines = collections.defaultdict(list)
        for piece, kind, edge, ops, points in sheet.lines:
            lines[piece].append((kind, edge, ops, points))
        pieces = [Piece(pattern, sheet, i, lines[i]) for i in range(len(sheet.pieces))]
        for dialect in ("aama", "astm"):
            data = sheet.dxf_bytes(dialect)
            trip = Trip(pattern, sheet, pieces, data, f"{name}.{dialect}.dxf")
            count, good = count + 1, good + (not trip.faults)
            worst, notch = max(worst, trip.worst), max(notch, trip.notch)
            for fault in trip.faults:
                losses[fault.split(": ")[1].split(" of ")[0] if ": " in fault else fault] += 1
                if args.list:
                    print(f"{name} {dialect}: {fault}")
            errors = audit(data)
            if errors is not None:
                audited, told = audited + 1, told + errors
    for what, n in losses.most_common(12):
        print(f"  {n:5d} {what}")
    print(f"round trip: {good} of {count} files keep all; outlines within {worst:.4f} mm, notches within {notch:.3f} mm; "
          f"{refused} patterns are refused, with the sentence above")
    print(f"audit: {audited} files, {told} errors and fixes" if audited else "audit: skipped, no ezdxf (pip install ezdxf)")
    return good == count and told == 0


def valentina(data):
    facts = collections.defaultdict(list)
    folder = data / "valentina"
    for row in csv.DictReader((folder / "facts.csv").open()):
        facts[row["file"]].append(row)
    files = pieces = good = cut = 0
    for name, rows in sorted(facts.items()):
        pattern = Pattern.read(folder / name)
        both = rows + facts[name.replace(".aama.", ".astm.")]
        files += len(pattern.panels) == len(rows)
        for i in range(len(pattern.panels)):
            pieces += 1
            area = 1e6 * pattern.area(i)
            known = {key: min((abs(area - float(row[key])) for row in both if row[key]), default=math.inf)
                     for key in ("sew_area_mm2", "cut_area_mm2")}
            near = min(known.values()) < 1e-4 + 1e-6 * area
            good += near
            cut += near and known["cut_area_mm2"] < known["sew_area_mm2"]
            if not near:
                print(f"  {name} {pattern.panels[i]}: {area:.2f} mm2 is no area of the facts")
    print(f"valentina: {files} of {len(facts)} files have the pieces of the facts; {good} of {pieces} pieces their area "
          f"({cut} that of the cut line)")
    return files == len(facts) and good == pieces


# the files of the data that Valentina exported: (drawing, measurements) in the folder of its examples, or in the data
DRAWINGS = {"keiko_skirt": ("Keiko_skirt", "keiko"), "male_shirt": ("MaleShirt/MaleShirt", "MaleShirt/MaleShirt"),
            "tshirt": ("TShirt_test", None), "seamtest3": ("test/seamtest3", None),
            "seamtest1": ("test/seamtest1", "test/merki27"), "blusa": ("pattern_blusa", "blusa"),
            "basic_block_women": ("Basic_block_women-2016", None),
            "issue767_grain": ("bugs/Issue_#767", "bugs/Issue_#767"), "issue646_notches": ("bugs/Issue_#646", None),
            **{f"{name}_{size}": (f"{name}_52-176", f"gost_man_{size}") for name in ("pantsM1", "jacketM1")
               for size in ("440_1640", "500_1760", "560_1880")}}


def ring(pattern, panel, chords):
    """The closed outline [mm] of a panel, each curve as chords."""
    parts = [1e3 * np.array(pattern.edge_polyline(edge, chords))[::way] for edge, way in pattern.outline(panel)]
    return np.concatenate([*parts, parts[0][:1]])


def away(corners, line):
    """How far the corners of an outline lie from a line [mm], once it is moved to where it fits best; and how far the
    line then lies from the outline; and the move."""
    kept, shift, best = 0.0, (line.min(0) + line.max(0) - corners.min(0) - corners.max(0)) / 2, math.inf
    for _ in range(8):
        a, d = line[:-1], line[1:] - line[:-1]
        p = corners + shift
        t = np.clip(((p[:, None] - a) * d).sum(2) / np.maximum((d * d).sum(1), 1e-30), 0, 1)
        off = a + t[..., None] * d - p[:, None]
        near = off[np.arange(len(p)), (off ** 2).sum(2).argmin(1)]
        if (worst := float(np.hypot(*near.T).max())) < best:
            best, kept = worst, shift
        shift = shift + (near.max(0) + near.min(0)) / 2
    return best, float(distance(line[::4] - kept, np.concatenate((corners, corners[:1])))), kept


def widths(pattern, panel):
    return [pattern.edge_allowance(edge) or 0.0 for edge, _ in pattern.outline(panel)]


def strays(theirs, ours):
    """How far each stretch of our outline that theirs has not goes away from theirs [mm]."""
    line = np.concatenate([a + (b - a) * np.linspace(0, 1, 9)[:-1, None] for a, b in zip(ours[:-1], ours[1:])])
    away = np.array([distance(p[None], theirs) for p in line])
    away = np.roll(away, -int(np.argmin(away)))
    runs = np.split(away, np.flatnonzero(np.diff((away > CHORD_MM).astype(int))) + 1)
    return [float(run.max()) for run in runs if run.max() > CHORD_MM]


def why(theirs, ours, drawing, allowances):
    """What makes a piece of Valentina's own export another one than its drawing says. `allowances` is (theirs, ours)."""
    wider = float((np.ptp(theirs, axis=0) - np.ptp(ours, axis=0)).min()) / 2
    if max(allowances[0]) == 0 and min(allowances[1]) > 0 and wider > CHORD_MM:
        return f"its export has the cut line alone, {wider:.1f} mm outside"
    if deep := [depth for depth in strays(theirs, ours) if depth > 1]:
        return f"its export leaves out {len(deep)} darts, slits or loops of the outline, up to {max(deep):.1f} mm deep"
    if 'type="triangle"' in drawing:
        return "a corner is a point of the tool triangle, which Valentina searches in steps of 0.26 mm"
    return "not known"


def tools(args):
    """Drawings of Valentina, evaluated, against its own export of them: the corners of its chords from our curves."""
    folder = args.valentina
    if not folder.is_dir():
        print(f"tools: skipped, no {folder}: apt-get download valentina; dpkg-deb -x")
        return True
    read = pieces = good = both = 0
    for name, (drawing, tape) in sorted(DRAWINGS.items()):
        measures = None if tape is None else next(
            path for path in (folder / f"{tape}.vit", args.data / f"valentina/measurements/{tape}.vit") if path.exists())
        try:
            ours = Pattern.read_val(folder / f"{drawing}.val", measures)
        except muslin.MuslinError as error:
            print(f"  {name}: {error}")
            continue
        read += 1
        text = (folder / f"{drawing}.val").read_text(errors="replace")
        theirs = Pattern.read(args.data / f"valentina/{name}.astm.dxf")
        lines = [ring(ours, i, 64) for i in range(len(ours.panels))]
        for i, piece in enumerate(theirs.panels):
            corners = ring(theirs, i, 1)
            worst, back, shift, k = min(((*away(corners, line), k) for k, line in enumerate(lines)), key=lambda found: found[:2])
            pieces, good, both = pieces + 1, good + (worst <= 0.1), both + (worst <= 0.1 and back <= CHORD_MM)
            if worst > 0.1 or back > CHORD_MM:
                print(f"  {name} {piece}: its corners within {worst:.3f} mm of our curves, our curves within {back:.3f} mm "
                      f"of its chords: {why(corners, lines[k] - shift, text, [widths(theirs, i), widths(ours, k)])}")
    print(f"tools: {read} of {len(DRAWINGS)} drawings of Valentina read; of {pieces} pieces {good} have the corners of its "
          f"export within 0.1 mm, {both} also the whole outline within {CHORD_MM} mm of its chords")
    others = sorted(path for path in folder.rglob("*.val") if path.stat().st_size < 1e6)
    told = collections.Counter()
    for path in others:
        asked = re.search("<measurements>([^<]*)", path.read_text(errors="replace"))
        named = pathlib.PurePath(asked.group(1).replace("\\", "/")).name if asked else ""
        tapes = [tape for tape in (path.parent / named, folder / named, folder.parents[3] / "valentina/tables/multisize" / named)
                 if named and tape.is_file()]
        try:
            Pattern.read_val(path, tapes[0] if tapes else None)
            told["read"] += 1
        except muslin.MuslinError as error:
            told[re.sub(r'^.*?\.val(:\d+)?: ', "", str(error))[:100]] += 1
    print(f"tools: {told.pop('read')} of {len(others)} drawings of its examples read")
    if args.list:
        for fault, count in told.most_common():
            print(f"  {count} x {fault}")
    return read == len(DRAWINGS)


def rules():
    known = {row["name"]: row["groups"][0] for row in muslin.designs()}
    done = points = bad = 0
    worst = 0.0
    for name in [n for n in GRADED if n in known] + list(known):
        if done == 6:
            break
        sizes = SIZES[known[name]]
        try:
            drafts = {size: joined(muslin.draft(name, tape_of(size))) for size in sizes}
            sheets = {size: Sheet(drafts[size], paper="roll") for size in sizes}
            others = {size: sheets[size] for size in sizes[1:]}
            options = {"size_name": sizes[0].encode(), "sizes": others}
            data, rul = sheets[sizes[0]].dxf_bytes(**options), sheets[sizes[0]].rul_bytes(**options)
        except muslin.MuslinError as error:
            print(f"  {name}: {error}")
            continue
        done += 1
        for size in sizes[1:]:
            again = Pattern.parse_dxf(data, rules=rul, size=size)
            own = [i for i in range(len(again.panels)) if again.cut(i)[1] is None]
            for piece, panel in zip(sheets[size].pieces, own):
                sample = sheets[sizes[0]].pieces[[p.name for p in sheets[size].pieces].index(piece.name)]
                turn = np.array(piece.turn).reshape(2, 2)
                ends = [drafts[size].edge_ends(e)[0 if d > 0 else 1] for e, d in drafts[size].rim(piece.panel)]
                place = np.array([drafts[size].point(i)[1:] for i in ends]) @ turn.T + np.array(sample.shift)
                got = np.array([again.point(again.edge_ends(e)[0])[1:] for e, _ in again.outline(panel)])
                off = 1e3 * np.hypot(*(got[:, None] - place[None]).transpose(2, 0, 1)).min(0)
                points += len(off)
                bad += int((off > GRADE_MM).sum())
                worst = max(worst, float(off.max()))
    print(f"rules: {done} designs in {8} sizes: {points} grade points, {bad} off by more than {GRADE_MM} mm, "
          f"worst {worst:.4f} mm")
    return done == 6 and bad == 0


def held(pattern):
    """Length of the edges of seams that GarmentCode can hold [m], and how many seams it cannot."""
    rims = {edge for panel in range(len(pattern.panels)) for edge, _ in pattern.rim(panel)}
    length, others = 0.0, 0
    for s in range(pattern.seam_count):
        seam = pattern.seam(s)
        edges = (seam["edge_a"], seam["edge_b"])
        if seam["laid"] or any(e not in rims or lib.mus_pattern_edge_seam(pattern.handle, e) != s for e in edges):
            others += 1
        else:
            length += sum(pattern.edge_length(e) for e in edges)
    return length, others


def garmentcode(args):
    """Every pattern as a GarmentCode specification and back: areas, places, lengths of what is sewn."""
    count = good = others = 0
    worst = 0.0
    for name, pattern in patterns(args.data, args.every):
        count += 1
        try:
            again = Pattern.parse(pattern.garmentcode_bytes(), name=f"{name}.json")
        except muslin.MuslinError as error:
            print(f"  {name}: {error}")
            continue
        # how far the outline would have to move all round for the area to differ by as much [m]
        moved = max(abs(pattern.area(i) - again.area(i)) / pattern.perimeter(i) for i in range(len(pattern.panels)))
        around = max(abs(pattern.perimeter(i) - again.perimeter(i)) for i in range(len(pattern.panels)))
        sewn = [held(pattern)[0], held(again)[0]]
        others += held(pattern)[1]
        worst = max(worst, 1e3 * around)
        fine = moved < 1e-8 and around < 1e-6 and abs(sewn[0] - sewn[1]) < 1e-5
        good += fine
        if not fine and args.list:
            print(f"  {name}: area as if moved by {moved:.1e} m, outline {around:.1e} m, sewn {sewn[0]:.4f} and {sewn[1]:.4f} m")
    print(f"garmentcode: {good} of {count} patterns keep outlines and seams; outlines as long within {worst:.1e} mm; "
          f"{others} seams are second seams of an edge or inside a panel, which the form has not")
    return good == count


def plots(args):
    """A dozen sheets as HPGL, their size as hp2xx tells it against the boxes of the cut lines."""
    if shutil.which("hp2xx") is None:
        print("plots: skipped, no hp2xx (apt-get install hp2xx)")
        return True
    count = bad = 0
    worst = 0.0
    for name, pattern in itertools.islice(patterns(args.data, 60), 12):
        sheet = Sheet(pattern, paper="roll")
        boxes = 1e3 * np.array([list(piece.box) for piece in sheet.pieces])
        size = (boxes[:, 2:].max(0) - boxes[:, :2].min(0))[::-1]
        with tempfile.NamedTemporaryFile(suffix=".plt") as file:
            file.write(sheet.plt_bytes(hpgl2=0, by_piece=1))
            file.flush()
            told = subprocess.run(["hp2xx", "-t", "-m", "svg", "-f", "/dev/null", file.name], capture_output=True,
                                  text=True, check=False)
        found = re.search(r"height: ([\d.]+) x ([\d.]+) mm", told.stdout + told.stderr)
        off = np.abs(np.array(found.groups(), float) - size).max() if found else math.inf
        count, bad, worst = count + 1, bad + (off > PLOT_MM), max(worst, off)
    print(f"plots: hp2xx draws {count - bad} of {count} sheets at true size, within {worst:.3f} mm")
    return bad == 0


def drawing_faults(pattern, again):
    """What an SVG lost of a pattern, and how far its edges are off [mm]. Edges come back in the order of the panels."""
    if pattern.panels != again.panels or pattern.edge_count != again.edge_count:
        return ["panels or edges"], 0.0
    order = sorted(range(pattern.edge_count), key=lambda e: (pattern.get("edge_panel", e), e))
    place, worst, faults = {e: i for i, e in enumerate(order)}, 0.0, []
    for edge, new in place.items():
        old, line = (1e3 * np.array(p.edge_polyline(e, 16)) for p, e in ((pattern, edge), (again, new)))
        worst = max(worst, np.abs(old - line).max() if old.shape == line.shape else math.inf)
        for what in ("edge_name", "edge_label"):
            if pattern.get(what, edge) != again.get(what, new):
                faults.append(f"edge {edge}: {what}")
        if abs((pattern.edge_allowance(edge) or 0.0) - (again.edge_allowance(new) or 0.0)) > 1e-9:
            faults.append(f"edge {edge}: allowance")
    for panel in range(len(pattern.panels)):
        if [(place[e], d) for e, d in pattern.outline(panel)] != list(again.outline(panel)):
            faults.append(f"panel {panel}: outline")
        turned = np.abs(np.subtract(pattern.grain(panel), again.grain(panel))).max() > 1e-6
        if pattern.cut(panel) != again.cut(panel) or turned:
            faults.append(f"panel {panel}: cut or grain")
    for i in range(min(pattern.seam_count, again.seam_count)):
        old, new = pattern.seam(i), again.seam(i)
        same = all(bool(old[k]) == bool(new[k]) for k in ("direction", "laid", "closure", "open"))
        if (place[old["edge_a"]], place[old["edge_b"]]) != (new["edge_a"], new["edge_b"]) or not same \
                or abs(old["ease"] - new["ease"]) > 1e-9:
            faults.append(f"seam {i}")
    notches = sorted((place[e], s, k) for e, s, k in pattern.notches()), sorted(again.notches())
    if any(a[0] != b[0] or abs(a[1] - b[1]) > 1e-8 or a[2] != b[2] for a, b in zip(*notches)):
        faults.append("notches")
    if [len(n) for n in notches] != 2 * [len(notches[0])] or len(pattern.marks()) != len(again.marks()) \
            or pattern.seam_count != again.seam_count:
        faults.append("number of seams, notches or marks")
    return faults, worst


def drawings(args):
    count, bad, worst = 0, 0, 0.0
    for name, pattern in patterns(args.data, args.every):
        faults, off = drawing_faults(pattern, Pattern.parse(pattern.svg_bytes(), name="drawing.svg"))
        count, bad, worst = count + 1, bad + bool(faults or off > OUTLINE_MM), max(worst, off)
        if args.list and faults:
            print(f"  {name}: " + "; ".join(faults[:3]))
    print(f"drawings: {count - bad} of {count} patterns come back from an SVG, edges within {worst:.4f} mm")
    return bad == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--every", type=int, default=1, help="take every n-th pattern")
    parser.add_argument("--valentina", type=pathlib.Path, help="folder of its examples",
                        default=pathlib.Path("/usr/share/doc/valentina/examples/collection"))
    parser.add_argument("--list", action="store_true", help="print every fault")
    args = parser.parse_args()
    return 0 if all([round_trip(args), valentina(args.data), tools(args), rules(), plots(args), garmentcode(args), drawings(args)]) else 1


if __name__ == "__main__":
    sys.exit(main())
