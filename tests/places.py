"""Where things are: the repository, the built programs (MUSLIN_BIN), the real data (MUSLIN_DATA)."""
import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[1]
BIN = pathlib.Path(os.environ.get("MUSLIN_BIN", ROOT / "build" / "bin")).resolve()
DATA = pathlib.Path(os.environ.get("MUSLIN_DATA", ROOT.parent / "shared" / "data")).resolve()
