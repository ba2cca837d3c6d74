#!/usr/bin/env python3
"""hardening.py --hard PROGRAM --soft PROGRAM [--runs N]: what stack guards and FORTIFY cost.

Two builds of the command, with and without them (relro and binding at the start are in both: they cost at the start of a
program alone), do the same work in turn. Of each the least CPU time of N runs is told, and their ratio. The kernels of a
drape are compiled without guards in both.
"""
import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile

WORK = [
    ("readers: a pattern and back", ["convert", "{pattern}", "{folder}/again.json"]),
    ("a body of a tape", ["body", "--size", "W40", "--obj", "{folder}/body.obj"]),
    ("paper of a shirt", ["print", "--design", "shirt", "--size", "W40", "--pdf", "{folder}/shirt.pdf"]),
    ("a seam proposal", ["seams", "{pattern}"]),
    ("a skirt dressed at 15 mm", ["dress", "--design", "skirt", "--size", "W40", "--spacing", "15", "--quiet"]),
    ("a T-shirt dressed at 30 mm, cloth on cloth",
     ["dress", "--design", "tshirt", "--size", "W40", "--spacing", "30", "--self-contact", "--quiet"]),
]


def seconds(command):
    """CPU seconds of a run."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in (0, 1):
        sys.exit(f"{command}: {done.stderr.decode()}")
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hard", required=True, type=pathlib.Path)
    parser.add_argument("--soft", required=True, type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=9)
    options = parser.parse_args()
    programs = [options.hard.resolve(), options.soft.resolve()]
    print(f"{'least CPU s of ' + str(options.runs) + ' runs':44} {'hardened':>9} {'without':>9} {'ratio':>7}")
    total = [0.0, 0.0]
    with tempfile.TemporaryDirectory() as folder:
        pattern = f"{folder}/shirt.json"
        subprocess.run([programs[0], "draft", "--design", "shirt", "--size", "W40", "-o", pattern], check=True)
        for name, words in WORK:
            words = [word.format(pattern=pattern, folder=folder) for word in words]
            least = [min(values) for values in zip(*([seconds([program, *words]) for program in programs]
                                                     for _ in range(options.runs)))]
            total = [a + b for a, b in zip(total, least)]
            print(f"{name:44} {least[0]:9.4f} {least[1]:9.4f} {least[0] / least[1]:7.3f}", flush=True)
    print(f"{'all':44} {total[0]:9.4f} {total[1]:9.4f} {total[0] / total[1]:7.3f}")


if __name__ == "__main__":
    main()
