"""fit.py: how a draped garment fits."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrays import view
from .context import Object, create, make_def, read_struct

if TYPE_CHECKING:
    from ._types import Array
    from .body import Body
    from .drape import Drape


class Fit(Object):
    """Ease a level, strain, pressure and gap of a drape as it stands now; without its body there are no levels."""

    _kind = "fit"

    def __init__(self, drape: Drape, body: Body | None = None) -> None:
        super().__init__(drape.context, create(drape.context, "fit", "mus_fit_create", drape.handle,
                                               body.handle if body is not None else None))

    def __len__(self) -> int:
        return self.get("node_count")

    def _told(self) -> str:
        return f"{len(self)} nodes, {len(self.levels)} levels"

    def to_pandas(self) -> Any:
        """The levels as a pandas DataFrame, a row each: level, side, body, garment, worn, ease, gap [m]."""
        import pandas
        return pandas.DataFrame(self.levels)

    def _array(self, name: str) -> Array:
        return view(self, self.get(name), len(self))

    @property
    def warp(self) -> Array:
        """Engineering strain along the warp at each node."""
        return self._array("warp")

    @property
    def weft(self) -> Array:
        """Engineering strain along the weft at each node."""
        return self._array("weft")

    @property
    def pressure(self) -> Array:
        """On the skin [Pa] at each node."""
        return self._array("pressure")

    @property
    def gap(self) -> Array:
        """Distance to the body [m] at each node, NaN where it is far."""
        return self._array("gap")

    @property
    def area(self) -> Array:
        """Area of the cloth that belongs to each node, in the flat [m2]."""
        return self._array("area")

    def spread(self, quantity: str) -> dict[str, float]:
        """How a quantity is spread over the cloth by area: a dict of p50, p95, p99, mean, least, largest, node, area.

        quantity: "strain" (the greater of warp and weft), "warp", "weft", "pressure" or "gap". Half of the area has at
        most p50. least and largest are those of one node and move apart as the mesh gets finer.
        """
        names = {"strain": _abi.MUS_FIT_STRAIN, "warp": _abi.MUS_FIT_WARP, "weft": _abi.MUS_FIT_WEFT,
                 "pressure": _abi.MUS_FIT_PRESSURE, "gap": _abi.MUS_FIT_GAP}
        if quantity not in names:
            raise ValueError(f"quantity {quantity!r} is not one of {', '.join(names)}")
        spread = make_def(_abi.mus_fit_spread, lib.mus_fit_spread_init)
        self.do("spread_get", names[quantity], ctypes.byref(spread))
        return read_struct(spread)

    @property
    def levels(self) -> list[dict[str, Any]]:
        """One dict a level: level and side by name, body, garment, worn, ease, gap [m]."""
        result = []
        for index in range(self.get("level_count")):
            level = make_def(_abi.mus_fit_level, lib.mus_fit_level_init)
            self.do("level_get", index, ctypes.byref(level))
            values = read_struct(level)
            right = values.pop("right")
            side = None if right == _abi.MUS_NONE else "right" if right else "left"
            result.append({**values, "level": lib.mus_hold_name(level.level).decode(), "side": side})
        return result

    @staticmethod
    def worn(drape, pattern, body):
        """Is the garment worn as its pattern means it? A dict of kind (a name, "worn" when it is), limb ("left arm" or
        None), panel, node, value, place, through, through_depth, through_area, through_place, text; lengths in metres.
        """
        worn = make_def(_abi.mus_worn, lib.mus_worn_init)
        drape.context.call("mus_fit_worn", drape.handle, pattern.handle, body.handle, ctypes.byref(worn))
        values = read_struct(worn)
        limbs = {_abi.MUS_WORN_NECK: "neck", _abi.MUS_WORN_ARM_LEFT: "left arm", _abi.MUS_WORN_ARM_RIGHT: "right arm",
                 _abi.MUS_WORN_LEG_LEFT: "left leg", _abi.MUS_WORN_LEG_RIGHT: "right leg"}
        panel = None if worn.panel == _abi.MUS_NONE else lib.mus_pattern_panel_name(pattern.handle, worn.panel).decode()
        return {**values, "kind": lib.mus_worn_name(worn.kind).decode(), "limb": limbs.get(worn.limb), "panel": panel,
                "place": tuple(worn.place), "through_place": tuple(worn.through_place), "text": worn.text.decode()}


__all__ = ["Fit"]
