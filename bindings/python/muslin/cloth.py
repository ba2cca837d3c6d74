"""cloth.py: a pattern cut in a fabric: nodes, springs, seam pairs."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrays import doubles, integers, view
from .context import Context, Valued, create, fill, make_def, plain, read_struct, text
from .pattern import Pattern

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from ._types import Array, Numbers, PathLike


# models of bending
PLATE, PAPER = _abi.MUS_BEND_PLATE, _abi.MUS_BEND_PAPER


def fabrics() -> dict[str, str]:
    """{name: where its numbers come from} of the named fabrics."""
    return {lib.mus_fabric_name(i).decode(): lib.mus_fabric_source(i).decode() for i in range(lib.mus_fabric_count())}


class Fabric:
    """A fabric by name, some of its numbers changed: Fabric("jersey", friction=0.4). Without a name it is jersey without
    friction of bending, as a Cloth.grid is without a fabric."""

    def __init__(self, name: str | None = None, **options: Any) -> None:
        self.struct = make_def(_abi.mus_fabric, lib.mus_fabric_init)
        if name is not None and lib.mus_fabric_find(text(name), ctypes.byref(self.struct)) != _abi.MUS_OK:
            raise KeyError(f"no fabric {name!r}: {', '.join(fabrics())}")
        fill(self.struct, options)

    def __reduce__(self) -> Any:
        return _fabric_of, (self.values(),)

    def __eq__(self, other: object) -> bool:
        return self.values() == other.values() if isinstance(other, Fabric) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"Fabric({', '.join(f'{name}={value}' for name, value in self.values().items())})"

    def values(self) -> dict[str, Any]:
        return read_struct(self.struct)

    @classmethod
    def read(cls, path: PathLike, context: Context | None = None) -> Fabric:
        """The fabric of a file (muslin_fabric(5))."""
        context = context or Context.of_thread()
        fabric = cls()
        context.call("mus_fabric_load", context.handle, text(path), ctypes.byref(fabric.struct))
        return fabric

    @classmethod
    def parse(cls, data: str | bytes, name: str = "fabric.json", context: Context | None = None) -> Fabric:
        """The fabric of the text of a file (str or bytes)."""
        context = context or Context.of_thread()
        fabric, data = cls(), text(data)
        context.call("mus_fabric_load_from", context.handle, data, len(data), text(name), ctypes.byref(fabric.struct))
        return fabric

    def write(self, path: PathLike, name: str, sources: Mapping[str, str] | None = None,
              context: Context | None = None) -> None:
        """Write a fabric file. sources: {key of the value: where it comes from}; None: those of the named fabric."""
        context = context or Context.of_thread()
        texts = None
        if sources is not None:
            keys = [lib.mus_fabric_value_key(value).decode() for value in range(lib.mus_fabric_value_count())]
            texts = (ctypes.c_char_p * len(keys))(*[text(sources[key]) for key in keys])
        context.call("mus_fabric_save", context.handle, ctypes.byref(self.struct), text(name), texts, text(path))


def _fabric_of(values: Mapping[str, Any]) -> Fabric:
    return Fabric(**values)


def _definition(fabric: str | Fabric | None, options: Mapping[str, Any]) -> Any:
    definition = make_def(_abi.mus_cloth_def, lib.mus_cloth_def_init, options)
    if fabric is not None:
        definition.fabric = ctypes.pointer((fabric if isinstance(fabric, Fabric) else Fabric(fabric)).struct)
    return definition


def _cut_in(definition: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    """Values of the fabric, and the options, of a mus_cloth_def."""
    fabric = definition.fabric.contents if definition.fabric else Fabric().struct
    return plain(fabric), plain(definition)


class Cloth(Valued):
    """A pattern cut in cloth. fabric: a name or a Fabric; spacing of the lattice [m]; options: fields of mus_cloth_def
    (bending=muslin.cloth.PAPER, paper_curvature, coarser, nodes_most=100000). Cloths that are cut of equal patterns
    in equal ways are equal. That of dress() is neither copied nor pickled: it is cut after the garment's retries."""

    _kind = "cloth"

    def __init__(self, pattern: Pattern, fabric: str | Fabric | None = None, spacing: float | None = None,
                 **options: Any) -> None:
        if spacing is not None:
            options["spacing"] = spacing
        definition = _definition(fabric, options)
        context = pattern.context
        super().__init__(context, create(context, "cloth", "mus_cloth_create", context.handle, pattern.handle,
                                         ctypes.byref(definition)))
        self._made = ("pattern", pattern.copy(), _cut_in(definition))

    _made: tuple[Any, ...] | None = None

    def _state(self) -> tuple[Any, ...]:
        if self._made is None:
            raise TypeError("the cloth of dress() cannot be copied or pickled: its pattern and body can")
        kind, what, how = self._made
        return kind, what._state() if kind == "pattern" else what, how

    @classmethod
    def _of_state(cls, context: Context, *state: Any) -> Cloth:
        kind, what, (fabric, options) = state
        fabric = _fabric_of(fabric)
        if kind == "pattern":
            return cls(Pattern._of_state(context, *what), fabric, **options)
        if kind == "grid":
            return cls.grid(*what, fabric, context, **options)
        return cls.bare(*what, context=context)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Cloth) and None in (self._made, other._made):
            return self is other
        return super().__eq__(other)

    def __hash__(self) -> int:
        return hash(repr(self._state())) if self._made else id(self)

    def close(self) -> None:
        super().close()
        if self._made is not None and self._made[0] == "pattern":
            self._made[1].close()

    def _told(self) -> str:
        return f"{len(self)} nodes, {1000 * self.spacing:g} mm, {self.spring_count} springs, {self.mass:.3g} kg"

    @classmethod
    def _own(cls, context: Context, function: str, *arguments: Any) -> Cloth:
        return cls._owned(context, create(context, "cloth", function, context.handle, *arguments))

    @classmethod
    def grid(cls, rows: int, columns: int, cell: Numbers, fabric: str | Fabric | None = None,
             context: Context | None = None, **options: Any) -> Cloth:
        """A rectangle that is one pure lattice; cell: (along weft, along warp) [m]. Node r * columns + c."""
        definition = _definition(fabric, options)
        cloth = cls._own(context or Context.of_thread(), "mus_cloth_create_grid", rows, columns,
                         (ctypes.c_double * 2)(*cell), ctypes.byref(definition))
        cloth._made = ("grid", (rows, columns, tuple(cell)), _cut_in(definition))
        return cloth

    @classmethod
    def bare(cls, place: Numbers, mass: Numbers, springs: Iterable[Sequence[float]] = (),
             bends: Iterable[Sequence[float]] = (), pins: Sequence[int] = (), context: Context | None = None) -> Cloth:
        """Bare nodes at `place` (n x 3) with `mass` (n).

        springs: (a, b, length, stiffness) or (a, b, length, stiffness, dashpot) each; bends: (a, b, c, stiffness) with
        E = stiffness / 2 |a - 2 b + c|^2; pins: nodes.
        """
        springs, bends = list(springs), list(bends)
        bare = make_def(_abi.mus_bare, lib.mus_bare_init)
        bare.place, bare.nodes = doubles(place, 3)
        bare.mass, count = doubles(mass)
        if count != bare.nodes:
            raise ValueError(f"{count} masses for {bare.nodes} nodes")
        bare.spring, bare.springs = integers([spring[:2] for spring in springs], 2)
        bare.length, bare.stiffness, bare.dashpot = (
            doubles([spring[i] if i < len(spring) else 0.0 for spring in springs])[0] for i in (2, 3, 4))
        bare.bend, bare.bends = integers([bend[:3] for bend in bends], 3)
        bare.bend_stiffness = doubles([bend[3] for bend in bends])[0]
        bare.pin, bare.pins = integers(pins)
        cloth = cls._own(context or Context.of_thread(), "mus_cloth_create_bare", ctypes.byref(bare))
        cloth._made = ("bare", (list(bare.place[:3 * count]), list(bare.mass[:count]), springs, bends, list(pins)),
                       ({}, {}))
        return cloth

    def __len__(self) -> int:
        return self.get("node_count")

    @property
    def rest(self) -> Array:
        """Places of the nodes in their panels (n x 2) [m], a view."""
        return view(self, self.get("rest"), len(self), 2)

    @property
    def node_panels(self) -> Array:
        """Panel of each node, a view."""
        return view(self, self.get("node_panels"), len(self))

    @property
    def masses(self) -> Array:
        """Mass of each node [kg], a view."""
        return view(self, self.get("masses"), len(self))

    @property
    def triangles(self) -> Array:
        """(m x 3), a view; right side out."""
        return view(self, self.get("triangles"), self.get("triangle_count"), 3)

    @property
    def pairs(self) -> Array:
        """Node pairs that seams bring together (k x 2), a view."""
        return view(self, self.get("pairs"), self.get("pair_count"), 2)

    @property
    def pair_seams(self) -> Array:
        """Seam of each pair, a view."""
        return view(self, self.get("pair_seams"), self.get("pair_count"))

    @property
    def spring_count(self) -> int:
        return self.get("spring_count")

    @property
    def spacing(self) -> float:
        """[m]."""
        return self.get("spacing")

    @property
    def mass(self) -> float:
        """[kg]."""
        return self.get("mass")

    def panel_range(self, panel: int) -> tuple[int, int, int, int]:
        """(first node, node count, first triangle, triangle count) of a panel."""
        numbers = (ctypes.c_int32 * 4)()
        self.do("panel_range", panel, numbers)
        return tuple(numbers)
