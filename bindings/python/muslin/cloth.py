"""cloth.py: a pattern cut in a fabric: nodes, springs, seam pairs."""
import ctypes

from . import _abi
from ._library import lib
from .arrays import view
from .context import Object, create, fill, make_def, read_struct, text


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


class Cloth(Object):
    """A pattern cut in cloth. fabric: a name or a Fabric; spacing of the lattice [m]."""

    _kind = "cloth"

    def __init__(self, pattern, fabric=None, spacing=None):
        definition = make_def(_abi.mus_cloth_def, lib.mus_cloth_def_init,
                              {"spacing": spacing} if spacing is not None else {})
        if fabric is not None:
            definition.fabric = (fabric if isinstance(fabric, Fabric) else Fabric(fabric)).struct
        context = pattern.context
        super().__init__(context, create(context, "cloth", "mus_cloth_create", context.handle, pattern.handle,
                                         ctypes.byref(definition)))

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
