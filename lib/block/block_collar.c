/*
 * block_collar.c: collar stand, collar leaf and hood as plain geometry, each drawn to the length of the edge that it is
 * sewn to. One breadth is solved for; the other figures follow from it.
 *
 *    stand                       leaf                         hood
 *    ____________                inner                         ____
 *   |            \__  top        ------------__               /    \
 *   |____________   \           |               \      face  |      |  crown
 *        bottom  \__/           |_______________ \           |      |
 *                                  outer        \_\           \_.__/
 *   centre back  front                           point          neck
 */
#include <math.h>
#include <string.h>

#include "block/block_collar.h"
#include "base/elementary.h"

/* an edge of a collar whose breadth x is unknown */
typedef struct collar_problem {
    double length, rise;
} collar_problem;


/* bottom = [(0, 0), (.45 x, 0), (x - .35 x cos b, u - .35 x sin b), (x, u)],  tan b = 1.7 u / x */
static void stand_bottom(double x, double u, double *out)
{
    const double b = mus__atan2(1.7 * u, x), start[2] = {0.0, 0.0}, end[2] = {x, u};
    mus__cubic_set(out, start, 0.45 * x, 0.0, x - 0.35 * x * mus__cos(b), u - 0.35 * x * mus__sin(b), end);
}


static double stand_excess(const void *data, double x)
{
    const collar_problem *problem = data;
    double bottom[8];
    stand_bottom(x, problem->rise, bottom);
    return mus__cubic_length(bottom) - problem->length;
}


mus_status mus__stand_draft(mus_context *context, const mus__stand_def *def, mus__stand *out)
{
    const collar_problem problem = {def->length, def->rise};
    double x;
    memset(out, 0, sizeof *out);
    if (!mus__solve(stand_excess, &problem, 0.5 * def->length, def->length + 0.1 * MUS__CM, &x))
        return mus__fail(context, MUS_ERR_DESIGN, "collar stand: a neck edge of %d mm is too short to rise by %d mm",
                         mus__millimetres(def->length), mus__millimetres(def->rise));

    /* top: level with the bottom at the back, square to it in front: T = end + .85 h (-sin b, cos b) */
    stand_bottom(x, def->rise, out->bottom);
    const double b = mus__atan2(1.7 * def->rise, x), h = 0.85 * def->height, start[2] = {0.0, def->height};
    const double t[2] = {x - h * mus__sin(b), def->rise + h * mus__cos(b)};
    mus__cubic_set(out->top, start, 0.45 * t[0], def->height, t[0] - 0.35 * t[0] * mus__cos(b),
                   t[1] - 0.35 * t[0] * mus__sin(b), t);
    out->top_length = mus__cubic_length(out->top);
    return MUS_OK;
}


/* inner = [(0, 0), (.45 x, 0), (.75 x, .55 u), (x, u)] */
static void leaf_inner(double x, double u, double *out)
{
    const double start[2] = {0.0, 0.0}, end[2] = {x, u};
    mus__cubic_set(out, start, 0.45 * x, 0.0, 0.75 * x, 0.55 * u, end);
}


static double leaf_excess(const void *data, double x)
{
    const collar_problem *problem = data;
    double inner[8];
    leaf_inner(x, problem->rise, inner);
    return mus__cubic_length(inner) - problem->length;
}


mus_status mus__leaf_draft(mus_context *context, const mus__leaf_def *def, mus__leaf *out)
{
    const collar_problem problem = {def->length, def->rise};
    double x;
    memset(out, 0, sizeof *out);
    if (!mus__solve(leaf_excess, &problem, 0.5 * def->length, def->length + 0.1 * MUS__CM, &x))
        return mus__fail(context, MUS_ERR_DESIGN, "collar leaf: an inner edge of %d mm is too short to bend by %d mm",
                         mus__millimetres(def->length), mus__millimetres(def->rise));

    /* a point of 7 cm stands 1.2 cm out and 0.6 cm up, and the outer edge comes to it 0.35 cm above; others alike */
    const double p = def->point / 7.0, start[2] = {0.0, -def->fall};
    const double tip[2] = {x + 1.2 * p, def->rise - def->point + 0.6 * p};
    leaf_inner(x, def->rise, out->inner);
    mus__cubic_set(out->outer, start, 0.5 * x, -def->fall, tip[0] - 0.4 * x, tip[1] + 0.35 * p, tip);
    return MUS_OK;
}


/* neck = [(0, -1.5), (.35 x, -1), (.65 x, .8), (x, 1)] cm */
static void hood_neck(double x, double *out)
{
    const double start[2] = {0.0, -1.5 * MUS__CM}, end[2] = {x, 1.0 * MUS__CM};
    mus__cubic_set(out, start, 0.35 * x, -1.0 * MUS__CM, 0.65 * x, 0.8 * MUS__CM, end);
}


static double hood_excess(const void *data, double x)
{
    const collar_problem *problem = data;
    double neck[8];
    hood_neck(x, neck);
    return mus__cubic_length(neck) - problem->length;
}


mus_status mus__hood_draft(mus_context *context, const mus__hood_def *def, mus__hood *out)
{
    const collar_problem problem = {def->length, 0.0};
    double x;
    memset(out, 0, sizeof *out);
    if (!mus__solve(hood_excess, &problem, 0.5 * def->length, def->length + 0.1 * MUS__CM, &x))
        return mus__fail(context, MUS_ERR_DESIGN, "hood: a neck edge of %d mm is too short for one",
                         mus__millimetres(def->length));

    /* w = head / 2 - 3, wider where the neck is; h = .62 head + 1; crown [(x, 1), (w + 1.5, .35 h), (w + 1.5, h),
     * (.45 w, h)], then straight to (-1, h) */
    hood_neck(x, out->neck);
    out->height = 0.62 * def->head + 1.0 * MUS__CM;
    out->width = fmax(0.5 * def->head - 3.0 * MUS__CM, x + 1.0 * MUS__CM);
    const double w = out->width, h = out->height, out_w = w + 1.5 * MUS__CM, end[2] = {0.45 * w, h};
    mus__cubic_set(out->crown, out->neck + 6, out_w, 0.35 * h, out_w, h, end);
    out->top[0] = -1.0 * MUS__CM, out->top[1] = h;
    return MUS_OK;
}
