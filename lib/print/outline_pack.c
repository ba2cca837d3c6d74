/*
 * outline_pack.c: pack outlines on a strip of paper, in a given order: each at the place nearest to the top of the
 * strip where it fits among those before it, also in their hollows (bottom-left on true outlines, upside down). An
 * outline may be turned by half a turn, by a quarter where it has such a shape too, and the half of a piece on the fold
 * mirrored.
 *
 * The strip is cut into upright slabs of equal width. In a slab an outline is a list of spans that it covers, measured
 * down from its top; it is grown by half the gap all round first. A place is a whole number of slabs from the left:
 *
 *        |  |   |  |   |       An outline with its first slab on slab s of the strip collides at the distances y from
 *        |  |\  |  |  /|       the top for which one of its spans, moved down by y, meets a span of the strip. y starts
 *        |  | '-|--|-' |       at 0 and is raised over each span that it meets, until none is met.
 *
 * The cost of a shape is that of its chords times the slabs that each comes near.
 * Source: Chazelle, The bottom-left bin-packing heuristic, 1983; spans in slabs as in Bennell and Oliveira, The
 * geometry of nesting problems, 2008, section 2.1 (raster method).
 */
#include <math.h>
#include <string.h>

#include "print/outline_pack.h"

#define STRIDE 0.008 /* [m] from place to place; chosen: twice as much takes half the time and packs a little looser */
#define SAMPLED 8    /* every which slab is looked at first; chosen: with fewer a place is seldom found wrong */
#define PAGE_PARTS 8 /* places tried in the width of a page; chosen: more seldom save a page */
#define SLABS_MOST 1e6 /* most slabs of a shape; chosen: bounds the memory */


/* ---- the spans of an outline ---- */

/* add a span to the slab's spans from `first` on, joined with those that it touches */
static void shape_span(mus__shape *shape, int32_t first, double low, double high)
{
    for (int32_t i = first; i < shape->nspan;) {
        double *span = shape->spans + 2 * i;
        if (low > span[1] || high < span[0]) {
            i++;
            continue;
        }
        low = low < span[0] ? low : span[0];
        high = high > span[1] ? high : span[1];
        shape->nspan--;
        memmove(span, span + 2, 2 * (size_t)(shape->nspan - i) * sizeof *span);
    }
    shape->spans[2 * shape->nspan] = low;
    shape->spans[2 * shape->nspan + 1] = high;
    shape->nspan++;
}


/* the part of the chord a, b in the slab left .. right as a span; false when it has none */
static bool shape_clip(const double *a, const double *b, double left, double right, double *span)
{
    const double *from = a[0] <= b[0] ? a : b, *to = a[0] <= b[0] ? b : a;
    if (to[0] < left || from[0] > right) return false;
    const double dx = to[0] - from[0], slope = dx > 0.0 ? (to[1] - from[1]) / dx : 0.0;
    const double y = from[0] < left ? from[1] + slope * (left - from[0]) : from[1];
    const double z = to[0] > right ? from[1] + slope * (right - from[0]) : to[1];
    span[0] = y < z ? y : z;
    span[1] = y < z ? z : y;
    return true;
}


/* chords of outlines by the slabs that they come near, so that a slab looks at its own alone */
typedef struct shape_near {
    const double *(*ends)[2]; /* (chords) */
    int32_t *outline;         /* (chords) */
    int32_t *start;           /* (slabs + 1) */
    int32_t *chords;          /* (start[slabs]) ascending in each slab */
} shape_near;


static void near_free(mus_context *context, shape_near *near)
{
    mus__print_free(context, near->ends);
    mus__print_free(context, near->outline);
    mus__print_free(context, near->start);
    mus__print_free(context, near->chords);
}


/* the first and the last slab that a chord may meet, one more on both sides for rounding; `left` is the left end of the
 * outline, and slabs are grown by the gap */
static void near_slabs(const mus__shape *shape, const double *const *ends, double left, double gap, int32_t *out)
{
    const double a = ends[0][0] - left, b = ends[1][0] - left;
    const double low = floor((a < b ? a : b) / shape->slab) - 2.0;
    const double high = floor(((a < b ? b : a) + gap) / shape->slab) + 1.0;
    out[0] = low > 0.0 ? (int32_t)low : 0;
    out[1] = high < shape->nslab - 1 ? (int32_t)high : shape->nslab - 1;
}


