/*
 * nest.c: a packing problem made of the caller's items, its runs shared among threads, and the shortest layout taken.
 *
 * Each run has a seed and a number of steps of its own and knows nothing of the others. Among layouts of equal length
 * the run with the lowest number wins, so the result is the same for any number of threads.
 */
#include <math.h>
#include <string.h>

#include "base/thread_pool.h"
#include "geom/polygon.h"
#include "nest/nest_run.h"


typedef struct nest_work {
    mus__nest_problem problem;
    double *xy;    /* points of all shapes */
    double *boxes; /* of their runs of sides */
    int32_t nrun;
    mus__nest_run *runs; /* (nrun) */
    _Atomic int32_t stop;
} nest_work;


static void nest_free_run(mus_context *context, mus__nest_run *run)
{
    mus__free(context, run->at);
    mus__free(context, run->box);
    mus__free(context, run->loss);
    mus__free(context, run->weight);
    mus__free(context, run->order);
    mus__free(context, run->near);
    mus__free(context, run->corners);
    mus__free(context, run->best.at);
    mus__free(context, run->least.at);
    for (int32_t k = 0; k < MUS__NEST_POOL; k++) mus__free(context, run->pool[k].at);
}


static void nest_free(mus_context *context, nest_work *work)
{
    for (int32_t k = 0; k < work->nrun; k++) nest_free_run(context, &work->runs[k]);
    mus__free(context, work->runs);
    mus__free(context, work->xy);
    mus__free(context, work->boxes);
    mus__free(context, work->problem.shapes);
    mus__free(context, work->problem.first);
    mus__free(context, work->problem.nway);
    mus__free(context, work->problem.edge);
    mus__free(context, work->problem.area);
}


static mus_status nest_make_run(mus_context *context, const mus__nest_problem *problem, int32_t index,
                                mus__nest_run *run)
{
    const int64_t n = problem->n;
    run->problem = problem;
    run->index = index;
    run->random = problem->def->seed + (uint64_t)index * UINT64_C(0x632be59bd9b4e019);
    run->limit = problem->def->steps;
    run->at = mus__new(context, n, sizeof *run->at);
    run->box = mus__new(context, n, 4 * sizeof *run->box);
    run->loss = mus__new(context, n * n, sizeof *run->loss);
    run->weight = mus__new(context, n * n, sizeof *run->weight);
    run->order = mus__new(context, n, sizeof *run->order);
    run->near = mus__new(context, problem->most, sizeof *run->near);
    run->corners = mus__new(context, problem->most, 4 * sizeof *run->corners);
    run->best.at = mus__new(context, n, sizeof *run->best.at);
    run->least.at = mus__new(context, n, sizeof *run->least.at);
    bool made = run->at != NULL && run->box != NULL && run->loss != NULL && run->weight != NULL && run->order != NULL &&
                run->near != NULL && run->corners != NULL && run->best.at != NULL && run->least.at != NULL;
    for (int32_t k = 0; k < MUS__NEST_POOL; k++) {
        run->pool[k].at = mus__new(context, n, sizeof *run->pool[k].at);
        made = made && run->pool[k].at != NULL;
    }
    return made ? MUS_OK : mus__fail_memory(context, "the search of a layout");
}


/* whether two ways are the same polygon: then they share a shape */
static bool nest_same(const mus__nest_way *a, const mus__nest_way *b)
{
    return a->n == b->n && a->xy == b->xy && memcmp(&a->stripe, &b->stripe, sizeof a->stripe) == 0;
}


/* make the shapes of the items; items with the same ways share them */
static mus_status nest_make_shapes(mus_context *context, const mus__nest_item *items, nest_work *work)
{
    mus__nest_problem *problem = &work->problem;
    int64_t points = 0, runs = 0;
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < problem->n && status == MUS_OK; i++) {
        int32_t same = i - 1;
        for (; same >= 0; same--) {
            bool equal = items[same].nway == items[i].nway;
            for (int32_t k = 0; k < items[i].nway && equal; k++)
                equal = nest_same(&items[same].ways[k], &items[i].ways[k]);
            if (equal) break;
        }
        problem->nway[i] = items[i].nway;
        problem->edge[i] = items[i].edge;
        problem->first[i] = same >= 0 ? problem->first[same] : problem->nshape;
        for (int32_t k = 0; k < items[i].nway && status == MUS_OK && same < 0; k++) {
            const mus__nest_way *way = &items[i].ways[k];
            status = mus__nest_shape_make(context, way, work->xy + 2 * points, work->boxes + 4 * runs,
                                          &problem->shapes[problem->nshape++]);
            points += way->n;
            runs += mus__nest_runs(way->n);
        }
        const double size = problem->shapes[problem->first[i]].size;
        problem->area[i] = size * size;
    }
    return status;
}


