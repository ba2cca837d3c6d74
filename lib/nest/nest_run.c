/*
 * nest_run.c: the state of one run: places, boxes and the losses of all pairs, kept in step with each other.
 */
#include <math.h>
#include <string.h>

#include "nest/nest_run.h"

#define RUN_TELL 5000000 /* steps between two calls of progress; chosen: some milliseconds */


void mus__nest_clamp(const mus__nest_run *run, int32_t i, mus__nest_at *at)
{
    const mus__nest_problem *problem = run->problem;
    const mus__nest_shape *shape = mus__nest_shape_of(run, i, at->way);
    const double left = -shape->low[0], right = run->length - shape->high[0];
    const double bottom = -shape->low[1], top = problem->def->height - shape->high[1];
    const double stripe = problem->def->stripe;
    at->x = fmax(left, fmin(at->x, right));
    at->y = problem->edge[i] ? bottom : fmax(bottom, fmin(at->y, top));
    if (!(stripe > 0.0)) return;
    double line = nearbyint((at->x + shape->stripe) / stripe) * stripe - shape->stripe;
    if (line > right) line -= stripe;
    if (line < left) line += stripe;
    at->x = line;
}


double mus__nest_weigh(mus__nest_run *run, int32_t i, const mus__nest_at *at, double bound)
{
    const int32_t n = run->problem->n;
    const mus__nest_shape *shape = mus__nest_shape_of(run, i, at->way);
    const double box[4] = {at->x - shape->half[0], at->x + shape->half[0], at->y - shape->half[1],
                           at->y + shape->half[1]};
    const double *weight = run->weight + (int64_t)i * n;
    double total = 0.0;
    run->steps += 20 + n;
    /* with stripes there may be no line within the strip */
    if (at->x + shape->high[0] > run->length * (1.0 + 1e-12)) total += run->problem->def->height * shape->size;
    for (int32_t j = 0; j < n; j++) {
        const double *other = run->box + 4 * (int64_t)j;
        if (box[0] > other[1] || box[1] < other[0] || box[2] > other[3] || box[3] < other[2] || j == i) continue;
        const double shift[2] = {run->at[j].x - at->x, run->at[j].y - at->y};
        const double loss =
            mus__nest_loss(shape, mus__nest_shape_of(run, j, run->at[j].way), shift, run->near, &run->steps);
        total += loss * weight[j];
        if (total >= bound) return total;
    }
    return total;
}


bool mus__nest_over(mus__nest_run *run)
{
    const mus__nest_def *def = run->problem->def;
    if (run->tells && def->progress != NULL && run->steps - run->told >= RUN_TELL && *run->stop == 0) {
        run->told = run->steps;
        const double done = fmin(1.0, (double)run->steps / (double)run->limit);
        if (def->progress(def->user, done, run->best.length) != 0) *run->stop = 1;
    }
    return *run->stop != 0 || run->steps >= run->limit;
}


/* set the place of item i and its box */
static void run_lay(mus__nest_run *run, int32_t i, const mus__nest_at *at)
{
    const mus__nest_shape *shape = mus__nest_shape_of(run, i, at->way);
    double *box = run->box + 4 * (int64_t)i;
    run->at[i] = *at;
    box[0] = at->x - shape->half[0];
    box[1] = at->x + shape->half[0];
    box[2] = at->y - shape->half[1];
    box[3] = at->y + shape->half[1];
}


/* set the losses of item i with the items from `first` on */
static void run_pairs(mus__nest_run *run, int32_t i, int32_t first)
{
    const int32_t n = run->problem->n;
    const double *box = run->box + 4 * (int64_t)i;
    const mus__nest_at *at = &run->at[i];
    const mus__nest_shape *shape = mus__nest_shape_of(run, i, at->way);
    run->steps += n;
    for (int32_t j = first; j < n; j++) {
        const double *other = run->box + 4 * (int64_t)j;
        double loss = 0.0;
        if (!(box[0] > other[1] || box[1] < other[0] || box[2] > other[3] || box[3] < other[2] || j == i)) {
            const double shift[2] = {run->at[j].x - at->x, run->at[j].y - at->y};
            loss = mus__nest_loss(shape, mus__nest_shape_of(run, j, run->at[j].way), shift, run->near, &run->steps);
        }
        run->loss[(int64_t)i * n + j] = run->loss[(int64_t)j * n + i] = loss;
    }
    /* the item itself: beyond the end of the strip, which stripes may bring about */
    if (at->x + shape->high[0] > run->length * (1.0 + 1e-12))
        run->loss[(int64_t)i * n + i] = run->problem->def->height * shape->size;
}


void mus__nest_put(mus__nest_run *run, int32_t i, const mus__nest_at *at)
{
    run_lay(run, i, at);
    run_pairs(run, i, 0);
}


void mus__nest_keep(const mus__nest_run *run, double loss, mus__nest_kept *kept)
{
    kept->length = run->length;
    kept->loss = loss;
    memcpy(kept->at, run->at, (size_t)run->problem->n * sizeof *kept->at);
}


void mus__nest_restore(mus__nest_run *run, const mus__nest_kept *kept)
{
    const int32_t n = run->problem->n;
    run->length = kept->length;
    for (int32_t i = 0; i < n; i++) run_lay(run, i, &kept->at[i]);
    for (int32_t i = 0; i < n; i++) run_pairs(run, i, i);
}