/* list the `points` chords of the outlines by slab; freed by the caller, also after a failure */
static mus_status near_make(mus_context *context, const mus__shape *shape, int32_t nloops,
                            const mus__loops *const *loops, int64_t points, double left, double gap, shape_near *near)
{
    int32_t n = 0, span[2];
    int64_t listed = 0;
    near->ends = mus__print_new(context, points, sizeof *near->ends);
    near->outline = mus__print_new(context, points, sizeof *near->outline);
    near->start = mus__print_new(context, (int64_t)shape->nslab + 1, sizeof *near->start);
    if (near->ends == NULL || near->outline == NULL || near->start == NULL)
        return mus__print_memory(context, "the chords of a piece");
    memset(near->start, 0, ((size_t)shape->nslab + 1) * sizeof *near->start);
    for (int32_t k = 0; k < nloops; k++) {
        const mus__loops *l = loops[k];
        for (int32_t m = 0; m < l->nloop; m++) {
            for (int32_t i = l->start[m]; i < l->start[m + 1]; i++, n++) {
                near->ends[n][0] = l->xy + 2 * i;
                near->ends[n][1] = l->xy + 2 * (i + 1 < l->start[m + 1] ? i + 1 : l->start[m]);
                near->outline[n] = k;
                near_slabs(shape, near->ends[n], left, gap, span);
                listed += span[1] - span[0] + 1;
                if (listed > INT32_MAX) return mus__print_memory(context, "the chords of a piece");
                for (int32_t s = span[0]; s <= span[1]; s++) near->start[s]++;
            }
        }
    }
    near->chords = mus__print_new(context, listed, sizeof *near->chords);
    if (near->chords == NULL) return mus__print_memory(context, "the chords of a piece");
    for (int32_t s = 0; s < shape->nslab; s++) near->start[s + 1] += near->start[s];
    /* from the last chord on: each start comes down from the end of its slab */
    while (n-- > 0) {
        near_slabs(shape, near->ends[n], left, gap, span);
        for (int32_t s = span[0]; s <= span[1]; s++) near->chords[--near->start[s]] = n;
    }
    return MUS_OK;
}


/* add the parts where the upright line at x runs inside an outline, n of whose chords may meet it: between odd and even
 * crossings. Crossings are found one after the other from below, since a line meets few chords */
static void shape_chords(mus__shape *shape, int32_t first, const shape_near *near, const int32_t *chords, int32_t n,
                         double x)
{
    double from = -HUGE_VAL;
    for (;;) {
        double pair[2] = {HUGE_VAL, HUGE_VAL};
        for (int32_t i = 0; i < n; i++) {
            const double *a = near->ends[chords[i]][0], *b = near->ends[chords[i]][1];
            if ((a[0] > x) == (b[0] > x)) continue;
            const double y = a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
            if (y <= from) continue;
            if (y < pair[0]) pair[1] = pair[0], pair[0] = y;
            else if (y < pair[1]) pair[1] = y;
        }
        if (!(pair[1] < HUGE_VAL)) return;
        shape_span(shape, first, pair[0], pair[1]);
        from = pair[1];
    }
}


/* add the spans of the slab that holds the points between `left` and `right`: its n chords, outline after outline */
static void shape_slab_spans(mus__shape *shape, const shape_near *near, const int32_t *chords, int32_t n, double left,
                             double right)
{
    const int32_t first = shape->nspan;
    for (int32_t i = 0, end = 0; i < n; i = end) {
        while (end < n && near->outline[chords[end]] == near->outline[chords[i]]) {
            double span[2];
            const double *const *ends = near->ends[chords[end++]];
            if (shape_clip(ends[0], ends[1], left, right, span)) shape_span(shape, first, span[0], span[1]);
        }
        shape_chords(shape, first, near, chords + i, end - i, left);
        shape_chords(shape, first, near, chords + i, end - i, right);
    }
}


