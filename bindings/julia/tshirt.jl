# tshirt.jl [DESIGN [SIZE [SPACING_MM]]]: dress a body of a table size and print the hash of the state
#
#     julia --project=bindings/julia bindings/julia/tshirt.jl skirt M50 20
using Muslin

design, size, spacing = [ARGS; ["tshirt", "W40", "10"][length(ARGS)+1:end]]

context = Muslin.context_create()
tape = Muslin.tape_create(context)
Muslin.tape_set_size(tape, size)
Muslin.tape_complete(tape)
body = Muslin.body_create(context, tape)
pattern = Muslin.design_draft(context, Muslin.design_find(design), tape)
cloth, drape = Muslin.dress(context, pattern, body, (spacing = 0.001 * parse(Float64, spacing),))

report = Ref(Muslin.defaults(Muslin.mus_drape_report))
Muslin.drape_report_get(drape, report)
println(stderr, "$design: $(report[].seams_closed) of $(report[].seams) seams closed")
println(string(Muslin.drape_hash(drape), base = 16, pad = 16))