/* compute the bound of the length; false when an item does not fit, *bad is its index */
static bool nest_bound(mus__nest_problem *problem, int32_t *bad)
{
    double area = 0.0;
    for (int32_t i = 0; i < problem->n; i++) {
        double width = HUGE_VAL;
        for (int32_t k = 0; k < problem->nway[i]; k++) {
            const mus__nest_shape *shape = &problem->shapes[problem->first[i] + k];
            if (mus__nest_fits(problem, shape, HUGE_VAL)) width = fmin(width, shape->high[0] - shape->low[0]);
        }
        if (!(width < HUGE_VAL)) {
            *bad = i;
            return false;
        }
        const mus__nest_shape *shape = &problem->shapes[problem->first[i]];
        problem->shortest = fmax(problem->shortest, width);
        area += fabs(mus__polygon_area(shape->n, shape->xy));
    }
    problem->shortest = fmax(problem->shortest, area / problem->def->height);
    return true;
}


static mus_status nest_make(mus_context *context, const mus__nest_item *items, nest_work *work, int32_t *bad)
{
    mus__nest_problem *problem = &work->problem;
    const int64_t n = problem->n;
    int64_t points = 0, ways = 0, runs = 0;
    for (int32_t i = 0; i < problem->n; i++) {
        ways += items[i].nway;
        for (int32_t k = 0; k < items[i].nway; k++) {
            points += items[i].ways[k].n;
            runs += mus__nest_runs(items[i].ways[k].n);
            problem->most = items[i].ways[k].n > problem->most ? items[i].ways[k].n : problem->most;
        }
    }
    work->xy = mus__new(context, points, 2 * sizeof *work->xy);
    work->boxes = mus__new(context, runs, 4 * sizeof *work->boxes);
    problem->shapes = mus__new(context, ways, sizeof *problem->shapes);
    problem->first = mus__new(context, n, sizeof *problem->first);
    problem->nway = mus__new(context, n, sizeof *problem->nway);
    problem->edge = mus__new(context, n, sizeof *problem->edge);
    problem->area = mus__new(context, n, sizeof *problem->area);
    work->runs = mus__new(context, problem->def->runs, sizeof *work->runs);
    if (work->xy == NULL || work->boxes == NULL || problem->shapes == NULL || problem->first == NULL ||
        problem->nway == NULL || problem->edge == NULL || problem->area == NULL || work->runs == NULL)
        return mus__fail_memory(context, "the items of a layout");
    mus_status status = nest_make_shapes(context, items, work);
    if (status == MUS_OK && !nest_bound(problem, bad))
        return mus__fail(context, MUS_ERR_ARG, "item %d: wider than the strip of %g in every way", *bad,
                         problem->def->height);
    for (; work->nrun < problem->def->runs && status == MUS_OK; work->nrun++)
        status = nest_make_run(context, problem, work->nrun, &work->runs[work->nrun]);
    return status;
}


static void nest_part(void *user, int32_t part, int32_t parts)
{
    nest_work *work = user;
    for (int32_t k = part; k < work->nrun; k += parts) {
        mus__nest_run *run = &work->runs[k];
        run->tells = part == 0;
        run->stop = &work->stop;
        mus__nest_explore(run);
    }
}


mus_status mus__nest_solve(mus_context *context, int32_t n, const mus__nest_item *items, const mus__nest_def *def,
                           mus__nest_place *places, double *length, int64_t *steps, int32_t *bad)
{
    nest_work work = {.problem = {.def = def, .n = n}};
    mus__pool *pool = NULL;
    *bad = MUS_NONE;
    mus_status status = nest_make(context, items, &work, bad);
    const int32_t threads = def->threads < def->runs ? def->threads : def->runs;
    if (status == MUS_OK) status = mus__pool_create(context, threads, &pool);
    if (status == MUS_OK) {
        mus__pool_run(pool, nest_part, &work);
        const mus__nest_run *best = &work.runs[0];
        int64_t sum = 0;
        for (int32_t k = 0; k < work.nrun; k++) {
            if (work.runs[k].best.length < best->best.length) best = &work.runs[k];
            sum += work.runs[k].steps;
        }
        *length = best->best.length;
        if (steps != NULL) *steps = sum;
        for (int32_t i = 0; i < n; i++)
            mus__nest_placed(mus__nest_shape_of(best, i, best->best.at[i].way), &best->best.at[i], &places[i]);
    }
    mus__pool_destroy(pool);
    nest_free(context, &work);
    return status;
}
