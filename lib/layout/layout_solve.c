/*
 * layout_solve.c: the ways in which each part may lie, and the search on the folded and on the open cloth.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "layout/layout_internal.h"

#define SOLVE_QUARTER 1.57079632679489661923 /* [rad] a quarter turn */
#define SOLVE_EXACT 1e-9 /* [rad] a turn this near a quarter turn is one; chosen: 10 nm over 10 m */
#define SOLVE_ANGLES 5   /* within the tolerance of the grain; chosen */

/* one search: the ways of its parts */
typedef struct solve_work {
    mus_layout *layout;
    double start, share; /* of progress */
    int32_t nway;
    mus__nest_way *ways;     /* (nway) */
    double (*turns)[4];      /* (nway) from the frame of the outline to the cloth */
    double (*boxes)[4];      /* (nway) of the cut line grown by the margin */
    double *xy;              /* points of all ways */
    int32_t *first;          /* (outlines x 4) first way of each outline and lie, or MUS_NONE */
    int32_t *count;          /* (outlines x 4) */
    mus__nest_item *items;   /* (n) */
    mus__nest_place *places; /* (n) */
} solve_work;


static void solve_free(solve_work *work)
{
    mus_context *context = work->layout->context;
    mus__free(context, work->ways);
    mus__free(context, work->turns);
    mus__free(context, work->boxes);
    mus__free(context, work->xy);
    mus__free(context, work->first);
    mus__free(context, work->count);
    mus__free(context, work->items);
    mus__free(context, work->places);
}


/* write the matrix of a turn; multiples of a quarter turn are exact */
static void solve_turn(double angle, double *out)
{
    const double quarters = nearbyint(angle / SOLVE_QUARTER);
    double cosine = mus__cos(angle), sine = mus__sin(angle);
    if (fabs(angle - quarters * SOLVE_QUARTER) < SOLVE_EXACT) {
        const int32_t way = (int32_t)(quarters - 4.0 * floor(quarters / 4.0));
        static const double cosines[4] = {1.0, 0.0, -1.0, 0.0}, sines[4] = {0.0, 1.0, 0.0, -1.0};
        cosine = cosines[way];
        sine = sines[way];
    }
    const double turn[4] = {cosine, -sine, sine, cosine};
    memcpy(out, turn, sizeof turn);
}


/* write the turns of an outline that lies so: out (at most 4 SOLVE_ANGLES, or its own); returns their number */
static int32_t solve_turns(const mus_layout *layout, const mus__layout_outline *outline, mus__layout_lie lie,
                           double (*out)[4])
{
    static const double signs[4][2] = {{1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}};
    const bool nap = layout->def.nap != 0;
    int32_t n = 0;
    for (int32_t k = 0; k < outline->turn_count; k++) solve_turn(outline->turns[k], out[n++]);
    if (n > 0) return n;
    for (int32_t k = 0; k < 4; k++) {
        /* 0 plain, 1 by half a turn, 2 turned over along the grain, 3 both; a half on the fold stays above it */
        const bool over = k >= 2, half = k % 2 == 1;
        if (half && nap) continue;
        if (lie == MUS__LIE_PLAIN && over) continue;
        if (lie == MUS__LIE_MIRRORED && !over) continue;
        if (lie == MUS__LIE_HALF && k != 0 && k != 3) continue;
        const int32_t angles = layout->def.tolerance > 0.0 && lie != MUS__LIE_HALF ? SOLVE_ANGLES : 1;
        for (int32_t a = 0; a < angles; a++) {
            double turn[4];
            solve_turn(layout->def.tolerance * ((a + 1) / 2) * (a % 2 == 0 ? 0.5 : -0.5), turn);
            for (int32_t d = 0; d < 4; d++) out[n][d] = turn[d] * signs[k][d % 2];
            n++;
        }
    }
    return n;
}


