"""muslin verify: every case holds, and the three forms say the same."""
import csv
import io
import json

import pytest

KEYS = ["id", "quantity", "exact", "got", "error", "tolerance", "pass"]


@pytest.fixture(scope="module")
def rows(command):
    return json.loads(command("verify", "--json").stdout)["cases"]


def test_every_row_holds(rows):
    assert len(rows) > 50
    for row in rows:
        assert set(KEYS) <= set(row) <= {*KEYS, "negative"}
        assert row["pass"] is True, row


def test_every_case_of_integration_and_damping_is_there(rows):
    ids = {row["id"] for row in rows}
    assert {f"I{i}" for i in range(1, 14)} | {"D1", "D2", "D3"} <= ids


def test_every_case_of_membrane_and_bending_is_there(rows):
    ids = {row["id"] for row in rows}
    assert {f"M{i}" for i in range(1, 11)} | {f"B{i}" for i in range(1, 9)} <= ids
    assert {row["id"] for row in rows if row.get("negative")} == {"B6", "B8", "M2", "M3"}


def test_every_case_on_limbs_and_planes_is_there(rows):
    ids = {row["id"] for row in rows}
    assert {f"F{i}" for i in range(1, 9)} | {"C1", "C2", "C3", "C4", "C5", "V1", "V2", "V3"} <= ids


def test_every_case_of_splines_is_there(rows):
    assert {"N1", "N2", "N3"} <= {row["id"] for row in rows}


def test_every_case_of_contours_and_solids_is_there(rows):
    assert {"K1", "K2", "K3", "K4"} <= {row["id"] for row in rows}


def test_the_error_is_that_of_the_columns(rows):
    for row in rows:
        error = abs((row["got"] - row["exact"]) / row["exact"]) if row["exact"] else abs(row["got"])
        assert row["error"] == pytest.approx(error, rel=1e-3, abs=1e-8)
        assert (row["error"] >= row["tolerance"]) if row.get("negative") else (row["error"] <= row["tolerance"])


def test_csv_and_table_have_the_rows_of_json(command, rows):
    wanted = [row for row in rows if row["id"] in ("I1", "I4")]
    table = list(csv.DictReader(io.StringIO(command("verify", "--csv", "--only", "I1,I4").stdout.decode())))
    assert [list(row) for row in table] == [KEYS] * len(wanted)
    for row, line in zip(wanted, table):
        assert (row["id"], row["quantity"]) == (line["id"], line["quantity"])
        assert float(line["got"]) == pytest.approx(row["got"], rel=1e-8)
    text = command("verify", "--only", "I1,I4").stdout.decode().splitlines()
    assert len(text) == len(wanted) + 2 and text[-1] == f"{len(wanted)} of {len(wanted)} rows pass, 0 known failures"


def test_a_family_and_an_id_choose(command):
    for only, ids in (("I6", {"I6"}), ("I3,I4", {"I3", "I4"})):
        cases = json.loads(command("verify", "--json", "--only", only).stdout)["cases"]
        assert {row["id"] for row in cases} == ids


def test_an_unknown_case_is_bad_input(command):
    done = command("verify", "--only", "I3,Z9", code=2)
    assert b'"Z9" is unknown' in done.stderr
    for bad in ("", "I3,,I4"):
        assert b"empty" in command("verify", "--only", bad, code=2).stderr
    command("verify", "--csv", "--json", code=2)
