#!/usr/bin/env python3
"""blender.py: the Blender extension in the module bpy: dress, dress again, a walk of 48 frames, glTF, a picture.

Then the zip of `make wheel extensions`: validated, and built again, by Blender's own builder of extensions.
One line a claim; exit 1 when one does not hold. Runs itself in an environment with bpy (0.9 GB, from PyPI), made in
MUSLIN_OUT/hosts/blender, or in that of MUSLIN_BPY. The .blend, the .glb and the picture stay in
MUSLIN_OUT/blender-tried.
"""
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import time
import traceback
import venv
import zipfile

import hosts

HOME = pathlib.Path(os.environ.get("MUSLIN_BPY", hosts.OUT / "blender")).resolve()
TRIED = hosts.BUILD / "blender-tried"
WORD = {True: "ok  ", False: "FAIL"}


def picture(bpy, path):
    """What a camera in front sees, by Cycles on the processor."""
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.samples, scene.cycles.device = "CYCLES", 8, "CPU"
    scene.render.resolution_x, scene.render.resolution_y = 300, 450
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location, camera.rotation_euler = (1.2, -4.0, 1.1), (1.53, 0, 0.29)
    lamp = bpy.data.objects.new("lamp", bpy.data.lights.new("lamp", "SUN"))
    lamp.data.energy, lamp.rotation_euler = 4.0, (0.9, 0.2, 0.4)
    for thing in (camera, lamp):
        bpy.context.collection.objects.link(thing)
    scene.camera, scene.render.filepath = camera, str(path)
    bpy.ops.render.render(write_still=True)


def packed(bpy):
    """Whether Blender's builder takes the zip, and makes one of the same files; None where there is no zip."""
    made = hosts.BUILD / "extensions/muslin-blender.zip"
    builder = pathlib.Path(bpy.utils.resource_path("LOCAL"), "scripts/addons_core/bl_pkg/cli/blender_ext.py")
    if not made.exists() or not builder.exists():
        print("skipped: bpy has no builder" if made.exists() else "skipped: there is no zip; make wheel extensions")
        return None
    source = TRIED / "extension"
    shutil.rmtree(source, ignore_errors=True)
    with zipfile.ZipFile(made) as files:
        files.extractall(source)
        names = set(files.namelist())
    said = hosts.run(sys.executable, builder, "validate", made)
    hosts.run(sys.executable, builder, "build", "--source-dir", source, "--output-filepath", TRIED / "again.zip")
    with zipfile.ZipFile(TRIED / "again.zip") as files:
        again = set(files.namelist())
    print(f"{WORD[again == names]} Blender's builder: {said.splitlines()[-1]}; built again of {len(again)} files")
    return again == names


def main():
    import bpy
    import importlib.util
    spec = importlib.util.spec_from_file_location("muslin_blender", hosts.BINDINGS / "blender/__init__.py")
    extension = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(extension)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    extension.register()
    settings, held = bpy.context.scene.muslin, []

    def claim(holds, told):
        held.append(bool(holds))
        print(f"{WORD[bool(holds)]} {told}", flush=True)

    start = time.time()
    bpy.ops.muslin.dress()
    shirt, body = bpy.data.objects["muslin tshirt"], bpy.data.objects["muslin body"]
    layers = shirt.data.uv_layers["pattern_m"].data
    uv = max(abs(point.uv[i]) for point in layers for i in (0, 1))
    whole = "panel" in shirt.data.attributes and len(shirt.data.materials) == 1
    claim(len(shirt.data.vertices) > 1000 and whole and 0.1 < uv < 3,
          f"dressed in {time.time() - start:.1f} s: {len(shirt.data.vertices)} nodes, UV to {uv:.2f} m, "
          f"{len(bpy.data.objects['muslin tshirt seams'].data.edges)} seam pairs")
    start, settings.spacing, settings.fabric = time.time(), 22.0, "jersey"
    bpy.ops.muslin.dress()
    claim(len(bpy.data.objects) == 3, f"dressed again where it hangs in {time.time() - start:.1f} s")
    try:
        settings.design = "no such design"
        bpy.ops.muslin.dress()
        claim(False, "an unknown design is refused")
    except RuntimeError as error:
        claim("no such design" in str(error), f"refused: {str(error).strip()[:60]}")
    settings.design, start = "tshirt", time.time()
    TRIED.mkdir(parents=True, exist_ok=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(TRIED / "walk.blend"))
    settings.frames = 48
    bpy.ops.muslin.walk()
    spent = time.time() - start
    cache = (TRIED / "muslin_tshirt.pc2").read_bytes()
    count, frames = struct.unpack("<i", cache[16:20])[0], struct.unpack("<i", cache[28:32])[0]
    bpy.context.scene.frame_set(30)
    for between in ("muslin seams", "muslin finer", "muslin outside"):
        shirt.modifiers[between].show_viewport = False
    shown = shirt.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices[5].co
    stored = struct.unpack_from("<3f", cache, 32 + (29 * count + 5) * 12)
    off = max(abs(a - b) for a, b in zip(shown, stored))
    claim(frames == 48 and off < 1e-5,
          f"walk of {frames} frames in {spent:.1f} s; frame 30 shows the cache within {off:.0e} m")
    bpy.ops.export_scene.gltf(filepath=str(TRIED / "dressed.glb"), export_animations=False)
    data = (TRIED / "dressed.glb").read_bytes()
    claim(data[:4] == b"glTF", f"glTF of {len(data) / 1e6:.1f} MB")
    picture(bpy, TRIED / "walk.png")
    claim((TRIED / "walk.png").exists(), f"picture {TRIED / 'walk.png'}")
    settings.wearer, settings.spacing, settings.size = body, 25.0, "W40"
    bpy.context.scene.frame_set(1)
    body.modifiers.clear()  # the wearer is the mesh as it stands, not the one that walks
    extension.KEPT.clear()
    bpy.ops.muslin.dress()
    claim(True, "dressed on a mesh of Blender's, as a scan")
    extension.unregister()
    return all(held) and packed(bpy) is not False


if __name__ == "__main__":
    python = HOME / "bin/python"
    if pathlib.Path(sys.prefix).resolve() != HOME:
        if not python.exists():
            venv.create(HOME, with_pip=True)
            hosts.fetch.install(python, "-m", "pip", "install", "-q", "bpy", "numpy", made=HOME)
        os.environ.update(PYTHONPATH=str(hosts.BINDINGS / "python"), MUSLIN_LIB=str(hosts.LIB))
        sys.exit(subprocess.run([python, __file__], timeout=550).returncode)
    code = 1
    try:
        code = 0 if main() else 1
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        os._exit(code)  # an error that Blender's own end meets would hang
