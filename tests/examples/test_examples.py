"""Each example program of examples/*.c runs, and prints what stands in the .out file beside it.

Words must be equal. A number may differ by 0.5 %, or by one unit of its last printed digit.
"""
import re
import subprocess

import pytest

from places import BIN, ROOT

EXAMPLES = sorted(path.stem for path in (ROOT / "examples").glob("*.out"))
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
RELATIVE = 0.005


def numbers_and_words(text):
    """(numbers as printed, text with a # in the place of each number)"""
    return NUMBER.findall(text), NUMBER.sub("#", text)


def close(got, expected):
    digits = len(expected.partition(".")[2])
    return abs(float(got) - float(expected)) <= max(RELATIVE * abs(float(expected)), 1.001 * 10.0 ** -digits)


def test_every_example_but_hello_has_its_output():
    """hello needs two files; tests/embed runs it."""
    programs = {path.stem for path in (ROOT / "examples").glob("*.c")}
    assert programs - set(EXAMPLES) == {"hello"}


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_example_prints_what_stands_beside_it(name, tmp_path):
    program = BIN.parent / "examples" / name
    done = subprocess.run([str(program)], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    expected = (ROOT / "examples" / f"{name}.out").read_text()
    got_numbers, got_words = numbers_and_words(done.stdout)
    expected_numbers, expected_words = numbers_and_words(expected)
    assert got_words == expected_words, done.stdout
    wrong = [(g, e) for g, e in zip(got_numbers, expected_numbers) if not close(g, e)]
    assert not wrong, f"numbers (got, expected): {wrong}"