/* set what is kept within the strip, the cut line grown by the margin, and what is laid on a stripe: the lowest point
 * of the panel as it is drawn, which has the least x in the frame of the cloth; less the margin, so that the stripes of
 * the strip are those of the cloth */
static void solve_bounds(const mus_layout *layout, const mus__layout_polygon *cut, const double *turn, double *box,
                         mus__nest_way *way)
{
    int32_t least = 0;
    for (int32_t d = 0; d < 2; d++) {
        box[d] = HUGE_VAL;
        box[2 + d] = -HUGE_VAL;
    }
    for (int32_t i = 0; i < cut->n; i++) {
        if (cut->xy[2 * i] < cut->xy[2 * least]) least = i;
        for (int32_t d = 0; d < 2; d++) {
            const double at = turn[2 * d] * cut->xy[2 * i] + turn[2 * d + 1] * cut->xy[2 * i + 1];
            box[d] = fmin(box[d], at - layout->margin);
            box[2 + d] = fmax(box[2 + d], at + layout->margin);
        }
    }
    way->box = box;
    way->stripe = turn[0] * cut->xy[2 * least] + turn[1] * cut->xy[2 * least + 1] - layout->margin;
}


/* count the ways and points of all outlines and lies, and, with room for them, make them */
static void solve_ways(solve_work *work, int64_t *points, double (*turns)[4])
{
    const mus_layout *layout = work->layout;
    work->nway = 0;
    *points = 0;
    for (int32_t i = 0; i < 4 * layout->noutline; i++) {
        const mus__layout_outline *outline = &layout->outlines[i / 4];
        const mus__layout_lie lie = (mus__layout_lie)(i % 4);
        const mus__layout_polygon *grown = lie == MUS__LIE_HALF ? &outline->grown_half : &outline->grown;
        const int32_t n = grown->n == 0 ? 0 : solve_turns(layout, outline, lie, turns);
        for (int32_t k = 0; k < n; k++, work->nway++, *points += grown->n) {
            if (work->xy == NULL) continue;
            double *xy = work->xy + 2 * *points, *turn = work->turns[work->nway];
            memcpy(turn, turns[k], sizeof *turns);
            for (int32_t p = 0; p < grown->n; p++) {
                xy[2 * p] = turn[0] * grown->xy[2 * p] + turn[1] * grown->xy[2 * p + 1];
                xy[2 * p + 1] = turn[2] * grown->xy[2 * p] + turn[3] * grown->xy[2 * p + 1];
            }
            work->ways[work->nway].n = grown->n;
            work->ways[work->nway].xy = xy;
            solve_bounds(layout, lie == MUS__LIE_HALF ? &outline->half : &outline->cut, turn, work->boxes[work->nway],
                         &work->ways[work->nway]);
        }
        if (work->xy == NULL) continue;
        work->first[i] = work->nway - n;
        work->count[i] = n;
    }
}


static mus_status solve_make(mus_layout *layout, solve_work *work)
{
    mus_context *context = layout->context;
    int32_t most = 4 * SOLVE_ANGLES;
    int64_t points;
    for (int32_t i = 0; i < layout->noutline; i++)
        most = layout->outlines[i].turn_count > most ? layout->outlines[i].turn_count : most;
    double(*turns)[4] = mus__new(context, most, sizeof *turns);
    if (turns == NULL) return mus__fail_memory(context, "the ways of a layout");
    solve_ways(work, &points, turns);
    work->ways = mus__new(context, work->nway, sizeof *work->ways);
    work->turns = mus__new(context, work->nway, sizeof *work->turns);
    work->boxes = mus__new(context, work->nway, sizeof *work->boxes);
    work->first = mus__new(context, layout->noutline, 4 * sizeof *work->first);
    work->count = mus__new(context, layout->noutline, 4 * sizeof *work->count);
    work->items = mus__new(context, layout->npart, sizeof *work->items);
    work->places = mus__new(context, layout->npart, sizeof *work->places);
    double *xy = mus__new(context, points, 2 * sizeof *xy);
    const bool made = work->ways != NULL && work->turns != NULL && work->boxes != NULL && work->first != NULL &&
                      work->count != NULL && work->items != NULL && work->places != NULL && xy != NULL;
    work->xy = xy;
    if (made) solve_ways(work, &points, turns);
    mus__free(context, turns);
    return made ? MUS_OK : mus__fail_memory(context, "the ways of a layout");
}


