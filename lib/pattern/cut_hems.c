/*
 * cut_hems.c: the ends of a hem's allowance, so that the hem lies flush when it is turned up along its line.
 *
 * A hem of depth h is folded on its line; its ends then lie on the cut lines of the neighbours, which they must equal.
 * So each end is the neighbour's cut line, mirrored in the hem line up to the depth h:
 *
 *      |  /        / cut line of the side: w beyond its sew line V S
 *      | S        /
 *      |/        /        X  where that cut line meets the hem line, on the fold
 *      V - - - -X         Y  its mirror image at the depth h; the hem's cut line begins there
 *      |         \
 *      +-----------Y--    a side that leans outwards gives a hem that leans inwards, and the other way round
 *
 * On a curved hem the mirror image of q is 2 f - q, with f the nearest point of the hem line: q and its image are at
 * the same arc length of the hem, at the same distance on both sides of it. Beyond its end the hem goes on straight.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "pattern/cut_ring.h"

/* largest |cosine| of a corner whose hem is turned up: within 38 degrees of square. Chosen: a side that leans more
 * would make the hem's end a sliver */
#define HEM_TURN 0.61
/* least cosine between two sides of one hem: 37 degrees. Chosen: a sharper corner ends the hem */
#define HEM_SMOOTH 0.8
/* largest part of a hem's length that one end may take off. Chosen: two ends must not meet */
#define HEM_TAKEN 0.45
/* most of a neighbour that is read, in depths of the hem. Chosen: one that leans more is no neighbour */
#define NEIGHBOUR_MOST 4.0
#define BISECTIONS 44  /* halvings of a line to find a depth; chosen: 2^-44 of a metre is below rounding */
#define IMAGE_PARTS 8  /* parts of a line in the mirror of a curved hem; chosen: within 0.01 mm at a radius of 0.3 m */

/* the end of a hem at a corner of the ring */
typedef struct hem_end {
    const mus__cut_ring *ring;
    int32_t corner, step;  /* the corner V; +1: the hem follows it, -1: the hem comes before it */
    double along[2], in[2]; /* at V: unit vectors along the hem, away from V, and into the panel */
    double depth, length;  /* of the hem's allowance; of the hem [m] */
    int32_t side;          /* the side of the hem on which the turned end begins */
    double foot[2], run;   /* the point on that side, or on the hem's extension, and its arc length from V [m] */
    int32_t last;          /* the side of the neighbour on whose cut line X lies */
    double base[2];        /* the point on that side, or on its extension, that X is the allowance of [m] */
    mus__cut_ring image;   /* the image of the cut line above X, down to the depth */
    bool begun;
} hem_end;


static int32_t ring_at(const mus__cut_ring *ring, int32_t i)
{
    return (i % ring->n + ring->n) % ring->n;
}


/* the side `count` sides away from the corner, on the hem (or, with a step turned round, on its neighbour) */
static int32_t side_from(const mus__cut_ring *ring, int32_t corner, int32_t step, int32_t count)
{
    return ring_at(ring, step > 0 ? corner + count : corner - 1 - count);
}


/* unit vector of a side, in the direction of the ring */
static void side_direction(const mus__cut_ring *ring, int32_t side, double *out)
{
    const double *a = ring->list[side].xy, *b = ring->list[ring_at(ring, side + 1)].xy;
    const double d = mus__dist2(a, b);
    out[0] = (b[0] - a[0]) / d, out[1] = (b[1] - a[1]) / d;
}


/* are two consecutive sides parts of one hem? */
static bool hem_goes_on(const mus__cut_ring *ring, int32_t first)
{
    const mus__cut_corner *a = &ring->list[first], *b = &ring->list[ring_at(ring, first + 1)];
    if (!a->hem || !b->hem || a->width != b->width) return false;
    double u[2], v[2];
    side_direction(ring, first, u);
    side_direction(ring, ring_at(ring, first + 1), v);
    return u[0] * v[0] + u[1] * v[1] >= HEM_SMOOTH;
}


/* the nearest point of a hem to q: *side is where it is; returns the distance, positive inside the panel [m] */
static double hem_foot(const hem_end *end, const double *q, double *foot, double *run, int32_t *side)
{
    const mus__cut_ring *ring = end->ring;
    const double *v = ring->list[end->corner].xy, r[2] = {q[0] - v[0], q[1] - v[1]};
    const double ahead = r[0] * end->along[0] + r[1] * end->along[1];
    *side = side_from(ring, end->corner, end->step, 0);
    *run = ahead;
    for (int32_t d = 0; d < 2; d++) foot[d] = v[d] + ahead * end->along[d];
    if (ahead <= 0.0) return r[0] * end->in[0] + r[1] * end->in[1];

    double best = HUGE_VAL, signed_best = 0.0, passed = 0.0;
    for (int32_t k = 0; passed < end->length; k++) {
        const int32_t i = side_from(ring, end->corner, end->step, k);
        const double *a = ring->list[i].xy, *b = ring->list[ring_at(ring, i + 1)].xy;
        double u[2];
        side_direction(ring, i, u);
        const double length = mus__dist2(a, b);
        double t = (q[0] - a[0]) * u[0] + (q[1] - a[1]) * u[1];
        t = t < 0.0 ? 0.0 : t > length ? length : t;
        const double p[2] = {a[0] + t * u[0], a[1] + t * u[1]}, away = mus__dist2(p, q);
        if (away < best) {
            best = away;
            signed_best = u[0] * (q[1] - a[1]) - u[1] * (q[0] - a[0]) < 0.0 ? -away : away;
            memcpy(foot, p, sizeof p);
            *run = passed + (end->step > 0 ? t : length - t);
            *side = i;
        }
        passed += length;
    }
    return signed_best;
}