mus_status mus__shape_make(mus_context *context, int32_t nloops, const mus__loops *const *loops, const double *box,
                           double gap, double slab, mus__shape *shape)
{
    int64_t points = 0;
    for (int32_t k = 0; k < nloops; k++) points += loops[k]->n;
    memset(shape, 0, sizeof *shape);
    shape->height = box[3] - box[1] + gap;
    shape->width = box[2] - box[0];
    const double slabs = ceil((shape->width + gap) / slab - 1e-9);
    shape->slab = slab;
    if (!(slabs < SLABS_MOST))
        return mus__file_fail(context, MUS_ERR_LIMIT, "a piece is wider than %.0f m", SLABS_MOST * slab);
    shape->nslab = slabs < 1.0 ? 1 : (int32_t)slabs;
    shape->start = mus__print_new(context, (int64_t)shape->nslab + 1, sizeof *shape->start);
    if (shape->start == NULL) return mus__print_memory(context, "the spans of a piece");

    shape_near near = {NULL, NULL, NULL, NULL};
    mus_status status = near_make(context, shape, nloops, loops, points, box[0], gap, &near);
    for (int32_t s = 0; s < shape->nslab && status == MUS_OK; s++) {
        const int32_t first = shape->start[s] = shape->nspan, n = near.start[s + 1] - near.start[s];
        status = mus__print_reserve(context, &shape->spans, &shape->room, 2 * (shape->nspan + 3 * (int64_t)n + 2),
                                    sizeof *shape->spans);
        if (status != MUS_OK) break;
        shape_slab_spans(shape, &near, near.chords + near.start[s], n, box[0] + s * slab - gap,
                         box[0] + (s + 1) * slab);
        for (int32_t i = first; i < shape->nspan; i++) {
            const double low = shape->spans[2 * i];
            shape->spans[2 * i] = box[3] - shape->spans[2 * i + 1];
            shape->spans[2 * i + 1] = box[3] - low + gap;
        }
    }
    shape->start[shape->nslab] = shape->nspan;
    near_free(context, &near);
    return status;
}


mus_status mus__shape_make_lying(mus_context *context, int32_t nloops, const mus__loops *const *loops,
                                 const double *box, double gap, double slab, mus__shape *shape)
{
    int64_t points = 0;
    double turned[4];
    for (int32_t k = 0; k < nloops; k++) points += loops[k]->n;
    double *xy = mus__print_new(context, points, 2 * sizeof *xy), *at = xy;
    mus__loops *own = mus__print_new(context, nloops, sizeof *own);
    const mus__loops **list = mus__print_new(context, nloops, sizeof *list);
    mus_status status = MUS_OK;
    if (xy == NULL || own == NULL || list == NULL) status = mus__print_memory(context, "the layout of a sheet");
    for (int32_t k = 0; k < nloops && status == MUS_OK; k++) {
        own[k] = *loops[k];
        own[k].xy = at;
        for (int32_t i = 0; i < own[k].n; i++, at += 2)
            at[0] = -loops[k]->xy[2 * i + 1], at[1] = loops[k]->xy[2 * i];
        list[k] = &own[k];
    }
    mus__box_quarter(box, turned);
    if (status == MUS_OK) status = mus__shape_make(context, nloops, list, turned, gap, slab, shape);
    mus__print_free(context, list);
    mus__print_free(context, own);
    mus__print_free(context, xy);
    return status;
}


double mus__shape_narrow(const mus__shape *shape)
{
    return shape->lying != NULL ? fmin(shape->lying->width, shape->width) : shape->width;
}


void mus__shape_free(mus_context *context, mus__shape *shape)
{
    mus__print_free(context, shape->start);
    mus__print_free(context, shape->spans);
    memset(shape, 0, sizeof *shape);
}


/* ---- places on the strip ---- */

/* the spans of slab s of a shape as it lies, still measured from its own top */
static const double *shape_slab(const mus__shape *shape, const bool *flip, int32_t s, int32_t *count)
{
    const int32_t k = flip[0] ? shape->nslab - 1 - s : s;
    *count = shape->start[k + 1] - shape->start[k];
    return shape->spans + 2 * shape->start[k];
}


/* raise *y until each `step`-th slab of the shape, its first slab on slab s, lies free; false at `limit` or above */
static bool strip_raise(const mus__strip *strip, const mus__shape *shape, const bool *flip, int32_t s, int32_t step,
                        double limit, double *y)
{
    double at = *y;
    /* round the slabs until none has raised y since it was raised last */
    for (int32_t k = 0, quiet = 0; quiet < shape->nslab; k = k + step < shape->nslab ? k + step : 0, quiet += step) {
        int32_t count;
        const double *spans = shape_slab(shape, flip, k, &count);
        for (int32_t node = strip->first[s + k]; node != MUS_NONE; node = strip->next[node]) {
            const double *taken = strip->spans + 2 * node;
            for (int32_t i = 0; i < count; i++) {
                const double low = flip[1] ? shape->height - spans[2 * i + 1] : spans[2 * i];
                const double high = flip[1] ? shape->height - spans[2 * i] : spans[2 * i + 1];
                if (at + low > taken[1] - 1e-12 || at + high < taken[0] + 1e-12) continue;
                at = taken[1] - low;
                if (at >= limit) return false;
                /* this slab is looked at again: the list is not sorted */
                quiet = -step;
            }
        }
    }
    *y = at;
    return at < limit;
}


