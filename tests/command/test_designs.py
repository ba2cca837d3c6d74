"""muslin designs: searched, shown, drawn; unknown names; the phrases of tests/design."""
import json
import subprocess
import sys

import pytest


def names(done):
    return [row["name"] for row in json.loads(done.stdout)]


def test_words_search_and_the_best_comes_first(command):
    assert command("designs", "pencil", "skirt").stdout.split()[0] == b"pencil_skirt_knee"
    rows = json.loads(command("designs", "pencil skirt", "--json", "--most", 3).stdout)
    assert len(rows) == 3 and all(row["name"].startswith("pencil_skirt") for row in rows)
    assert 1 >= rows[0]["score"] >= rows[1]["score"] > 0
    assert all("length=midi" in row["words"] for row in
               json.loads(command("designs", "skirt", "length=midi", "--json").stdout))
    assert b"no design is like" in command("designs", "xyzzy", code=1).stderr
    assert b"knee mini midi" in command("designs", "length=foo", code=2).stderr


@pytest.mark.parametrize("name, near", [("pencil-skirt", "pencil_skirt_knee"), ("jaens", "jeans"), ("pants", "trousers")])
def test_an_unknown_name_is_answered_with_near_ones(command, name, near):
    for arguments in (("draft", "--design", name, "--size", "W40", "-o", "-"), ("designs", "--show", name)):
        said = command(*arguments, code=2).stderr.decode()
        assert f'no design is called "{name}"; near: ' in said and near in said


def test_an_unknown_command_is_answered_with_a_near_one(command):
    assert b"did you mean dress?" in command("dres", code=2).stderr
    assert b"did you mean" not in command("xyzzy", code=2).stderr


def test_show_tells_axes_ease_pieces_and_cloth(command):
    told = json.loads(command("designs", "--show", "pencil_skirt_knee", "--size", "W44", "--json").stdout)
    assert told["axes"]["skirt"] == "pencil" and told["axes"]["length"] == "knee" and "sleeve" not in told["axes"]
    assert told["tape"] == "W44" and 0.02 < told["ease_m"]["hip"] < 0.06 and told["ease_m"]["bust"] is None
    assert sum(piece["copies"] for piece in told["pieces"]) >= 5
    boxes = sum(piece["copies"] * piece["width_m"] * piece["height_m"] for piece in told["pieces"])
    assert told["area_m2"] < boxes < told["cloth_width_m"] * told["cloth_length_m"] < 3 * boxes
    said = command("designs", "--show", "pencil_skirt_knee").stdout.decode()
    assert "length=knee" in said and "W40" in said and "of cloth 1.40 m wide" in said


def test_a_picture_has_a_tile_for_each(command, tmp_path):
    command("designs", "kids dress", "--png", tmp_path / "sheet.png", "--most", 3)
    head = (tmp_path / "sheet.png").read_bytes()[:24]
    assert head[:4] == b"\x89PNG" and int.from_bytes(head[16:20], "big") % 240 == 0
    assert b"at most 200" in command("designs", "--png", tmp_path / "all.png", "--most", 700, code=2).stderr


def test_words_are_read_as_they_are_spoken(command):
    patterns = [json.loads(command("draft", "--words", words, "--size", "W40", "-o", "-").stdout)
                for words in ("pencil skirt knee", "skirt skirt=pencil")]
    assert patterns[0] == patterns[1]


def test_phrases_of_people_find_their_design(root):
    lists = [root / "tests/design" / name for name in ("phrases.txt", "phrases_held_out.txt")]
    done = subprocess.run([sys.executable, root / "tests/design/phrases.py", *lists], capture_output=True, text=True,
                          timeout=60)
    assert done.returncode == 0, done.stdout
