/*
 * slide.c: what slides off the body while it settles, piece by piece of what hangs together by seams.
 *
 * Cloth that ends high up is carried by the shoulders or the bust, cloth that ends lower by the waist or the hip. A
 * piece has slid off when its uppermost node has gone a hand below what carried it: below the bust if it began above
 * it, below the hip if it began between; below the armpits if it began on the shoulders; or, once it has had time to
 * drop onto the body, when no node is near it. Held edges carry their piece. One that is sewn, reached a hand below the
 * bust and is above the armpits as a whole has gone the other way, rolled up round the neck, held there or not.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "drape/drape_internal.h"
#include "geom/vec.h"

#define SLIDE_DEEP 0.08      /* [m] below what carried it, and below where it began */
#define SLIDE_RIM 0.02       /* [m]: a top that begins so little below the bust is a top */
#define SLIDE_STRAP 0.08     /* [m] above the armpits: what begins so high hangs on the shoulders */
#define OFF_THE_BODY 0.005   /* [m]: no node this near: nothing carries the garment */


/* highest node of each piece along `up`, into top (npanel) and, if wanted, its panel */
static void slide_tops(const mus_drape *drape, const double *x, const double *up, double *top, int32_t *panel)
{
    const mus_cloth *cloth = drape->cloth;
    for (int32_t p = 0; p < cloth->npanel; p++) top[p] = -INFINITY;
    for (int32_t i = 0; i < drape->n; i++) {
        const int32_t piece = drape->slide[cloth->node_panel[i]].piece;
        const double high = mus__dot3(up, x + 3 * (int64_t)drape->rep[i]);
        if (!(high > top[piece])) continue;
        top[piece] = high;
        if (panel != NULL) panel[piece] = cloth->node_panel[i];
    }
}


mus_status mus__drape_slide_start(mus_drape *drape, const double *x)
{
    const mus_cloth *cloth = drape->cloth;
    mus__held_level hip;
    mus__drape_level(drape, MUS_HOLD_HIP, 0, &hip);
    if (!hip.there || cloth->npanel == 0) return MUS_OK;
    mus__slide *first = drape->slide == NULL ? mus__new(drape->context, cloth->npanel, sizeof *first) : NULL;
    if (first != NULL) drape->slide = first;
    double *top = mus__new(drape->context, cloth->npanel, sizeof *top);
    int32_t *panel = mus__new(drape->context, cloth->npanel, sizeof *panel);
    const int32_t done = drape->slide != NULL && top != NULL && panel != NULL;
    if (done) {
        /* pieces by their lowest panel: few panels, so sweeps until nothing changes */
        for (int32_t p = 0; p < cloth->npanel; p++) drape->slide[p].piece = p;
        for (int32_t changed = 1; changed;) {
            changed = 0;
            for (int32_t k = 0; k < cloth->npair; k++) {
                int32_t *a = &drape->slide[cloth->node_panel[cloth->pair[2 * k]]].piece;
                int32_t *b = &drape->slide[cloth->node_panel[cloth->pair[2 * k + 1]]].piece;
                if (*a == *b) continue;
                *a = *b = *a < *b ? *a : *b;
                changed = 1;
            }
        }
        slide_tops(drape, x, hip.up, top, panel);
        for (int32_t p = 0; p < cloth->npanel; p++) drape->slide[p].top = top[p], drape->slide[p].panel = panel[p];

        /* sewing may have thrown it up, or let it fall: it began where the pattern puts it. What was worn before began
         * where it hangs, no higher than that. Held pieces do not slide */
        const double down[3] = {-hip.up[0], -hip.up[1], -hip.up[2]};
        mus__cloth_place(cloth, drape->work);
        slide_tops(drape, drape->work, down, top, NULL);
        for (int32_t p = 0; p < cloth->npanel; p++) drape->slide[p].foot = -top[p];
        slide_tops(drape, drape->work, hip.up, top, NULL);
        for (int32_t p = 0; p < cloth->npanel; p++)
            drape->slide[p].top = drape->cold ? top[p] : fmin(drape->slide[p].top, top[p]);
        for (int32_t h = 0; h < drape->plan.nheld; h++)
            drape->slide[drape->slide[cloth->node_panel[drape->plan.held[h].node]].piece].top = -INFINITY;
    }
    mus__free(drape->context, top);
    mus__free(drape->context, panel);
    if (done) return MUS_OK;

    /* what was taken here is given back */
    if (first != NULL) drape->slide = NULL;
    mus__free(drape->context, first);
    return mus__fail_memory(drape->context, "the pieces of a garment");
}


