#!/usr/bin/env python3
"""web.py [states | refit | package | page]: the fitting room of MUSLIN_OUT/web (make web) in Node and in Chromium.

60 garments in WebAssembly against the library: equal state hashes. What a moved slider costs. The npm package, packed
and installed: the command's hash, and its types under TypeScript. Then the browser: ready, three designs, a dragged
slider, files (PDF by qpdf, glb by the validator where it is installed), no network, axe-core. Pictures stay in
MUSLIN_OUT/web-tried. With a word one part alone.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import threading

import hosts

sys.path[:0] = [str(hosts.BINDINGS / "web"), str(hosts.BINDINGS / "python")]
os.environ.setdefault("MUSLIN_LIB", str(hosts.LIB))
import serve  # noqa: E402  (needs the path above)

TRIED = hosts.BUILD / "web-tried"
SPACING = 0.035
CASES = 60
PACKAGES = {"playwright-core": "^1.50.0", "axe-core": "^4.10.0"}


def states():
    """How many of CASES garments have the native state hash in WebAssembly."""
    import muslin
    fits = {"women": "W40", "men": "M50", "children": "C116"}
    rows = muslin.designs()
    pairs = [(row["name"], fits[row["groups"][0]]) for row in rows[::len(rows) // CASES]][:CASES]
    node, = hosts.need("node")
    done = subprocess.run([node, hosts.ROOT / "tests/hosts/web_states.mjs", serve.FOLDER / "room.wasm",
                           hosts.BINDINGS / "web/page/room.js", str(SPACING)], capture_output=True, text=True,
                          input="".join(f"{design} {size}\n" for design, size in pairs))
    if done.returncode != 0:
        sys.exit(done.stderr)
    equal, other = 0, []
    for (design, size), line in zip(pairs, done.stdout.splitlines()):
        worn = muslin.dress(design, size, spacing=SPACING, strict=False)
        same = worn.drape is not None and worn.drape.state_hash == line.split()[2]
        equal += same
        other += [] if same else [design]
    print(f"{'ok  ' if equal == len(pairs) else 'FAIL'} {equal} of {len(pairs)} garments have the native state hash"
          f"{'; not: ' + ', '.join(other) if other else ''}", flush=True)
    return equal == len(pairs)


def refit():
    """CPU milliseconds from a moved slider to the first picture and to rest, in Node."""
    node, = hosts.need("node")
    held = True
    for line in hosts.run(node, hosts.ROOT / "tests/hosts/web_refit.mjs", serve.FOLDER / "room.wasm",
                          hosts.BINDINGS / "web/page/room.js", "tshirt", "skirt", "jeans", "shirt").splitlines():
        design, nodes, *taken = line.split()
        body, draft, cut, settle = map(float, taken)
        first, rest = body + draft + cut, body + draft + cut + settle
        held &= first < 60 and rest < 400
        print(f"{'ok  ' if first < 60 and rest < 400 else 'FAIL'} {design}, {nodes} nodes, bust moved by 1 mm: picture "
              f"after {first:.0f} CPU ms (body {body:.0f}, draft {draft:.0f}, cut {cut:.0f}; aim 60), rest after "
              f"{rest:.0f} (aim 400), medians of 30")
    return held


def package():
    """The packed npm package where a stranger installs it."""
    node, npm = hosts.need("node", "npm")
    folder = hosts.BUILD / "npm-tried"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    packed = hosts.run(npm, "pack", "--silent", "--pack-destination", folder, cwd=hosts.BUILD / "npm").splitlines()[-1]
    size = (folder / packed).stat().st_size
    design, fit, spacing = hosts.SCENE
    (folder / "package.json").write_text(json.dumps({"private": True, "type": "module"}))
    hosts.fetch.install(npm, "install", "--no-audit", "--no-fund", folder / packed, "typescript@5", cwd=folder)
    (folder / "one.ts").write_text(f"""import {{ open }} from "muslin";
