/*
 * boundary_loop.h: runs of open half-edges along the boundary loop of the half as sewn so far, where a sleeve, a collar
 * or a band is sewn on.
 */
#ifndef MUS_BOUNDARY_LOOP_H
#define MUS_BOUNDARY_LOOP_H

#include "half/half_garment.h"

/* The open half-edges with `label` of the panels whose names begin with `panels` ("" for all), in the order of the
 * boundary loop (cloth to the left), over darts and seams from panel to panel. Returns how many there are; at most
 * `room` are written to `sides`. The waist of a front runs from the centre to the side, that of a back from the side
 * to the centre; "" "armhole" is a ring that begins at the front underarm; "neck" runs from centre back to centre
 * front */
int32_t mus__half_boundary(const mus__half *half, const char *panels, const char *label, int32_t *sides, int32_t room);

#define MUS__BOUNDARY_SIDES 48

/* A run of open half-edges (mus__half_boundary()) as one line. Their panels are laid flat beside one another, each seam
 * that is passed closed at its corner: point p of the panel of half-edge i lies at  R(turn[i]) p + shift[i],  the first
 * panel as it is. */
typedef struct mus__boundary {
    int32_t n;
    int32_t side[MUS__BOUNDARY_SIDES];
    int32_t over[MUS__BOUNDARY_SIDES]; /* sewn half-edge passed on the way to this one; MUS_NONE: none */
    double s[MUS__BOUNDARY_SIDES + 1]; /* arc length at the start of each, and of the whole [m] */
    double turn[MUS__BOUNDARY_SIDES], shift[MUS__BOUNDARY_SIDES][2];
} mus__boundary;

/* Reads the run with `label`. The board fails when there is none, or when it has too many half-edges. */
void mus__boundary_read(mus__half *half, const char *label, mus__boundary *out);
/* Splits the run at arc length s, unless a joint lies within 1 mm. Returns the number of the half-edge that starts
 * there. */
int32_t mus__boundary_split(mus__board *board, mus__boundary *loop, double s);
/* Number of the first half-edge that follows a seam with `label`, or MUS_NONE. */
int32_t mus__boundary_over(const mus__board *board, const mus__boundary *loop, const char *label);
/* Number of the half-edge whose start is nearest to `part` (0..1) of the length, within `off` (0..1), or MUS_NONE. */
int32_t mus__boundary_near(const mus__boundary *loop, double part, double off);
/* Arc length of the first notch of `kind` on half-edges first..last - 1; NaN when there is none. */
double mus__boundary_notch(const mus__board *board, const mus__boundary *loop, int32_t first, int32_t last,
                           int32_t kind);
/* Writes the point and the unit tangent at arc length s, laid flat. */
void mus__boundary_at(const mus__board *board, const mus__boundary *loop, double s, double *xy, double *tangent);

#endif
