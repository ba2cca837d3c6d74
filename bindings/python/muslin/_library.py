"""_library.py: find and open the shared libraries, and give their functions the prototypes of _abi.

Looked for in this order: the file (or folder) that the environment variable MUSLIN_LIB names; libmuslin.so beside this
file (a wheel); build/lib of the repository that this file lies in; the system's own search. libmuslin-print,
libmuslin-exchange and libmuslin-catalogue lie where libmuslin lies, and are opened when one of their functions is first
asked for.
"""
from __future__ import annotations

import ctypes
import ctypes.util
import os
import pathlib
from typing import TYPE_CHECKING, Any

from . import _abi

if TYPE_CHECKING:
    from collections.abc import Iterator

_HERE = pathlib.Path(__file__).resolve().parent
_FILES = {"core": "libmuslin", "print": "libmuslin-print", "exchange": "libmuslin-exchange",
          "catalogue": "libmuslin-catalogue"}


def _named_by_environment() -> pathlib.Path | None:
    named = os.environ.get("MUSLIN_LIB")
    if not named:
        return None
    path = pathlib.Path(named)
    return path / "libmuslin.so" if path.is_dir() else path


def _candidates() -> Iterator[pathlib.Path]:
    yield _HERE / f"libmuslin.so.{_abi.MUS_ABI}"
    yield _HERE / "libmuslin.so"
    yield _HERE.parents[2] / "build" / "lib" / "libmuslin.so"


def _find_core() -> tuple[str, pathlib.Path | None]:
    """(path to open, folder of the other two or None for the system's own search)."""
    named = _named_by_environment()
    if named is not None:
        if not named.exists():
            raise ImportError(f"MUSLIN_LIB names {named}, which is not there")
        return str(named), named.parent
    for path in _candidates():
        if path.exists():
            return str(path), path.parent
    found = ctypes.util.find_library("muslin")
    if found:
        return found, None
    raise ImportError("libmuslin was not found: set MUSLIN_LIB to the file, or run make in the repository, or install "
                      f"it (looked at {', '.join(str(path) for path in _candidates())} and the system's libraries)")


class _Library:
    """The C functions as attributes: lib.mus_tape_create(...)."""

    def __init__(self) -> None:
        path, self._folder = _find_core()
        self._suffix = path.partition(".so")[2]
        self._open = {"core": ctypes.CDLL(path)}

    def _of(self, part: str) -> Any:
        if part not in self._open:
            if self._folder is None:
                name = ctypes.util.find_library(_FILES[part][len("lib"):]) or _FILES[part] + ".so"
            else:
                name = str(self._folder / f"{_FILES[part]}.so{self._suffix}")
            try:
                self._open[part] = ctypes.CDLL(name)
            except OSError as error:
                raise ImportError(f"{_FILES[part]} cannot be opened: {error}") from None
        return self._open[part]

    def __getattr__(self, name: str) -> Any:
        if name not in _abi.FUNCTIONS:
            raise AttributeError(name)
        part, result, arguments = _abi.FUNCTIONS[name]
        function = getattr(self._of(part), name)
        function.restype = result
        function.argtypes = arguments
        setattr(self, name, function)
        return function


lib = _Library()


def version() -> str:
    """Version of the library that runs, "0.2.0"."""
    numbers = (ctypes.c_int32 * 3)()
    lib.mus_version(numbers)
    return ".".join(map(str, numbers))


if version().split(".")[:2] != _abi.VERSION.split(".")[:2]:
    raise ImportError(f"this package speaks to muslin {_abi.VERSION}, the library found is {version()}")
