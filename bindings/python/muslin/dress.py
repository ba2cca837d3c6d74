"""dress.py: from a pattern and a body to a garment at rest, in one call."""
import ctypes

from . import _abi
from ._library import lib
from .arrange import read_reason
from .body import Body
from .cloth import Cloth, Fabric
from .context import make_def
from .design import draft
from .drape import Drape, progress_hook
from .errors import MuslinError
from .pattern import Pattern

_PLACES = {"both": _abi.MUS_DRESS_PLACE_BOTH, "pattern": _abi.MUS_DRESS_PLACE_PATTERN,
           "found": _abi.MUS_DRESS_PLACE_FOUND}
_PHASES = ("place", "cut", "sew", "settle")


class Dressed:
    """A dressed body: pattern, body, cloth and drape (None when nothing could be cut), how it came to be in starts,
    seconds, found and reason, and status, "MUS_OK" or the name of an error."""

    def __init__(self, pattern, body, cloth, drape, report, reason, status):
        self.pattern, self.body, self.cloth, self.drape = pattern, body, cloth, drape
        self.reason = reason
        self.status = status
        self.found = bool(report.found)
        self.kept = report.kept
        names = {number: name for name, number in _PLACES.items()}
        self.starts = [{"kind": names[report.start_place[i]], "patient": bool(report.start_patient[i]),
                        "seconds": report.start_seconds[i], "end": lib.mus_reason_name(report.start_end[i]).decode()}
                       for i in range(report.starts)]
        self.seconds = {phase: getattr(report, f"{phase}_seconds") for phase in _PHASES}


def dress(garment, wearer, fabric=None, strict=True, progress=None, draft_options=None, drape_options=None, **options):
    """Dress a body and let the garment come to rest, with the retries of `muslin dress`; returns a Dressed.

    garment: a Pattern, or what draft() takes: the name of a design, or words. wearer: a Tape, of which a body is made,
    or a Body (and a Pattern). fabric: a name or a Fabric. options: spacing, self_contact, precision, threads, friction,
    place ("both", "pattern" or "found"), retry, open_closures, nodes_most (mus_dress_def). drape_options: all
    options of the drape instead (mus_drape_def). progress(Progress) may return True to stop. A garment that does not
    come to rest raises MuslinError, or with strict=False is returned with its reason.
    """
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
    definition.progress = progress_hook(progress, raised)

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
