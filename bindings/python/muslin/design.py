"""design.py: garments drafted from the tape."""
import ctypes

from . import _abi
from ._library import lib
from .context import create, make_def, text
from .pattern import Pattern


def designs():
    """[{"name", "family", "title"}] of the named designs."""
    return [{"name": lib.mus_design_name(i).decode(), "family": lib.mus_design_family(i).decode(),
             "title": lib.mus_design_title(i).decode()} for i in range(lib.mus_design_count())]


def draft(design, tape, **options):
    """The pattern of a design, by name, for a tape. options: ease, length, sleeve [m] (mus_draft_def)."""
    index = lib.mus_design_find(text(design))
    if index == _abi.MUS_NONE:
        raise KeyError(f"no design {design!r}: {', '.join(row['name'] for row in designs())}")
    definition = make_def(_abi.mus_draft_def, lib.mus_draft_def_init, options)
    context = tape.context
    return Pattern(context=context, _handle=create(context, "pattern", "mus_design_draft", context.handle, index,
                                                   tape.handle, ctypes.byref(definition)))
