"""
The C interface of muslin. It reads `muslin_abi.json`, so that it knows every function: `Muslin.design_draft` is
`mus_design_draft`. Beyond the plain C call

  * a status that is not MUS_OK is thrown as a `MuslinError` with status, name and the library's sentence;
  * objects that C gives through pointers (`mus_tape **out`) are results, and are freed by the collector;
  * a named tuple stands for options: `(spacing = 0.02,)` is a `mus_dress_def` with its defaults and this spacing;
  * text comes as a `String`, `nothing` is NULL. Arguments that are left out at the end are `nothing`.

A struct that a call fills is a `Ref`: `report = Ref(Muslin.defaults(Muslin.mus_drape_report))`. Lengths are metres.
"""
module Muslin

using JSON, Libdl

const ABI_FILE = let
    tried = [get(ENV, "MUSLIN_ABI_JSON", ""), joinpath(@__DIR__, "..", "..", "abi", "muslin_abi.json"),
             "/usr/local/share/muslin/muslin_abi.json", "/usr/share/muslin/muslin_abi.json"]
    found = findfirst(isfile, tried)
    found === nothing && error("muslin_abi.json was not found: $(join(tried, ", "))")
    tried[found]
end
include_dependency(ABI_FILE)
const ABI = JSON.parsefile(ABI_FILE)

# ---- the libraries: MUSLIN_LIB (file or folder), the build folder of the repository, the system's ----

const OPENED = Dict{String,Ptr{Cvoid}}()

function open_library(name)
    get!(OPENED, name) do
        named = get(ENV, "MUSLIN_LIB", "")
        built = joinpath(@__DIR__, "..", "..", "..", "build", "lib")
        folder = isempty(named) ? built : isdir(named) ? named : dirname(named)
        path = joinpath(folder, "$name.so")
        dlopen(isfile(path) ? path : "$name.so.$(ABI["abi"])")
    end
end

address(name) = dlsym(open_library(ABI["functions"][name]["library"]), name)

# ---- constants, structs ----

for (name, value) in ABI["constants"]
    @eval const $(Symbol(name)) = $(Int32(value))
end

const SCALARS = Dict("mus_status" => Int32, "int32_t" => Int32, "int64_t" => Int64, "uint64_t" => UInt64,
                     "uint8_t" => UInt8, "size_t" => Csize_t, "double" => Float64, "float" => Float32, "char" => UInt8,
                     "int" => Cint, "void" => Cvoid)

base(type) = strip(replace(replace(type, "const" => ""), "*" => ""))
pointer_depth(type) = count(==('*'), type)
scalar(type) = get(SCALARS, type, Ptr{Cvoid}) # pointers, handles and callbacks are addresses

for (name, struct_) in ABI["structs"]
    fields = map(struct_["fields"]) do field
        type = scalar(field["type"])
        for length in reverse(get(field, "array", []))
            type = NTuple{length,type}
        end
        :($(Symbol(field["name"]))::$type)
    end
    @eval struct $(Symbol(name))
        $(fields...)
    end
    @eval @assert sizeof($(Symbol(name))) == $(struct_["size"])
end

"""Options or a report of type `T` with its defaults, its size, and the given fields."""
function defaults(::Type{T}; fields...) where {T}
    made = Ref{T}()
    ccall(address("$(nameof(T))_init"), Cvoid, (Ptr{Cvoid}, Csize_t), made, sizeof(T))
    T((get(values(fields), name, getfield(made[], name)) for name in fieldnames(T))...)
end

# ---- errors, and objects with their contexts ----

struct MuslinError <: Exception
    status::Int32
    name::String
    text::String
end
Base.showerror(io::IO, error::MuslinError) = print(io, error.name, ": ", error.text)

mutable struct State # of a context: freed after the last of its objects, in whatever order the collector ends them
    context::Ptr{Cvoid}
    count::Int
    lock::ReentrantLock
end

mutable struct Handle{Kind}
    pointer::Ptr{Cvoid}
    state::State
