#!/usr/bin/env python3
"""inkscape.py: the Inkscape extensions on the distribution's Python without numpy, and in the real program under Xvfb.

One line a claim; exit 1 when one does not hold. The files stay in MUSLIN_OUT/inkscape-tried. Needs Inkscape's own
Python modules (Debian: inkscape python3-lxml), and xvfb-run for the second part.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree

import hosts

TRIED = hosts.BUILD / "inkscape-tried"
HERE = hosts.BINDINGS / "inkscape"
MODULES = pathlib.Path("/usr/share/inkscape/extensions")
PYTHON = "/usr/bin/python3"
NO_NUMPY = "import sys, runpy; sys.modules['numpy.typing'] = None; sys.path.insert(0, {here!r}); import muslin; " \
           "muslin.arrays.numpy = None; sys.argv = {argv!r}; runpy.run_path(sys.argv[0], run_name='__main__')"
held = []


def claim(holds, told):
    held.append(bool(holds))
    print(f"{'ok  ' if holds else 'FAIL'} {told}", flush=True)


def layers(path):
    names = xml.etree.ElementTree.parse(path).getroot()
    mode = "{http://www.inkscape.org/namespaces/inkscape}"
    return [group.get(f"{mode}label") for group in names if group.get(f"{mode}groupmode") == "layer"]


def as_script(name, *options):
    """(seconds, standard error) of an extension on skirt.svg; its document goes to NAME.svg."""
    argv = [str(HERE / f"{name}.py"), *map(str, options), str(HERE / "skirt.svg")]
    start = time.time()
    with open(TRIED / f"{name}.svg", "wb") as out:
        done = subprocess.run([PYTHON, "-c", NO_NUMPY.format(here=str(HERE), argv=argv)], stdout=out, timeout=300,
                              stderr=subprocess.PIPE, text=True, cwd=TRIED,
                              env={**os.environ, "PYTHONPATH": f"{MODULES}:{hosts.BINDINGS / 'python'}",
                                   "MUSLIN_LIB": str(hosts.LIB)})
    return time.time() - start, done.stderr


def scripts():
    seconds, said = as_script("muslin_draft", "--design", "tshirt")
    found = layers(TRIED / "muslin_draft.svg")
    claim(set(found) >= {"front", "back", "scale"}, f"draft: layers {found} in {seconds:.1f} s {said[:80]}")
    files = ["--glb", TRIED / "skirt.glb", "--pdf", TRIED / "skirt.pdf"]
    seconds, said = as_script("muslin_dress", *files, "--spacing", 25)
    good = "MUS_OK" in said and (TRIED / "skirt.glb").read_bytes()[:4] == b"glTF" and \
        (TRIED / "skirt.pdf").read_bytes()[:4] == b"%PDF"
    claim(good, f"dress of skirt.svg in {seconds:.1f} s: {said.splitlines()[0] if said else ''}")
    _, said = as_script("muslin_draft", "--design", "nothing")
    claim("nothing" in said and "Traceback" not in said, f"an unknown design: {said.strip()[:70]}")


def program():
    inkscape, xvfb = hosts.need("inkscape", "xvfb-run")
    profile = TRIED / "profile"
    place = profile / "extensions" / "muslin"
    place.mkdir(parents=True, exist_ok=True)
    for file in HERE.glob("muslin_*"):
        shutil.copy(file, place)
    shutil.copytree(hosts.BINDINGS / "python/muslin", place / "muslin", dirs_exist_ok=True)
    out, start = TRIED / "real.svg", time.time()
    out.unlink(missing_ok=True)
    actions = f"org.muslin.draft.noprefs;export-filename:{out};export-do;"
    command = [xvfb, "-a", inkscape, "--batch-process", f"--actions={actions}", HERE / "skirt.svg"]
    subprocess.run(command, capture_output=True, timeout=300,
                   env={**os.environ, "INKSCAPE_PROFILE_DIR": str(profile), "MUSLIN_LIB": str(hosts.LIB)})
    found = layers(out) if out.exists() else []
    claim("front" in found, f"Inkscape itself under Xvfb: layers {found} in {time.time() - start:.1f} s")


if __name__ == "__main__":
    if not (MODULES / "inkex").exists():
        print("skipped: Inkscape's Python modules are not installed")
        sys.exit(0)
    shutil.rmtree(TRIED, ignore_errors=True)
    TRIED.mkdir(parents=True)
    scripts()
    try:
        program()
    except hosts.Skipped as lack:
        print(f"skipped: {lack}")
    sys.exit(not all(held))
