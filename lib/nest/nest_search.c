/*
 * nest_search.c: a place for one item that overlaps less.
 *
 * Samples over the whole strip and round the place now; the best few are walked down by coordinate descent, the best of
 * these with finer steps. A place is weighed by the losses of the pairs times their weights, and no further than the
 * worst place that is still kept.
 * Source: Gardeyn, Vanden Berghe, Wauters, An open-source heuristic to reboot 2D nesting research, 2025, section 6;
 * their numbers of samples and steps.
 */
#include <math.h>

#include "nest/nest_run.h"

#define SEARCH_KEPT 3           /* samples that are walked down */
#define SEARCH_ANYWHERE 50      /* samples over the strip */
#define SEARCH_AROUND 25        /* samples round the place now */
#define SEARCH_COARSE_FROM 0.25 /* [of the shorter side of the box] first and last step of the first walk */
#define SEARCH_COARSE_TO 0.02
#define SEARCH_FINE_FROM 0.01 /* of the second walk */
#define SEARCH_FINE_TO 0.001
#define SEARCH_GROW 1.1   /* of a step after a success */
#define SEARCH_SHRINK 0.5 /* after a failure */

typedef struct search_place {
    mus__nest_at at;
    double loss;
} search_place;


/* keep a place among the best; one that is near a kept one replaces it or is dropped */
static void search_keep(const mus__nest_run *run, int32_t i, search_place *kept, const mus__nest_at *at, double loss)
{
    const double near = 0.05 * mus__nest_shape_of(run, i, at->way)->least;
    int32_t slot = SEARCH_KEPT - 1;
    for (int32_t k = 0; k < SEARCH_KEPT; k++) {
        if (kept[k].loss < HUGE_VAL && kept[k].at.way == at->way && fabs(kept[k].at.x - at->x) < near &&
            fabs(kept[k].at.y - at->y) < near) {
            if (kept[k].loss <= loss) return;
            slot = k;
            break;
        }
    }
    for (; slot > 0 && kept[slot - 1].loss > loss; slot--) kept[slot] = kept[slot - 1];
    kept[slot].at = *at;
    kept[slot].loss = loss;
}


/* walk a place down: steps along an axis or a diagonal, from `from` to `to` */
static void search_descend(mus__nest_run *run, int32_t i, search_place *place, double from, double to)
{
    double step[2] = {from, from};
    while ((step[0] > to || step[1] > to) && place->loss > 0.0) {
        const int32_t axis = (int32_t)(mus__nest_random(run) >> 62);
        double move[2] = {axis == 1 ? 0.0 : step[0], axis == 0 ? 0.0 : axis == 3 ? -step[1] : step[1]};
        move[0] = move[0] > 0.0 ? fmax(move[0], run->problem->def->stripe) : 0.0;
        bool better = false;
        const mus__nest_at start = place->at;
        for (int32_t sign = -1; sign <= 1; sign += 2) {
            mus__nest_at at = start;
            at.x += sign * move[0];
            at.y += sign * move[1];
            mus__nest_clamp(run, i, &at);
            const double loss = mus__nest_weigh(run, i, &at, place->loss);
            if (loss >= place->loss) continue;
            place->loss = loss;
            place->at = at;
            better = true;
        }
        /* along a diagonal both steps change, by the root */
        const double factor = better ? SEARCH_GROW : axis < 2 ? SEARCH_SHRINK : 0.70710678118654752440;
        if (axis != 1) step[0] *= factor;
        if (axis != 0) step[1] *= factor;
    }
}


/* a random way of item i that is not longer than the strip; the way now when none was drawn */
static int32_t search_way(mus__nest_run *run, int32_t i)
{
    const int32_t way = mus__nest_below(run, run->problem->nway[i]);
    const mus__nest_shape *shape = mus__nest_shape_of(run, i, way);
    return mus__nest_fits(run->problem, shape, run->length) ? way : run->at[i].way;
}


void mus__nest_search(mus__nest_run *run, int32_t i)
{
    search_place kept[SEARCH_KEPT] = {{run->at[i], 0.0}, {run->at[i], HUGE_VAL}, {run->at[i], HUGE_VAL}};
    const mus__nest_at now = run->at[i];
    kept[0].loss = mus__nest_weigh(run, i, &now, HUGE_VAL);
    const double before = kept[0].loss;
    for (int32_t k = 0; k < SEARCH_ANYWHERE + SEARCH_AROUND && kept[0].loss > 0.0; k++) {
        mus__nest_at at = now;
        const double u = mus__nest_uniform(run), v = mus__nest_uniform(run);
        if (k < SEARCH_ANYWHERE || k % 2 == 0) at.way = search_way(run, i);
        const mus__nest_shape *shape = mus__nest_shape_of(run, i, at.way);
        if (k < SEARCH_ANYWHERE) {
            at.x = u * (run->length - shape->high[0]) - (1.0 - u) * shape->low[0];
            at.y = v * (run->problem->def->height - shape->high[1]) - (1.0 - v) * shape->low[1];
        } else {
            at.x += (2.0 * u - 1.0) * shape->half[0];
            at.y += (2.0 * v - 1.0) * shape->half[1];
        }
        mus__nest_clamp(run, i, &at);
        const double loss = mus__nest_weigh(run, i, &at, kept[SEARCH_KEPT - 1].loss);
        if (loss < kept[SEARCH_KEPT - 1].loss) search_keep(run, i, kept, &at, loss);
    }
    int32_t top = 0;
    for (int32_t k = 0; k < SEARCH_KEPT && kept[top].loss > 0.0; k++) {
        if (!(kept[k].loss < HUGE_VAL)) continue;
        const double least = mus__nest_shape_of(run, i, kept[k].at.way)->least;
        search_descend(run, i, &kept[k], SEARCH_COARSE_FROM * least, SEARCH_COARSE_TO * least);
        if (kept[k].loss < kept[top].loss) top = k;
    }
    const double least = mus__nest_shape_of(run, i, kept[top].at.way)->least;
    search_descend(run, i, &kept[top], SEARCH_FINE_FROM * least, SEARCH_FINE_TO * least);
    if (kept[top].loss < before) mus__nest_put(run, i, &kept[top].at);
}