static void slide_say(mus_drape *drape, int32_t panel, const char *where)
{
    const mus_cloth *cloth = drape->cloth;
    const char *garment = mus_cloth_name(cloth), *name = panel != MUS_NONE ? mus_cloth_panel_name(cloth, panel) : "";
    char text[256];
    snprintf(text, sizeof text, "slid off%s: %.100s%s%.60s at %.1f s", where[0] != '\0' ? "" : " the body",
             garment[0] != '\0' ? garment : name, where[0] != '\0' ? " " : "", where, drape->settle_time);
    mus__drape_reason_set(drape, MUS_REASON_SLID_OFF, panel, MUS_NONE, MUS_NONE, drape->settle_time, text);
}


/* nonzero when nothing is held and no node is near the body any more */
static int32_t slide_loose(const mus_drape *drape, const double *x)
{
    double normal[3 * MUS__TOUCHING_MAX], friction[MUS__TOUCHING_MAX];
    if (drape->plan.nheld > 0) return 0;
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->pinned[i]) return 0;
        if (drape->mass[i] <= 0.0) continue;
        if (mus__collider_touching(drape->collider, x + 3 * (int64_t)i, OFF_THE_BODY, normal, friction) > 0) return 0;
    }
    return 1;
}


/* where a piece of which `top` is uppermost now has slid to, NULL while it is worn; levels along the torso */
static const char *slide_where(const mus__slide *slide, double top, double breast, double armpit, double hip)
{
    const bool high = slide->top > breast - SLIDE_RIM;
    const double carried = high ? breast : hip;
    if (!(slide->top > hip)) return NULL;
    if (top < carried - SLIDE_DEEP && top < slide->top - SLIDE_DEEP) return high ? "below bust" : "below hip";
    return slide->top > armpit + SLIDE_STRAP && top < armpit ? "below armpit" : NULL;
}


/* the first piece that is no longer where it is worn, MUS_NONE without; *where names where it is */
static int32_t slide_piece(const mus_drape *drape, const double *x, const char **where)
{
    const mus_cloth *cloth = drape->cloth;
    mus__held_level bust, hip, armpit;
    double *top = drape->work; /* scratch, 6 numbers a node */
    mus__drape_level(drape, MUS_HOLD_BUST, 0, &bust);
    mus__drape_level(drape, MUS_HOLD_HIP, 0, &hip);
    mus__drape_level(drape, MUS_HOLD_ARMPIT, 0, &armpit);
    if (!bust.there || !hip.there || drape->slide == NULL || cloth->npanel > 3 * (int64_t)drape->n) return MUS_NONE;
    const double breast = mus__dot3(hip.up, bust.point), down[3] = {-hip.up[0], -hip.up[1], -hip.up[2]};
    const double under = armpit.there ? mus__dot3(hip.up, armpit.point) : INFINITY;
    double *foot = top + cloth->npanel;
    slide_tops(drape, x, hip.up, top, NULL);
    slide_tops(drape, x, down, foot, NULL);
    for (int32_t p = 0; p < cloth->npanel; p++) {
        const mus__slide *slide = &drape->slide[p];
        if (slide->piece != p) continue;
        *where = slide_where(slide, top[p], breast, under, hip.at);
        const bool round = cloth->npair > 0 && slide->foot < breast - SLIDE_DEEP;
        if (*where == NULL && round && -foot[p] > under) *where = "above armpit";
        if (*where != NULL) return p;
    }
    return MUS_NONE;
}


int32_t mus__drape_slid(mus_drape *drape, const double *x, int32_t loose)
{
    const char *where = "";
    if (drape->collider == NULL) return 0;
    for (int32_t i = 0; i < drape->n; i++)
        if (drape->pinned[i]) return 0;
    const int32_t piece = slide_piece(drape, x, &where);
    if (piece != MUS_NONE) {
        slide_say(drape, drape->slide[piece].panel, where);
        return 1;
    }
    if (!loose || !slide_loose(drape, x)) return 0;
    slide_say(drape, MUS_NONE, "");
    return 1;
}
