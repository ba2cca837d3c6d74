-- dress.lua HEADER LIBRARY DESIGN SIZE SPACING: the state hash of a dressed design, by LuaJIT and the flat header alone
local ffi = require("ffi")
local bit = require("bit")
local header, library, design, size, spacing = ...
ffi.cdef(assert(io.open(header)):read("*a"))
local muslin = ffi.load(library)

local function made(kind, create, ...)
    local out = ffi.new(kind .. " *[1]")
    local arguments = {...}
    arguments[#arguments + 1] = out
    assert(create(unpack(arguments)) == muslin.MUS_OK)
    return out[0]
end

local context = ffi.new("mus_context *[1]")
assert(muslin.mus_context_create(nil, context) == muslin.MUS_OK)
context = context[0]
local tape = made("mus_tape", muslin.mus_tape_create, context)
assert(muslin.mus_tape_set_size(tape, size) == muslin.MUS_OK)
assert(muslin.mus_tape_complete(tape) == muslin.MUS_OK)
local body, pattern = ffi.new("mus_body *[1]"), ffi.new("mus_pattern *[1]")
assert(muslin.mus_body_create(context, tape, nil, body) == muslin.MUS_OK)
assert(muslin.mus_design_draft(context, muslin.mus_design_find(design), tape, nil, pattern) == muslin.MUS_OK)

local def = ffi.new("mus_dress_def")
muslin.mus_dress_def_init(def, ffi.sizeof(def))
def.spacing = tonumber(spacing)
local drape = ffi.new("mus_drape *[1]")
local status = muslin.mus_dress(context, pattern[0], body[0], def, nil, nil, nil, drape)
assert(status == muslin.MUS_OK, ffi.string(muslin.mus_context_error(context)))
print(bit.tohex(muslin.mus_drape_hash(drape[0])))

muslin.mus_drape_destroy(drape[0])
muslin.mus_pattern_destroy(pattern[0])
muslin.mus_body_destroy(body[0])
muslin.mus_tape_destroy(tape)
assert(muslin.mus_context_bytes(context) == 0)
muslin.mus_context_destroy(context)
