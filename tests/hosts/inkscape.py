#!/usr/bin/env python3
"""inkscape.py: the Inkscape extensions on the distribution's Python without numpy, and in the real program under Xvfb.

One line a claim; exit 1 when one does not hold. The files stay in MUSLIN_OUT/inkscape-tried. Needs Inkscape's own
Python modules (Debian: inkscape python3-lxml), and xvfb-run for the second part.
"""
import json
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


def boxes(path, old):
    """Boxes [low x, low y, high x, high y] of the first `old` things that are drawn and of those after them, by inkex in
    the document's units; None without any."""
    code = "import sys, json, inkex\nfor thing in inkex.load_svg(sys.argv[1]).getroot():\n" \
           "    box = thing.bounding_box() if isinstance(thing, inkex.ShapeElement) else None\n" \
           "    if box is not None: print(json.dumps([box.left, box.top, box.right, box.bottom]))"
    done = subprocess.run([PYTHON, "-c", code, path], capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": str(MODULES)})
    every = [json.loads(line) for line in done.stdout.splitlines()]
    both = every if old is None else every[:old], [] if old is None else every[old:]
    return [[min(b[0] for b in each), min(b[1] for b in each), max(b[2] for b in each), max(b[3] for b in each)]
            if each else None for each in both] + [len(every)]


def as_script(name, *options, document=HERE / "skirt.svg"):
    """(seconds, standard error) of an extension on a document; what it makes of it goes to NAME.svg."""
    argv = [str(HERE / f"{name}.py"), *map(str, options), str(document)]
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
    _, _, count = boxes(HERE / "skirt.svg", None)
    old, new, _ = boxes(TRIED / "muslin_draft.svg", count)
    claim(old and new and new[0] > old[2], f"the draft lies right of the drawing: {new[0]:.0f} is beyond {old[2]:.0f}")
    empty = TRIED / "empty.svg"
    empty.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="210mm" height="297mm" viewBox="0 0 210 297"/>')
    as_script("muslin_draft", "--design", "tshirt", document=empty)
    _, new, _ = boxes(TRIED / "muslin_draft.svg", 0)
    page = [float(n) for n in
            xml.etree.ElementTree.parse(TRIED / "muslin_draft.svg").getroot().get("viewBox").split()]
    claim(new[0] >= page[0] and new[1] >= page[1] and new[2] <= page[0] + page[2] and new[3] <= page[1] + page[3],
          f"in an empty document the page is as large as the draft: {page[2]:.0f} x {page[3]:.0f} mm")
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
