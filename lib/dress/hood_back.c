/*
 * hood_back.c: a hood that would hang over the face is drawn back, as its wearer draws it.
 *
 * A hood that is sewn stands round the head, and where it is deeper than the head its edge stands before the face. Let
 * down as it is it hangs over the eyes. So two hands take the edge to both sides of its middle, draw it over the crown,
 * that what is too deep comes behind the head, and forwards and down again until it lies half way from the brow to the
 * crown, where hair begins. It is held there while the garment is let down; then friction and the weight behind hold
 * it.
 *
 * The edge in the hands lies on a great circle of the head's dome that turns about the axis from ear to ear: a hair
 * band that is pushed back. The hands give it a speed, and no place: a fold that is in its way stops it. An edge that
 * cannot come before the hairline is left alone.
 */
#include <math.h>

#include "base/elementary.h"
#include "drape/drape_state.h"
#include "dress/hood_back.h"
#include "dress/sew.h"
#include "geom/vec.h"

#define BACK_HAIRLINE (0.25 * MUS_PI) /* [rad] above the brow: half way to the crown */
#define BACK_CROWN (0.5 * MUS_PI)     /* [rad] above the brow: straight above its centre */
#define BACK_SECONDS 1.0 /* [s] of the drawing, half of it to the crown; chosen: in 0.5 s it is 6 degrees late */
#define BACK_STEPS 8     /* of sewing between two looks of the hands: 3 mm of their way at most */
#define BACK_REACH 0.4   /* [m] from the centre of the brow: beyond every head */
#define BACK_HALVINGS 16 /* of it: to a hundredth of a millimetre */

/* where a node of the edge was taken */
typedef struct back_hold {
    double angle; /* of its great circle above the brow [rad] */
    double turn;  /* along it, to the left [rad] */
    double far;   /* from the centre of the brow [m] */
} back_hold;


/* the direction (3) at a place of a great circle */
static void back_way(const mus__head *head, double angle, double turn, double *out)
{
    for (int32_t d = 0; d < 3; d++)
        out[d] = mus__cos(turn) * (mus__cos(angle) * head->front[d] + mus__sin(angle) * head->up[d]) +
                 mus__sin(turn) * head->left[d];
}


/* distance from the centre of the brow at which cloth rests on the head in a direction */
static double back_skin(const mus_drape *drape, const mus__head *head, const double *way)
{
    double low = 0.0, high = BACK_REACH;
    for (int32_t k = 0; k < BACK_HALVINGS; k++) {
        const double half = 0.5 * (low + high);
        const double at[3] = {head->brow[0] + half * way[0], head->brow[1] + half * way[1],
                              head->brow[2] + half * way[2]};
        double depth;
        mus_drape_depth(drape, 1, at, &depth, NULL);
        const bool in = depth > -drape->def.clearance;
        low = in ? half : low, high = in ? high : half;
    }
    return high;
}


/* gives the edge the speed that brings it in `time` [s] to its place at the share t of the way */
static void back_move(mus_drape *drape, const mus__hood_edge *hood, const back_hold *hold, double t, double time)
{
    double way[3];
    const double up = fmin(2.0 * t, 1.0), down = fmax(2.0 * t - 1.0, 0.0);
    back_way(&hood->head, BACK_HAIRLINE, 0.0, way);
    const double radius = back_skin(drape, &hood->head, way);
    for (int32_t k = 0; k < hood->count; k++) {
        const int32_t r = drape->rep[hood->node[k]];
        const double angle = hold[k].angle + up * (BACK_CROWN - hold[k].angle) + down * (BACK_HAIRLINE - BACK_CROWN);
        back_way(&hood->head, angle, hold[k].turn + up * (hood->along[k] / radius - hold[k].turn), way);
        const double skin = back_skin(drape, &hood->head, way);
        const double far = skin + (1.0 - down) * fmax(hold[k].far - skin, 0.0), *x = drape->x + 3 * (int64_t)r;
        for (int32_t i = 0; i < drape->n; i++)
            for (int32_t d = 0; d < 3 && drape->rep[i] == r; d++)
                drape->v[3 * (int64_t)i + d] = (hood->head.brow[d] + far * way[d] - x[d]) / time;
    }
    mus__drape_push(drape);
}