static void image_add(hem_end *end, const double *xy)
{
    mus__cut_corner corner = {.dart = MUS_NONE, .given = true};
    memcpy(corner.xy, xy, sizeof corner.xy);
    mus__cut_add(&end->image, &corner);
}


/* the point between p and q, p the lower, that is `depth` [m] inside the hem line: by bisection */
static void image_level(const hem_end *end, const double *p, const double *q, double depth, double *out)
{
    double low = 0.0, high = 1.0, foot[2], run;
    int32_t side;
    for (int32_t k = 0; k < BISECTIONS; k++) {
        const double t = 0.5 * (low + high);
        for (int32_t d = 0; d < 2; d++) out[d] = p[d] + t * (q[d] - p[d]);
        if (hem_foot(end, out, foot, &run, &side) < depth) low = t;
        else high = t;
    }
}


/* mirror the part of the cut line of the neighbour's side `own`, `out` beyond it, from p to q that lies between the hem
 * line and the depth; true when it ends at the depth, which sets the hem's first side and point */
static bool image_part(hem_end *end, int32_t own, const double *out, const double *p, const double *q)
{
    double foot[2], from[2] = {p[0], p[1]}, to[2] = {q[0], q[1]}, run;
    int32_t side;
    const double high = hem_foot(end, q, foot, &run, &side);
    if (!end->begun) {
        if (high < 0.0) return false;
        image_level(end, p, q, 0.0, from);
        end->last = own;
        for (int32_t d = 0; d < 2; d++) end->base[d] = from[d] - out[d];
        end->begun = true;
    }
    const bool done = high >= end->depth - MUS__CUT_SAME;
    if (done) image_level(end, from, q, end->depth, to);
    hem_foot(end, to, end->foot, &end->run, &end->side);
    if (!done && mus__dist2(from, to) < MUS__CUT_SAME) return false;

    /* a straight line stays straight in the mirror of a straight hem alone */
    const int32_t n = end->side == side_from(end->ring, end->corner, end->step, 0) ? 1 : IMAGE_PARTS;
    for (int32_t k = 1; k <= n; k++) {
        double image[2];
        for (int32_t d = 0; d < 2; d++) image[d] = from[d] + (to[d] - from[d]) * k / n;
        if (done && k == n) break;
        hem_foot(end, image, foot, &run, &side);
        for (int32_t d = 0; d < 2; d++) image[d] = 2.0 * foot[d] - image[d];
        image_add(end, image);
    }
    return done;
}


/* go on with a neighbour's cut line, which ends at `high` in direction u, to where it meets that of the next side: at
 * an outer corner, as of a strip that is folded along its middle. Nothing at an inner corner, or where they hardly turn
 */
static void image_corner(const hem_end *end, int32_t next, const double *u, double *high)
{
    const mus__cut_ring *ring = end->ring;
    double v[2];
    side_direction(ring, next, v);
    const double width = ring->list[next].width;
    const double *a = ring->list[end->step > 0 ? ring_at(ring, next + 1) : next].xy;
    const double low[2] = {a[0] + width * v[1], a[1] - width * v[0]};
    for (int32_t d = 0; d < 2; d++) v[d] *= -end->step; /* away from the hem, as u is */
    const double cross = u[0] * v[1] - u[1] * v[0];
    if (fabs(cross) < HEM_TURN) return;
    const double t = ((low[0] - high[0]) * v[1] - (low[1] - high[1]) * v[0]) / cross;
    for (int32_t d = 0; d < 2 && t > 0.0; d++) high[d] += t * u[d];
}


/* mirror the neighbour's cut line in the hem line; false when the hem keeps a plain corner: the neighbour ends, or has
 * the mouth of a dart, below the depth of the hem, or the ends of the hem would meet */
