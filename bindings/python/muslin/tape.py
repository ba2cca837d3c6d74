"""tape.py: the tailor's measures of one person."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .context import Context, Valued, create, taken_bytes, text

if TYPE_CHECKING:
    from ._types import PathLike

_SEXES = {"unset": _abi.MUS_SEX_UNSET, "female": _abi.MUS_SEX_FEMALE, "male": _abi.MUS_SEX_MALE,
          "child": _abi.MUS_SEX_CHILD}
_SOURCES = {_abi.MUS_SOURCE_NONE: None, _abi.MUS_SOURCE_GIVEN: "given", _abi.MUS_SOURCE_DERIVED: "derived"}


def measures() -> list[str]:
    """Names of all measures, in the library's order."""
    return [lib.mus_measure_name(i).decode() for i in range(lib.mus_measure_count())]


def sizes() -> list[str]:
    """Names of the table sizes ("W40", "M50", "C116")."""
    return [lib.mus_tape_size_name(i).decode() for i in range(lib.mus_tape_size_count())]


def measure_index(name: str) -> int:
    """Index of a measure by name or alias; KeyError for an unknown one."""
    index = lib.mus_measure_find(text(name))
    if index == _abi.MUS_NONE:
        raise KeyError(name)
    return index


class Tape(Valued):
    """Measures by name: tape["waist"] = 0.76 (metre; the angles in radian), or a text with a unit as in a tape file:
    tape["waist"] = "76 cm"; tape["waist"] is None when unset. Tapes with the same measures and sources are equal."""

    _kind = "tape"

    def __init__(self, sex: str | None = None, name: str | None = None, context: Context | None = None,
                 _handle: Any = None, **given: float | str | None) -> None:
        context = context or Context.of_thread()
        super().__init__(context, _handle or create(context, "tape", "mus_tape_create", context.handle))
        if sex is not None:
            self.sex = sex
        if name is not None:
            self.name = name
        for measure, value in given.items():
            self[measure] = value

    @classmethod
    def size(cls, size: str, context: Context | None = None) -> Tape:
        """A tape of a table size, by its name."""
        tape = cls(context=context)
        tape.do("set_size", text(size))
        return tape

    @classmethod
    def of(cls, wearer: Tape | PathLike, context: Context | None = None) -> Tape:
        """A Tape as it is; of a text that names a table size ("W40") that size; else the tape of a file."""
        if isinstance(wearer, Tape):
            return wearer
        if str(wearer) in sizes():
            return cls.size(str(wearer), context)
        return cls.read(wearer, context=context)

    @classmethod
    def read(cls, path: PathLike, row: str | None = None, context: Context | None = None) -> Tape:
        """Read a file: .tape or .txt, .yaml (GarmentCode body), .vit, .csv (`row` names the row)."""
        context = context or Context.of_thread()
        return cls(context=context,
                   _handle=create(context, "tape", "mus_tape_read", context.handle, text(path), text(row)))

    @classmethod
    def parse(cls, data: str | bytes, name: str = "tape.tape", row: str | None = None,
              context: Context | None = None) -> Tape:
        """From the text of a file (str or bytes); the ending of `name` tells the form, as the path does for read()."""
        context = context or Context.of_thread()
        data = text(data)
        return cls(context=context, _handle=create(context, "tape", "mus_tape_read_from", context.handle, data,
                                                   len(data), text(name), text(row)))

    def write(self, path: PathLike) -> None:
        """Write a .tape file."""
        self.context.call("mus_tape_write", self.handle, text(path))

    def to_bytes(self) -> bytes:
        """The bytes that write() would write."""
        return taken_bytes(self.context, "mus_tape_write_bytes", self.handle)

    def copy(self) -> Tape:
        """A copy of the tape."""
        return Tape(context=self.context, _handle=create(self.context, "tape", "mus_tape_copy", self.handle))

    def __getitem__(self, measure: str) -> float | None:
        value = self.get("value", measure_index(measure))
        return None if math.isnan(value) else value

    def __setitem__(self, measure: str, value: float | str | None) -> None:
        if isinstance(value, str):
            value = Tape.parse(f"{measure} {value}\n", context=self.context)[measure]
        value = math.nan if value is None else value
        self.do("set", measure_index(measure), value, _abi.MUS_SOURCE_GIVEN)

    def _state(self) -> tuple[Any, ...]:
        return (self.sex, self.name, self.is_complete,
                tuple((name, value, self.source(name)) for name, value in self.items()))

    @classmethod
    def _of_state(cls, context: Context, *state: Any) -> Tape:
        sex, name, is_complete, given = state
        tape, number = cls(sex, name, context), {word: value for value, word in _SOURCES.items()}
        for measure, value, source in given:
            tape.do("set", measure_index(measure), value, number[source])
        if is_complete:
            tape.complete()
        return tape

    def _told(self) -> str:
        known = {name: self[name] for name in ("stature", "bust", "waist", "hip")}
        told = ", ".join(f"{name} {100 * value:g} cm" for name, value in known.items() if value is not None)
        return f"{self.name!r}, {self.sex}, {told}; {len(self.items())} measures"

    def source(self, measure: str) -> str | None:
        """Source of a measure: None, "given" or "derived"."""
        return _SOURCES[self.get("source", measure_index(measure))]

    def items(self) -> list[tuple[str, float]]:
        """List of (name, value) of the measures that are set."""
        pairs = ((name, self[name]) for name in measures())
        return [(name, value) for name, value in pairs if value is not None]

    def complete(self) -> list[str]:
        """Derive the measures that are not set and check the tape; returns the warnings."""
        self.do("complete")
        return self.warnings

    @property
    def is_complete(self) -> bool:
        """Whether complete() succeeded and nothing was set since."""
        return bool(self.get("is_complete"))

    @property
    def warnings(self) -> list[str]:
        """Warnings of the last complete()."""
        return [self.get("warning", i) for i in range(self.get("warning_count"))]

    @property
    def sex(self) -> str:
        """"unset", "female", "male" or "child"."""
        number = self.get("sex")
        return next(name for name, value in _SEXES.items() if value == number)

    @sex.setter
    def sex(self, value: str) -> None:
        if value not in _SEXES:
            raise ValueError(f"sex is one of {', '.join(_SEXES)}, not {value!r}")
        self.do("set_sex", _SEXES[value])

    @property
    def name(self) -> str:
        """Name for reports and labels; "" without one."""
        return self.get("name")

    @name.setter
    def name(self, value: str) -> None:
        self.do("set_name", text(value))
