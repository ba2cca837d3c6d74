/*
 * edge_attributes.c: what is said of an edge: its label, its seam allowance, where it is attached to the body, and an
 * elastic along it.
 *
 * A hold keeps a garment up: a waistband does not slide below the waist, a strapless top not below the armpits. An
 * elastic draws an edge in: a casing or a rib is shorter than the cloth that it is sewn to. Both are said of edges, by
 * a named level of the body and by a ratio of lengths, never by a height in metre: the pattern knows no body. A drape
 * finds the level on its own body, and a cloth makes springs of the elastic.
 */
#include <math.h>
#include <string.h>

#include "pattern/pattern_internal.h"

#define ALLOWANCE_MOST 0.2   /* [m] widest seam allowance; chosen: wider is a slip of unit */
#define HOLD_FARTHEST 1.0    /* [m] farthest that a hold is from its level; chosen: farther is a slip of unit */
#define ELASTIC_LEAST 0.1    /* shortest elastic over the length of its edge; chosen: none stretches tenfold */
#define ELASTIC_STIFFEST 1e6 /* [N] to double length; chosen: steel wire of 2.5 mm has it (E A = 2e11 Pa 5e-6 m2) */

static const char *const hold_names[MUS_HOLD_COUNT] = {"none", "neck",   "armpit", "bust",  "waist", "hip",
                                                       "crotch", "biceps", "wrist",  "thigh", "knee",  "ankle"};


const char *mus_hold_name(int32_t level)
{
    return level >= 0 && level < MUS_HOLD_COUNT ? hold_names[level] : NULL;
}


int32_t mus_hold_find(const char *name)
{
    for (int32_t i = 0; name != NULL && i < MUS_HOLD_COUNT; i++)
        if (strcmp(name, hold_names[i]) == 0) return i;
    return MUS_NONE;
}


void mus__edge_attributes_init(mus__edge_attributes *attr)
{
    *attr = (mus__edge_attributes){.allowance = (double)NAN, .hold = MUS_HOLD_NONE, .ratio = 1.0};
}


bool mus__edge_attributes_equal(const mus__edge_attributes *a, const mus__edge_attributes *b)
{
    const bool allowance = a->allowance == b->allowance || (isnan(a->allowance) && isnan(b->allowance));
    const bool hold = a->hold == b->hold && a->below == b->below;
    const bool elastic = a->ratio == b->ratio && a->stiffness == b->stiffness;
    return allowance && hold && elastic && strcmp(a->label, b->label) == 0;
}


/* Errors: MUS_ERR_ARG (a level that is none, `below` beyond HOLD_FARTHEST); `what` names the edges in the sentence */
static mus_status hold_check(const mus_pattern *pattern, const char *what, int32_t level, double below)
{
    if (level < 0 || level >= MUS_HOLD_COUNT)
        return mus__fail(pattern->context, MUS_ERR_ARG, "%s: hold %d is not one of 0 to %d", what, (int)level,
                         MUS_HOLD_COUNT - 1);
    if (!(fabs(below) <= HOLD_FARTHEST))
        return mus__fail(pattern->context, MUS_ERR_ARG, "%s: held %g m below the %s, expected %g to %g m", what, below,
                         hold_names[level], -HOLD_FARTHEST, HOLD_FARTHEST);
    return MUS_OK;
}


mus_status mus_pattern_set_edge_hold(mus_pattern *pattern, int32_t edge, int32_t level, double below)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    char title[2 * MUS__NAME_BYTES];
    mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status != MUS_OK) return status;
    mus__pattern_edge_title(pattern, edge, title);
    status = hold_check(pattern, title, level, below);
    if (status != MUS_OK) return status;
    mus__edge_attributes *attr = &pattern->edge[edge].attr;
    attr->hold = level;
    attr->below = level == MUS_HOLD_NONE ? 0.0 : below;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_hold_label(mus_pattern *pattern, const char *label, int32_t level, double below, int32_t *count)
{
    if (count != NULL) *count = 0;
    if (pattern == NULL) return MUS_ERR_ARG;
    if (label == NULL || label[0] == '\0')
        return mus__fail(pattern->context, MUS_ERR_ARG, "hold: the label of the edges is NULL or empty");
    mus_status status = hold_check(pattern, label, level, below);
    int32_t n = 0;
    for (int32_t i = 0; i < pattern->nedge && status == MUS_OK; i++) {
        if (strcmp(pattern->edge[i].attr.label, label) != 0) continue;
        status = mus_pattern_set_edge_hold(pattern, i, level, below);
        n++;
    }
    if (status == MUS_OK && count != NULL) *count = n;
    return status;
}


