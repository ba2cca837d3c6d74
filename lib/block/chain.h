/*
 * chain.h: the curves that blocks are drawn with. A cubic is a Bezier curve as 8 numbers: start, two handles, end. A
 * chain is lines, arcs and cubics end to end: one edge of a panel.
 */
#ifndef MUS_CHAIN_H
#define MUS_CHAIN_H

#include <stdbool.h>
#include <stdint.h>

#include "base/base_internal.h"

void mus__cubic_set(double *out, const double *start, double ax, double ay, double bx, double by, const double *end);
double mus__cubic_length(const double *cubic);
/* the part of a cubic between arc lengths s0 < s1 */
void mus__cubic_part(const double *cubic, double s0, double s1, double *out);
/* root of f between lo and hi; false when f has the same sign at both */
bool mus__solve(double (*f)(const void *data, double x), const void *data, double lo, double hi, double *root);

#define MUS__CHAIN_PIECES 4

/* lines, arcs and cubics end to end: one edge of a panel */
typedef struct mus__chain {
    int32_t npiece;
    int32_t kinds[MUS__CHAIN_PIECES];
    int32_t nxy;
    double xy[2 * (3 * MUS__CHAIN_PIECES + 1)]; /* (nxy x 2), both ends included */
} mus__chain;

void mus__chain_line(mus__chain *chain, const double *start, const double *end);
void mus__chain_cubic(mus__chain *chain, const double *cubic);
void mus__chain_arc(mus__chain *chain, const double *start, const double *middle, const double *end);
/* `chain` then `next`, which starts where `chain` ends */
void mus__chain_append(mus__chain *chain, const mus__chain *next);
void mus__chain_reverse(mus__chain *chain);
/* x to -x, and reversed: the same edge of the other half, walked counter-clockwise */
void mus__chain_mirror(mus__chain *chain);
/* a chain that ends on the centre line, and after it its mirror image */
void mus__chain_unfold(mus__chain *chain);

/* cubics through n (2..5) points with unit tangents; ds (n - 1): arc length from each to the next */
void mus__chain_through(mus__chain *chain, int32_t n, const double *xy, const double *tangent, const double *ds);
double mus__chain_length(const mus__chain *chain);

/* x of every point more by `dx` */
void mus__chain_shift(mus__chain *chain, double dx);
/* the first `s` of a chain */
void mus__chain_cut(const mus__chain *chain, double s, mus__chain *out);

#endif
