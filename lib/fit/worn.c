/*
 * worn.c: mus_fit_worn(): is a garment worn by the body as the pattern means it?
 *
 * In the order of use: worn_loops.c finds the boundary loops of the sewn cloth, worn_axes.c the axes of the limbs and
 * the linking numbers, worn_openings.c the limbs that the pattern has for each loop. Here linking numbers as the cloth
 * lies now are compared with these. worn_level.c looks at shoulders and heights, worn_through.c counts triangles.
 *
 * An axis has several ways outside. A limb is in its opening when one of them is right for all loops of the component;
 * a hand under a skirt is right on none.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arrange/arrange_nodes.h"
#include "fit/fit_internal.h"
#include "fit/worn_check.h"
#include "fit/worn_internal.h"
#include "geom/vec.h"

/* [part] strain from which an opening or the cloth is too tight: twice its length. No fabric of muslin_fabric(5) is
 * measured beyond half of that; a seam of a garment tears before */
#define WORN_TIGHT 1.0


static const char *const worn_limbs[MUS_WORN_LIMBS] = {"the head", "the left arm", "the right arm", "the left leg",
                                                       "the right leg"};


/* the first limb of a component that is not in its opening when its loops count with `sign`, MUS_NONE without any; *at:
 * its opening, or the loop that has it and should not */
static int32_t worn_astray(const mus__worn_call *call, int32_t component, int32_t sign, int32_t *at)
{
    const mus__worn_loops *loops = &call->loops;
    int32_t wrong[MUS_WORN_LIMBS][MUS__WORN_WAYS], found = MUS_NONE;
    for (int32_t limb = 0; limb < MUS_WORN_LIMBS; limb++)
        for (int32_t way = 0; way < MUS__WORN_WAYS; way++) wrong[limb][way] = MUS_NONE;
    for (int32_t l = 0; l < loops->nloop; l++) {
        const mus__worn_loop *own = &loops->loop[l];
        int32_t common = 0, link[MUS_WORN_LIMBS][MUS__WORN_WAYS];
        if (own->component != component) continue;
        mus__worn_link(&call->axes, loops, l, call->x, link);
        mus__worn_agree(&call->axes, own, sign * own->sign, link, &common);
        for (int32_t limb = 0; limb < MUS_WORN_LIMBS; limb++)
            for (int32_t way = 0; way < MUS__WORN_WAYS; way++) {
                const int32_t has = sign * own->sign * link[limb][way] - common, wants = own->expect >> limb & 1;
                if (call->axes.count[limb] == 0 || !(own->judged >> limb & 1) || has == wants) continue;
                if (wrong[limb][way] == MUS_NONE || wants) wrong[limb][way] = l;
            }
    }
    for (int32_t limb = 0; limb < MUS_WORN_LIMBS; limb++)
        for (int32_t way = 0; way < MUS__WORN_WAYS && found == MUS_NONE; way++) {
            if (wrong[limb][way] == MUS_NONE) break;
            if (way == MUS__WORN_WAYS - 1) found = limb, *at = wrong[limb][0];
        }
    return found;
}


/* every limb in its opening, right side out */
static void worn_openings(const mus__worn_call *call)
{
    for (int32_t component = 0; component < call->drape->cloth->npanel; component++) {
        int32_t at = MUS_NONE, other = MUS_NONE, here = MUS_NONE;
        for (int32_t l = call->loops.nloop; l-- > 0;)
            if (call->loops.loop[l].component == component && call->loops.loop[l].expect != 0) here = l;
        if (here == MUS_NONE) continue;
        const int32_t limb = worn_astray(call, component, 1, &at);
        char text[128];
        if (limb == MUS_NONE) continue;
        if (worn_astray(call, component, -1, &other) == MUS_NONE) {
            mus__worn_note(call, MUS_WORN_INSIDE_OUT, MUS_NONE, here, MUS_NONE, 0.0, "inside out");
        } else {
            const bool own = call->loops.loop[at].expect >> limb & 1;
            const bool sleeve =
                limb != MUS_WORN_NECK && call->loops.loop[at].expect == 1 << limb;
            snprintf(text, sizeof text, "%s is %s", worn_limbs[limb],
                     !own     ? "in an opening that is not its own"
                     : sleeve ? limb <= MUS_WORN_ARM_RIGHT ? "not in its sleeve or armhole" : "not in its trouser leg"
                              : "not in its opening");
            mus__worn_note(call, MUS_WORN_OPENING, limb, at, MUS_NONE, 0.0, text);
        }
    }
}


/* length of a loop as it lies, and in the flat (*flat), without the steps from panel to panel [m] */
static double worn_length(const mus__worn_call *call, const mus__worn_loop *loop, double *flat)
{
    const mus_cloth *cloth = call->drape->cloth;
    double length = 0.0;
    *flat = 0.0;
    for (int32_t i = 0; i < loop->count; i++) {
        const int32_t from = call->loops.node[loop->first + i];
        const int32_t to = call->loops.node[loop->first + (i + 1) % loop->count];
        const double *a = call->x + 3 * (ptrdiff_t)from, *b = call->x + 3 * (ptrdiff_t)to;
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        if (cloth->node_panel[from] != cloth->node_panel[to]) continue;
        length += mus__norm3(d);
        *flat += mus__dist2(cloth->rest + 2 * (ptrdiff_t)from, cloth->rest + 2 * (ptrdiff_t)to);
    }
    return length;
}


