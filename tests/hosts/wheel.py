#!/usr/bin/env python3
"""wheel.py [chroot]: the wheel and the source distribution of bindings/python, tried in clean environments.

With `chroot` alone the source distribution is built by pip in a fresh system of this machine's release, with the
compiler and libraries of its packages and nothing of this machine (needs root and mmdebstrap).

One line a claim with its figure; exit 1 when one does not hold. The files are those of MUSLIN_OUT/wheel (make wheel).
Packages come from PyPI. The notebook's picture and the executed notebook stay in MUSLIN_OUT/wheel/tried.
"""
import base64
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import time
import venv

import hosts

HERE = hosts.BUILD / "wheel"
TRIED = HERE / "tried"
EXAMPLES = hosts.BINDINGS / "python" / "examples"
BARE = """
import sys, muslin
assert "numpy" not in sys.modules and muslin.arrays.numpy is None
shirt = muslin.dress("tshirt", "W40", spacing=0.03, progress=True)  # without tqdm there is no bar
mesh = muslin.Mesh("shirt", shirt.drape.positions, shirt.cloth.triangles)  # the views handed back
shirt.drape.set_state(shirt.drape.positions, shirt.drape.velocities)
assert shirt._repr_png_() is None and shirt.pattern._repr_svg_().startswith("<")
muslin.Sheet(shirt.pattern).write_pdf("shirt.pdf")
print(shirt.drape.state_hash)
"""
LOOPS = """
import gc, muslin
def resident(): return int(open("/proc/self/statm").read().split()[1]) * 4096
def loop():
    shirt = muslin.dress("tshirt", "W40", spacing=0.05)
    shirt.fit().levels, shirt.picture(60, 90), muslin.Sheet(shirt.pattern).pdf_bytes(), shirt.pattern.copy()
for _ in range(20): loop()
gc.collect(); first = resident()
for _ in range(200): loop()
gc.collect(); print((resident() - first) / 1e6)
"""
EXTRAS = """
import pathlib, sys, muslin
tape = muslin.Tape.size("W40")
tape.write(pathlib.Path("w40.tape"))
shirt = muslin.dress("tshirt", pathlib.Path("w40.tape"), spacing=0.03, progress=True)
assert "tqdm" in sys.modules
garment = shirt.meshes()[-1].to_trimesh()
assert type(garment).__module__.startswith("trimesh") and len(garment.vertices) == len(shirt.drape)
table = shirt.fit().to_pandas()
assert type(table).__name__ == "DataFrame" and "ease" in table and len(table) == len(shirt.fit().levels)
shirt.pattern.write(pathlib.Path("tshirt.json"))
muslin.Sheet(muslin.Pattern.read(pathlib.Path("tshirt.json"))).write_pdf(pathlib.Path("tshirt.pdf"))
muslin.write_glb(pathlib.Path("tshirt.glb"), shirt.meshes())
page = shirt.view().page()
assert "model-viewer" in page and "data:model/gltf-binary;base64," in page and "data:image/png" in page
print(f"trimesh {len(garment.faces)} faces, pandas {table.shape[0]} levels, tqdm, Path, a model that turns "
      f"({len(page) / 1e6:.1f} MB)")
"""
NOTEBOOK = """
import sys, time, nbformat, nbclient
notebook = nbformat.read(sys.argv[1], 4)
client, start, times = nbclient.NotebookClient(notebook, timeout=300), time.time(), []
client.on_cell_executed = lambda cell, cell_index, execute_reply: times.append(time.time() - start)
client.execute()
nbformat.write(notebook, sys.argv[2])
print(times[0], times[-1])
"""
SYSTEM = ["python3", "python3-pip", "gcc", "make", "pkg-config", "libcairo2-dev", "libjansson-dev", "libyaml-dev",
          "libexpat1-dev", "libsqlite3-dev"]
BUILDERS = ["setuptools>=77"]
claims = {"held": 0, "failed": 0}


def claim(holds, told):
    claims["held" if holds else "failed"] += 1
    print(f"{'ok  ' if holds else 'FAIL'} {told}", flush=True)


def clean(name, *packages):
    """The Python of a new environment with the packages, and seconds that it took."""
    start = time.time()
    venv.create(TRIED / name, clear=True, with_pip=True)
    python = TRIED / name / "bin" / "python"
    hosts.fetch.install(python, "-m", "pip", "install", "-q", *packages)
    return python, time.time() - start


