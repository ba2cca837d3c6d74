"""context.py: the context that every object is made from, and what all objects of the package share.

A context serves one thread at a time. Each Context therefore has a lock that every call on it or its objects takes;
calls on objects of two contexts run side by side (ctypes lets go of the interpreter during a call). An object that is
made without naming a context uses the one of the object it is made from, or else the calling thread's own.
"""
from __future__ import annotations

import ctypes
import threading
import weakref
from typing import TYPE_CHECKING, Any, TypeVar

from . import _abi
from ._library import lib
from .errors import MuslinError, check

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

_own = threading.local()
_Same = TypeVar("_Same")


class Context:
    """The context: allocator, log, error text. log: called with (level, text) for each line."""

    def __init__(self, log: Callable[[int, str], Any] | None = None) -> None:
        definition = make_def(_abi.mus_context_def, lib.mus_context_def_init)
        self._log = None
        if log is not None:
            self._log = _abi.mus_log_fn(lambda _, level, text: log(level, text.decode("utf-8", "replace")))
            definition.log = self._log
        self.lock = threading.RLock()
        self.handle = ctypes.POINTER(_abi.mus_context)()
        check(None, lib.mus_context_create(ctypes.byref(definition), ctypes.byref(self.handle)))
        # the hook must outlive the C context, so the finalizer holds it
        weakref.finalize(self, _destroy_context, self.handle, self._log)

    @staticmethod
    def of_thread() -> Context:
        """The context of the calling thread, made when it is first asked for."""
        if not hasattr(_own, "context"):
            _own.context = Context()
        return _own.context

    @property
    def bytes(self) -> int:
        """Bytes that objects of this context hold now."""
        return lib.mus_context_bytes(self.handle)

    @property
    def allocations(self) -> int:
        """Allocations since the context was made."""
        return lib.mus_context_allocations(self.handle)

    @property
    def error(self) -> str:
        """Text of the last failure, "" if none."""
        return lib.mus_context_error(self.handle).decode("utf-8", "replace")

    def call(self, name: str, *arguments: Any) -> None:
        """Call a function that returns a status, under the lock; raises MuslinError."""
        with self.lock:
            check(self.handle, getattr(lib, name)(*arguments))


def _destroy_context(handle: Any, _hook: Any) -> None:
    lib.mus_context_destroy(handle)


def _destroy_object(name: str, handle: Any, context: Context) -> None:
    with context.lock:
        getattr(lib, name)(handle)


class Object:
    """A handle of the library with its context. Ends by close(), as a context manager, or with the last reference.

    A view of the object's arrays keeps the object alive; close() refuses while such a view lives.
    """

    _kind = None  # "tape": the functions are mus_tape_*

    def __init__(self, context: Context, handle: Any) -> None:
        self.context = context
        self._handle = handle
        self._views = weakref.WeakSet()
        self._end = weakref.finalize(self, _destroy_object, f"mus_{self._kind}_destroy", handle, context)

    @classmethod
    def _owned(cls, context: Context, handle: Any) -> Any:
        """An object of this class for a handle that the library made; None for NULL."""
        if not handle:
            return None
        self = cls.__new__(cls)
        Object.__init__(self, context, handle)
        return self

    def __repr__(self) -> str:
        told = self._told() if self._end.alive else "closed"
        return f"<{type(self).__name__}{': ' if told else ''}{told}>"

    def _told(self) -> str:
        """What repr() says of an open object."""
        return ""

    def __reduce__(self) -> Any:
        raise TypeError(f"a {type(self).__name__} cannot be copied or pickled: tapes, patterns, bodies and cloths can")

    @property
    def handle(self) -> Any:
        if not self._end.alive:
            raise ValueError(f"this {type(self).__name__} is closed")
        return self._handle

    def close(self) -> None:
        """Free the object now. BufferError while a view of its arrays is alive."""
        if len(self._views) > 0:
            raise BufferError(f"this {type(self).__name__} has arrays in use")
        self._end()

    def __enter__(self: _Same) -> _Same:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def get(self, name: str, *arguments: Any) -> Any:
        """Value of mus_KIND_name(handle, ...), text decoded."""
        with self.context.lock:
            value = getattr(lib, f"mus_{self._kind}_{name}")(self.handle, *arguments)
        return value.decode("utf-8", "replace") if isinstance(value, bytes) else value

    def do(self, name: str, *arguments: Any) -> None:
        """Call mus_KIND_name(handle, ...) that returns a status; raises MuslinError."""
        self.context.call(f"mus_{self._kind}_{name}", self.handle, *arguments)


