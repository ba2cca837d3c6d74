"""Many garments of a list: the same bytes however it was run and stopped, a line with its reason for all that fails."""
import json
import os
import signal
import subprocess
import time

import pytest

# small garments, all of another kind, one that cannot be, in an order that is not that of their names
LIST = """
# what                                              on whom
--design skirt                                      --size W40
--name b_top --words "top neck=v shape=boxy cloth=knit" --size 'M50'   # of a knit

--design sleeveless                                 --size W36 --self-contact --friction 0.4
--design no_such_design                             --size W40
--design skirt                                      --size W40 --spacing 40
"""
NAMES = ["skirt-W40", "b_top", "sleeveless-W36", "no_such_design-W40", "skirt-W40-2"]


def lines(folder, name="results.jsonl"):
    return [json.loads(line) for line in (folder / name).read_text().splitlines()]


@pytest.fixture
def batch(command, tmp_path):
    """Dress a list given as text into the folder `out`; the finished process, standard output as text."""
    def run(text, *options, out="out", code=0):
        done = command("dress", "--batch", "-", "-o", tmp_path / out, "--spacing", 60, *options, code=code,
                       input=text.encode())
        return done
    return run


@pytest.fixture(scope="module")
def clean(command, tmp_path_factory):
    """The folder of one clean run over LIST, and what it said."""
    folder = tmp_path_factory.mktemp("clean")
    (folder / "list").write_text(LIST)
    done = command("dress", "--batch", folder / "list", "-o", folder / "out", "--spacing", 60)
    return folder / "out", done.stdout.decode()


def test_each_line_has_its_garment_in_the_order_of_the_list(command, clean):
    folder, said = clean
    made = lines(folder)
    assert [one["name"] for one in made] == NAMES and [one["line"] for one in made] == [3, 4, 6, 7, 8]
    assert made[3]["status"] == "bad input" and "no_such_design" in made[3]["reason"]
    assert "self_contacts" in made[2] and "self_contacts" not in made[0]
    assert made[0]["state_hash"] != made[4]["state_hash"]
    settled = sum(one["status"] == "settled" for one in made)
    assert said.startswith("5 garments: ") and f"{settled} settled" in said and "1 bad input" in said
    assert "median" in said and "p95" in said and said.count("\n") == 1


def test_a_line_is_the_report_of_dress_without_its_time(command, clean, timeless):
    made = lines(clean[0])[2]
    done = command("dress", "--design", "sleeveless", "--size", "W36", "--spacing", 60, "--self-contact", "--friction",
                   0.4, "--json", code=None)
    report = timeless(json.loads(done.stdout))
    assert {**report, "line": 6, "name": "sleeveless-W36"} == made


def test_parts_of_a_list_merge_to_the_whole_by_line(batch, clean, tmp_path):
    merged = []
    for part in (1, 2):
        batch(LIST, "--part", f"{part}/2", out=f"part{part}")
        merged += (tmp_path / f"part{part}" / "results.jsonl").read_bytes().splitlines(True)
    merged.sort(key=lambda line: json.loads(line)["line"])
    assert b"".join(merged) == (clean[0] / "results.jsonl").read_bytes()
    assert batch(LIST, "--part", "7/9", out="none").stdout == b"0 garments: \n"
    for wrong in ("0/2", "3/2", "1", "1/2x", "-1/2", ""):
        assert b"expected I/N" in batch(LIST, "--part", wrong, out="none", code=2).stderr


def test_times_are_in_a_file_of_their_own(clean):
    times = lines(clean[0], "times.jsonl")
    assert [one["name"] for one in times] == NAMES
    assert all(one["cpu_s"] > 0 for one in times) and times[0]["seconds"]["settle"] > 0
    assert "seconds" not in (clean[0] / "results.jsonl").read_text()


def test_the_bytes_are_the_same_for_any_number_of_processes(batch, clean, tmp_path):
    done = batch(LIST, "--jobs", 2)
    assert done.stderr == b"" and b"from before" not in done.stdout
    assert (tmp_path / "out" / "results.jsonl").read_bytes() == (clean[0] / "results.jsonl").read_bytes()


