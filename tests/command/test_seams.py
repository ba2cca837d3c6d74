"""muslin seams: a half skirt and a sleeve drawn without words are completed, sewn and dressed."""
import json

import pytest

PLACE = {"origin": [0, 0, 0], "rotation": [1, 0, 0, 0, 1, 0, 0, 0, 1], "bend": 0, "bend_x": 0}


def drawing(folder):
    """Front and back of a skirt as halves, one sleeve: three quadrilaterals [m], no seams."""
    shapes = {"piece_1": [(0, 0), (0.34, 0), (0.2, 0.5), (0, 0.5)],
              "piece_2": [(0.4, 0), (0.74, 0), (0.6, 0.5), (0.4, 0.5)],
              "piece_3": [(0.9, 0), (1.15, 0), (1.19, 0.4), (0.86, 0.4)]}
    panels, points, edges = [], [], []
    for number, (name, corners) in enumerate(shapes.items()):
        first = len(points)
        points += [{"panel": number, "at": list(corner)} for corner in corners]
        edges += [{"start": first + i, "end": first + (i + 1) % 4, "pieces": [{"kind": "line"}]} for i in range(4)]
        panels.append({"name": name, "label": "", "grain": [0, 1], "cut": 1, "placement": PLACE,
                       "outline": [[first + i, 1] for i in range(4)]})
    path = folder / "drawing.json"
    path.write_text(json.dumps({"muslin_pattern": 1, "unit": "m", "name": "drawing", "panels": panels, "points": points,
                                "edges": edges, "seams": [], "notches": [], "marks": []}))
    return str(path)


def panels_of(path):
    pattern = json.loads(path.read_text())
    return {panel["name"]: panel for panel in pattern["panels"]}, pattern


def test_halves_are_unfolded_and_sewn(command, tmp_path):
    out = tmp_path / "skirt.json"
    command("seams", drawing(tmp_path), "--piece", "piece_1=skirt_front fold", "--piece", "piece_2=skirt_back fold:7",
            "--piece", "piece_3 leave", "-o", out)
    panels, pattern = panels_of(out)
    assert list(panels) == ["skirt_front", "skirt_back"]
    assert len(pattern["seams"]) == 2
    command("dress", "--pattern", out, "--size", "W40", "--place", "found", "--spacing", "40", "--json")


def test_a_pair_gets_its_image_and_its_part(command, tmp_path):
    out = tmp_path / "sleeves.json"
    command("seams", drawing(tmp_path), "--piece", "piece_3=sleeve_left pair arm", "--split", "10:100,200", "-o", out)
    panels, pattern = panels_of(out)
    assert set(panels) == {"piece_1", "piece_2", "sleeve_left", "sleeve_right"}
    assert panels["sleeve_right"]["label"] == panels["sleeve_left"]["label"] == "arm"
    # the edge of 330 mm is in three parts, on both
    assert len(panels["sleeve_left"]["outline"]) == len(panels["sleeve_right"]["outline"]) == 6


@pytest.mark.parametrize("words, told", [
    (["--piece", "piece_9 leave"], ["--piece piece_9 leave", "no panel of this name"]),
    (["--piece", "piece_1 fold pair"], ["one of them"]),
    (["--piece", "piece_1 fold:7"], ["fold:"]),
    (["--piece", "piece_1=piece_2"], ["piece_2"]),
    (["--piece", ""], ["no panel"]),
    (["--split", "77:5"], ["no edge of this number"]),
    (["--split", "1"], ["EDGE:MM"]),
    (["--split", "1:x"], ["EDGE:MM"]),
    (["--split", "1:200,100"], ["ascending"]),
    (["--split", "1:9000"], ["outside"]),
])
def test_what_is_wrong_is_said_in_one_line(command, one_line, tmp_path, words, told):
    text = one_line(command("seams", drawing(tmp_path), *words, code=2))
    assert all(word in text for word in told), text