class Valued(Object):
    """An object that is compared, copied and pickled by _state(): the plain values that it can be made of again."""

    def _state(self) -> tuple[Any, ...]:
        raise NotImplementedError

    @classmethod
    def _of_state(cls, context: Context, *state: Any) -> Any:
        raise NotImplementedError

    def __reduce__(self) -> Any:
        return _restored, (type(self), self._state())

    def __copy__(self: _Same) -> _Same:
        return self._of_state(self.context, *self._state())  # type: ignore[attr-defined,no-any-return]

    def __deepcopy__(self: _Same, _: Any) -> _Same:
        return self.__copy__()  # type: ignore[attr-defined,no-any-return]

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        if type(self) is not type(other):
            return NotImplemented
        return repr(self._state()) == repr(other._state())  # type: ignore[attr-defined]

    __hash__ = None  # type: ignore[assignment]


def _restored(kind: Any, state: tuple[Any, ...]) -> Any:
    """An object of a pickle, in the context of the thread that reads it."""
    return kind._of_state(Context.of_thread(), *state)


def create(context: Context, kind: str, function: str, *arguments: Any) -> Any:
    """Handle of a new mus_KIND from a function whose last argument gives it."""
    handle = ctypes.POINTER(getattr(_abi, f"mus_{kind}"))()
    context.call(function, *arguments, ctypes.byref(handle))
    return handle


def make_def(kind: Any, init: Any, options: Mapping[str, Any] | tuple[()] = ()) -> Any:
    """A def or result struct with its defaults, and then `options` (name to value)."""
    definition = kind()
    init(ctypes.byref(definition), ctypes.sizeof(definition))
    fill(definition, options)
    return definition


def fill(struct: Any, options: Mapping[str, Any] | tuple[()]) -> None:
    """Set fields by name; arrays take sequences of their length, text is encoded."""
    known = {name: field for name, field in struct._fields_ if name != "size"}
    for name, value in dict(options).items():
        if name not in known:
            raise TypeError(f"{type(struct).__name__} has no option {name!r}: {', '.join(known)}")
        kind = known[name]
        if kind is ctypes.c_char_p:
            value = text(value)
        elif issubclass(kind, ctypes.Array):
            value = kind(*value)
        setattr(struct, name, value)


def read_struct(struct: Any) -> dict[str, Any]:
    """Fields of a result struct as a dict, without its size."""
    values = {name: getattr(struct, name) for name, _ in struct._fields_ if name != "size"}
    return {name: list(value) if isinstance(value, ctypes.Array) else value for name, value in values.items()}


def plain(struct: Any) -> dict[str, Any]:
    """Fields of a struct of options as numbers and lists, without its size and its pointers."""
    numbers = (int, float, list)
    return {name: value for name, value in read_struct(struct).items() if isinstance(value, numbers)}


def taken_bytes(context: Context, name: str, *arguments: Any) -> bytes:
    """The bytes that a function whose last two arguments are `char **bytes, size_t *size` gives; its block is freed."""
    block, size = ctypes.c_char_p(), ctypes.c_size_t()
    with context.lock:
        context.call(name, *arguments, ctypes.byref(block), ctypes.byref(size))
        try:
            return ctypes.string_at(ctypes.cast(block, ctypes.c_void_p), size.value)
        finally:
            lib.mus_context_alloc(context.handle, ctypes.cast(block, ctypes.c_void_p), 0)


def text(value: Any) -> bytes | None:
    """str, path or None as bytes or None for C."""
    if value is None or isinstance(value, bytes):
        return value
    return str(value).encode("utf-8", "surrogateescape")


__all__ = ["Context", "MuslinError", "Object", "Valued", "create", "fill", "make_def", "plain", "read_struct",
           "taken_bytes", "text"]