/* takes the places of the nodes of the edge */
static void back_take(const mus_drape *drape, const mus__hood_edge *hood, back_hold *hold)
{
    for (int32_t k = 0; k < hood->count; k++) {
        double to[3];
        for (int32_t d = 0; d < 3; d++)
            to[d] = drape->x[3 * (int64_t)drape->rep[hood->node[k]] + d] - hood->head.brow[d];
        const double front = mus__dot3(to, hood->head.front), up = mus__dot3(to, hood->head.up);
        hold[k].angle = mus__atan2(up, front);
        hold[k].turn = mus__atan2(mus__dot3(to, hood->head.left), sqrt(up * up + front * front));
        hold[k].far = mus__norm3(to);
    }
}


/* whether the edge, let down as it is, comes before the hairline: its middle is farther from the crown than the
 * hairline is along the head */
static bool back_deep(const mus_drape *drape, const mus__head *head, const back_hold *middle)
{
    double crown[3], hairline[3], edge[3], off[3];
    back_way(head, BACK_CROWN, 0.0, crown);
    back_way(head, BACK_HAIRLINE, 0.0, hairline);
    back_way(head, middle->angle, middle->turn, edge);
    const double top = back_skin(drape, head, crown), radius = 0.5 * (top + back_skin(drape, head, hairline));
    for (int32_t d = 0; d < 3; d++) off[d] = middle->far * edge[d] - top * crown[d];
    return middle->angle < BACK_CROWN && mus__norm3(off) > (BACK_CROWN - BACK_HAIRLINE) * radius;
}


/* moves the edge, with the steps of sewing */
static mus_status back_draw(mus_drape *drape, const mus__hood_edge *hood, const back_hold *hold, mus__progress *run)
{
    mus_status status = mus__drape_plane_cache(drape);
    for (double t = 0.0; t < BACK_SECONDS && status == MUS_OK && !run->stop;) {
        const double h = mus__sew_step(drape);
        int32_t steps = BACK_STEPS;
        back_move(drape, hood, hold, fmin((t + steps * h) / BACK_SECONDS, 1.0), steps * h);
        status = mus__sew_run(drape, run, h, &steps);
        t += steps * h;
        drape->counters.settle_time += steps * h;
        mus__drape_publish(drape);
        mus__progress_report(run, drape, 0.0);
    }
    drape->sim.plane_cache = NULL;
    return status;
}


mus_status mus__hood_back(mus_drape *drape, const mus_pattern *pattern, const mus_body *body, mus__progress *run,
                          mus__hood_edge *hood)
{
    back_hold hold[MUS__HOOD_HAND];
    mus_status status = mus__fit_hood(drape, pattern, body, hood);
    if (status != MUS_OK || hood->count == 0) return status;
    back_take(drape, hood, hold);
    if (!back_deep(drape, &hood->head, &hold[0])) {
        hood->count = 0;
        return MUS_OK;
    }
    status = back_draw(drape, hood, hold, run);
    for (int32_t k = 0; k < hood->count && status == MUS_OK; k++) status = mus_drape_pin(drape, hood->node[k], 1);
    if (status != MUS_OK || run->stop) mus__hood_release(drape, hood);
    return status;
}


mus_status mus__hood_release(mus_drape *drape, mus__hood_edge *hood)
{
    mus_status status = MUS_OK;
    for (int32_t k = 0; k < hood->count; k++) {
        const mus_status own = mus_drape_pin(drape, hood->node[k], 0);
        if (own != MUS_OK) status = own;
    }
    hood->count = 0;
    return status;
}
