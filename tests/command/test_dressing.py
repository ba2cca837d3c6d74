"""Dressing end to end: reports, states that do not depend on threads or on who asks, real garments, progress."""
import json
import math
import os
import pty
import struct
import subprocess

import pytest

STATUS = {"settled", "twisted seam", "panel crosses itself", "seam cannot close", "start tangled", "slid off", "tangled",
          "not settled", "unstable", "not worn", "no memory", "bad input"}
COUNTS = ["panels", "nodes", "springs", "seams", "seams_closed", "steps", "spring_evaluations", "contact_queries"]
NUMBERS = ["max_seam_gap_mm", "max_penetration_mm", "max_strain", "residual", "max_speed_m_s", "mass_kg", "step_s",
           "step_bound_s", "sew_time_s", "settle_time_s"]

# one of each kind of garment, small ones: (specification, body)
SAMPLE = [("d11_007_mean_all", "mean_all"), ("d11_045_mean_all", "mean_all"), ("d11_012_mean_female", "mean_female"),
          ("d11_043_mean_female", "mean_female")]


@pytest.fixture
def dress(command, tmp_path):
    """Dress and return (report, finished process)."""
    def run(*arguments, code=0):
        report = tmp_path / "report.json"
        report.unlink(missing_ok=True)
        done = command("dress", *arguments, "--report", report, code=code)

        def refuse(word):
            raise AssertionError(f"{word} is no JSON")
        return json.loads(report.read_text(), parse_constant=refuse), done
    return run


def check(report, code):
    """What every report has, whatever became of the garment."""
    assert report["status"] in STATUS
    assert (report["status"] == "settled") == (code == 0)
    assert ("reason" in report) == (code != 0)
    for name in COUNTS:
        assert isinstance(report[name], int) and report[name] >= 0, name
    for name in NUMBERS:
        assert isinstance(report[name], (int, float)) and math.isfinite(report[name]) and report[name] >= 0, name
    assert all(report["seconds"][name] >= 0 for name in ("draft", "body", "place", "mesh", "sew", "settle", "render"))
    assert len(report["state_hash"]) == 16 and int(report["state_hash"], 16) > 0
    assert report["seams_closed"] <= report["seams"]
    # a garment that is too tight to go on is told before the first step
    assert report["steps"] == 0 or (report["step_s"] > 0 and report["step_bound_s"] > 0)
    assert isinstance(report["skipped"], str)


# ---- the T-shirt ----

def test_the_tshirt_settles_closed_and_outside_the_body(dress, tape):
    report, done = dress("--design", "tshirt", "--tape", tape, "--spacing", 30)
    check(report, 0)
    assert report["garment"] == "tshirt" and report["panels"] == 4
    assert report["seams_closed"] == report["seams"] == 10 and report["max_seam_gap_mm"] <= 1
    assert report["max_penetration_mm"] < 2 and report["max_strain"] < 0.3
    assert 0.05 < report["mass_kg"] < 0.4
    said = done.stdout.decode()
    assert said.startswith("tshirt: settled; ") and said.count("\n") == 1 and done.stderr == b""


def test_a_finer_tshirt_settles_too(dress, tape):
    report, _ = dress("--design", "tshirt", "--tape", tape, "--spacing", 15)
    check(report, 0)
    assert report["nodes"] > 2500 and report["seams_closed"] == report["seams"]
    assert report["max_penetration_mm"] < 2


@pytest.mark.parametrize("design, size", [("sleeveless", "W34"), ("sleeveless", "W52"), ("sleeveless", "M50"),
                                          ("tshirt", "M50"), ("tshirt", "C116"), ("skirt", "W34"), ("skirt", "W48")])
def test_designs_settle_on_thin_and_stout_people(dress, design, size):
    report, _ = dress("--design", design, "--size", size, "--spacing", 35)
    check(report, 0)
    assert report["max_penetration_mm"] < 2


