"""slider.py: what the two chosen numbers of the friction of bending move: the curvature at which a slider slips, and
the steps between two moves of the sliders.

The library is built once more for each value, with the files that hold these numbers compiled anew; the discs of the
fabrics that have a measured loop then hang in each.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
FILES = ("cloth/fabric", "sim/bend_slider", "sim/sim_f32")  # a disc is stepped in float
FLAGS = "-std=c11 -Iinclude -Ilib -fPIC -fvisibility=hidden -pthread -O3 -fno-math-errno -ffp-contract=off".split()
# (macro, values; that of the library is among them)
CHOSEN = (("MUS__SLIDE_CURVATURE", (2.5, 5.0, 10.0, 25.0)), ("MUS__SLIDE_STEPS", (1, 8, 64)))
FABRICS = ("broadcloth", "polyester")


def build(archive, folder, macro, value):
    """The shared library in `folder` with the macro at this value."""
    folder.mkdir(parents=True, exist_ok=True)
    own = folder / archive.name
    shutil.copy(archive, own)
    compiler = os.environ.get("CC", "cc").split()
    for name in FILES:
        part = folder / f"{name.split('/')[1]}.o"
        subprocess.run([*compiler, *FLAGS, f"-D{macro}={value}", "-c", f"lib/{name}.c", "-o", str(part)], cwd=ROOT,
                       check=True)
        subprocess.run(["ar", "r", str(own), str(part)], check=True)
    shared = folder / "libmuslin.so"
    subprocess.run([*compiler, "-shared", "-pthread", "-o", str(shared), "-Wl,--whole-archive", str(own),
                    "-Wl,--no-whole-archive", "-lm"], check=True)
    return shared


def measured(library, spacing, starts):
    """{fabric: mean coefficient [%]} of that library, in a process of its own."""
    text = subprocess.run([sys.executable, __file__, str(spacing), str(starts)], check=True, capture_output=True,
                          text=True, env={**os.environ, "MUSLIN_LIB": str(library)}).stdout
    return json.loads(text)


def rows(archive, out, spacing, starts):
    """[(macro, value, {fabric: coefficient})]; spacing [m]."""
    for macro, values in CHOSEN:
        for value in values:
            library = build(archive, out / f"{macro}-{value}", macro, value)
            yield macro, value, measured(library, spacing, starts)


def main():
    import cusick
    import muslin
    spacing, starts = float(sys.argv[1]), int(sys.argv[2])
    means = {}
    for name in FABRICS:
        fabric = muslin.Fabric(name, damping=0.0)
        means[name] = sum(cusick.measure(fabric, spacing, start)[0] for start in range(starts)) / starts
    print(json.dumps(means))


if __name__ == "__main__":
    main()
