/*
 * arrange.c: mus_arrange_pattern(): finds where the panels of a pattern start round a body.
 *
 * Where a stranger starts in this room. Three things are done with panels before they are sewn:
 *
 *   - their placement is found, here: arrange_from_pattern.c reads outlines, seams and labels; arrange_ring.c puts
 *     panels side by side into rings (a torso, a skirt, sleeves, a collar); arrange_limb.c puts each ring round its
 *     limb, at the azimuth at which its edges are nearest to their partners; arrange_clear.c moves panels clear of the
 *     body
 *   - nodes are put where the placement says: arrange_nodes.c, called by mus_drape_place()
 *   - an arrangement is checked (arrange_check.c, arrange_check_layers.c) and changed where cloth would begin in cloth
 *     (arrange_prefold.c, arrange_separate.c), called by mus_drape_start() and mus_drape_sew(). These take a cloth with
 *     the places of its nodes (placed_cloth.h), not a drape. A fault is told as a reason (failure_reason.c)
 */
#include "arrange/arrange_internal.h"
#include "muslin/arrange.h"


/* writes the placements to the pattern: the point (x, y) of a panel is (sign x, y), turned */
static mus_status arrange_write(const mus__arrangement *arrangement, mus_pattern *pattern)
{
    mus_status status = MUS_OK;
    for (int32_t p = 0; p < arrangement->npanel && status == MUS_OK; p++) {
        const mus__arranged_panel *panel = &arrangement->panel[p];
        const double c = panel->turn[0], s = panel->turn[1];
        mus_placement place;
        mus_placement_init(&place, sizeof place);

        /* the point (line, 0) as drawn: w = c h - s v, y = s h + c v */
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


mus_status mus_arrange_pattern(mus_pattern *pattern, const mus_body *body)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_pattern_context(pattern);
    if (body == NULL) return mus__fail(context, MUS_ERR_ARG, "place: the body is NULL");
    mus__arrangement arrangement = {.context = context, .pattern = pattern, .body = body};
    arrangement.npanel = mus_pattern_panel_count(pattern);
    arrangement.nedge = mus_pattern_edge_count(pattern);
    arrangement.nseam = mus_pattern_seam_count(pattern);
    arrangement.panel = mus__new(context, arrangement.npanel, sizeof *arrangement.panel);
    arrangement.edge = mus__new(context, arrangement.nedge, sizeof *arrangement.edge);
    arrangement.seam = mus__new(context, arrangement.nseam, sizeof *arrangement.seam);
    arrangement.ring = mus__new(context, arrangement.npanel, sizeof *arrangement.ring);
    arrangement.work = mus__new(context, (int64_t)arrangement.nseam + arrangement.npanel, sizeof *arrangement.work);
    mus_status status = MUS_OK;
    if (arrangement.panel == NULL || arrangement.edge == NULL || arrangement.seam == NULL || arrangement.ring == NULL ||
        arrangement.work == NULL)
        status = mus__fail_memory(context, "the places of panels");
    if (status == MUS_OK) status = mus__arrange_read(&arrangement);
    if (status == MUS_OK) status = mus__arrange_rings(&arrangement);
    if (status == MUS_OK) status = mus__arrange_limbs(&arrangement);
    if (status == MUS_OK) status = mus__arrange_clear(&arrangement);
    if (status == MUS_OK) status = arrange_write(&arrangement, pattern);
    mus__free(context, arrangement.panel);
    mus__free(context, arrangement.edge);
    mus__free(context, arrangement.seam);
    mus__free(context, arrangement.ring);
    mus__free(context, arrangement.work);
    return status;
}
