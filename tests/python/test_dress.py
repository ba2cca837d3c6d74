"""muslin.dress() gives the state of `muslin dress`, with its retries; the starts that were tried are told."""
import json

import pytest

import muslin


def command_report(command, tmp_path, *options):
    report = tmp_path / "report.json"
    command("dress", *options, "--spacing", 30, "--report", report)
    return json.loads(report.read_text())


@pytest.mark.parametrize("design", ["tshirt", "tee_v", "skirt", "jeans"])
def test_a_design_dressed_is_the_commands(command, tmp_path, design):
    want = command_report(command, tmp_path, "--design", design, "--size", "W40", "--self-contact")
    dressed = muslin.dress(design, muslin.Tape.size("W40"), spacing=0.03, self_contact=1)
    assert dressed.drape.state_hash == want["state_hash"]
    assert dressed.status == "MUS_OK" and dressed.reason["name"] == want["status"] == "settled"
    assert dressed.starts[dressed.kept]["end"] == "settled"
    assert dressed.cloth.mass == pytest.approx(want["mass_kg"])


@pytest.fixture
def skirt_in_the_body():
    tape = muslin.Tape.size("W40")
    pattern = muslin.draft("skirt", tape)
    pattern.set_placement(0, origin=(0, 0.9, 0))
    return pattern, tape


def test_a_second_start_is_the_commands(command, tmp_path, skirt_in_the_body):
    pattern, tape = skirt_in_the_body
    pattern.write(tmp_path / "skirt.json")
    want = command_report(command, tmp_path, "--pattern", tmp_path / "skirt.json", "--size", "W40")
    assert want["start"] == "found"
    dressed = muslin.dress(pattern, tape, spacing=0.03)
    assert dressed.drape.state_hash == want["state_hash"]
    assert dressed.found and [start["kind"] for start in dressed.starts] == ["pattern", "found"]
    assert dressed.starts[0]["end"] == "start tangled"
    assert all(start["seconds"] > 0 for start in dressed.starts)


def test_a_garment_that_is_not_on_raises_or_says_so(skirt_in_the_body):
    pattern, tape = skirt_in_the_body
    with pytest.raises(muslin.MuslinError, match="inside the body") as caught:
        muslin.dress(pattern, tape, spacing=0.03, retry=0)
    assert caught.value.name == "MUS_ERR_SEW"
    dressed = muslin.dress(pattern, tape, spacing=0.03, retry=0, strict=False)
    assert dressed.status == "MUS_ERR_SEW" and dressed.reason["panel"] == 0
    assert len(dressed.drape) == len(dressed.cloth)


def test_options_reach_cloth_and_drape():
    tape = muslin.Tape.size("W40")
    body, pattern = muslin.Body(tape), muslin.draft("skirt", tape)
    denim = muslin.dress(pattern, body, fabric="denim", spacing=0.04, drape_options={"precision": 64})
    assert denim.cloth.spacing == 0.04 and denim.body is body
    assert denim.cloth.mass > 2 * muslin.dress(pattern, body, spacing=0.04).cloth.mass
    with pytest.raises(TypeError, match="no option 'spaceing'"):
        muslin.dress(pattern, body, spaceing=0.04)


def test_progress_stops_and_raises():
    tape = muslin.Tape.size("W40")
    seen = []
    stopped = muslin.dress("skirt", tape, spacing=0.03, strict=False, progress=lambda told: seen.append(told) or True)
    assert stopped.status == "MUS_ERR_STOPPED" and stopped.reason["name"] == "stopped"
    assert [told.phase for told in seen] == ["sew"]

    late = muslin.dress("skirt", tape, spacing=0.03, strict=False, seconds_most=1e-9)
    assert late.status == "MUS_ERR_STOPPED" and late.reason["text"] == "no end after 1e-09 s"

    def broken(told):
        raise KeyError(told.phase)
    with pytest.raises(KeyError, match="sew"):
        muslin.dress("skirt", tape, spacing=0.03, progress=broken)
