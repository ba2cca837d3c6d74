"""What printed paper tells a sewer, read by pdftotext: lines of the legend, allowances by their edges, names of marks."""
import re
import shutil
import subprocess

import pytest

from places import BIN

MUSLIN = BIN / "muslin"


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    """The words of a print: told("coat", "M50", options) as one line."""
    folder, known = tmp_path_factory.mktemp("words"), {}

    def text(design, size, *options):
        if shutil.which("pdftotext") is None:
            pytest.skip("no pdftotext")
        if (design, size, options) not in known:
            pdf = folder / "paper.pdf"
            subprocess.run([MUSLIN, "print", "--design", design, "--size", size, "--pdf", pdf, "--language", "en", *options],
                           check=True, capture_output=True)
            raw = subprocess.run(["pdftotext", "-raw", pdf, "-"], check=True, capture_output=True).stdout.decode()
            known[design, size, options] = re.sub(r"\s+", " ", raw)
        return known[design, size, options]
    return text


def test_allowances_are_told_with_their_edges(told):
    """A front that buttons has four; a strip has one, without a word; legs of darts are not cut and not told."""
    shirt = told("shirt", "M50", "--paper", "roll")
    assert "Seam allowance included: centre 45 mm; hem 25 mm; neck 7 mm; other edges 10 mm" in shirt
    assert "Seam allowance included: 10 mm" in shirt
    assert "no allowance: inner" in told("coat", "M50", "--paper", "roll")
    skirt = told("skirt", "W40", "--paper", "roll")
    assert "no allowance" not in skirt and "hem 40 mm" in skirt


def test_edges_of_one_label_and_two_allowances_are_told_by_their_names(told):
    """The free edges of a collar's stand are all the neck of the garment; its ends lap."""
    assert re.search("end 24.5 mm; bottom, top 7 mm|bottom, top 7 mm; end 24.5 mm", told("shirt", "M50", "--paper", "roll"))


def test_the_legend_tells_the_lines_of_the_page(told):
    shirt, skirt = told("shirt", "M50"), told("skirt", "W40")
    for text in (shirt, skirt):
        assert "Solid line: cut. Short dashes: sew. Long dashes: fold or place" in text
        assert "three together: end of a zip or opening" in text
    assert "Cross in a line: buttonhole of the upper front and button of the under front" in shirt
    assert "Cross in a line" not in skirt
    sizes = told("skirt", "W40", "--sizes", "W36")
    assert "in the dashes of your size: cut." in sizes and "Solid line" not in sizes


def test_a_buttonhole_and_its_button_share_a_caption(told):
    shirt = told("shirt", "M50", "--paper", "roll")
    assert shirt.count("buttonhole, button") == 11  # nine of the front, both ends of the collar's stand
    assert shirt.count("interfacing") > 3 and " fold " in shirt
