"""pattern.py: a sewing pattern as a cell complex: points, edges, panels, and seams between edges."""
from __future__ import annotations

import ctypes
import math
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrays import doubles, integers, result
from .context import Context, Valued, create, make_def, read_struct, taken_bytes, text
from .edit import Edits
from .topology import Topology

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ._types import Array, Numbers, PathLike

_PIECES = {"line": _abi.MUS_PIECE_LINE, "quadratic": _abi.MUS_PIECE_QUADRATIC, "cubic": _abi.MUS_PIECE_CUBIC,
           "arc": _abi.MUS_PIECE_ARC}
_MATERIALS = {"main": _abi.MUS_MATERIAL_MAIN, "lining": _abi.MUS_MATERIAL_LINING,
              "interfacing": _abi.MUS_MATERIAL_INTERFACING, "rib": _abi.MUS_MATERIAL_RIB,
              "elastic": _abi.MUS_MATERIAL_ELASTIC}
_SIDES = {"front": _abi.MUS_SIDE_FRONT, "back": _abi.MUS_SIDE_BACK, "left": _abi.MUS_SIDE_LEFT,
          "right": _abi.MUS_SIDE_RIGHT}


class Pattern(Topology, Edits, Valued):
    """A pattern. Cells are numbers that stay until the next of its Edits: panels, points, edges, seams from 0. Patterns
    that write() writes as the same file are equal."""

    _kind = "pattern"

    def __init__(self, name: str = "pattern", context: Context | None = None, _handle: Any = None) -> None:
        context = context or Context.of_thread()
        super().__init__(context,
                         _handle or create(context, "pattern", "mus_pattern_create", context.handle, text(name)))

    @classmethod
    def read(cls, path: PathLike, context: Context | None = None) -> Pattern:
        """From a file: muslin JSON, a GarmentCode specification, a FreeSewing dump or a DXF in its sample size."""
        context = context or Context.of_thread()
        return cls(context=context,
                   _handle=create(context, "pattern", "mus_pattern_read", context.handle, text(path)))

    @classmethod
    def parse(cls, data: str | bytes, name: str = "pattern.json", context: Context | None = None) -> Pattern:
        """From the text of a file (str or bytes); `name` stands for the path in messages."""
        context = context or Context.of_thread()
        data = text(data)
        return cls(context=context, _handle=create(context, "pattern", "mus_pattern_read_from", context.handle, data,
                                                   len(data), text(name)))

    @classmethod
    def read_dxf(cls, path: PathLike, rules: PathLike | None = None, size: str | None = None,
                 context: Context | None = None) -> Pattern:
        """From a DXF (AAMA, ASTM) in one size, None: its sample size; `rules` is the path of its RUL file."""
        return cls._from_dxf(context, {"path": text(path), "rules_path": text(rules), "size_name": text(size)})

    @classmethod
    def parse_dxf(cls, data: str | bytes, rules: str | bytes | None = None, size: str | None = None,
                  name: str = "pattern.dxf", context: Context | None = None) -> Pattern:
        """read_dxf() of the bytes of a DXF and of its RUL file."""
        data, rules = text(data), text(rules)
        options = {"path": text(name), "text": data, "text_size": len(data), "size_name": text(size)}
        if rules is not None:
            options.update({"rules_path": text(name + ".rul"), "rules": rules, "rules_size": len(rules)})
        return cls._from_dxf(context, options)

    @classmethod
    def _from_dxf(cls, context: Context | None, options: dict[str, Any]) -> Pattern:
        context = context or Context.of_thread()
        source = make_def(_abi.mus_pattern_dxf, lib.mus_pattern_dxf_init, options)
        return cls(context=context, _handle=create(context, "pattern", "mus_pattern_read_dxf", context.handle,
                                                   ctypes.byref(source)))

    @classmethod
    def read_val(cls, path: PathLike, measures: PathLike | None = None, size: str | None = None,
                 context: Context | None = None) -> Pattern:
        """From a pattern of Valentina or Seamly (.val, .sm2d) with its measurements (.vit, .smis, or a .vst and a size
        "500_1760")."""
        context = context or Context.of_thread()
        options = {"path": text(path), "measures_path": text(measures), "size_name": text(size)}
        source = make_def(_abi.mus_pattern_val, lib.mus_pattern_val_init, options)
        return cls(context=context, _handle=create(context, "pattern", "mus_pattern_read_val", context.handle,
                                                   ctypes.byref(source)))

    def write(self, path: PathLike) -> None:
        """Write as muslin JSON; reading it back gives the same pattern, bit for bit."""
        self.context.call("mus_pattern_write", self.handle, text(path))

    def to_bytes(self) -> bytes:
        """The bytes that write() would write."""
        return taken_bytes(self.context, "mus_pattern_write_bytes", self.handle)

    def write_garmentcode(self, path: PathLike) -> None:
        """Write as a GarmentCode specification."""
        self.context.call("mus_pattern_write_garmentcode", self.handle, text(path))

    def garmentcode_bytes(self) -> bytes:
        """The bytes that write_garmentcode() would write."""
        return taken_bytes(self.context, "mus_pattern_write_garmentcode_bytes", self.handle)

    def write_svg(self, path: PathLike) -> None:
        """Write as an SVG that drawing programs edit and read() reads back."""
        self.context.call("mus_pattern_write_svg", self.handle, text(path))

    def svg_bytes(self) -> bytes:
        """The bytes that write_svg() would write."""
        return taken_bytes(self.context, "mus_pattern_write_svg_bytes", self.handle)

    def write_instructions(self, path: PathLike, title: str | None = None, language: str | None = None) -> None:
        """Write how the pattern is sewn, as plain text: pieces, notions, and the steps in their order. title: the first
        line, default the name of the pattern. language: "de", "pt_BR" ..., default English."""
        self.context.call("mus_pattern_write_instructions_in", self.handle, text(language), text(title), text(path))

    def instructions(self, title: str | None = None, language: str | None = None) -> str:
        """The text that write_instructions() would write."""
        return taken_bytes(self.context, "mus_pattern_write_instructions_in_bytes", self.handle, text(language),
                           text(title)).decode()

    def propose_seams(self) -> list[tuple[int, int, bool, float]]:
        """Seams for a pattern without: (edge a, edge b, in the best sewing?, confidence 0 to 1), the surest first; then
        second choices. Seams that the pattern has are kept and not listed."""
        room = 2 * self.edge_count
        edges, chosen, sure = (ctypes.c_int32 * (2 * room))(), (ctypes.c_int32 * room)(), (ctypes.c_double * room)()
        n = ctypes.c_int32()
        self.do("propose_seams", edges, chosen, sure, room, ctypes.byref(n))
        return [(edges[2 * i], edges[2 * i + 1], bool(chosen[i]), sure[i]) for i in range(n.value)]

    def copy(self) -> Pattern:
        return Pattern(context=self.context,
                       _handle=create(self.context, "pattern", "mus_pattern_copy", self.handle))

    def _state(self) -> tuple[Any, ...]:
        return (self.to_bytes(),)

    @classmethod
    def _of_state(cls, context: Context, *state: Any) -> Pattern:
        return cls.parse(state[0], context=context)

    def _told(self) -> str:
        return f"{self.name!r}, {len(self.panels)} panels, {self.edge_count} edges, {self.seam_count} seams"

    def _repr_svg_(self) -> str:
        """The pieces with their allowance, for a notebook."""
        from .print import Sheet
        return Sheet(self, paper="roll").svg_bytes().decode()

    # ---- edit ----

    def _add(self, function: str, *arguments: Any) -> int:
        index = ctypes.c_int32()
        self.do(function, *arguments, ctypes.byref(index))
        return index.value

    def add_panel(self, name: str) -> int:
        return self._add("add_panel", text(name))

    def add_point(self, panel: int, x: float, y: float) -> int:
        return self._add("add_point", panel, x, y)

    def add_edge(self, start: int, end: int, pieces: Sequence[str] = ("line",), points: Numbers = (),
                 name: str | None = None) -> int:
        """An edge of pieces ("line", "quadratic", "cubic", "arc"); points: control points and inner joints in order."""
        kinds, count = integers([_PIECES.get(piece, piece) for piece in pieces])
        places, n = doubles(points, 2)
        definition = make_def(_abi.mus_edge_def, lib.mus_edge_def_init,
                              {"name": name, "start": start, "end": end, "npiece": count, "kinds": kinds, "nxy": n,
                               "xy": places})
        return self._add("add_edge", ctypes.byref(definition))

    def set_outline(self, panel: int, edges: Sequence[int], directions: Sequence[int] | None = None) -> None:
        """The attaching map of a panel; directions +1 or -1, all +1 when left out."""
        cells, n = integers(edges)
        signs, m = integers(directions if directions is not None else [1] * n)
        if m != n:
            raise ValueError(f"{n} edges, {m} directions")
        self.do("set_outline", panel, n, cells, signs)

    def add_seam(self, edge_a: int, edge_b: int, **options: Any) -> int:
        """Sew two edges. options: direction, ease, tolerance, laid, closure, open, buttons (mus_seam_def)."""
        definition = make_def(_abi.mus_seam_def, lib.mus_seam_def_init,
                              {"edge_a": edge_a, "edge_b": edge_b, **options})
        return self._add("add_seam", ctypes.byref(definition))

    def open_closures(self, leave_open: bool = True) -> int:
        """Leave all zips and buttons open, or do them up: how many there are."""
        return self._add("open_closures", 1 if leave_open else 0)

    def add_notch(self, edge: int, s: float, kind: int = 1) -> int:
        return self._add("add_notch", edge, s, kind)

    def add_mark(self, panel: int, name: str, points: Numbers) -> int:
        """A line or (one point) a drill point inside a panel."""
        places, n = doubles(points, 2)
        return self._add("add_mark", panel, text(name), n, places)

    def set_label(self, edge: int, label: str) -> None:
        """The opening or role of an edge ("hem", "neck")."""
        self.do("set_edge_label", edge, text(label))

    def set_allowance(self, edge: int, allowance: float | None) -> None:
        """Seam allowance of an edge [m]; None leaves it to the sheet."""
        self.do("set_edge_allowance", edge, math.nan if allowance is None else allowance)

    def set_hold(self, edge: int, level: str | int, below: float = 0.0) -> None:
        """Keep an edge from sliding more than `below` [m] under a level of the body ("waist"; "none" lets go)."""
        self.do("set_edge_hold", edge, self._hold(level), below)

    def hold_label(self, label: str, level: str | int, below: float = 0.0) -> int:
        """The same for all edges with a label: how many there are."""
        count = ctypes.c_int32()
        self.do("hold_label", text(label), self._hold(level), below, ctypes.byref(count))
        return count.value

    @staticmethod
    def _hold(level: str | int) -> int:
        return lib.mus_hold_find(text(level)) if isinstance(level, str) else level

    def set_elastic(self, edge: int, ratio: float, stiffness: float) -> None:
        """An elastic along an edge: length over that of the edge, and newton for double length (0: none)."""
        self.do("set_edge_elastic", edge, ratio, stiffness)

    def set_panel_name(self, panel: int, name: str) -> None:
        """Another name of a panel; its words tell the sides until they are set."""
        self.do("set_panel_name", panel, name)

    def set_panel_label(self, panel: int, label: str) -> None:
        """The part of the garment that a panel is: "arm" lets an arrangement put it round an arm."""
        self.do("set_panel_label", panel, label)

    def set_layer(self, panel: int, layer: int) -> None:
        """Layer of a panel, 0 next to the skin: a drape with self_contact sews them from inside to outside."""
        self.do("set_layer", panel, layer)

    def layer(self, panel: int) -> int:
        return lib.mus_pattern_layer(self.handle, panel)

    def set_sides(self, panel: int, *sides: str) -> None:
        """The sides of the wearer that a panel is on ("front", "left"); until then its name tells them."""
        self.do("set_panel_sides", panel, sum({_SIDES[side] for side in sides}))

    def sides(self, panel: int) -> list[str]:
        told = lib.mus_pattern_panel_sides(self.handle, panel, None)
        return [side for side, bit in _SIDES.items() if told & bit]

    def join(self, other: Pattern, layer: int) -> None:
        """Another garment over this one: all cells of a pattern, its innermost panels in `layer`."""
        self.do("join", other.handle, layer)

    def set_grain(self, panel: int, x: float, y: float) -> None:
        """Direction of the warp in the plane of a panel."""
        self.do("set_grain", panel, x, y)

    def set_cut(self, panel: int, count: int, mirror_of: int = _abi.MUS_NONE) -> None:
        """How many pieces are cut, and of which panel it is the mirror image."""
        self.do("set_cut", panel, count, mirror_of)

    def set_material(self, panel: int, material: str, count: int) -> None:
        """How many pieces are cut of a material: main, lining, interfacing, rib, elastic."""
        self.do("set_material", panel, _MATERIALS[material], count)

    def set_cut_only(self, panels: Pattern | None) -> None:
        """The panels that are cut and not draped, a pattern of their own, which is copied; None takes them away."""
        self.do("set_cut_only", panels.handle if panels is not None else None)

    def set_placement(self, panel: int, **options: Any) -> None:
        """Where a panel starts: origin, rotation, bend, bend_x, fold (mus_placement)."""
        placement = make_def(_abi.mus_placement, lib.mus_placement_init, options)
        self.do("set_placement", panel, ctypes.byref(placement))

    def placement(self, panel: int) -> dict[str, Any]:
        placement = make_def(_abi.mus_placement, lib.mus_placement_init)
        self.do("placement", panel, ctypes.byref(placement))
        return read_struct(placement)

    # ---- query ----

    @property
    def name(self) -> str:
        return self.get("name")

    @name.setter
    def name(self, value: str) -> None:
        self.do("set_name", text(value))

    @property
    def panels(self) -> list[str]:
        """Names of the panels."""
        return [self.get("panel_name", i) for i in range(self.get("panel_count"))]

    @property
    def edge_count(self) -> int:
        return self.get("edge_count")

    @property
    def point_count(self) -> int:
        return self.get("point_count")

    @property
    def seam_count(self) -> int:
        return self.get("seam_count")

    def outline(self, panel: int) -> list[tuple[int, int]]:
        """[(edge, direction)] of a panel."""
        n, edges, signs = ctypes.c_int32(), ctypes.POINTER(ctypes.c_int32)(), ctypes.POINTER(ctypes.c_int32)()
        self.do("outline", panel, ctypes.byref(n), ctypes.byref(edges), ctypes.byref(signs))
        return [(edges[i], signs[i]) for i in range(n.value)]

    def rim(self, panel: int) -> list[tuple[int, int]]:
        """[(edge, direction)] of what is cut: the outline without lines inside the panel."""
        room = len(self.outline(panel))
        edges, signs, n = (ctypes.c_int32 * room)(), (ctypes.c_int32 * room)(), ctypes.c_int32()
        self.do("rim", panel, edges, signs, room, ctypes.byref(n))
        return list(zip(edges[:n.value], signs[:n.value]))

    def cut_line(self, panel: int, allowance: float = 0.01) -> tuple[list[Array], list[list[tuple[float, float]]]]:
        """(loops, darts) of what is cut, with allowances [m]: closed loops (n x 2), the outer one first; of each dart that
        the line runs across: first end of its mouth, its point, second end, end of the fold."""
        line, n, xy = ctypes.POINTER(_abi.mus_cut_line)(), ctypes.c_int32(), ctypes.POINTER(ctypes.c_double)()
        self.do("cut_line", panel, allowance, ctypes.byref(line))
        try:
            loops, darts, four = [], [], (ctypes.c_double * 8)()
            for loop in range(lib.mus_cut_line_loop_count(line)):
                self.context.call("mus_cut_line_loop", line, loop, ctypes.byref(n), ctypes.byref(xy))
                loops.append(result((ctypes.c_double * (2 * n.value))(*xy[:2 * n.value]), 2))
            for dart in range(lib.mus_cut_line_dart_count(line)):
                self.context.call("mus_cut_line_dart", line, dart, four)
                darts.append([(four[k], four[k + 1]) for k in range(0, 8, 2)])
            return loops, darts
        finally:
            lib.mus_cut_line_destroy(line)

    def panel(self, name: str) -> int:
        """Number of a panel by name; KeyError."""
        index = self.get("find_panel", text(name))
        if index == _abi.MUS_NONE:
            raise KeyError(name)
        return index

    def edge(self, panel: int, name: str) -> int:
        """Number of an edge by its panel's number and its name; KeyError."""
        index = self.get("find_edge", panel, text(name))
        if index == _abi.MUS_NONE:
            raise KeyError(name)
        return index

    def grain(self, panel: int) -> tuple[float, float]:
        """(x, y) of the warp."""
        place = (ctypes.c_double * 2)()
        self.do("grain", panel, place)
        return tuple(place)

    def cut(self, panel: int) -> tuple[int, int | None]:
        """(count, mirror_of) of a panel; mirror_of None when it is no mirror image."""
        count, mirror = ctypes.c_int32(), ctypes.c_int32()
        self.do("cut", panel, ctypes.byref(count), ctypes.byref(mirror))
        return count.value, None if mirror.value == _abi.MUS_NONE else mirror.value

    def materials(self, panel: int) -> dict[str, int]:
        """Pieces that are cut of each material of a panel, those without a piece left out: {"main": 2, "lining": 1}."""
        count, told = ctypes.c_int32(), {}
        for name, material in _MATERIALS.items():
            self.do("material", panel, material, ctypes.byref(count), None)
            if count.value > 0:
                told[name] = count.value
        return told

    def cut_only(self) -> Pattern | None:
        """A copy of the panels that are cut and not draped (facings, elastic); None without any."""
        own = self.get("cut_only")
        return Pattern(context=self.context, _handle=create(self.context, "pattern", "mus_pattern_copy", own)) if own else None

    def edge_allowance(self, edge: int) -> float | None:
        """[m], None where the sheet decides."""
        value = self.get("edge_allowance", edge)
        return None if math.isnan(value) else value

    def edge_hold(self, edge: int) -> tuple[str, float]:
        """(level, metre below it) of an edge; ("none", 0.0) without."""
        level, below = ctypes.c_int32(), ctypes.c_double()
        self.do("edge_hold", edge, ctypes.byref(level), ctypes.byref(below))
        return lib.mus_hold_name(level.value).decode(), below.value

    def edge_elastic(self, edge: int) -> tuple[float, float]:
        """(ratio, newton) of an edge's elastic; (1.0, 0.0) without."""
        ratio, stiffness = ctypes.c_double(), ctypes.c_double()
        self.do("edge_elastic", edge, ctypes.byref(ratio), ctypes.byref(stiffness))
        return ratio.value, stiffness.value

    def edge_at(self, edge: int, t: Numbers) -> Array:
        """Points (n x 2) of an edge at relative arc lengths t (0 start .. 1 end)."""
        places, n = doubles(t)
        points = (ctypes.c_double * (2 * n))()
        self.do("edge_at", edge, n, places, points)
        return result(points, 2)

    def notches(self) -> list[tuple[int, float, int]]:
        """[(edge, arc length [m], kind)]."""
        return [self._notch(i) for i in range(self.get("notch_count"))]

    def _notch(self, notch: int) -> tuple[int, float, int]:
        edge, s, kind = ctypes.c_int32(), ctypes.c_double(), ctypes.c_int32()
        self.do("notch", notch, ctypes.byref(edge), ctypes.byref(s), ctypes.byref(kind))
        return edge.value, s.value, kind.value

    def marks(self) -> list[tuple[int, str, list[tuple[float, float]]]]:
        """[(panel, name, points)]."""
        return [self._mark(i) for i in range(self.get("mark_count"))]

    def _mark(self, mark: int) -> tuple[int, str, list[tuple[float, float]]]:
        panel, name, n = ctypes.c_int32(), ctypes.c_char_p(), ctypes.c_int32()
        points = ctypes.POINTER(ctypes.c_double)()
        self.do("mark", mark, ctypes.byref(panel), ctypes.byref(name), ctypes.byref(n), ctypes.byref(points))
        return panel.value, name.value.decode(), [(points[2 * i], points[2 * i + 1]) for i in range(n.value)]

    def point(self, point: int) -> tuple[int, float, float]:
        """(panel, x, y) of a point."""
        panel, place = ctypes.c_int32(), (ctypes.c_double * 2)()
        self.do("point", point, ctypes.byref(panel), place)
        return panel.value, place[0], place[1]

    def edge_ends(self, edge: int) -> tuple[int, int]:
        start, end = ctypes.c_int32(), ctypes.c_int32()
        self.do("edge_ends", edge, ctypes.byref(start), ctypes.byref(end))
        return start.value, end.value

    def edge_name(self, edge: int) -> str:
        return self.get("edge_name", edge)

    def edge_label(self, edge: int) -> str:
        return self.get("edge_label", edge)

    def edge_length(self, edge: int) -> float:
        """[m]."""
        return self.get("edge_length", edge)

    def edge_polyline(self, edge: int, chords: int = 40) -> Array:
        """Points (n x 2) along an edge, each curved piece in `chords` chords."""
        count = ctypes.c_int32()
        self.do("edge_polyline", edge, chords, None, 0, ctypes.byref(count))
        points = (ctypes.c_double * (2 * count.value))()
        self.do("edge_polyline", edge, chords, points, count.value, ctypes.byref(count))
        return result(points, 2)

    def area(self, panel: int) -> float:
        """[m2]."""
        return self.get("panel_area", panel)

    def perimeter(self, panel: int) -> float:
        """[m]."""
        return self.get("panel_perimeter", panel)

    def seam(self, seam: int) -> dict[str, Any]:
        """{edge_a, edge_b, direction, ease, tolerance} of a seam."""
        definition = make_def(_abi.mus_seam_def, lib.mus_seam_def_init)
        self.do("seam", seam, ctypes.byref(definition))
        return read_struct(definition)

    # ---- openings ----

    @property
    def openings(self) -> list[str]:
        """Labels of the openings that the sewn garment is declared to have."""
        return [self.get("opening", i) for i in range(self.get("opening_count"))]

    def add_opening(self, label: str) -> None:
        """Declare an opening; a pattern that declares any is checked as a garment."""
        self.do("add_opening", text(label))
