-- muslin.lua: the C interface of muslin for LuaJIT. It reads muslin_flat.h, so that it knows every function.
--
-- muslin.NAME is mus_NAME, and object:NAME is mus_KIND_NAME of the object's kind. Beyond the plain C call
--   * a status that is not MUS_OK is raised, as a table {status, name, text} that prints as a sentence;
--   * objects that C gives through pointers (mus_tape **out) are results, and are freed by the collector;
--   * a table stands for options: {spacing = 0.02} is a mus_dress_def with its defaults and this spacing;
--   * text comes as a Lua string; a Lua function stands for a progress function, true stops the run.
-- Arguments that are left out at the end are nil. Constants are muslin.MUS_*. Arrays are those of ffi.new.
local ffi = require("ffi")

local muslin = {}
local here = debug.getinfo(1, "S").source:match("^@(.*/)") or "./"

-- ---- the header and the libraries ----

local function open_header()
    local tried = {os.getenv("MUSLIN_FLAT_H") or here .. "../abi/muslin_flat.h", here .. "muslin_flat.h",
                   "/usr/local/share/muslin/muslin_flat.h", "/usr/share/muslin/muslin_flat.h"}
    for _, path in ipairs(tried) do
        local file = io.open(path)
        if file then return file:read("*a") end
    end
    error("muslin_flat.h was not found: " .. table.concat(tried, ", "))
end

-- MUSLIN_LIB (file or folder), the build folder of the repository, the system's libraries
local function open_library(part)
    local named = os.getenv("MUSLIN_LIB")
    local file = "libmuslin" .. part .. ".so"
    local tried = named and {named .. "/" .. file, (named:match("^.*/") or "./") .. file}
        or {here .. "../../build/lib/" .. file, file .. ".1", file}
    for _, path in ipairs(tried) do
        local ok, library = pcall(ffi.load, path, true)
        if ok then return library end
    end
    error(file .. " was not found: set MUSLIN_LIB, run make in the repository, or install it")
end

local header = open_header()
ffi.cdef(header)
local handles, functions = {}, {}
for kind in header:gmatch("typedef struct mus_(%w+) mus_%1;") do
    if header:find("void mus_" .. kind .. "_destroy(", 1, true) then handles[kind] = true end
end
do
    local part = ""
    for line in header:match("/%* libmuslin %*/.*"):gmatch("[^\n]+") do
        part = line:match("^/%* libmuslin(.-) %*/") or part
        local result, name, arguments = line:match("^(.-)mus_([%w_]+)%((.*)%);$")
        if name then
            functions[name] = {part = part, result = result:match("^(.-)%s*$"), arguments = {}}
            for kind in arguments:gmatch("([^,]-%s%**)[%w_]+%s*%f[,%z]") do
                table.insert(functions[name].arguments, (kind:gsub("^%s+", ""):gsub("%s+$", "")))
            end
        end
    end
end
local libraries = setmetatable({}, {__index = function(all, part)
    all[part] = open_library(part)
    return all[part]
end})

-- ---- errors, and objects with their contexts ----

local Error = {__tostring = function(error) return error.name .. ": " .. error.text end}
local owners = setmetatable({}, {__mode = "k"}) -- of an object: its context, what counts its kin, what frees it

local function check(status, owner)
    if status == 0 then return end
    local text = owner and ffi.string(libraries[""].mus_context_error(owner.context)) or ""
    if text == "" then text = ffi.string(libraries[""].mus_status_text(status)) end
    local name = ffi.string(libraries[""].mus_status_name(status))
    error(setmetatable({status = status, name = name, text = text}, Error), 0)
end

-- the context is freed after the last of its objects, in whatever order the collector ends them
local function release(state)
    state.count = state.count - 1
    if state.count == 0 then libraries[""].mus_context_destroy(state.context) end
end

local function own(kind, pointer, owner)
    if pointer == nil then return nil end
    local state = kind == "context" and {context = pointer, count = 0} or owner.state
    state.count = state.count + 1
    local destroy = kind ~= "context" and libraries[functions[kind .. "_destroy"].part]["mus_" .. kind .. "_destroy"]
    local object = ffi.gc(pointer, function(dead)
        if destroy then destroy(dead) end
        release(state)
    end)
    owners[object] = {context = state.context, state = state, finish = destroy or function() end}
    return object
end

-- muslin.KIND_destroy: frees an object now, which the collector then leaves alone
local function destroy(object)
    local owned = object ~= nil and owners[object]
    if not owned then return end
    ffi.gc(object, nil)
    owners[object] = nil
    owned.finish(object)
    release(owned.state)
end

-- ---- calls ----

-- options or a report: the struct with its defaults, then `fields`; muslin.new("dress_def", {spacing = 0.02})
function muslin.new(name, fields)
    local made = ffi.new("mus_" .. name)
    libraries[functions[name .. "_init"].part]["mus_" .. name .. "_init"](made, ffi.sizeof(made))
    for field, value in pairs(fields or {}) do made[field] = value end
    return made
end

local function progress_hook(progress, raised)
    return ffi.cast("mus_progress_fn", function(_, at)
        local ok, stop = pcall(progress, at)
        if not ok then raised.value = stop end
        return (not ok or stop) and 1 or 0
    end)
end

local function wrap(name)
    local f = functions[name] or error("muslin has no function mus_" .. name, 3)
    if name:find("_destroy$") then return destroy end
    local c = libraries[f.part]["mus_" .. name]
    local count = #f.arguments
    local function call(...)
        local given, values, outs, raised, hook, owner = {...}, {}, {}, {}, nil, nil
        local next_given = 1
        for i, kind in ipairs(f.arguments) do
            local made = f.result == "mus_status" and kind:match("^mus_(%w+) %*%*$")
            if made and handles[made] then
                values[i] = ffi.new("mus_" .. made .. " *[1]")
                table.insert(outs, {made, values[i]})
            else
                local value = given[next_given]
                next_given = next_given + 1
                owner = owner or owners[value or false]
                if type(value) == "table" and kind:match("mus_") then
                    value = muslin.new(kind:match("mus_([%w_]+)"), value)
                elseif type(value) == "function" and kind == "mus_progress_fn" then
                    hook = progress_hook(value, raised)
                    value = hook
                end
                values[i] = value
            end
        end
        local result = c(unpack(values, 1, count))
        if hook then hook:free() end
        local made = {}
        for i, out in ipairs(outs) do made[i] = own(out[1], out[2][0], owner) end
        if raised.value then error(raised.value, 0) end
        if f.result == "mus_status" then
            check(result, owner)
            return unpack(made, 1, #outs)
        elseif f.result == "const char *" then
            return result ~= nil and ffi.string(result) or nil
        elseif f.result ~= "void" then
            return result
        end
    end
    jit.off(call) -- it may be called back
    return call
end

setmetatable(muslin, {__index = function(all, name)
    local value = name:match("^MUS_") and libraries[""][name] or not name:match("^MUS_") and wrap(name)
    all[name] = value
    return value
end})

for kind in pairs(handles) do
    ffi.metatype("mus_" .. kind, {__index = function(_, name) return muslin[kind .. "_" .. name] end})
end

return muslin
