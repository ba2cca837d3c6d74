"""arrange.py: where the panels of a pattern are before they are sewn, and what is wrong with an arrangement."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .context import make_def, read_struct

if TYPE_CHECKING:
    from .body import Body
    from .pattern import Pattern


def read_reason(reason: Any) -> dict[str, Any]:
    """A mus_reason as a dict, with its kind in words as "name"."""
    return {**read_struct(reason), "name": lib.mus_reason_name(reason.kind).decode(),
            "text": reason.text.decode("utf-8", "replace")}


def arrange(pattern: Pattern, body: Body) -> None:
    """Find where the panels of a pattern start round a body, and write it as their placement."""
    if body.context is not pattern.context:
        raise ValueError("pattern and body are of two contexts")
    pattern.context.call("mus_arrange_pattern", pattern.handle, body.handle)


def pattern_reason(pattern: Pattern) -> dict[str, Any]:
    """The first fault of a pattern, as a dict (mus_reason); kind 0 when a cloth can be cut of it."""
    reason = make_def(_abi.mus_reason, lib.mus_reason_init)
    pattern.context.call("mus_pattern_reason", pattern.handle, ctypes.byref(reason))
    return read_reason(reason)