mus_status mus_pattern_edge_hold(const mus_pattern *pattern, int32_t edge, int32_t *level, double *below)
{
    if (level != NULL) *level = MUS_HOLD_NONE;
    if (below != NULL) *below = 0.0;
    if (pattern == NULL) return MUS_ERR_ARG;
    const mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status != MUS_OK) return status;
    if (level != NULL) *level = pattern->edge[edge].attr.hold;
    if (below != NULL) *below = pattern->edge[edge].attr.below;
    return MUS_OK;
}


mus_status mus_pattern_set_edge_elastic(mus_pattern *pattern, int32_t edge, double ratio, double stiffness)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status != MUS_OK) return status;
    char title[2 * MUS__NAME_BYTES];
    mus__pattern_edge_title(pattern, edge, title);
    if (!(ratio >= ELASTIC_LEAST && ratio <= 1.0))
        return mus__fail(pattern->context, MUS_ERR_ARG, "edge %s: an elastic of %g times its length, expected %g to 1",
                         title, ratio, ELASTIC_LEAST);
    if (!(stiffness >= 0.0 && stiffness <= ELASTIC_STIFFEST))
        return mus__fail(pattern->context, MUS_ERR_ARG, "edge %s: stiffness of its elastic is %g N, expected 0 to %g",
                         title, stiffness, ELASTIC_STIFFEST);
    mus__edge_attributes *attr = &pattern->edge[edge].attr;
    attr->ratio = stiffness > 0.0 ? ratio : 1.0;
    attr->stiffness = stiffness;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_edge_elastic(const mus_pattern *pattern, int32_t edge, double *ratio, double *stiffness)
{
    if (ratio != NULL) *ratio = 1.0;
    if (stiffness != NULL) *stiffness = 0.0;
    if (pattern == NULL) return MUS_ERR_ARG;
    const mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status != MUS_OK) return status;
    if (ratio != NULL) *ratio = pattern->edge[edge].attr.ratio;
    if (stiffness != NULL) *stiffness = pattern->edge[edge].attr.stiffness;
    return MUS_OK;
}


mus_status mus_pattern_set_edge_label(mus_pattern *pattern, int32_t edge, const char *label)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status == MUS_OK) status = mus__pattern_take_name(pattern, "edge label", label, pattern->edge[edge].attr.label);
    if (status == MUS_OK) mus__pattern_edited(pattern);
    return status;
}


mus_status mus_pattern_set_edge_allowance(mus_pattern *pattern, int32_t edge, double allowance)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status != MUS_OK) return status;

    /* NaN leaves it to the sheet */
    if (allowance < 0.0 || allowance > ALLOWANCE_MOST) {
        char title[2 * MUS__NAME_BYTES];
        mus__pattern_edge_title(pattern, edge, title);
        return mus__fail(pattern->context, MUS_ERR_ARG, "edge %s: an allowance of %g m is outside 0 to %g m", title,
                         allowance, ALLOWANCE_MOST);
    }
    pattern->edge[edge].attr.allowance = allowance;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


const char *mus_pattern_edge_name(const mus_pattern *pattern, int32_t edge)
{
    return pattern != NULL && edge >= 0 && edge < pattern->nedge ? pattern->edge[edge].name : NULL;
}


const char *mus_pattern_edge_label(const mus_pattern *pattern, int32_t edge)
{
    return pattern != NULL && edge >= 0 && edge < pattern->nedge ? pattern->edge[edge].attr.label : NULL;
}


double mus_pattern_edge_allowance(const mus_pattern *pattern, int32_t edge)
{
    return pattern != NULL && edge >= 0 && edge < pattern->nedge ? pattern->edge[edge].attr.allowance : (double)NAN;
}
