"""exchange.py: triangle meshes to files and from them. Tapes and patterns have read and write of their own."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import _abi
from ._library import lib
from .arrays import doubles, integers
from .context import Context, create, make_def, taken_bytes, text

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ._types import MeshLists, Numbers, PathLike
    from .cloth import Cloth


class Mesh:
    """A mesh to write: positions (n x 3), triangles (m x 3), normals (n x 3), texcoords (n x 2), colour (RGBA).

    With the `cloth` whose nodes and triangles it has, write_mesh() divides it into panels; `material` names the fabric.
    """

    def __init__(self, name: str, positions: Numbers, triangles: Numbers, normals: Numbers | None = None,
                 texcoords: Numbers | None = None, colour: Sequence[float] | None = None,
                 two_sided: bool = False, cloth: Cloth | None = None, material: str | None = None) -> None:
        self._cloth, self._material = cloth, text(material) if material is not None else None
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


_FORMS = {"obj": _abi.MUS_MESH_OBJ, "glb": _abi.MUS_MESH_GLB, "usda": _abi.MUS_MESH_USDA, "ply": _abi.MUS_MESH_PLY,
          "pc2": _abi.MUS_MESH_PC2}


def _mesh_file(meshes: Sequence[Mesh], form: str, times: Numbers | None,
               motions: Sequence[tuple[Numbers | None, Numbers | None]] | None) -> tuple[Any, Any]:
    """The struct of a mesh file, and what it borrows."""
    if form not in _FORMS:
        raise ValueError(f"{form!r} is no form of a mesh file: {', '.join(_FORMS)}")
    cloths = (ctypes.POINTER(_abi.mus_cloth) * len(meshes))()
    for i, mesh in enumerate(meshes):
        if mesh._cloth is not None:
            cloths[i] = mesh._cloth.handle
    materials = (ctypes.c_char_p * len(meshes))(*[mesh._material for mesh in meshes])
    views = _views(meshes)
    options = {"form": _FORMS[form], "count": len(meshes)}
    held: list[Any] = [cloths, materials, views]
    file = make_def(_abi.mus_mesh_file, lib.mus_mesh_file_init, options)
    file.meshes, file.materials, file.cloths = views, materials, cloths
    if times is not None and motions is not None:
        when, keys = doubles(times, 1)
        motion = [_motion(mesh, keys, *moved) for mesh, moved in zip(meshes, motions, strict=True)]
        structs = (_abi.mus_mesh_motion * len(meshes))(*[struct for struct, _ in motion])
        file.keys, file.times, file.motion = keys, when, structs
        held += [when, motion, structs]
    return file, held


def write_mesh(path: PathLike, meshes: Sequence[Mesh], form: str | None = None, times: Numbers | None = None,
               motions: Sequence[tuple[Numbers | None, Numbers | None]] | None = None,
               context: Context | None = None) -> None:
    """Meshes as "obj", "glb", "usda", "ply" or "pc2" (the ending of the path): a mesh of a cloth panel by panel, with
    packed texture coordinates and its seams as lines. times and motions: as write_glb_motion() has them."""
    context = context or Context.of_thread()
    file, _ = _mesh_file(meshes, form or str(path).rpartition(".")[2], times, motions)
    context.call("mus_mesh_write", context.handle, text(path), ctypes.byref(file))


def mesh_bytes(meshes: Sequence[Mesh], form: str, times: Numbers | None = None,
               motions: Sequence[tuple[Numbers | None, Numbers | None]] | None = None,
               context: Context | None = None) -> bytes:
    """What write_mesh() writes, as bytes."""
    context = context or Context.of_thread()
    file, _ = _mesh_file(meshes, form, times, motions)
    return taken_bytes(context, "mus_mesh_write_bytes", context.handle, ctypes.byref(file))


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
