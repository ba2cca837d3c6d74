#!/usr/bin/env python3
"""The binary interface as abidw (libabigail) reads it from debug information is that of tests/abi/*.abi.gz.

    MUSLIN_LIB=build/lib/libmuslin.so python3 tests/abi/test_abidw.py --record

writes the records anew. baseline.txt guards what debug information does not have, the constants; this guards what a
reader of headers can only compute: sizes, offsets, and types as the compiler has laid them out.
"""
import gzip
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
PUBLIC = ["--drop-private-types"]
LIBRARIES = ("libmuslin", "libmuslin-print", "libmuslin-exchange", "libmuslin-catalogue")
ABI_CHANGE = 4 | 8  # bits of abidiff's exit code: a change, an incompatible one


def built(name):
    return pathlib.Path(os.environ["MUSLIN_LIB"]).resolve().parent / f"{name}.so"


def headers():
    return HERE.parents[1] / "include" / "muslin"


def record():
    for name in LIBRARIES:
        text = subprocess.run(["abidw", "--headers-dir", headers(), *PUBLIC, "--no-corpus-path", "--no-comp-dir-path",
                               "--drop-undefined-syms", "--no-elf-needed", built(name)],
                              check=True, capture_output=True).stdout
        (HERE / f"{name}.abi.gz").write_bytes(gzip.compress(text, mtime=0))


def compared(text, name, folder):
    """Whether a library has the interface of a record, and what abidiff says."""
    recorded = folder / f"{name}.abi"
    recorded.write_text(text)
    run = subprocess.run(["abidiff", "--suppressions", HERE / "growth.suppr", "--headers-dir2", headers(), *PUBLIC,
                          "--no-added-syms", recorded, built(name)], capture_output=True, text=True)
    return run.returncode >= 0 and not run.returncode & ABI_CHANGE, run.stdout + run.stderr


def recorded_text(name):
    return gzip.decompress((HERE / f"{name}.abi.gz").read_bytes()).decode()


@pytest.fixture(autouse=True)
def tools():
    """Each skip is a machine that cannot see the types, and says so. .ci/run installs abigail-tools and skips none."""
    if not shutil.which("abidiff"):
        pytest.skip("there is no abidiff (Debian: abigail-tools)")  # a package, and not every system has it
    if platform.machine() != "x86_64":
        pytest.skip("the records are of x86-64")  # sizes and offsets are other ones elsewhere
    if b".debug_info" not in subprocess.run(["readelf", "-SW", built("libmuslin")], capture_output=True).stdout:
        pytest.skip("the library has no debug information, which has the types")  # CFLAGS without -g


@pytest.mark.parametrize("name", LIBRARIES)
def test_a_library_has_the_interface_that_was_recorded(name, tmp_path):
    same, said = compared(recorded_text(name), name, tmp_path)
    assert same, said + "if that is meant, raise MUS_ABI unless it is not released yet, and record anew"


def before(text, struct, member):
    """A record of the time before a double was put into a struct: what stands behind it, and the end, 64 bits earlier."""
    start = text.index(f"<class-decl name='{struct}' size-in-bits")
    end = text.index("</class-decl>", start)
    head, put, tail = re.fullmatch(r"(.*)( *<data-member (?:(?!</data-member>).)*<var-decl name='" + member +
                                   r"'.*?</data-member>\n)(.*)", text[start:end], re.S).groups()
    tail = re.sub(r"(?<=offset-in-bits=')\d+", lambda at: str(int(at[0]) - 64), tail)
    head = re.sub(r"(?<=size-in-bits=')\d+", lambda size: str(int(size[0]) - 64), head, count=1)
    return text[:start] + head + tail + text[end:]


def test_a_field_put_into_the_middle_is_seen(tmp_path):
    assert not compared(before(recorded_text("libmuslin"), "mus_drape_def", "contact_ball"), "libmuslin", tmp_path)[0]


def test_a_field_put_at_the_end_is_no_change(tmp_path):
    same, said = compared(before(recorded_text("libmuslin"), "mus_drape_def", "progress_seconds"), "libmuslin", tmp_path)
    assert same, said


def test_a_function_that_went_is_seen(tmp_path):
    text = recorded_text("libmuslin")
    row = next(line for line in text.splitlines() if "<elf-symbol name='mus_tape_create'" in line)
    added = text.replace(row, row + "\n" + row.replace("mus_tape_create", "mus_tape_make"))
    assert not compared(added, "libmuslin", tmp_path)[0]


if __name__ == "__main__":
    if sys.argv[1:] != ["--record"]:
        sys.exit(__doc__)
    record()
