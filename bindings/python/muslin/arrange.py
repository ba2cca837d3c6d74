"""arrange.py: where the panels of a pattern are before they are sewn, and what is wrong with an arrangement."""
import ctypes

from . import _abi
from ._library import lib
from .context import make_def, read_struct


def read_reason(reason):
    """A mus_reason as a dict, with its kind in words as "name"."""
    return {**read_struct(reason), "name": lib.mus_reason_name(reason.kind).decode(),
            "text": reason.text.decode("utf-8", "replace")}


def arrange(pattern, body):
    """Find where the panels of a pattern start round a body, and write it as their placement."""
    if body.context is not pattern.context:
        raise ValueError("pattern and body are of two contexts")
    pattern.context.call("mus_arrange_pattern", pattern.handle, body.handle)


def pattern_reason(pattern):
    """The first fault of a pattern, as a dict (mus_reason); kind 0 when a cloth can be cut of it."""
    reason = make_def(_abi.mus_reason, lib.mus_reason_init)
    pattern.context.call("mus_pattern_reason", pattern.handle, ctypes.byref(reason))
    return read_reason(reason)
