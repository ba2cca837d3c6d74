"""A mesh for a body: what is told of it, how it is refused, and garments on it."""
import json
import math

import pytest

NAMES = ["bust", "waist", "hip", "thigh", "wrist"]
PARTS = ["torso", "head", "arms", "hands", "legs", "feet"]


@pytest.fixture(scope="session")
def person(command, tape, tmp_path_factory):
    """The OBJ of a body of ours."""
    path = tmp_path_factory.mktemp("mesh") / "w40.obj"
    command("body", "--tape", tape, "--obj", path)
    return path


def test_a_mesh_is_told_as_a_table_and_as_json(command, person, tmp_path):
    said = command("body", "--mesh", person, "--obj", tmp_path / "scan.obj").stdout.decode()
    assert "height 168.00 cm, one unit of the mesh is 1 m" in said and "waist" in said and "torso" in said
    assert (tmp_path / "scan.obj").read_text().startswith("# muslin")
    told = json.loads(command("body", "--mesh", person, "--json").stdout)
    assert list(told["girths"]) == NAMES and list(told["distances_m"]) == PARTS
    assert all(math.isfinite(girth["tape_m"]) for girth in told["girths"].values())
    assert abs(told["stature_m"] - 1.68) < 1e-3 and told["unit_m"] == 1 and told["contours"] > 300
    assert all(told["distances_m"][part]["body_to_mesh"][0] < 1e-3 for part in PARTS)
    assert 0.060 < told["volume_m3"] < 0.070


def test_a_mesh_sits_down(command, person, tmp_path):
    heights = []
    for pose in ([], ["--pose", "sit"]):
        command("body", "--mesh", person, *pose, "--obj", tmp_path / "posed.obj")
        rows = [line.split() for line in (tmp_path / "posed.obj").read_text().splitlines() if line.startswith("v ")]
        heights.append(max(float(row[2]) for row in rows) - min(float(row[2]) for row in rows))
    assert 0.7 * heights[0] < heights[1] < 0.85 * heights[0]


def test_what_cannot_be_read_is_one_line(command, one_line, person, tmp_path):
    (tmp_path / "empty.obj").write_text("v 0 0 0\n")
    cases = [(("--mesh", tmp_path / "none.obj"), "none.obj"), (("--mesh", tmp_path / "empty.obj"), "no face"),
             (("--mesh", person, "--up", "w"), "--up w"), (("--mesh", person, "--front", "up"), "--front up"),
             (("--mesh", person, "--up", "x", "--front", "-x"), "one axis"), (("--mesh", person, "--unit", "0"), "--unit"),
             (("--mesh", person, "--unit", "1000"), "is unit 1000 right?"), (("--mesh", person, "--pose", "sleep"), "sleep")]
    for arguments, word in cases:
        said = one_line(command("body", *arguments, code=2))
        assert word in said, said


def test_a_tshirt_settles_on_a_mesh(command, person, tape, tmp_path):
    report = tmp_path / "report.json"
    command("dress", "--design", "tshirt", "--tape", tape, "--mesh", person, "--spacing", 30, "--report", report)
    told = json.loads(report.read_text())
    assert told["status"] == "settled" and told["seams_closed"] == told["seams"]
    assert told["max_penetration_mm"] < 2


def test_a_garment_of_garmentcode_settles_on_its_own_body(command, data, tmp_path):
    spec = data("garmentcode/specs/d11_012_mean_female_specification.json")
    mesh = data("garmentcode/bodies/mean_female.obj")
    report = tmp_path / "report.json"
    done = command("dress", "--pattern", spec, "--mesh", mesh, "--spacing", 30, "--report", report, code=None)
    assert done.returncode in (0, 1)
    told = json.loads(report.read_text())
    assert told["panels"] > 0 and told["max_penetration_mm"] < 2
