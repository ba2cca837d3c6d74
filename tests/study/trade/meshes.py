#!/usr/bin/env python3
"""A dressed T-shirt as OBJ, glTF, USD, PLY and point cache, read by other programs: `make check-glb`.

One line a claim; exit 1 when one does not hold, a line with "skipped" where a program is not there.
  own readers: names and materials of the panels, texture coordinates in the unit square, no triangle over another.
  glTF:  the Khronos validator (tests/guard/glb.sh), of the still and of the animated file.
  USD:   all validators of usd-core (PyPI, fetched into MUSLIN_OUT/hosts/usd) without a message.
  Blender: the module bpy of `make check-blender`, or that of MUSLIN_BPY: every file opens, with named panels, materials
         and texture coordinates without overlap; the point cache has the positions of the animated glTF.

    python3 tests/study/trade/meshes.py --command build/bin/muslin --out build/out/meshes
"""
import argparse
import json
import os
import pathlib
import struct
import subprocess
import sys
import venv

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
OUT = pathlib.Path(os.environ.get("MUSLIN_OUT", ROOT / "build")).resolve()
PANELS = ["front", "back", "sleeve_left", "sleeve_right"]
FRAMES = 4
HELD = []


def claim(holds, told):
    HELD.append(bool(holds))
    print(f"{'ok  ' if holds else 'FAIL'} {told}", flush=True)


def overlaps(uv, triangles):
    """Number of triangles whose middle lies inside another triangle of the texture."""
    a, b, c = (uv[triangles[:, k]] for k in range(3))
    middle, count = (a + b + c) / 3, 0
    cross = lambda p, q, m: (q[:, 0] - p[:, 0]) * (m[1] - p[:, 1]) - (q[:, 1] - p[:, 1]) * (m[0] - p[:, 0])
    for m in middle:
        sides = np.stack((cross(a, b, m), cross(b, c, m), cross(c, a, m)))
        count += int(((sides > 0).all(0) | (sides < 0).all(0)).sum()) - 1
    return count


def told_uv(name, uv, triangles):
    uv, triangles = np.asarray(uv), np.asarray(triangles)
    low, high, over = uv.min(), uv.max(), overlaps(uv, triangles)
    a, b, c = (uv[triangles[:, k]] for k in range(3))
    area = np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]).sum() / 2
    claim(low >= -1e-6 and high <= 1 + 1e-6 and over == 0,
          f"{name}: texture from {low:.4f} to {high:.4f}, {over} of {len(triangles)} triangles over another, "
          f"{100 * area:.0f} % of the square used")


def read_obj(path):
    """{object: {group: (material, triangles)}}, texture coordinates, lines of the group seams."""
    uv, groups, lines, materials, at = [], {}, 0, set(), [None, None, None]
    for line in path.read_text().splitlines():
        words = line.split()
        if words[0] == "mtllib":
            materials = {w.split()[1] for w in (path.parent / words[1]).read_text().splitlines() if w[:6] == "newmtl"}
        elif words[0] == "vt":
            uv.append([float(w) for w in words[1:]])
        elif words[0] in ("o", "g", "usemtl"):
            kind = ("o", "g", "usemtl").index(words[0])
            at[kind:] = [words[1]] + [None] * (2 - kind)
        elif words[0] == "f":
            groups.setdefault(tuple(at), []).append([int(w.split("/")[1] or 0) - 1 for w in words[1:]])
        elif words[0] == "l":
            lines += 1
    return uv, groups, lines, materials


