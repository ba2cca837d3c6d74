"""The paper itself: scale, lengths, bytes. A small C program prints the sample shirt; the command prints a T-shirt."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

import pytest

import measure_pdf

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
LIB = pathlib.Path(os.environ.get("MUSLIN_LIB", ROOT / "build/lib/libmuslin.so")).parent
BIN = pathlib.Path(os.environ.get("MUSLIN_BIN", ROOT / "build/bin"))
PAPERS = {"a4": 0, "letter": 1, "a3": 2, "a0": 3, "roll": 4}
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def sample(tmp_path_factory):
    """The program sample_print, built against the archives."""
    archives = [LIB / "libmuslin-print.a", LIB / "libmuslin.a"]
    missing = [str(a) for a in archives if not a.exists()]
    assert not missing, f"not built: {' '.join(missing)}"
    program = tmp_path_factory.mktemp("sample") / "sample_print"
    cairo = subprocess.run(["pkg-config", "--libs", "cairo", "pangocairo"], capture_output=True, text=True, check=True).stdout.split()
    flags = ["-fsanitize=address,undefined"] if "sanitize" in str(LIB) else ["--coverage"] if "coverage" in str(LIB) else []
    subprocess.run([*os.environ.get("CC", "cc").split(), "-std=c11", *flags, "-I", ROOT / "include", "-I", HERE,
                    HERE / "sample_print.c", *archives, *cairo, "-lm", "-pthread", "-o", program], check=True)
    return program


def draw(sample, folder, paper, *locale, **environment):
    pdf, svg = folder / f"{paper}.pdf", folder / f"{paper}.svg"
    done = subprocess.run([sample, str(PAPERS[paper]), pdf, svg, *locale], capture_output=True, text=True,
                          env={**os.environ, **environment})
    assert done.returncode == 0, done.stderr or f"exit {done.returncode}"
    return pdf, svg, json.loads(done.stdout)


def places(facts):
    keys = ("x_um", "y_um", "width_um", "height_um")
    return [(p["page"], *(p[k] / 1000.0 for k in keys)) for p in facts["pages"]]


@pytest.mark.parametrize("paper", PAPERS)
def test_squares_are_true_to_a_fifth_of_a_millimetre(sample, tmp_path, paper):
    pdf, _, _ = draw(sample, tmp_path, paper)
    for size, sides in measure_pdf.squares(pdf).items():
        for length in sides:
            assert abs(length - size) <= 0.2, f"{size} mm measures {length}"


@pytest.mark.parametrize("paper", PAPERS)
def test_edges_on_joined_tiles_are_as_long_as_the_patterns(sample, tmp_path, paper):
    pdf, _, facts = draw(sample, tmp_path, paper)
    assert measure_pdf.page_count(pdf) == len(facts["pages"]) + (1 if facts["tiled"] else 0)
    lengths = measure_pdf.seams(pdf, places(facts), facts["margin_um"] / 1000.0)
    worst = measure_pdf.compare(lengths, [e / 1000.0 for e in facts["edges_um"]])
    assert worst <= 0.05, f"an edge differs by {worst} mm"


def test_the_measure_sees_a_shrunk_page(sample, tmp_path):
    """The same measure must fail where the scale is wrong: places 0.1 % off tear the copies of an edge apart."""
    pdf, _, facts = draw(sample, tmp_path, "a4")
    wrong = [(p, 1.001 * x, 1.001 * y, w, h) for p, x, y, w, h in places(facts)]
    with pytest.raises(AssertionError):
        lengths = measure_pdf.seams(pdf, wrong, facts["margin_um"] / 1000.0)
        assert measure_pdf.compare(lengths, [e / 1000.0 for e in facts["edges_um"]]) <= 0.1


def test_bytes_do_not_depend_on_locale_clock_or_zone(sample, tmp_path):
    if shutil.which("localedef") is None:  # musl and bare images have none: the claim needs a comma locale
        pytest.skip("no localedef to make a locale with a decimal comma")
    made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", tmp_path / "de_DE.UTF-8"], capture_output=True)
    if not (tmp_path / "de_DE.UTF-8").exists():  # the sources of locales are a package of their own
        pytest.skip(f"localedef knows no de_DE: {made.stderr.decode(errors='replace').strip()[:200]}")
    (tmp_path / "plain").mkdir()
    (tmp_path / "comma").mkdir()
    plain = draw(sample, tmp_path / "plain", "a4")
    comma = draw(sample, tmp_path / "comma", "a4", "de_DE.UTF-8", LOCPATH=str(tmp_path), TZ="Asia/Tokyo")
    for one, other in zip(plain[:2], comma[:2]):
        assert one.read_bytes() == other.read_bytes()


def test_svg_is_true_scale_with_named_groups(sample, tmp_path):
    _, svg, facts = draw(sample, tmp_path, "a4")
    root = xml.etree.ElementTree.parse(svg).getroot()
    assert root.get("width").endswith("mm") and root.get("height").endswith("mm")
    assert root.get("viewBox") == f"0 0 {root.get('width')[:-2]} {root.get('height')[:-2]}"
    names = [g.get("id") for g in root.iter(SVG + "g")]
    assert len(names) == len(set(names))
    lengths = []
    for piece in ("front", "back", "sleeve_left", "neck_rib"):
        assert piece in names
        for group in root.iter(SVG + "g"):
            if group.get("id") == piece + ".seam":
                for path in group:
                    steps = measure_pdf.path_points(path.get("d").replace(",", " "))
                    points = [p for _, numbers in steps for p in zip(numbers[::2], numbers[1::2])]
                    line = measure_pdf.curve("".join(kind for kind, _ in steps), measure_pdf.numpy.array(points))
                    lengths.append(float(measure_pdf.numpy.hypot(*measure_pdf.numpy.diff(line, axis=0).T).sum()))
    assert measure_pdf.compare(lengths, [e / 1000.0 for e in facts["edges_um"]]) < 0.01


def test_the_command_prints_a_tshirt_true_to_scale(tmp_path):
    """From tape to paper: `muslin print` of the T-shirt on A4, every edge against the drafted pattern."""
    assert (BIN / "muslin").exists(), f"not built: {BIN / 'muslin'}"
    muslin = pytest.importorskip("muslin")
    tape, pdf, drafted = ROOT / "examples/tapes/w40.tape", tmp_path / "tshirt.pdf", tmp_path / "tshirt.json"
    subprocess.run([BIN / "muslin", "draft", "--design", "tshirt", "--tape", tape, "-o", drafted], check=True)
    out = subprocess.run([BIN / "muslin", "print", "--design", "tshirt", "--tape", tape, "--pdf", pdf, "--json"],
                         check=True, capture_output=True, text=True).stdout
    facts = json.loads(out)
    pages = [(t["page"], *(1000.0 * t[k] for k in ("x_m", "y_m", "width_m", "height_m"))) for t in facts["tiles"]]
    lengths = measure_pdf.seams(pdf, pages, 10.0)

    # the printed panels: those that are no mirror image of another
    mirrors = {panel["name"] for panel in json.loads(drafted.read_text())["panels"] if panel.get("mirror_of")}
    pattern = muslin.Pattern.read(drafted)
    pattern.join(pattern.cut_only(), 0)  # the neckband is cut and not draped
    expected = [1000.0 * pattern.edge_length(edge) for panel, name in enumerate(pattern.panels) if name not in mirrors
                for edge, _ in pattern.outline(panel)]
    assert measure_pdf.compare(lengths, expected) <= 0.1
    for size, sides in measure_pdf.squares(pdf).items():
        assert all(abs(length - size) <= 0.2 for length in sides)


def test_a_reader_finds_the_words_in_three_scripts(tmp_path):
    """Letters are strokes, and text besides: title, person, pieces and pages are found by pdftotext."""
    muslin = pytest.importorskip("muslin")
    title, person, pdf = "Skirt Größe 40", "Ольга 山田", tmp_path / "skirt.pdf"
    muslin.Sheet(muslin.draft("skirt", "W40"), title=title, person=person, fold=1).write_pdf(pdf)
    text = subprocess.run(["pdftotext", pdf, "-"], capture_output=True, text=True, check=True).stdout
    for words in (title, person, "skirt front", "Cut 1 on fold", "place on fold", "Piece 2 of", "100 mm", "A2"):
        assert words in text, words


def test_each_size_is_a_layer_that_is_on(tmp_path):
    """Three sizes in one file: three layers, all on, each with lines; a checker of PDF finds nothing wrong."""
    pdf = tmp_path / "nest.pdf"
    subprocess.run([BIN / "muslin", "print", "--design", "pencil_skirt_knee", "--sizes", "W36,W38,W40", "--paper", "a0",
                    "--pdf", pdf], check=True, capture_output=True)
    sys.path.insert(0, str(ROOT / "tests/study/paper"))
    import paper
    assert paper.layer_names(pdf) == ["W36", "W38", "W40"]
    tiles = [(page, 0.0, 0.0, 0.0) for page in range(len(paper.pdf_pages(pdf)))]
    cuts = [paper.layer_cuts(pdf, tiles, k) for k in range(3)]
    assert len({len(lines) for lines, _ in cuts}) == 1 and len(cuts[0][0]) >= 3
    assert len({tuple(dashes) for _, dashes in cuts}) == 3
    if shutil.which("qpdf"):
        done = subprocess.run(["qpdf", "--check", pdf], capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr
    assert subprocess.run(["pdfinfo", pdf], capture_output=True, text=True, check=True).stderr == ""


@pytest.mark.parametrize("design, most", [("tshirt", 12), ("pencil_skirt_knee", 8), ("full_skirt_midi", 23)])
def test_paper_of_halves_is_short_and_unfolds_to_the_pattern(tmp_path, design, most):
    """What `make dress` prints, read from the content stream by code of its own: pages, lines of pages, halves unfolded."""
    sys.path.insert(0, str(ROOT / "tests/study/paper"))
    import paper
    studies = (ROOT / "tests/study/studies.mk").read_text()
    assert re.search(r"RUN_dress = [^$]*(.*\\\n)*?.*--fold --pdf \$\(OUT\)/out/tshirt.pdf", studies)
    pdf = tmp_path / "halves.pdf"
    subprocess.run([BIN / "muslin", "print", "--design", design, "--tape", ROOT / "examples/tapes/w40.tape", "--fold",
                    "--pdf", pdf], check=True, capture_output=True)
    assert len(paper.pdf_pages(pdf)) <= most
    garment = "top" if design == "tshirt" else "skirt"
    _, _, worst, count = paper.check_design((str(BIN / "muslin"), design, garment, "W40"))
    assert worst["pages"][0] == 0.0 and count["halves"] >= 1, worst["pages"]
    # [mm] from the pattern's edges to the sew lines of whole pieces, and from whole pieces to unfolded halves
    assert worst["place"][0] + worst["unfold"][0] <= 0.1, worst
