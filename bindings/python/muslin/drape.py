"""drape.py: cloth in time: placed round a body, sewn, stepped, settled."""
from __future__ import annotations

import ctypes
import typing
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrange import read_reason
from .arrays import doubles, result, view
from .context import Object, create, make_def, read_struct
from .errors import MuslinError
from .integrate import METHODS
from .pose import Pose

if TYPE_CHECKING:
    from collections.abc import Callable

    from ._types import Array, Numbers
    from .body import Body
    from .cloth import Cloth
    from .pose import Pose


class Progress(typing.NamedTuple):
    """What a progress function is told: phase ("sew" or "settle"), share done (0 to 1), positions (n x 3) [m] and
    triangles (m x 3) of the cut that moves now, a copy, and whether that is a coarser one than the cloth itself."""

    phase: str
    share: float
    positions: object
    triangles: object
    coarse: bool


def _progress(told: Any) -> Progress:
    told = told.contents
    positions = (ctypes.c_double * (3 * told.nodes))()
    triangles = (ctypes.c_int32 * (3 * told.triangles))()
    ctypes.memmove(positions, told.positions, ctypes.sizeof(positions))
    if told.triangles:
        ctypes.memmove(triangles, told.triangle, ctypes.sizeof(triangles))
    return Progress(told.phase.decode(), told.progress, result(positions, 3), result(triangles, 3), bool(told.coarse))


def progress_hook(progress: Callable[[Progress], Any] | bool | None, raised: list[BaseException]) -> Any:
    """The C hook of a Python function, or a null one; what the function raises goes to the list `raised`."""
    if progress is None:
        return _abi.mus_progress_fn()

    def hook(_, told):
        try:
            return 1 if progress(_progress(told)) else 0
        except BaseException as error:  # an exception cannot pass through C: stop the run, and raise it after
            raised.append(error)
            return 1

    return _abi.mus_progress_fn(hook)


