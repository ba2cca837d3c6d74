#!/usr/bin/env python3
"""build.py: the fitting room, a folder of files that any web server can hand out: MUSLIN_OUT/web; and the npm package
muslin, MUSLIN_OUT/npm.

clang and lld compile the core, lib/print and parts of lib/exchange to WebAssembly with wasi-libc; esbuild bundles the
page with three.js (from npm, once). Nothing is written into the repository.
"""
import gzip
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import fetch  # noqa: E402

ROOT = HERE.parents[1]
BUILD = pathlib.Path(os.environ.get("MUSLIN_OUT", ROOT / "build")).resolve()
OUT, WORK, NPM = BUILD / "web", BUILD / "web-work", BUILD / "npm"
LEFT_OUT = {"catalogue", "scan", "exchange", "sewing", "meshfile", "trade", "seam", "valentina"}  # rooms of lib/
EXCHANGE = ("file_read", "tape_file", "tape_csv", "pattern_json_write")  # what of lib/exchange needs no outside library
CAIRO = {"lib/paperfile/pdf.c", "lib/drawing/lettering_pango.c", "lib/drawing/lettering_strokes.c"}  # its calls, or Pango's
INSTEAD = {"lib/base/thread_pool.c"}  # src/thread_pool_single.c stands for it
FLAGS = ["--target=wasm32-wasi", "-msimd128", "-mnontrapping-fptoint", "-msign-ext",  # all browsers have them
         "-fno-math-errno", "-ffp-contract=off", "-std=c11", "-DNDEBUG", "-Wall", "-Wextra",
         "-DMUS_STROKES_ONLY", "-DMUS_ENGLISH_ONLY", "-fvisibility=hidden",
         "-ffunction-sections", "-fdata-sections", "-include", str(HERE / "src/absent.h"),
         f"-I{HERE / 'src'}", f"-I{ROOT / 'include'}", f"-I{ROOT / 'lib'}"]
# rooms of lib/ where a garment's time goes; the others are compiled for size, and the answers are the same at any level
FAST = {"base", "body", "cloth", "contact", "drape", "dress", "geom", "integrate", "limb", "selfcontact", "sim"}
PACKAGES = {"three": "^0.180.0", "esbuild": "^0.25.0"}
LARGEST = 700_000  # bytes of all files together, compressed


def program(*names):
    found = next((path for path in map(shutil.which, names) if path), None)
    if found is None:
        sys.exit(f"build.py: {names[0]} is missing; apt-get install clang lld wasi-libc libclang-rt-14-dev-wasm32 "
                 "npm")
    return found


def sources():
    rooms = [room for room in sorted((ROOT / "lib").iterdir()) if room.is_dir() and room.name not in LEFT_OUT]
    files = [file for room in rooms for file in sorted(room.glob("*.c")) if str(file.relative_to(ROOT)) not in INSTEAD]
    return files + [ROOT / f"lib/exchange/{name}.c" for name in EXCHANGE] + sorted((HERE / "src").glob("*.c"))


def compile_one(clang, file):
    """The object of a file, made again when what it was made of has changed."""
    made = WORK / f"{file.relative_to(ROOT)}.o".replace("/", "_")
    rules = made.with_suffix(".d")
    if made.exists() and rules.exists():
        needed = rules.read_text().replace("\\\n", " ").split(":", 1)[1].split()
        if all(os.path.exists(path) and os.path.getmtime(path) <= made.stat().st_mtime for path in needed):
            return made
    level = "-O3" if file.parent.name in FAST else "-Os"
    subprocess.run([clang, level, *FLAGS, "-MMD", "-MF", rules, "-c", file, "-o", made], check=True)
    return made


def module():
    """Build room.wasm."""
    clang = program("clang-14", "clang")
    program("wasm-ld-14", "wasm-ld")
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(lambda file: compile_one(clang, file), sources()))
    subprocess.run([clang, "--target=wasm32-wasi", "-mexec-model=reactor", "-Wl,--gc-sections,-s,-z,stack-size=4194304",
                    *objects, "-lm", "-o", OUT / "room.wasm"], check=True)


def natively():
    """Link what the module is made of with this machine's compiler and the objects of `make`: a room that needs
    what the page leaves out, or a call of cairo that src/ does not have, is found in seconds and without clang."""
    objects, given = [], []
    for file in sources():
        ours = file.parent == HERE / "src" or file.relative_to(ROOT).as_posix() in CAIRO
        given += [file] if ours else []
        objects += [] if ours else [BUILD / "obj" / file.relative_to(ROOT).with_suffix(".o")]
    WORK.mkdir(parents=True, exist_ok=True)
    shared = ["-shared", "-fPIC", "-Wl,--no-undefined,--defsym,host_progress=0", "-lm", "-o", WORK / "room.so"]
    ours = [flag for flag in FLAGS if flag.startswith(("-I", "-DMUS"))]
    subprocess.run([program("cc"), "-std=c11", "-w", *ours, *given, *objects, *shared], check=True)
    print(f"build.py: {len(given) + len(objects)} files make the page's module, by {program('cc')}")


def page():
    """Bundle the page and its worker; sw.js gets the list of files and a version of their bytes."""
    modules = WORK / "node_modules"
    if not (modules / "esbuild").exists():
        (WORK / "package.json").write_text(json.dumps({"private": True, "dependencies": PACKAGES}))
        fetch.install(program("npm"), "install", "--no-audit", "--no-fund", cwd=WORK, made=modules)
    for name in ("page.js", "worker.js", "scene.js"):
        subprocess.run([modules / ".bin/esbuild", HERE / "page" / name, "--bundle", "--minify", "--format=esm",
                        "--log-level=warning", f"--outfile={OUT / name}"], check=True,
                       env={**os.environ, "NODE_PATH": str(modules)})
    for name in ("index.html", "page.css", "manifest.webmanifest", "icon.svg"):
        shutil.copy(HERE / "page" / name, OUT)
    files = sorted(file for file in OUT.iterdir() if file.name != "sw.js")
    version = hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()[:12]
    script = (HERE / "page/sw.js").read_text()
    (OUT / "sw.js").write_text(script.replace("VERSION", version).replace("FILES", json.dumps([f.name for f in files])))


def package():
    """The npm package: the module and its object, for Node and for other people's pages."""
    shutil.rmtree(NPM, ignore_errors=True)
    shutil.copytree(HERE / "npm", NPM)
    shutil.copy(HERE / "page/room.js", NPM)
    shutil.copy(ROOT / "LICENSE", NPM)
    shutil.copy(OUT / "room.wasm", NPM / "muslin.wasm")


def main():
    if sys.argv[1:] == ["--natively"]:
        return natively()
    for folder in (OUT, WORK):
        folder.mkdir(parents=True, exist_ok=True)
    module()
    if sys.argv[1:] != ["--module"]:
        page()
    package()
    total = 0
    for file in sorted(OUT.iterdir()):
        packed = len(gzip.compress(file.read_bytes(), 9))
        total += packed
        print(f"{file.name:22} {file.stat().st_size:9} bytes, {packed:8} compressed (gzip)")
    print(f"{'all':22} {sum(f.stat().st_size for f in OUT.iterdir()):9} bytes, {total:8} compressed; {OUT}")
    if total > LARGEST:
        sys.exit(f"build.py: more than {LARGEST} bytes")


if __name__ == "__main__":
    main()
