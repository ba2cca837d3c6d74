"""A contact sheet: tiles in their places, the list of what became of them, refusals."""
import struct


def size_of(png):
    data = png.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", data[16:24])


def test_two_designs_on_two_bodies(command, tmp_path):
    png = tmp_path / "sheet.png"
    done = command("sheet", "--designs", "skirt,top neck=v shape=boxy cloth=knit", "--tapes", "W40,M50", "--png", png,
                   "--spacing", 40, "--tile", "48x60", "--columns", 3, code=None)
    lines = done.stdout.decode().splitlines()
    assert size_of(png) == (3 * 48, 2 * 60)
    assert lines[0].startswith("row 1 column 1: skirt on W40:")
    assert lines[2].startswith("row 1 column 3: top neck=v shape=boxy cloth=knit on W40: settled")
    assert lines[3].startswith("row 2 column 1: top neck=v shape=boxy cloth=knit on M50:")
    settled = sum(": settled" in line for line in lines[:4])
    assert lines[4] == f"{settled} of 4 settled" and done.returncode == (0 if settled == 4 else 1)


def test_the_picture_is_the_same_for_any_number_of_processes(command, tmp_path):
    made = []
    for jobs in (1, 2):
        png = tmp_path / f"{jobs}.png"
        command("sheet", "--designs", "sleeveless,tshirt", "--tapes", "W40", "--png", png, "--spacing", 40, "--tile",
                "32x40", "--jobs", jobs, code=None)
        made.append(png.read_bytes())
    assert made[0] == made[1]


def test_lists_that_cannot_be_are_refused(command, tmp_path):
    png = tmp_path / "sheet.png"
    for designs, tapes, words in (("ballgown_of_1870", "W40", "near: ball_gown"), (",", "W40", "empty"),
                                  ("all:0", "W40", "all:1"), ("tshirt", ",", "empty"), ("all", "W41", "W41")):
        done = command("sheet", "--designs", designs, "--tapes", tapes, "--png", png, code=2)
        assert words in done.stderr.decode()
