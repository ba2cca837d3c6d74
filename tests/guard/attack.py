#!/usr/bin/env python3
"""attack.py [--run OUT]: what the attack on release 0.1 found (F1 to F11, and small things without a number), and what
keeps each finding closed.

Prints a row for each; exit 1 when a test, guard or seed that a row names is not there. The tests run in `make check`,
those of "sanitize" in .ci/run. With --run each test that a row names is run with the programs of OUT, and the row says
how it went and how long it took; then the two figures of size: nodes refused, seeds in the tree.
"""
import argparse
import functools
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXTREME, COMMAND = "tests/extreme/", "tests/command/test_refusals.py"
SEEDS = "tests/fuzz/seeds/"
# finding, what it was, (file, a text in it that names the test)
FINDINGS = [
    ("F1", "positions beyond a float's range led a search out of its memory", [
        (EXTREME + "test_refused_cloth.c", "places_beyond_the_limit_are_refused_at_each_door"),
        (SEEDS + "drape/far_placement.json", ""), (SEEDS + "drape/far_apart.json", "")]),
    ("F2", "a catalogue's views and triggers were run", [
        ("tests/catalogue/test_catalogue.c", "a_hostile_file_runs_nothing_and_ends"),
        (SEEDS + "catalogue/view.db", ""), (SEEDS + "catalogue/trigger.db", "")]),
    ("F3", "a small file asked for any number of nodes", [
        ("tests/cloth/test_cloth.c", "at most 1048576 (nodes_most)"), (SEEDS + "drape/panel_40m.json", "")]),
    ("F4", "a build with the thread sanitizer ended before main", [
        (".ci/run", "config=tsan werror=1 check-threads"), ("lib/base/target_clones.h", "thread_sanitizer")]),
    ("F5", "arithmetic with NULL where memory fails", [
        ("tests/scan/test_scan.c", "support_fail_after"), (EXTREME + "every_call.h", "mus_body_create_scan"),
        (EXTREME + "every_call.h", "mus_sheet_write_svg_bytes"), (EXTREME + "test_every_call.c", ""),
        (".ci/run", "what lacks memory, under clang's sanitizers")]),
    ("F6", "a name of a tape that is not UTF-8 was taken", [
        ("tests/exchange/test_tape_csv.c", "a_row_whose_name_is_not_utf8_is_refused"),
        (SEEDS + "tape/csv_not_utf8", "")]),
    ("F7", "a FIFO hung a batch", [(COMMAND, "test_a_pipe_is_refused_before_it_is_opened")]),
    ("F8", "exit codes of a full device differed", [(COMMAND, "test_a_full_device_is_a_run_that_failed")]),
    ("F9", "control characters of a name reached the terminal", [
        (COMMAND, "test_control_characters_of_a_name_are_shown")]),
    ("F10", "messages of 150 digits", [(EXTREME + "test_refused_cloth.c", "z is -1e+160 m")]),
    ("F11", "no hardening by default, no baseline of the ABI", [
        ("tests/guard/total.sh", "guard hardened"), ("tests/abi/test_baseline.py", "test_nothing_that_was_recorded"),
        ("tests/abi/test_first.py", "test_a_program_of_the_first_release_runs"), ("SECURITY.md", "Report a")]),
    ("small", "a panel was added in a time that grew with their number", [
        ("tests/pattern/test_panels_edges_points.c", "many_panels_are_added_and_found_in_linear_time")]),
    ("small", "two outputs into one file: the last won without a word", [
        (COMMAND, "both write to a"), (COMMAND, "test_outputs_that_are_one_file_by_a_link_are_refused")]),
    ("small", "a killed writer left an empty file that was no catalogue", [
        ("tests/catalogue/test_catalogue.c", "an empty file: no pattern was added to it")]),
    ("small", "what a host must know of threads, memory, signals and fork stood nowhere", [
        ("man/muslin.3", ".Ss Processes"), ("man/muslin.3", "A catalogue stays with the process"),
        ("man/muslin.3", "SQLite for an open catalogue")]),
    ("small", "no fuzz target and no seed stood in the tree", [
        ("tests/fuzz/test_fuzz.c", "holds_on_seeds_and_damaged_copies")]),
]


@functools.cache
def run(out, path, text):
    """Whether the test passes, and its seconds; None for what is no test of its own."""
    start = time.monotonic()
    environment = {**os.environ, "MUSLIN_BIN": f"{out}/bin", "MUSLIN_LIB": f"{out}/lib/libmuslin.so",
                   "PYTHONPATH": f"{ROOT}/bindings/python", "CK_TIMEOUT_MULTIPLIER": "10"}
    name = pathlib.Path(path).name
    if path.startswith(SEEDS):
        return run(out, "tests/fuzz/test_fuzz.c", "")
    if name.startswith("test_") and name.endswith(".c"):
        if text:
            return run(out, path, "")
        command, environment["CK_RUN_SUITE"] = [f"{out}/bin/tests"], name[len("test_"):-len(".c")]
    elif name.startswith("test_") and name.endswith(".py"):
        chosen = ["-k", text] if text.startswith("test_") else []
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *chosen, path]
    elif text == "guard hardened":
        command = ["sh", "tests/guard/hardened.sh", out]
    else:
        return None
    done = subprocess.run(command, cwd=ROOT, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return done.returncode == 0, time.monotonic() - start


def told(out, path, text):
    kept = f"{path}{': ' if text else ''}{text}"
    went = run(out, path, text) if out else None
    return kept if went is None else f"{kept} ({'passed' if went[0] else 'FAILED'} in {went[1]:.1f} s)"


def sizes(out):
    """The file of 644 bytes, and the seeds."""
    panel = SEEDS + "drape/panel_40m.json"
    start = time.monotonic()
    done = subprocess.run([f"{out}/bin/muslin", "dress", "--size", "W40", "--pattern", panel], cwd=ROOT,
                          capture_output=True, text=True)
    print(f"{(ROOT / panel).stat().st_size} bytes that ask for 16 million nodes: exit {done.returncode} in "
          f"{time.monotonic() - start:.3f} s: {done.stderr.strip()}")
    seeds = [path for path in (ROOT / SEEDS).rglob("*") if path.is_file()]
    print(f"seeds: {len(seeds)} files in {len(set(path.parent for path in seeds))} folders, "
          f"{sum(path.stat().st_size for path in seeds)} bytes")
    return done.returncode != 2


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--run", metavar="OUT", type=lambda path: str(pathlib.Path(path).resolve()))
    out = parser.parse_args().run
    faults = 0
    for number, what, keepers in FINDINGS:
        gone = [f"{path}: {text}" for path, text in keepers
                if not (ROOT / path).exists() or (text and text not in (ROOT / path).read_text())]
        kept = [told(out, path, text) for path, text in keepers]
        red = [keeper for keeper in kept if "FAILED" in keeper]
        faults += len(gone) + len(red)
        print(f"{number}: {what}: " + (f"OPEN, {'; '.join(gone)} is not there" if gone else
                                       f"{'OPEN' if red else 'closed'} by {', '.join(kept)}"), flush=True)
    if out:
        faults += sizes(out)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
