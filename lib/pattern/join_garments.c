/*
 * join_garments.c: several garments as one pattern, each a layer farther out than the one before.
 *
 * The layer of a panel is a number; layer 0 is worn next to the skin. It does not change the shape: a shirt is the same
 * pattern under a coat. A drape sews the layers one after another, from inside to outside.
 */
#include <stdio.h>
#include <string.h>

#include "pattern/pattern_internal.h"


/* number of bytes of the whole characters of a text within its first `most` bytes */
static int layer_bytes(const char *text, size_t most)
{
    size_t n = strlen(text);
    if (n > most) n = most;
    while (n > 0 && ((unsigned char)text[n] & 0xC0) == 0x80) n--;
    return (int)n;
}


/* a name that no panel of the pattern has: the name, or with the name of its garment before it, or with a number */
static void layer_name(const mus_pattern *pattern, const char *garment, const char *name, char *out)
{
    char own[MUS__NAME_BYTES];
    memcpy(own, name, sizeof own);
    memcpy(out, own, sizeof own);
    for (int32_t k = 1; mus_pattern_find_panel(pattern, out) != MUS_NONE; k++) {
        if (k == 1 && garment[0] != '\0')
            snprintf(out, MUS__NAME_BYTES, "%.*s_%.*s", layer_bytes(garment, 60), garment, layer_bytes(own, 60), own);
        else
            snprintf(out, MUS__NAME_BYTES, "%.*s_%d", layer_bytes(own, 110), own, (int)k);
    }
}


/* room for the cells of both */
static mus_status layer_room(mus_pattern *p, const mus_pattern *more)
{
    mus_context *context = p->context;
    mus_status status = mus__reserve(context, &p->panel, &p->panel_room, (int64_t)p->npanel + more->npanel,
                                     sizeof *p->panel);
    if (status == MUS_OK)
        status = mus__reserve(context, &p->point, &p->point_room, (int64_t)p->npoint + more->npoint, sizeof *p->point);
    if (status == MUS_OK)
        status = mus__reserve(context, &p->edge, &p->edge_room, (int64_t)p->nedge + more->nedge, sizeof *p->edge);
    if (status == MUS_OK)
        status = mus__reserve(context, &p->seam, &p->seam_room, (int64_t)p->nseam + more->nseam, sizeof *p->seam);
    if (status == MUS_OK)
        status = mus__reserve(context, &p->notch, &p->notch_room, (int64_t)p->nnotch + more->nnotch, sizeof *p->notch);
    if (status == MUS_OK)
        status = mus__reserve(context, &p->mark, &p->mark_room, (int64_t)p->nmark + more->nmark, sizeof *p->mark);
    return status;
}


/* lowest and highest layer of the panels; both 0 without any */
static void layer_span(const mus_pattern *pattern, int32_t *low, int32_t *high)
{
    *low = *high = pattern->npanel > 0 ? pattern->panel[0].attr.layer : 0;
    for (int32_t i = 1; i < pattern->npanel; i++) {
        const int32_t layer = pattern->panel[i].attr.layer;
        *low = layer < *low ? layer : *low;
        *high = layer > *high ? layer : *high;
    }
}


/* append the cells of `more` to those of p, which has room for them, `up` layers above their own; p owns the blocks
 * afterwards */
static void layer_move(mus_pattern *p, mus_pattern *more, int32_t up)
{
    const int32_t panel = p->npanel, point = p->npoint, edge = p->nedge, seam = p->nseam;
    for (int32_t i = 0; i < more->npanel; i++) {
        mus__panel own = more->panel[i];
        for (int32_t k = 0; k < own.noutline; k++) own.outline[k] += edge;
        if (own.mirror_of != MUS_NONE) own.mirror_of += panel;
        own.attr.layer += up;
        layer_name(p, more->name, more->panel[i].name, own.name);
        const int32_t sides = mus__sides_named(more->panel[i].name);
        if (own.attr.sides == MUS_NONE && sides != mus__sides_named(own.name)) own.attr.sides = sides;
        p->panel[p->npanel++] = own;
    }
    for (int32_t i = 0; i < more->npoint; i++) {
        p->point[p->npoint] = more->point[i];
        p->point[p->npoint++].panel += panel;
    }
    for (int32_t i = 0; i < more->nedge; i++) {
        mus__edge *own = &p->edge[p->nedge++];
        *own = more->edge[i];
        own->panel += panel, own->start += point, own->end += point;
        if (own->seam != MUS_NONE) own->seam += seam;
    }
    for (int32_t i = 0; i < more->nseam; i++) {
        mus_seam_def *own = &p->seam[p->nseam++];
        *own = more->seam[i];
        own->edge_a += edge, own->edge_b += edge;
    }
    for (int32_t i = 0; i < more->nnotch; i++) {
        p->notch[p->nnotch] = more->notch[i];
        p->notch[p->nnotch++].edge += edge;
    }
    for (int32_t i = 0; i < more->nmark; i++) {
        p->mark[p->nmark] = more->mark[i];
        p->mark[p->nmark++].panel += panel;
    }
    more->npanel = more->nedge = more->nmark = 0;
}


mus_status mus_pattern_join(mus_pattern *pattern, const mus_pattern *other, int32_t layer)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    if (other == NULL) return mus__fail(pattern->context, MUS_ERR_ARG, "join: the other pattern is NULL");
    int32_t low, high;
    layer_span(other, &low, &high);
    mus_status status = mus__layer_check(pattern, layer);
    if (status == MUS_OK) status = mus__layer_check(pattern, layer + high - low);
    if (status != MUS_OK) return status;
    mus_pattern *more;
    status = mus_pattern_copy(other, &more);
    if (status != MUS_OK) {
        const char *text = mus_context_error(other->context);
        return other->context == pattern->context ? status : mus__fail(pattern->context, status, "%s", text);
    }
    status = layer_room(pattern, more);
    if (status == MUS_OK && more->cut_only != NULL) {
        status = pattern->cut_only != NULL ? mus_pattern_join(pattern->cut_only, more->cut_only, layer)
                                           : mus_pattern_set_cut_only(pattern, more->cut_only);
    }
    if (status == MUS_OK) {
        layer_move(pattern, more, layer - low);
        pattern->nopening = 0;
        mus__pattern_edited(pattern);
    }
    mus_pattern_destroy(more);
    return status;
}
