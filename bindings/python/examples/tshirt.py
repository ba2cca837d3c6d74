"""A T-shirt for a person: tshirt.py [TAPE or SIZE] [FOLDER] writes a picture, a model and the pattern to cut."""
from __future__ import annotations

import pathlib
import sys

import muslin


def main(wearer: str = "W40", folder: str = ".") -> None:
    out = pathlib.Path(folder)
    tape = muslin.Tape.of(wearer)
    tshirt = muslin.dress("tshirt", tape, fabric="jersey", spacing=0.02)
    assert tshirt.drape is not None
    print(f"{tshirt.pattern.name}: {len(tshirt.drape)} nodes, state {tshirt.drape.state_hash}")
    for level in tshirt.fit().levels:
        print(f"  {level['level']:8} body {100 * level['body']:6.1f} cm, garment {100 * level['garment']:6.1f} cm")
    (out / "tshirt.png").write_bytes(muslin.png_bytes(tshirt.picture(yaw=30.0)))
    muslin.write_glb(out / "tshirt.glb", tshirt.meshes())
    muslin.Sheet(tshirt.pattern, paper="a4", title="T-shirt", person=tape.name).write_pdf(out / "tshirt.pdf")


if __name__ == "__main__":
    main(*sys.argv[1:3])
