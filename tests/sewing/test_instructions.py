"""The sheet of instructions from outside: the command's text beside the pattern's own JSON. Each seam stands in it
once, and the steps do not depend on the order in which the pattern lists its panels, edges and seams."""
import collections
import json
import random
import re
import subprocess

import pytest

from places import BIN

MUSLIN = BIN / "muslin"
EVERY = 48  # of the designs, each EVERY-th is looked at


def run(*arguments):
    done = subprocess.run([MUSLIN, *arguments], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def designs():
    return [line.split()[0] for line in run("designs").splitlines()][::EVERY] + ["jeans", "oxford_shirt", "coat"]


def draft(name, folder):
    for size in ("W40", "M50", "C116"):
        done = subprocess.run([MUSLIN, "draft", "--design", name, "--size", size, "-o", folder / "pattern.json"],
                              capture_output=True, text=True)
        if done.returncode == 0:
            return json.loads((folder / "pattern.json").read_text())
    raise AssertionError(f"{name} is drafted in no size: {done.stderr}")


def instructions(pattern, folder):
    (folder / "asked.json").write_text(json.dumps(pattern))
    return run("print", "--pattern", folder / "asked.json", "--instructions", "-")


def shuffled(pattern, seed):
    """The same pattern with its cells in another order."""
    draw = random.Random(seed)
    new = {}
    for kind in ("panels", "points", "edges"):
        order = list(range(len(pattern[kind])))
        draw.shuffle(order)
        new[kind] = {old: place for place, old in enumerate(order)}
    panel, point, edge = new["panels"], new["points"], new["edges"]

    def placed(kind, cells):
        return [cells[old] for old in sorted(new[kind], key=new[kind].get)]

    panels = [{**p, "outline": [[edge[e], way] for e, way in p["outline"]],
               **({"mirror_of": panel[p["mirror_of"]]} if "mirror_of" in p else {})} for p in pattern["panels"]]
    points = [{**p, "panel": panel[p["panel"]]} for p in pattern["points"]]
    edges = [{**e, "start": point[e["start"]], "end": point[e["end"]]} for e in pattern["edges"]]
    seams = [{**s, "a": edge[s["a"]], "b": edge[s["b"]]} for s in pattern["seams"]]
    draw.shuffle(seams)
    return {**pattern, "panels": placed("panels", panels), "points": placed("points", points),
            "edges": placed("edges", edges), "seams": seams,
            "notches": [{**n, "edge": edge[n["edge"]]} for n in pattern["notches"]],
            "marks": [{**m, "panel": panel[m["panel"]]} for m in pattern["marks"]]}


@pytest.mark.parametrize("name", designs())
def test_the_steps_do_not_depend_on_the_order_of_the_cells(name, tmp_path):
    pattern = draft(name, tmp_path)
    steps = instructions(pattern, tmp_path).split("\nSewing", 1)[1]
    for seed in range(3):
        assert instructions(shuffled(pattern, seed), tmp_path).split("\nSewing", 1)[1] == steps


def words(name):
    """A panel's name as the text has it, without left and right."""
    return " ".join(word for word in re.findall(r"[^\W_]+", name) if word not in ("left", "right"))


@pytest.mark.parametrize("name", designs())
def test_each_seam_has_its_line(name, tmp_path):
    pattern = draft(name, tmp_path)
    owner = {edge: words(panel["name"]) for panel in pattern["panels"] for edge, _ in panel["outline"]}
    wanted = collections.Counter()
    for seam in pattern["seams"]:
        wanted[frozenset((owner[seam["a"]], owner[seam["b"]]))] += 1
    told = collections.Counter()
    for line in re.findall(r"^   - (.*)", instructions(pattern, tmp_path), re.M):
        line = line.removeprefix("set in the zip: ")
        if re.fullmatch(r"[^,:]+, \d+ buttons?", line):  # of a stand, which no seam closes
            continue
        head = re.split(r", \d|: \d+ (?:dart|pleat)", line)[0]
        sides = re.split(r" (?:to|onto) ", head) if " to " in head or " onto " in head else [head]
        if re.match(r"[^()]*: ", head):  # a panel with itself
            sides = [head.split(":")[0]]
        sides = [words(re.sub(r" \([^)]*\)| at the .*", "", side)) for side in sides]
        dart = re.search(r": (\d+) (?:dart|pleat)", line)
        told[frozenset(sides)] += (int(dart.group(1)) if dart else 1) * (2 if line.endswith("alike") else 1)
    assert set(told) == set(wanted)
    for pair, count in told.items():  # parts of one seam between darts share a line
        assert count <= wanted[pair], sorted(pair)


def test_what_laps_is_told_and_its_buttons_are_counted(tmp_path):
    jeans = instructions(draft("jeans", tmp_path), tmp_path)
    assert "The underlap of band front right reaches 35 mm beyond" in jeans and "- 1 button\n" in jeans
    assert jeans.count("a zip for an opening of 17.9 cm") == 1
    shirt = instructions(draft("oxford_shirt", tmp_path), tmp_path)
    assert "The underlap of cuff reaches 25 mm beyond" in shirt
    # 45 mm beyond the centre, folded 17.5 mm from it
    assert 'Fold 27.5 mm at the centre to the wrong side, along the line "fold", and press: front.' in shirt
    assert 'Fuse the button stand to the wrong side of: front, the lines "fold" on each other.' in shirt
    assert "button stand" not in re.search(r"Fuse the interfacing to: (.*)\.", shirt)[1]
    front = int(re.search(r"at the centre, .*?, (\d+) buttons", shirt)[1])
    assert f"- {front + 3} buttons\n" in shirt  # both cuffs, and the stand of the collar
    leaf = re.search(r"Sew the layers of (.*?) to each other.* along: (.*)\. Turn", shirt)
    assert leaf[1] == "collar leaf, under collar leaf" and leaf[2] == "end, top"
    assert "under collar leaf" in shirt.split("\nSewing")[0]
    # the stand holds the leaf and the neck, so its second layer comes last; a cuff that opens is set on a closed sleeve
    order = [shirt.index(text) for text in ("Sew the layers of collar leaf", "collar leaf (bottom) to collar (top)",
                                            "sleeve: under back to under front", "cuff (top) to sleeve (cuff)",
                                            "Second layer of collar:", "Second layers: back yoke.")]
    assert order == sorted(order) and "from one edge of the slit to the other" in shirt


def test_zips_and_openings_of_pockets_are_told(tmp_path):
    dress = instructions(draft("collar_dress_short", tmp_path), tmp_path)
    assert dress.count("a zip for an opening of ") == 1 and dress.count("set in the zip: ") == 2
    hoodie = instructions(draft("hoodie", tmp_path), tmp_path)
    assert "Hem the openings of the kangaroo pocket" in hoodie and "stretch the front rib from " in hoodie


def test_bands_are_sewn_on_when_what_they_go_round_is_closed(tmp_path):
    """Jeans: the sides of band, yoke and legs and the zip before the band, which is one line; a rib is one with its body."""
    jeans = instructions(draft("jeans", tmp_path), tmp_path)
    order = [jeans.index(text) for text in ("back yoke left to back yoke right", "back yoke to leg back at the yoke",
                                            "back yoke to leg front at the side", "back yoke to band back at the band")]
    assert order == sorted(order)
    assert max(jeans.index("band back to band front at the side"), jeans.index("set in the zip: ")) < order[-1]
    hoodie = instructions(draft("hoodie", tmp_path), tmp_path)
    step = re.search(r"\d+\. .* in one go:\n((?:   - .*\n)*   - back rib to front rib.*\n(?:   - .*\n)*)", hoodie)[1]
    assert "back to front at the side" in step and "sleeve: under back to under front" in step
    assert hoodie.count("first fold it along its line, wrong sides together, and sew both its edges on") == 3
    assert hoodie.index("at the crown") < hoodie.index("Sew the layers of hood") < hoodie.index("to hood at the neck")


def test_edges_of_one_name_are_turned_as_deep_as_they_are_cut(tmp_path):
    skirt = instructions(draft("pencil_skirt_knee", tmp_path), tmp_path)
    assert "Finish the slit of skirt back, 36.0 cm in all: turn 10 mm" in skirt
    assert "Finish the hem of skirt back, skirt front, 95.2 cm in all: turn 40 mm" in skirt
    trousers = instructions(draft("pyjama_trousers", tmp_path), tmp_path)
    assert '2.5 cm wide' in trousers and 'fold along the line "fold" to the inside' in trousers


def test_a_wrap_is_told_with_its_slot_and_ties(tmp_path):
    dress = instructions(draft("wrap_dress", tmp_path), tmp_path)
    assert dress.count("in the left one leave the slot open, from the waist") == 1 and "zip" not in dress
    assert "turn and press: tie long, tie short.\n" in dress
    assert re.search(r"Sew the short tie to the end of the left front.*:\n   - front: tie to side, 3\.0 cm", dress)
    assert "the lap, 24.0 cm" in dress and "- tie long: cut 1\n- tie short: cut 1\n" in dress


def test_bands_that_give_are_stretched_to_the_edge_that_they_are_sewn_to(tmp_path):
    """A casing of a knit and a rib, with both lengths; a woven casing does not give: what is longer is gathered."""
    leggings = instructions(draft("leggings", tmp_path), tmp_path)
    for part, length, edge in re.findall(r"stretch the band (front|back) from (\d+\.\d) cm to (\d+\.\d) cm", leggings):
        assert f"band {part} to leg {part} at the band, {edge} cm" in leggings and float(length) < float(edge)
    assert leggings.count("stretch the band") == 2 and "gather" not in leggings
    assert re.search("stretch the cuff from .* cm to .* cm", instructions(draft("sweatshirt", tmp_path), tmp_path))
    woven = instructions(draft("gathered_skirt_elastic_mini", tmp_path), tmp_path)
    assert "gather the skirt front" in woven and "stretch the band" not in woven


def test_what_is_asked_wrongly_has_a_sentence(tmp_path):
    done = subprocess.run([MUSLIN, "print", "--design", "tshirt", "--size", "W40", "--instructions",
                           tmp_path / "no" / "t.txt"], capture_output=True, text=True)
    assert done.returncode != 0 and "t.txt" in done.stderr
    assert run("print", "--design", "tshirt", "--size", "W40", "--instructions", "-").startswith("T-shirt\n")


@pytest.mark.parametrize("name", ["tshirt", "pencil_skirt_knee", "coat"])
def test_the_metres_of_cloth_are_those_of_a_layout(name, tmp_path):
    """Each material has a line; the metres of a width are those of a thorough search on folded cloth, within 12 % and
    the 5 cm that they are rounded up to, and never too few."""
    text = run("print", "--design", name, "--size", "W40", "--instructions", "-")
    lines = re.search(r"^Cloth\n((?:- .*\n)+)", text, re.M)[1].splitlines()
    told = {line[2:line.index(",")]: dict(re.findall(r"(\d\.\d\d) m wide: (\d+\.\d\d) m", line)) for line in lines}
    names = {"main": "main cloth"}
    laid = {}
    for width in ("1.14", "1.40"):
        done = subprocess.run([MUSLIN, "layout", "--design", name, "--size", "W40", "--fold", "--json", "--width",
                               str(round(1000 * float(width)))], capture_output=True, text=True)
        for row in json.loads(done.stdout)["materials"] if done.returncode == 0 else []:
            laid[names.get(row["material"], row["material"]), width] = row["length_m"]
    assert {material for material, _ in laid} == set(told) and len(laid) >= len(told)
    for (material, width), length in laid.items():
        metres = float(told[material][width])
        assert length - 1e-9 <= metres <= 1.12 * length + 0.05, (material, width, length, metres)