def own(folder):
    uv, groups, lines, materials = read_obj(folder / "still.obj")
    garment = {g: (m, t) for (o, g, m), t in groups.items() if o == "garment"}
    claim(list(garment) == PANELS and all(m == f"jersey.{g}" and m in materials for g, (m, _) in garment.items()),
          f"OBJ: groups {', '.join(garment)}, each with a material of the .mtl; {lines} lines along seams")
    told_uv("OBJ", uv, [t for _, triangles in garment.values() for t in triangles])
    data = (folder / "still.glb").read_bytes()
    scene = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])
    names = [node["name"] for node in scene["nodes"]]
    sets = {key for mesh in scene["meshes"] for part in mesh["primitives"] for key in part["attributes"]}
    claim(names == ["body", "garment", *PANELS, "seams"] and {"TEXCOORD_0", "TEXCOORD_1"} <= sets and
          scene["meshes"][-1]["primitives"][0]["mode"] == 1,
          f"glTF: nodes {', '.join(names)}; {', '.join(sorted(sets))}; seams as lines")


def validated(folder):
    for name in ("still", "walk"):
        done = subprocess.run(["sh", ROOT / "tests/guard/glb.sh", folder / f"{name}.glb"], capture_output=True, text=True)
        if done.stdout.startswith("skipped"):
            print(done.stdout.strip())
            return
        claim(done.returncode == 0, f"glTF {name}: Khronos validator, {done.stdout.strip().split(': ')[-1]}")


USD = """
import json, sys
from pxr import Usd, UsdValidation
told = {}
for path in sys.argv[1:]:
    stage = Usd.Stage.Open(path)
    checks = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    errors = UsdValidation.ValidationContext(checks).Validate(stage)
    told[path] = [len(checks), [error.GetMessage() for error in errors],
                  [prim.GetName() for prim in stage.Traverse() if prim.GetTypeName() in ("Mesh", "BasisCurves")],
                  stage.GetEndTimeCode() - stage.GetStartTimeCode()]
print(json.dumps(told))
"""


def usd(folder):
    home = OUT / "hosts" / "usd"
    python = home / "bin" / "python"
    if not python.exists():
        venv.create(home, with_pip=True)
    if subprocess.run([python, "-c", "import pxr"], capture_output=True).returncode != 0:
        if subprocess.run([python, "-m", "pip", "install", "-q", "usd-core"], capture_output=True).returncode != 0:
            print("skipped: usd-core could not be fetched from PyPI")
            return
    done = subprocess.run([python, "-c", USD, folder / "still.usda", folder / "walk.usda"], capture_output=True, text=True)
    if done.returncode != 0:
        claim(False, f"USD: {done.stderr.strip().splitlines()[-1]}")
        return
    for path, (checks, errors, names, codes) in json.loads(done.stdout).items():
        frames = f", {codes:.0f} frames on" if codes else ""
        claim(not errors and names == ["body", *PANELS, "seams"],
              f"USD {pathlib.Path(path).stem}: {checks} validators, {len(errors)} messages {errors[:2] or ''}; prims "
              f"{', '.join(names)}{frames}")


def cache(folder):
    data = (folder / "walk.pc2").read_bytes()
    nodes, frames = struct.unpack_from("<4xi8xi", data, 12)
    claim(len(data) == 32 + 12 * nodes * frames and frames == FRAMES, f"PC2: {nodes} nodes in {frames} frames")


def blender(folder):
    python = pathlib.Path(os.environ.get("MUSLIN_BPY", OUT / "hosts" / "blender")) / "bin" / "python"
    if not python.exists():
        print("skipped: no bpy (`make check-blender` fetches it; MUSLIN_BPY names an environment that has it)")
        return
    done = subprocess.run([python, __file__, "--blender", folder], capture_output=True, text=True)
    lines = [line for line in done.stdout.splitlines() if line[:4] in ("ok  ", "FAIL")]
    print("\n".join(lines) or done.stderr[-800:], flush=True)
    HELD.extend([line.startswith("ok") for line in lines] or [False])


def triangles_of(thing):
    """Texture coordinates of the corners of a Blender mesh, and its triangles as indices of corners."""
    mesh = thing.data
    mesh.calc_loop_triangles()
    uv = np.empty(2 * len(mesh.loops))
    mesh.uv_layers[0].data.foreach_get("uv", uv)
    return uv.reshape(-1, 2), np.array([triangle.loops[:] for triangle in mesh.loop_triangles])


