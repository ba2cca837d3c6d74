"""The command end to end: what it writes, what it says, how it ends."""
import json

import pytest

COMMANDS = ["body", "designs", "draft", "grade", "dress", "print", "layout", "convert", "seams", "catalogue", "find", "bench", "verify"]
TAPES = ["w40", "m50", "child116"]
REPORT_KEYS = {"status", "nodes", "springs", "seams_closed", "max_seam_gap_mm", "max_penetration_mm", "max_strain",
               "seconds", "steps", "step_s", "step_bound_s", "spring_evaluations", "contact_queries", "skipped",
               "state_hash"}


@pytest.fixture(scope="module")
def skirt(patterns):
    """A drafted skirt as muslin JSON."""
    return patterns("skirt")


# ---- help ----

def test_help_names_every_command(command):
    text = command("--help").stdout.decode()
    for name in COMMANDS:
        assert name in text
        assert "usage: muslin " + name in command(name, "--help").stdout.decode()


def test_version_is_that_of_the_header(command, root):
    header = (root / "include/muslin/base.h").read_text()
    numbers = [line.split()[2] for line in header.splitlines() if line.startswith("#define MUS_VERSION_")]
    assert command("--version").stdout.decode().split()[-1] == ".".join(numbers)


# ---- body ----

@pytest.mark.parametrize("name", TAPES)
def test_every_girth_asked_is_made_within_a_millimetre(command, root, name):
    done = command("body", "--tape", root / f"examples/tapes/{name}.tape", "--json")
    report = json.loads(done.stdout)
    measures = {row["name"]: row for row in report["measures"]}
    girths = ["bust", "waist", "hip", "neck", "upper_arm", "wrist", "thigh", "knee", "head"]
    for girth in girths:
        assert measures[girth]["made_m"] == pytest.approx(measures[girth]["asked_m"], abs=0.001), girth
    assert not measures["bust"]["derived"] and measures["bust"]["asked_m"] > 0
    assert 0.01 < report["volume_m3"] < 0.2


def points_of(path):
    return [tuple(map(float, line.split()[1:])) for line in path.read_text().splitlines() if line.startswith("v ")]


def test_poses_and_movements_are_listed_and_stood_in(command, tape, tmp_path):
    names = [line.split() for line in command("body", "--poses").stdout.decode().splitlines()]
    assert {"pose", "move"} == {kind for kind, _ in names} and len(names) > 18
    standing = tmp_path / "standing.obj"
    command("body", "--tape", tape, "--obj", standing)
    tall = max(y for _, y, _ in points_of(standing))
    for kind, name in [("pose", "sit"), ("pose", "squat"), ("move", "walk")]:
        command("body", "--tape", tape, f"--{kind}", name, "--obj", tmp_path / f"{name}.obj")
        heights = [y for _, y, _ in points_of(tmp_path / f"{name}.obj")]
        assert len(heights) == len(points_of(standing))
        assert min(heights) == pytest.approx(0.0, abs=0.01)
        assert max(heights) < tall - (0.25 if kind == "pose" else 0.0)
    command("body", "--tape", tape, "--move", "walk", "--at", "0.5", "--obj", tmp_path / "later.obj")
    assert points_of(tmp_path / "later.obj") != points_of(tmp_path / "walk.obj")
    assert b"fly" in command("body", "--tape", tape, "--pose", "fly", code=2).stderr
    command("body", "--tape", tape, "--pose", "sit", "--move", "walk", code=2)


def test_the_closed_surface_has_two_triangles_at_each_edge(command, tape, tmp_path, one_line):
    closed, pose = tmp_path / "closed.obj", ["--pose", "sit"]
    command("body", "--tape", tape, *pose, "--manifold", "--spacing", "25", "--obj", closed, "--glb",
            tmp_path / "closed.glb")
    corners = [[int(corner.split("/")[0]) for corner in line.split()[1:]]
               for line in closed.read_text().splitlines() if line.startswith("f ")]
    edges = {(face[k], face[(k + 1) % 3]) for face in corners for k in range(3)}
    assert len(edges) == 3 * len(corners) and all((b, a) in edges for a, b in edges)
    assert len(points_of(closed)) - len(edges) // 2 + len(corners) == 2
    assert (tmp_path / "closed.glb").read_bytes()[:4] == b"glTF"
    assert "--obj, --glb or a picture" in one_line(command("body", "--tape", tape, "--manifold", code=2))
    assert "needs --manifold" in one_line(command("body", "--tape", tape, "--spacing", "5", "--obj", closed, code=2))


