"""exchange.py: triangle meshes to files. Tapes and patterns have read and write of their own."""
from . import _abi
from ._library import lib
from .arrays import doubles, integers
from .context import Context, make_def, text


class Mesh:
    """A mesh to write: positions (n x 3), triangles (m x 3), normals (n x 3), texcoords (n x 2), colour (RGBA)."""

    def __init__(self, name, positions, triangles, normals=None, texcoords=None, colour=None, two_sided=False):
        self._positions, n = doubles(positions, 3)
        self._triangles, m = integers(triangles, 3)
        self._normals = self._rows(normals, 3, n)
        self._texcoords = self._rows(texcoords, 2, n)
        options = {"name": name, "vertex_count": n, "triangle_count": m, "two_sided": int(two_sided)}
        if colour is not None:
            options["colour"] = colour
        self.struct = make_def(_abi.mus_mesh_view, lib.mus_mesh_view_init, options)
        for field in ("positions", "triangles", "normals", "texcoords"):
            data = getattr(self, f"_{field}")
            if data is not None:
                setattr(self.struct, field, data)

    @staticmethod
    def _rows(values, width, n):
        if values is None:
            return None
        data, rows = doubles(values, width)
        if rows != n:
            raise ValueError(f"{n} vertices, {rows} rows of {width}")
        return data


def _write(function, path, meshes, context):
    context = context or Context.of_thread()
    views = (_abi.mus_mesh_view * len(meshes))(*[mesh.struct for mesh in meshes])
    context.call(function, context.handle, text(path), len(meshes), views)


def write_obj(path, meshes, context=None):
    """All meshes as one OBJ."""
    _write("mus_mesh_write_obj", path, meshes, context)


def write_glb(path, meshes, context=None):
    """All meshes as one binary glTF 2.0."""
    _write("mus_mesh_write_glb", path, meshes, context)