def test_a_batch_that_is_killed_goes_on_where_it_was(batch, clean, program, tmp_path):
    (tmp_path / "list").write_text(LIST)
    # on a crowded machine a batch may be done before anyone looks: another one then
    for out in (tmp_path / "one", tmp_path / "two", tmp_path / "three"):
        running = subprocess.Popen([program, "dress", "--batch", tmp_path / "list", "-o", out, "--spacing", "60"],
                                   stdout=subprocess.DEVNULL)
        first = out / "parts" / NAMES[0]
        while not first.exists() and running.poll() is None:
            time.sleep(0.002)
        running.send_signal(signal.SIGKILL)
        running.wait()
        if not (out / "results.jsonl").exists():
            break
    assert first.exists() and not (out / "results.jsonl").exists()
    kept = first.stat().st_mtime_ns
    done = batch(LIST, out=out.name)
    assert b" from before" in done.stdout and first.stat().st_mtime_ns == kept
    assert (out / "results.jsonl").read_bytes() == (clean[0] / "results.jsonl").read_bytes()
    # a third run has nothing to do
    assert b"; 5 from before" in batch(LIST, "--jobs", 2, out=out.name).stdout


def test_what_a_killed_process_was_writing_is_removed(batch, tmp_path):
    out = tmp_path / "out"
    out.mkdir()
    for name in ("a.obj.part0", "a.mtl.part0", "a.glb.part0"):
        (out / name).write_text("half")
    batch("--design skirt --size W40 --name a\n", "--obj", "--glb", out="out")
    assert sorted(path.name for path in out.glob("a.*")) == ["a.glb", "a.mtl", "a.obj"]


def test_a_part_that_is_cut_short_is_not_taken(batch, tmp_path):
    text = "--design no_such_design --size W40\n"
    batch(text)
    whole = (tmp_path / "out" / "results.jsonl").read_bytes()
    part = tmp_path / "out" / "parts" / "no_such_design-W40"
    good = part.read_bytes()
    for cut in (b"", good[:10], good[:-1], good + b"x", good.replace(b"1 ", b"2 ", 1)):
        part.write_bytes(cut)
        assert b"from before" not in batch(text).stdout
        assert (tmp_path / "out" / "results.jsonl").read_bytes() == whole
    assert b"1 from before" in batch(text).stdout


@pytest.mark.parametrize("line, words", [
    ("--design 'skirt", ["quote"]),
    ("--design skirt --size W40 --spcing 4", ["--spcing", "unknown"]),
    ("--design skirt --size W40 --spacing 4mm", ["--spacing", "4mm"]),
    ("--design skirt --size W40 --size W42", ["--size", "twice"]),
    ("--design skirt --size W40 --jobs 2", ["--jobs", "--batch"]),
    ("--design skirt --size W40 --png a.png", ["--png", "--batch"]),
    ("--design skirt --size W40 --report a.json", ["--report"]),
    ("--design skirt --help", ["--help"]),
    ("--design skirt --size W40 --precision 48", ["--precision", "48"]),
    ("--design skirt --size W40 --name ../a", ["--name", "../a"]),
    ("--design no --size W40 --name first", ["--name", "first", "line 1"]),
    ("skirt", ["skirt"]),
])
def test_a_bad_line_is_told_in_its_place(batch, tmp_path, line, words):
    done = batch(f"--name first --design no_such --size W40\n\n{line}\n--name last --design no_such --size W40\n")
    first, bad, last = lines(tmp_path / "out")
    assert (first["name"], last["name"], bad["line"], bad["status"]) == ("first", "last", 3, "bad input")
    assert bad["reason"].startswith("line 3: ") and "\n" not in bad["reason"]
    for word in words:
        assert word in bad["reason"]
    assert done.stderr == b"" and b"3 bad input" in done.stdout
    assert len(lines(tmp_path / "out", "times.jsonl")) == 2


def test_a_line_in_another_coding_is_told_in_utf8(command, tmp_path):
    command("dress", "--batch", "-", "-o", tmp_path / "out", input="--gr\xf6sse W40\n--länge 3\n".encode("latin-1"))
    assert ["--gr\ufffdsse" in one["reason"] or "--l\ufffdnge" in one["reason"] for one in lines(tmp_path / "out")] \
        == [True, True]


def test_what_has_no_end_is_stopped_and_done_with_a_longer_limit(batch, tmp_path):
    text = "--design skirt --size W40\n"
    done = batch(text, "--limit", 0.02)
    (late,) = lines(tmp_path / "out")
    assert late == {"line": 1, "name": "skirt-W40", "status": "out of time", "reason": "no end after 0.02 CPU seconds"}
    assert b"1 out of time" in done.stdout
    assert b"1 from before" in batch(text, "--limit", 0.02).stdout
    done = batch(text)
    assert b"from before" not in done.stdout and lines(tmp_path / "out")[0]["nodes"] > 0