/* compute the least distance from the top at which the shape lies free with its first slab on slab s; false at `limit`
 * or above. A part of the slabs asks for no more than all of them, and mostly for enough to turn a place down */
static bool strip_rest(const mus__strip *strip, const mus__shape *shape, const bool *flip, int32_t s, double limit,
                       double *out)
{
    double y = 0.0;
    if (!strip_raise(strip, shape, flip, s, SAMPLED, limit, &y)) return false;
    if (!strip_raise(strip, shape, flip, s, 1, limit, &y)) return false;
    *out = y;
    return true;
}


static void strip_put(mus__strip *strip, const mus__shape *shape, const mus__place *place)
{
    for (int32_t k = 0; k < shape->nslab; k++) {
        int32_t count;
        const double *spans = shape_slab(shape, place->flip, k, &count);
        for (int32_t i = 0; i < count; i++) {
            double *span = strip->spans + 2 * strip->nspan;
            span[0] = place->y + (place->flip[1] ? shape->height - spans[2 * i + 1] : spans[2 * i]);
            span[1] = place->y + (place->flip[1] ? shape->height - spans[2 * i] : spans[2 * i + 1]);
            strip->next[strip->nspan] = strip->first[place->slab + k];
            strip->first[place->slab + k] = strip->nspan++;
        }
    }
}


mus_status mus__strip_make(mus_context *context, int32_t n, const mus__shape *shapes, double widest, mus__strip *strip)
{
    int64_t spans = 0;
    memset(strip, 0, sizeof *strip);
    for (int32_t i = 0; i < n; i++) {
        const mus__shape *lying = shapes[i].lying;
        spans += lying != NULL && lying->nspan > shapes[i].nspan ? lying->nspan : shapes[i].nspan;
    }
    strip->slab = n > 0 ? shapes[0].slab : widest;
    strip->room = (int32_t)(widest / strip->slab) + 2;
    strip->first = mus__print_new(context, strip->room, sizeof *strip->first);
    strip->next = mus__print_new(context, spans, sizeof *strip->next);
    strip->spans = mus__print_new(context, spans, 2 * sizeof *strip->spans);
    if (strip->first == NULL || strip->next == NULL || strip->spans == NULL)
        return mus__print_memory(context, "the layout of a sheet");
    return MUS_OK;
}


void mus__strip_free(mus_context *context, mus__strip *strip)
{
    mus__print_free(context, strip->first);
    mus__print_free(context, strip->next);
    mus__print_free(context, strip->spans);
    memset(strip, 0, sizeof *strip);
}


/* the place of a shape that is looked for, and what it costs */
typedef struct strip_quest {
    const mus__strip *strip;
    double gap;           /* that the shapes are grown by [m] */
    int32_t nslab, fresh; /* pages that the best place takes anew */
    mus__place best;
} strip_quest;


/* number of pages that a place takes and that no shape before it took, not counted beyond `most`: of each SAMPLED slab
 * and the last one. With `fill` all slabs are asked, and the pages are taken */
static int32_t quest_pages(const strip_quest *q, const mus__shape *shape, const mus__place *place, int32_t most,
                           bool fill)
{
    mus__pages *pages = q->strip->pages;
    const double column_step = 1.0 / pages->step[0], row_step = 1.0 / pages->step[1];
    const int32_t stride = fill ? 1 : SAMPLED;
    int32_t count = 0, n;
    pages->stamp++;
    for (int32_t at = 0; at < shape->nslab - 1 + stride; at += stride) {
        const int32_t k = at < shape->nslab ? at : shape->nslab - 1;
        const double x = (place->slab + k) * shape->slab + pages->border;
        const double *spans = shape_slab(shape, place->flip, k, &n);
        int32_t column = (int32_t)(x * column_step);
        column = column < pages->columns ? column : pages->columns - 1;
        for (int32_t i = 0; i < n; i++) {
            /* the outline without the gap that it is grown by */
            const double low = place->flip[1] ? shape->height - spans[2 * i + 1] : spans[2 * i];
            const double high = (place->flip[1] ? shape->height - spans[2 * i] : spans[2 * i + 1]) - q->gap;
            const double top = place->y + pages->border;
            int32_t row = (int32_t)((top + low) * row_step);
            const int32_t last = (int32_t)((top + (high > low ? high : low)) * row_step);
            for (; row <= last && row < pages->rows; row++) {
                int32_t *seen = &pages->seen[row * pages->columns + column];
                if (*seen == -1 || *seen == pages->stamp) continue;
                *seen = fill ? -1 : pages->stamp;
                if (++count > most) return count;
            }
        }
    }
    return count;
}


