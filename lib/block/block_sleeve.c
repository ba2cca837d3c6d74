/*
 * block_sleeve.c: the set-in sleeve: a cap of two cubics with level handles, fitted to the two armhole halves, and an
 * underarm that runs straight to the hem.
 *
 * The cap height is solved so that the whole cap has the length of the armhole and its ease, and the crown is
 * moved sideways until the front half of the cap has its length: the crown is then the shoulder notch. Method: cap
 * fitted by iteration as in FreeSewing 4 (library sleeve).
 *
 *            T (crown, height)
 *         __/ \__
 *      __/       \__
 *   F ---- biceps ---- K     y = 0
 *     \              /
 *      hem ------ hem        y = height - length
 */
#include <math.h>
#include <string.h>

#include "block/block_sleeve.h"

typedef struct sleeve_cap_problem {
    double width, crown, target, ratio;
} sleeve_cap_problem;


/* front [F, (F.x + .55 dx, 0), (T.x - .44 dx, h), T], dx = T.x - F.x; back [T, (T.x + .48 dx, h), (K.x - .45 dx, 0),
 * K] */
static void sleeve_cap(double width, double height, double crown, double *front, double *back)
{
    double f[2] = {-0.5 * width, 0.0}, k[2] = {0.5 * width, 0.0}, t[2] = {crown, height};
    double before = t[0] - f[0], after = k[0] - t[0];
    mus__cubic_set(front, f, f[0] + 0.55 * before, 0.0, t[0] - 0.44 * before, height, t);
    mus__cubic_set(back, t, t[0] + 0.48 * after, height, k[0] - 0.45 * after, 0.0, k);
}


static double sleeve_cap_excess(const void *data, double height)
{
    const sleeve_cap_problem *problem = data;
    double front[8], back[8];
    sleeve_cap(problem->width, height, problem->crown, front, back);
    return mus__cubic_length(front) + mus__cubic_length(back) - problem->target;
}


static double sleeve_width_excess(const void *data, double width)
{
    const sleeve_cap_problem *problem = data;
    sleeve_cap_problem wide = {width, 0.0, problem->target, 0.0};
    return sleeve_cap_excess(&wide, problem->ratio * problem->target);
}


double mus__sleeve_width(double cap, double ratio)
{
    /* a cap is never wider than its own length */
    sleeve_cap_problem problem = {0.0, 0.0, cap, ratio};
    double width = 0.8 * cap;
    mus__solve(sleeve_width_excess, &problem, 0.3 * cap, cap, &width);
    return width;
}


mus_status mus__sleeve_draft(mus_context *context, const mus__sleeve_def *def, mus__sleeve *out)
{
    memset(out, 0, sizeof *out);
    double target = def->front + def->back, w = def->width;
    if (!(target >= 1.02 * w))
        return mus__fail(context, MUS_ERR_DESIGN,
                         "sleeve cap: an armhole of %d mm does not reach round a sleeve %d mm wide (upper_arm)",
                         mus__millimetres(target), mus__millimetres(w));

    /* solves the height for the whole length, then moves the crown by 0.8 of the error of the front half, in turn */
    sleeve_cap_problem problem = {w, 0.0, target, 0.0};
    double height = 0.0, error = 1.0;
    for (int i = 0; i < 60 && fabs(error) > 1e-10; i++) {
        if (!mus__solve(sleeve_cap_excess, &problem, 0.1 * MUS__CM, target, &height)) break;
        sleeve_cap(w, height, problem.crown, out->cap_front, out->cap_back);
        error = mus__cubic_length(out->cap_front) - def->front;
        if (fabs(error) > 1e-10) problem.crown = fmax(-0.25 * w, fmin(0.25 * w, problem.crown - 0.8 * error));
    }
    if (fabs(error) > 1e-7)
        return mus__fail(context, MUS_ERR_DESIGN, "sleeve cap: halves of %d and %d mm do not share a crown on %d mm",
                         mus__millimetres(def->front), mus__millimetres(def->back), mus__millimetres(w));
    if (def->length - height < 2.0 * MUS__CM)
        return mus__fail(context, MUS_ERR_DESIGN, "sleeve: length %d mm leaves no underarm below a cap of %d mm",
                         mus__millimetres(def->length), mus__millimetres(height));

    out->width = w, out->height = height, out->crown = problem.crown;
    out->length = def->length, out->hem = def->hem;
    out->front_length = mus__cubic_length(out->cap_front);
    out->back_length = mus__cubic_length(out->cap_back);
    return MUS_OK;
}
