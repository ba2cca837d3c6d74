-- tshirt.lua [DESIGN [SIZE [SPACING_MM]]]: dress a body of a table size and print the hash of the state
--
--     luajit tshirt.lua skirt M50 20
package.path = (arg[0]:match("^.*/") or "./") .. "?.lua;" .. package.path
local muslin = require("muslin")
local bit = require("bit")
local design, size, spacing = arg[1] or "tshirt", arg[2] or "W40", tonumber(arg[3] or 10)

local context = muslin.context_create()
local tape = muslin.tape_create(context)
tape:set_size(size)
tape:complete()
local body = muslin.body_create(context, tape)
local pattern = muslin.design_draft(context, muslin.design_find(design), tape)
local cloth, drape = muslin.dress(context, pattern, body, {spacing = 0.001 * spacing})

local report = muslin.new("drape_report")
drape:report_get(report)
io.stderr:write(("%s: %d of %d seams closed\n"):format(design, report.seams_closed, report.seams))
print(bit.tohex(drape:hash()))
