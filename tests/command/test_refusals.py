"""What the command refuses: one line that names the thing, the right exit code, no file left, no work done first."""
import json
import os
import subprocess

import pytest

COMMANDS = ["body", "designs", "draft", "dress", "print", "convert", "bench"]
DRAFT = ["draft", "--design", "skirt", "--size", "W40"]
DRESS = ["dress", "--design", "skirt", "--size", "W40", "--spacing", "40"]
PRINT = ["print", "--design", "skirt", "--size", "W40"]


@pytest.mark.parametrize("name", COMMANDS)
def test_help_names_every_option_in_a_line_of_its_own(command, name):
    for option in ("--help", "-h"):
        done = command(name, option)
        assert done.stderr == b"" and done.stdout.startswith(b"usage: muslin " + name.encode())
    lines = done.stdout.decode().splitlines()
    options = [line.split()[0] for line in lines if line.startswith("  -")]
    assert "--help" in options and len(options) == len(set(options))
    assert max(map(len, lines)) <= 100


@pytest.mark.parametrize("name", COMMANDS)
def test_an_unknown_option_is_named(command, one_line, name):
    assert "--wrong" in one_line(command(name, "--wrong", code=2))


def test_no_command_at_all_is_one_line(command, one_line):
    assert "--help" in one_line(command(code=2))


@pytest.mark.parametrize("arguments, words", [
    # values that are missing, given twice, too many
    (["draft", "--design", "skirt", "--size", "W40", "-o"], ["-o", "value"]),
    (["body", "--size", "W40", "--size", "W42"], ["--size", "twice"]),
    ([*DRESS, "--spacing", "30"], ["--spacing", "twice"]),
    (["body", "--size", "W40", "--json", "--json"], ["--json", "twice"]),
    (["body", "--size", "W40", "more"], ["more"]),
    (["convert", "a.json", "b.json", "c.json"], ["c.json"]),
    # things that do not go together
    (["body", "--size", "W40", "--tape", "x.tape"], ["--tape", "--size"]),
    (["body", "--size", "W40", "--row", "Ada"], ["--row", "Ada"]),
    (["dress", "--design", "skirt", "--pattern", "x.json", "--size", "W40"], ["--design", "--pattern"]),
    (["dress", "--pattern", "x.json"], ["--tape"]),
    (["print", "--pdf", "x.pdf"], ["--design", "--pattern"]),
    (["print", "--design", "skirt", "--pdf", "x.pdf"], ["--tape"]),
    ([*PRINT, "--pdf", "-", "--svg", "-"], ["--pdf", "--svg", "standard output"]),
    ([*PRINT, "--pdf", "-", "--json"], ["--pdf", "--json", "standard output"]),
    ([*DRESS, "--report", "-", "--json"], ["--report", "--json", "standard output"]),
    (["body", "--size", "W40", "--obj", "-", "--json"], ["--obj", "--json", "standard output"]),
    ([*DRESS, "--obj", "a", "--glb", "a"], ["--glb", "--obj", "both write to a"]),
    ([*PRINT, "--pdf", "a", "--svg", "a"], ["--pdf", "--svg", "both write to a"]),
    # names that are not known
    (["body", "--size", "W41"], ["W41", "W40", "M50", "C116"]),
    (["body", "--size", ""], ["size"]),
    ([*DRESS, "--fabric", "lead"], ["--fabric", "lead", "jersey"]),
    ([*DRESS, "--fabric", "no.json"], ["no.json", "cannot be opened"]),
    ([*DRESS, "--colour", "blurple"], ["--colour", "blurple"]),
    ([*DRESS, "--colour", "#12345g"], ["--colour", "#12345g"]),
    ([*PRINT, "--pdf", "x.pdf", "--paper", "a5"], ["--paper", "a5", "letter"]),
    (["convert", "x.json", "x.stl"], ["x.stl", "svg"]),
    (["convert", "x.tape", "x.yaml"], ["x.yaml", "tape"]),
    (["convert", "x.json", "-", "--to", "stl"], ["stl", "svg"]),
    (["body", "--tape", "x.doc"], ["x.doc", ".tape"]),
    # numbers
    *[([*DRESS[:-2], "--spacing", value], ["--spacing", value]) for value in
      ("12,5", "nan", "NaN", "inf", "-inf", "1e9", "-3", "0", "", "ten", "0x10", "1 0", "1e", "12mm", "+-1")],
    *[([*DRESS, "--threads", value], ["--threads", value]) for value in ("1e9", "2.5", "0", "nan", "-1", "2,0")],
    ([*DRESS, "--place", "there"], ["--place there", "file or found"]),
    *[([*DRESS, "--precision", value], ["--precision", value]) for value in ("48", "32.5", "16", "128", "nan")],
    *[([*DRESS, "--friction", value], ["--friction", value]) for value in ("-0.1", "nan", "0,4", "11")],
    *[([*DRESS, "--repeat", value], ["--repeat", value]) for value in ("0", "nan", "1e9")],
    *[([*PRINT, "--pdf", "x.pdf", "--allowance", value], ["--allowance", value]) for value in ("1,5", "-1", "1e9")],
    *[([*DRESS, "--view", value], ["--view", value]) for value in ("0", "a,b,c", "0,5,nan", "0,5,1e9", "0,95,1")],
    *[([*DRESS, "--pixels", value], ["--pixels", value]) for value in ("100", "0x0", "1e9x1", "100x", "20000x20000")],
    # files that are not there
    (["body", "--tape", "not/there.tape"], ["not/there.tape"]),
    (["body", "--tape", "there.csv", "--row", "Ada"], ["there.csv"]),
    (["print", "--pattern", "not-there.json", "--pdf", "x.pdf"], ["not-there.json"]),
    ([*DRESS, "--texture", "not-there.png"], ["--texture", "not-there.png"]),
    (["convert", "not-there.tape", "x.tape"], ["not-there.tape"]),
    # files that cannot be written
    *[([*DRESS, option, "not/there.out"], ["not/there.out"]) for option in ("--png", "--glb", "--obj", "--report")],
    *[([*PRINT, option, "not/there.out"], ["not/there.out"]) for option in ("--pdf", "--svg")],
    ([*DRAFT, "-o", "not/there.json"], ["not/there.json"]),
    ([*DRAFT, "-o", "."], ["folder"]),
    ([*DRAFT, "-o", ""], ["empty"]),
    (["body", "--size", "W40", "--obj", "not/there.obj"], ["not/there.obj"]),
    (["convert", "x.tape", "not/there.tape"], ["not/there.tape"]),
], ids=lambda value: " ".join(value) if isinstance(value, list) and value and value[0] in COMMANDS else "")
def test_a_bad_request_is_refused_by_name_and_leaves_nothing(command, one_line, tmp_path, arguments, words):
    said = one_line(command(*arguments, code=2, cwd=tmp_path))
    for word in words:
        assert word in said, said
    assert list(tmp_path.iterdir()) == []