static int32_t solve_progress(void *user, double done, double length)
{
    const solve_work *work = user;
    const mus_layout *layout = work->layout;
    return layout->def.progress(layout->def.user, work->start + work->share * done, layout->length + length);
}


/* lay the parts of the folded or of the open cloth, from the length so far on; sets turn, shift and the length */
static mus_status solve_cloth(solve_work *work, bool folded)
{
    mus_layout *layout = work->layout;
    const mus_layout_def *def = &layout->def;
    int32_t n = 0, bad;
    for (int32_t i = 0; i < layout->npart; i++) {
        const mus__layout_part *part = &layout->parts[i];
        if (part->folded != folded) continue;
        const int32_t way = 4 * part->outline + (int32_t)part->lie;
        work->items[n].nway = work->count[way];
        work->items[n].ways = work->ways + work->first[way];
        work->items[n++].edge = part->lie == MUS__LIE_HALF;
    }
    if (n == 0) return MUS_OK;
    const mus__nest_def nest = {.height =
                                    (folded ? 0.5 : 1.0) * def->width + 2.0 * layout->margin + MUS__LAYOUT_ROUNDING,
                                .stripe = def->stripe,
                                .steps = def->steps,
                                .runs = def->runs,
                                .threads = def->threads,
                                .seed = def->seed,
                                .progress = def->progress != NULL ? solve_progress : NULL,
                                .user = work};
    double length;
    int64_t steps;
    const mus_status status =
        mus__nest_solve(layout->context, n, work->items, &nest, work->places, &length, &steps, &bad);
    if (status == MUS_OK) layout->steps += steps;
    double from = layout->length > 0.0 ? layout->length + def->gap : 0.0;
    if (def->stripe > 0.0) from = ceil(from / def->stripe) * def->stripe; /* the stripes run on */
    for (int32_t i = 0, k = 0; i < layout->npart; i++) {
        mus__layout_part *part = &layout->parts[i];
        const mus__layout_outline *outline = &layout->outlines[part->outline];
        if (part->folded != folded) continue;
        if (status == MUS_ERR_ARG && k == bad)
            return mus__fail(layout->context, MUS_ERR_ARG,
                             "piece %d %.100s is wider than the cloth of %g m in every way it may lie",
                             (int)outline->panel, outline->name, def->width);
        if (status == MUS_OK) {
            const mus__nest_place *place = &work->places[k];
            memcpy(part->turn, work->turns[work->items[k].ways - work->ways + place->way], sizeof part->turn);
            part->shift[0] = from + place->x - layout->margin;
            part->shift[1] = place->y - layout->margin;
            const mus__layout_polygon *cut = part->lie == MUS__LIE_HALF ? &outline->half : &outline->cut;
            for (int32_t p = 0; p < cut->n; p++)
                layout->length = fmax(layout->length, part->turn[0] * cut->xy[2 * p] +
                                                          part->turn[1] * cut->xy[2 * p + 1] + part->shift[0]);
        }
        k++;
    }
    return status;
}


mus_status mus__layout_solve(mus_layout *layout, double start, double share)
{
    solve_work work = {.layout = layout, .start = start, .share = 0.5 * share};
    layout->length = layout->folded = 0.0;
    mus_status status = solve_make(layout, &work);
    if (status == MUS_OK) status = solve_cloth(&work, true);
    layout->folded = layout->length;
    work.start += work.share;
    if (status == MUS_OK) status = solve_cloth(&work, false);
    solve_free(&work);
    return status;
}