# the test finds the worker it kills in /proc, which some systems do not have
@pytest.mark.skipif(not os.path.exists("/proc/self/task"), reason="no /proc that names the children of a process")
def test_a_crash_is_a_line_and_the_others_go_on(program, command, one_line, tmp_path):
    out = tmp_path / "out"
    (tmp_path / "list").write_text("--design tshirt --size W40 --spacing 3\n--design no_such --size W40\n")
    running = subprocess.Popen([program, "dress", "--batch", tmp_path / "list", "-o", out], stdout=subprocess.PIPE)
    children = f"/proc/{running.pid}/task/{running.pid}/children"
    while not (child := open(children).read().split()):
        assert running.poll() is None
        time.sleep(0.002)
    # and meanwhile nobody else works there
    assert "another batch" in one_line(command("dress", "--batch", tmp_path / "list", "-o", out, code=2))
    os.kill(int(child[0]), signal.SIGABRT)
    said, _ = running.communicate(timeout=60)
    crashed, other = lines(out)
    assert running.returncode == 0 and b"1 crashed, 1 bad input" in said
    assert crashed["status"] == "crashed" and "signal 6" in crashed["reason"]
    assert other["status"] == "bad input"


def test_what_has_changed_is_dressed_again_and_nothing_else(batch, tmp_path, tape, patterns):
    mine, pattern = tmp_path / "mine.tape", tmp_path / "mine.json"
    mine.write_bytes(tape.read_bytes())
    pattern.write_bytes(patterns("skirt").read_bytes())
    text = f"--pattern {pattern} --tape {mine}\n--design no_such --size W40\n"
    batch(text)
    before = lines(tmp_path / "out")
    assert before[0]["name"] == "mine-mine"
    assert b"2 from before" in batch("# a remark moves the lines\n" + text).stdout
    # a blank in the file is another file, but no other garment
    pattern.write_bytes(pattern.read_bytes() + b"\n")
    assert b"1 from before" in batch(text).stdout and lines(tmp_path / "out") == before
    assert b"1 from before" in batch(text.replace("mine.tape", "mine.tape --friction 0.9")).stdout
    assert lines(tmp_path / "out")[0]["state_hash"] != before[0]["state_hash"]


def test_a_garment_over_another_is_one_line(batch, tmp_path):
    # beside --batch for all lines, and that of a line in its place
    # two skirts of one ease tremble at so wide a spacing: rest is another test's
    batch("--design skirt_plain --size W40 --spacing 90\n--design skirt_plain --size W40 --over no_such\n", "--over",
          "skirt_plain")
    both, bad = lines(tmp_path / "out")
    assert both["name"] == "skirt_plain-skirt_plain-W40" and both["status"] in ("settled", "not settled")
    assert both["panels"] == 4 and both["seams_closed"] == both["seams"] == 4 and both["crossings"] == 0
    assert both["self_contacts"] > 0
    assert bad["name"] == "skirt_plain-no_such-W40" and bad["status"] == "bad input" and "no_such" in bad["reason"]


def test_pictures_and_meshes_lie_under_the_name(batch, tmp_path):
    text = "--name one --design skirt --size W40\n--name none --design no_such --size W40\n"
    out = tmp_path / "out"
    done = batch(text)
    whole = (out / "results.jsonl").read_bytes()
    assert not (out / "one.obj").exists()
    done = batch(text, "--obj")
    assert b"; 1 from before" in done.stdout and (out / "one.obj").read_bytes().startswith(b"#")
    assert (out / "results.jsonl").read_bytes() == whole
    assert b"; 2 from before" in batch(text, "--obj").stdout
    assert not (out / "none.obj").exists()


def test_what_cannot_be_begun_is_refused(command, one_line, tmp_path):
    def refused(*arguments, text=b"--design skirt --size W40\n"):
        return one_line(command("dress", "--batch", *arguments, code=2, cwd=tmp_path, input=text))
    assert "-o" in refused("-")
    assert "no garment" in refused("-", "-o", "out", text=b"# none\n\n")
    assert "a byte of it is 0" in refused("-", "-o", "out", text=b"--design skirt\0--size W40\n")
    assert "not/there" in refused("not/there", "-o", "out")
    assert "not/there" in refused("-", "-o", "not/there")
    assert "--jobs" in refused("-", "-o", "out", "--jobs", "0")
    assert "--report" in refused("-", "-o", "out", "--report", "r.json")
    assert sorted(path.name for path in tmp_path.iterdir()) == []