def test_a_bad_request_is_refused_before_the_work(program, tmp_path):
    """A drape at 4 mm takes minutes; each of these must not begin one."""
    base = ["dress", "--design", "tshirt", "--size", "W40", "--spacing", "4"]
    for bad in (["--png", "not/there.png"], ["--report", "not/there.json"], ["--texture", "none.png"],
                ["--fabric", "lead"], ["--view", "x"], ["--colour", "x"], ["--pixels", "x"]):
        done = subprocess.run([program, *base, *bad], cwd=tmp_path, stderr=subprocess.DEVNULL, timeout=5)
        assert done.returncode == 2


# ---- standard output that is full ----

@pytest.mark.parametrize("arguments", [["designs"], ["designs", "--json"], ["body", "--size", "W40", "--json"],
                                       [*DRAFT, "-o", "-"], [*PRINT, "--pdf", "-"], [*PRINT, "--svg", "-"], ["--help"],
                                       ["body", "--help"]], ids=" ".join)
def test_a_full_standard_output_is_told(program, arguments):
    with open("/dev/full", "wb") as full:
        done = subprocess.run([program, *arguments], stdout=full, stderr=subprocess.PIPE, timeout=60)
    assert done.returncode == 1
    assert done.stderr.count(b"\n") == 1 and b"cannot be written" in done.stderr


@pytest.mark.parametrize("arguments", [["body", "--size", "W40", "--obj"], [*DRAFT, "-o"], [*PRINT, "--pdf"],
                                       [*PRINT, "--svg"], [*DRESS, "--glb"], [*DRESS, "--report"]], ids=" ".join)
def test_a_full_device_is_a_run_that_failed(command, arguments):
    assert b"cannot be written" in command(*arguments, "/dev/full", code=1).stderr


def test_outputs_that_are_one_file_by_a_link_are_refused(command, one_line, tmp_path):
    (tmp_path / "a.pdf").write_text("old")
    (tmp_path / "b.svg").symlink_to("a.pdf")
    said = one_line(command(*PRINT, "--pdf", "a.pdf", "--svg", "b.svg", code=2, cwd=tmp_path))
    assert "both write to b.svg" in said and (tmp_path / "a.pdf").read_text() == "old"
    command(*PRINT, "--pdf", "/dev/null", "--svg", "/dev/null")


# ---- files that are none ----

@pytest.mark.parametrize("arguments", [["dress", "--size", "W40", "--pattern"], ["dress", "--design", "skirt", "--tape"],
                                       [*DRESS, "--fabric"], ["body", "--mesh"],
                                       [*DRESS, "--png", "x.png", "--texture"]], ids=" ".join)
def test_a_pipe_is_refused_before_it_is_opened(command, one_line, tmp_path, arguments):
    pipe = tmp_path / ("p.tape" if "--tape" in arguments else "p.obj" if "--mesh" in arguments else "p.json")
    os.mkfifo(pipe)
    said = one_line(command(*arguments, pipe, code=2))
    assert str(pipe) in said and "no regular file" in said


# ---- names that would steer the terminal ----

def test_control_characters_of_a_name_are_shown(command, one_line, tmp_path):
    pattern = tmp_path / "a.json"
    command(*DRAFT, "-o", pattern)
    text = json.loads(pattern.read_text())
    text["name"] = "a\x1b[31mred\x9b1m\n"
    pattern.write_text(json.dumps(text))
    done = command("dress", "--size", "W40", "--spacing", "50", "--pattern", pattern)
    assert rb"a\x1b[31mred\xc2\x9b1m\x0a: settled" in done.stdout and b"\x1b" not in done.stdout
    said = one_line(command("dress", "--size", "W40", "--pattern", "no\x1b[2J.json", code=2))
    assert "\x1b" not in said and "[2J" in said