/* openings, and cloth, at twice their length. Less cloth than a cell of the lattice is a sliver of the mesh at a corner
 * or a seam, which the cut does not resolve */
static mus_status worn_tight(const mus__worn_call *call)
{
    char text[128];
    for (int32_t l = 0; l < call->loops.nloop; l++) {
        const mus__worn_loop *own = &call->loops.loop[l];
        double flat;
        const double length = worn_length(call, own, &flat);
        if (own->expect == 0 || !(length > (1.0 + WORN_TIGHT) * flat)) continue;
        snprintf(text, sizeof text, "too tight: an opening of %.0f mm is drawn to %.0f mm", 1000.0 * flat,
                 1000.0 * length);
        mus__worn_note(call, MUS_WORN_TIGHT, MUS_NONE, l, MUS_NONE, length / flat - 1.0, text);
    }
    const int32_t n = call->drape->cloth->nnode;
    double *strain = mus__new(call->drape->context, 3 * (int64_t)n, sizeof *strain), most = WORN_TIGHT;
    if (strain == NULL) return mus__fail_memory(call->drape->context, "the strain of a garment");
    mus_fit fit = {.n = n, .warp = strain, .weft = strain + n, .area = strain + 2 * (ptrdiff_t)n};
    mus__fit_strains(&fit, call->drape);
    int32_t worst = MUS_NONE;
    double area = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const double own = fmax(fit.warp[i], fit.weft[i]);
        if (own > WORN_TIGHT) area += fit.area[i];
        if (own > most) most = own, worst = i;
    }
    mus__free(call->drape->context, strain);
    const double spacing = call->drape->cloth->spacing;
    snprintf(text, sizeof text, "too tight: cloth is drawn to %.1f times its length", 1.0 + most);
    if (worst != MUS_NONE && area > spacing * spacing)
        mus__worn_note(call, MUS_WORN_TIGHT, MUS_NONE, MUS_NONE, worst, most, text);
    return MUS_OK;
}


/* the checks of `parts` (MUS__WORN_*), in the order of the list of kinds */
static mus_status worn_check(mus__worn_call *call, int32_t parts)
{
    mus_status status = MUS_OK;
    if (mus__worn_axes_make(call->body, &call->axes)) {
        status = mus__worn_loops_make(call->drape->context, call->drape->cloth, &call->loops);
        if (status == MUS_OK)
            status = mus__worn_expect(call->pattern, call->drape->cloth, &call->axes, call->placed, &call->loops);
        if (status == MUS_OK && (parts & MUS__WORN_GIRTHS) != 0) mus__worn_girths(call);
        if (status == MUS_OK && (parts & MUS__WORN_OPENINGS) != 0) worn_openings(call);
        if (status == MUS_OK && (parts & MUS__WORN_HANGS) != 0) {
            mus__worn_over(&call->axes, call->x, &call->loops);
            mus__worn_levels(call);
            status = worn_tight(call);
        }
        if (status == MUS_OK && (parts & MUS__WORN_OPENINGS) != 0) mus__worn_pierced(call);
    } else {
        call->out->kind = MUS_WORN_UNKNOWN;
    }
    return status == MUS_OK && (parts & MUS__WORN_SKIN) != 0 ? mus__worn_through(call) : status;
}


mus_status mus__fit_worn(const mus_drape *drape, const mus_pattern *pattern, const mus_body *body, int32_t parts,
                         mus_worn *out)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (pattern == NULL || body == NULL || out == NULL)
        return mus__fail(drape->context, MUS_ERR_ARG, "worn: %s is NULL",
                         pattern == NULL ? "the pattern" : body == NULL ? "the body" : "out");
    if (out->size != sizeof *out)
        return mus__fail(drape->context, MUS_ERR_VERSION, "worn: size unknown; use mus_worn_init");
    const mus_cloth *cloth = drape->cloth;
    if (cloth->npanel == 0 || mus_pattern_panel_count(pattern) != cloth->npanel)
        return mus__fail(drape->context, MUS_ERR_ARG, "worn: the pattern has %d panels, the cloth %d",
                         (int)mus_pattern_panel_count(pattern), (int)cloth->npanel);
    double *placed = mus__new(drape->context, 3 * (int64_t)cloth->nnode, sizeof *placed);
    if (placed == NULL) return mus__fail_memory(drape->context, "whether a garment is worn");
    mus__arrange_nodes(cloth, placed);
    mus_worn worn;
    mus_worn_init(&worn, sizeof worn);
    mus__worn_call call = {.drape = drape, .pattern = pattern, .body = body, .x = drape->x, .placed = placed,
                           .out = &worn};
    const mus_status status = worn_check(&call, parts);
    if (call.loops.context != NULL) mus__worn_loops_free(&call.loops);
    mus__free(drape->context, placed);
    if (status == MUS_OK) *out = worn;
    return status;
}


mus_status mus_fit_worn(const mus_drape *drape, const mus_pattern *pattern, const mus_body *body, mus_worn *out)
{
    return mus__fit_worn(drape, pattern, body, MUS__WORN_OPENINGS | MUS__WORN_HANGS | MUS__WORN_SKIN, out);
}
