"""What the command prints for programs: bodies against their tapes, designs, drafts, paper, all as JSON."""
import json
import math
import xml.etree.ElementTree

import pytest

GIRTHS = ["bust", "waist", "hip", "underbust", "high_bust", "high_hip", "neck", "upper_arm", "wrist", "thigh", "knee",
          "calf", "ankle", "head"]
SIZES = ["W34", "W40", "W52", "M46", "M50", "M60", "C56", "C116", "C164"]
BODIES = ["mean_all", "mean_female", "m_smpl_average_A40"]
SVG = "{http://www.w3.org/2000/svg}"


def finite(value):
    """No NaN or infinity anywhere, and no text that stands for one."""
    if isinstance(value, dict):
        return all(map(finite, value.values()))
    if isinstance(value, list):
        return all(map(finite, value))
    return not isinstance(value, float) or math.isfinite(value)


def read(done):
    """JSON that is nothing but JSON: strict, so NaN is refused."""
    def refuse(word):
        raise AssertionError(f"{word} is no JSON")
    assert done.stderr == b"" or b"warning" in done.stderr
    return json.loads(done.stdout, parse_constant=refuse)


def check_body(report):
    assert set(report) >= {"measures", "volume_m3", "seconds"}
    rows = {row["name"]: row for row in report["measures"]}
    assert len(rows) == len(report["measures"]) == 36
    assert all(set(row) >= {"name", "asked_m", "made_m", "derived"} for row in report["measures"])
    for name in GIRTHS:
        row = rows[name]
        assert row["made_m"] is not None or row["derived"], row
        assert row["made_m"] is None or abs(row["made_m"] - row["asked_m"]) <= 0.001, row
    assert sum(rows[name]["made_m"] is not None for name in GIRTHS) >= len(GIRTHS) - 1
    for row in report["measures"]:
        if row["asked_m"] is None:
            assert row["derived"] is False and row["name"] == "front_waist"
    assert 0.002 < report["volume_m3"] < 0.25 and report["seconds"] > 0
    return rows


@pytest.mark.parametrize("size", SIZES)
def test_girths_asked_are_made_for_a_table_size(command, size):
    rows = check_body(read(command("body", "--size", size, "--json")))
    assert [rows[name]["derived"] for name in ("stature", "bust", "waist", "hip")] == [False] * 4
    assert rows["knee"]["derived"] is True


@pytest.mark.parametrize("body", BODIES)
def test_girths_asked_are_made_for_a_garmentcode_body(command, data, body):
    rows = check_body(read(command("body", "--tape", data(f"garmentcode/bodies/{body}.yaml"), "--json")))
    assert rows["waist"]["derived"] is False and rows["hip"]["derived"] is False


def test_girths_asked_are_made_for_a_row_of_a_table(command, data, one_line):
    table = data("freesewing/models.csv")
    names = [line.split(",")[0] for line in table.read_text().splitlines()[1:] if line]
    adult = next(name for name in names if "doll" not in name.lower() and "giant" not in name.lower())
    check_body(read(command("body", "--tape", table, "--row", adult, "--json")))
    said = one_line(command("body", "--tape", table, "--row", "Nobody", code=2))
    assert "Nobody" in said
    assert "--row" in one_line(command("body", "--tape", table, code=2)) or "row" in said


def test_the_figures_for_people_are_those_for_programs(command, tape):
    rows = {row["name"]: row for row in read(command("body", "--tape", tape, "--json"))["measures"]}
    lines = command("body", "--tape", tape).stdout.decode().splitlines()
    assert lines[0].split() == ["measure", "asked", "made", "error"] and lines[-1].startswith("volume ")
    for line in lines[1:-1]:
        words = line.split()
        factor = 100.0 if words[2] == "cm" else 180.0 / math.pi
        assert float(words[1]) == pytest.approx(factor * rows[words[0]]["asked_m"], abs=0.006)
        assert ("derived" in words) == rows[words[0]]["derived"]
        assert "-0.00" not in words


def test_designs_can_all_be_drafted_for_every_kind_of_person(command):
    designs = read(command("designs", "--json"))
    assert len({row["name"] for row in designs}) == len(designs) >= 4
    assert all(row["name"] and row["family"] and row["title"] for row in designs)
    assert all(row["words"] for row in designs)
    plain = [row for row in designs if row["name"] in ("tshirt", "sleeveless", "bodice", "skirt", "skirt_plain")]
    assert len(plain) == 5 and all(set(row["groups"]) == {"women", "men", "children"} for row in plain)
    for row in plain:
        for size in ("W34", "W52", "M50"):
            pattern = read(command("draft", "--design", row["name"], "--size", size, "-o", "-"))
            assert len(pattern["panels"]) >= 2 and pattern["seams"] and finite(pattern)


