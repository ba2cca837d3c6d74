"""Muslin > Draft a design: the pieces of a design as layers of the document, in its scale."""
import os
import sys

import inkex
from lxml import etree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import muslin  # noqa: E402

SVG = "{http://www.w3.org/2000/svg}"


def tape_of(options):
    """The tape of a file, or of a table size."""
    named = options.tape if options.tape and os.path.isfile(options.tape) else options.size
    return muslin.Tape.of(named)


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
        for group in drawn.findall(f"{SVG}g"):
            layer = inkex.Layer.new(group.get("id"))
            layer.transform = inkex.Transform(scale=millimetre)
            layer.append(etree.fromstring(etree.tostring(group), parser=inkex.elements._parser.SVG_PARSER))
            self.svg.add(layer)


if __name__ == "__main__":
    Draft().run()
