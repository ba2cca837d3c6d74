# JSON.jl: the one call that Muslin.jl makes of the package JSON, for systems that cannot fetch it. It reads
# muslin_abi.json: no numbers but decimal ones, and no characters beyond those of UCS-2.
module JSON

mutable struct Text
    bytes::Vector{UInt8}
    at::Int
end

here(text) = Char(text.bytes[text.at])
step(text) = (text.at += 1; Char(text.bytes[text.at - 1]))

function skip(text, set)
    while text.at <= length(text.bytes) && here(text) in set
        text.at += 1
    end
end

function word(text)
    made = IOBuffer()
    step(text)
    while here(text) != '"'
        if here(text) != '\\'
            write(made, text.bytes[text.at])
            text.at += 1
            continue
        end
        step(text)
        sign = step(text)
        if sign == 'u'
            print(made, Char(parse(UInt16, String(text.bytes[text.at:text.at + 3]), base = 16)))
            text.at += 4
        else
            print(made, get(Dict('n' => '\n', 't' => '\t', 'r' => '\r'), sign, sign))
        end
    end
    step(text)
    return String(take!(made))
end

# the values up to `last`, each by `one`
function list(text, last, one)
    values = Any[]
    step(text)
    while (skip(text, " \t\r\n,"); here(text) != last)
        push!(values, one(text))
    end
    step(text)
    return values
end

function member(text)
    name = word(text)
    skip(text, " \t\r\n:")
    return name => value(text)
end

function value(text)
    skip(text, " \t\r\n")
    sign = here(text)
    sign == '{' && return Dict{String,Any}(list(text, '}', member))
    sign == '[' && return list(text, ']', value)
    sign == '"' && return word(text)
    start = text.at
    skip(text, "+-.0123456789abcdefghijklmnopqrstuvwxyzE")
    name = String(text.bytes[start:text.at - 1])
    name in ("true", "false") && return name == "true"
    name == "null" && return nothing
    whole = tryparse(Int, name)
    return whole === nothing ? parse(Float64, name) : whole
end

parsefile(path) = value(Text(read(path), 1))

end
