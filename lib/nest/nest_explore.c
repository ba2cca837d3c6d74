/*
 * nest_explore.c: the search of one run: make the strip shorter, separate, and again.
 *
 * The first layout is columns of boxes, which always fit. Exploring: after each success the strip is made shorter by a
 * step, which doubles while success comes quickly and returns to the least after a failure. After a failure at the
 * least step the search goes on from one of the layouts with the fewest overlaps, in which two large items change
 * places. Compressing, in the last part of the steps: the best layout is made shorter by steps that become smaller, at
 * a random place. Source: Gardeyn, Vanden Berghe, Wauters, An open-source heuristic to reboot 2D nesting research,
 * 2025, section 7.
 */
#include <math.h>
#include <string.h>

#include "nest/nest_run.h"

#define EXPLORE_WIDE 0.8          /* part of the steps for exploring */
#define EXPLORE_STEP_LEAST 0.001  /* [of the length] step of exploring */
#define EXPLORE_STEP_MOST 0.05    /* chosen: the first layout may be twice as long as the best */
#define EXPLORE_QUICK 0.01        /* [of the steps] a success within this doubles the step; chosen */
#define EXPLORE_FAILURES 10       /* in a row after which exploring ends */
#define EXPLORE_FINE_FIRST 0.0005 /* [of the length] first and last step of compressing */
#define EXPLORE_FINE_LAST 0.00001
#define EXPLORE_PATIENCE 100 /* rounds without progress when exploring, and strikes; half and two thirds of theirs: */
#define EXPLORE_STRIKES 2    /* 8e9 steps cover 0.4 to 0.8 % more of shirts, trousers and dagli */
#define EXPLORE_TRIAL 30     /* rounds without progress at a larger step; chosen */
#define EXPLORE_FINE_PATIENCE 100 /* when compressing */
#define EXPLORE_FINE_STRIKES 5
#define EXPLORE_LARGE 0.5 /* [of the largest hull] items that may change places; chosen */


/* the first way of item i that is within the strip's height; its own number of ways when there is none */
static int32_t explore_way(const mus__nest_run *run, int32_t i, double length)
{
    int32_t way = 0;
    for (; way < run->problem->nway[i]; way++) {
        const mus__nest_shape *shape = mus__nest_shape_of(run, i, way);
        if (mus__nest_fits(run->problem, shape, length)) break;
    }
    return way;
}


/* whether item a comes before b in the columns: items on the edge one to a column, then by width */
static bool explore_before(const mus__nest_run *run, int32_t a, int32_t b)
{
    const bool *edge = run->problem->edge;
    if (edge[a] != edge[b]) return edge[a];
    const double wide = mus__nest_shape_of(run, a, run->at[a].way)->half[0];
    const double other = mus__nest_shape_of(run, b, run->at[b].way)->half[0];
    return wide > other || (wide == other && a < b);
}


/* lay the boxes of all items in columns, a little apart, and keep that as the best layout */
static void explore_columns(mus__nest_run *run)
{
    const mus__nest_problem *problem = run->problem;
    const int32_t n = problem->n;
    for (int32_t i = 0; i < n; i++) {
        int32_t k = i;
        run->at[i].way = explore_way(run, i, HUGE_VAL);
        for (; k > 0 && explore_before(run, i, run->order[k - 1]); k--) run->order[k] = run->order[k - 1];
        run->order[k] = i;
    }
    const double apart = 1e-6 * problem->def->height, stripe = problem->def->stripe;
    double left = 0.0, right = 0.0, low = HUGE_VAL;
    for (int32_t k = 0; k < n; k++) {
        const int32_t i = run->order[k];
        const mus__nest_shape *shape = mus__nest_shape_of(run, i, run->at[i].way);
        mus__nest_at *at = &run->at[i];
        at->y = fmax(low + shape->half[1], -shape->low[1]);
        if (problem->edge[i] || at->y + shape->high[1] > problem->def->height) {
            left = right;
            at->y = -shape->low[1];
        }
        at->x = left + fmax(shape->half[0], -shape->low[0]) + apart;
        if (stripe > 0.0) at->x = ceil((at->x + shape->stripe) / stripe) * stripe - shape->stripe;
        right = fmax(right, at->x + fmax(shape->half[0], shape->high[0]));
        low = at->y + shape->half[1] + apart;
    }
    run->length = right + 1e-6 * problem->def->height;
    mus__nest_keep(run, 0.0, &run->best);
    mus__nest_restore(run, &run->best);
}


/* make the strip shorter: what lies right of `split` moves to the left by the difference */
static void explore_shorten(mus__nest_run *run, double length, double split)
{
    const int32_t n = run->problem->n;
    const double less = run->length - length;
    mus__nest_kept *next = &run->least;
    mus__nest_keep(run, 0.0, next);
    next->length = run->length = length;
    for (int32_t i = 0; i < n; i++) {
        mus__nest_at *at = &next->at[i];
        if (!mus__nest_fits(run->problem, mus__nest_shape_of(run, i, at->way), length)) {
            const int32_t way = explore_way(run, i, length);
            if (way < run->problem->nway[i]) at->way = way;
        }
        if (at->x > split) at->x -= less;
        mus__nest_clamp(run, i, at);
    }
    mus__nest_restore(run, next);
}


