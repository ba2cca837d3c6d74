/*
 * diagnosis.c: why a garment is on or is not: the reason of the last run, with its panel, seam or place.
 *
 * Runs note their end here. A fault of the arrangement before sewing (arrange_check.c) is noted too. It is the reason
 * given when the run then fails, because a person would mend that first.
 */
#include <stdio.h>
#include <string.h>

#include "arrange/arrange_check.h"
#include "arrange/failure_reason.h"
#include "drape/drape_state.h"
#include "drape/residual.h"
#include "dress/diagnosis.h"
#include "dress/dynamic_relaxation.h"
#include "dress/sew.h"
#include "geom/vec.h"


void mus__diagnosis_set(mus_drape *drape, int32_t kind, int32_t panel, int32_t seam, int32_t node, double value,
                        const char *text)
{
    mus__reason_write(&drape->reason, kind, text);
    drape->reason.panel = panel, drape->reason.seam = seam, drape->reason.node = node;
    drape->reason.value = value;
    if (node != MUS_NONE) memcpy(drape->reason.place, drape->x + 3 * (int64_t)node, sizeof drape->reason.place);
}


/* the node with the largest force left over its mass, by the last residual; MUS_NONE without any */
static int32_t diagnosis_restless(const mus_drape *drape)
{
    int32_t worst = MUS_NONE;
    double most = 0.0;
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        const double left = mus__norm3(drape->relax.force + 3 * (int64_t)i) / drape->mass[i];
        if (left > most) most = left, worst = i;
    }
    return worst;
}


/* a node of the pair with the widest gap of a seam */
static int32_t diagnosis_gap(const mus_drape *drape, int32_t seam)
{
    const mus_cloth *cloth = drape->cloth;
    int32_t worst = MUS_NONE;
    double most = -1.0;
    for (int32_t p = 0; p < cloth->npair; p++) {
        const double *a = drape->x + 3 * (int64_t)cloth->pair[2 * p];
        const double *b = drape->x + 3 * (int64_t)cloth->pair[2 * p + 1];
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, gap = mus__norm3(d);
        if (cloth->pair_seam[p] == seam && gap > most) most = gap, worst = cloth->pair[2 * p];
    }
    return worst;
}


/* with self-contact: *tangled is nonzero, and the reason written, when cloth crosses cloth. Errors: MUS_ERR_MEMORY */
static mus_status diagnosis_tangled(mus_drape *drape, int32_t *tangled)
{
    const mus_cloth *cloth = drape->cloth;
    int64_t count = 0;
    int32_t pair[2];
    char text[256];
    *tangled = 0;
    if (!drape->def.self_contact) return MUS_OK;
    const mus_status status = mus_drape_crossings(drape, 1, pair, &count);
    if (status != MUS_OK || count == 0) return status;
    const int32_t node = cloth->triangle[3 * (ptrdiff_t)pair[0]];
    const int32_t other = cloth->node_panel[cloth->triangle[3 * (ptrdiff_t)pair[1]]];
    snprintf(text, sizeof text, "tangled: %lld crossings of cloth, the first of %.80s and %.80s", (long long)count,
             mus_cloth_panel_name(cloth, cloth->node_panel[node]), mus_cloth_panel_name(cloth, other));
    mus__diagnosis_set(drape, MUS_REASON_TANGLED, cloth->node_panel[node], MUS_NONE, node, 0.0, text);
    drape->reason.count = count < INT32_MAX ? (int32_t)count : INT32_MAX;
    *tangled = 1;
    return MUS_OK;
}


/* notes the reason for the status of a sew or settle; text: the context's error */
static void diagnosis_of(mus_drape *drape, mus_status status, const char *text)
{
    const int32_t *panel = drape->cloth->node_panel;
    if (status == MUS_OK) {
        if (drape->relax.settled)
            mus__diagnosis_set(drape, MUS_REASON_SETTLED, MUS_NONE, MUS_NONE, MUS_NONE, 0.0, "");
        else
            mus_reason_init(&drape->reason, sizeof drape->reason);
        return;
    }
    if (status == MUS_ERR_STOPPED) {
        mus__diagnosis_set(drape, MUS_REASON_STOPPED, MUS_NONE, MUS_NONE, MUS_NONE, 0.0, text);
        return;
    }
    if (status == MUS_ERR_DIVERGED) {
        mus__diagnosis_set(drape, MUS_REASON_UNSTABLE, MUS_NONE, MUS_NONE, MUS_NONE, 0.0, text);
    } else if (status == MUS_ERR_SEW) {
        int32_t seam;
        const double gap = mus__weld_gap(drape, &seam);
        const int32_t node = diagnosis_gap(drape, seam);
        mus__diagnosis_set(drape, MUS_REASON_SEAM_OPEN, node != MUS_NONE ? panel[node] : MUS_NONE, seam, node, gap,
                           text);
    } else if (status == MUS_ERR_UNSETTLED) {
        if (drape->reason.kind == MUS_REASON_SLID_OFF) return;
        const int32_t node = diagnosis_restless(drape);
        mus__diagnosis_set(drape, MUS_REASON_NOT_SETTLED, node != MUS_NONE ? panel[node] : MUS_NONE, MUS_NONE, node,
                           drape->relax.residual, text);
    } else {
        mus__diagnosis_set(drape, MUS_REASON_BAD_INPUT, MUS_NONE, MUS_NONE, MUS_NONE, 0.0, text);
        return;
    }
    if (drape->start.kind != MUS_REASON_NONE) drape->reason = drape->start;
}


mus_status mus__diagnosis_status(mus_drape *drape, mus_status status)
{
    char text[256];
    snprintf(text, sizeof text, "%s", mus_context_error(drape->context));
    if (drape->relax.settled || (status == MUS_ERR_UNSETTLED && drape->reason.kind != MUS_REASON_SLID_OFF)) {
        int32_t tangled;
        const mus_status counted = diagnosis_tangled(drape, &tangled);
        if (tangled) return status;

        /* without a count of crossings nothing is called settled */
        if (counted != MUS_OK) {
            status = counted;
            drape->relax.settled = 0;
            snprintf(text, sizeof text, "%s", mus_context_error(drape->context));
        }
    }
    diagnosis_of(drape, status, text);
    return status;
}


mus_status mus_drape_reason(const mus_drape *drape, mus_reason *out)
{
    return drape == NULL ? MUS_ERR_ARG : mus__reason_give(drape->context, &drape->reason, out);
}


mus_status mus_drape_start(const mus_drape *drape, mus_reason *out)
{
    mus_reason own;
    if (drape == NULL) return MUS_ERR_ARG;
    const mus__placed_cloth placed = mus__drape_placed(drape);
    mus__arrange_check(&placed, &own);
    const mus_status status = own.kind == MUS_REASON_NONE ? mus__arrange_check_layers(&placed, &own) : MUS_OK;
    return status == MUS_OK ? mus__reason_give(drape->context, &own, out) : status;
}
