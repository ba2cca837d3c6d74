"""dataset.py: many dressed garments as a data set of shards: tables by pyarrow (Parquet), meshes as npz.

    from muslin.dataset import dataset
    dataset("set", [("tshirt", "W40"), ("dress neck=v", muslin.Tape.read("me.tape")), ...], shard=500, jobs=2)

writes set/shard-00000.parquet, a row a garment (design, tape, pattern, body girths, status, ease, strain, pressure,
picture, state_hash), and set/shard-00000.npz with positions, rest places and triangles one after the other; row i has
nodes first_node to first_node + nodes and triangles first_triangle to first_triangle + triangles. A garment that is not
dressed keeps its row, with the reason. A shard that is there is not made again.
"""
from __future__ import annotations

import functools
import itertools
import os
import pathlib
from concurrent.futures import ProcessPoolExecutor
from typing import TYPE_CHECKING, Any

import numpy

from .body import Body
from .context import Context
from .design import draft
from .dress import dress
from .errors import MuslinError
from .render import png_bytes, render
from .tape import Tape

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from ._types import PathLike

ARRAYS = ("positions", "rest", "triangles")


@functools.lru_cache(maxsize=16)
def _bodies(context: Context, *state: Any) -> tuple[Body, Body]:
    """The body of a tape's state, and a coarser copy for pictures: made once for many garments of a wearer."""
    body = Body(Tape._of_state(context, *state))
    return body, body.remade(samples=24, ring_spacing=0.03)


def garment(job: tuple[str, Tape, Mapping[str, Any]]) -> tuple[dict[str, Any], dict[str, Any] | None]:
    """(row, arrays or None) of one garment: a design or words, a tape, options of dress() and `picture`."""
    design, tape, options = job[0], job[1], dict(job[2])
    size = options.pop("picture", None)
    row: dict[str, Any] = {"design": design, "tape": tape.to_bytes().decode(), "status": "MUS_OK", "reason": ""}
    try:
        pattern, (body, seen) = draft(design, tape), _bodies(tape.context, *tape._state())
        row["pattern"] = pattern.to_bytes().decode()
        worn = dress(pattern, body, strict=False, **options)
    except MuslinError as error:
        return {**row, "status": error.name, "reason": error.text}, None
    row.update(status=worn.status, reason=worn.reason["text"], seconds=sum(worn.seconds.values()))
    row.update({f"body_{name}": body.made[name] for name in ("bust", "waist", "hip") if name in body.made})
    if worn.cloth is None or worn.drape is None:
        return row, None
    fit = worn.fit()
    row.update({f"ease_{level['level']}": level["ease"] for level in fit.levels if level["side"] is None})
    row.update(strain_p95=fit.spread("strain")["p95"], pressure_p95=fit.spread("pressure")["p95"],
               state_hash=worn.drape.state_hash, nodes=len(worn.drape), triangles=len(worn.cloth.triangles))
    if size:
        row["picture"] = png_bytes(render(worn.meshes(body=seen), *size))
    return row, {"positions": worn.drape.positions.astype(numpy.float32),
                 "rest": worn.cloth.rest.astype(numpy.float32), "triangles": worn.cloth.triangles.copy()}


def _write(path: pathlib.Path, made: list[tuple[dict[str, Any], dict[str, Any] | None]]) -> None:
    import pyarrow
    import pyarrow.parquet

    rows, node, triangle = [], 0, 0
    for row, arrays in made:
        rows.append({**row, "first_node": node, "first_triangle": triangle})
        if arrays is not None:
            node, triangle = node + len(arrays["positions"]), triangle + len(arrays["triangles"])
    kept = [arrays for _, arrays in made if arrays is not None]
    beside = path.with_suffix(".new")
    with open(beside, "wb") as file:
        arrays = {name: numpy.concatenate([one[name] for one in kept]) for name in ARRAYS if kept}
        numpy.savez_compressed(file, **arrays)
    os.replace(beside, path.with_suffix(".npz"))
    names = sorted(set().union(*rows))
    table = pyarrow.Table.from_pylist([{name: row.get(name) for name in names} for row in rows])
    pyarrow.parquet.write_table(table, beside, compression="zstd")
    os.replace(beside, path.with_suffix(".parquet"))  # last: the shard is there


def dataset(folder: PathLike, garments: Iterable[tuple[str, Tape | PathLike]], shard: int = 500, jobs: int = 2,
            **options: Any) -> list[pathlib.Path]:
    """Write a data set; returns the paths of its tables.

    garments: (design or words, Tape or what Tape.of() takes); the same again goes on with what is missing. options:
    those of dress() (fabric, spacing ...), and picture=(width, height) for a PNG in each row. Needs numpy and pyarrow.
    """
    out = pathlib.Path(folder)
    out.mkdir(parents=True, exist_ok=True)
    tapes: dict[str, Tape] = {}
    paths, rest = [], iter(garments)
    with ProcessPoolExecutor(jobs) as pool:
        for number in itertools.count():
            part = list(itertools.islice(rest, shard))
            if not part:
                return paths
            path = out / f"shard-{number:05d}"
            paths.append(path.with_suffix(".parquet"))
            if paths[-1].exists():
                continue
            jobs_of = [(design, wearer if isinstance(wearer, Tape) else tapes.setdefault(str(wearer), Tape.of(wearer)),
                        options) for design, wearer in part]
            _write(path, list(pool.map(garment, jobs_of, chunksize=4)))
    return paths


__all__ = ["dataset", "garment"]
