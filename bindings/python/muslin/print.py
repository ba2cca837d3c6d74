"""print.py: ready-to-cut paper."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Mapping

from . import _abi
from ._library import lib
from .context import Object, create, make_def, taken_bytes, text

if TYPE_CHECKING:
    from ._types import PathLike
    from .pattern import Pattern

_PAPERS = {name[len("MUS_PAPER_"):].lower(): value for name, value in vars(_abi).items()
           if name.startswith("MUS_PAPER_")}


class Sheet(Object):
    """The pieces of a pattern laid out. paper: "a4", "letter", "a3", "a0" or "roll"; options: allowance, margin,
    overlap, title, person, fold, language, notes (mus_sheet_def)."""

    _kind = "sheet"

    def __init__(self, pattern: Pattern, paper: str = "a4", **options: Any) -> None:
        if paper not in _PAPERS:
            raise ValueError(f"paper is one of {', '.join(_PAPERS)}, not {paper!r}")
        definition = make_def(_abi.mus_sheet_def, lib.mus_sheet_def_init, {"paper": _PAPERS[paper], **options})
        context = pattern.context
        super().__init__(context, create(context, "sheet", "mus_sheet_create", context.handle, pattern.handle,
                                         ctypes.byref(definition)))

    @classmethod
    def of_sizes(cls, patterns: Mapping[str, Pattern], paper: str = "a4", **options: Any) -> "Sheet":
        """The same pattern in several sizes, by the name of each, one on the other."""
        if paper not in _PAPERS:
            raise ValueError(f"paper is one of {', '.join(_PAPERS)}, not {paper!r}")
        if not patterns:
            raise ValueError("no size is given")
        definition = make_def(_abi.mus_sheet_def, lib.mus_sheet_def_init, {"paper": _PAPERS[paper], **options})
        context = next(iter(patterns.values())).context
        handles = [ctypes.cast(pattern.handle, ctypes.POINTER(_abi.mus_pattern)) for pattern in patterns.values()]
        names = (ctypes.c_char_p * len(handles))(*[text(name) for name in patterns])
        sheet = cls.__new__(cls)
        Object.__init__(sheet, context, create(context, "sheet", "mus_sheet_create_sizes", context.handle, len(handles),
                                               (ctypes.POINTER(_abi.mus_pattern) * len(handles))(*handles), names,
                                               ctypes.byref(definition)))
        return sheet

    def _told(self) -> str:
        width, height = self.extent
        return f"{self.page_count} pages, {len(self.pieces)} pieces, {width:.2f} x {height:.2f} m"

    def _repr_svg_(self) -> str:
        """The sheet, for a notebook."""
        return self.svg_bytes().decode()

    @property
    def page_count(self) -> int:
        return self.get("page_count")

    @property
    def grid(self) -> tuple[int, int]:
        """(columns, rows) of tiles."""
        return self.get("columns"), self.get("rows")

    @property
    def extent(self) -> tuple[float, float]:
        """(width, height) of the sheet [m]."""
        extent = (ctypes.c_double * 2)()
        self.do("extent", extent)
        return tuple(extent)

    def page(self, page: int) -> tuple[float, float, float, float]:
        """(x, y, width, height) [m]: where a page shows the sheet."""
        place = (ctypes.c_double * 4)()
        self.do("page", page, place)
        return tuple(place)

    def write_pdf(self, path: PathLike) -> None:
        self.do("write_pdf", text(path))

    def write_svg(self, path: PathLike) -> None:
        self.do("write_svg", text(path))

    def pdf_bytes(self) -> bytes:
        """The PDF as bytes."""
        return taken_bytes(self.context, "mus_sheet_write_pdf_bytes", self.handle)

    def svg_bytes(self) -> bytes:
        """The SVG as bytes."""
        return taken_bytes(self.context, "mus_sheet_write_svg_bytes", self.handle)

    def write_dxf(self, path: PathLike, dialect: str = "astm", **options: Any) -> None:
        """Write DXF R12 for cutters and CAD. dialect: "aama" or "astm"; options: size_name, date, sew (True: layer 1 is
        the sew line), nested, and sizes: a dict of further sizes, name to Sheet."""
        self.do("write_dxf", ctypes.byref(self._dxf(dialect, **options)), text(path))

    def dxf_bytes(self, dialect: str = "astm", **options: Any) -> bytes:
        """The DXF as bytes."""
        return taken_bytes(self.context, "mus_sheet_write_dxf_bytes", self.handle,
                           ctypes.byref(self._dxf(dialect, **options)))

    def write_rul(self, path: PathLike, dialect: str = "astm", **options: Any) -> None:
        """Write the grade rules of `sizes`, as write_dxf() takes them, as a RUL file."""
        self.do("write_rul", ctypes.byref(self._dxf(dialect, **options)), text(path))

    def rul_bytes(self, dialect: str = "astm", **options: Any) -> bytes:
        """The RUL file as bytes."""
        return taken_bytes(self.context, "mus_sheet_write_rul_bytes", self.handle,
                           ctypes.byref(self._dxf(dialect, **options)))

    def write_plt(self, path: PathLike, **options: Any) -> None:
        """Write HPGL for a plotter or cutter. options: hpgl2, by_piece (for a cutter), one_pen (mus_sheet_plt)."""
        self.do("write_plt", ctypes.byref(make_def(_abi.mus_sheet_plt, lib.mus_sheet_plt_init, options)), text(path))

    def plt_bytes(self, **options: Any) -> bytes:
        """The HPGL as bytes."""
        return taken_bytes(self.context, "mus_sheet_write_plt_bytes", self.handle,
                           ctypes.byref(make_def(_abi.mus_sheet_plt, lib.mus_sheet_plt_init, options)))

    @staticmethod
    def _dxf(dialect: str, sew: bool = False, sizes: Any = (), **options: Any) -> Any:
        dialects = {"aama": _abi.MUS_DXF_AAMA, "astm": _abi.MUS_DXF_ASTM}
        if dialect not in dialects:
            raise ValueError(f"dialect is one of {', '.join(dialects)}, not {dialect!r}")
        definition = make_def(_abi.mus_sheet_dxf, lib.mus_sheet_dxf_init,
                              {"dialect": dialects[dialect], "boundary": int(sew), "size_count": len(sizes), **options})
        sizes = dict(sizes)
        handles = [ctypes.cast(sheet.handle, ctypes.POINTER(_abi.mus_sheet)) for sheet in sizes.values()]
        definition.sheets = (ctypes.POINTER(_abi.mus_sheet) * len(sizes))(*handles)
        definition.size_names = (ctypes.c_char_p * len(sizes))(*[text(name) for name in sizes])
        return definition

    @property
    def pieces(self) -> list[Any]:
        """The pieces as structs (panel, name, copies, mirrored, fold, turn, shift, box, size_index)."""
        return [self._struct("piece", i) for i in range(lib.mus_sheet_piece_count(self.handle))]

    @property
    def lines(self) -> list[tuple[int, int, int, str, list[tuple[float, float]]]]:
        """Every line that is drawn: (piece, kind, edge, ops, points); ops is text of m, l, c, z, points are (x, y) [m].
        kind: 0 cut, 1 sew, 2 notch, 3 grain, 4 mark, 5 label (MUS_LINE_*); edge: of the pattern, or -1."""
        lines = []
        for i in range(lib.mus_sheet_line_count(self.handle)):
            line = self._struct("line", i)
            points = [tuple(line.points[2 * k:2 * k + 2]) for k in range(line.point_count)]
            lines.append((line.piece, line.kind, line.edge, bytes(line.ops[:line.op_count]).decode(), points))
        return lines

    def _struct(self, noun: str, index: int) -> Any:
        struct = make_def(getattr(_abi, f"mus_sheet_{noun}"), getattr(lib, f"mus_sheet_{noun}_init"))
        self.do(f"{noun}_get", index, ctypes.byref(struct))
        return struct
