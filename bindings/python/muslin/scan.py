"""scan.py: a body from a triangle mesh: a scan of a person, an avatar, a dress form."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrays import doubles, integers
from .body import Body
from .context import Context, create, make_def, plain

if TYPE_CHECKING:
    from ._types import Numbers

_AXES = {"x": _abi.MUS_SCAN_X, "y": _abi.MUS_SCAN_Y, "z": _abi.MUS_SCAN_Z}
_PARTS = ("torso", "head", "arms", "hands", "legs", "feet")
_GIRTHS = ("bust", "waist", "hip", "thigh", "wrist")


def _axis(value: str | int) -> Any:
    """"y" or "-z" as a number of the library."""
    if not isinstance(value, str):
        return value
    return -_AXES[value[1:]] if value.startswith("-") else _AXES[value.lstrip("+")]


def _report(struct: Any) -> dict[str, Any]:
    """The report as a dict, with girths and distances by name."""
    plain = {name: getattr(struct, name) for name, _ in struct._fields_ if name != "size"}
    plain = {name: list(value) if isinstance(value, ctypes.Array) else value for name, value in plain.items()}
    for name in ("girth", "girth_height"):
        plain[name] = dict(zip(_GIRTHS, plain[name]))
    for name in ("mesh_to_body", "body_to_mesh"):
        plain[name] = {part: tuple(row) for part, row in zip(_PARTS, plain[name])}
    return plain


def scan(vertices: Numbers, triangles: Numbers, context: Context | None = None, **options: Any) -> tuple[Body,
         dict[str, Any]]:
    """Make a body of a mesh, vertices (n x 3) and triangles (m x 3); returns (body, report).

    Options are the fields of mus_scan_def: up and front ("y", "-z" ...) and unit [m], which are found when left out;
    spacing, corners, gap, samples, ring_spacing. The report is a dict with the fields of mus_scan_report; distances are
    (median, 95th percentile, maximum)."""
    context = context or Context.of_thread()
    x, n = doubles(vertices, 3)
    triangle, m = integers(triangles, 3)
    options = {name: _axis(value) if name in ("up", "front") else value for name, value in options.items()}
    definition = make_def(_abi.mus_scan_def, lib.mus_scan_def_init, options)
    report = _abi.mus_scan_report()
    lib.mus_scan_report_init(ctypes.byref(report), ctypes.sizeof(report))
    handle = create(context, "body", "mus_body_create_scan", context.handle, n, x, m, triangle,
                    ctypes.byref(definition), ctypes.byref(report))
    made = ("scan", (bytes(x), bytes(triangle)), plain(definition))
    return Body(context, _handle=handle, _made=made), _report(report)
