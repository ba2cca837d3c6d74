"""What printed paper tells a sewer, read by pdftotext: lines of the legend, allowances by their edges, names of marks."""
import json
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


def first_page(design, size, folder, *options):
    """The words of the first page, as one line, and the number of pages."""
    pdf = folder / "first.pdf"
    done = subprocess.run([MUSLIN, "print", "--design", design, "--size", size, "--pdf", pdf, "--language", "en",
                           "--json", *options], check=True, capture_output=True, text=True)
    raw = subprocess.run(["pdftotext", "-raw", "-l", "1", pdf, "-"], check=True, capture_output=True).stdout.decode()
    return re.sub(r"\s+", " ", raw), json.loads(done.stdout)


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="no pdftotext")
def test_the_first_page_tells_what_there_is(tmp_path):
    """Title, size, measures, cloth, notions, pieces with their numbers, and the names of all pages: on a cover, and in
    a set of fewer than ten pages on the page that the title stands on."""
    for design, size, cover, words in [
            ("shirt_mandarin_long", "M50", True,
             ["Collarless shirt with a stand, long sleeves For M50.", "bust: 100.0 cm; waist: 88.0 cm", "9 buttons",
              "1. front left: cut 2 mirrored", "6. button stand: cut 2 interfacing", "inner square: 100 mm"]),
            ("pencil_skirt_knee", "W40", False,
             ["Pencil skirt, to the knee For W40. 8 pages", "waist: 76.0 cm; hip: 100.0 cm", "a zip of 18.0 cm",
              "1. skirt front: cut 1 on fold", "5. band back right: cut 2 + 1 interfacing"])]:
        text, facts = first_page(design, size, tmp_path, "--fold")
        for word in [*words, "Drafted to these measures", "Cloth - main cloth, 0.90 m wide: ", "Notions - ", "Pieces 1. "]:
            assert word in text, (design, word)
        assert facts["pages"] == len(facts["tiles"]) + cover
        assert len(set(re.findall(r"\b[A-Z]\d\b", text))) == len(facts["tiles"])


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="no pdftotext")
def test_sizes_stand_on_the_first_page_without_the_cloth_of_one(tmp_path):
    text, _ = first_page("tshirt", "W40", tmp_path, "--fold", "--sizes", "W36")
    assert "Sizes W40, W36. " in text and "Drafted" not in text and "Pieces 1. front: cut 1 on fold" in text
