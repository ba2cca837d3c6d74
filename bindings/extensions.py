#!/usr/bin/env python3
"""extensions.py: the extensions for Inkscape and Blender as zip files in MUSLIN_OUT/extensions, around the wheel.

muslin-inkscape.zip is unpacked into Inkscape's folder of user extensions (Edit > Preferences > System);
muslin-blender.zip is installed from disk by Blender (Preferences > Get Extensions). Needs the wheel: make wheel.
"""
import os
import pathlib
import sys
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
BUILD = pathlib.Path(os.environ.get("MUSLIN_OUT", HERE.parent / "build")).resolve()
OUT = BUILD / "extensions"


def main():
    wheel = next(BUILD.glob("wheel/muslin-*.whl"), None)
    if wheel is None:
        sys.exit("extensions.py: there is no wheel; make wheel")
    OUT.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(OUT / "muslin-inkscape.zip", "w", zipfile.ZIP_DEFLATED) as made:
        for file in sorted((HERE / "inkscape").glob("muslin_*")):
            made.write(file, f"muslin/{file.name}")
        with zipfile.ZipFile(wheel) as packed:
            for name in packed.namelist():
                if name.split("/")[0] in ("muslin", "muslin.libs"):
                    made.writestr(f"muslin/{name}", packed.read(name))
    manifest = (HERE / "blender/blender_manifest.toml").read_text()
    manifest = manifest.replace("VERSION", wheel.name.split("-")[1]).replace("WHEEL", wheel.name)
    with zipfile.ZipFile(OUT / "muslin-blender.zip", "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr("blender_manifest.toml", manifest)
        made.write(HERE / "blender/__init__.py", "__init__.py")
        made.write(wheel, f"wheels/{wheel.name}")
    for file in sorted(OUT.glob("*.zip")):
        print(f"{file}  {file.stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
