"""design.py: garments drafted from the tape, by name or by words."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .context import Context, create, make_def, text
from .pattern import Pattern
from .tape import Tape

if TYPE_CHECKING:
    from ._types import PathLike

GROUPS = {_abi.MUS_GROUP_WOMEN: "women", _abi.MUS_GROUP_MEN: "men", _abi.MUS_GROUP_CHILDREN: "children"}


def _row(design: int) -> dict[str, Any]:
    bits = lib.mus_design_groups(design)
    return {"name": lib.mus_design_name(design).decode(), "family": lib.mus_design_family(design).decode(),
            "title": lib.mus_design_title(design).decode(), "words": lib.mus_design_words(design).decode(),
            "fabric": lib.mus_design_fabric(design).decode(),
            "groups": [group for bit, group in GROUPS.items() if bits & bit]}


def designs(phrase: str | None = None, most: int | None = None) -> list[dict[str, Any]]:
    """[{"name", "family", "title", "words", "fabric", "groups"}] of the named designs; groups: "women", "men", "children".

    phrase: what a person types ("long sleeve tee", "kids dress", "skirt length=knee"): only the designs that match, the
    best first, with "score", 0 to 1; [] when none does. most: rows at most.
    """
    if phrase is None:
        return [_row(i) for i in range(lib.mus_design_count())][:most]
    room = lib.mus_design_count() if most is None else max(0, most)
    found, scores, count = (ctypes.c_int32 * room)(), (ctypes.c_double * room)(), ctypes.c_int32()
    context = Context.of_thread()
    context.call("mus_design_search", context.handle, text(phrase), room, found, scores, ctypes.byref(count))
    return [{**_row(found[i]), "score": scores[i]} for i in range(min(room, count.value))]


def axes() -> dict[str, list[str]]:
    """{"garment": ["top", ...], "neck": [...], ...}: the words that designs are made of."""
    return {lib.mus_design_axis_name(a).decode():
            [lib.mus_design_option_name(a, i).decode() for i in range(lib.mus_design_option_count(a))]
            for a in range(lib.mus_design_axis_count())}


def spell(words: str) -> str:
    """Words in full, what was left out chosen; MuslinError for words that do not go together."""
    full = ctypes.create_string_buffer(1024)
    context = Context.of_thread()
    context.call("mus_design_spell", context.handle, text(words), full, len(full))
    return full.value.decode()


def draft(design: str, tape: Tape | PathLike, **options: Any) -> Pattern:
    """The pattern of a design for a tape: by name ("tshirt"), or by words ("dress neck=v sleeve=puff").

    A text that is no name is taken as words, with their axes or spoken ("pencil skirt midi"). tape: a Tape, or what Tape.of() takes: a path, the name of a table size.
    options: ease, length, sleeve [m] (mus_draft_def).
    """
    index = lib.mus_design_find(text(design))
    definition = make_def(_abi.mus_draft_def, lib.mus_draft_def_init, options)
    tape = Tape.of(tape)
    context = tape.context
    if index != _abi.MUS_NONE:
        function, what = "mus_design_draft", index
    elif set(str(design).split()) & set(axes()["garment"]):
        function, what = "mus_design_draft_words", text(design)
    else:
        near = ", ".join(row["name"] for row in designs(str(design).replace("=", " "), 4))
        raise KeyError(f"no design is called {design!r}; " + (f"near: {near}" if near else
                       "muslin.designs() lists the names, muslin.axes() the words"))
    return Pattern(context=context, _handle=create(context, "pattern", function, context.handle, what, tape.handle,
                                                   ctypes.byref(definition)))


def grade(from_pattern: Pattern, to_pattern: Pattern) -> list[tuple[float, float]]:
    """[(dx, dy)] for each point of a pattern: how far it moves to where the next size has it; NaN where it is not."""
    rules = (ctypes.c_double * (2 * from_pattern.get("point_count")))()
    from_pattern.context.call("mus_design_grade", from_pattern.handle, to_pattern.handle, rules, None)
    return list(zip(rules[0::2], rules[1::2]))


def ease(pattern: Pattern, tape: Tape) -> dict[str, float]:
    """{"bust", "waist", "hip"}: what the garment is wider than the body by [m], NaN where it is not."""
    values = (ctypes.c_double * _abi.MUS_EASE_COUNT)()
    pattern.context.call("mus_design_ease", pattern.handle, tape.handle, values)
    return dict(zip(("bust", "waist", "hip"), values))