const room = await open();
room.size("{fit}");
room.body();
room.draft("{design}");
const status: number = room.sew({int(spacing) / 1000});
const mesh = room.clothMesh();
if (status !== 0 || mesh.positions.length !== 3 / 2 * mesh.rest.length) throw new Error(`status ${{status}}`);
console.log(room.hash);
""")
    hosts.run(folder / "node_modules/.bin/tsc", "--strict", "--target", "es2022", "--module", "nodenext", "--lib",
              "es2022,dom", "one.ts", cwd=folder)
    found = hosts.run(node, "one.js", cwd=folder)
    good = found == hosts.by_command()
    print(f"{'ok  ' if good else 'FAIL'} npm package, {size} bytes: types hold under tsc --strict, state {found}")
    return good


def pdf():
    """The PDF that the page gave: qpdf, and its square of 100 mm."""
    path, sound = TRIED / "out.pdf", True
    if shutil.which("qpdf"):
        done = subprocess.run(["qpdf", "--check", path], capture_output=True, text=True)
        sound = done.returncode == 0
        print(f"{'ok  ' if sound else 'FAIL'} qpdf --check: {done.stdout.strip().splitlines()[-1]}")
    points = 100 / 25.4 * 72
    found = 0
    for x, y, rest in re.findall(rb"([\d.-]+) ([\d.-]+) m\n((?:[\d.-]+ [\d.-]+ l\n){3,4})", path.read_bytes()):
        corners = [(float(x), float(y))] + [tuple(map(float, line.split()[:2])) for line in rest.splitlines()]
        width, height = (max(c[i] for c in corners) - min(c[i] for c in corners) for i in (0, 1))
        found += abs(width - points) < 0.01 and abs(height - points) < 0.01
    print(f"{'ok  ' if found else 'FAIL'} {found} squares of 100 mm in the PDF, within 0.004 mm")
    return sound and found > 0


def glb():
    path = TRIED / "out.glb"
    data = path.read_bytes()
    length = int.from_bytes(data[12:16], "little")
    tree = json.loads(data[20:20 + length])
    done = subprocess.run(["sh", hosts.ROOT / "tests/guard/glb.sh", path], capture_output=True, text=True)
    said = done.stdout.strip().splitlines()[-1].split(": ")[-1]
    good = done.returncode == 0 and len(tree["meshes"]) == 2
    print(f"{'ok  ' if good else 'FAIL'} glb: {len(tree['meshes'])} meshes, {len(data)} bytes; the validator: {said}")
    return good


def browser():
    node, npm = hosts.need("node", "npm")
    if not shutil.which("chromium") and "CHROMIUM" not in os.environ:
        raise hosts.Skipped("chromium is not installed (or CHROMIUM does not name it)")
    TRIED.mkdir(parents=True, exist_ok=True)
    if not (TRIED / "node_modules/axe-core").exists():
        (TRIED / "package.json").write_text(json.dumps({"private": True, "dependencies": PACKAGES}))
        hosts.fetch.install(npm, "install", "--no-audit", "--no-fund", cwd=TRIED, made=TRIED / "node_modules")
    for old in TRIED.glob("out.*"):
        old.unlink()
    made = serve.server()
    threading.Thread(target=made.serve_forever, daemon=True).start()
    url = f"http://127.0.0.1:{made.server_address[1]}/"
    tape = hosts.ROOT / "examples/tapes/w40.tape"
    done = subprocess.run([node, hosts.ROOT / "tests/hosts/web.mjs", url, TRIED, tape])
    return done.returncode == 0 and all([pdf(), glb()])


def main():
    if not (serve.FOLDER / "room.wasm").exists():
        sys.exit("web.py: the fitting room is not built; make web")
    parts = {"states": states, "refit": refit, "package": package, "page": browser}
    held = []
    for name in sys.argv[1:] or parts:
        try:
            held.append(parts[name]())
        except hosts.Skipped as lack:
            print(f"skipped: {name}: {lack}")
    return not all(held)


if __name__ == "__main__":
    sys.exit(main())
