#!/usr/bin/env python3
"""faults.py --command PROGRAM --out FOLDER [--kills N] [--seed N] [PART ...]: the command under kills and without room.

batches    N batches of three garments are killed (SIGKILL to all their processes) at a random moment and run again to
           the end: results and meshes have the bytes of a run that nobody killed, and nothing else is left over
catalogues N writers of 12 patterns are killed at a random moment: the file has 0 or 12 rows, its integrity is ok, and
           the same writer then adds all
two        two writers of one catalogue at once, a tenth of N times: all rows of both are there
disk       dress with every output onto a tmpfs of 64 MB that has less and less room: whole files or none, exit 1
memory     dress under 50 limits of address space (RLIMIT_AS), from the least with which the program starts to more than
           the dress needs: exit 0, 1 or 2 with a sentence, never a signal
All parts if none is named. Each prints one line; exit 1 when one fails. disk needs root, and says so without it.
"""
import argparse
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import time

LIST = "--design skirt --size W40\n--design tshirt --size W36\n--design sleeveless --size M50\n"
SPACING = ("--spacing", "80")
ROWS = 12


def killed(command, moment):
    """Run a command in a group of its own and kill the group after `moment` seconds; whether it was still running."""
    process = subprocess.Popen(command, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        process.wait(moment)
        return False
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return True


def timed(command):
    start = time.monotonic()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return time.monotonic() - start


def tree(folder):
    """Bytes of each file of a batch but those with times."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file() and path.name != "times.jsonl" and "parts" not in path.parts and path.name != ".lock"}


def batches(options, folder, draw):
    (folder / "list").write_text(LIST)
    command = [options.command, "dress", "--batch", folder / "list", *SPACING, "--obj", "--jobs", "2", "-o"]
    long = timed(command + [folder / "clean"])
    want, hit, wrong = tree(folder / "clean"), 0, []
    for i in range(options.kills):
        out = folder / "killed"
        shutil.rmtree(out, ignore_errors=True)
        hit += killed(command + [out], draw.uniform(0.0, long))
        subprocess.run(command + [out], check=True, stdout=subprocess.DEVNULL)
        have = tree(out)
        if have != want:
            wrong.append((i, sorted(name for name in have.keys() | want.keys() if have.get(name) != want.get(name))))
    print(f"batches: {options.kills} killed, {hit} of them in their work, {len(wrong)} with other bytes or files left",
          *wrong[:3])
    return not wrong


def rows_of(path):
    if not path.exists() or path.stat().st_size == 0:
        return 0, "ok"
    base = sqlite3.connect(path)
    try:
        tables = base.execute("SELECT count(*) FROM sqlite_master WHERE name = 'pattern'").fetchone()[0]
        rows = base.execute("SELECT count(*) FROM pattern").fetchone()[0] if tables else 0
        return rows, base.execute("PRAGMA integrity_check").fetchone()[0]
    finally:
        base.close()


def patterns(options, folder):
    files = []
    names = subprocess.run([options.command, "designs"], check=True, capture_output=True, text=True).stdout
    designs = [line.split()[0] for line in names.splitlines() if line[:1].isalpha()][:2 * ROWS]
    for design in designs:
        file = folder / f"{design}.json"
        done = subprocess.run([options.command, "draft", "--design", design, "--size", "W40", "-o", file],
                              stderr=subprocess.DEVNULL)
        if done.returncode == 0:
            files.append(file)
    return files


def catalogues(options, folder, draw):
    files = patterns(options, folder)[:ROWS]
    path = folder / "catalogue.db"
    command = [options.command, "catalogue", "add", path, *files]
    long, hit, wrong = timed(command), 0, []
    for i in range(options.kills):
        for file in folder.glob("catalogue.db*"):
            file.unlink()
        hit += killed(command, draw.uniform(0.0, long))
        rows, whole = rows_of(path)
        if rows not in (0, len(files)) or whole != "ok":
            wrong.append((i, rows, whole))
        if path.exists() and path.stat().st_size == 0:
            path.unlink()
        again = subprocess.run(command, capture_output=True, text=True)
        if again.returncode != 0 or rows_of(path) != (len(files), "ok"):
            wrong.append((i, "again", again.stderr))
    print(f"catalogues: {options.kills} writers killed, {hit} in their work, {len(wrong)} wrong", *wrong[:3])
    return not wrong


def two(options, folder, _):
    files = patterns(options, folder)
    wrong = 0
    rounds = max(options.kills // 10, 1)
    for _ in range(rounds):
        for file in folder.glob("catalogue.db*"):
            file.unlink()
        writers = [subprocess.Popen([options.command, "catalogue", "add", folder / "catalogue.db", *half])
                   for half in (files[:ROWS], files[ROWS:])]
        codes = [writer.wait() for writer in writers]
        wrong += codes != [0, 0] or rows_of(folder / "catalogue.db") != (len(files), "ok")
    print(f"two: {rounds} pairs of writers of one catalogue, {wrong} wrong")
    return not wrong


def disk(options, folder, draw):
    small = folder / "small"
    small.mkdir()
    if os.geteuid() or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64m", "tmpfs", small],
                                      stderr=subprocess.DEVNULL).returncode:
        print("disk: skipped: a tmpfs of 64 MB cannot be mounted here")
        return True
    wrong, codes = [], {0: 0, 1: 0}
    command = [options.command, "dress", "--design", "skirt", "--size", "W40", *SPACING]

    def outputs(place):
        return ["--obj", place / "a.obj", "--glb", place / "a.glb", "--report", place / "a.json"]

    whole = folder / "whole"
    whole.mkdir()
    subprocess.run(command + outputs(whole), check=True, stdout=subprocess.DEVNULL)
    try:
        for i in range(20):
            for file in small.iterdir():
                file.unlink()
            (small / "a.obj").write_text("old")
            room = draw.randrange(0, 16000) * 1024
            with open(small / "filler", "wb") as filler:
                filler.write(bytes(64 * 1024 * 1024 - room - 4096))
            done = subprocess.run(command + outputs(small), capture_output=True, text=True)
            codes[done.returncode] = codes.get(done.returncode, 0) + 1
            for file in small.iterdir():
                want = whole / file.name
                good = file.name in ("filler", "a.json") or (want.exists() and file.read_bytes() == want.read_bytes())
                good |= file.name == "a.obj" and file.read_bytes() == b"old"
                if file.name == "a.json":  # it tells times
                    json.loads(file.read_text())
                if not good:
                    wrong.append((i, file.name))
            if done.returncode not in (0, 1) or (done.returncode and not done.stderr):
                wrong.append((i, done.returncode, done.stderr))
    finally:
        subprocess.run(["umount", small], check=True)
    print(f"disk: 20 runs with 0 to 16 MB of room: {codes[0]} written, {codes[1]} refused, {len(wrong)} wrong",
          *wrong[:3])
    return not wrong


def limited(command, limit):
    return subprocess.run(command, capture_output=True, text=True,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))


def least(command, low, high):
    """The least limit [MiB] with which a command succeeds."""
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if limited(command, middle << 20).returncode == 0 else (middle, high)
    return high


def memory(options, folder, _):
    command = [options.command, "dress", "--design", "tshirt", "--size", "W40", *SPACING, "--obj", folder / "a.obj"]
    low = least([options.command, "--version"], 1, 1024)  # below it the loader fails, and nothing of ours runs
    high = least(command, low, 1024)
    wrong, codes = [], {}
    for i in range(50):
        limit = int(2**20 * (low + 1.1 * (high - low) * i / 49))
        done = limited(command, limit)
        codes[done.returncode] = codes.get(done.returncode, 0) + 1
        if done.returncode not in (0, 1, 2) or (done.returncode and not done.stderr):
            wrong.append((limit >> 20, done.returncode, done.stderr[:80]))
    print(f"memory: 50 limits from {low} to {low + 1.1 * (high - low):.0f} MiB, exit codes",
          dict(sorted(codes.items())), f"{len(wrong)} wrong", *wrong[:3])
    return not wrong


PARTS = {"batches": batches, "catalogues": catalogues, "two": two, "disk": disk, "memory": memory}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", required=True, type=pathlib.Path)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=25)
    parser.add_argument("parts", nargs="*", metavar="PART")
    options = parser.parse_args()
    options.command = options.command.resolve()
    good = True
    for name in options.parts or PARTS:
        folder = options.out.resolve() / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        good &= PARTS[name](options, folder, random.Random(options.seed))
        sys.stdout.flush()
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
