"""body.py: a body made of stacks of closed contours that fit the tape."""
import ctypes
import math

from . import _abi
from ._library import lib
from .arrays import doubles, result, view
from .context import Context, Object, create, fill, make_def
from .pose import Move, Pose
from .tape import measures

_LANDMARKS = {name[len("MUS_LANDMARK_"):].lower(): value for name, value in vars(_abi).items()
              if name.startswith("MUS_LANDMARK_") and name != "MUS_LANDMARK_COUNT"}


class Body(Object):
    """A body made from a tape. Options are the fields of mus_body_def: samples, ring_spacing, ellipse, plain, without,
    and the posture stoop, head_forward, sway [m]."""

    _kind = "body"

    def __init__(self, tape, _handle=None, **options):
        context = tape if _handle is not None else tape.context
        if _handle is None:
            definition = make_def(_abi.mus_body_def, lib.mus_body_def_init, options)
            _handle = create(context, "body", "mus_body_create", context.handle, tape.handle, ctypes.byref(definition))
        super().__init__(context, _handle)

    @classmethod
    def of_limbs(cls, limbs, context=None, **options):
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
        return cls(context, _handle=handle)

    def posed(self, pose):
        """A copy of the body in a Pose (or a mus_pose); measures and volume are those of the rest pose."""
        return Body(self.context, _handle=create(self.context, "body", "mus_body_pose", self.handle,
                                                 ctypes.byref(getattr(pose, "struct", pose))))

    @property
    def rest_pose(self):
        """The Pose that the body was made in."""
        return self._pose("rest_pose")

    @property
    def stance(self):
        """The Pose that the body stands in."""
        return self._pose("stance")

    def _pose(self, function):
        pose = Pose()
        self.do(function, ctypes.byref(pose.struct))
        return pose

    def fit(self, pose, gap=0.012):
        """Fit a Pose to the body: arms `gap` [m] off its sides, its feet (pose.feet) on the floor. Returns the pose."""
        self.do("clear_arms", ctypes.byref(pose.struct), gap)
        self.do("stand", pose.feet, ctypes.byref(pose.struct))
        return pose

    def move(self, name, gap=0.012):
        """A named Move fitted to the body: feet on the floor, arms `gap` [m] off its sides."""
        return Move(name, _handle=create(self.context, "move", "mus_body_move", self.handle, name.encode(), gap),
                    context=self.context)

    @property
    def vertices(self):
        """Vertices of the skin (n x 3) [m], a view."""
        return view(self, self.get("vertices"), self.get("vertex_count"), 3)

    @property
    def normals(self):
        """Outward unit normals of the vertices (n x 3), a view."""
        return view(self, self.get("normals"), self.get("vertex_count"), 3)

    @property
    def triangles(self):
        """Triangles of the skin (m x 3), winding outwards, a view."""
        return view(self, self.get("triangles"), self.get("triangle_count"), 3)

    @property
    def limbs(self):
        """Names of the limbs."""
        return [self.get("limb_name", i) for i in range(self.get("limb_count"))]

    def limb_range(self, limb):
        """(first vertex, vertex count, first triangle, triangle count) of a limb by name."""
        numbers = (ctypes.c_int32 * 4)()
        self.do("limb_range", self.limbs.index(limb), numbers)
        return tuple(numbers)

    def contour(self, limb, contour, n=96):
        """`n` points (n x 3) round a contour of a limb, both by name."""
        limb = self.limbs.index(limb)
        names = [self.get("contour_name", limb, i) for i in range(self.get("contour_count", limb))]
        points = (ctypes.c_double * (3 * n))()
        self.do("contour_points", limb, names.index(contour), n, points)
        return result(points, 3)

    def contours(self, limb):
        """Names of the contours of a limb, in the order of its axis."""
        limb = self.limbs.index(limb)
        return [self.get("contour_name", limb, i) for i in range(self.get("contour_count", limb))]

    @property
    def asked(self):
        """{measure: value of the completed tape} [m] or [rad]."""
        return self._measures("asked")

    @property
    def made(self):
        """{measure: value on the finished surface} [m] or [rad], without those that are not measured there."""
        return self._measures("made")

    def _measures(self, function):
        values = {name: self.get(function, i) for i, name in enumerate(measures())}
        return {name: value for name, value in values.items() if not math.isnan(value)}

    @property
    def volume(self):
        """Volume of the union of the limbs [m3]."""
        return self.get("volume")

    def landmark(self, name):
        """Position (3) of a landmark [m]: crown, nape, bust, waist, hip, crotch, shoulder_left, ..."""
        place = (ctypes.c_double * 3)()
        self.do("landmark", _LANDMARKS[name], place)
        return result(place)

    def depth(self, points):
        """Depths of points (n x 3) [m], positive inside; -1e30 for a point more than 5 cm outside."""
        places, n = doubles(points, 3)
        depth = (ctypes.c_double * n)()
        self.do("depth", n, places, depth, None)
        return result(depth)
