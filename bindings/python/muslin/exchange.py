"""exchange.py: triangle meshes to files and from them. Tapes and patterns have read and write of their own."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any
from . import _abi
from ._library import lib
from .arrays import doubles, integers
from .context import Context, create, make_def, taken_bytes, text

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ._types import MeshLists, Numbers, PathLike


class Mesh:
    """A mesh to write: positions (n x 3), triangles (m x 3), normals (n x 3), texcoords (n x 2), colour (RGBA)."""

    def __init__(self, name: str, positions: Numbers, triangles: Numbers, normals: Numbers | None = None,
                 texcoords: Numbers | None = None, colour: Sequence[float] | None = None,
                 two_sided: bool = False) -> None:
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

    def __repr__(self) -> str:
        return f"<Mesh: {self.struct.name.decode()!r}, {self.struct.vertex_count} vertices, " \
               f"{self.struct.triangle_count} triangles>"

    def to_trimesh(self) -> Any:
        """A trimesh.Trimesh of the mesh; needs trimesh."""
        import trimesh
        rows = [[data[i:i + 3] for i in range(0, len(data), 3)] for data in (self._positions, self._triangles)]
        return trimesh.Trimesh(*rows, process=False)

    @staticmethod
    def _rows(values: Numbers | None, width: int, n: int) -> Any:
        if values is None:
            return None
        data, rows = doubles(values, width)
        if rows != n:
            raise ValueError(f"{n} vertices, {rows} rows of {width}")
        return data


def _views(meshes: Sequence[Mesh]) -> Any:
    return (_abi.mus_mesh_view * len(meshes))(*[mesh.struct for mesh in meshes])


def _write(function: str, path: PathLike, meshes: Sequence[Mesh], context: Context | None) -> None:
    context = context or Context.of_thread()
    context.call(function, context.handle, text(path), len(meshes), _views(meshes))


def _bytes_of(function: str, meshes: Sequence[Mesh], context: Context | None) -> bytes:
    context = context or Context.of_thread()
    return taken_bytes(context, function, context.handle, len(meshes), _views(meshes))


def read_obj(path: PathLike, context: Context | None = None) -> MeshLists:
    """(vertices, triangles) of a Wavefront OBJ: lists of (x, y, z) and of indices from 0, as scan() takes them."""
    context = context or Context.of_thread()
    return _mesh_lists(context, create(context, "mesh", "mus_mesh_read_obj", context.handle, text(path)))


def parse_obj(data: str | bytes, name: str = "mesh.obj", context: Context | None = None) -> MeshLists:
    """read_obj() of the bytes of an OBJ; `name` stands for the path in messages."""
    context = context or Context.of_thread()
    data = text(data)
    return _mesh_lists(context, create(context, "mesh", "mus_mesh_read_obj_from", context.handle, data, len(data),
                                       text(name)))


def _mesh_lists(context: Context, handle: Any) -> MeshLists:
    try:
        x, triangle = lib.mus_mesh_vertices(handle), lib.mus_mesh_triangles(handle)
        vertices = [tuple(x[3 * i:3 * i + 3]) for i in range(lib.mus_mesh_vertex_count(handle))]
        return vertices, [tuple(triangle[3 * i:3 * i + 3]) for i in range(lib.mus_mesh_triangle_count(handle))]
    finally:
        with context.lock:
            lib.mus_mesh_destroy(handle)


def write_obj(path: PathLike, meshes: Sequence[Mesh], context: Context | None = None) -> None:
    """All meshes as one OBJ."""
    _write("mus_mesh_write_obj", path, meshes, context)


def obj_bytes(meshes: Sequence[Mesh], context: Context | None = None) -> bytes:
    """All meshes as the bytes of one OBJ."""
    return _bytes_of("mus_mesh_write_obj_bytes", meshes, context)


def glb_bytes(meshes: Sequence[Mesh], context: Context | None = None) -> bytes:
    """All meshes as the bytes of one binary glTF 2.0."""
    return _bytes_of("mus_mesh_write_glb_bytes", meshes, context)


def write_glb(path: PathLike, meshes: Sequence[Mesh], context: Context | None = None) -> None:
    """All meshes as one binary glTF 2.0."""
    _write("mus_mesh_write_glb", path, meshes, context)


def _motion(mesh: Mesh, keys: int, positions: Numbers | None, normals: Numbers | None) -> tuple[Any, Any]:
    """The struct of one mesh's motion, and the arrays that it borrows."""
    motion = make_def(_abi.mus_mesh_motion, lib.mus_mesh_motion_init, {})
    rows = keys * mesh.struct.vertex_count
    arrays = [None if values is None else doubles(values, 3) for values in (positions, normals)]
    for field, array in zip(("positions", "normals"), arrays):
        if array is None:
            continue
        if array[1] != rows:
            raise ValueError(f"{keys} keys of {mesh.struct.vertex_count} vertices, {array[1]} rows of 3")
        setattr(motion, field, array[0])
    return motion, arrays


def write_glb_motion(path: PathLike, meshes: Sequence[Mesh], times: Numbers,
                     motions: Sequence[tuple[Numbers | None, Numbers | None]], context: Context | None = None) -> None:
    """Meshes in motion as one binary glTF 2.0: times (keys) [s]; motions one (positions, normals) a mesh, each
    (keys * n x 3) or None."""
    context = context or Context.of_thread()
    when, keys = doubles(times, 1)
    motion = [_motion(mesh, keys, *moved) for mesh, moved in zip(meshes, motions, strict=True)]
    structs = (_abi.mus_mesh_motion * len(meshes))(*[struct for struct, _ in motion])
    context.call("mus_mesh_write_glb_motion", context.handle, text(path), len(meshes), _views(meshes), keys, when,
                 structs)