def plain(python, *arguments):
    """What Python prints in the folder TRIED with nothing of the repository in its environment."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("MUSLIN", "PYTHON"))}
    done = subprocess.run([str(python), *map(str, arguments)], cwd=TRIED, env=kept, capture_output=True, text=True,
                          timeout=1500)
    if done.returncode != 0:
        raise RuntimeError(done.stderr or done.stdout)
    return done.stdout.strip()


def without_numpy(wheel):
    python, seconds = clean("bare", wheel)
    start = time.time()
    state, want = plain(python, "-c", BARE), hosts.by_command()
    claim(state == want, f"clean environment without numpy ({seconds:.1f} s): state {state}, the command's {want}; "
                         f"{time.time() - start:.1f} s")


def with_all(wheel):
    python, seconds = clean("full", f"muslin[notebook] @ file://{wheel}", "nbclient", "ipykernel", "mypy")
    notebook = TRIED / "ten_minutes.ipynb"
    first, last = map(float, plain(python, "-c", NOTEBOOK, EXAMPLES / "ten_minutes.ipynb", notebook).split())
    cells = [cell for cell in json.loads(notebook.read_text())["cells"] if cell["cell_type"] == "code"]
    picture = base64.b64decode(cells[0]["outputs"][0]["data"]["image/png"])
    (TRIED / "first.png").write_bytes(picture)
    claim(first < 60, f"notebook: first picture after {first:.1f} s ({len(picture)} bytes), all of it {last:.1f} s")
    claim(True, plain(python, "-c", EXTRAS))
    grown = float(plain(python, "-c", LOOPS))
    claim(grown < 4, f"200 loops of dress, fit, picture, sheet: {grown:+.2f} MB")
    lines = plain(python, EXAMPLES / "sizes.py").splitlines()
    claim(all(line.endswith(" equal") for line in lines), f"{len(lines)} garments through ProcessPoolExecutor: equal")
    for name in ("tshirt", "drawn"):
        claim(True, f"examples/{name}.py: {plain(python, EXAMPLES / f'{name}.py').splitlines()[0]}")
    said = plain(python, "-m", "mypy", "--strict", *sorted(EXAMPLES.glob("*.py")))
    claim("no issues" in said, f"mypy --strict: {said}")


def refuses(sdist):
    """A source distribution whose sources were taken away."""
    with tarfile.open(sdist) as packed:
        packed.extractall(TRIED / "sdist")
    folder, = (TRIED / "sdist").iterdir()
    size = sum(file.stat().st_size for file in (folder / "source").rglob("*") if file.is_file())
    shutil.rmtree(folder / "source")
    kept = {name: value for name, value in os.environ.items() if name != "MUSLIN_LIB"}
    done = subprocess.run([str(HERE / "tools/bin/python"), "setup.py", "bdist_wheel"], cwd=folder, env=kept,
                          capture_output=True, text=True)
    said = done.stderr.strip().splitlines()[-1]
    claim(done.returncode != 0 and said.startswith("muslin: neither the sources"),
          f"without its sources ({size / 1e6:.1f} MB) the source distribution says: {said[:60]}...")


def in_chroot(sdist):
    """The source distribution in a fresh system without a network: pip builds and installs it, and it dresses."""
    lines = pathlib.Path("/etc/os-release").read_text().splitlines()
    release = dict(line.split("=", 1) for line in lines if "=" in line)
    mmdebstrap, = hosts.need("mmdebstrap")
    system, start = TRIED / "system", time.time()
    shutil.rmtree(system, ignore_errors=True)
    TRIED.mkdir(exist_ok=True)
    hosts.run(mmdebstrap, "--variant=apt", f"--include={','.join(SYSTEM)}", release["VERSION_CODENAME"], system)
    made = time.time()
    hosts.fetch.install(sys.executable, "-m", "pip", "download", "-q", "--no-deps", "-d", system / "tmp", *BUILDERS)
    shutil.copy(sdist, system / "tmp")
    hosts.run("chroot", system, "pip", "install", "-q", "--no-index", "--find-links", "/tmp", "--break-system-packages",
              f"/tmp/{sdist.name}")
    built = time.time()
    state = hosts.run("chroot", system, "python3", "-c", BARE.replace("progress=True", ""), MUSLIN_LIB="")
    shutil.rmtree(system)
    claim(state == hosts.by_command(), f"source distribution in a fresh {release['VERSION_CODENAME']} (made in "
          f"{made - start:.0f} s): built and installed by pip in {built - made:.0f} s, state {state}")


def main():
    sdist, = HERE.glob("*.tar.gz")
    if sys.argv[1:] == ["chroot"]:
        in_chroot(sdist)
        return claims["failed"] > 0
    wheel, = HERE.glob("*.whl")
    shutil.rmtree(TRIED, ignore_errors=True)
    TRIED.mkdir()
    claim(wheel.stat().st_size < 4e6, f"{wheel.name}: {wheel.stat().st_size / 1e6:.2f} MB")
    without_numpy(wheel)
    with_all(wheel)
    refuses(sdist)
    print(f"{claims['held']} passed, {claims['failed']} failed")
    return claims["failed"] > 0


if __name__ == "__main__":
    sys.exit(main())
