"""integrate.py: fixed steps of a flat state with a rate function written in Python."""
from __future__ import annotations

import array
import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrays import doubles, numpy, result
from .context import Context, make_def
from .errors import MuslinError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from ._types import Numbers

METHODS = {"rk4": _abi.MUS_METHOD_RK4, "verlet": _abi.MUS_METHOD_VERLET, "euler": _abi.MUS_METHOD_EULER}
_KINDS = {64: (ctypes.c_double, "", "mus_integrate"), 32: (ctypes.c_float, "32", "mus_integrate_f32")}


class _Functions:
    """The caller's functions as C calls them. An exception cannot pass through C: the first one is kept, and from then
    on the rate is not a number, which ends the run."""

    def __init__(self, n: int, kind: Any, rate: Any, energy: Any) -> None:
        self.n, self.kind, self._rate, self._energy = n, kind, rate, energy
        self.raised = None

    def _array(self, pointer: Any) -> Any:
        """What C lends for the time of a call."""
        memory = (self.kind * self.n).from_address(ctypes.addressof(pointer.contents))
        return numpy.ctypeslib.as_array(memory) if numpy else memoryview(memory).cast("B").cast(self.kind._type_)

    def rate(self, _: Any, t: float, y: Any, dy: Any) -> None:
        if self.raised is None:
            try:
                values = array.array(self.kind._type_, self._rate(t, self._array(y)))
                if len(values) != self.n:
                    raise ValueError(f"the rate has {len(values)} numbers, the state {self.n}")
                ctypes.memmove(dy, values.buffer_info()[0], self.n * values.itemsize)
                return
            except BaseException as error:
                self.raised = error
        ctypes.memset(dy, 0xff, self.n * ctypes.sizeof(self.kind))

    def energy(self, _: Any, t: float, y: Any) -> float:
        if self.raised is None:
            try:
                return float(self._energy(t, self._array(y)))
            except BaseException as error:
                self.raised = error
        return float("nan")


def integrate(rate: Callable[[float, Any], Iterable[float]], y: Numbers, step: float, steps: int, *,
              method: str = "rk4", precision: int = 64, energy: Callable[[float, Any], float] | None = None,
              context: Context | None = None, **options: Any) -> Any:
    """State after `steps` steps of `step` from `y`: rate(t, y) gives dy/dt, n numbers.

    method: "rk4"; "verlet" or "euler", whose state is places and then velocities. energy(t, y) guards the run.
    options: start, guard_every, energy_growth, energy_floor (mus_integrate_def). A run that blows up raises MuslinError
    with the last good state as its `state` and its step as `done`. The y of a callback is lent for the call.
    """
    if method not in METHODS or precision not in _KINDS:
        raise ValueError(f"method is {method!r}, one of {', '.join(METHODS)}; precision {precision!r}, 32 or 64")
    kind, suffix, name = _KINDS[precision]
    data, n = doubles(y)
    data = (kind * n)(*data)
    functions = _Functions(n, kind, rate, energy)
    definition = make_def(_abi.mus_integrate_def, lib.mus_integrate_def_init,
                          {"method": METHODS[method], "step": step, **options})
    setattr(definition, "rate" + suffix, getattr(_abi, f"mus_rate{suffix}_fn")(functions.rate))
    if energy is not None:
        setattr(definition, "energy" + suffix, getattr(_abi, f"mus_energy{suffix}_fn")(functions.energy))
    work, done = (kind * lib.mus_integrate_work(definition.method, n))(), ctypes.c_int64()
    context = context or Context.of_thread()
    try:
        context.call(name, context.handle, ctypes.byref(definition), n, data, steps, work, ctypes.byref(done))
    except MuslinError as error:
        if functions.raised is not None:
            raise functions.raised from None
        error.state, error.done = result(data), done.value
        raise
    if functions.raised is not None:
        raise functions.raised
    return result(data)
