#!/usr/bin/env python3
"""man.py [LIBFOLDER]: the pages against the headers, both ways, and against mandoc.

Every public function stands in a .Fn or .Fo of some page in man/; every mus_ function named there is declared; every
.Xr of a mus page has its page; mandoc -Tlint -Wstyle is silent. With LIBFOLDER, each example that has a main() is
compiled, linked with the archives there and run in an empty folder: it must end with 0; and muslin(1) has the options of
each `muslin COMMAND --help`, in its text and, unless that says "options", in its synopsis, and no others.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
OF_LINES = {"-name"}  # options of the lines of a batch, which no --help lists
DECLARED = re.compile(r"\bMUS_API\s[^;(#]*?\b(mus_\w+)\s*\(")


def lint(pages):
    out = subprocess.run(["mandoc", "-Tlint", "-Wstyle", *map(str, pages)], capture_output=True, text=True).stdout
    # mandoc asks the manuals that the machine has for the targets of .Xr; ours are checked below
    return [line for line in out.splitlines() if line.strip() and "referenced manual not found" not in line]


def examples(page):
    """The C programs of a page: literal displays with a main()."""
    for block in re.findall(r"^\.Bd -literal.*?\n(.*?)^\.Ed", page.read_text(), re.M | re.S):
        if re.search(r"\bmain\(", block):
            yield re.sub(r"^\\&", "", block, flags=re.M).replace("\\e", "\\").replace("\\-", "-").replace("\\(aq", "'")


def run_example(name, text, lib):
    packages = subprocess.run(["pkg-config", "--libs", "cairo", "pangocairo", "jansson", "yaml-0.1", "expat",
                               "sqlite3"], capture_output=True,
                              text=True).stdout.split()
    archives = [str(lib / f"libmuslin{part}.a") for part in ("-print", "-exchange", "-catalogue", "")]
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "example.c")
        source.write_text(text)
        build = subprocess.run([*os.environ.get("CC", "cc").split(), "-std=c99", "-Wall", "-Wextra", "-Werror",
                                "-I", str(ROOT / "include"), str(source), *archives, *packages, "-lm", "-pthread",
                                "-o", folder + "/example"], capture_output=True, text=True)
        if build.returncode != 0:
            return [f"{name}: its example does not compile:", build.stderr.strip()]
        done = subprocess.run([folder + "/example"], cwd=folder, capture_output=True, text=True, timeout=120)
        if done.returncode != 0:
            return [f"{name}: its example ends with {done.returncode}: {done.stderr.strip()}"]
    return []


def sections(text):
    """{subcommand: [lists of options]}: those of its synopses; {subcommand: text of its part}; what holds for all."""
    whole = re.search(r"^\.Sh SYNOPSIS\n(.*?)^\.Sh DESCRIPTION\n(.*?)^\.Sh ", text, re.M | re.S)
    synopsis, description = whole.groups()
    uses = {}
    for use in synopsis.split(".Nm\n")[1:]:
        name = re.match(r"\.Cm (\w+)", use)
        if name:
            uses.setdefault(name[1], []).append(use)
    common, *parts = re.split(r"^\.Ss (.*)\n", description, flags=re.M)
    return uses, dict(zip(parts[::2], parts[1::2])), common


def options(text, lead=""):
    """The options that a page names: of all its lines, or of those that begin with `lead`."""
    lines = [line for line in text.splitlines() if line.startswith(lead or ".") and "Fl " in line]
    return {name for line in lines for name in re.findall(r"(?<!\S)-\w[\w-]*|(?<=Fl )\w\b", line)}


def command_faults(command, page):
    """Options of `muslin COMMAND --help` that muslin(1) does not name, and those that it names and are not there."""
    faults = []
    uses, parts, common = sections(page.read_text())
    commands = re.findall(r"^  (\w+) ", subprocess.run([command, "--help"], capture_output=True, text=True).stdout, re.M)
    faults += [f"{page.name}: the synopsis has no {name}" for name in commands if name not in uses]
    for name in uses:
        helps = [[name]] + ([["dress", "--batch"]] if name == "dress" else [])
        texts = [subprocess.run([command, *words, "--help"], capture_output=True, text=True).stdout for words in helps]
        there = {flag[1:] for text in texts for flag in re.findall(r"^  (-[\w-]+)", text, re.M)} - {"-help"}
        part = "".join(text for title, text in parts.items() if title.split()[0] == name)
        whole = any("Ar options" in use for use in uses[name])
        shown = {flag for use in uses[name] for flag in options(use)}
        told = options(part) | options(common, ".It ")
        faults += [f"{page.name}: {name} has no option -{flag}"
                   for flag in sorted((shown | options(part, ".It ")) - there - OF_LINES)]
        if not whole:
            faults += [f"{page.name}: the synopsis of {name} lacks -{flag}" for flag in sorted(there - shown)]
        faults += [f"{page.name}: {name} does not tell -{flag}"
                   for flag in sorted(there - told - (set() if whole else shown))]
    return faults


def main():
    pages = sorted((ROOT / "man").glob("*.[0-9]"))
    declared = set()
    for header in (ROOT / "include/muslin").glob("*.h"):
        declared |= set(DECLARED.findall(header.read_text()))
    faults = lint(pages)
    named = {}
    for page in pages:
        text = page.read_text()
        for name in re.findall(r"^\.F[no] \"?(?:[\w *]* \*?)?(mus_\w+)", text, re.M):
            named.setdefault(name, page.name)
        for name, section in re.findall(r"^\.Xr (m(?:us|uslin)[\w-]*) (\d)", text, re.M):
            if not (ROOT / f"man/{name}.{section}").exists():
                faults.append(f"{page.name}: refers to {name}({section}), which is not there")
    faults += [f"{name} is in no man page" for name in sorted(declared - set(named))]
    faults += [f"{page}: {name} is declared in no header" for name, page in sorted(named.items())
               if name not in declared]
    if len(sys.argv) > 1:
        command = pathlib.Path(sys.argv[1]).resolve().parent / "bin" / "muslin"
        if command.exists():
            faults += command_faults(command, ROOT / "man" / "muslin.1")
        for page in pages:
            for text in examples(page):
                faults += run_example(page.name, text, pathlib.Path(sys.argv[1]).resolve())
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
