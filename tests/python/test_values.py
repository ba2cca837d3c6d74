"""Tapes, patterns, bodies and cloths as values: texts with units, repr, equality, copies, pickles, pictures."""
import copy
import math
import pickle
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor

import pytest

import muslin

VALUES = {
    "tape": lambda: muslin.Tape.size("W40"),
    "complete tape": lambda: completed(muslin.Tape(sex="male", stature=1.8, bust=1.0, waist=0.9, hip=1.02)),
    "pattern": lambda: muslin.draft("tshirt", "W40"),
    "body": lambda: muslin.Body("W40", samples=24, stoop=0.01),
    "body in a pose": lambda: muslin.Body("W40", samples=24).posed(muslin.Pose("sit")),
    "body of limbs": lambda: muslin.Body.of_limbs([{"contour": [(0, 0, 0, 0.1, 0.1, 2), (0.5, 0, 0, 0.1, 0.1, 2)],
                                                       "pole": (-0.05, 0.55)}]),
    "cloth": lambda: muslin.Cloth(muslin.draft("skirt", "W40"), "denim", spacing=0.04),
    "grid": lambda: muslin.Cloth.grid(5, 6, (0.01, 0.01), muslin.Fabric("wool", friction=0.3)),
    "bare cloth": lambda: muslin.Cloth.bare([(0, 0, 0), (0, -1, 0)], [1, 1], [(0, 1, 1.0, 50.0)], pins=[0]),
    "fabric": lambda: muslin.Fabric("jersey", weight=0.2),
    "pose": lambda: muslin.Pose("sit"),
}


def completed(tape):
    tape.complete()
    return tape


@pytest.mark.parametrize("name", VALUES)
def test_values_are_equal_to_their_copies_and_pickles(name):
    one = VALUES[name]()
    for other in (pickle.loads(pickle.dumps(one)), copy.deepcopy(one), copy.copy(one), VALUES[name]()):
        assert other == one and repr(other) == repr(one) and other is not one
        if hasattr(one, "to_bytes"):
            assert other.to_bytes() == one.to_bytes()
    assert one != VALUES["pose" if name != "pose" else "fabric"]()


def test_a_pickle_of_a_scan_is_the_same_body():
    body = muslin.Body("W40", samples=32, ring_spacing=0.02)
    made, _ = muslin.scan(body.vertices, body.triangles, samples=24)
    again = pickle.loads(pickle.dumps(made))
    assert again == made and bytes(again.vertices) == bytes(made.vertices)


def test_a_change_makes_values_unequal():
    tape, pattern = muslin.Tape.size("W40"), muslin.draft("skirt", "W40")
    other, wider = copy.copy(tape), pattern.copy()
    other["bust"] = "96 cm"
    wider.move_point(0, *[x + 0.01 for x in wider.point(0)[1:]])
    assert other != tape and wider != pattern
    assert muslin.Cloth(pattern, spacing=0.05) != muslin.Cloth(pattern, spacing=0.06)


def state(pattern, body):
    return muslin.dress(pattern, body, spacing=0.05).drape.state_hash


def test_another_process_drapes_a_pickle_to_the_same_state():
    pattern, body = muslin.draft("skirt", "W40"), muslin.Body("W40", samples=24)
    with ProcessPoolExecutor(1) as pool:
        assert pool.submit(state, pattern, body).result() == state(pattern, body)


def test_drapes_and_cloths_of_dress_say_that_they_cannot_be_pickled():
    worn = muslin.dress("skirt", "W40", spacing=0.05)
    for one in (worn.drape, worn.cloth, worn.fit()):
        with pytest.raises(TypeError, match="cannot be copied or pickled"):
            pickle.dumps(one)
    assert worn.cloth == worn.cloth and worn.cloth != muslin.Cloth(worn.pattern, spacing=0.05)


def test_a_measure_is_a_text_with_its_unit():
    tape = muslin.Tape.size("W40")
    tape["bust"], tape["high_bust"] = "96 cm", "35 in"
    assert tape["bust"] == 0.96 and tape["high_bust"] == pytest.approx(35 * 0.0254)
    assert muslin.Tape(shoulder_slope="22 deg")["shoulder_slope"] == pytest.approx(math.radians(22))
    for wrong in ("96", "96 miles", "wide"):
        with pytest.raises(muslin.MuslinError):
            tape["bust"] = wrong
    assert tape["bust"] == 0.96


def test_a_wearer_is_a_size_a_path_or_a_tape(root):
    path = root / "examples/tapes/w40.tape"
    tape = muslin.Tape.read(path)
    for wearer in (tape, path, str(path)):
        assert muslin.Body(wearer, samples=24).asked["bust"] == tape["bust"]
    assert muslin.Tape.of("W40") == muslin.Tape.size("W40")
    with pytest.raises(muslin.MuslinError, match="no_such.tape"):
        muslin.Body("no_such.tape")


def test_repr_says_what_it_is_and_whether_it_is_closed():
    tape = muslin.Tape.size("W40")
    assert repr(tape).startswith("<Tape: 'W40', female, stature 168 cm, bust 92 cm")
    assert repr(muslin.draft("tshirt", tape)).startswith("<Pattern: 'tshirt', 4 panels")
    tape.close()
    assert repr(tape) == "<Tape: closed>"


def test_a_body_is_made_again_with_other_options():
    body = muslin.Body("W40").posed(muslin.Pose("sit"))
    coarse = body.remade(samples=24, ring_spacing=0.03)
    assert coarse.stance == body.stance and 0 < len(coarse.vertices) < len(body.vertices) / 4


def test_a_garment_shows_itself(tmp_path):
    numpy = pytest.importorskip("numpy")  # pictures are drawn by it
    tape = muslin.Tape.size("W40")
    coarse = muslin.Body(tape, samples=24, ring_spacing=0.03)
    worn = muslin.dress(muslin.draft("skirt", tape), coarse, spacing=0.05)
    picture = worn.picture(60, 90, yaw=0)
    assert picture.shape == (90, 60, 3) and picture.dtype == numpy.uint8
    assert len({tuple(colour) for colour in picture.reshape(-1, 3)}) > 100
    blue = picture[:, :, 2].astype(int) - picture[:, :, 0]
    rows, columns = numpy.nonzero(blue > 20)  # the skirt: in the middle, from the waist to the knees
    assert 25 < columns.mean() < 35 and 30 < rows.min() < 45 and 55 < rows.max() < 75
    assert worn._repr_png_().startswith(b"\x89PNG\r\n\x1a\n")
    page = worn.view()._repr_html_()
    assert "model-viewer" in page and "data:model/gltf-binary;base64," in page
    assert worn.pattern._repr_svg_().startswith("<")


def test_it_serves_without_numpy(root):
    program = """
import sys
sys.modules["numpy"] = sys.modules["tqdm"] = None
import muslin
worn = muslin.dress("skirt", "W40", spacing=0.05, progress=True)
positions, triangles = worn.drape.positions, worn.cloth.triangles
mesh = muslin.Mesh("skirt", positions, triangles, worn.drape.normals)
worn.drape.set_state(positions, worn.drape.velocities)
assert worn._repr_png_() is None and "model-viewer" in worn.view().page()
print(worn.drape.state_hash, type(positions).__name__)
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                          env={"PYTHONPATH": str(root / "bindings/python")})
    assert done.stderr == "" and done.stdout.split() == [state_of_skirt(), "memoryview"]


def state_of_skirt():
    return muslin.dress("skirt", "W40", spacing=0.05).drape.state_hash
