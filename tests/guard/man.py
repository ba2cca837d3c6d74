#!/usr/bin/env python3
"""man.py [LIBFOLDER]: the pages against the headers, both ways, and against mandoc.

Every public function stands in a .Fn or .Fo of some page in man/; every mus_ function named there is declared; every
.Xr of a mus page has its page; mandoc -Tlint -Wstyle is silent. With LIBFOLDER, each example that has a main() is
compiled, linked with the archives there and run in an empty folder: it must end with 0.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
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
    packages = subprocess.run(["pkg-config", "--libs", "cairo", "jansson", "yaml-0.1", "expat",
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
        for page in pages:
            for text in examples(page):
                faults += run_example(page.name, text, pathlib.Path(sys.argv[1]).resolve())
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