def test_the_state_is_the_same_for_any_number_of_threads_and_of_runs(dress, tape):
    scene = ("--design", "tshirt", "--tape", tape, "--spacing", 30)
    first, _ = dress(*scene, "--threads", 1)
    again, _ = dress(*scene, "--threads", 1)
    two, _ = dress(*scene, "--threads", 2)
    four, _ = dress(*scene, "--threads", 4)
    assert first["state_hash"] == again["state_hash"] == two["state_hash"] == four["state_hash"]
    assert first["steps"] == two["steps"] and first["contact_queries"] == two["contact_queries"]


def test_twice_the_precision_is_the_same_garment(dress, tape):
    scene = ("--design", "skirt", "--tape", tape, "--spacing", 30)
    single, _ = dress(*scene, "--precision", 32)
    double, _ = dress(*scene, "--precision", 64)
    check(double, 0)
    assert double["state_hash"] != single["state_hash"]
    assert double["nodes"] == single["nodes"] and double["mass_kg"] == single["mass_kg"]
    assert double["max_strain"] == pytest.approx(single["max_strain"], abs=0.05)


def test_fabric_friction_and_spacing_change_the_state(dress, patterns, tape):
    base = ("--pattern", patterns("sleeveless"), "--tape", tape)
    hashes = [dress(*base, *options, code=None)[0]["state_hash"] for options in
              (["--spacing", 40], ["--spacing", 38], ["--spacing", 40, "--fabric", "silk"],
               ["--spacing", 40, "--friction", 0.9])]
    assert len(set(hashes)) == len(hashes)


def test_a_fabric_file_is_the_fabric(dress, patterns, tape, tmp_path):
    muslin = pytest.importorskip("muslin")
    muslin.Fabric("silk").write(tmp_path / "mine.json", "mine", {
        muslin.cloth.lib.mus_fabric_value_key(i).decode(): "assumed" for i in range(muslin.cloth.lib.mus_fabric_value_count())})
    base = ("--pattern", patterns("sleeveless"), "--tape", tape, "--spacing", 40, "--fabric")
    named, file = (dress(*base, fabric, code=None)[0]["state_hash"] for fabric in ("silk", tmp_path / "mine.json"))
    assert named == file


def test_a_design_and_its_drafted_pattern_are_the_same_garment(dress, patterns, tape):
    drafted, _ = dress("--pattern", patterns("skirt"), "--tape", tape, "--spacing", 30)
    named, _ = dress("--design", "skirt", "--tape", tape, "--spacing", 30)
    assert drafted["state_hash"] == named["state_hash"]


def test_the_package_has_the_hash_of_the_command(dress, patterns, tape):
    muslin = pytest.importorskip("muslin")
    for design, precision in (("tshirt", 32), ("skirt", 64)):
        report, _ = dress("--pattern", patterns(design), "--tape", tape, "--spacing", 30, "--precision", precision)
        drape = muslin.Drape(muslin.Cloth(muslin.Pattern.read(patterns(design)), spacing=0.030),
                             muslin.Body(muslin.Tape.read(tape)), precision=precision, threads=2)
        drape.place()
        drape.sew()
        drape.settle()
        assert drape.state_hash == report["state_hash"]


def test_the_package_tells_the_fit_of_the_command(dress, patterns, tape):
    muslin = pytest.importorskip("muslin")
    report, _ = dress("--pattern", patterns("tshirt"), "--tape", tape, "--spacing", 30)
    body = muslin.Body(muslin.Tape.read(tape))
    drape = muslin.Drape(muslin.Cloth(muslin.Pattern.read(patterns("tshirt")), spacing=0.030), body)
    drape.place()
    drape.sew()
    drape.settle()
    fit = muslin.Fit(drape, body)
    assert drape.reason["name"] == "settled"
    assert [level["level"] for level in fit.levels] == [level["level"] for level in report["fit"]["levels"]]
    for ours, theirs in zip(fit.levels, report["fit"]["levels"]):
        assert ours["ease"] == pytest.approx(theirs["ease_m"], abs=1e-8)
    assert {"bust", "waist", "hip"} <= {level["level"] for level in fit.levels}
    assert max(fit.pressure) == pytest.approx(report["fit"]["pressure_Pa"]["most"], rel=1e-8)


