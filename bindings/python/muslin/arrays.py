"""arrays.py: arrays of the library as views that keep their owner alive, and Python's numbers as C arrays.

With numpy a view is a read-only ndarray, without it a read-only memoryview; both are (n x width), or flat for width 1,
and both see what the library writes later. Nothing is copied.
"""
from __future__ import annotations

import array
import ctypes
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ._types import Array, Numbers

try:
    import numpy
except ImportError:  # numpy is optional
    numpy = None

_ORDER = "<" if sys.byteorder == "little" else ">"
_CODES = {ctypes.c_double: ("d", f"{_ORDER}f8"), ctypes.c_int32: ("i", f"{_ORDER}i4")}


class _Holder:
    """What numpy asks for an array; its life is the view's life, and it holds the owner."""

    def __init__(self, owner: Any, interface: Any) -> None:
        self.owner = owner
        self.__array_interface__ = interface


def view(owner: Any, pointer: Any, count: int, width: int = 1) -> Array:
    """`count` rows of `width` elements at `pointer`, borrowed from `owner`."""
    kind = pointer._type_
    code, numpy_code = _CODES[kind]
    shape = (count,) if width == 1 else (count, width)
    if count == 0 or not pointer:
        return numpy.empty(shape, numpy_code) if numpy else memoryview(array.array(code))
    address = ctypes.addressof(pointer.contents)
    if numpy:
        holder = _Holder(owner, {"version": 3, "shape": shape, "typestr": numpy_code, "data": (address, True)})
        owner._views.add(holder)
        return numpy.asarray(holder)
    memory = (kind * (count * width)).from_address(address)
    holder = memory.owner = _Holder(owner, None)
    owner._views.add(holder)
    return memoryview(memory).toreadonly().cast("B").cast(code, shape)


def _flat(values: Any) -> Iterator[Any]:
    if isinstance(values, memoryview):  # rows of a view cannot be iterated; its bytes can
        values = values.cast("B").cast(values.format[-1])
    for value in values:
        if hasattr(value, "__iter__"):
            yield from _flat(value)
        else:
            yield value


def doubles(values: Numbers, width: int = 1) -> tuple[Any, int]:
    """(C array, rows) of numbers, nested or flat; ValueError when they do not fill rows of `width`."""
    return _c_array(ctypes.c_double, "d", values, width)


def integers(values: Numbers, width: int = 1) -> tuple[Any, int]:
    """The same for int32."""
    return _c_array(ctypes.c_int32, "i", values, width)


def _c_array(kind: Any, code: str, values: Any, width: int) -> tuple[Any, int]:
    if numpy is not None and isinstance(values, numpy.ndarray):
        flat = numpy.ascontiguousarray(values, dtype=_CODES[kind][1]).reshape(-1)
        data = (kind * len(flat)).from_buffer_copy(flat)
    else:
        flat = array.array(code, _flat(values))
        data = (kind * len(flat)).from_buffer_copy(flat)
    if len(data) % width:
        raise ValueError(f"{len(data)} numbers do not make rows of {width}")
    return data, len(data) // width


def result(data: Any, width: int = 1) -> Any:
    """A C array that this side owns, as an ndarray or a list of rows."""
    if numpy:
        flat = numpy.ctypeslib.as_array(data)
        return flat if width == 1 else flat.reshape(-1, width)
    flat = list(data)
    return flat if width == 1 else [flat[i:i + width] for i in range(0, len(flat), width)]
