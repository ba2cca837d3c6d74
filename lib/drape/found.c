/*
 * found.c: where panels start when nobody said: mus_pattern_place().
 *
 * Seams make tubes of panels that lie side by side: a torso, a skirt, sleeves, a collar (found_tube.c). Each tube goes
 * round its limb, the way round at which its edges are nearest to their partners (found_site.c); panels that then
 * touch the body go off it (found_push.c).
 */
#include <string.h>

#include "drape/found.h"
#include "muslin/drape.h"


/* to the pattern: a place of a panel is (sign x, y) turned */
static mus_status found_write(const mus__found *found, mus_pattern *pattern)
{
    mus_status status = MUS_OK;
    for (int32_t p = 0; p < found->npanel && status == MUS_OK; p++) {
        const found_panel *panel = &found->panel[p];
        const double c = panel->turn[0], s = panel->turn[1];
        mus_placement place;
        mus_placement_init(&place, sizeof place);

        /* (line, 0) as drawn: w = c h - s v, y = s h + c v */
        const double x0 = panel->sign * c * panel->line, y0 = s * panel->line;
        for (int32_t d = 0; d < 3; d++) {
            place.rotation[3 * d] = panel->sign * (c * panel->along[d] - s * panel->up[d]);
            place.rotation[3 * d + 1] = s * panel->along[d] + c * panel->up[d];
            place.rotation[3 * d + 2] = panel->sign * panel->out[d];
            place.origin[d] = panel->at[d] - place.rotation[3 * d] * x0 - place.rotation[3 * d + 1] * y0;
        }
        if (panel->bend > 0.0 && s == 0.0) place.bend = panel->sign * panel->bend, place.bend_x = x0;
        status = mus_pattern_set_placement(pattern, p, &place);
    }
    return status;
}


mus_status mus_pattern_place(mus_pattern *pattern, const mus_body *body)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_pattern_context(pattern);
    if (body == NULL) return mus__fail(context, MUS_ERR_ARG, "place: the body is NULL");
    mus__found found = {.context = context, .pattern = pattern, .body = body};
    found.npanel = mus_pattern_panel_count(pattern);
    found.nedge = mus_pattern_edge_count(pattern);
    found.nseam = mus_pattern_seam_count(pattern);
    found.panel = mus__new(context, found.npanel, sizeof *found.panel);
    found.edge = mus__new(context, found.nedge, sizeof *found.edge);
    found.seam = mus__new(context, found.nseam, sizeof *found.seam);
    found.tube = mus__new(context, found.npanel, sizeof *found.tube);
    found.work = mus__new(context, (int64_t)found.nseam + found.npanel, sizeof *found.work);
    mus_status status = MUS_OK;
    if (found.panel == NULL || found.edge == NULL || found.seam == NULL || found.tube == NULL || found.work == NULL)
        status = mus__fail_memory(context, "the places of panels");
    if (status == MUS_OK) status = mus__found_read(&found);
    if (status == MUS_OK) status = mus__found_tubes(&found);
    if (status == MUS_OK) status = mus__found_sites(&found);
    if (status == MUS_OK) status = mus__found_push(&found);
    if (status == MUS_OK) status = found_write(&found, pattern);
    mus__free(context, found.panel);
    mus__free(context, found.edge);
    mus__free(context, found.seam);
    mus__free(context, found.tube);
    mus__free(context, found.work);
    return status;
}
