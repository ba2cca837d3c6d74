"""catalogue.py: patterns kept in a file, found again by how they are sewn."""
from __future__ import annotations

import contextlib
import ctypes
from typing import TYPE_CHECKING

from . import _abi
from .context import Context, Object, create, text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ._types import PathLike
    from .pattern import Pattern

_PARTS = [name[len("MUS_DISTANCE_"):].lower() for name, value in
          sorted(((n, v) for n, v in vars(_abi).items() if n.startswith("MUS_DISTANCE_") and n != "MUS_DISTANCE_COUNT"),
                 key=lambda item: item[1])]


class Catalogue(Object):
    """A catalogue in a file; writable=True makes it when it is not there. Patterns are numbers and names."""

    _kind = "catalogue"

    def __init__(self, path: PathLike, writable: bool = False, context: Context | None = None) -> None:
        context = context or Context.of_thread()
        mode = _abi.MUS_CATALOGUE_WRITE if writable else _abi.MUS_CATALOGUE_READ
        super().__init__(context, create(context, "catalogue", "mus_catalogue_open", context.handle, text(path), mode))

    def __len__(self) -> int:
        return self.get("count")

    def _told(self) -> str:
        return f"{len(self)} patterns"

    def add(self, pattern: Pattern, name: str) -> int:
        """Keep a pattern; one of that name is replaced. Returns its number."""
        number = ctypes.c_int32()
        self.do("add", pattern.handle, text(name), ctypes.byref(number))
        return number.value

    @contextlib.contextmanager
    def together(self) -> Iterator[Catalogue]:
        """Additions in the block are kept all or none, and are on disk at its end."""
        self.do("begin")
        try:
            yield self
        except BaseException:
            self.do("rollback")
            raise
        self.do("commit")

    def name(self, number: int) -> str:
        name = ctypes.c_char_p()
        with self.context.lock:
            self.do("name", number, ctypes.byref(name))
            return name.value.decode("utf-8", "replace")

    def exact(self, pattern: Pattern) -> list[int]:
        """Numbers of the patterns that are the same but for names, order and mirroring."""
        return self._all("exact", pattern)

    def containing(self, part: Pattern) -> list[int]:
        """Numbers of the patterns that contain a part."""
        return self._all("containing", part)

    def _all(self, function: str, pattern: Pattern) -> list[int]:
        count = ctypes.c_int32()
        self.do(function, pattern.handle, None, 0, ctypes.byref(count))
        numbers = (ctypes.c_int32 * count.value)()
        self.do(function, pattern.handle, numbers, count.value, ctypes.byref(count))
        return list(numbers)

    def nearest(self, pattern: Pattern, count: int = 10) -> list[tuple[int, float, bool]]:
        """[(number, distance, exact)], nearest first."""
        numbers, exact, distances = (ctypes.c_int32 * count)(), (ctypes.c_int32 * count)(), (ctypes.c_double * count)()
        found = ctypes.c_int32()
        self.do("nearest", pattern.handle, count, numbers, distances, exact, ctypes.byref(found))
        return [(numbers[i], distances[i], bool(exact[i])) for i in range(found.value)]

    def explain(self, pattern: Pattern, number: int) -> tuple[dict[str, float], str]:
        """({part: distance}, sentences): what the distance to a pattern is made of."""
        parts, sentences = (ctypes.c_double * _abi.MUS_DISTANCE_COUNT)(), ctypes.create_string_buffer(2048)
        self.do("explain", pattern.handle, number, parts, sentences, len(sentences))
        return dict(zip(_PARTS, parts)), sentences.value.decode("utf-8", "replace")
