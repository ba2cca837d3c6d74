/*
 * worn_note.c: the record mus_worn: its defaults, the names of its kinds, and the first reason why a garment is not
 * worn.
 */
#include <stdio.h>
#include <string.h>

#include "fit/worn_internal.h"


void mus_worn_init(mus_worn *worn, size_t size)
{
    mus_worn own = {.limb = MUS_NONE, .panel = MUS_NONE, .node = MUS_NONE};
    mus__def_init(worn, size, &own, sizeof own);
}


const char *mus_worn_name(int32_t kind)
{
    static const char *const names[MUS_WORN_COUNT] = {
        "worn", "unknown", "a limb is not in its opening", "inside out", "off the shoulder", "the hood is off",
        "too low", "rolled up", "too tight", "through the body"};
    return kind >= 0 && kind < MUS_WORN_COUNT ? names[kind] : NULL;
}


void mus__worn_note(const mus__worn_call *call, int32_t kind, int32_t limb, int32_t loop, int32_t node, double value,
                    const char *text)
{
    mus_worn *out = call->out;
    if (out->kind != MUS_WORN_YES && out->kind != MUS_WORN_UNKNOWN) return;
    out->kind = kind, out->limb = limb, out->value = value;
    if (loop != MUS_NONE) {
        const mus__worn_loop *own = &call->loops.loop[loop];
        node = call->loops.node[own->first];
        for (int32_t i = 0; i < own->count; i++)
            for (int32_t d = 0; d < 3; d++)
                out->place[d] += call->x[3 * (ptrdiff_t)call->loops.node[own->first + i] + d] / own->count;
    } else if (node != MUS_NONE) {
        memcpy(out->place, call->x + 3 * (ptrdiff_t)node, sizeof out->place);
    }
    out->node = node;
    if (node != MUS_NONE) out->panel = call->drape->cloth->node_panel[node];
    const char *panel = out->panel != MUS_NONE ? mus_pattern_panel_name(call->pattern, out->panel) : NULL;
    snprintf(out->text, sizeof out->text, "not worn: %.110s%s%.60s", text, panel != NULL ? ", at " : "",
             panel != NULL ? panel : "");
}
