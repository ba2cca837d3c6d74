"""The same scene by the package and by the command: the same state, bit for bit, for any number of threads."""
import json

import pytest

import muslin

SPACING_MM = 20
SPACING = 0.001 * SPACING_MM


@pytest.fixture(scope="module")
def scene(root, tmp_path_factory, command):
    """(pattern file, tape file, the command's report) of a draped skirt."""
    folder = tmp_path_factory.mktemp("scene")
    tape, pattern, report = root / "examples/tapes/w40.tape", folder / "skirt.json", folder / "report.json"
    command("draft", "--design", "skirt", "--tape", tape, "-o", pattern)
    command("dress", "--pattern", pattern, "--tape", tape, "--spacing", SPACING_MM, "--report", report)
    return pattern, tape, json.loads(report.read_text())


def drape(pattern_path, tape_path, **options):
    tape = muslin.Tape.read(tape_path)
    pattern = muslin.Pattern.read(pattern_path)
    drape = muslin.Drape(muslin.Cloth(pattern, spacing=SPACING), muslin.Body(tape), **options)
    drape.place()
    drape.sew()
    drape.settle()
    return drape


@pytest.mark.parametrize("threads", [1, 2])
def test_the_hash_is_the_commands(scene, threads):
    pattern, tape, report = scene
    assert drape(pattern, tape, threads=threads).state_hash == report["state_hash"]


def test_the_report_says_the_same(scene):
    pattern, tape, report = scene
    got = drape(pattern, tape).report
    assert got["nodes"] == report["nodes"]
    assert got["steps"] == report["steps"]
    assert got["settled"] == 1 and report["status"] == "settled"
    assert got["max_seam_gap"] * 1000 == pytest.approx(report["max_seam_gap_mm"], abs=1e-6)


def test_the_draft_is_the_commands(scene, tmp_path):
    pattern, tape, _ = scene
    muslin.draft("skirt", muslin.Tape.read(tape)).write(tmp_path / "skirt.json")
    assert (tmp_path / "skirt.json").read_bytes() == pattern.read_bytes()


def test_a_start_is_found_and_looked_at(scene):
    pattern, tape, _ = scene
    body, pattern = muslin.Body(muslin.Tape.read(tape)), muslin.Pattern.read(pattern)
    assert muslin.pattern_reason(pattern)["kind"] == 0
    muslin.arrange(pattern, body)
    good = muslin.Drape(muslin.Cloth(pattern, spacing=0.05), body)
    good.place()
    assert good.start["kind"] == 0 and good.start["text"] == ""
    pattern.set_placement(0, origin=(0, 0.9, 0))
    bad = muslin.Drape(muslin.Cloth(pattern, spacing=0.05), body)
    bad.place()
    assert bad.start["name"] == "start tangled" and bad.start["panel"] == 0 and "inside the body" in bad.start["text"]


def test_paper_and_meshes_are_written(scene, tmp_path):
    pattern, tape, _ = scene
    sheet = muslin.Sheet(muslin.Pattern.read(pattern), paper="a4", person="W40")
    columns, rows = sheet.grid
    assert 1 < sheet.page_count <= columns * rows + 1  # a cover, and no tile without ink
    sheet.write_pdf(tmp_path / "skirt.pdf")
    sheet.write_svg(tmp_path / "skirt.svg")
    assert (tmp_path / "skirt.pdf").read_bytes()[:5] == b"%PDF-"

    body = muslin.Body(muslin.Tape.read(tape))
    mesh = muslin.Mesh("body", body.vertices, body.triangles, normals=body.normals, colour=(0.8, 0.6, 0.5, 1))
    muslin.write_obj(tmp_path / "body.obj", [mesh])
    muslin.write_glb(tmp_path / "body.glb", [mesh])
    assert (tmp_path / "body.glb").read_bytes()[:4] == b"glTF"
    assert (tmp_path / "body.obj").read_text().count("\nf ") == len(body.triangles)
    with pytest.raises(muslin.MuslinError, match="no/such/folder"):
        sheet.write_pdf("no/such/folder/skirt.pdf")


def test_a_cloth_is_written_panel_by_panel(tmp_path):
    cloth = muslin.Cloth(muslin.draft("skirt", "W40"), spacing=0.05)
    places = [(x, y, 0) for x, y in cloth.rest]
    mesh = muslin.Mesh("skirt", places, cloth.triangles, texcoords=cloth.rest, cloth=cloth, material="denim")
    muslin.write_mesh(tmp_path / "skirt.obj", [mesh])
    groups = [line[2:] for line in (tmp_path / "skirt.obj").read_text().splitlines() if line.startswith("g ")]
    assert groups[-1] == "seams" and len(groups) == 1 + len(set(cloth.node_panels))
    assert f"newmtl denim.{groups[0]}" in (tmp_path / "skirt.mtl").read_text()
    for form in ("glb", "usda", "ply"):
        assert groups[0].encode() in muslin.exchange.mesh_bytes([mesh], form)


def test_meshes_in_motion_are_written(tmp_path):
    square, faces = [[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 1, 2]]
    mesh = muslin.Mesh("flag", square, faces, normals=[[0, 0, 1]] * 3)
    moved = square + [[0, 0, 1], [1, 0, 0], [1, 1, 0]]
    muslin.write_glb_motion(tmp_path / "flag.glb", [mesh], [0, 0.5], [(moved, [[0, 0, 1]] * 6)])
    data = (tmp_path / "flag.glb").read_bytes()
    length = int.from_bytes(data[12:16], "little")
    document = json.loads(data[20:20 + length])
    assert len(document["meshes"][0]["primitives"][0]["targets"]) == 2
    assert document["animations"][0]["channels"][0]["target"] == {"node": 0, "path": "weights"}
    muslin.write_mesh(tmp_path / "flag.usda", [mesh], times=[0, 0.5], motions=[(moved, None)])
    assert "points.timeSamples" in (tmp_path / "flag.usda").read_text()
    muslin.write_mesh(tmp_path / "flag.pc2", [mesh], times=[0, 0.5], motions=[(moved, None)])
    assert len((tmp_path / "flag.pc2").read_bytes()) == 32 + 2 * 3 * 12
    with pytest.raises(ValueError, match="'stl' is no form"):
        muslin.write_mesh(tmp_path / "flag.stl", [mesh])
    with pytest.raises(ValueError, match="2 keys of 3 vertices"):
        muslin.write_glb_motion(tmp_path / "flag.glb", [mesh], [0, 0.5], [(square, None)])
