"""test_edit.py: edits of a pattern from Python: each method reaches its call, and undo gives every byte back."""
import math

import pytest

import muslin


@pytest.fixture
def pattern():
    tape = muslin.Tape.size("W40")
    return muslin.draft("bodice", tape)


def written(pattern, tmp_path):
    path = tmp_path / "pattern.json"
    pattern.write(path)
    return path.read_bytes()


def test_darts_move_and_come_back(pattern, tmp_path):
    before = written(pattern, tmp_path)
    pattern.keep_history()

    def edge(name, panel="front_left"):
        return pattern.edge(pattern.panel(panel), name)

    angle, _, _ = pattern.dart(edge("bd1"))
    leg = pattern.rotate_dart(edge("bd1"), edge("sh"), 0.05, edge("cf"))
    assert pattern.dart(leg)[0] == pytest.approx(angle, abs=1e-12)
    neck = edge("neck")
    legs = pattern.split_dart(leg, [(neck, 0.03, 0.5), (neck, 0.06, 0.5)], edge("cf"))
    assert sum(pattern.dart(leg)[0] for leg in legs) == pytest.approx(angle, abs=1e-12)
    leg = pattern.merge_darts(legs[0], legs[1], edge("cf"))
    pattern.shorten_dart(leg, 0.02)
    assert pattern.edge_name(pattern.release_dart(leg)) == "neck"
    assert pattern.history == (5, 0)
    for _ in range(5):
        pattern.undo()
    assert written(pattern, tmp_path) == before
    pattern.redo()
    assert pattern.history == (1, 4)


def test_panels_are_cut_filled_out_and_faced(pattern):
    def edge(name, panel="back_left"):
        return pattern.edge(pattern.panel(panel), name)

    area = pattern.area(pattern.panel("back_left"))
    panel, seam = pattern.separate(edge("cb"), 0.2, edge("arm"), 0.1, "yoke", "yoke_seam")
    assert pattern.area(panel) + pattern.area(pattern.panel("back_left")) == pytest.approx(area, abs=1e-12)
    assert pattern.join_panels(seam) == pattern.panel("back_left") or pattern.panel("yoke") is not None
    image = pattern.mirror_panel(pattern.panel("front_left"), "image")
    pattern.remove_panel(image)
    facing = pattern.add_facing(edge("neck", "front_left"), 0.05, "facing")
    assert pattern.panels[facing] == "facing"

    side = edge("side1", "front_left")
    walk = pattern.walk_seam(pattern.get("edge_seam", side))
    assert abs(walk["excess"]) < 1e-3 and 0.0 < walk["corner_start"] < 2.0 * math.pi
    pattern.lengthen(pattern.panel("front_left"), (0.0, 0.05), (1.0, 0.0), 0.02)
    seam = pattern.get("edge_seam", edge("side1", "front_left"))
    pattern.move_point(pattern.edge_ends(edge("side1", "front_left"))[0], 0.2, -0.03)
    pattern.true_seam(seam, edge("side1", "front_left"), at_end=False)
    assert abs(pattern.walk_seam(seam)["excess"]) < 1e-9
    notches = len(pattern.notches())
    pattern.notch_seam(edge("side1", "front_left"), 0.05, kind=2)
    assert len(pattern.notches()) == notches + 2
    pattern.remove_seam(seam)
    part = pattern.split_edge(edge("neck", "front_right"), 0.03, "neck_part")
    assert pattern.edge_name(part) == "neck_part"
    pattern.redraw_edge(part, ["quadratic"], [(0.05, 0.4)])
    pattern.move_control(part, 1, 0.06, 0.41)
    pattern.fair_edge(part)


def test_a_refused_edit_changes_nothing(pattern, tmp_path):
    before = written(pattern, tmp_path)
    edge = pattern.edge(pattern.panel("front_left"), "sh")
    with pytest.raises(muslin.MuslinError, match="no leg of a dart"):
        pattern.dart(edge)
    with pytest.raises(muslin.MuslinError, match="not the leg of a dart"):
        pattern.rotate_dart(edge, edge, 0.05, edge)
    with pytest.raises(muslin.MuslinError, match="0 edits to undo"):
        pattern.undo()
    for call in (lambda: pattern.add_dart(edge, 0.05, 9.0, (0.1, 0.2)), lambda: pattern.spread(edge, 9, edge, 0, 1, 1),
                 lambda: pattern.pleat(edge, 0.1, edge, 0.05, 0.01, 0.01), lambda: pattern.flare(edge, edge, 3, 0.1),
                 lambda: pattern.unfold(pattern.edge(pattern.panel("front_left"), "neck")),
                 lambda: pattern.dart_to_seam(edge, edge, 0.1, "a", "b"), lambda: pattern.merge_edges(edge)):
        with pytest.raises(muslin.MuslinError):
            call()
    assert written(pattern, tmp_path) == before


def test_patches_pleats_and_closures(pattern):
    front = pattern.panel("front_left")
    rim = pattern.rim(front)
    assert rim == pattern.outline(front)
    patch = pattern.add_patch(front, "pocket", [(0.03, 0.2), (0.03, 0.16), (0.07, 0.16), (0.07, 0.2)])
    assert pattern.panel("pocket") == patch
    assert len(pattern.rim(front)) == len(rim)
    assert len(pattern.outline(front)) == len(rim) + 8
    seams = pattern.seam_count
    pattern.lay_pleats(pattern.edge(patch, "mouth"), [0.02], [0.01])
    assert pattern.seam_count == seams + 2
    assert pattern.open_closures() == 0
