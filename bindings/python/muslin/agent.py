"""agent.py: the package as tools of the Model Context Protocol, for programs that talk to a person and call tools.

    python -m muslin.agent FOLDER      speaks the protocol on standard input and output; needs pip install muslin[agent]

Tapes, patterns, pictures and pages are files of FOLDER, by plain names: nothing outside it is read or written, and a
link that leads out of it is refused. Answers are short; lists are cut to what was asked for, and pictures are images.
"""
from __future__ import annotations

import functools
import json
import pathlib
import sys
from typing import Any

import mcp.server.mcpserver as protocol
from mcp.server.mcpserver.exceptions import ToolError

from . import design, pattern, tape
from .body import Body
from .cloth import fabrics
from .context import Context
from .dress import Dressed, dress
from .errors import MuslinError
from .fit import Fit
from .print import Sheet
from .render import png_bytes, render

EDITS = ("add_dart", "add_facing", "fair_edge", "flare", "lay_pleats", "lengthen", "merge_darts", "merge_edges",
         "mirror_panel", "move_point", "notch_seam", "pleat", "remove_panel", "remove_seam", "rotate_dart",
         "set_allowance", "set_label", "shorten_dart", "split_edge", "spread", "true_seam")
INSTRUCTIONS = """Sewing patterns: tape -> draft (or a pattern file) -> edit -> dress (picture) -> fit -> print.
Lengths in edits are metres; measures of a tape are texts with a unit ("96 cm"). Files are names in one folder."""
BYTES_MOST = 4_000_000  # of a file that is read


class Folder:
    """The one folder whose files are read and written."""

    def __init__(self, root: str) -> None:
        self.root = pathlib.Path(root).resolve(strict=True)

    def path(self, name: str, *endings: str) -> pathlib.Path:
        """The path of a plain file name with one of the endings; ValueError for any other name."""
        if not name or name != pathlib.PurePath(name).name or name.startswith(".") or not name.isprintable() \
                or "\\" in name or not name.endswith(endings):
            raise ValueError(f"{name!r} is not a plain file name that ends in {' or '.join(endings)}")
        path = self.root / name
        if path.is_symlink() or path.resolve() != path or (path.exists() and not path.is_file()):
            raise ValueError(f"{name} is not a file of the folder")
        return path

    def read(self, name: str, *endings: str) -> bytes:
        path = self.path(name, *endings)
        if not path.exists():
            raise ValueError(f"there is no {name}; files: {', '.join(sorted(p.name for p in self.root.iterdir()))}")
        if path.stat().st_size > BYTES_MOST:
            raise ValueError(f"{name} has more than {BYTES_MOST} bytes")
        return path.read_bytes()