end
Base.unsafe_convert(::Type{Ptr{Cvoid}}, handle::Handle) = handle.pointer

function said(status, context)
    about(name) = unsafe_string(ccall(address(name), Cstring, (Int32,), status))
    sentence = context == C_NULL ? "" : unsafe_string(ccall(address("mus_context_error"), Cstring, (Ptr{Cvoid},), context))
    MuslinError(status, about("mus_status_name"), isempty(sentence) ? about("mus_status_text") : sentence)
end

"""Free an object now. The collector calls it for objects that are forgotten."""
function destroy(handle::Handle{Kind}) where {Kind}
    handle.pointer == C_NULL && return
    if !trylock(handle.state.lock) # another thread is in a call with this context: later
        finalizer(destroy, handle)
        return
    end
    try
        Kind === :mus_context || ccall(address("$(Kind)_destroy"), Cvoid, (Ptr{Cvoid},), handle.pointer)
        handle.pointer = C_NULL
        handle.state.count -= 1
        handle.state.count == 0 && ccall(address("mus_context_destroy"), Cvoid, (Ptr{Cvoid},), handle.state.context)
    finally
        unlock(handle.state.lock)
    end
    nothing
end

function own(kind, pointer, state)
    pointer == C_NULL && return nothing
    state === nothing && (state = State(pointer, 0, ReentrantLock()))
    state.count += 1
    handle = Handle{kind}(pointer, state)
    finalizer(destroy, handle)
    handle
end

# ---- calls ----

given(value, type) = value
given(::Nothing, type) = C_NULL
given(value::NamedTuple, type) = Ref(defaults(getfield(Muslin, Symbol(base(type))); value...))

isout(type) = pointer_depth(type) == 2 && base(type) in ABI["handles"]
isobject(type) = pointer_depth(type) == 1 && base(type) in ABI["handles"]

for (name, about) in ABI["functions"]
    endswith(name, "_destroy") && continue
    types = [argument["type"] for argument in about["arguments"]]
    outs = about["result"] == "mus_status" ? findall(isout, types) : Int[]
    symbols = [Symbol("a", i) for i in eachindex(types)]
    text(type) = type == "const char *"
    ctypes = [text(type) ? Cstring : scalar(type) for type in types]
    result = text(about["result"]) ? Cstring : scalar(about["result"])
    inputs = [symbols[i] for i in eachindex(types) if !(i in outs)]
    # an object at the first place is needed, and what stands before a number; the pointers after it may be left out
    needed = something(findlast(type -> haskey(SCALARS, type), types), isempty(types) || !isobject(types[1]) ? 0 : 1)
    parameters = [i > needed ? Expr(:kw, s, nothing) : s for (i, s) in enumerate(symbols) if !(i in outs)]
    prepare = [i in outs ? :($s = Ref{Ptr{Cvoid}}(C_NULL)) :
               text(types[i]) ? :($s = $s === nothing ? Cstring(C_NULL) : $s) : :($s = given($s, $(types[i])))
               for (i, s) in enumerate(symbols)]
    made = [:(own($(QuoteNode(Symbol(base(types[i])))), $(symbols[i])[], state)) for i in outs]
    @eval function $(Symbol(name[5:end]))($(parameters...))
        state = nothing
        for one in ($(inputs...),)
            one isa Handle && one.pointer == C_NULL && error("this object is destroyed")
            one isa Handle && state === nothing && (state = one.state)
        end
        $(prepare...)
        state === nothing || lock(state.lock)
        try
            back = ccall(address($name), $result, ($(ctypes...),), $(symbols...))
            made = ($(made...),)
            $(if about["result"] == "mus_status"
                :(back == 0 || throw(said(back, state === nothing ? C_NULL : state.context));
                  return length(made) == 1 ? made[1] : isempty(made) ? nothing : made)
            elseif result === Cstring
                :(return back == C_NULL ? nothing : unsafe_string(back))
            else
                :(return back)
            end)
        finally
            state === nothing || unlock(state.lock)
        end
    end
end

end
