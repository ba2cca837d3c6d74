/*
 * cut_only.h: what the files of the panels that are cut and sewn but not draped share.
 *
 * cut_only.c chooses the panels by the words of a style; cut_only_facing.c traces facings and the fly from the edges of
 * the drafted panels, cut_only_strip.c draws rectangles. lib/design calls mus__cut_only_make() at the end of a draft.
 */
#ifndef MUS_CUT_ONLY_H
#define MUS_CUT_ONLY_H

#include "half/half_garment.h"

#define MUS__FACING (5.0 * MUS__CM) /* [m] width of a facing (Aldrich 2008: 5 to 6 cm) */

/* panels under work; the first failure stays in `status`, and calls after it do nothing */
typedef struct mus__cut_only {
    const mus_pattern *pattern; /* the drafted garment */
    mus_pattern *made;
    double scale; /* factor of lengths that are given in centimetres */
    mus_status status;
} mus__cut_only;

/* a rectangle: lengths along its sew line [m] */
typedef struct mus__cut_strip {
    const char *name, *label;
    double length, width;
    double turned;    /* allowance of its upper long edge, the inner layer of a folded strip; 0: that of a seam */
    bool lengthwise;  /* grain along the length, else across */
    int32_t material; /* MUS_MATERIAL_* */
    int32_t count;
    bool interfaced; /* also cut once of interfacing */
} mus__cut_strip;

/* Gives a drafted pattern the panels that are cut and sewn but not draped; `scale` is mus__measures_scale() of the
 * wearer. Errors: MUS_ERR_MEMORY */
mus_status mus__cut_only_make(const mus__style *style, double scale, mus_pattern *pattern);

void mus__cut_strip_add(mus__cut_only *job, const mus__cut_strip *strip);

/* Traces a facing of MUS__FACING along each run of edges with `label` of each panel that is no collar or hood, darts
 * closed; `ending` is added to the panel's name. */
void mus__cut_facings(mus__cut_only *job, const char *label, const char *ending);
/* Traces a fly facing of `width` [m] along the edge "zip" of the left front leg. */
void mus__cut_fly(mus__cut_only *job, double width);

#endif
