"""The ABI is that of tests/abi/baseline.txt: nothing that a linked program relies on was taken away or changed."""
import importlib.util

import pytest


@pytest.fixture(scope="module")
def generate(root):
    spec = importlib.util.spec_from_file_location("generate", root / "bindings/python/generate.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def now(generate, root):
    return set(generate.render_baseline(generate.Headers(root / "include/muslin")).splitlines())


def test_nothing_that_was_recorded_is_gone_or_changed(generate, now):
    recorded = generate.BASELINE.read_text().splitlines()
    assert len(recorded) > 700
    gone = [line for line in recorded if line not in now]
    assert not gone, ("the ABI changed; if that is meant, raise MUS_ABI in base.h unless it is not released yet, and "
                      "run bindings/python/generate.py --record")


def test_what_is_new_is_recorded(generate, now):
    new = sorted(now - set(generate.BASELINE.read_text().splitlines()))
    assert not new, "run bindings/python/generate.py --record: what is not recorded is not guarded"


@pytest.mark.parametrize("name, old, new", [
    ("base", "X(4, ERR_STATE,", "X(44, ERR_STATE,"),
    ("cloth", "#define MUS_BEND_PAPER 1", "#define MUS_BEND_PAPER 2"),
    ("cloth", "    double shear;", "    double bias;\n    double shear;"),
    ("base", "MUS_API size_t mus_context_bytes(", "MUS_API uint64_t mus_context_bytes("),
])
def test_a_change_of_each_kind_is_seen(generate, now, root, tmp_path, name, old, new):
    for header in (root / "include/muslin").glob("*.h"):
        text = header.read_text()
        (tmp_path / header.name).write_text(text.replace(old, new) if header.stem == name else text)
    changed = set(generate.render_baseline(generate.Headers(tmp_path)).splitlines())
    assert now - changed


def test_a_field_at_the_end_of_a_struct_is_no_change(generate, now, root, tmp_path):
    for header in (root / "include/muslin").glob("*.h"):
        text = header.read_text()
        (tmp_path / header.name).write_text(text.replace("} mus_cloth_def;", "    double more;\n} mus_cloth_def;"))
    assert not now - set(generate.render_baseline(generate.Headers(tmp_path)).splitlines())
