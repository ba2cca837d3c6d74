"""Muslin > Draft a design: the pieces of a design as layers of the document, in its scale.

They lie right of what is drawn already; a document in which nothing is drawn gets a page of their size."""
import os
import sys

import inkex
from lxml import etree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import muslin  # noqa: E402

SVG = "{http://www.w3.org/2000/svg}"
APART = 10  # mm from what is drawn to the pieces; chosen: more than a seam allowance is wide


def tape_of(options):
    """The tape of a file, or of a table size."""
    named = options.tape if options.tape and os.path.isfile(options.tape) else options.size
    return muslin.Tape.of(named)


def box_of(svg):
    """The box of all that is drawn, None when nothing is."""
    box = None
    for child in svg:
        if isinstance(child, inkex.ShapeElement):
            own = child.bounding_box()
            box = box + own if box is not None and own is not None else own if box is None else box
    return box


class Draft(inkex.EffectExtension):
    def add_arguments(self, pars):
        pars.add_argument("--design", default="tshirt")
        pars.add_argument("--size", default="W40")
        pars.add_argument("--tape", default="")
        pars.add_argument("--allowance", type=float, default=10.0)

    def effect(self):
        try:
            pattern = muslin.draft(self.options.design, tape_of(self.options))
            sheet = muslin.Sheet(pattern, paper="roll", allowance=self.options.allowance / 1000)
        except (muslin.MuslinError, KeyError) as error:
            raise inkex.AbortExtension(str(getattr(error, "text", error)))
        drawn = etree.fromstring(sheet.svg_bytes())
        millimetre = self.svg.unittouu("1mm")
        left, top, width, height = (float(number) * millimetre for number in drawn.get("viewBox").split())
        box = box_of(self.svg)
        if box is None:
            self.svg.set("width", drawn.get("width"))
            self.svg.set("height", drawn.get("height"))
            self.svg.set("viewBox", f"0 0 {width} {height}")
            place = inkex.Transform(translate=(-left, -top), scale=millimetre)
        else:
            place = inkex.Transform(translate=(box.right + APART * millimetre - left, box.top - top), scale=millimetre)
        for group in drawn.findall(f"{SVG}g"):
            layer = inkex.Layer.new(group.get("id"))
            layer.transform = place
            layer.append(etree.fromstring(etree.tostring(group), parser=inkex.elements._parser.SVG_PARSER))
            self.svg.add(layer)


if __name__ == "__main__":
    Draft().run()
