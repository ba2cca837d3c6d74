/*
 * dxf_ring.h: the closed outline of a piece, and the grade rules of a RUL file.
 */
#ifndef MUS__TRADE_DXF_RING_H
#define MUS__TRADE_DXF_RING_H

#include "trade/dxf_file.h"

/* grade rules: the displacement of a point from the sample size to each size */
typedef struct mus__rul {
    int32_t nsize, nrule;
    int32_t sample;        /* index of the sample size */
    mus__dxf_slice *sizes; /* (nsize) */
    int32_t *numbers;      /* (nrule) numbers of the rules */
    double *moves;         /* (nrule x nsize x 2) [m] */
    int32_t size_room, number_room, move_room;
} mus__rul;

/* read a RUL file; the caller frees `rul`, after a failure too */
mus_status mus__rul_load(const mus__source *source, mus__rul *rul);
void mus__rul_unload(mus_context *context, mus__rul *rul);
/* index of a size; MUS_NONE without it */
int32_t mus__rul_size(const mus__rul *rul, mus__dxf_slice name);
/* displacement (2) [m] of rule `number` for a size; false without the rule */
bool mus__rul_move(const mus__rul *rul, int32_t number, int32_t size, double *out);

typedef struct mus__ring_point {
    double xy[2];    /* [m] in the sample size */
    double moved[2]; /* [m] in the wanted size */
    bool turn;       /* an edge begins here */
} mus__ring_point;

typedef struct mus__ring {
    int32_t n, room;
    mus__ring_point *points; /* (n), closed */
} mus__ring;

void mus__ring_free(mus_context *context, mus__ring *ring);
/* join the polylines and lines of a layer to a ring; its n is 0 when there are none. `only` is an entity to take alone,
 * or MUS_NONE. MUS_ERR_FORMAT when they do not close */
mus_status mus__ring_make(const mus__dxf_file *file, const mus__dxf_block *block, int32_t layer, int32_t only,
                          mus__ring *ring);
/* mark where edges begin: turn points (layer 2), ends of polylines; without any, corners of more than 30 degrees */
void mus__ring_turns(const mus__dxf_file *file, const mus__dxf_block *block, mus__ring *ring);
/* move the points by the rules that texts "# 3" name, and those between two by both, by arc length */
mus_status mus__ring_grade(const mus__dxf_file *file, const mus__dxf_block *block, const mus__rul *rul, int32_t size,
                           mus__ring *ring);
/* add the mirror image of a half outline at its mirror line (layer 6), when a side of the outline lies on the line;
 * axis (4) gets two points of the line, *folded is false without one */
mus_status mus__ring_unfold(const mus__dxf_file *file, const mus__dxf_block *block, mus__ring *ring, double *axis,
                            bool *folded);
/* move a point to its mirror image in the line through the points of axis (4) */
void mus__ring_mirror(const double *axis, double *xy);
/* turn a clockwise ring round */
void mus__ring_orient(mus__ring *ring);
/* true when p lies inside the ring */
bool mus__ring_inside(const mus__ring *ring, const double *p);
/* distance [m] of p from the place `part` of the side behind point `at` */
double mus__ring_away(const mus__ring *ring, int32_t at, double part, const double *p);
/* low x, low y, high x, high y [m] */
void mus__ring_box(const mus__ring *ring, double *box);
/* distance [m] of p from the ring: *at gets the point before the nearest place, *part the place on its side, 0 to 1 */
double mus__ring_nearest(const mus__ring *ring, const double *p, int32_t *at, double *part);
/* the place where the ray from p in the direction d (a unit vector), `back` [m] behind p to `ahead` [m], meets the ring
 * nearest to p; false without one */
bool mus__ring_meet(const mus__ring *ring, const double *p, const double *d, const double *range, int32_t *at,
                    double *part);
/* the corner that the ray from p in the direction d (a unit vector) passes first, at most `ahead` [m] from p. Of the
 * two edges that meet there, *at and *part get the end of the one that is more square to the ray, since where the ray
 * meets an edge that it grazes is not certain. false without such a corner */
bool mus__ring_corner(const mus__ring *ring, const double *p, const double *d, double ahead, int32_t *at, double *part);

#define MUS__ALLOWANCE_MOST 0.1 /* [m] a sew line farther inside is none; chosen: as the largest of a sheet */

/* allowance [m] of the edge of n sides behind point `first` of the sew line, counter-clockwise, from the cut line */
double mus__ring_allowance(const mus__ring *sew, int32_t first, int32_t n, const mus__ring *cut);

#endif
