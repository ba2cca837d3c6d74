"""body.py: a body made of stacks of closed contours that fit the tape."""
from __future__ import annotations

import ctypes
import math
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrays import doubles, result, view
from .context import Context, Valued, create, fill, make_def, plain
from .pose import Move, Pose
from .tape import Tape, measures

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from ._types import Array, Numbers, PathLike

_LANDMARKS = {name[len("MUS_LANDMARK_"):].lower(): value for name, value in vars(_abi).items()
              if name.startswith("MUS_LANDMARK_") and name != "MUS_LANDMARK_COUNT"}


def _options(definition: Any) -> dict[str, Any]:
    """Options of a mus_body_def, without limbs, the length of an array that the package does not use."""
    return {name: value for name, value in plain(definition).items() if name != "limbs"}


class Body(Valued):
    """A body made from a Tape, or from what Tape.of() takes: a path, the name of a table size.

    options: the fields of mus_body_def: samples round a contour, ring_spacing [m], ellipse, plain, without (limbs to
    leave out), and the posture stoop, head_forward, sway [m]. Bodies that are made from the same things are equal."""

    _kind = "body"

    def __init__(self, tape: Tape | PathLike, _handle: Any = None, _made: Any = None, **options: Any) -> None:
        if _handle is None:
            tape = Tape.of(tape)
            context = tape.context
            definition = make_def(_abi.mus_body_def, lib.mus_body_def_init, options)
            _made = ("tape", tape._state(), _options(definition))
            _handle = create(context, "body", "mus_body_create", context.handle, tape.handle, ctypes.byref(definition))
        else:
            context = tape
        super().__init__(context, _handle)
        self._made = _made  # what it is made from: a kind, and plain values

    def _state(self) -> tuple[Any, ...]:
        return self._made

    @classmethod
    def _of_state(cls, context: Context, *state: Any) -> Body:
        kind, what, options = state
        if kind == "tape":
            return cls(Tape._of_state(context, *what), **options)
        if kind == "limbs":
            return cls.of_limbs(what, context, **options)
        if kind == "pose":
            return cls._of_state(context, *what).posed(Pose._of_state(options))
        from .scan import scan
        return scan(*(memoryview(data).cast(code) for data, code in zip(what, "di")), context, **options)[0]

    def __hash__(self) -> int:
        return hash(repr(self._state()))

    def _told(self) -> str:
        return f"of {'a ' if self._made[0] != 'limbs' else ''}{self._made[0]}, {len(self.limbs)} limbs, " \
               f"{self.get('vertex_count')} vertices, {1000 * self.volume:.1f} l"

    @classmethod
    def of_limbs(cls, limbs: Sequence[Mapping[str, Any]], context: Context | None = None, **options: Any) -> Body:
        """A body of given limbs, without a tape. Each limb is a dict with the fields of mus_limb: contour, rows of
        (s, centre a, centre b, half breadth, half depth, exponent); pole (below, above); and, where the defaults do not
        fit, name, origin, axis, side. With outline, a list of corners (a, b) for each contour, contours are polygons
        and not superellipses."""
        context = context or Context.of_thread()
        kept, structs = [], (_abi.mus_limb * len(limbs))()
        for struct, limb in zip(structs, limbs):
            rows = [number for row in limb["contour"] for number in row]
            kept.append((ctypes.c_double * len(rows))(*rows))
            given = {**limb, "contour": kept[-1], "contours": len(limb["contour"])}
            if limb.get("outline"):
                numbers = [number for contour in limb["outline"] for corner in contour for number in corner]
                kept.append((ctypes.c_double * len(numbers))(*numbers))
                given.update(outline=kept[-1], corners=len(limb["outline"][0]))
            lib.mus_limb_init(ctypes.byref(struct), ctypes.sizeof(struct))
            fill(struct, given)
        definition = make_def(_abi.mus_body_def, lib.mus_body_def_init, options)
        handle = create(context, "body", "mus_body_create_limbs", context.handle, len(limbs), structs,
                        ctypes.byref(definition))
        return cls(context, _handle=handle, _made=("limbs", limbs, _options(definition)))

    def remade(self, **options: Any) -> Body:
        """A body of the same tape, limbs or mesh with other options, in the pose that it was made in."""
        kind, what, given = self._made
        if kind == "pose":
            return Body._of_state(self.context, *what).remade(**options).posed(Pose._of_state(given))
        return Body._of_state(self.context, kind, what, {**given, **options})

    def posed(self, pose: Pose) -> Body:
        """A copy of the body in a Pose (or a mus_pose); measures and volume are those of the rest pose."""
        return Body(self.context, _handle=create(self.context, "body", "mus_body_pose", self.handle,
                                                 ctypes.byref(getattr(pose, "struct", pose))),
                    _made=("pose", self._made, Pose._of_struct(pose)._state()))

    @property
    def rest_pose(self) -> Pose:
        """The Pose that the body was made in."""
        return self._pose("rest_pose")

    @property
    def stance(self) -> Pose:
        """The Pose that the body stands in."""
        return self._pose("stance")

    def _pose(self, function: str) -> Pose:
        pose = Pose()
        self.do(function, ctypes.byref(pose.struct))
        return pose

    def fit(self, pose: Pose, gap: float = 0.012) -> Pose:
        """Fit a Pose to the body: arms `gap` [m] off its sides, its feet (pose.feet) on the floor. Returns the pose."""
        self.do("clear_arms", ctypes.byref(pose.struct), gap)
        self.do("stand", pose.feet, ctypes.byref(pose.struct))
        return pose

    def move(self, name: str, gap: float = 0.012) -> Move:
        """A named Move fitted to the body: feet on the floor, arms `gap` [m] off its sides."""
        return Move(name, _handle=create(self.context, "move", "mus_body_move", self.handle, name.encode(), gap),
                    context=self.context)

    @property
    def vertices(self) -> Array:
        """Vertices of the skin (n x 3) [m], a view."""
        return view(self, self.get("vertices"), self.get("vertex_count"), 3)

    @property
    def normals(self) -> Array:
        """Outward unit normals of the vertices (n x 3), a view."""
        return view(self, self.get("normals"), self.get("vertex_count"), 3)

    @property
    def triangles(self) -> Array:
        """Triangles of the skin (m x 3), winding outwards, a view."""
        return view(self, self.get("triangles"), self.get("triangle_count"), 3)

    @property
    def limbs(self) -> list[str]:
        """Names of the limbs."""
        return [self.get("limb_name", i) for i in range(self.get("limb_count"))]

    def limb_range(self, limb: str) -> tuple[int, int, int, int]:
        """(first vertex, vertex count, first triangle, triangle count) of a limb by name."""
        numbers = (ctypes.c_int32 * 4)()
        self.do("limb_range", self.limbs.index(limb), numbers)
        return tuple(numbers)

    def contour(self, limb: str, contour: str, n: int = 96) -> Array:
        """`n` points (n x 3) round a contour of a limb, both by name."""
        limb = self.limbs.index(limb)
        names = [self.get("contour_name", limb, i) for i in range(self.get("contour_count", limb))]
        points = (ctypes.c_double * (3 * n))()
        self.do("contour_points", limb, names.index(contour), n, points)
        return result(points, 3)

    def contours(self, limb: str) -> list[str]:
        """Names of the contours of a limb, in the order of its axis."""
        limb = self.limbs.index(limb)
        return [self.get("contour_name", limb, i) for i in range(self.get("contour_count", limb))]

    @property
    def asked(self) -> dict[str, float]:
        """{measure: value of the completed tape} [m] or [rad]."""
        return self._measures("asked")

    @property
    def made(self) -> dict[str, float]:
        """{measure: value on the finished surface} [m] or [rad], without those that are not measured there."""
        return self._measures("made")

    def _measures(self, function: str) -> dict[str, float]:
        values = {name: self.get(function, i) for i, name in enumerate(measures())}
        return {name: value for name, value in values.items() if not math.isnan(value)}

    @property
    def volume(self) -> float:
        """Volume of the union of the limbs [m3]."""
        return self.get("volume")

    def landmark(self, name: str) -> Array:
        """Position (3) of a landmark [m]: crown, nape, bust, waist, hip, crotch, shoulder_left, ..."""
        place = (ctypes.c_double * 3)()
        self.do("landmark", _LANDMARKS[name], place)
        return result(place)

    def depth(self, points: Numbers) -> Array:
        """Depths of points (n x 3) [m], positive inside; -1e30 for a point more than 5 cm outside."""
        places, n = doubles(points, 3)
        depth = (ctypes.c_double * n)()
        self.do("depth", n, places, depth, None)
        return result(depth)
