/*
 * arrange_clear.c: moves panels clear of the body along their outer normals.
 */
#include "arrange/arrange_internal.h"
#include "geom/vec.h"

#define CLEAR_GRID 8      /* sample points across a panel, and up it */
#define CLEAR_STEP 0.005  /* [m] of a move */
#define CLEAR_STEPS 40    /* moves at most: 20 cm */
#define CLEAR_CLEAR 0.004 /* [m] off the skin a sample point is clear; chosen: twice the clearance of cloth */
#define CLEAR_PART 0.02   /* of a panel's sample points: fewer that are too deep are left to contact */


/* whether (h, v) is inside the outline of a panel, taken as the polygon of its dots */
static bool clear_within(const mus__arrangement *arrangement, const mus__arranged_panel *panel, double h, double v)
{
    bool within = false;
    for (int32_t i = 0; i < panel->nedge; i++) {
        const double *dot = arrangement->edge[panel->edge[i]].dot;
        for (int32_t k = 0; k + 1 < MUS__ARRANGE_DOTS; k++) {
            const double *a = dot + 2 * k, *b = a + 2;
            if ((a[1] > v) != (b[1] > v) && h < a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) within = !within;
        }
    }
    return within;
}


/* number of sample points of a panel that are too deep, and of all in its outline */
static mus_status clear_deep(const mus__arrangement *arrangement, const mus__arranged_panel *panel, int32_t *deep,
                             int32_t *all)
{
    double x[3 * CLEAR_GRID * CLEAR_GRID], depth[CLEAR_GRID * CLEAR_GRID];
    int32_t n = 0;
    *deep = 0;
    for (int32_t i = 0; i < CLEAR_GRID; i++)
        for (int32_t k = 0; k < CLEAR_GRID; k++) {
            const double h = panel->low[0] + (i + 0.5) / CLEAR_GRID * (panel->high[0] - panel->low[0]);
            const double v = panel->low[1] + (k + 0.5) / CLEAR_GRID * (panel->high[1] - panel->low[1]);
            if (clear_within(arrangement, panel, h, v)) mus__arrange_point(panel, h, v, x + 3 * n++);
        }
    const mus_status status = mus_body_depth(arrangement->body, n, x, depth, NULL);
    for (int32_t i = 0; i < n && status == MUS_OK; i++) *deep += depth[i] > -CLEAR_CLEAR;
    *all = n;
    return status;
}


/* moves one panel until it is clear */
static mus_status clear_off(const mus__arrangement *arrangement, mus__arranged_panel *panel)
{
    for (int32_t i = 0; i < CLEAR_STEPS; i++) {
        int32_t deep, all;
        const mus_status status = clear_deep(arrangement, panel, &deep, &all);
        if (status != MUS_OK) return status;
        if (!(deep > CLEAR_PART * all)) return MUS_OK;
        for (int32_t d = 0; d < 3; d++) panel->at[d] += CLEAR_STEP * panel->out[d];
    }
    return MUS_OK;
}


mus_status mus__arrange_clear(mus__arrangement *arrangement)
{
    mus_status status = MUS_OK;
    for (int32_t p = 0; p < arrangement->npanel && status == MUS_OK; p++)
        status = clear_off(arrangement, &arrangement->panel[p]);
    return status;
}
