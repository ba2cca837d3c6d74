"""edit.py: a drawn pattern changed as on the cutting table; what a Pattern can do by muslin/edit.h.

Every method leaves the pattern as it was when it raises. Numbers of panels, edges, points and seams are new after each
call: find them again by name, or use what the call gives back.
"""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrays import doubles, integers
from .context import make_def, read_struct, text

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ._types import Numbers

_PIECES = {"line": _abi.MUS_PIECE_LINE, "quadratic": _abi.MUS_PIECE_QUADRATIC, "cubic": _abi.MUS_PIECE_CUBIC,
           "arc": _abi.MUS_PIECE_ARC}


def _chain(pieces: Sequence[str], points: Numbers) -> tuple[Any, ...]:
    """npiece, kinds, nxy, xy of a chain without its ends; no pieces is a straight line."""
    kinds, count = integers([_PIECES.get(piece, piece) for piece in pieces])
    places, n = doubles(points, 2)
    return count, kinds, n, places


def _cut(edge_a: int, s_a: float, edge_b: int, s_b: float, name: str, seam_name: str, pieces: Sequence[str],
         points: Numbers) -> Any:
    """mus_cut_def: the line from place a to place b."""
    count, kinds, n, places = _chain(pieces, points)
    return make_def(_abi.mus_cut_def, lib.mus_cut_def_init,
                    {"name": name, "seam_name": seam_name, "edge_a": edge_a, "s_a": s_a, "edge_b": edge_b, "s_b": s_b,
                     "npiece": count, "kinds": kinds, "nxy": n, "xy": places})


