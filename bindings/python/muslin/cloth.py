"""cloth.py: a pattern cut in a fabric: nodes, springs, seam pairs."""
import ctypes

from . import _abi
from ._library import lib
from .arrays import doubles, integers, view
from .context import Context, Object, create, fill, make_def, read_struct, text


# models of bending
PLATE, PAPER = _abi.MUS_BEND_PLATE, _abi.MUS_BEND_PAPER


def fabrics():
    """{name: where its numbers come from} of the named fabrics."""
    return {lib.mus_fabric_name(i).decode(): lib.mus_fabric_source(i).decode() for i in range(lib.mus_fabric_count())}


class Fabric:
    """A fabric by name (the default one without), some of its numbers changed: Fabric("jersey", friction=0.4)."""

    def __init__(self, name=None, **options):
        self.struct = make_def(_abi.mus_fabric, lib.mus_fabric_init)
        if name is not None and lib.mus_fabric_find(text(name), ctypes.byref(self.struct)) != _abi.MUS_OK:
            raise KeyError(f"no fabric {name!r}: {', '.join(fabrics())}")
        fill(self.struct, options)

    def values(self):
        return read_struct(self.struct)

    @classmethod
    def read(cls, path, context=None):
        """The fabric of a file (muslin_fabric(5))."""
        context = context or Context.of_thread()
        fabric = cls()
        context.call("mus_fabric_load", context.handle, text(path), ctypes.byref(fabric.struct))
        return fabric

    @classmethod
    def parse(cls, data, name="fabric.json", context=None):
        """The fabric of the text of a file (str or bytes)."""
        context = context or Context.of_thread()
        fabric, data = cls(), text(data)
        context.call("mus_fabric_load_from", context.handle, data, len(data), text(name), ctypes.byref(fabric.struct))
        return fabric

    def write(self, path, name, sources=None, context=None):
        """Write a fabric file. sources: {key of the value: where it comes from}; None: those of the named fabric."""
        context = context or Context.of_thread()
        texts = None
        if sources is not None:
            keys = [lib.mus_fabric_value_key(value).decode() for value in range(lib.mus_fabric_value_count())]
            texts = (ctypes.c_char_p * len(keys))(*[text(sources[key]) for key in keys])
        context.call("mus_fabric_save", context.handle, ctypes.byref(self.struct), text(name), texts, text(path))


def _definition(fabric, options):
    definition = make_def(_abi.mus_cloth_def, lib.mus_cloth_def_init, options)
    if fabric is not None:
        definition.fabric = ctypes.pointer((fabric if isinstance(fabric, Fabric) else Fabric(fabric)).struct)
    return definition


class Cloth(Object):
    """A pattern cut in cloth. fabric: a name or a Fabric; spacing of the lattice [m]; options: fields of mus_cloth_def
    (bending=muslin.cloth.PAPER, nodes_most=100000)."""

    _kind = "cloth"

    def __init__(self, pattern, fabric=None, spacing=None, **options):
        if spacing is not None:
            options["spacing"] = spacing
        definition = _definition(fabric, options)
        context = pattern.context
        super().__init__(context, create(context, "cloth", "mus_cloth_create", context.handle, pattern.handle,
                                         ctypes.byref(definition)))

    @classmethod
    def _own(cls, context, function, *arguments):
        return cls._owned(context, create(context, "cloth", function, context.handle, *arguments))

    @classmethod
    def grid(cls, rows, columns, cell, fabric=None, context=None, **options):
        """A rectangle that is one pure lattice; cell: (along weft, along warp) [m]. Node r * columns + c."""
        definition = _definition(fabric, options)
        return cls._own(context or Context.of_thread(), "mus_cloth_create_grid", rows, columns,
                        (ctypes.c_double * 2)(*cell), ctypes.byref(definition))

    @classmethod
    def bare(cls, place, mass, springs=(), bends=(), pins=(), context=None):
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
        return cls._own(context or Context.of_thread(), "mus_cloth_create_bare", ctypes.byref(bare))

    def __len__(self):
        return self.get("node_count")

    @property
    def rest(self):
        """Places of the nodes in their panels (n x 2) [m], a view."""
        return view(self, self.get("rest"), len(self), 2)

    @property
    def node_panels(self):
        """Panel of each node, a view."""
        return view(self, self.get("node_panels"), len(self))

    @property
    def masses(self):
        """Mass of each node [kg], a view."""
        return view(self, self.get("masses"), len(self))

    @property
    def triangles(self):
        """(m x 3), a view; right side out."""
        return view(self, self.get("triangles"), self.get("triangle_count"), 3)

    @property
    def pairs(self):
        """Node pairs that seams bring together (k x 2), a view."""
        return view(self, self.get("pairs"), self.get("pair_count"), 2)

    @property
    def pair_seams(self):
        """Seam of each pair, a view."""
        return view(self, self.get("pair_seams"), self.get("pair_count"))

    @property
    def spring_count(self):
        return self.get("spring_count")

    @property
    def spacing(self):
        """[m]."""
        return self.get("spacing")

    @property
    def mass(self):
        """[kg]."""
        return self.get("mass")

    def panel_range(self, panel):
        """(first node, node count, first triangle, triangle count) of a panel."""
        numbers = (ctypes.c_int32 * 4)()
        self.do("panel_range", panel, numbers)
        return tuple(numbers)