/* take the place with the first slab on s for the best when it takes fewer pages anew, or as many nearer to the top */
static void quest_try(strip_quest *q, const mus__shape *shape, const mus__shape *own, const bool *flip, int32_t s)
{
    mus__place place = {.slab = s, .quarter = own != shape, .flip = {flip[0], flip[1]}};
    const double nearer = q->best.y - own->slab;
    if (!strip_rest(q->strip, own, flip, s, q->fresh > 0 ? HUGE_VAL : nearer, &place.y)) return;
    const int32_t fresh = q->strip->pages != NULL ? quest_pages(q, own, &place, q->fresh, false) : 0;
    if (fresh > q->fresh || (fresh == q->fresh && place.y >= nearer)) return;
    q->fresh = fresh;
    q->best = place;
}


/* look for a place of a shape that may be turned and flipped as `shape`: at each STRIDE, or at each part of a page, and
 * at the last slab */
static void quest_search(strip_quest *q, const mus__shape *shape, const mus__shape *own)
{
    static const bool flips[4][2] = {{false, false}, {true, true}, {true, false}, {false, true}};
    const int32_t last = q->nslab - own->nslab, ways = shape->flips ? 4 : shape->turns ? 2 : 1;
    const mus__pages *pages = q->strip->pages;
    const double step = pages != NULL ? pages->step[0] / PAGE_PARTS : STRIDE;
    const double border = pages != NULL ? pages->border : 0.0;
    for (int32_t k = 1, s = 0; s <= last && (q->best.y > 0.0 || q->fresh > 0); k++) {
        for (int32_t i = 0; i < ways; i++) quest_try(q, shape, own, flips[(shape->first + i) % ways], s);
        if (s == last) break;
        s = (int32_t)ceil((k * step - border) / own->slab);
        s = s < last ? s : last;
    }
}


/* find the place of a shape nearest to the top, with pages of those that take fewest anew, of those that differ by less
 * than a slab the leftmost; then moved to the left while it does not sink. y is HUGE_VAL when the shape is too wide */
static mus__place strip_find(const mus__strip *strip, const mus__shape *shape, int32_t nslab, double gap)
{
    const mus__pages *pages = strip->pages;
    strip_quest q = {strip, gap, nslab, pages != NULL ? INT32_MAX - 1 : 0, {.y = HUGE_VAL}};
    const bool lying = shape->lying != NULL && shape->first >= 4;
    if (lying) quest_search(&q, shape, shape->lying);
    quest_search(&q, shape, shape);
    if (shape->lying != NULL && !lying) quest_search(&q, shape, shape->lying);
    const mus__shape *own = q.best.quarter ? shape->lying : shape;
    while (q.best.slab > 0) {
        mus__place left = q.best;
        left.slab--;
        if (!strip_rest(strip, own, left.flip, left.slab, left.y + 1e-9, &left.y)) break;
        if (pages != NULL && quest_pages(&q, own, &left, q.fresh, false) > q.fresh) break;
        q.best.slab = left.slab;
        q.best.y = fmin(q.best.y, left.y);
    }
    if (pages != NULL && q.best.y < HUGE_VAL) quest_pages(&q, own, &q.best, INT32_MAX, true);
    return q.best;
}


double mus__strip_pack(mus__strip *strip, int32_t n, const mus__shape *shapes, const int32_t *order, double width,
                       double gap, mus__place *places)
{
    /* the gap is part of each shape, so the strip is one gap wider */
    const int32_t nslab = (int32_t)((width + gap) / strip->slab + 1e-9);
    double used = 0.0;
    if (nslab > strip->room) return -1.0;
    strip->nspan = 0;
    for (int32_t s = 0; s < nslab; s++) strip->first[s] = MUS_NONE;
    for (int32_t i = 0; i < n; i++) {
        const mus__shape *shape = &shapes[order[i]];
        const mus__place best = strip_find(strip, shape, nslab, gap);
        if (!(best.y < HUGE_VAL)) return -1.0; /* wider than the strip */
        if (best.quarter) shape = shape->lying;
        strip_put(strip, shape, &best);
        places[order[i]] = best;
        /* mirrored, the shape ends with its last slab, which it may fill in part */
        places[order[i]].x = best.slab * shape->slab;
        if (best.flip[0]) places[order[i]].x += shape->nslab * shape->slab - gap - shape->width;
        const double top = best.y + shape->height;
        used = top > used ? top : used;
    }
    return used > gap ? used - gap : 0.0;
}
