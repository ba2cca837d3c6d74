/*
 * block_waist.h: a waist line that is fair when its darts are closed.
 */
#ifndef MUS_BLOCK_WAIST_H
#define MUS_BLOCK_WAIST_H

#include "block/block_bodice.h"

/* a top edge of a half from the centre to the side, with its darts */
typedef struct mus__waist {
    double end[2][2];           /* at the centre and at the side [m] */
    double along[2][2];         /* unit tangents there, from the centre to the side */
    int32_t ndart;
    double dart[MUS__DARTS][6]; /* inner mouth, point, outer mouth; from the centre outwards; legs of equal length */
    double part[MUS__DARTS + 1][8]; /* set by the call: cubics between the darts */
    double closed[8];               /* set by the call: the line with the darts closed */
    double close[6];                /* and the turn that closes them, of what lies beyond the last: (x, y) goes to
                                       (m0 x + m1 y + m2, m3 x + m4 y + m5) */
} mus__waist;

/*
 * Trues the waist: reads its ends, tangents and darts, moves the mouths along their legs onto the fair line, and sets
 * the parts. Returns the length of the line with the darts closed [m], or NAN when it misses a leg.
 */
double mus__waist_true(mus__waist *waist);

#endif
