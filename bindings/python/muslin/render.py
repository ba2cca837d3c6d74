"""render.py: a picture of meshes as an array, drawn by numpy on any machine: no window, no graphics driver.

Every triangle is cut into its pixels, the nearest pixel of each place is kept, and its colour is shaded by the
interpolated normal. A body and a garment take about a second at 360 x 540 pixels. For pictures with shadows and fit
maps there is `muslin dress --png`.
"""
from __future__ import annotations

import struct
import zlib
from math import cos, radians, sin
from typing import TYPE_CHECKING, Any

from .arrays import numpy

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ._types import Array
    from .exchange import Mesh

_LIGHT = (0.35, 0.55, 0.76)  # direction to the lamp as the camera sees it: right, up, near
_AMBIENT = 0.38  # share of the colour where no light of the lamp comes


def _arrays(mesh: Mesh) -> tuple[Any, Any, Any]:
    """Positions, triangles and unit normals of a mesh; normals are summed over triangles where the mesh has none."""
    places = numpy.frombuffer(mesh._positions).reshape(-1, 3)
    triangles = numpy.frombuffer(mesh._triangles, numpy.int32).reshape(-1, 3)
    if mesh._normals is not None:
        return places, triangles, numpy.frombuffer(mesh._normals).reshape(-1, 3)
    a, b, c = (places[triangles[:, i]] for i in range(3))
    normals, faces = numpy.zeros_like(places), numpy.cross(b - a, c - a)
    for i in range(3):
        numpy.add.at(normals, triangles[:, i], faces)
    return places, triangles, normals / numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-30)


def _fragments(corners: Any, width: int, height: int) -> tuple[Any, Any, Any]:
    """Pixels of triangles with corners (m x 3 x 2) [pixel]: triangle, pixel and barycentric weights (k x 3)."""
    low = numpy.maximum(numpy.ceil(corners.min(1) - 0.5), 0).astype(int)
    high = numpy.minimum(numpy.floor(corners.max(1) - 0.5), (width - 1, height - 1)).astype(int)
    sides = numpy.maximum(high - low + 1, 0)
    counts = sides.prod(1)
    triangle = numpy.repeat(numpy.arange(len(counts)), counts)
    nth = numpy.arange(len(triangle)) - numpy.repeat(numpy.cumsum(counts) - counts, counts)
    x = low[triangle, 0] + nth % sides[triangle, 0]
    y = low[triangle, 1] + nth // sides[triangle, 0]
    a, b, c = (corners[triangle, i] - numpy.stack((x + 0.5, y + 0.5), 1) for i in range(3))
    weights = numpy.stack([p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0] for p, q in ((b, c), (c, a), (a, b))], 1)
    area = weights.sum(1)
    kept = (weights * numpy.sign(area)[:, None] >= 0).all(1) & (area != 0)
    return triangle[kept], (y * width + x)[kept], weights[kept] / area[kept, None]


def render(meshes: Sequence[Mesh], width: int = 360, height: int = 540, yaw: float = 25.0, pitch: float = 8.0,
           zoom: float = 1.0, background: Sequence[float] = (0.97, 0.97, 0.96)) -> Array:
    """A picture (height x width x 3, uint8) of meshes, in parallel projection, that shows them whole at zoom 1.

    yaw: degrees that the camera goes round to the wearer's left; pitch: degrees that it looks down. Needs numpy.
    """
    if numpy is None:
        raise ImportError("pictures need numpy: pip install muslin[arrays]")
    yaw, pitch = radians(yaw), radians(pitch)
    camera = numpy.array([[cos(yaw), 0, -sin(yaw)], [-sin(pitch) * sin(yaw), cos(pitch), -sin(pitch) * cos(yaw)],
                          [cos(pitch) * sin(yaw), sin(pitch), cos(pitch) * cos(yaw)]])  # rows: right, up, near
    drawn = [(_arrays(mesh), numpy.array(mesh.struct.colour[:3])) for mesh in meshes]
    seen = numpy.concatenate([places @ camera.T for (places, _, _), _ in drawn])
    low, high = seen.min(0)[:2], seen.max(0)[:2]
    w, h = 2 * width, 2 * height  # each pixel is the mean of four
    scale = 0.94 * zoom * min(w / (high[0] - low[0]), h / (high[1] - low[1]))
    colours = numpy.tile(numpy.asarray(background, float), (w * h, 1))
    nearest = numpy.full(w * h, -numpy.inf)
    for (places, triangles, normals), colour in drawn:
        view = places @ camera.T
        flat = (view[:, :2] - (low + high) / 2) * (scale, -scale) + (w / 2, h / 2)
        triangle, pixel, weight = _fragments(flat[triangles], w, h)
        corners = triangles[triangle]
        depth = (view[corners, 2] * weight).sum(1)
        numpy.maximum.at(nearest, pixel, depth)
        front = nearest[pixel] == depth
        normal = numpy.einsum("ki,kij->kj", weight[front], (normals @ camera.T)[corners[front]])
        normal *= numpy.where(normal[:, 2:] < 0, -1, 1) / numpy.maximum(
            numpy.linalg.norm(normal, axis=1, keepdims=True), 1e-30)  # cloth is seen from both sides
        light = _AMBIENT + (1 - _AMBIENT) * numpy.maximum(normal @ numpy.array(_LIGHT), 0)
        colours[pixel[front]] = colour * light[:, None]
    picture = colours.reshape(height, 2, width, 2, 3).mean((1, 3))
    return (255 * picture.clip(0, 1) + 0.5).astype(numpy.uint8)


def png_bytes(picture: Array) -> bytes:
    """A picture (height x width x 3, uint8) as the bytes of a PNG file."""
    height, width, _ = picture.shape
    rows = b"".join(b"\0" + row.tobytes() for row in picture)

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


__all__ = ["png_bytes", "render"]
