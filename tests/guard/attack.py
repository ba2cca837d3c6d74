#!/usr/bin/env python3
"""attack.py: what the attack on release 0.1 found (F1 to F11), and what keeps each finding closed.

Prints a row for each; exit 1 when a test, guard or seed that a row names is not there. The tests run in `make check`,
those of "sanitize" in .ci/run.
"""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXTREME, COMMAND = "tests/extreme/", "tests/command/test_refusals.py"
# finding, what it was, (file, a text in it that names the test)
FINDINGS = [
    ("F1", "positions beyond a float's range led a search out of its memory", [
        (EXTREME + "test_refused_cloth.c", "places_beyond_the_limit_are_refused_at_each_door"),
        ("tests/fuzz/seeds/drape/far_placement.json", ""), ("tests/fuzz/seeds/drape/far_apart.json", "")]),
    ("F2", "a catalogue's views and triggers were run", [
        ("tests/catalogue/test_catalogue.c", "a_hostile_file_runs_nothing_and_ends"),
        ("tests/fuzz/seeds/catalogue/view.db", ""), ("tests/fuzz/seeds/catalogue/trigger.db", "")]),
    ("F3", "a small file asked for any number of nodes", [
        ("tests/cloth/test_cloth.c", "at most 1048576 (nodes_most)"), ("tests/fuzz/seeds/drape/panel_40m.json", "")]),
    ("F4", "a build with the thread sanitizer ended before main", [
        (".ci/run", "config=tsan werror=1 check-threads"), ("lib/base/target_clones.h", "thread_sanitizer")]),
    ("F5", "arithmetic with NULL where memory fails", [
        ("tests/scan/test_scan.c", "support_fail_after"), ("tests/extreme/every_call.h", "mus_body_create_scan"),
        ("tests/extreme/every_call.h", "mus_sheet_write_svg_bytes")]),
    ("F6", "a name of a tape that is not UTF-8 was taken", [
        ("tests/exchange/test_tape_csv.c", "a_row_whose_name_is_not_utf8_is_refused"),
        ("tests/fuzz/seeds/tape/csv_not_utf8", "")]),
    ("F7", "a FIFO hung a batch", [(COMMAND, "test_a_pipe_is_refused_before_it_is_opened")]),
    ("F8", "exit codes of a full device differed", [(COMMAND, "test_a_full_device_is_a_run_that_failed")]),
    ("F9", "control characters of a name reached the terminal", [
        (COMMAND, "test_control_characters_of_a_name_are_shown")]),
    ("F10", "messages of 150 digits", [(EXTREME + "test_refused_cloth.c", "z is -1e+160 m")]),
    ("F11", "no hardening by default, no baseline of the ABI", [
        ("tests/guard/total.sh", "guard hardened"), ("tests/abi/test_baseline.py", "test_nothing_that_was_recorded"),
        ("tests/abi/test_first.py", "test_a_program_of_the_first_release_runs"), ("SECURITY.md", "Report a")]),
]


def main():
    faults = 0
    for number, what, keepers in FINDINGS:
        gone = [f"{path}: {text}" for path, text in keepers
                if not (ROOT / path).exists() or (text and text not in (ROOT / path).read_text())]
        faults += len(gone)
        kept = ", ".join(f"{path}{': ' if text else ''}{text}" for path, text in keepers)
        print(f"{number}: {what}: " + (f"OPEN, {'; '.join(gone)} is not there" if gone else f"closed by {kept}"))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
