/*
 * block_curve.h: the curves that blocks are drawn with. A cubic is a Bezier curve as 8 numbers: start, two handles,
 * end. A chain is lines, arcs and cubics end to end: one edge of a panel.
 */
#ifndef MUS_BLOCK_CURVE_H
#define MUS_BLOCK_CURVE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/base_internal.h"

void mus__cubic_set(double *out, const double *start, double ax, double ay, double bx, double by, const double *end);
double mus__cubic_length(const double *cubic);
/* Writes the part of a cubic between arc lengths s0 < s1 [m] to `out`. */
void mus__cubic_part(const double *cubic, double s0, double s1, double *out);
/* Solves f(data, x) = 0 for x between lo and hi; false when f has the same sign at both. */
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
/* Appends `next`, which starts at the end of `chain`; an empty chain (npiece 0) becomes `next`. */
void mus__chain_append(mus__chain *chain, const mus__chain *next);
/* Appends a line. */
void mus__chain_add_line(mus__chain *chain, const double *start, const double *end);
/* Appends a cubic with handles (ax, ay) and (bx, by). */
void mus__chain_add_cubic(mus__chain *chain, const double *start, double ax, double ay, double bx, double by,
                          const double *end);
void mus__chain_reverse(mus__chain *chain);
/* Mirrors in x = 0 and reverses: the edge of the other half, counter-clockwise again. */
void mus__chain_mirror(mus__chain *chain);
/* Appends the mirror image of a chain that ends on the centre line. */
void mus__chain_unfold(mus__chain *chain);

/* Draws cubics through n (2..5) points xy (n x 2) with unit tangents (n x 2); ds (n - 1): arc lengths between them. */
void mus__chain_through(mus__chain *chain, int32_t n, const double *xy, const double *tangent, const double *ds);
double mus__chain_length(const mus__chain *chain);

/* Adds `dx` to the x of every point. */
void mus__chain_shift(mus__chain *chain, double dx);
/* Writes the first `s` [m] of a chain to `out`. */
void mus__chain_cut(const mus__chain *chain, double s, mus__chain *out);
/* Moves every point: (x, y) goes to (m0 x + m1 y + m2, m3 x + m4 y + m5), map (6). */
void mus__chain_move(mus__chain *chain, const double *map);

#endif
