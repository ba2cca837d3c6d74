"""manifold.py: a body as one closed surface, for printing in 3D, Boolean operations and games."""
import ctypes

from . import _abi
from ._library import lib
from .arrays import view
from .context import Object, create, make_def


class Manifold(Object):
    """The union of a body's limbs where it stands: closed, without crossings, a sphere for each connected piece. Options
    are the fields of mus_manifold_def: spacing [m], threads."""

    _kind = "manifold"

    def __init__(self, body, **options):
        definition = make_def(_abi.mus_manifold_def, lib.mus_manifold_def_init, options)
        super().__init__(body.context, create(body.context, "manifold", "mus_manifold_create", body.handle,
                                              ctypes.byref(definition)))

    @property
    def vertices(self):
        """Vertices (n x 3) [m]: a view."""
        return view(self, self.get("vertices"), self.get("vertex_count"), 3)

    @property
    def normals(self):
        """Outward unit normals at the vertices (n x 3): a view."""
        return view(self, self.get("normals"), self.get("vertex_count"), 3)

    @property
    def triangles(self):
        """Triangles (m x 3) as vertex indices, winding outwards: a view."""
        return view(self, self.get("triangles"), self.get("triangle_count"), 3)

    @property
    def pieces(self):
        """Number of connected pieces."""
        return self.get("piece_count")

    @property
    def cuts(self):
        """Number of vertices on a cut, where a handle of the body was opened."""
        return self.get("cut_count")

    @property
    def volume(self):
        """Volume [m3]."""
        return self.get("volume")