class Tools:
    """The tools; every public method is one."""

    def __init__(self, folder: str) -> None:
        self.folder, self.context = Folder(folder), Context()
        self.worn: dict[str, Dressed] = {}  # by the name of the pattern's file, the last few

    def _tape(self, name: str) -> tape.Tape:
        if name in tape.sizes():
            return tape.Tape.size(name, self.context)
        data = self.folder.read(name, ".tape", ".txt", ".yaml", ".yml", ".vit")
        return tape.Tape.parse(data, name, context=self.context)

    def _pattern(self, name: str) -> pattern.Pattern:
        return pattern.Pattern.parse(self.folder.read(name, ".json"), name, context=self.context)

    def sizes(self) -> dict[str, Any]:
        """Names of the table sizes, the measures that a tape can have, and the fabrics."""
        return {"sizes": tape.sizes(), "measures": tape.measures(), "fabrics": list(fabrics())}

    def make_tape(self, file: str, measures: dict[str, str], sex: str = "female", size: str = "") -> dict[str, Any]:
        """Write a tape file (name.tape) of measures as texts with a unit, {"bust": "96 cm", "stature": "170 cm"}, over
        those of a table size if one is named. Stature, bust, waist and hip are needed. Tells warnings."""
        path = self.folder.path(file, ".tape")
        made = tape.Tape.size(size, self.context) if size else tape.Tape(sex, context=self.context)
        for measure, value in measures.items():
            made[measure] = str(value)
        warnings = made.complete()
        made.write(path)
        given = [name for name, _ in made.items() if made.source(name) == "given"]
        return {"file": file, "given": given, "warnings": warnings}

    def body(self, wearer: str) -> list[Any]:
        """The body of a tape file or a table size: girths asked and made [cm], and its picture."""
        body = Body(self._tape(wearer))
        girths = {name: [round(100 * body.asked[name], 1), round(100 * body.made[name], 1)]
                  for name in ("bust", "waist", "hip", "thigh", "upper_arm") if name in body.made}
        skin = _mesh(body)
        return [json.dumps({"asked_and_made_cm": girths, "litres": round(1000 * body.volume, 1)}),
                _image(render([skin], 240, 480))]

    def designs(self, words: str = "", most: int = 20) -> dict[str, Any]:
        """Search the named designs by what a person calls them ("long sleeve tee", "skirt length=midi"), the best
        first; without words all of them."""
        found = design.designs(words.strip() or None)
        return {"count": len(found), "designs": [{"name": row["name"], "title": row["title"]}
                                                 for row in found[:max(0, min(most, 50))]]}

    def words(self) -> dict[str, list[str]]:
        """The words that a design can be spelled in instead of a name ("dress neck=v sleeve=puff"), by axis."""
        return design.axes()

    def draft(self, what: str, wearer: str, file: str) -> dict[str, Any]:
        """Draft a design (a name, or words) for a tape file or a table size, and write the pattern (name.json)."""
        path = self.folder.path(file, ".json")
        drafted = design.draft(what, self._tape(wearer))
        drafted.write(path)
        return {"file": file, **_summary(drafted)}

    def describe(self, file: str) -> dict[str, Any]:
        """Panels, edges with their numbers and lengths [cm], seams and faults of a pattern file."""
        read = self._pattern(file)
        panels = {name: [{"edge": edge, "name": read.edge_name(edge), "label": read.edge_label(edge),
                          "cm": round(100 * read.edge_length(edge), 1)} for edge, _ in read.outline(number)]
                  for number, name in enumerate(read.panels)}
        seams = [[read.seam(seam)["edge_a"], read.seam(seam)["edge_b"]] for seam in range(read.seam_count)]
        return {**_summary(read), "edges": panels, "seams": seams, "faults": [text for _, text in read.check()]}

    def edit(self, file: str, operation: str, arguments: dict[str, Any], save_as: str) -> dict[str, Any]:
        """Edit a pattern file and save it under a name. Operations, with arguments in metres and numbers of describe:
        add_dart(edge, s, width, point), add_facing(edge, width, name), fair_edge(edge, within), flare(hem, hinge, n,
        amount), lay_pleats(edge, places, depths), lengthen(panel, point, direction, amount), merge_darts(leg, into,
        keep), merge_edges(edge), mirror_panel(panel, name), move_point(point, x, y), notch_seam(edge, s),
        pleat(edge_a, s_a, edge_b, s_b, depth_a, depth_b), remove_panel(panel), remove_seam(seam), rotate_dart(leg,
        target, s, keep, fraction), set_allowance(edge, allowance), set_label(edge, label), shorten_dart(leg, back),
        split_edge(edge, s, name), spread(edge_a, s_a, edge_b, s_b, w_a, w_b), true_seam(seam, edge, at_end)."""
        path, read = self.folder.path(save_as, ".json"), self._pattern(file)
        if operation not in EDITS:
            raise ValueError(f"no operation {operation!r}: {', '.join(EDITS)}")
        made = getattr(read, operation)(**arguments)
        read.write(path)
        return {"file": save_as, "made": made, **_summary(read)}

    def dress(self, file: str, wearer: str, fabric: str = "", spacing_mm: float = 20.0, yaw: float = 25.0) -> list[Any]:
        """Sew a pattern file on the body of a tape file or a table size and let it come to rest: a report, a picture.
        yaw: degrees that the camera goes round; 180 shows the back."""
        read, body = self._pattern(file), Body(self._tape(wearer))
        worn = dress(read, body, fabric or None, strict=False, spacing=max(spacing_mm, 8.0) / 1000, nodes_most=60000)
        self.worn = {**dict(list(self.worn.items())[-3:]), file: worn}
        told = {"status": worn.status, "reason": worn.reason["text"], "seconds": round(sum(worn.seconds.values()), 2)}
        if worn.drape is None:
            return [json.dumps(told)]
        told.update(nodes=len(worn.drape), state_hash=worn.drape.state_hash)
        return [json.dumps(told), _image(worn.picture(320, 480, yaw=yaw))]

    def fit(self, file: str) -> dict[str, Any]:
        """Ease by level [cm], strain and pressure of a pattern file that was dressed before."""
        if file not in self.worn or self.worn[file].drape is None:
            raise ValueError(f"{file} was not dressed yet, or not cut; dressed: {', '.join(self.worn) or 'none'}")
        fit: Fit = self.worn[file].fit()
        levels = [{"level": level["level"], "side": level["side"], **{f"{name}_cm": round(100 * level[name], 1)
                   for name in ("body", "garment", "ease")}} for level in fit.levels]
        return {"levels": levels, "strain_p95": round(fit.spread("strain")["p95"], 4),
                "pressure_pa_p95": round(fit.spread("pressure")["p95"], 1)}

    def print_pattern(self, file: str, pdf: str, paper: str = "a4", title: str = "") -> dict[str, Any]:
        """Write the ready-to-cut paper of a pattern file as a PDF (name.pdf). paper: a4, letter, a3, a0, roll."""
        path = self.folder.path(pdf, ".pdf")
        sheet = Sheet(self._pattern(file), paper, **({"title": title} if title else {}))
        sheet.write_pdf(path)
        return {"file": pdf, "pages": sheet.page_count, "pieces": len(sheet.pieces), "bytes": path.stat().st_size}


def _summary(read: pattern.Pattern) -> dict[str, Any]:
    return {"name": read.name, "panels": read.panels, "edges": read.edge_count, "seams": read.seam_count}


def _mesh(body: Body) -> Any:
    from .dress import SKIN
    from .exchange import Mesh
    return Mesh("body", body.vertices, body.triangles, body.normals, colour=SKIN)


def _image(picture: Any) -> protocol.Image:
    return protocol.Image(data=png_bytes(picture), format="png")


def _told(method: Any) -> Any:
    """A tool whose failures reach the caller as sentences."""
    @functools.wraps(method)
    def tool(**arguments: Any) -> Any:
        try:
            return method(**arguments)
        except (MuslinError, ValueError, KeyError, TypeError, OSError) as error:
            raise ToolError(str(error)) from None
    return tool


def server(folder: str) -> protocol.MCPServer:
    """The server over one folder."""
    tools, made = Tools(folder), protocol.MCPServer("muslin", instructions=INSTRUCTIONS)
    for name in vars(Tools):
        if not name.startswith("_"):
            made.tool(structured_output=False)(_told(getattr(tools, name)))
    return made


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python -m muslin.agent FOLDER")
    server(sys.argv[1]).run()