def test_a_posture_keeps_the_girths_and_is_refused_beyond_its_range(command, tape, tmp_path, one_line):
    stoop = ["--stoop", "50", "--head-forward", "-5", "--sway", "20"]
    upright, bent = [{m["name"]: m["made_m"] for m in json.loads(command("body", "--tape", tape, *more, "--json").stdout)
                      ["measures"]} for more in ([], stoop)]
    for name in ["bust", "waist", "hip", "neck", "head", "nape_height", "bust_height", "stature"]:
        assert abs(upright[name] - bent[name]) < 1e-9, name
    assert bent["back_waist"] > upright["back_waist"] + 0.01
    assert "stoop 0.15 m" in one_line(command("body", "--tape", tape, "--stoop", "150", code=2))
    for which in ("body", "dress"):
        more = ["--design", "tshirt"] if which == "dress" else []
        assert "--sway" in one_line(command(which, *more, "--tape", tape, "--mesh", "a.obj", "--sway", "1", code=2))


def test_json_goes_to_standard_output_and_nothing_else(command, tape):
    for arguments in (["designs"], ["body", "--tape", tape]):
        done = command(*arguments, "--json")
        json.loads(done.stdout)
        assert done.stderr == b""


def test_a_doubt_about_the_tape_is_a_line_and_a_member_of_the_json(command, tmp_path):
    path = tmp_path / "ada.tape"
    path.write_text("sex female\nstature 165 cm\nbust 69 cm\nwaist 78 cm\nhip 104 cm\n")
    done = command("body", "--tape", path, "--json")
    doubt, = json.loads(done.stdout)["warnings"]
    assert doubt.startswith("bust of 69.0 cm does not fit the others") and doubt.endswith("digits swapped: 96.0 cm?")
    assert done.stderr.decode() == f"muslin body: warning: {doubt}\n"
    assert json.loads(command("body", "--size", "W40", "--json").stdout)["warnings"] == []

    skirt = ("--design", "skirt", "--spacing", 60, "--tape", path)
    command("dress", *skirt, "--report", tmp_path / "r.json")
    assert json.loads((tmp_path / "r.json").read_text())["warnings"] == [doubt]
    command("dress", "--batch", "-", "-o", tmp_path / "out", "--spacing", 60,
            input=f"--design skirt --tape {path}".encode())
    assert json.loads((tmp_path / "out" / "results.jsonl").read_text())["warnings"] == [doubt]
    printed = command("print", *skirt[:2], "--tape", path, "--pdf", tmp_path / "s.pdf", "--json").stdout
    assert json.loads(printed)["warnings"] == [doubt]


def test_a_body_is_drawn_alone_and_turned(command, tape, tmp_path, one_line):
    view = "--view", "0,5", "--pixels", "64x96"
    if b"EGL" in command("body", "--tape", tape, "--png", tmp_path / "a.png", *view, code=None).stderr:
        pytest.skip("a machine without EGL")  # the renderer is optional; muslin without it says so in one sentence
    command("body", "--tape", tape, "--turn", 3, "--frames", tmp_path, *view)
    names = ["a.png"] + [f"frame_000{k}.png" for k in (1, 2, 3)]
    pictures = [(tmp_path / name).read_bytes() for name in names]
    assert pictures[0] == pictures[1] and len(set(pictures)) == 3
    assert "go together" in one_line(command("body", "--tape", tape, "--turn", 3, code=2))
    assert "--view" in one_line(command("body", "--tape", tape, "--png", tmp_path / "b.png", "--view", "front", code=2))


# ---- draft and convert ----

def test_designs_have_name_family_and_title(command):
    rows = json.loads(command("designs", "--json").stdout)
    assert {"tshirt", "skirt"} <= {row["name"] for row in rows}
    assert all(set(row) >= {"name", "family", "title"} for row in rows)


def test_a_dash_writes_the_same_pattern_to_standard_output(command, tape, skirt):
    assert command("draft", "--design", "skirt", "--tape", tape, "-o", "-").stdout == skirt.read_bytes()


