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
        assert "Solid line: cut. Short dashes: sew; at a hem: fold up. Long dashes: what their word says" in text
        assert "three together: end of a zip or opening, at the middle one." in text
    assert "Cross in a line: buttonhole of the upper front and button of the under front" in shirt
    assert "Cross in a line" not in skirt
    sizes = told("skirt", "W40", "--sizes", "W36")
    assert "in the dashes of your size: cut." in sizes and "Solid line" not in sizes


def test_a_buttonhole_and_its_button_share_a_caption(told):
    shirt = told("shirt", "M50", "--paper", "roll")
    assert shirt.count("buttonhole, button") == 11  # nine of the front, both ends of the collar's stand
    assert shirt.count("interfacing") > 3 and " fold " in shirt


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="no pdftotext")
def test_edges_have_the_words_of_the_instructions(tmp_path):
    """Of each seam that the instructions name by its edges both words stand on the paper."""
    pdf, steps = tmp_path / "paper.pdf", tmp_path / "steps.txt"
    for design, size in [("tshirt", "W40"), ("hoodie", "M50"), ("jeans", "W40")]:
        subprocess.run([MUSLIN, "print", "--design", design, "--size", size, "--fold", "--language", "en", "--pdf", pdf,
                        "--instructions", steps], check=True, capture_output=True)
        paper = subprocess.run(["pdftotext", "-raw", pdf, "-"], check=True, capture_output=True).stdout.decode()
        seams = [line.split(" cm")[0] for line in steps.read_text().splitlines() if line.startswith("   - ")]
        words = set(re.findall(r"(?<=\()[^)]*(?=\))|(?<= at the )[^,]*(?=,)", "\n".join(seams)))
        assert len(words) > 3
        for word in words:
            assert word in re.split("[\n\f]", paper), (design, word)


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="no pdftotext")
def test_slanting_words_are_found_in_every_script(tmp_path):
    """Readers take slanting text apart into letters: level text lies under it, also of words from right to left."""
    pdf = tmp_path / "paper.pdf"
    for language, words in [("de", "Schulternaht,Armkugel hinten,untere Ärmelnaht vorne"), ("th", "ไหล่,หัวแขนหลัง"),
                            ("ja", "肩線,後ろ袖山"), ("ar", "الكتف,رأس الكم الخلفي")]:
        subprocess.run([MUSLIN, "print", "--design", "tshirt", "--size", "W40", "--language", language, "--pdf", pdf],
                       check=True, capture_output=True)
        paper = subprocess.run(["pdftotext", pdf, "-"], check=True, capture_output=True).stdout.decode()
        lines = re.split("[\n\f]", re.sub("[\u202a-\u202e]", "", paper))
        for word in words.split(","):
            assert word in lines, (language, word)


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
             ["Pencil skirt, to the knee For W40. 8 pages", "waist: 76.0 cm; hip: 100.0 cm", "a zip for an opening of 18.0 cm",
              "1. skirt front: cut 1 on fold", "5. band back right: cut 2 + 1 interfacing"])]:
        text, facts = first_page(design, size, tmp_path, "--fold")
        for word in [*words, "Drafted to these measures", "Cloth - main cloth, 0.90 m wide: ", "Notions - ", "Pieces 1. "]:
            assert word in text, (design, word)
        assert facts["pages"] == len(facts["tiles"]) + cover
        shown = re.sub("Places without a line have no page: [^.]*", "", text)
        assert len(set(re.findall(r"\b[A-Z]\d\b", shown))) == len(facts["tiles"])


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="no pdftotext")
def test_the_first_page_tells_which_places_have_no_page(tmp_path):
    """Pages of the grid without a line are not printed: who counts the pages must know that none is lost."""
    text, facts = first_page("full_skirt_midi", "W40", tmp_path, "--fold")
    across = sorted({tile["x_m"] for tile in facts["tiles"]})
    down = sorted({tile["y_m"] for tile in facts["tiles"]}, reverse=True)
    tiles = {(down.index(tile["y_m"]), across.index(tile["x_m"])) for tile in facts["tiles"]}
    empty = [f"{chr(65 + row)}{column + 1}" for row in range(facts["rows"]) for column in range(facts["columns"])
             if (row, column) not in tiles]
    assert empty and f"Places without a line have no page: {', '.join(empty)}." in text
    text, facts = first_page("pencil_skirt_knee", "W40", tmp_path, "--fold")
    assert len(facts["tiles"]) == facts["rows"] * facts["columns"] and "have no page" not in text


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="no pdftotext")
def test_sizes_stand_on_the_first_page_without_the_cloth_of_one(tmp_path):
    text, _ = first_page("tshirt", "W40", tmp_path, "--fold", "--sizes", "W36")
    assert "Sizes W40, W36. " in text and "Drafted" not in text and "Pieces 1. front: cut 1 on fold" in text