def inside_blender(folder):
    import bpy
    readers = {"obj": lambda path: bpy.ops.wm.obj_import(filepath=path, use_split_groups=True),
               "glb": lambda path: bpy.ops.import_scene.gltf(filepath=path),
               "usda": lambda path: bpy.ops.wm.usd_import(filepath=path),
               "ply": lambda path: bpy.ops.wm.ply_import(filepath=path)}
    for form, read in readers.items():
        bpy.ops.wm.read_factory_settings(use_empty=True)
        read(str(folder / f"still.{form}"))
        things = {thing.name.split(".")[0]: thing for thing in bpy.data.objects if thing.type == "MESH"}
        whole = form == "ply"
        chosen = list(things.values()) if whole else [things[name] for name in PANELS if name in things]
        corners, triangles, first = [], [], 0
        for thing in chosen:
            uv, faces = triangles_of(thing)
            if whole:  # the body has no texture: its part is 0
                part = np.array([v.value for v in thing.data.attributes["part"].data])
                index = np.array([loop.vertex_index for loop in thing.data.loops])
                faces = faces[part[index[faces[:, 0]]] > 0]
            corners.append(uv), triangles.append(faces + first)
            first += len(uv)
        named = sorted({slot.material.name for thing in chosen for slot in thing.material_slots if slot.material})
        claim(len(chosen) == (1 if whole else len(PANELS)) and (whole or len(named) == len(PANELS)),
              f"Blender {form}: {', '.join(sorted(things))}; materials {', '.join(named)}")
        told_uv(f"Blender {form}", np.concatenate(corners), np.concatenate(triangles))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(folder / "walk.glb"))
    moved = []
    bpy.context.scene.render.fps = 60
    data = np.frombuffer((folder / "walk.pc2").read_bytes()[32:], "<f4").reshape(FRAMES, -1, 3)
    keys = bpy.data.objects["front"].data.shape_keys.key_blocks
    last = np.empty(3 * len(keys[0].data))
    keys[-1].data.foreach_get("co", last)
    last = last.reshape(-1, 3)
    wanted = data[-1][:len(last)]
    off = float(np.abs(np.sort(last[:, 0]) - np.sort(wanted[:, 0])).max())
    moved = float(np.abs(data[-1] - data[0]).max())
    claim(off < 1e-5 and moved > 1e-3 and len(keys) == FRAMES + 1,
          f"Blender walk: {len(keys) - 1} shape keys; the last is that of the point cache within {1000 * off:.4f} mm, "
          f"{1000 * moved:.1f} mm from the first")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--command", default=OUT / "bin" / "muslin")
    parser.add_argument("--out", type=pathlib.Path, default=OUT / "out" / "meshes")
    parser.add_argument("--blender", type=pathlib.Path)
    asked = parser.parse_args()
    if asked.blender is not None:
        inside_blender(asked.blender)
        return 0
    folder = asked.out.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    dress = [asked.command, "dress", "--design", "tshirt", "--tape", ROOT / "examples/tapes/w40.tape", "--spacing", "20",
             "--quiet"]
    for name, more in (("still", ["obj", "glb", "usda", "ply"]), ("walk", ["glb", "usda", "pc2"])):
        files = [word for form in more for word in (f"--{form}", folder / f"{name}.{form}")]
        walk = ["--move", "walk", "--count", str(FRAMES)] if name == "walk" else []
        done = subprocess.run([*dress, *files, *walk], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr)
    own(folder)
    cache(folder)
    validated(folder)
    usd(folder)
    blender(folder)
    print(f"{sum(HELD)} of {len(HELD)} hold")
    return 0 if all(HELD) else 1


if __name__ == "__main__":
    sys.exit(main())
