"""Dressing on a body that moves: a named pose, a walk with its pictures and its animated file."""
import json


def frames_of(glb):
    data = glb.read_bytes()
    document = json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])
    return [len(mesh["primitives"][0]["targets"]) for mesh in document["meshes"]], document["animations"]


def run(command, tmp_path, *arguments, code=0):
    report = tmp_path / "report.json"
    command("dress", "--size", "W40", *arguments, "--report", report, code=code)
    return json.loads(report.read_text())


def test_a_skirt_sits_down_and_rests(command, tmp_path):
    report = run(command, tmp_path, "--design", "skirt", "--spacing", 30, "--pose", "sit")
    assert report["status"] == "settled"
    assert report["max_penetration_mm"] < 2 and report["motion"]["max_penetration_mm"] < 2
    assert report["motion"]["name"] == "sit" and report["motion"]["frames"] == 0 and report["motion"]["steps"] > 0


def test_a_walk_leaves_its_frames(command, tmp_path):
    folder = tmp_path / "film"
    folder.mkdir()
    report = run(command, tmp_path, "--design", "skirt", "--spacing", 40, "--move", "walk", "--count", 3, "--frames",
                 folder, "--pixels", "64x96", "--glb", tmp_path / "walk.glb")
    motion = report["motion"]
    assert motion["frames"] == 3 and motion["frames_per_second"] == 60 and motion["step_parts"] == 1
    assert motion["max_penetration_mm"] < 2 and 0 < motion["max_jump_mm"] < 50
    assert sorted(path.name for path in folder.iterdir()) == [f"frame_000{k}.png" for k in (1, 2, 3)]
    targets, animations = frames_of(tmp_path / "walk.glb")
    # body, front, back and seams move
    assert targets == [3] * 4 and len(animations[0]["channels"]) == 4


def test_the_same_walk_gives_the_same_state(command, tmp_path):
    walk = ["--design", "skirt", "--spacing", 40, "--move", "walk", "--count", 4]
    one = run(command, tmp_path, *walk)
    assert run(command, tmp_path, *walk, "--threads", 3)["state_hash"] == one["state_hash"]


def test_names_that_are_not_known_are_refused(command, tmp_path):
    for option, name in (("--pose", "somersault"), ("--move", "fly")):
        done = command("dress", "--design", "skirt", "--size", "W40", option, name, code=2)
        assert name in done.stderr.decode()
    done = command("dress", "--design", "skirt", "--size", "W40", "--frames", tmp_path, code=2)
    assert "--move" in done.stderr.decode()
    done = command("dress", "--design", "skirt", "--size", "W40", "--pose", "sit", "--move", "walk", code=2)
    assert "exclude" in done.stderr.decode()