def test_a_map_colours_the_cloth_and_has_a_scale(command, dress, tape, tmp_path):
    pictures = []
    for name in (None, "strain", "pressure", "ease"):
        picture = tmp_path / f"{name}.png"
        dress("--design", "tshirt", "--tape", tape, "--spacing", 40, "--pixels", "300x200", "--png", picture,
              *(["--map", name] if name else []))
        pictures.append(picture.read_bytes())
    assert len(set(pictures)) == 4
    done = command("dress", "--design", "tshirt", "--tape", tape, "--map", "taste", code=2)
    assert b"expected strain, pressure or ease" in done.stderr


def test_json_on_standard_output_is_the_report(command, dress, tape, timeless):
    scene = ("--design", "skirt", "--tape", tape, "--spacing", 40)
    report, _ = dress(*scene)
    done = command("dress", *scene, "--json")
    printed = json.loads(done.stdout)
    assert done.stderr == b""
    assert timeless(printed) == timeless(report)


# ---- shapes ----

def chunk(data, offset):
    size, kind = struct.unpack_from("<II", data, offset)
    return kind, data[offset + 8:offset + 8 + size], offset + 8 + size


def test_meshes_hold_body_and_garment(command, dress, tape, tmp_path, root):
    glb, obj = tmp_path / "a.glb", tmp_path / "a.obj"
    report, _ = dress("--design", "tshirt", "--tape", tape, "--spacing", 30, "--glb", glb, "--obj", obj)
    data = glb.read_bytes()
    assert struct.unpack_from("<III", data) == (0x46546C67, 2, len(data))
    kind, text, end = chunk(data, 12)
    assert kind == 0x4E4F534A
    scene = json.loads(text)
    panels = ["front", "back", "sleeve_left", "sleeve_right"]
    assert [node["name"] for node in scene["nodes"]] == ["body", "garment", *panels, "seams"]
    assert scene["nodes"][1]["children"] == [2, 3, 4, 5, 6]
    assert [material["name"] for material in scene["materials"]] == ["skin", *[f"jersey.{name}" for name in panels]]
    positions = [scene["accessors"][mesh["primitives"][0]["attributes"]["POSITION"]] for mesh in scene["meshes"]]
    assert sum(accessor["count"] for accessor in positions[1:-1]) == positions[-1]["count"] == report["nodes"]
    for accessor in positions:
        assert all(-2 < low <= high < 3 for low, high in zip(accessor["min"], accessor["max"]))
    assert chunk(data, end)[0] == 0x004E4942
    lines = obj.read_text().splitlines()
    assert [line for line in lines if line.startswith("o ")] == ["o body", "o garment"]
    assert [line for line in lines if line.startswith("g ")] == [f"g {name}" for name in [*panels, "seams"]]
    assert sum(line.startswith("v ") for line in lines) == sum(accessor["count"] for accessor in positions[:-1])
    assert (tmp_path / "a.mtl").read_text().count("newmtl") == 5

    done = subprocess.run(["sh", root / "tests/guard/glb.sh", glb], capture_output=True, text=True)
    if done.stdout.startswith("skipped"):
        pytest.skip(done.stdout.strip())  # node and gltf-validator are optional
    assert done.returncode == 0, done.stdout


def test_a_picture_may_go_to_standard_output(command, tape):
    done = command("dress", "--design", "skirt", "--tape", tape, "--spacing", 40, "--png", "-", "--pixels", "120x100",
                   "--view", "180,0,1", "--colour", "#804020", code=None)
    if done.returncode == 1 and b"EGL" in done.stderr:
        pytest.skip(done.stderr.decode().strip())  # a machine without EGL
    assert done.returncode == 0 and done.stdout[:8] == b"\x89PNG\r\n\x1a\n"
    assert struct.unpack(">II", done.stdout[16:24]) == (120, 100)


