"""The static solver of the report, on scenes small enough for every check."""
import pathlib
import sys

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("scipy")
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import muslin  # noqa: E402  (measure.py says where it lies, conftest.py does so here)
import newton  # noqa: E402
import scene_hang  # noqa: E402


def test_a_hanging_sheet_has_one_shape_from_two_starts():
    sheet = scene_hang.Sheet(9)
    drape = sheet.level()
    drape.settle()
    places, how = sheet.newton(drape.positions)
    other, _ = sheet.newton(sheet.straight_down())
    assert how["status"] == "ok" and how["value"] < 1e-6
    assert min(np.abs(other - image).max() for image in (places, *scene_hang.images(places))) < 1e-7
    left, carried = sheet.balance(places)
    assert left < 1e-6 and abs(carried - 1) < 1e-9
    assert abs(drape.report["max_strain"] / sheet.strain(places) - 1) < 0.01


def test_the_stiffness_is_the_derivative_of_the_forces_across_seams_too():
    tape = muslin.Tape.size("W40")
    cloth = muslin.Cloth(muslin.draft("tshirt", tape), muslin.Fabric(), spacing=0.05)
    drape = muslin.Drape(cloth, muslin.Body(tape), precision=64)
    drape.place()
    drape.sew()
    statics = newton.Statics(drape, cloth)
    x = np.array(drape.positions)[statics.first]
    way = np.random.default_rng(0).normal(size=x.shape)
    exact = (statics.force(x - 1e-7 * way) - statics.force(x + 1e-7 * way)) / 2e-7
    assert np.abs((statics.stiffness(x) @ way.reshape(-1)).reshape(x.shape) - exact).max() < 1e-6 * np.abs(exact).max()


def test_a_straight_sheet_that_is_pushed_together_is_no_minimum():
    cloth = muslin.Cloth.grid(2, 9, (0.01, 0.01), muslin.Fabric("silk"))
    drape = muslin.Drape(cloth, precision=64, gravity=(0.0, 0.0, 0.0))
    places = np.array(drape.positions) * [0.9, 1.0, 1.0]
    statics = newton.Statics(drape, cloth, pins=(0, 8, 9, 17))
    statics.descend(places[statics.first], most=1)
    assert statics.softest < 0.0
