"""The Python program of README.md runs as it stands there, and leaves the paper that it says."""
import os
import re


def test_the_program_of_the_readme_runs(root, tmp_path, monkeypatch):
    program = re.search(r"```python\n(.*?)```", (root / "README.md").read_text(), re.S)[1]
    os.symlink(root / "examples", tmp_path / "examples")
    monkeypatch.chdir(tmp_path)
    names = {}
    exec(program, names)
    assert names["drape"].report["settled"] == 1
    assert (tmp_path / "tshirt.pdf").read_bytes()[:5] == b"%PDF-"
