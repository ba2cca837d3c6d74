"""dress.py: from a pattern and a body to a garment at rest, in one call."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrange import read_reason
from .arrays import numpy
from .body import Body
from .cloth import Cloth, Fabric
from .context import make_def
from .design import draft
from .drape import Drape, progress_hook
from .errors import MuslinError
from .exchange import Mesh
from .fit import Fit
from .pattern import Pattern
from .render import png_bytes, render
from .tape import Tape
from .view import View

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from ._types import Array, PathLike
    from .drape import Progress

_PLACES = {"both": _abi.MUS_DRESS_PLACE_BOTH, "pattern": _abi.MUS_DRESS_PLACE_PATTERN,
           "found": _abi.MUS_DRESS_PLACE_FOUND}
CLOTH, SKIN = (0.32, 0.47, 0.66), (0.80, 0.72, 0.66, 1.0)  # colours of pictures: red, green, blue (and opacity)
_PHASES = ("place", "cut", "sew", "settle")


class Dressed:
    """A dressed body: pattern, body, cloth and drape (None when nothing could be cut), how it came to be in starts,
    seconds, found and reason, and status, "MUS_OK" or the name of an error."""

    def __init__(self, pattern: Pattern, body: Body | None, cloth: Cloth | None, drape: Drape | None, report: Any,
                 reason: Any, status: str) -> None:
        self.pattern, self.body, self.cloth, self.drape = pattern, body, cloth, drape
        self.reason = reason
        self.status = status
        self.found = bool(report.found)
        self.kept = report.kept
        names = {number: name for name, number in _PLACES.items()} | {_abi.MUS_DRESS_PLACE_RAISED: "raised"}
        self.starts = [{"kind": names[report.start_place[i]], "patient": bool(report.start_patient[i]),
                        "seconds": report.start_seconds[i], "end": lib.mus_reason_name(report.start_end[i]).decode()}
                       for i in range(report.starts)]
        self.seconds = {phase: getattr(report, f"{phase}_seconds") for phase in _PHASES}

    def meshes(self, colour: Sequence[float] = CLOTH, body: Body | None = None) -> list[Mesh]:
        """The body (or `body` in its place) and the garment as meshes: for render(), View, write_mesh(), write_glb()."""
        if self.cloth is None or self.drape is None:
            raise ValueError(f"{self.pattern.name} was not cut: {self.reason['text']}")
        body = body or self.body
        garment = Mesh(self.pattern.name, self.drape.positions, self.cloth.triangles, self.drape.normals,
                       self.cloth.rest, colour=(*colour[:3], 1.0), two_sided=True, cloth=self.cloth)
        return [Mesh("body", body.vertices, body.triangles, body.normals, colour=SKIN)] * (body is not None) + [garment]

    def picture(self, width: int = 360, height: int = 540, **options: Any) -> Array:
        """A picture (height x width x 3, uint8). options: yaw, pitch, zoom, background (muslin.render)."""
        return render(self.meshes(), width, height, **options)

    def view(self, height: int = 540) -> View:
        """What a notebook shows as a model that turns: the garment on a coarser copy of the body."""
        coarse = self.body.remade(samples=32, ring_spacing=0.025) if self.body is not None else None
        return View(self.meshes(body=coarse), self.pattern.name, height)

    def fit(self) -> Fit:
        """Ease, strain and pressure of the garment as it hangs now."""
        return Fit(self.drape, self.body)

    def _repr_png_(self) -> bytes | None:
        return png_bytes(self.picture()) if numpy and self.drape is not None else None

    def __repr__(self) -> str:
        state = f", {len(self.drape)} nodes, state {self.drape.state_hash}" if self.drape is not None else ""
        return f"<Dressed: {self.pattern.name!r}, {self.status}{state}>"


def _bar() -> Callable[[Progress], None] | None:
    """A progress function that moves a bar of tqdm; None where tqdm is not installed."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    bar = tqdm(total=100, unit="%", leave=False)

    def move(told: Progress) -> None:
        bar.set_description(told.phase)
        bar.update(round(100 * told.share) - bar.n)

    return move


def dress(garment: str | Pattern, wearer: Tape | Body | PathLike | None, fabric: str | Fabric | None = None,
          strict: bool = True, progress: Callable[[Progress], Any] | bool | None = None,
          draft_options: Mapping[str, Any] | None = None, drape_options: Mapping[str, Any] | None = None,
          **options: Any) -> Dressed:
    """Dress a body and let the garment come to rest, with the retries of `muslin dress`; returns a Dressed.

    garment: a Pattern, or what draft() takes: the name of a design, or words. wearer: a Body (and a Pattern), or a Tape
    or what Tape.of() takes ("W40", "me.tape"), of which a body is made; None for cloth without a body.

    fabric: a name or a Fabric; jersey without one. strict: a garment that does not come to rest raises MuslinError;
    with False it is returned with its reason. progress: progress(Progress) may return True to stop; True shows a bar where tqdm is
    installed. draft_options: ease, length, sleeve [m] (mus_draft_def). options (mus_dress_def): spacing [m],
    self_contact, precision (0: as the cloth asks, 32, 64), threads, friction, place ("both", "pattern" or "found"), retry, open_closures,
    nodes_most, progress_seconds, seconds_most [s of wall time, 0: no limit; over it the run ends with
    MUS_ERR_STOPPED, as far as it got]. drape_options: all options of the drape instead (mus_drape_def).
    """
    if not isinstance(wearer, (Body, type(None))):
        wearer = Tape.of(wearer)
    pattern = garment if isinstance(garment, Pattern) else draft(garment, wearer, **(draft_options or {}))
    body = wearer if isinstance(wearer, Body) or wearer is None else Body(wearer)
    context = pattern.context
    if body is not None and body.context is not context:
        raise ValueError("pattern and body are of two contexts")
    if isinstance(options.get("place"), str):
        options["place"] = _PLACES[options["place"]]
    definition = make_def(_abi.mus_dress_def, lib.mus_dress_def_init, options)
    if fabric is not None:
        fabric = fabric if isinstance(fabric, Fabric) else Fabric(fabric)
        definition.fabric = ctypes.pointer(fabric.struct)
    if drape_options is not None:
        definition.drape = ctypes.pointer(make_def(_abi.mus_drape_def, lib.mus_drape_def_init, drape_options))
    raised = []
    told = _bar() if progress is True else progress or None
    definition.progress = progress_hook(told, raised)

    report = make_def(_abi.mus_dress_report, lib.mus_dress_report_init)
    reason = make_def(_abi.mus_reason, lib.mus_reason_init)
    cloth, drape = ctypes.POINTER(_abi.mus_cloth)(), ctypes.POINTER(_abi.mus_drape)()
    failure = None
    try:
        context.call("mus_dress", context.handle, pattern.handle, body.handle if body is not None else None,
                     ctypes.byref(definition), ctypes.byref(report), ctypes.byref(reason), ctypes.byref(cloth),
                     ctypes.byref(drape))
    except MuslinError as error:
        failure = error
    dressed = Dressed(pattern, body, Cloth._owned(context, cloth), Drape._owned(context, drape), report,
                      read_reason(reason), "MUS_OK" if failure is None else failure.name)
    if raised:
        raise raised[0]
    if failure is not None and strict:
        raise failure
    return dressed


__all__ = ["Dressed", "dress"]