class Drape(Object):
    """A cloth round a body, or in empty space. options: gravity, precision, threads, integrator ("rk4" or "verlet"),
    clearance, ... (mus_drape_def)."""

    _kind = "drape"

    def __init__(self, cloth: Cloth, body: Body | None = None, **options: Any) -> None:
        if isinstance(options.get("integrator"), str):
            options["integrator"] = METHODS[options["integrator"]]
        definition = make_def(_abi.mus_drape_def, lib.mus_drape_def_init, options)
        context = cloth.context
        if body is not None and body.context is not context:
            raise ValueError("cloth and body are of two contexts")
        super().__init__(context, create(context, "drape", "mus_drape_create", context.handle, cloth.handle,
                                         body.handle if body is not None else None, ctypes.byref(definition)))

    def __len__(self) -> int:
        return self.get("node_count")

    def _told(self) -> str:
        return f"{len(self)} nodes, {self.time:.3g} s, state {self.state_hash}"

    # ---- run ----

    def place(self) -> None:
        """Put the nodes where the pattern's placement says, and open all seams."""
        self.do("place")

    def move_body(self, velocity: Numbers) -> None:
        """Let the body glide with a constant velocity (3) [m/s] in step(); zero stops it where it is."""
        self.do("move_body", (ctypes.c_double * 3)(*velocity))

    def pose_body(self, pose: Pose, duration: float = 0.0) -> None:
        """Let the body move to a pose (a Pose, or a mus_pose) in the next `duration` seconds of step()."""
        self.do("pose_body", ctypes.byref(getattr(pose, "struct", pose)), duration)

    def body_pose(self) -> Pose:
        """The Pose that the body stands in now."""
        pose = Pose()
        self.do("body_pose", ctypes.byref(pose.struct))
        return pose

    def add_plane(self, **options: Any) -> int:
        """One more plane (members of mus_plane: point, normal, velocity, spin, friction, reach); its number."""
        index = ctypes.c_int32()
        self.do("add_plane", ctypes.byref(make_def(_abi.mus_plane, lib.mus_plane_init, options)), ctypes.byref(index))
        return index.value

    def move_plane(self, index: int, velocity: Numbers, spin: float = 0.0) -> None:
        """Let a plane move with a velocity (3) [m/s] and a spin about its normal [rad/s] in step()."""
        self.do("move_plane", index, (ctypes.c_double * 3)(*velocity), spin)

    def sew(self, progress: Callable[[Progress], Any] | bool | None = None) -> None:
        """Pull all seams shut and weld them. progress(Progress) may return True to stop: MuslinError with the name
        MUS_ERR_STOPPED."""
        self._run("sew", progress)

    def settle(self, progress: Callable[[Progress], Any] | bool | None = None) -> None:
        """Let the cloth come to rest. progress as in sew()."""
        self._run("settle", progress)

    def _run(self, function: str, progress: Callable[[Progress], Any] | bool | None) -> None:
        raised = []
        try:
            self.do(function, progress_hook(progress, raised), None)
        except MuslinError:
            if not raised:
                raise
        if raised:
            raise raised[0]

    def step(self, steps: int, dt: float) -> None:
        """Advance by steps of dt [s] of the integrator: classical Runge-Kutta, or velocity Verlet."""
        self.do("step", steps, dt)

    def evaluate(self, times: int = 1) -> None:
        """Evaluate the forces `times` times and throw them away, for timing."""
        self.do("evaluate", times)

    @property
    def step_bound(self) -> float:
        """Largest stable step [s]."""
        return self.get("step_bound")

    def set_gravity(self, gravity: Numbers) -> None:
        """Change gravity (3) [m/s2] from now on."""
        self.do("set_gravity", (ctypes.c_double * 3)(*gravity))

    def estimate(self, frame: float) -> dict[str, Any]:
        """What step() will cost for a frame of `frame` seconds of cloth time, as a dict (mus_estimate)."""
        estimate = make_def(_abi.mus_estimate, lib.mus_estimate_init)
        self.do("estimate", frame, ctypes.byref(estimate))
        return read_struct(estimate)

    def set_state(self, positions: Numbers, velocities: Numbers | None = None) -> None:
        """Positions (n x 3) [m] and velocities (n x 3) [m/s]."""
        places, n = doubles(positions, 3)
        speeds, m = doubles(velocities, 3) if velocities is not None else (None, n)
        if n != len(self) or m != n:
            raise ValueError(f"the drape has {len(self)} nodes, not {n}")
        self.do("set_state", places, speeds)

    def warm(self, other: Drape) -> None:
        """Start where the cloth of another drape lies: a refit after a change of fabric, spacing, body or pattern."""
        self.do("warm", other.handle)

    def pin(self, node: int, fixed: bool = True) -> None:
        """Hold a node where it is, or let it go."""
        self.do("pin", node, 1 if fixed else 0)

    def tack(self, a: int, b: int, stiffness: float) -> int:
        """Draw two nodes together from now on by a spring of no length, of a stiffness [N/m]; its number."""
        index = ctypes.c_int32()
        self.do("tack", a, b, stiffness, ctypes.byref(index))
        return index.value

    def untack(self, index: int) -> None:
        """Take a tack out again."""
        self.do("untack", index)

    # ---- look ----

    @property
    def positions(self) -> Array:
        """(n x 3) [m], a view that follows the drape."""
        return view(self, self.get("positions"), len(self), 3)

    @property
    def velocities(self) -> Array:
        """(n x 3) [m/s], a view that follows the drape."""
        return view(self, self.get("velocities"), len(self), 3)

    @property
    def normals(self) -> Array:
        """Smooth unit normals (n x 3), made anew."""
        normals = (ctypes.c_double * (3 * len(self)))()
        self.do("normals", normals)
        return result(normals, 3)

    @property
    def forces(self) -> Array:
        """Force of springs, bending and gravity on each node (n x 3) [N], made anew."""
        forces = (ctypes.c_double * (3 * len(self)))()
        self.do("forces", forces)
        return result(forces, 3)

    def depth(self, points: Numbers) -> tuple[Array, Array]:
        """(depth (n) [m], positive inside; outward normals (n x 3)) of points (n x 3) in what the cloth meets."""
        places, n = doubles(points, 3)
        depth, normals = (ctypes.c_double * n)(), (ctypes.c_double * (3 * n))()
        self.do("depth", n, places, depth, normals)
        return result(depth), result(normals, 3)

    def gaps(self, cloth: Cloth) -> Array:
        """Gap of each seam pair [m]; `cloth` is the one that the drape was made of."""
        gaps = (ctypes.c_double * max(1, cloth.get("pair_count")))()
        self.do("gaps", gaps)
        return result(gaps)

    def crossings(self) -> int:
        """How many pairs of triangles of the cloth cross, exactly; 0 is a certificate."""
        count = ctypes.c_int64()
        self.do("crossings", 0, None, ctypes.byref(count))
        return count.value

    def untangle(self) -> None:
        """Draw cloth that crosses cloth apart; raises when some still does. Needs self_contact."""
        left = ctypes.c_int64()
        self.do("untangle", ctypes.byref(left))

    @property
    def time(self) -> float:
        """Cloth time since place [s]."""
        return self.get("time")

    @property
    def report(self) -> dict[str, Any]:
        """What the drape did and how it stands, as a dict (mus_drape_report)."""
        report = make_def(_abi.mus_drape_report, lib.mus_drape_report_init)
        self.do("report_get", ctypes.byref(report))
        return read_struct(report)

    def _reason(self, which: str) -> dict[str, Any]:
        reason = make_def(_abi.mus_reason, lib.mus_reason_init)
        self.do(which, ctypes.byref(reason))
        return read_reason(reason)

    @property
    def start(self) -> dict[str, Any]:
        """What is wrong with how the cloth lies before it is sewn, as reason; kind 0: nothing."""
        return self._reason("start")

    @property
    def reason(self) -> dict[str, Any]:
        """Why the last sew or settle ended as it did, as a dict (mus_reason); kind in words too, as name."""
        return self._reason("reason")

    @property
    def skipped(self) -> list[str]:
        """Names of what this scene did without."""
        return [name for name in self.get("skipped").split(",") if name]

    @property
    def state_hash(self) -> str:
        """Hash of the state, 16 hex digits: the same as in the command's report."""
        return f"{self.get('hash'):016x}"
