"""Pictures of dressed bodies: what sewing leaves to see on a garment, and garments told apart by their colours."""
import json
import subprocess

import pytest

np = pytest.importorskip("numpy")

from places import BIN, ROOT  # noqa: E402
from test_render import picture  # noqa: E402

TAPE = ROOT / "examples" / "tapes" / "w40.tape"


def command(*arguments):
    done = subprocess.run([str(BIN / "muslin"), *map(str, arguments)], capture_output=True, timeout=120)
    if b"EGL" in done.stderr:
        pytest.skip(done.stderr.decode().strip())  # a machine without EGL
    assert done.returncode == 0, done.stderr.decode()


def shown(tmp_path, *arguments, pixels="600x800"):
    path = tmp_path / "picture.png"
    command("dress", "--tape", TAPE, "--spacing", 30, "--png", path, "--pixels", pixels, *arguments)
    return picture(path)


def drafted(tmp_path, design):
    path = tmp_path / "pattern.json"
    command("draft", "--design", design, "--tape", TAPE, "-o", path)
    return json.loads(path.read_text())


def runs(flags):
    """First and last index of each run of true values."""
    steps = np.diff(np.concatenate([[0], flags.astype(int), [0]]))
    return list(zip(np.flatnonzero(steps == 1), np.flatnonzero(steps == -1) - 1))


def test_a_front_has_its_buttons_one_below_the_other(tmp_path):
    pattern = drafted(tmp_path, "gilet")
    heights = {round(mark["points"][0][1], 3) for mark in pattern["marks"]
               if mark["name"] == "button" and pattern["panels"][mark["panel"]]["name"].startswith("front")}
    rows = shown(tmp_path, "--design", "gilet", "--colour", "#181818", "--view", "0,0")
    bright, middle = rows.min(axis=2), rows.shape[1] // 2
    cloth = (bright[:, middle - 25] < 90) & (bright[:, middle + 25] < 90)
    front = bright[cloth, middle - 4:middle + 5].max(axis=1)
    buttons = [run for run in runs(front > 120) if run[1] - run[0] < 8]  # longer: the skin above
    assert len(buttons) == len(heights) >= 4


def test_a_band_that_closes_shows_one_button(tmp_path):
    pattern = drafted(tmp_path, "jeans")
    assert {mark["name"] for mark in pattern["marks"]} >= {"button", "buttonhole"}
    rows = shown(tmp_path, "--design", "jeans", "--colour", "#181818", "--view", "0,0")
    bright, middle = rows.min(axis=2), rows.shape[1] // 2
    cloth = np.flatnonzero((bright[:, middle - 25] < 90) & (bright[:, middle + 25] < 90))
    band = bright[cloth[0] + 2:cloth[0] + 14, middle - 45:middle + 45].max(axis=0)
    assert len(runs(band > 120)) == 1


def test_a_hem_is_stitched_at_its_depth(tmp_path):
    pattern = drafted(tmp_path, "straight_skirt_knee")
    front = next(k for k, panel in enumerate(pattern["panels"]) if "front" in panel["name"])
    depth = next(edge["allowance"] for edge in pattern["edges"]
                 if edge.get("label") == "hem" and pattern["points"][edge["start"]]["panel"] == front)
    y = [point["at"][1] for point in pattern["points"] if point["panel"] == front]
    rows = shown(tmp_path, "--design", "straight_skirt_knee", "--colour", "#203060", "--view", "0,0,1", pixels="900x1800")
    column = rows[:, 430:440].mean(axis=1)
    cloth = max(runs(column[:, 2] - column[:, 0] > 20), key=lambda run: run[1] - run[0])
    pixel = (max(y) - min(y)) / (cloth[1] - cloth[0] + 1)  # metres, of a skirt that hangs straight down
    light = column.sum(axis=1)
    at = range(cloth[1] - int(2 * depth / pixel), cloth[1] - int(0.3 * depth / pixel))
    over = [light[i] - np.median(light[i - 8:i + 9]) for i in at]
    assert max(over) > 6
    assert (cloth[1] - at[int(np.argmax(over))]) * pixel == pytest.approx(depth, abs=0.006)


def test_garments_over_one_another_have_colours_of_their_own(tmp_path):
    rows = shown(tmp_path, "--design", "skirt", "--over", "gilet", "--colour", "#c02020", "--colour", "#20a020",
                 "--view", "0,0")
    red = (rows[:, :, 0] > 1.8 * rows[:, :, 1]).sum()
    green = (rows[:, :, 1] > 1.5 * rows[:, :, 0]).sum()
    assert red > 5000 and green > 3000