/* whether the layout is one: no two outlines share a point, as they leave the room */
static bool explore_exact(const mus__nest_run *run)
{
    const int32_t n = run->problem->n;
    double *corners[2] = {run->corners, run->corners + 2 * (int64_t)run->problem->most};
    for (int32_t i = 0; i < n; i++) {
        const mus__nest_shape *shape[2] = {mus__nest_shape_of(run, i, run->at[i].way), NULL};
        mus__nest_outline(shape[0], &run->at[i], corners[0]);
        for (int32_t j = 0; j < i; j++) {
            const double *a = run->box + 4 * (int64_t)i, *b = run->box + 4 * (int64_t)j;
            if (a[0] > b[1] || a[1] < b[0] || a[2] > b[3] || a[3] < b[2]) continue;
            shape[1] = mus__nest_shape_of(run, j, run->at[j].way);
            mus__nest_outline(shape[1], &run->at[j], corners[1]);
            if (mus__nest_exact_meets(shape[0]->n, corners[0], shape[1]->n, corners[1])) return false;
        }
    }
    return true;
}


/* separate, and keep the layout as the best one if that was done */
static bool explore_separate(mus__nest_run *run, int32_t strikes, int32_t patience)
{
    if (!mus__nest_separate(run, strikes, patience) || !explore_exact(run)) return false;
    mus__nest_keep(run, 0.0, &run->best);
    return true;
}


/* keep the layout of run->least in the pool, in the order of the losses; a full pool drops its worst */
static void explore_pool(mus__nest_run *run)
{
    int32_t k = run->npool < MUS__NEST_POOL ? run->npool++ : MUS__NEST_POOL - 1;
    mus__nest_kept slot = run->pool[k];
    for (; k > 0 && run->pool[k - 1].loss > run->least.loss; k--) run->pool[k] = run->pool[k - 1];
    slot.length = run->least.length;
    slot.loss = run->least.loss;
    memcpy(slot.at, run->least.at, (size_t)run->problem->n * sizeof *slot.at);
    run->pool[k] = slot;
}


/* go on from a layout of the pool, more often from one of the better ones, with two large items in each other's place
 */
static void explore_disrupt(mus__nest_run *run)
{
    const mus__nest_problem *problem = run->problem;
    const int32_t n = problem->n;
    const double u = mus__nest_uniform(run);
    mus__nest_restore(run, &run->pool[(int32_t)(u * u * run->npool)]);
    double largest = 0.0;
    for (int32_t i = 0; i < n; i++) largest = fmax(largest, problem->area[i]);
    int32_t a = MUS_NONE, b = MUS_NONE, count = 0, others = 0;
    /* each large item is taken with equal chance; then another that is not its like */
    for (int32_t i = 0; i < n; i++)
        if (problem->area[i] >= EXPLORE_LARGE * largest && mus__nest_below(run, ++count) == 0) a = i;
    for (int32_t i = 0; i < n; i++)
        if (problem->area[i] >= EXPLORE_LARGE * largest && problem->area[i] != problem->area[a] &&
            mus__nest_below(run, ++others) == 0)
            b = i;
    if (b == MUS_NONE) b = mus__nest_below(run, n);
    mus__nest_at one = run->at[a], two = run->at[b];
    const double x = one.x, y = one.y;
    one.x = two.x;
    one.y = two.y;
    two.x = x;
    two.y = y;
    mus__nest_clamp(run, a, &one);
    mus__nest_clamp(run, b, &two);
    mus__nest_put(run, a, &one);
    mus__nest_put(run, b, &two);
}


/* explore until the steps of the run or the failures are used up */
static void explore_wide(mus__nest_run *run)
{
    double step = EXPLORE_STEP_MOST;
    int32_t failures = 0;
    while (!mus__nest_over(run) && failures < EXPLORE_FAILURES) {
        const double most = 1.0 - run->problem->shortest / run->best.length;
        const int64_t before = run->steps;
        if (most < EXPLORE_STEP_LEAST) return;
        step = fmin(step, most);
        explore_shorten(run, run->best.length * (1.0 - step), mus__nest_uniform(run) * run->length);
        run->npool = 0;
        /* a step above the least is a trial */
        const bool trial = step > EXPLORE_STEP_LEAST;
        bool done = explore_separate(run, trial ? 1 : EXPLORE_STRIKES, trial ? EXPLORE_TRIAL : EXPLORE_PATIENCE);
        for (; !done && !trial && !mus__nest_over(run);
             done = explore_separate(run, EXPLORE_STRIKES, EXPLORE_PATIENCE)) {
            explore_pool(run);
            if (++failures >= EXPLORE_FAILURES) break;
            explore_disrupt(run);
        }
        if (done)
            failures = 0;
        else
            mus__nest_restore(run, &run->best);
        const bool quick = (double)(run->steps - before) < EXPLORE_QUICK * (double)run->limit;
        step = !done   ? fmax(EXPLORE_STEP_LEAST, 0.25 * step)
               : quick ? fmin(EXPLORE_STEP_MOST, 2.0 * step)
                       : fmax(EXPLORE_STEP_LEAST, 0.5 * step);
    }
}


/* make the best layout shorter by ever smaller steps */
static void explore_compress(mus__nest_run *run)
{
    const int64_t start = run->steps;
    while (!mus__nest_over(run)) {
        const double done = (double)(run->steps - start) / (double)(run->limit - start + 1);
        const double step = EXPLORE_FINE_FIRST + (EXPLORE_FINE_LAST - EXPLORE_FINE_FIRST) * done;
        const double length = fmax(run->problem->shortest, run->best.length * (1.0 - step));
        if (!(length < run->best.length)) return;
        mus__nest_restore(run, &run->best);
        explore_shorten(run, length, mus__nest_uniform(run) * run->length);
        explore_separate(run, EXPLORE_FINE_STRIKES, EXPLORE_FINE_PATIENCE);
    }
}


void mus__nest_explore(mus__nest_run *run)
{
    const int64_t limit = run->limit;
    explore_columns(run);
    run->limit = (int64_t)(EXPLORE_WIDE * (double)limit);
    explore_wide(run);
    run->limit = limit;
    explore_compress(run);
}