def test_a_fabric_has_the_colour_in_which_it_is_sold(command, tape, tmp_path):
    """Without --colour; jersey, the default, has the first colour of the palette."""
    def cloth(name, *options):
        command("dress", "--design", "skirt", "--tape", tape, "--spacing", 60, "--glb", tmp_path / name, *options)
        data = (tmp_path / name).read_bytes()
        head = json.loads(data[20:20 + struct.unpack("<I", data[12:16])[0]])
        return {tuple(round(c, 3) for c in material["pbrMetallicRoughness"]["baseColorFactor"])
                for material in head["materials"]}
    plain = cloth("plain.glb")
    assert cloth("jersey.glb", "--fabric", "jersey") == plain
    denim = cloth("denim.glb", "--fabric", "denim")
    assert len(denim - plain) == 1 and cloth("denim_b.glb", "--fabric", "denim_b") == denim
    assert cloth("asked.glb", "--fabric", "denim", "--colour", "#678db0") != denim


# ---- real garments: each comes to an end that has a name ----

@pytest.mark.parametrize("specification, body", SAMPLE)
def test_a_garmentcode_garment_ends_with_a_word_from_the_list(dress, data, specification, body):
    spec = data(f"garmentcode/specs/{specification}_specification.json")
    tape = data(f"garmentcode/bodies/{body}.yaml")
    report, done = dress("--pattern", spec, "--tape", tape, "--spacing", 30, code=None)
    assert done.returncode in (0, 1)
    check(report, done.returncode)
    assert report["panels"] == len(json.loads(spec.read_text())["pattern"]["panels"])
    lines = [line for line in done.stderr.decode().splitlines() if "warning:" not in line]
    assert len(lines) == (0 if done.returncode == 0 else 1)
    if lines:
        assert report["reason"] in lines[0]


def test_where_the_places_of_a_file_are_wrong_others_are_found(dress, patterns, tape, tmp_path):
    # front and back each where the other belongs
    pattern = json.loads(patterns("tshirt").read_text())
    front, back = (next(panel for panel in pattern["panels"] if panel["name"] == name) for name in ("front", "back"))
    front["placement"], back["placement"] = back["placement"], front["placement"]
    path = tmp_path / "exchanged.json"
    path.write_text(json.dumps(pattern))
    asked, _ = dress("--pattern", path, "--tape", tape, "--spacing", "40", "--place", "file", code=1)
    report, _ = dress("--pattern", path, "--tape", tape, "--spacing", "40")
    assert asked["start"] == "pattern" and asked["status"] == "start tangled"
    assert report["start"] == "found" and report["status"] == "settled"