def test_converting_a_pattern_to_its_own_form_changes_no_byte(command, skirt, tmp_path):
    command("convert", skirt, tmp_path / "again.json")
    assert (tmp_path / "again.json").read_bytes() == skirt.read_bytes()


def test_a_tape_written_again_makes_the_same_body(command, root, tmp_path):
    for name in TAPES:
        source = root / f"examples/tapes/{name}.tape"
        command("convert", source, tmp_path / "again.tape")
        first, again = (json.loads(command("body", "--tape", path, "--json").stdout)
                        for path in (source, tmp_path / "again.tape"))
        assert first["measures"] == again["measures"]


def test_a_garmentcode_specification_becomes_a_pattern(command, data, tmp_path):
    command("convert", data("garmentcode/specs/d11_002_mean_all_specification.json"), tmp_path / "out.json")
    command("convert", tmp_path / "out.json", tmp_path / "again.json")
    assert (tmp_path / "out.json").read_bytes() == (tmp_path / "again.json").read_bytes()


def test_a_dxf_in_sizes_comes_back_and_what_it_loses_is_told(command, skirt, tmp_path):
    told = command("convert", skirt, tmp_path / "s.dxf", "--dialect", "aama").stderr
    assert "dxf does not keep" in str(told) and "seams" in str(told)
    command("convert", tmp_path / "s.dxf", tmp_path / "s.json")
    before, after = (json.loads(path.read_text()) for path in (skirt, tmp_path / "s.json"))
    assert len(after["panels"]) == len(before["panels"]) and not after["seams"]
    command("print", "--design", "tshirt", "--size", "W40", "--dxf", tmp_path / "n.dxf", "--rul", tmp_path / "n.rul",
            "--sizes", "W36,W44", "--plt", tmp_path / "n.plt")
    for options in ([], ["--size", "W44"], ["--size", "W44", "--rul", tmp_path / "n.rul"]):
        command("convert", tmp_path / "n.dxf", tmp_path / "n.json", *options)
        assert len(json.loads((tmp_path / "n.json").read_text())["panels"]) == 5  # with the neckband
    assert (tmp_path / "n.plt").read_text().startswith("IN;PS")


# ---- dress ----

@pytest.fixture(scope="module")
def dressed(tmp_path_factory, command, tape, skirt):
    folder = tmp_path_factory.mktemp("dress")
    command("dress", "--pattern", skirt, "--tape", tape, "--spacing", 25, "--png", folder / "a.png", "--glb",
            folder / "a.glb", "--obj", folder / "a.obj", "--report", folder / "r.json")
    return folder


def test_a_dressed_skirt_is_settled_closed_and_outside_the_body(dressed):
    report = json.loads((dressed / "r.json").read_text())
    assert report["status"] == "settled"
    assert report["seams_closed"] == report["seams"] and report["max_seam_gap_mm"] <= 1
    assert report["max_penetration_mm"] < 2
    assert report["step_s"] > 0 and report["steps"] > 0 and report["nodes"] > 100


def test_the_report_has_the_keys_that_scripts_rely_on(dressed):
    report = json.loads((dressed / "r.json").read_text())
    assert REPORT_KEYS <= set(report)
    assert {"draft", "mesh", "sew", "settle", "render"} <= set(report["seconds"])
    assert len(report["state_hash"]) == 16 and int(report["state_hash"], 16) >= 0


