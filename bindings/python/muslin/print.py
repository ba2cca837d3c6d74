"""print.py: ready-to-cut paper."""
import ctypes

from . import _abi
from ._library import lib
from .context import Object, create, make_def, text

_PAPERS = {name[len("MUS_PAPER_"):].lower(): value for name, value in vars(_abi).items()
           if name.startswith("MUS_PAPER_")}


class Sheet(Object):
    """The pieces of a pattern laid out. paper: "a4", "letter", "a3", "a0" or "roll"; options: allowance, margin,
    overlap, title, person (mus_sheet_def)."""

    _kind = "sheet"

    def __init__(self, pattern, paper="a4", **options):
        if paper not in _PAPERS:
            raise ValueError(f"paper is one of {', '.join(_PAPERS)}, not {paper!r}")
        definition = make_def(_abi.mus_sheet_def, lib.mus_sheet_def_init, {"paper": _PAPERS[paper], **options})
        context = pattern.context
        super().__init__(context, create(context, "sheet", "mus_sheet_create", context.handle, pattern.handle,
                                         ctypes.byref(definition)))

    @property
    def page_count(self):
        return self.get("page_count")

    @property
    def grid(self):
        """(columns, rows) of tiles."""
        return self.get("columns"), self.get("rows")

    @property
    def extent(self):
        """(width, height) of the sheet [m]."""
        extent = (ctypes.c_double * 2)()
        self.do("extent", extent)
        return tuple(extent)

    def page(self, page):
        """(x, y, width, height) [m]: where a page shows the sheet."""
        place = (ctypes.c_double * 4)()
        self.do("page", page, place)
        return tuple(place)

    def write_pdf(self, path):
        self.do("write_pdf", text(path))

    def write_svg(self, path):
        self.do("write_svg", text(path))
