"""Paper and instructions in eight languages, read by programs of others: pdftotext, pdffonts, an XML parser."""
import json
import os
import shutil
import subprocess
import unicodedata
import xml.etree.ElementTree

import pytest

from places import BIN, ROOT

MUSLIN = BIN / "muslin"
DESIGN = ("--design", "shirt_straight_long", "--size", "W40")
# words that stand on its paper, free of the ligature of lam and alef, whose two letters pdftotext turns round
WORDS = {"de": ["Rückenteil", "Ärmel", "Nahtzugabe enthalten", "gegengleich zuschneiden", "Fadenlauf"],
         "fr": ["manche", "Marges de couture comprises", "droit fil"],
         "es": ["espalda", "Margen de costura incluido", "hilo de la tela"],
         "pt": ["costas", "Margem de costura incluída", "fio do tecido"],
         "ja": ["前身頃", "後ろ身頃", "縫い代込み", "地の目", "ストレートシャツ"],
         "ar": ["الخلف", "الكم", "قميص مستقيم", "الياقة"],
         "th": ["ตัวหน้า", "ตัวหลัง", "แขนเสื้อ", "ปกเสื้อ", "แนวเกรน", "รวมค่าเย็บแล้ว", "เสื้อเชิ้ตทรงตรง"]}
ENGLISH = {"front", "back", "sleeve", "collar", "cut", "seam", "allowance", "piece", "scale", "mirrored", "print"}


def run(*arguments, code=0, **environment):
    done = subprocess.run([MUSLIN, *map(str, arguments)], capture_output=True, text=True,
                          env={**os.environ, "LC_ALL": "C", **environment})
    assert done.returncode == code, done.stderr
    return done.stderr if code else done.stdout


def needs(program):
    if shutil.which(program) is None:
        pytest.skip(f"no {program}")


def needs_font(language):
    needs("fc-list")
    if not subprocess.run(["fc-list", f":lang={language}"], capture_output=True, text=True).stdout.strip():
        pytest.skip(f"no font for {language}: tests/guard/packages.sh test installs one")


@pytest.fixture(scope="module", params=sorted(WORDS))
def paper(request, tmp_path_factory):
    """(language, path of the PDF)"""
    needs_font(request.param)
    pdf = tmp_path_factory.mktemp(request.param) / "paper.pdf"
    run("print", *DESIGN, "--language", request.param, "--pdf", pdf)
    return request.param, pdf


def text_of(pdf):
    needs("pdftotext")
    text = subprocess.run(["pdftotext", pdf, "-"], capture_output=True, check=True).stdout.decode()
    # marks of direction are not letters
    return "".join(letter for letter in text if unicodedata.category(letter) != "Cf").replace("\n", " ")


def test_words_of_the_paper_are_found_in_it(paper):
    language, pdf = paper
    text = text_of(pdf)
    for word in WORDS[language]:
        # a word may end a line between two of its letters, as Japanese and Thai do
        assert word.replace(" ", "") in text.replace(" ", ""), f"{language}: {word}"
    assert not ENGLISH & set(text.lower().split()), language


def test_every_font_is_in_the_file(paper):
    _, pdf = paper
    needs("pdffonts")
    rows = subprocess.run(["pdffonts", pdf], capture_output=True, text=True, check=True).stdout.splitlines()
    head, fonts = rows[0], rows[2:]
    assert fonts
    for font in fonts:
        # embedded, a part, with its letters; that of the invisible text under slanting words is whole
        part = "no" if "Type 3" in font else "yes"
        assert font[head.index("emb"):].split()[:3] == ["yes", part, "yes"], font


def test_the_same_sheet_gives_the_same_bytes(paper, tmp_path):
    language, pdf = paper
    run("print", *DESIGN, "--language", language, "--pdf", tmp_path / "again.pdf", LC_ALL="C.UTF-8", TZ="Asia/Tokyo")
    assert (tmp_path / "again.pdf").read_bytes() == pdf.read_bytes()


def test_lines_of_pieces_do_not_depend_on_the_language(paper, tmp_path):
    """The cut and sew lines of each piece in the SVG, whose identifiers stay English."""
    language, _ = paper
    lines = []
    for tag in ("en", language):
        run("print", *DESIGN, "--language", tag, "--paper", "roll", "--svg", tmp_path / f"{tag}.svg")
        groups = {group.get("id"): [path.get("d") for path in group]
                  for group in xml.etree.ElementTree.parse(tmp_path / f"{tag}.svg").iter("{http://www.w3.org/2000/svg}g")}
        lines.append({name: paths for name, paths in groups.items() if name.endswith((".cut", ".seam", ".notches"))})
    assert len(lines[0]) == 3 * sum(name.endswith(".cut") for name in lines[0]) >= 18 and lines[0] == lines[1]


