"""muslin: from the tape measure to the sewn and draped garment, and to ready-to-cut paper.

    import muslin
    tape = muslin.Tape.size("W40")
    tape["bust"] = "96 cm"
    tshirt = muslin.dress("tshirt", tape)   # a notebook shows its picture; tshirt.view() can be turned
    tshirt.drape.positions              # (nodes x 3), a view, no copy
    muslin.Sheet(tshirt.pattern).write_pdf("tshirt.pdf")

The same step by step: Body(tape), draft("tshirt", tape), Cloth(pattern), Drape(cloth, body), and the drape's place(),
sew() and settle().

Units are SI: metre, kilogram, second, radian. X to the wearer's left, Y up, Z forward, floor at Y = 0. A status that is
not MUS_OK becomes a MuslinError with the library's own sentence. Nothing is computed in Python. Arrays are numpy's when
it is installed, memoryviews when it is not.
"""
from ._abi import VERSION as __version__
from ._library import version
from .arrange import arrange, pattern_reason
from .body import Body
from .catalogue import Catalogue
from .cloth import Cloth, Fabric, fabrics
from .context import Context
from .design import axes, designs, draft, ease, grade, spell
from .drape import Drape
from .dress import Dressed, dress
from .errors import MuslinError
from .exchange import Mesh, read_obj, write_glb, write_glb_motion, write_mesh, write_obj
from .fit import Fit
from .integrate import integrate
from .language import languages, translate, words
from .layout import Layout
from .manifold import Manifold
from .pattern import Pattern
from .pose import FOOT_LEFT, FOOT_RIGHT, Move, Pose, joint_limits, moves, poses
from .print import Sheet
from .render import png_bytes, render
from .scan import scan
from .tape import Tape, measures, sizes
from .view import View

__all__ = ["Body", "Catalogue", "Cloth", "Context", "Drape", "Dressed", "FOOT_LEFT", "FOOT_RIGHT", "Fabric", "Fit",
           "Layout", "Manifold", "Mesh", "Move", "MuslinError", "Pattern", "Pose", "Sheet", "Tape", "View", "arrange", "axes",
           "designs", "draft", "dress", "ease", "fabrics", "grade", "integrate", "joint_limits", "languages", "measures",
           "moves", "pattern_reason", "png_bytes", "poses", "read_obj", "render", "scan", "sizes", "spell", "translate",
           "version", "words", "write_glb", "write_glb_motion", "write_mesh", "write_obj", "__version__"]
