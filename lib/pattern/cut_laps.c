/*
 * cut_laps.c: the ends of an allowance that laps, so that its end can be finished.
 *
 * A front that buttons is drawn to its centre; its allowance is the stand, which goes on beyond the centre and is worn
 * as a part of the front. So the end of that allowance is an edge like the one beside it, and has an allowance as wide:
 *
 *         neck \                     V   corner of the centre (below) and the neck
 *               \                    w   allowance of the neck
 *   L-----------X\                   L   the end of the stand: w beyond V, square to the centre
 *   |            \V                  X   where that end meets the cut line of the neck
 *   |            |
 *
 * Where the neck is square to the centre its cut line reaches the end of the stand by itself: the corner is mitred
 * (polygon_offset.c). It does not where the neck leans back from the stand, as a V does; this file gives that end.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "pattern/cut_ring.h"

/* most of a neighbour that is read, in widths of its allowance; chosen: an edge that leans less goes straight on */
#define LAP_MOST 3.0

/* the end of an allowance that laps: at a corner of the ring, which the lap ends at (step 1) or begins at (-1) */
typedef struct lap_end {
    int32_t corner, step;
    int32_t side;   /* the side of the neighbour on whose cut line X lies */
    double base[2]; /* the point of that side that X is the allowance of [m] */
    double tip[2];  /* the point of the lap's line, beyond its corner, that the end is square to [m] */
} lap_end;


static int32_t lap_at(const mus__cut_ring *ring, int32_t i)
{
    return (i % ring->n + ring->n) % ring->n;
}


/* direction of a side, away from the corner `step` sides on; and the direction out of the panel beside it */
static void lap_side(const mus__cut_ring *ring, int32_t side, int32_t step, double *along, double *out)
{
    const double *a = ring->list[side].xy, *b = ring->list[lap_at(ring, side + 1)].xy, d = mus__dist2(a, b);
    for (int32_t k = 0; k < 2; k++) along[k] = step * (b[k] - a[k]) / d;
    out[0] = (b[1] - a[1]) / d, out[1] = (a[0] - b[0]) / d;
}


/* does the lap end at the corner, beside an edge whose cut line leaves it short? Sets the end */
static bool lap_end_is(const mus__cut_ring *ring, int32_t corner, int32_t step, lap_end *end)
{
    const int32_t own = step > 0 ? lap_at(ring, corner - 1) : corner;
    const int32_t first = step > 0 ? corner : lap_at(ring, corner - 1);
    const mus__cut_corner *lap = &ring->list[own], *next = &ring->list[first];
    const double *v = ring->list[corner].xy, width = next->width;
    double along[2], out[2], to[2], aside[2], passed = 0.0;
    if (!lap->laps || next->laps || next->hem || next->dart != MUS_NONE || !(width > 0.0)) return false;
    lap_side(ring, own, step, along, out);
    lap_side(ring, first, step, to, aside);
    /* the outline turns by an acute angle to the inside, and the corner cannot be mitred */
    const double cosine = along[0] * to[0] + along[1] * to[1];
    if (out[0] * to[0] + out[1] * to[1] >= 0.0 || width >= lap->width * cosine) return false;
    *end = (lap_end){.corner = corner, .step = step};
    for (int32_t k = 0; k < 2; k++) end->tip[k] = v[k] + width * along[k];
    for (int32_t i = 0; i < ring->n && passed < LAP_MOST * width; i++) {
        const int32_t side = step > 0 ? lap_at(ring, first + i) : lap_at(ring, first - i);
        const mus__cut_corner *at = &ring->list[side];
        if (at->width != width || at->dart != MUS_NONE || at->laps) return false;
        const double *a = ring->list[step > 0 ? side : lap_at(ring, side + 1)].xy;
        const double length = mus__dist2(at->xy, ring->list[lap_at(ring, side + 1)].xy);
        lap_side(ring, side, step, to, aside);
        /* how far the allowance of its start lies below the end, and how fast it comes there */
        double below = width, rise = 0.0;
        for (int32_t k = 0; k < 2; k++) {
            below -= along[k] * (a[k] + width * aside[k] - v[k]);
            rise += along[k] * to[k];
        }
        if (rise > 0.0 && below >= 0.0 && below <= rise * length) {
            for (int32_t k = 0; k < 2; k++) end->base[k] = a[k] + below / rise * to[k];
            end->side = side;
            return true;
        }
        passed += length;
    }
    return false;
}


/* the end in place of its corner, in the order of the ring */
static void lap_write(const mus__cut_ring *in, const lap_end *end, mus__cut_ring *out)
{
    mus__cut_corner tip = in->list[end->step > 0 ? lap_at(in, end->corner - 1) : end->corner];
    mus__cut_corner base = in->list[end->side];
    memcpy(tip.xy, end->tip, sizeof tip.xy);
    memcpy(base.xy, end->base, sizeof base.xy);
    mus__cut_corner *given = end->step > 0 ? &tip : &base;
    given->width = 0.0, given->given = true;
    mus__cut_add(out, given);
    mus__cut_add(out, end->step > 0 ? &base : &tip);
}


void mus__cut_end_laps(const mus__cut_ring *in, mus__cut_ring *out)
{
    bool *taken = mus__new(in->context, in->n, sizeof *taken);
    lap_end *ends = mus__new(in->context, in->n, sizeof *ends);
    if (taken == NULL || ends == NULL) out->status = mus__fail_memory(in->context, "the laps of a panel");
    for (int32_t i = 0; i < in->n && out->status == MUS_OK; i++) {
        lap_end *end = &ends[i];
        if (!lap_end_is(in, i, 1, end) && !lap_end_is(in, i, -1, end)) continue;
        /* the corners of the neighbour before X are left out */
        if (end->step > 0)
            for (int32_t k = i; k != end->side; k = lap_at(in, k + 1)) taken[lap_at(in, k + 1)] = true;
        else
            for (int32_t k = lap_at(in, i - 1); k != end->side; k = lap_at(in, k - 1)) taken[k] = true;
    }
    for (int32_t i = 0; i < in->n && out->status == MUS_OK; i++) {
        if (ends[i].step != 0)
            lap_write(in, &ends[i], out);
        else if (!taken[i])
            mus__cut_add(out, &in->list[i]);
    }
    mus__free(in->context, ends);
    mus__free(in->context, taken);
}
