"""view.py: meshes in a notebook that the hand can turn: glTF in the web component model-viewer.

The component is loaded from VIEWER, an address that a notebook without the network can point at a copy of its own.
Until it is loaded, and where it cannot be, the picture of render() stands in its place.
"""
from __future__ import annotations

import base64
import html
from typing import TYPE_CHECKING

from .arrays import numpy
from .exchange import glb_bytes
from .render import png_bytes, render

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .exchange import Mesh

VIEWER = "https://cdn.jsdelivr.net/npm/@google/model-viewer@4.1.0/dist/model-viewer.min.js"
_PAGE = """<!DOCTYPE html><script type="module" src="{viewer}"></script><style>body{{margin:0}}img{{height:100vh}}
model-viewer{{width:100vw;height:100vh;background:#f7f7f5}}</style><model-viewer camera-controls
camera-orbit="25deg 82deg auto" alt="{title}" shadow-intensity="1" src="data:model/gltf-binary;base64,{glb}">
<img slot="poster" alt="{title}" src="data:image/png;base64,{png}"></model-viewer>"""


class View:
    """Meshes as a notebook shows them: View(meshes, title="T-shirt", height=540)."""

    def __init__(self, meshes: Sequence[Mesh], title: str = "garment", height: int = 540) -> None:
        self.meshes, self.title, self.height = list(meshes), title, height

    def page(self) -> str:
        """A page of HTML that shows the meshes."""
        png = png_bytes(render(self.meshes, 240, 360)) if numpy else b""
        return _PAGE.format(viewer=VIEWER, title=html.escape(self.title), png=base64.b64encode(png).decode(),
                            glb=base64.b64encode(glb_bytes(self.meshes)).decode())

    def _repr_html_(self) -> str:
        return f'<iframe sandbox="allow-scripts" style="width:100%;height:{self.height}px;border:0" srcdoc="{html.escape(self.page())}">' \
               "</iframe>"


__all__ = ["VIEWER", "View"]
