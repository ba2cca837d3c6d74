"""layout.py: pieces on the cloth: where each is cut, and how many metres that takes."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrays import doubles, view
from .context import Context, Object, create, make_def, taken_bytes, text
from .pattern import _MATERIALS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from ._types import PathLike
    from .pattern import Pattern


class Layout(Object):
    """The pieces of one material of a pattern on cloth. material: "main", "lining", "interfacing" or "rib"; options:
    width [m], gap, allowance, fold, nap, tolerance [rad], stripe, steps, runs, threads, seed (mus_layout_def).
    progress(done, length) may return True to end the search with the best layout so far."""

    _kind = "layout"

    def __init__(self, pattern: Pattern, material: str = "main",
                 progress: Callable[[float, float], Any] | None = None, **options: Any) -> None:
        if material not in _MATERIALS:
            raise ValueError(f"material is one of {', '.join(_MATERIALS)}, not {material!r}")
        self._make(pattern.context, "mus_layout_create", (pattern.handle,), progress,
                   {"material": _MATERIALS[material], **options})

    @classmethod
    def of_outlines(cls, outlines: Iterable[Mapping[str, Any]], context: Context | None = None,
                    progress: Callable[[float, float], Any] | None = None, **options: Any) -> "Layout":
        """Outlines on open cloth: a dict each, with xy (n x 2), and count (1), turns (a list of angles [rad]; without
        it as drawn, and by half a turn without nap)."""
        kept, items = [], []
        for outline in outlines:
            unknown = set(outline) - {"xy", "count", "turns"}
            if unknown or "xy" not in outline:
                raise TypeError(f"an outline has xy, count, turns, not {', '.join(sorted(unknown)) or 'no xy'}")
            (xy, n), (turns, turn_count) = doubles(outline["xy"], 2), doubles(outline.get("turns", ()))
            kept += [xy, turns]
            items.append(make_def(_abi.mus_layout_item, lib.mus_layout_item_init,
                                  {"n": n, "xy": ctypes.cast(xy, ctypes.POINTER(ctypes.c_double)),
                                   "count": outline.get("count", 1), "turn_count": turn_count,
                                   "turns": ctypes.cast(turns, ctypes.POINTER(ctypes.c_double))}))
        layout = cls.__new__(cls)
        array = (_abi.mus_layout_item * len(items))(*items)
        layout._make(context or Context.of_thread(), "mus_layout_create_items", (len(items), array), progress, options)
        return layout

    def _make(self, context: Context, function: str, what: tuple[Any, ...],
              progress: Callable[[float, float], Any] | None, options: Mapping[str, Any]) -> None:
        raised: list[BaseException] = []

        def hook(_, done, length):
            try:
                return 1 if progress(done, length) else 0
            except BaseException as error:  # an exception cannot pass through C: end the search, and raise it after
                raised.append(error)
                return 1

        definition = make_def(_abi.mus_layout_def, lib.mus_layout_def_init, options)
        if progress is not None:
            definition.progress = _abi.mus_layout_progress_fn(hook)
        super().__init__(context, create(context, "layout", function, context.handle, *what,
                                         ctypes.byref(definition)))
        if raised:
            raise raised[0]

    def _told(self) -> str:
        return (f"{len(self.pieces)} pieces, {self.length:.2f} m of {self.width:.2f} m, "
                f"{100 * self.utilisation:.1f} % used")

    def _repr_svg_(self) -> str:
        """The layout, for a notebook."""
        return self.svg_bytes().decode()

    @property
    def width(self) -> float:
        """Width of the cloth [m]."""
        return self.get("width")

    @property
    def length(self) -> float:
        """Length of cloth that the layout takes [m]."""
        return self.get("length")

    @property
    def folded(self) -> float:
        """Length of the folded part [m]."""
        return self.get("folded")

    @property
    def utilisation(self) -> float:
        """Part of the cloth that the pieces cover, 0 to 1."""
        return self.get("utilisation")

    @property
    def steps(self) -> int:
        """Elementary steps that the search took."""
        return self.get("steps")

    @property
    def pieces(self) -> list[Any]:
        """The pieces as structs (panel, name, mirrored, turned, layers, on_fold, spare, turn, shift)."""
        pieces = []
        for index in range(self.get("piece_count")):
            piece = make_def(_abi.mus_layout_piece, lib.mus_layout_piece_init)
            self.do("piece_get", index, ctypes.byref(piece))
            pieces.append(piece)
        return pieces

    @property
    def outlines(self) -> list[Any]:
        """The cut line of each piece on the cloth (n x 2) [m]: views."""
        return [view(self, piece.xy, piece.n, 2) for piece in self.pieces]

    def write_svg(self, path: PathLike) -> None:
        self.do("write_svg", text(path))

    def svg_bytes(self) -> bytes:
        """The SVG as bytes."""
        return taken_bytes(self.context, "mus_layout_write_svg_bytes", self.handle)
