"""pose.py: poses (the angles of a body's joints) and movements (poses over time)."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .context import Context, Object, create

if TYPE_CHECKING:
    from collections.abc import Sequence

JOINTS = [name.lower() for name in _abi.JOINT_NAMES]
AXES = ("flexion", "abduction", "rotation")


def poses() -> list[str]:
    """Names of the named poses."""
    return [lib.mus_pose_name(i).decode() for i in range(lib.mus_pose_count())]


def moves() -> list[str]:
    """Names of the named movements."""
    return [lib.mus_move_name(i).decode() for i in range(lib.mus_move_count())]


FOOT_LEFT, FOOT_RIGHT = _abi.MUS_FOOT_LEFT, _abi.MUS_FOOT_RIGHT


def joint_limits(joint: str) -> tuple[tuple[float, float], ...]:
    """Limits of a joint by name [rad]: (low, high) of flexion, of abduction and of rotation."""
    low, high, limits = ctypes.c_double(), ctypes.c_double(), []
    for axis in range(3):
        lib.mus_joint_limits(JOINTS.index(joint), axis, ctypes.byref(low), ctypes.byref(high))
        limits.append((low.value, high.value))
    return tuple(limits)


class Pose:
    """Angles of the joints [rad] and the place of the root [m]: pose["knee_left"] is (flexion, abduction, rotation).

    Pose() stands with hanging arms, Pose("sit") is a named pose; joints by keyword: Pose(knee_left=(1.5, 0, 0)).
    pose.feet are the feet that Body.fit() puts on the floor, a sum of FOOT_LEFT and FOOT_RIGHT: those of the named
    pose. With 0, as for joints by keyword, the lowest point of the body goes there.
    """

    def __init__(self, name: str | None = None, context: Context | None = None, **joints: Sequence[float]) -> None:
        self.struct = _abi.mus_pose()
        lib.mus_pose_init(ctypes.byref(self.struct), ctypes.sizeof(self.struct))
        self.feet = lib.mus_pose_feet(name.encode()) if name is not None else 0
        if name is not None:
            context = context or Context.of_thread()
            context.call("mus_pose_named", context.handle, name.encode(), ctypes.byref(self.struct))
        for joint, angles in joints.items():
            self[joint] = angles

    @classmethod
    def _of_struct(cls, struct: Any) -> Pose:
        """A Pose with a copy of a mus_pose; a Pose itself."""
        if isinstance(struct, Pose):
            return struct
        pose = cls()
        ctypes.memmove(ctypes.byref(pose.struct), ctypes.byref(struct), ctypes.sizeof(struct))
        return pose

    def _state(self) -> tuple[Any, ...]:
        return self.place, tuple(tuple(row) for row in self.struct.angle), self.feet

    @classmethod
    def _of_state(cls, state: tuple[Any, ...]) -> Pose:
        pose = cls()
        pose.place, angles, pose.feet = state
        for joint, row in zip(JOINTS, angles):
            pose[joint] = row
        return pose

    def __reduce__(self) -> Any:
        return Pose._of_state, (self._state(),)

    def __eq__(self, other: object) -> bool:
        return self._state() == other._state() if isinstance(other, Pose) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        bent = ", ".join(f"{joint}=({', '.join(f'{angle:.3g}' for angle in self[joint])})" for joint in JOINTS
                         if any(self[joint]))
        return f"Pose({bent})"

    def __getitem__(self, joint: str) -> tuple[float, float, float]:
        return tuple(self.struct.angle[JOINTS.index(joint)])

    def __setitem__(self, joint: str, angles: Sequence[float]) -> None:
        self.struct.angle[JOINTS.index(joint)][:] = angles

    @property
    def place(self) -> tuple[float, float, float]:
        """Translation (x, y, z) of the root from where the body was made [m]."""
        return tuple(self.struct.place)

    @place.setter
    def place(self, place: Sequence[float]) -> None:
        self.struct.place[:] = place

    def check(self, context: Context | None = None) -> None:
        """Raise MuslinError when an angle is beyond the limits of its joint."""
        context = context or Context.of_thread()
        context.call("mus_pose_check", context.handle, ctypes.byref(self.struct))


class Move(Object):
    """A movement: a named one for a stature, Move("walk", stature=1.7), or keys: Move(times, poses, period)."""

    _kind = "move"

    def __init__(self, name: str | Sequence[float], poses: Sequence[Pose] | None = None, period: float = 0.0,
                 stature: float = 1.7, context: Context | None = None, _handle: Any = None) -> None:
        context = context or Context.of_thread()
        if _handle is not None:
            handle = _handle
        elif poses is None:
            handle = create(context, "move", "mus_move_named", context.handle, name.encode(), stature)
        else:
            times = (ctypes.c_double * len(name))(*name)
            if len(times) != len(poses):
                raise ValueError(f"{len(times)} times and {len(poses)} poses")
            structs = (_abi.mus_pose * len(poses))(*[pose.struct for pose in poses])
            handle = create(context, "move", "mus_move_create", context.handle, len(poses), times, structs, period)
        super().__init__(context, handle)

    @property
    def period(self) -> float:
        """Period [s]; 0 for a movement that ends."""
        return self.get("period")

    @property
    def duration(self) -> float:
        """Time from the first to the last key [s], of a periodic movement its period."""
        return self.get("duration")

    def at(self, time: float) -> Pose:
        """The Pose at a time [s]."""
        pose = Pose()
        self.do("at", time, ctypes.byref(pose.struct))
        return pose