def test_a_draft_survives_every_way_through_convert(command, patterns, tmp_path):
    for design in ("tshirt", "skirt"):
        source = patterns(design)
        whole = source.read_bytes()
        assert command("convert", source, "-").stdout == whole
        assert command("convert", source, "-", "--to", "json").stdout == whole
        command("convert", source, tmp_path / "again.json")
        command("convert", tmp_path / "again.json", tmp_path / "thrice.json")
        assert (tmp_path / "thrice.json").read_bytes() == whole


def test_a_tape_goes_to_standard_output(command, tape, tmp_path):
    command("convert", tape, tmp_path / "t.tape")
    assert command("convert", tape, "-").stdout == (tmp_path / "t.tape").read_bytes()


# ---- paper ----

def test_pages_are_those_of_the_pdf_and_cover_the_sheet_without_gap(command, patterns, tmp_path):
    for paper in ("a4", "letter", "roll"):
        pdf = tmp_path / f"{paper}.pdf"
        plan = read(command("print", "--pattern", patterns("tshirt"), "--pdf", pdf, "--paper", paper, "--json"))
        assert set(plan) >= {"pages", "columns", "rows", "width_m", "height_m", "tiles"}
        tiles = plan["tiles"]
        assert plan["pages"] == len(tiles) + (1 if tiles[0]["page"] == 1 else 0)
        assert len({(tile["x_m"], tile["y_m"]) for tile in tiles}) == len(tiles) <= plan["columns"] * plan["rows"]
        assert pdf.read_bytes().count(b"/Type /Page\n") in (0, plan["pages"])
        for tile in tiles:
            assert tile["x_m"] < plan["width_m"] and tile["y_m"] < plan["height_m"]
            assert tile["x_m"] + tile["width_m"] > 0 and tile["y_m"] + tile["height_m"] > 0


def test_a_line_for_people_says_how_many_pages(command, patterns, tmp_path):
    plan = read(command("print", "--pattern", patterns("skirt"), "--pdf", tmp_path / "a.pdf", "--json"))
    said = command("print", "--pattern", patterns("skirt"), "--pdf", tmp_path / "b.pdf").stdout.decode()
    assert f"{plan['pages']} pages" in said and "b.pdf" in said
    assert (tmp_path / "a.pdf").read_bytes() == (tmp_path / "b.pdf").read_bytes()
    bare = command("print", "--pattern", patterns("skirt"), "--pdf", "-").stdout
    assert bare == (tmp_path / "a.pdf").read_bytes()


def test_a_sheet_has_a_group_for_each_printed_piece(command, patterns):
    out = command("print", "--pattern", patterns("tshirt"), "--svg", "-").stdout
    ids = [group.get("id") for group in xml.etree.ElementTree.fromstring(out).iter(SVG + "g") if group.get("id")]
    assert len(ids) == len(set(ids))
    panels = json.loads(patterns("tshirt").read_text())["panels"]
    printed = [panel["name"] for panel in panels if not panel.get("mirror_of")]
    assert printed
    for name in printed:
        for part in ("", ".cut", ".seam", ".grain", ".label"):
            assert name + part in ids, name + part
    for panel in panels:
        assert (panel["name"] in ids) == (panel["name"] in printed)


def test_an_allowance_is_for_edges_that_say_none(command, patterns, tmp_path):
    def sheet(pattern, allowance):
        return command("print", "--pattern", pattern, "--svg", "-", "--allowance", allowance).stdout
    assert sheet(patterns("skirt"), 5) == sheet(patterns("skirt"), 30)
    bare = json.loads(patterns("skirt").read_text())
    assert all(edge.pop("allowance") >= 0 for edge in bare["edges"])
    (tmp_path / "bare.json").write_text(json.dumps(bare))
    assert sheet(tmp_path / "bare.json", 5) != sheet(tmp_path / "bare.json", 30)


def test_the_name_of_the_tape_is_on_the_label(command, patterns, tape):
    def sheet(*options):
        return command("print", "--pattern", patterns("skirt"), "--svg", "-", *options).stdout
    assert sheet("--tape", tape) != sheet()
