/*
 * notches_marks.c: what is drawn on a panel: notches on its edges, and marks inside it (lines and drill points).
 */
#include <string.h>

#include "pattern/pattern_internal.h"

/* [m] a notch this far beyond the end of its edge is at the end: the error of a length */
#define END_SLACK 1e-9


mus_status mus_pattern_add_notch(mus_pattern *pattern, int32_t edge, double s, int32_t kind, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status != MUS_OK) return status;

    const mus__edge *own = &pattern->edge[edge];
    double length = own->run[own->npiece];
    char title[2 * MUS__NAME_BYTES];
    mus__pattern_edge_title(pattern, edge, title);
    if (!(s >= -END_SLACK && s <= length + END_SLACK))
        return mus__fail(context, MUS_ERR_ARG, "notch on %s: %g m is outside the edge, which is %g m long", title, s,
                         length);
    if (kind < MUS_NOTCH_SINGLE || kind > MUS_NOTCH_TRIPLE)
        return mus__fail(context, MUS_ERR_ARG, "notch on %s: kind %d is outside 1 to 3", title, (int)kind);

    mus__notch notch = {s < 0.0 ? 0.0 : s > length ? length : s, edge, kind};
    status = mus__reserve(context, &pattern->notch, &pattern->notch_room, (int64_t)pattern->nnotch + 1, sizeof notch);
    if (status != MUS_OK) return status;
    pattern->notch[pattern->nnotch] = notch;
    if (out != NULL) *out = pattern->nnotch;
    pattern->nnotch++;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_add_mark(mus_pattern *pattern, int32_t panel, const char *name, int32_t n, const double *xy,
                                int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    mus__mark mark = {.panel = panel, .n = n};
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status == MUS_OK) status = mus__pattern_take_name(pattern, "mark", name, mark.name);
    if (status != MUS_OK) return status;
    if (n < 1 || xy == NULL)
        return mus__fail(context, MUS_ERR_ARG, "mark %s: %d points, it needs 1 or more", mark.name,
                         xy != NULL ? (int)n : 0);
    status = mus__check_near(context, n, 2, xy, "mark %s: point", mark.name);
    if (status != MUS_OK) return status;

    mark.xy = mus__new(context, 2 * (int64_t)n, sizeof *xy);
    if (mark.xy == NULL) return mus__fail_memory(context, "a mark");
    memcpy(mark.xy, xy, 2 * (size_t)n * sizeof *xy);
    status = mus__reserve(context, &pattern->mark, &pattern->mark_room, (int64_t)pattern->nmark + 1, sizeof mark);
    if (status != MUS_OK) {
        mus__free(context, mark.xy);
        return status;
    }
    pattern->mark[pattern->nmark] = mark;
    if (out != NULL) *out = pattern->nmark;
    pattern->nmark++;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_notch(const mus_pattern *pattern, int32_t notch, int32_t *edge, double *s, int32_t *kind)
{
    if (edge != NULL) *edge = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "notch", notch, pattern->nnotch);
    if (status != MUS_OK) return status;
    if (edge != NULL) *edge = pattern->notch[notch].edge;
    if (s != NULL) *s = pattern->notch[notch].s;
    if (kind != NULL) *kind = pattern->notch[notch].kind;
    return MUS_OK;
}


mus_status mus_pattern_mark(const mus_pattern *pattern, int32_t mark, int32_t *panel, const char **name, int32_t *n,
                            const double **xy)
{
    if (panel != NULL) *panel = MUS_NONE;
    if (name != NULL) *name = NULL;
    if (n != NULL) *n = 0;
    if (xy != NULL) *xy = NULL;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "mark", mark, pattern->nmark);
    if (status != MUS_OK) return status;
    if (panel != NULL) *panel = pattern->mark[mark].panel;
    if (name != NULL) *name = pattern->mark[mark].name;
    if (n != NULL) *n = pattern->mark[mark].n;
    if (xy != NULL) *xy = pattern->mark[mark].xy;
    return MUS_OK;
}
