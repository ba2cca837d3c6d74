"""One garment in many sizes on all cores: sizes.py [DESIGN] [SIZE ...] prints a line each.

Tapes, patterns and bodies travel to the other processes by pickle, and give the same state there.
"""
from __future__ import annotations

import sys
from concurrent.futures import ProcessPoolExecutor

import muslin


def state(garment: tuple[muslin.Pattern, muslin.Body]) -> str:
    """State hash of a pattern that is sewn on a body."""
    pattern, body = garment
    dressed = muslin.dress(pattern, body, spacing=0.03)
    assert dressed.drape is not None
    return dressed.drape.state_hash


def main(design: str = "tshirt", *sizes: str) -> None:
    names = list(sizes) or ["W36", "W40", "W44", "W48"]
    tapes = [muslin.Tape.size(name) for name in names]
    garments = [(muslin.draft(design, tape), muslin.Body(tape)) for tape in tapes]
    with ProcessPoolExecutor(2) as pool:
        for name, there, here in zip(names, pool.map(state, garments), map(state, garments)):
            print(f"{design} {name} {there} {'equal' if there == here else 'DIFFERS'}")


if __name__ == "__main__":
    main(*sys.argv[1:])
