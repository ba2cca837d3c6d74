/*
 * pack.c: pack boxes on a strip of paper: the tallest first, each at the lowest place where it fits (bottom-left on a
 * skyline). Boxes are not turned, so that the grain stays upright.
 *
 * The skyline is a row of steps from left to right; each has the height up to which its part of the strip is used:
 *
 *          +---+                 A box of width w may stand with its left side on any step's left end; it rests on the
 *      +---+   +------           highest step below it. The place with the lowest top wins, then the one on the left.
 *      |       |
 *
 * Source: Chazelle, The bottom-left bin-packing heuristic, 1983; skyline form as in Jylanki, A thousand ways to pack
 * the bin, 2010, section 2.4.
 */
#include <stdbool.h>

#include "file/pack.h"

/* a step of the skyline: left end, right end, height */
enum { STEP_LEFT, STEP_RIGHT, STEP_HEIGHT, STEP_FIELDS };


/* compute the height at which a box rests with its left side at step s; false when it does not fit in the strip */
static bool pack_rest(const double *sky, int32_t nstep, int32_t s, double width, double *rest)
{
    double right = sky[STEP_FIELDS * s + STEP_LEFT] + width;
    if (right > sky[STEP_FIELDS * (nstep - 1) + STEP_RIGHT] + 1e-9) return false;
    *rest = 0.0;
    for (int32_t i = s; i < nstep && sky[STEP_FIELDS * i + STEP_LEFT] < right - 1e-12; i++)
        if (sky[STEP_FIELDS * i + STEP_HEIGHT] > *rest) *rest = sky[STEP_FIELDS * i + STEP_HEIGHT];
    return true;
}


/* raise the skyline to `top` from step s to `right`: the steps between vanish, a cut one keeps the rest of its width.
 * Returns the number of steps */
static int32_t pack_raise(double *sky, int32_t nstep, int32_t s, double right, double top)
{
    double left = sky[STEP_FIELDS * s + STEP_LEFT];
    int32_t end = s;
    while (end < nstep && sky[STEP_FIELDS * end + STEP_RIGHT] <= right + 1e-12) end++;
    if (end < nstep && sky[STEP_FIELDS * end + STEP_LEFT] < right) sky[STEP_FIELDS * end + STEP_LEFT] = right;

    /* one step replaces the steps s .. end - 1 */
    int32_t shift = s + 1 - end;
    if (shift > 0)
        for (int32_t i = STEP_FIELDS * nstep - 1; i >= STEP_FIELDS * end; i--) sky[i + STEP_FIELDS * shift] = sky[i];
    if (shift < 0)
        for (int32_t i = STEP_FIELDS * end; i < STEP_FIELDS * nstep; i++) sky[i + STEP_FIELDS * shift] = sky[i];
    sky[STEP_FIELDS * s + STEP_LEFT] = left;
    sky[STEP_FIELDS * s + STEP_RIGHT] = right;
    sky[STEP_FIELDS * s + STEP_HEIGHT] = top;
    return nstep + shift;
}


double mus__pack(int32_t n, const double *size, double width, double gap, double *at, int32_t *work, double *sky)
{
    /* tallest first, then widest, then in the given order (insertion sort: a pattern has few pieces) */
    for (int32_t i = 0; i < n; i++) {
        int32_t j = i;
        for (; j > 0; j--) {
            const double *a = size + 2 * work[j - 1], *b = size + 2 * i;
            if (a[1] > b[1] || (a[1] == b[1] && a[0] >= b[0])) break;
            work[j] = work[j - 1];
        }
        work[j] = i;
    }

    /* the gap is part of each box, so the strip is one gap wider */
    int32_t nstep = 1;
    double used = 0.0;
    sky[STEP_LEFT] = 0.0;
    sky[STEP_RIGHT] = width + gap;
    sky[STEP_HEIGHT] = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const double *box = size + 2 * work[i];
        int32_t best = 0;
        double rest, best_rest = -1.0;
        for (int32_t s = 0; s < nstep; s++) {
            if (!pack_rest(sky, nstep, s, box[0] + gap, &rest)) break;
            if (best_rest < 0.0 || rest < best_rest) {
                best = s;
                best_rest = rest;
            }
        }
        if (best_rest < 0.0) return -1.0; /* wider than the strip */
        at[2 * work[i]] = sky[STEP_FIELDS * best + STEP_LEFT];
        at[2 * work[i] + 1] = best_rest;
        double top = best_rest + box[1] + gap;
        nstep = pack_raise(sky, nstep, best, at[2 * work[i]] + box[0] + gap, top);
        used = top > used ? top : used;
    }
    return used > gap ? used - gap : 0.0;
}
