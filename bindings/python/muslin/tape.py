"""tape.py: the tailor's measures of one person."""
import math

from . import _abi
from ._library import lib
from .context import Context, Object, create, taken_bytes, text

_SEXES = {"unset": _abi.MUS_SEX_UNSET, "female": _abi.MUS_SEX_FEMALE, "male": _abi.MUS_SEX_MALE,
          "child": _abi.MUS_SEX_CHILD}
_SOURCES = {_abi.MUS_SOURCE_NONE: None, _abi.MUS_SOURCE_GIVEN: "given", _abi.MUS_SOURCE_DERIVED: "derived"}


def measures():
    """Names of all measures, in the library's order."""
    return [lib.mus_measure_name(i).decode() for i in range(lib.mus_measure_count())]


def sizes():
    """Names of the table sizes ("W40", "M50", "C116")."""
    return [lib.mus_tape_size_name(i).decode() for i in range(lib.mus_tape_size_count())]


def measure_index(name):
    """Index of a measure by name or alias; KeyError for an unknown one."""
    index = lib.mus_measure_find(text(name))
    if index == _abi.MUS_NONE:
        raise KeyError(name)
    return index


class Tape(Object):
    """Measures by name: tape["waist"] = 0.76 (metre; the angles in radian); tape["waist"] is None when unset."""

    _kind = "tape"

    def __init__(self, sex=None, name=None, context=None, _handle=None, **given):
        context = context or Context.of_thread()
        super().__init__(context, _handle or create(context, "tape", "mus_tape_create", context.handle))
        if sex is not None:
            self.sex = sex
        if name is not None:
            self.name = name
        for measure, value in given.items():
            self[measure] = value

    @classmethod
    def size(cls, size, context=None):
        """A tape of a table size, by its name."""
        tape = cls(context=context)
        tape.do("set_size", text(size))
        return tape

    @classmethod
    def read(cls, path, row=None, context=None):
        """Read a file: .tape or .txt, .yaml (GarmentCode body), .vit, .csv (`row` names the row)."""
        context = context or Context.of_thread()
        return cls(context=context,
                   _handle=create(context, "tape", "mus_tape_read", context.handle, text(path), text(row)))

    @classmethod
    def parse(cls, data, name="tape.tape", row=None, context=None):
        """From the text of a file (str or bytes); the ending of `name` tells the form, as the path does for read()."""
        context = context or Context.of_thread()
        data = text(data)
        return cls(context=context, _handle=create(context, "tape", "mus_tape_read_from", context.handle, data,
                                                   len(data), text(name), text(row)))

    def write(self, path):
        """Write a .tape file."""
        self.context.call("mus_tape_write", self.handle, text(path))

    def to_bytes(self):
        """The bytes that write() would write."""
        return taken_bytes(self.context, "mus_tape_write_bytes", self.handle)

    def copy(self):
        """A copy of the tape."""
        return Tape(context=self.context, _handle=create(self.context, "tape", "mus_tape_copy", self.handle))

    def __getitem__(self, measure):
        value = self.get("value", measure_index(measure))
        return None if math.isnan(value) else value

    def __setitem__(self, measure, value):
        value = math.nan if value is None else value
        self.do("set", measure_index(measure), value, _abi.MUS_SOURCE_GIVEN)

    def source(self, measure):
        """Source of a measure: None, "given" or "derived"."""
        return _SOURCES[self.get("source", measure_index(measure))]

    def items(self):
        """List of (name, value) of the measures that are set."""
        pairs = ((name, self[name]) for name in measures())
        return [(name, value) for name, value in pairs if value is not None]

    def complete(self):
        """Derive the measures that are not set and check the tape; returns the warnings."""
        self.do("complete")
        return self.warnings

    @property
    def is_complete(self):
        """Whether complete() succeeded and nothing was set since."""
        return bool(self.get("is_complete"))

    @property
    def warnings(self):
        """Warnings of the last complete()."""
        return [self.get("warning", i) for i in range(self.get("warning_count"))]

    @property
    def sex(self):
        """"unset", "female", "male" or "child"."""
        number = self.get("sex")
        return next(name for name, value in _SEXES.items() if value == number)

    @sex.setter
    def sex(self, value):
        if value not in _SEXES:
            raise ValueError(f"sex is one of {', '.join(_SEXES)}, not {value!r}")
        self.do("set_sex", _SEXES[value])

    @property
    def name(self):
        """Name for reports and labels; "" without one."""
        return self.get("name")

    @name.setter
    def name(self, value):
        self.do("set_name", text(value))
