/*
 * seam.c: seams: two edges said to be one, with direction and ease (paper, eq. 19 and 20).
 *
 * The direction speaks of the edges as they are stored. REVERSED: the start of a is the end of b; DIRECT: the start
 * of a is the start of b. Which side of the cloth that leaves outside depends on how the words of the panels run
 * along the edges, and is for the quotient to say.
 */
#include "pattern/pattern_internal.h"

#define SEAM_BUTTONS 1000 /* at most */


void mus_seam_def_init(mus_seam_def *def, size_t size)
{
    mus_seam_def own = {.edge_a = MUS_NONE, .edge_b = MUS_NONE, .tolerance = 0.0005};
    mus__def_init(def, size, &own, sizeof own);
}


/* is every field of a seam in its range? */
static mus_status seam_check(const mus_pattern *pattern, const mus_seam_def *def)
{
    mus_context *context = pattern->context;
    mus_status status = mus__pattern_known(pattern, "edge", def->edge_a, pattern->nedge);
    if (status == MUS_OK) status = mus__pattern_known(pattern, "edge", def->edge_b, pattern->nedge);
    if (status != MUS_OK) return status;
    if (def->edge_a == def->edge_b) {
        char title[2 * MUS__NAME_BYTES];
        mus__pattern_edge_title(pattern, def->edge_a, title);
        return mus__fail(context, MUS_ERR_ARG, "seam: edge %s cannot be sewn to itself", title);
    }
    if (def->direction != MUS_SEAM_REVERSED && def->direction != MUS_SEAM_DIRECT)
        return mus__fail(context, MUS_ERR_ARG, "seam: direction %d is neither reversed (0) nor direct (1)",
                         (int)def->direction);
    if (!mus__finite(def->ease))
        return mus__fail(context, MUS_ERR_ARG, "seam: an ease of %g m is not finite", def->ease);
    if (!mus__finite(def->tolerance) || def->tolerance < 0.0)
        return mus__fail(context, MUS_ERR_ARG, "seam: a tolerance of %g m is not 0 or more", def->tolerance);
    if (def->closure < MUS_CLOSURE_NONE || def->closure > MUS_CLOSURE_TIES)
        return mus__fail(context, MUS_ERR_ARG, "seam: closure %d is outside 0 to %d", (int)def->closure,
                         MUS_CLOSURE_TIES);
    if (def->closure == MUS_CLOSURE_NONE && def->open != 0)
        return mus__fail(context, MUS_ERR_ARG, "seam: it is no closure, and cannot be left open");
    if (def->buttons < 0 || def->buttons > SEAM_BUTTONS || (def->buttons > 0 && def->closure != MUS_CLOSURE_BUTTONS))
        return mus__fail(context, MUS_ERR_ARG, "seam: %d buttons, expected 0 to %d, and 0 of what has none",
                         (int)def->buttons, SEAM_BUTTONS);
    return MUS_OK;
}


mus_status mus_pattern_add_seam(mus_pattern *pattern, const mus_seam_def *def, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    if (def == NULL) return mus__fail(context, MUS_ERR_ARG, "seam: its def is NULL");

    mus_seam_def own;
    mus_seam_def_init(&own, sizeof own);
    mus_status status = mus__def_read(context, &own, sizeof own, sizeof own, def, "seam def");
    if (status == MUS_OK) status = seam_check(pattern, &own);
    if (status == MUS_OK)
        status = mus__reserve(context, &pattern->seam, &pattern->seam_room, (int64_t)pattern->nseam + 1, sizeof own);
    if (status != MUS_OK) return status;

    /* each edge knows its first seam and how many it is in */
    int32_t seam = pattern->nseam++;
    pattern->seam[seam] = own;
    mus__edge *sides[2] = {&pattern->edge[own.edge_a], &pattern->edge[own.edge_b]};
    for (int32_t i = 0; i < 2; i++) {
        if (sides[i]->nseam == 0) sides[i]->seam = seam;
        sides[i]->nseam++;
    }
    if (out != NULL) *out = seam;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_open_closures(mus_pattern *pattern, int32_t open, int32_t *count)
{
    if (count != NULL) *count = 0;
    if (pattern == NULL) return MUS_ERR_ARG;
    int32_t n = 0;
    for (int32_t i = 0; i < pattern->nseam; i++) {
        if (pattern->seam[i].closure == MUS_CLOSURE_NONE) continue;
        pattern->seam[i].open = open != 0;
        n++;
    }
    if (n > 0) mus__pattern_edited(pattern);
    if (count != NULL) *count = n;
    return MUS_OK;
}


mus_status mus_pattern_seam(const mus_pattern *pattern, int32_t seam, mus_seam_def *out)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(pattern->context, MUS_ERR_ARG, "seam: out is NULL");
    mus_status status = mus__pattern_known(pattern, "seam", seam, pattern->nseam);
    if (status != MUS_OK) return status;
    return mus__pattern_give(pattern, out, &pattern->seam[seam], sizeof *out, "seam def");
}


int32_t mus_pattern_edge_seam(const mus_pattern *pattern, int32_t edge)
{
    return pattern != NULL && edge >= 0 && edge < pattern->nedge ? pattern->edge[edge].seam : MUS_NONE;
}


mus_status mus_pattern_add_opening(mus_pattern *pattern, const char *label)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus__opening own;
    mus_status status = mus__pattern_take_name(pattern, "opening", label, own.label);
    if (status != MUS_OK) return status;
    if (own.label[0] == '\0') return mus__fail(pattern->context, MUS_ERR_ARG, "opening: its label is empty");
    status = mus__reserve(pattern->context, &pattern->opening, &pattern->opening_room, (int64_t)pattern->nopening + 1,
                          sizeof own);
    if (status != MUS_OK) return status;
    pattern->opening[pattern->nopening++] = own;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


int32_t mus_pattern_opening_count(const mus_pattern *pattern)
{
    return pattern != NULL ? pattern->nopening : 0;
}


const char *mus_pattern_opening(const mus_pattern *pattern, int32_t opening)
{
    if (pattern == NULL || opening < 0 || opening >= pattern->nopening) return NULL;
    return pattern->opening[opening].label;
}