HEADS = {"de": ["Gezeichnet nach diesen Maßen", "Stoff", "Kurzwaren", "Schnittteile"],
         "fr": ["Tracé d’après ces mesures", "Tissu", "Mercerie", "Pièces du patron"],
         "es": ["Trazado según estas medidas", "Tela", "Mercería", "Piezas del patrón"],
         "pt": ["Traçado segundo estas medidas", "Tecido", "Aviamentos", "Partes do molde"],
         "ja": ["製図に使った寸法", "布", "付属品", "パーツ"], "ar": ["وفق هذه القياسات", "لوازم الخياطة", "قطع الباترون"],
         "th": ["ร่างแบบตามขนาดเหล่านี้", "อุปกรณ์เย็บ"]}


def test_the_first_page_is_a_cover_in_every_language(paper):
    language, pdf = paper
    needs("pdftotext")
    text = subprocess.run(["pdftotext", "-l", "1", pdf, "-"], capture_output=True, check=True).stdout.decode()
    text = "".join(letter for letter in text if unicodedata.category(letter) != "Cf")
    for head in HEADS[language]:
        # pdftotext tells gaps of short Arabic lines from their letters by a guess
        assert "".join(head.split()) in "".join(text.split()), (language, head)


@pytest.mark.parametrize("language", sorted(WORDS))
def test_layers_of_sizes_and_halves_are_written_in_every_language(language, tmp_path):
    needs_font(language)
    run("print", "--design", "skirt", "--sizes", "W36,W40", "--fold", "--language", language, "--pdf", tmp_path / "n.pdf",
        "--plt", tmp_path / "n.plt")
    needs("pdftotext")
    assert b"/OCGs" in (tmp_path / "n.pdf").read_bytes()
    assert len(text_of(tmp_path / "n.pdf")) > 200


def test_the_environment_decides_and_the_option_before_it():
    told = {tag: run("print", *DESIGN, "--instructions", "-", "--language", tag) for tag in ["en", *WORDS]}
    assert len(set(told.values())) == 8
    for variables, tag in [({"LC_ALL": "", "LANG": "de_DE.UTF-8"}, "de"),
                           ({"LC_ALL": "", "LC_MESSAGES": "fr_FR", "LANG": "de_DE.UTF-8"}, "fr"),
                           ({"LC_ALL": "ja_JP.UTF-8", "LC_MESSAGES": "fr_FR"}, "ja"),
                           ({"LC_ALL": "", "LANG": "it_IT.UTF-8"}, "en"), ({"LC_ALL": "", "LANG": ""}, "en")]:
        assert run("print", *DESIGN, "--instructions", "-", **{"LC_MESSAGES": "", **variables}) == told[tag]
    assert run("print", *DESIGN, "--instructions", "-", "--language", "pt_BR", LC_ALL="de_DE") == told["pt"]


def test_json_and_files_do_not_change_with_the_language(tmp_path):
    for arguments in (["designs", "--json"], ["designs", "--show", "jeans", "--json"]):
        assert json.loads(run(*arguments, LC_ALL="th_TH")) == json.loads(run(*arguments))
    files = []
    for tag in ("en", "ja"):
        run("draft", *DESIGN, "-o", tmp_path / "p.json", LC_ALL=tag)
        run("print", *DESIGN, "--language", tag, "--dxf", tmp_path / "p.dxf")
        files.append([(tmp_path / name).read_bytes() for name in ("p.json", "p.dxf")])
    assert files[0] == files[1]
    body = json.loads(run("body", "--size", "W40", "--json", LC_ALL="ar_EG"))
    assert "waist" in [measure["name"] for measure in body["measures"]]


@pytest.mark.parametrize("command", [["print", *DESIGN, "--instructions", "-"], ["designs"], ["body", "--size", "W40"]])
def test_an_unknown_language_is_refused_with_the_list(command):
    line = run(*command, "--language", "tlh", code=2)
    assert line == f"muslin {command[0]}: --language tlh: expected one of en de fr es pt ja ar th\n"


def test_titles_and_measures_are_listed_in_the_language():
    assert "Bleistiftrock, Midilänge" in run("designs", "pencil", "--language", "de")
    assert "ペンシルスカート、ミディ丈" in run("designs", "pencil", "--language", "ja")
    table = run("body", "--size", "W40", "--language", "es")
    assert "contorno de cintura" in table and "waist" not in table and "76.00 cm" in table
    english = run("body", "--size", "W40").splitlines()
    assert english[0] == "measure              asked        made       error"
    assert english[3].split() == ["waist", "76.00", "cm", "76.00", "cm", "0.00", "mm"]


def test_names_beyond_latin_are_text_on_english_paper(tmp_path):
    needs_font("ja")
    tape = tmp_path / "hanako.tape"
    tape.write_text((ROOT / "examples/tapes/w40.tape").read_text().replace("name W40", "name 花子"))
    run("print", "--design", "skirt", "--tape", tape, "--pdf", tmp_path / "p.pdf")
    text = text_of(tmp_path / "p.pdf")
    assert "For 花子" in text and "Seam allowance included" in text