static bool image_build(hem_end *end)
{
    const mus__cut_ring *ring = end->ring;
    double last[2], climbed = 0.0;
    for (int32_t k = 0; climbed < NEIGHBOUR_MOST * end->depth && k < ring->n && end->image.status == MUS_OK; k++) {
        const int32_t i = side_from(ring, end->corner, -end->step, k);
        if (ring->list[i].dart != MUS_NONE) return false;
        const double *a = ring->list[i].xy, *b = ring->list[ring_at(ring, i + 1)].xy, width = ring->list[i].width;
        double u[2], low[2], high[2];
        side_direction(ring, i, u);
        const double out[2] = {width * u[1], -width * u[0]};
        for (int32_t d = 0; d < 2; d++) {
            low[d] = (end->step > 0 ? b : a)[d] + out[d];
            high[d] = (end->step > 0 ? a : b)[d] + out[d];
            /* the first side goes on below the hem line */
            if (k == 0) last[d] = low[d] - 2.0 * end->depth * (high[d] - low[d]) / mus__dist2(a, b);
        }
        for (int32_t d = 0; d < 2; d++) u[d] *= -end->step;
        image_corner(end, side_from(ring, end->corner, -end->step, k + 1), u, high);
        if (image_part(end, i, out, last, low) || image_part(end, i, out, low, high))
            return end->run <= HEM_TAKEN * end->length;
        memcpy(last, high, sizeof last);
        climbed += mus__dist2(a, b);
    }
    return false;
}


/* is the corner an end of a hem that is turned up? Sets all of *end but what image_build() sets */
static bool hem_end_is(const mus__cut_ring *ring, int32_t corner, hem_end *end)
{
    const int32_t before = ring_at(ring, corner - 1);
    const mus__cut_corner *a = &ring->list[before], *b = &ring->list[corner];
    if (a->dart != MUS_NONE || b->dart != MUS_NONE) return false;
    if (hem_goes_on(ring, before) || (!a->hem && !b->hem) || (a->hem && b->hem && a->width == b->width)) return false;
    *end = (hem_end){.ring = ring, .corner = corner, .image = {.context = ring->context}};
    end->step = b->hem && !(a->hem && a->width > b->width) ? 1 : -1;
    end->depth = (end->step > 0 ? b : a)->width;
    double u[2], v[2];
    side_direction(ring, before, u);
    side_direction(ring, corner, v);
    const double *own = end->step > 0 ? v : u;
    end->in[0] = -own[1], end->in[1] = own[0];
    for (int32_t d = 0; d < 2; d++) end->along[d] = end->step * own[d];
    if (fabs(u[0] * v[0] + u[1] * v[1]) > HEM_TURN || u[0] * v[1] - u[1] * v[0] <= 0.0 || !(end->depth > 0.0))
        return false;
    for (int32_t k = 0; k < ring->n; k++) {
        const int32_t side = side_from(ring, corner, end->step, k);
        end->length += mus__dist2(ring->list[side].xy, ring->list[ring_at(ring, side + 1)].xy);
        if (!hem_goes_on(ring, end->step > 0 ? side : ring_at(ring, side - 1))) break;
    }
    return true;
}


/* the turned end of a hem in place of its corner V, in the order of the ring */
static void hem_write(const hem_end *end, mus__cut_ring *out)
{
    const mus__cut_ring *image = &end->image;
    mus__cut_corner base = end->ring->list[end->last], foot = end->ring->list[end->side];
    memcpy(base.xy, end->base, sizeof base.xy);
    memcpy(foot.xy, end->foot, sizeof foot.xy);
    mus__cut_corner *before = end->step > 0 ? &base : &foot;
    before->width = 0.0, before->given = true;
    mus__cut_add(out, before);
    for (int32_t k = 0; k < image->n; k++) mus__cut_add(out, &image->list[end->step > 0 ? k : image->n - 1 - k]);
    mus__cut_add(out, end->step > 0 ? &foot : &base);
}


/* mark the corners that lie between the corner of the ring and the side `last` on its way in the direction of `step` */
static void hem_take(const mus__cut_ring *ring, int32_t corner, int32_t step, int32_t last, bool *taken)
{
    for (int32_t k = 0; k < ring->n; k++) {
        const int32_t side = side_from(ring, corner, step, k);
        if (side == last) return;
        taken[step > 0 ? ring_at(ring, side + 1) : side] = true;
    }
}


void mus__cut_turn_hems(const mus__cut_ring *in, mus__cut_ring *out)
{
    hem_end *ends = mus__new(in->context, in->n, sizeof *ends);
    bool *is = mus__new(in->context, in->n, sizeof *is), *taken = mus__new(in->context, in->n, sizeof *taken);
    if (ends == NULL || is == NULL || taken == NULL) out->status = mus__fail_memory(in->context, "the hems of a panel");
    for (int32_t i = 0; i < in->n && out->status == MUS_OK; i++) {
        is[i] = hem_end_is(in, i, &ends[i]) && image_build(&ends[i]);
        out->status = ends[i].image.status;
        if (!is[i]) continue;
        hem_take(in, i, ends[i].step, ends[i].side, taken);
        hem_take(in, i, -ends[i].step, ends[i].last, taken);
    }
    for (int32_t i = 0; i < in->n && out->status == MUS_OK; i++) {
        if (is[i]) hem_write(&ends[i], out);
        else if (!taken[i]) mus__cut_add(out, &in->list[i]);
    }
    for (int32_t i = 0; i < in->n && ends != NULL; i++) mus__free(in->context, ends[i].image.list);
    mus__free(in->context, ends);
    mus__free(in->context, is);
    mus__free(in->context, taken);
}
