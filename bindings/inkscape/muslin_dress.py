"""Muslin > Dress what is drawn: closed paths become panels, marks tell the seams; a model and pages are written.

A closed path with the label panel:NAME is a panel, seen from outside; front or back in its name tells its side. Its
edges end at its corners. An open path with one of these labels marks the edge that lies nearest to its middle:

    seam:NAME     two edges with the same name are sewn together
    hold:LEVEL    the edge is held at a level of the body (waist, hip ...)
    open:NAME     the edge is part of an opening (hem, neck, waist ...)
"""
import math
import os
import sys

import inkex

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import muslin  # noqa: E402
from muslin_draft import tape_of  # noqa: E402

SMOOTH = math.radians(30)  # a node that turns less does not end an edge
SAME = 1e-5                # [m] points that are one


def pieces_of(path, scale):
    """[(points)] of a path: chords of two points and cubics of four, in metre with y up, without empty ones."""
    made = []
    for sub in path.to_superpath():
        nodes = [[(x * scale, -y * scale) for x, y in node] for node in sub]
        for (_, start, out), (into, end, _) in zip(nodes, nodes[1:]):
            if math.dist(start, end) < SAME:
                continue
            chord = math.dist(start, end)
            away = max(abs((p[0] - start[0]) * (end[1] - start[1]) - (p[1] - start[1]) * (end[0] - start[0])) / chord
                       for p in (out, into))
            made.append([start, end] if away < SAME else [start, out, into, end])
    return made


def turn(a, b):
    """Angle between the end of a piece and the beginning of the next [rad]."""
    def direction(points):
        return next(math.atan2(q[1] - p[1], q[0] - p[0]) for p, q in zip(points, points[1:]) if math.dist(p, q) > SAME)
    last = direction(a[::-1])
    return abs((direction(b) - (last + math.pi) + math.pi) % (2 * math.pi) - math.pi)


def edges_of(pieces):
    """Pieces of a closed outline, counterclockwise, as edges between its corners."""
    corners = [piece[0] for piece in pieces]
    if sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(corners, corners[1:] + corners[:1])) < 0:
        pieces = [piece[::-1] for piece in pieces[::-1]]
    cut = [i for i in range(len(pieces)) if turn(pieces[i - 1], pieces[i]) > SMOOTH] or [0]
    turned = pieces[cut[0]:] + pieces[:cut[0]]
    edges = []
    for i, piece in enumerate(turned):
        if (i + cut[0]) % len(pieces) in cut or not edges:
            edges.append([])
        edges[-1].append(piece)
    return edges if len(edges) > 1 else [edges[0][:len(edges[0]) // 2], edges[0][len(edges[0]) // 2:]]


def points_along(pieces):
    """Points of an edge, eight a piece."""
    for piece in pieces:
        for k in range(9):
            t = k / 8
            row = piece
            while len(row) > 1:
                row = [((1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1]) for p, q in zip(row, row[1:])]
            yield row[0]


class Drawn:
    """The pattern that a drawing stands for."""

    def __init__(self, name):
        self.pattern = muslin.Pattern(name)
        self.edges = []  # (number, points along it)

    def add_panel(self, name, pieces):
        pattern, edges = self.pattern, edges_of(pieces)
        panel = pattern.add_panel(name)
        points = [pattern.add_point(panel, *edge[0][0]) for edge in edges]
        numbers = []
        for i, edge in enumerate(edges):
            inner = [p for piece in edge for p in piece[1:]][:-1]
            kinds = ["line" if len(piece) == 2 else "cubic" for piece in edge]
            numbers.append(pattern.add_edge(points[i], points[(i + 1) % len(edges)], kinds, inner, f"{name}{i}"))
            self.edges.append((numbers[-1], list(points_along(edge))))
        pattern.set_outline(panel, numbers)
        sides = [side for side in ("front", "back") if side in name.lower()]
        if sides:
            pattern.set_sides(panel, *sides)

    def nearest(self, pieces):
        """The edge that lies nearest to the middle of a mark."""
        along = list(points_along(pieces))
        middle = along[len(along) // 2]
        return min(self.edges, key=lambda edge: min(math.dist(point, middle) for point in edge[1]))[0]

    def mark(self, marks):
        """Seams, holds and openings of [(label, pieces)]."""
        seams = {}
        for label, pieces in marks:
            kind, _, name = label.partition(":")
            edge = self.nearest(pieces)
            if kind == "seam":
                seams.setdefault(name, []).append(edge)
            elif kind == "hold":
                self.pattern.set_hold(edge, name)
                self.pattern.set_label(edge, name)
            else:
                self.pattern.set_label(edge, name)
        for name, edges in seams.items():
            if len(edges) != 2 or edges[0] == edges[1]:
                raise inkex.AbortExtension(f"seam:{name} marks {len(set(edges))} edges; expected two")
            self.pattern.add_seam(*edges)


class Dress(inkex.EffectExtension):
    def add_arguments(self, pars):
        for name in ("--size", "--tape", "--fabric", "--glb", "--pdf"):
            pars.add_argument(name, default="W40" if name == "--size" else "")
        pars.add_argument("--spacing", type=float, default=20.0)

    def drawn(self):
        scale = 0.001 / self.svg.unittouu("1mm")
        made, marks = Drawn("drawing"), []
        for element in self.svg.xpath("//svg:path|//svg:rect|//svg:polygon|//svg:polyline|//svg:line"):
            label = element.get("inkscape:label") or element.get_id()
            pieces = pieces_of(element.path.transform(element.composed_transform()), scale)
            if label.startswith("panel:") and len(pieces) > 1:
                made.add_panel(label[len("panel:"):], pieces)
            elif label.split(":")[0] in ("seam", "hold", "open") and pieces:
                marks.append((label, pieces))
        if not made.edges:
            raise inkex.AbortExtension("no closed path has a label panel:NAME (Object > Object properties)")
        made.mark(marks)
        return made.pattern

    def effect(self):
        pattern = self.drawn()
        try:
            body = muslin.Body(tape_of(self.options))
            muslin.arrange(pattern, body)
            worn = muslin.dress(pattern, body, self.options.fabric or None, spacing=self.options.spacing / 1000)
            if self.options.glb:
                coarse = body.remade(samples=32, ring_spacing=0.025)
                muslin.write_glb(self.options.glb, worn.meshes(body=coarse))
            if self.options.pdf:
                muslin.Sheet(pattern).write_pdf(self.options.pdf)
        except muslin.MuslinError as error:
            raise inkex.AbortExtension(error.text)
        self.msg(f"{worn!r}\n" + "\n".join(f"{level['level']}: body {100 * level['body']:.1f} cm, garment "
                                           f"{100 * level['garment']:.1f} cm" for level in worn.fit().levels))


if __name__ == "__main__":
    Dress().run()