def test_picture_and_meshes_are_what_their_names_say(dressed):
    assert (dressed / "a.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"
    assert (dressed / "a.glb").read_bytes()[:4] == b"glTF"
    names = [line for line in (dressed / "a.obj").read_text().splitlines() if line.startswith("o ")]
    assert len(names) == 2


def test_the_state_does_not_depend_on_threads(command, tape, skirt, tmp_path):
    hashes = set()
    for threads in (1, 2, 3):
        command("dress", "--pattern", skirt, "--tape", tape, "--spacing", 30, "--threads", threads, "--report",
                tmp_path / "r.json")
        hashes.add(json.loads((tmp_path / "r.json").read_text())["state_hash"])
    assert len(hashes) == 1


# ---- print ----

@pytest.mark.parametrize("paper", ["a4", "letter", "a3", "a0", "roll"])
def test_paper_is_tiled_to_cover_the_sheet(command, skirt, tmp_path, paper):
    done = command("print", "--pattern", skirt, "--pdf", tmp_path / "p.pdf", "--svg", tmp_path / "p.svg", "--paper",
                   paper, "--json")
    plan = json.loads(done.stdout)
    assert 0 < len(plan["tiles"]) <= plan["columns"] * plan["rows"]  # tiles without ink are left out
    assert plan["pages"] >= len(plan["tiles"])
    assert max(tile["x_m"] + tile["width_m"] for tile in plan["tiles"]) >= plan["width_m"] - 1e-9
    assert (tmp_path / "p.pdf").read_bytes()[:5] == b"%PDF-"
    assert b"<svg" in (tmp_path / "p.svg").read_bytes()[:400]


# ---- locale ----

def test_a_comma_locale_changes_no_byte(command, tape, skirt, tmp_path, comma):
    for name, options in {"plain": {}, "comma": comma}.items():
        folder = tmp_path / name
        folder.mkdir()
        command("draft", "--design", "skirt", "--tape", tape, "-o", folder / "skirt.json", **options)
        command("print", "--pattern", skirt, "--pdf", folder / "p.pdf", "--svg", folder / "p.svg", **options)
        command("body", "--tape", tape, "--obj", folder / "b.obj", **options)
        command("convert", tape, folder / "t.tape", **options)
    for file in sorted((tmp_path / "plain").iterdir()):
        assert file.read_bytes() == (tmp_path / "comma" / file.name).read_bytes(), file.name


# ---- bad input: one line that says what and where, exit 2, no file ----

BAD_TAPES = {
    "waist 76": "unit",
    "waist 1,234 mm": "thousands",
    "waist nan cm": "nan",
    "waist 1e9 cm": "waist",
    "waist -3 cm": "waist",
    "wiast 76 cm": "wiast",
    "waist": "waist",
    "sex other": "other",
    "waist 76 cm\nwaist 77 cm": "waist",
}


@pytest.mark.parametrize("line", BAD_TAPES, ids=lambda line: line.replace("\n", "|"))
def test_a_bad_line_of_a_tape_is_named(command, tmp_path, line, one_line):
    path = tmp_path / "bad.tape"
    path.write_text(f"# a tape\nstature 168 cm\nbust 92 cm\nhip 100 cm\n{line}\n")
    text = one_line(command("body", "--tape", path, code=2))
    assert BAD_TAPES[line] in text and "bad.tape" in text
    assert ":5" in text or ":6" in text or "line 5" in text or "line 6" in text, text


def test_a_tape_in_contradiction_is_refused_with_both_names(command, tmp_path, one_line):
    path = tmp_path / "bad.tape"
    path.write_text("sex female\nstature 168 cm\nbust 92 cm\nwaist 76 cm\nhip 100 cm\n"
                    "waist_height 104 cm\nrise 26 cm\ninleg 60 cm\n")
    text = one_line(command("body", "--tape", path, code=2))
    assert "inleg" in text and "waist_height" in text


@pytest.mark.parametrize("arguments, word", [
    (["sew"], "sew"),
    (["body", "--tap", "x"], "--tap"),
    (["body", "--tape"], "--tape"),
    (["body"], "--tape"),
    (["body", "--tape", "no/such.tape"], "no/such.tape"),
    (["draft", "--design", "spacesuit", "--size", "W40", "-o", "-"], "spacesuit"),
    (["draft", "--design", "skirt", "--size", "W41", "-o", "-"], "W41"),
    (["draft", "--design", "skirt", "--size", "W40"], "-o"),
    (["dress", "--design", "skirt"], "--tape"),
    (["dress", "--size", "W40"], "--design"),
    (["dress", "--design", "skirt", "--size", "W40", "--spacing", "0"], "--spacing"),
    (["dress", "--design", "skirt", "--size", "W40", "--spacing", "nan"], "--spacing"),
    (["dress", "--design", "skirt", "--size", "W40", "--spacing", "12,5"], "--spacing"),
    (["dress", "--design", "skirt", "--size", "W40", "--threads", "1e9"], "--threads"),
    (["dress", "--design", "skirt", "--size", "W40", "--fabric", "lead"], "lead"),
    (["print", "--design", "skirt", "--size", "W40"], "--pdf"),
    (["layout", "--design", "skirt", "--size", "W40", "--material", "silk"], "--material silk"),
    (["layout", "--design", "skirt", "--size", "W40", "--width", "300"], "wider than the cloth"),
    (["print", "--design", "skirt", "--size", "W40", "--pdf", "x.pdf", "--paper", "a9"], "a9"),
    (["convert", "only-one.json"], "two files"),
], ids=lambda value: " ".join(value) if isinstance(value, list) else "")
def test_bad_arguments_are_named(command, tmp_path, arguments, word, one_line):
    assert word in one_line(command(*arguments, code=2, cwd=tmp_path))
    assert list(tmp_path.iterdir()) == []


def test_a_pattern_cut_short_anywhere_is_refused_or_whole(command, skirt, tmp_path, one_line):
    whole = skirt.read_bytes()
    cut = tmp_path / "cut.json"
    for n in sorted({0, 1, 2, len(whole) // 3, len(whole) // 2, len(whole) - 40, len(whole) - 3}):
        cut.write_bytes(whole[:n])
        assert "cut.json" in one_line(command("convert", cut, tmp_path / "out.json", code=2))
        assert not (tmp_path / "out.json").exists()


@pytest.mark.parametrize("text", ["[]", "{}", "null", '"pattern"', "{\"pattern\": 5}", "\x00\xff", "[" * 100000,
                                  '{"pattern": {"panels": {}, "stitches": 1e9}, "properties": {}}'],
                         ids=["list", "empty", "null", "text", "number", "bytes", "deep", "count"])
def test_a_file_that_is_no_pattern_is_refused(command, tmp_path, text, one_line):
    path = tmp_path / "bad.json"
    path.write_bytes(text.encode("latin-1"))
    assert "bad.json" in one_line(command("convert", path, tmp_path / "out.json", code=2))
    assert not (tmp_path / "out.json").exists()


@pytest.mark.parametrize("option", ["--pdf", "--svg"])
def test_an_output_that_cannot_be_written_leaves_nothing(command, skirt, tmp_path, option, one_line):
    done = command("print", "--pattern", skirt, option, tmp_path / "missing" / "p.out", code=None)
    assert done.returncode in (1, 2) and "missing" in one_line(done)
    assert list(tmp_path.iterdir()) == []


def test_an_old_output_survives_a_failed_one(command, tmp_path, tape):
    old = tmp_path / "out.json"
    old.write_text("old")
    command("convert", tmp_path / "not-there.json", old, code=2)
    command("draft", "--design", "spacesuit", "--tape", tape, "-o", old, code=2)
    assert old.read_text() == "old"


def test_layout_tells_metres_and_draws_each_material(command, tmp_path):
    quick = ["layout", "--design", "shirt", "--size", "W40", "--effort", "0.02", "--width", "1400", "--nap"]
    told = json.loads(command(*quick, "--fold", "--json", "--svg", tmp_path / "cloth.svg").stdout)
    assert told["width_m"] == 1.4 and 0.8 < told["length_m"] < 2.0 and 0.5 < told["utilisation"] < 1.0
    assert [m["material"] for m in told["materials"]] == ["main", "interfacing"]
    assert told["materials"][0]["pieces"] == told["pieces"] and told["folded_m"] <= told["length_m"]
    assert (tmp_path / "cloth.svg").stat().st_size > 1000 and (tmp_path / "cloth-interfacing.svg").stat().st_size > 1000
    for piece in told["pieces"]:
        assert not piece["turned"] and max(piece["outline_m"][::2]) <= told["length_m"] + 1e-6
    area = sum(abs(sum(xy[i] * xy[i + 3 - n] - xy[i + 1] * xy[i + 2 - n]
                       for i in range(0, len(xy), 2) for n in [len(xy) if i + 2 == len(xy) else 0])) / 2
               * (2 if p["on_fold"] else p["layers"] - p["spare"]) for p in told["pieces"] for xy in [p["outline_m"]])
    assert area / told["width_m"] / told["length_m"] == pytest.approx(told["utilisation"], rel=1e-4)
    line = command(*quick, "--material", "main").stdout.decode()
    assert line.startswith("main: ") and " m of 1.40 m wide; " in line and len(line.splitlines()) == 1
    again = [command(*quick, "--runs", "3", "--threads", n, "--json").stdout for n in ("1", "3")]
    assert again[0] == again[1]
