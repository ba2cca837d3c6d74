/*
 * exact.h: sums and products of two doubles with their rounding errors, for signs that must be right
 * (geom/predicate.c) and for functions that need more than a double on their way (elementary.c). The results are exact
 * unless a product overflows or underflows. Source: Knuth, The Art of Computer Programming 2, 4.2.2 (sum); Dekker, A
 * Floating-Point Technique for Extending the Available Precision, 1971 (product).
 */
#ifndef MUS_BASE_EXACT_H
#define MUS_BASE_EXACT_H

#include "base/ieee.h"

/* 2^27 + 1: multiplying by it splits a double into two of 26 bits (Dekker 1971) */
#define MUS__SPLIT 134217729.0


/* Returns the rounded sum a + b; *low gets its rounding error. */
static inline double mus__exact_sum(double a, double b, double *low)
{
    double high = a + b, part = high - a;
    *low = (a - (high - part)) + (b - part);
    return high;
}


/* Returns the rounded product a * b; *low gets its rounding error. */
static inline double mus__exact_product(double a, double b, double *low)
{
    double high = a * b;
    double c = MUS__SPLIT * a, a1 = c - (c - a), a0 = a - a1;
    double d = MUS__SPLIT * b, b1 = d - (d - b), b0 = b - b1;
    *low = a0 * b0 - (((high - a1 * b1) - a0 * b1) - a1 * b0);
    return high;
}

#endif