class Edits:
    """Edits of a pattern, with undo and redo."""

    # ---- history ----

    def keep_history(self, depth: int = 100) -> None:
        """Keep what the pattern was before each of the last `depth` edits."""
        self.do("keep_history", depth)

    def undo(self) -> None:
        self.do("undo")

    def redo(self) -> None:
        self.do("redo")

    @property
    def history(self) -> tuple[int, int]:
        """How many edits can be undone and redone."""
        return self.get("undo_count"), self.get("redo_count")

    # ---- darts ----

    def dart(self, leg: int) -> tuple[float, float, float]:
        """(angle [rad], width of the mouth [m], depth [m]) of the dart with an edge as leg."""
        values = [ctypes.c_double() for _ in range(3)]
        self.do("dart", leg, *map(ctypes.byref, values))
        return tuple(value.value for value in values)

    def add_dart(self, edge: int, s: float, width: float, point: Numbers) -> int:
        """A dart on an edge about arc length s; a leg of it."""
        return self._made("add_dart", edge, s, width, doubles(point, 2)[0])

    def rotate_dart(self, leg: int, target: int, s: float, keep: int, fraction: float = 1.0) -> int:
        """Pivot a dart to arc length s of edge `target`; the part with edge `keep` stays. A leg of the new dart."""
        return self._made("rotate_dart", leg, target, s, keep, fraction)

    def split_dart(self, leg: int, targets: Sequence[tuple[int, float, float]], keep: int) -> list[int]:
        """Split a dart: targets [(edge, s, fraction)]; legs of the new darts in that order."""
        edges, n = integers([target[0] for target in targets])
        places, _ = doubles([target[1] for target in targets])
        fractions, _ = doubles([target[2] for target in targets])
        out = (ctypes.c_int32 * n)()
        self.do("split_dart", leg, n, edges, places, fractions, keep, out)
        return list(out)

    def merge_darts(self, leg: int, into: int, keep: int) -> int:
        """Close a dart into another with the same point."""
        return self._made("merge_darts", leg, into, keep)

    def shorten_dart(self, leg: int, back: float) -> None:
        """The point of a dart `back` nearer to its mouth."""
        self.do("shorten_dart", leg, back)

    def release_dart(self, leg: int) -> int:
        """Forget a dart: its cloth is gathered or eased. The edge that has its mouth."""
        return self._made("release_dart", leg)

    def dart_to_seam(self, leg: int, target: int, s: float, name: str, seam_name: str, pieces: Sequence[str] = (),
                     points: Numbers = ()) -> tuple[int, int]:
        """A dart becomes part of a seam that goes on to arc length s of edge `target`: (panel, seam)."""
        cut = _cut(leg, 0.0, target, s, name, seam_name, pieces, points)
        return self._made_two("dart_to_seam", ctypes.byref(cut))

    # ---- panels ----

    def separate(self, edge_a: int, s_a: float, edge_b: int, s_b: float, name: str, seam_name: str,
                 pieces: Sequence[str] = (), points: Numbers = ()) -> tuple[int, int]:
        """Cut a panel along a chain from place a to place b: (panel, seam)."""
        cut = _cut(edge_a, s_a, edge_b, s_b, name, seam_name, pieces, points)
        return self._made_two("separate", ctypes.byref(cut))

    def join_panels(self, seam: int) -> int:
        """The two panels of a seam become one."""
        return self._made("join_panels", seam)

    def mirror_panel(self, panel: int, name: str) -> int:
        return self._made("mirror_panel", panel, text(name))

    def unfold(self, fold: int) -> None:
        """A panel and its mirror image in a straight edge become one."""
        self.do("unfold", fold)

    def add_facing(self, edge: int, width: float, name: str) -> int:
        """A facing sewn to a free edge."""
        return self._made("add_facing", edge, width, text(name))

    def add_patch(self, panel: int, name: str, points: Numbers) -> int:
        """A patch sewn onto a panel along a line of points inside it, open between the ends of the line: its panel."""
        places, n = doubles(points, 2)
        return self._made("add_patch", panel, text(name), n, places)

    def remove_panel(self, panel: int) -> None:
        self.do("remove_panel", panel)

    def remove_seam(self, seam: int) -> None:
        self.do("remove_seam", seam)

    # ---- fullness and length ----

    def spread(self, edge_a: int, s_a: float, edge_b: int, s_b: float, w_a: float, w_b: float) -> None:
        """Slash from place a to place b and open it by w_a and w_b."""
        self.do("spread", edge_a, s_a, edge_b, s_b, w_a, w_b)

    def flare(self, hem: int, hinge: int, n: int, amount: float) -> None:
        """Open a hem by `amount` in n even slashes that are hinged at another edge."""
        self.do("flare", hem, hinge, n, amount)

    def pleat(self, edge_a: int, s_a: float, edge_b: int, s_b: float, depth_a: float, depth_b: float) -> None:
        self.do("pleat", edge_a, s_a, edge_b, s_b, depth_a, depth_b)

    def lay_pleats(self, edge: int, places: Numbers, depths: Numbers) -> None:
        """Lay pleats on an edge: outer folds at arc lengths, each so deep, under what comes before it (depth > 0) or
        after it."""
        s, n = doubles(places)
        self.do("lay_pleats", edge, n, s, doubles(depths)[0])

    def lengthen(self, panel: int, point: Numbers, direction: Numbers, amount: float) -> None:
        """What lies left of the line through `point` along `direction` moves by `amount`."""
        self.do("lengthen", panel, doubles(point, 2)[0], doubles(direction, 2)[0], amount)

    # ---- points and edges ----

    def move_point(self, point: int, x: float, y: float) -> None:
        self.do("move_point", point, x, y)

    def move_control(self, edge: int, index: int, x: float, y: float) -> None:
        """Point `index` of an edge's chain, its ends not counted out."""
        self.do("move_control", edge, index, x, y)

    def redraw_edge(self, edge: int, pieces: Sequence[str] = ("line",), points: Numbers = ()) -> None:
        self.do("redraw_edge", edge, *_chain(pieces, points))

    def fair_edge(self, edge: int, within: float = 0.005) -> None:
        """Draw an edge with corners again as one smooth line that stays `within` [m] of it."""
        self.do("fair_edge", edge, within)

    def split_edge(self, edge: int, s: float, name: str | None = None) -> int:
        return self._made("split_edge", edge, s, text(name))

    def merge_edges(self, edge: int) -> int:
        """One edge of this and the next in the outline."""
        return self._made("merge_edges", edge)

    # ---- seams ----

    def walk_seam(self, seam: int) -> dict[str, Any]:
        """The two sides of a seam walked along each other (mus_seam_walk as a dict)."""
        walk = make_def(_abi.mus_seam_walk, lib.mus_seam_walk_init)
        self.do("walk_seam", seam, ctypes.byref(walk))
        return read_struct(walk)

    def true_seam(self, seam: int, edge: int, at_end: bool = True) -> None:
        """One end of an edge of the seam moves until the seam is true."""
        self.do("true_seam", seam, edge, 1 if at_end else 0)

    def notch_seam(self, edge: int, s: float, kind: int = 1) -> None:
        """Put a notch on an edge at arc length s [m], and on every edge that is sewn to it."""
        self.do("notch_seam", edge, s, kind)

    def _made(self, function: str, *arguments: Any) -> int:
        index = ctypes.c_int32()
        self.do(function, *arguments, ctypes.byref(index))
        return index.value

    def _made_two(self, function: str, *arguments: Any) -> tuple[int, int]:
        panel, seam = ctypes.c_int32(), ctypes.c_int32()
        self.do(function, *arguments, ctypes.byref(panel), ctypes.byref(seam))
        return panel.value, seam.value
