"""test_find.py: muslin catalogue and muslin find by their files, JSON and exit codes."""
import json
import pathlib
import subprocess

TAPE = str(pathlib.Path(__file__).resolve().parents[2] / "examples" / "tapes" / "w40.tape")


def run(program, *arguments):
    return subprocess.run([str(program), *arguments], capture_output=True, text=True, timeout=120)


def test_patterns_are_kept_and_found(tmp_path, program):
    for design in ("tshirt", "skirt"):
        done = run(program, "draft", "--design", design, "--tape", TAPE, "-o", str(tmp_path / f"{design}.json"))
        assert done.returncode == 0, done.stderr
    database = str(tmp_path / "c.db")
    files = [str(tmp_path / f"{design}.json") for design in ("tshirt", "skirt")]
    done = run(program, "catalogue", "add", database, *files)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")

    done = run(program, "find", "--like", files[1], "--in", database, "--json")
    rows = json.loads(done.stdout)
    assert [row["name"] for row in rows] == ["skirt", "tshirt"]
    assert rows[0] == {"name": "skirt", "distance": 0, "exact": True}
    assert rows[1]["distance"] > 1 and rows[1]["exact"] is False
    done = run(program, "find", "--like", files[0], "--in", database, "--part", "--why", "--count", "3")
    assert done.returncode == 0 and "tshirt" in done.stdout and "skirt" not in done.stdout


def test_bad_input_is_one_line(tmp_path, program):
    database = str(tmp_path / "c.db")
    for arguments in (("find",), ("find", "--like", "x.json", "--in", database), ("catalogue",),
                      ("catalogue", "add", database), ("catalogue", "drop", database, "x"),
                      ("catalogue", "add", database, "x.json"), ("find", "--like", TAPE, "--in", TAPE)):
        done = run(program, *arguments)
        assert done.returncode in (1, 2) and done.stdout == "" and len(done.stderr.splitlines()) == 1, arguments