def test_a_specification_cut_short_is_refused(command, one_line, data, tape, tmp_path):
    whole = data("garmentcode/specs/d11_007_mean_all_specification.json").read_bytes()
    for n in (0, 1, len(whole) // 2, len(whole) - 10):
        (tmp_path / "cut.json").write_bytes(whole[:n])
        done = command("dress", "--pattern", tmp_path / "cut.json", "--tape", tape, "--png", tmp_path / "p.png",
                       "--report", tmp_path / "r.json", code=2)
        said = one_line(done)
        assert "cut.json" in said
        assert sorted(file.name for file in tmp_path.iterdir()) == ["cut.json"]


# ---- a run that fails ----

def test_a_garment_that_cannot_be_worn_is_told_with_a_report(dress, patterns, tmp_path):
    """A skirt a fifth as wide as it should be: the run ends, says why, and writes what there is."""
    pattern = json.loads(patterns("skirt_plain").read_text())
    for point in pattern["points"]:
        point["at"][0] *= 0.2
    for edge in pattern["edges"]:
        for piece in edge["pieces"]:
            for place in [*piece.get("controls", []), *([piece["end"]] if "end" in piece else [])]:
                place[0] *= 0.2
    pattern["notches"] = pattern["marks"] = []
    path = tmp_path / "narrow.json"
    path.write_text(json.dumps(pattern))
    report, done = dress("--pattern", path, "--size", "W52", "--spacing", 30, "--fabric", "denim", "--obj",
                         tmp_path / "a.obj", code=1)
    check(report, 1)
    assert done.stderr.count(b"\n") == 1 and report["reason"] in done.stderr.decode()
    assert (tmp_path / "a.obj").exists()


# ---- where it starts ----

def test_a_garment_over_its_time_is_written_as_far_as_it_got(dress, tape, tmp_path):
    picture = tmp_path / "late.png"
    report, done = dress("--design", "full_skirt_midi", "--tape", tape, "--spacing", 30, "--limit", 0.001, "--png", picture,
                         code=1)
    assert report["status"] == "stopped" and report["reason"] == "no end after 0.001 s"
    assert len(report["starts"]) == 1 and picture.stat().st_size > 10000
    assert done.stderr.splitlines() == [b"muslin dress: no end after 0.001 s"]


def test_a_start_is_found_where_the_pattern_has_none(dress, patterns, tape, tmp_path):
    pattern = json.loads(patterns("tshirt").read_text())
    for panel in pattern["panels"]:
        panel.pop("placement", None)
    path = tmp_path / "nowhere.json"
    path.write_text(json.dumps(pattern))
    bare, _ = dress("--pattern", path, "--tape", tape, "--spacing", 40)
    found, _ = dress("--design", "tshirt", "--tape", tape, "--spacing", 40, "--place", "found")
    check(bare, 0)
    assert bare["state_hash"] == found["state_hash"]


def test_a_bad_start_is_said_and_nothing_is_sewn(dress, patterns, tape, tmp_path):
    pattern = json.loads(patterns("tshirt").read_text())
    place = {panel["name"]: panel for panel in pattern["panels"]}
    one, other = place["sleeve_left"], place["sleeve_right"]
    one["placement"], other["placement"] = other["placement"], one["placement"]
    path = tmp_path / "swapped.json"
    path.write_text(json.dumps(pattern))
    report, done = dress("--pattern", path, "--tape", tape, "--spacing", 40, "--place", "file", code=1)
    assert report["status"] == "start tangled" and report["steps"] == 0 and report["at"]["panel"].startswith("sleeve")
    assert "sleeve_left and sleeve_right" in report["reason"] and report["reason"] in done.stderr.decode()


# ---- progress ----

def on_terminal(program, *arguments):
    """Run with standard error on a terminal: (exit status, what the terminal got, standard output)."""
    master, slave = pty.openpty()
    process = subprocess.Popen([program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=slave)
    os.close(slave)
    got = b""
    while True:
        try:
            more = os.read(master, 4096)
        except OSError:  # the other end is closed
            break
        if not more:
            break
        got += more
    os.close(master)
    out = process.stdout.read()
    process.stdout.close()
    return process.wait(timeout=60), got, out


def test_progress_is_shown_on_a_terminal_and_nowhere_else(program, command, tape):
    scene = ("dress", "--design", "tshirt", "--tape", tape, "--spacing", 30)
    code, shown, out = on_terminal(program, *scene)
    assert code == 0 and b"settle" in shown and b"%" in shown
    assert shown.endswith(b"\r") and shown.split(b"\r")[-2].strip() == b"", "the line is wiped at the end"
    assert b"\n" not in shown and b"%" in out and b"\r" not in out
    assert on_terminal(program, *scene, "--quiet")[1] == b""
    assert command(*scene).stderr == b""


def test_json_stays_json_on_a_terminal(program, tape):
    code, _, out = on_terminal(program, "dress", "--design", "skirt", "--tape", tape, "--spacing", 40, "--json")
    assert code == 0 and json.loads(out)["status"] == "settled"


def test_a_locale_with_a_decimal_comma_changes_no_report(command, comma, tape, timeless):
    scene = ("dress", "--design", "skirt", "--tape", tape, "--spacing", "37.5", "--friction", "0.35", "--json")
    plain, other = (json.loads(command(*scene, **options).stdout) for options in ({}, comma))
    assert timeless(plain) == timeless(other)


def test_an_elastic_that_ends_in_a_seam_lets_it_close(command, tmp_path):
    report = tmp_path / "report.json"
    command("dress", "--words", "skirt skirt=half band=elastic", "--size", "W40", "--spacing", 30, "--report", report)
    done = json.loads(report.read_text())
    assert done["status"] == "settled" and done["seams_closed"] == done["seams"] and done["max_seam_gap_mm"] < 1
