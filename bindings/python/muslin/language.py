"""language.py: the words that a sewer reads, in several languages."""
from __future__ import annotations

import ctypes

from . import _abi
from ._library import lib
from .context import text


def languages() -> dict[str, str]:
    """{"en": "English", "de": "Deutsch", ...}: tags, and what their speakers call them."""
    return {lib.mus_language_tag(i).decode(): lib.mus_language_name(i).decode() for i in range(lib.mus_language_count())}


def _number(language: str | None) -> int:
    number = lib.mus_language_find(text(language))
    if number == _abi.MUS_NONE:
        raise ValueError(f"language {language!r} is unknown; expected one of {', '.join(languages())}")
    return number


def words(language: str | None = None) -> dict[str, str]:
    """{key: text} of the whole table in a language: "de", "pt_BR"; None is English. {0}, {1} stand for what goes in."""
    number = _number(language)
    keys = [lib.mus_language_row_key(i) for i in range(lib.mus_language_row_count())]
    return {key.decode(): lib.mus_language_text(number, key).decode() for key in keys}


def translate(kind: str, name: str, language: str | None = None) -> str:
    """A "title" of a design, or the name of a "panel", an "edge" or a "measure", in a language. What the table lacks
    stays English."""
    made = ctypes.create_string_buffer(1024)
    lib.mus_language_compose(_number(language), text(kind), text(name), made, len(made))
    return made.value.decode()
