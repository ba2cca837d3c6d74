"""topology.py: a pattern as a surface once its seams are glued, and what is wrong with it; what a Pattern can ask by
muslin/topology.h.
"""
from __future__ import annotations

import ctypes
from typing import Any

from . import _abi
from ._library import lib
from .context import create, make_def, read_struct

_FAULTS = {value: name[len("MUS_FAULT_"):].lower() for name, value in vars(_abi).items()
           if name.startswith("MUS_FAULT_")}


class Topology:
    """Questions about the sewn pattern: counts, openings, homology, canonical form, faults."""

    def topology(self) -> dict[str, Any]:
        """{vertices, edges, faces, euler, components, loops, orientable, manifold, genus} of the sewn pattern."""
        topology = make_def(_abi.mus_topology, lib.mus_topology_init)
        self.do("topology", ctypes.byref(topology))
        return read_struct(topology)

    def homology(self, sewn: bool = True) -> dict[str, Any]:
        """{cells, rank, betti, euler, torsion} over the integers; torsion is the list of coefficients."""
        homology = make_def(_abi.mus_homology, lib.mus_homology_init)
        self.do("homology", sewn, ctypes.byref(homology), None, 0)
        torsion = (ctypes.c_int32 * homology.torsion)()
        self.do("homology", sewn, ctypes.byref(homology), torsion, len(torsion))
        return {**read_struct(homology), "torsion": list(torsion)}

    def boundary(self, dimension: int, sewn: bool = True) -> list[tuple[int, int, int]]:
        """[(row, column, value)] of the boundary operator of edges (1) or panels (2)."""
        count = ctypes.c_int32()
        self.do("boundary", sewn, dimension, None, 0, ctypes.byref(count))
        triples = (ctypes.c_int32 * (3 * count.value))()
        self.do("boundary", sewn, dimension, triples, count.value, ctypes.byref(count))
        return [tuple(triples[i:i + 3]) for i in range(0, len(triples), 3)]

    def form(self, mirror: bool = True, labels: bool = True) -> tuple[bytes, str]:
        """(bytes, hash of 32 hex digits) of the canonical form: equal for patterns that are the same but for names,
        order, where words begin and, with mirror, a mirror image."""
        definition = make_def(_abi.mus_form_def, lib.mus_form_def_init, {"mirror": mirror, "labels": labels})
        count, hashes = ctypes.c_size_t(), (ctypes.c_uint64 * 2)()
        self.do("form", ctypes.byref(definition), None, 0, ctypes.byref(count), hashes)
        form = (ctypes.c_uint8 * count.value)()
        self.do("form", ctypes.byref(definition), form, count.value, ctypes.byref(count), hashes)
        return bytes(form), f"{hashes[0]:016x}{hashes[1]:016x}"

    def loops(self) -> list[tuple[list[int], float]]:
        """[(edges, length [m])] of the openings of the sewn pattern."""
        return [self._loop(i) for i in range(self.topology()["loops"])]

    def loop_label(self, loop: int) -> str:
        """The label that is longest round an opening of the sewn pattern."""
        label = ctypes.c_char_p()
        self.do("loop_label", loop, ctypes.byref(label))
        return label.value.decode("utf-8", "replace")

    def _loop(self, loop: int) -> tuple[list[int], float]:
        count, length = ctypes.c_int32(), ctypes.c_double()
        self.do("loop", loop, None, 0, ctypes.byref(count), ctypes.byref(length))
        edges = (ctypes.c_int32 * count.value)()
        self.do("loop", loop, edges, count.value, ctypes.byref(count), None)
        return list(edges), length.value

    def check(self) -> list[tuple[str, str]]:
        """[(kind, sentence)] of the faults; empty when the pattern is fit to cut and sew."""
        kind, found = ctypes.c_int32(), []
        with self.context.lock:
            faults = create(self.context, "faults", "mus_pattern_check", self.handle, None)
            try:
                for i in range(lib.mus_faults_count(faults)):
                    self.context.call("mus_faults_item", faults, i, ctypes.byref(kind), None, None, None)
                    found.append((_FAULTS[kind.value], lib.mus_faults_text(faults, i).decode("utf-8", "replace")))
            finally:
                lib.mus_faults_destroy(faults)
        return found
