"""dress_cffi.py HEADER LIBRARY DESIGN SIZE SPACING: the state hash of a dressed design, by cffi and the flat header
alone."""
import pathlib
import sys

import cffi

header, library, design, size, spacing = sys.argv[1:]
ffi = cffi.FFI()
ffi.cdef(pathlib.Path(header).read_text())
muslin = ffi.dlopen(library)


def made(kind, create, *arguments):
    out = ffi.new(f"{kind} **")
    assert create(*arguments, out) == muslin.MUS_OK
    return out[0]


context = made("mus_context", muslin.mus_context_create, ffi.NULL)
tape = made("mus_tape", muslin.mus_tape_create, context)
assert muslin.mus_tape_set_size(tape, size.encode()) == muslin.MUS_OK
assert muslin.mus_tape_complete(tape) == muslin.MUS_OK
body = made("mus_body", muslin.mus_body_create, context, tape, ffi.NULL)
pattern = made("mus_pattern", muslin.mus_design_draft, context, muslin.mus_design_find(design.encode()), tape, ffi.NULL)

options = ffi.new("mus_dress_def *")
muslin.mus_dress_def_init(options, ffi.sizeof("mus_dress_def"))
options.spacing = float(spacing)
drape = made("mus_drape", muslin.mus_dress, context, pattern, body, options, ffi.NULL, ffi.NULL, ffi.NULL)
print(f"{muslin.mus_drape_hash(drape):016x}")

muslin.mus_drape_destroy(drape)
muslin.mus_pattern_destroy(pattern)
muslin.mus_body_destroy(body)
muslin.mus_tape_destroy(tape)
assert muslin.mus_context_bytes(context) == 0
muslin.mus_context_destroy(context)
