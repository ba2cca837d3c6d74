"""errors.py: a status of the library as an exception."""
from __future__ import annotations

from typing import Any
from . import _abi
from ._library import lib


class MuslinError(Exception):
    """A call failed. status: the number (MUS_ERR_*), name: "MUS_ERR_TAPE", text: the library's sentence."""

    def __init__(self, status: int, text: str | None) -> None:
        self.status = status
        self.name = lib.mus_status_name(status).decode()
        self.text = text or lib.mus_status_text(status).decode()
        super().__init__(f"{self.name}: {self.text}")

    def __reduce__(self) -> tuple[Any, ...]:
        return MuslinError, (self.status, self.text)


def check(context: Any, status: int) -> None:
    """Raise for a status that is not MUS_OK; `context` is a handle or None."""
    if status != _abi.MUS_OK:
        text = lib.mus_context_error(context).decode("utf-8", "replace") if context is not None else ""
        raise MuslinError(status, text)
