-- objects.lua PACKAGE_PATH FILE: failures are raised, options are tables, callbacks stop a run, nothing leaks
package.path = arg[1] .. ";" .. package.path
local muslin = require("muslin")

local function fails(words, f, ...)
    local ok, failure = pcall(f, ...)
    assert(not ok and tostring(failure):find(words, 1, true), tostring(failure))
    return failure
end

local context = muslin.context_create()
local tape = muslin.tape_create(context)
local waist = muslin.measure_find("waist")
assert(fails("780.0 cm", tape.set, tape, waist, 7.8, muslin.MUS_SOURCE_GIVEN).name == "MUS_ERR_TAPE")
fails("no function mus_nonsense", function() return muslin.nonsense end)
tape:set_size("W40")
tape:complete()

local body = muslin.body_create(context, tape)
local pattern = muslin.design_draft(context, muslin.design_find("skirt"), tape, {ease = 0.02})
assert(pattern:name() == "skirt" and pattern:panel_count() == 2)
pattern:write(arg[2]) -- of libmuslin-exchange
assert(muslin.pattern_read(context, arg[2]):panel_count() == 2)

local cloth = muslin.cloth_create(context, pattern, {spacing = 0.04})
local drape = muslin.drape_create(context, cloth, body, {progress_seconds = 0})
drape:place()
fails("mine", drape.sew, drape, function() error("mine") end)
assert(fails("", drape.sew, drape, function() return true end).status == muslin.MUS_ERR_STOPPED)
local calls = 0
drape:sew(function() calls = calls + 1 end)
assert(calls > 0)

cloth:destroy() -- at once; the rest by the collector
tape, body, pattern, cloth, drape = nil, nil, nil, nil, nil
collectgarbage()
collectgarbage()
assert(context:bytes() == 0)

-- a context lives as long as its objects, and the end of the program frees all that is left in any order
local last = muslin.tape_create(muslin.context_create())
collectgarbage()
last:set_size("W40")
context:destroy()
