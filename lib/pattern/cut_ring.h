/*
 * cut_ring.h: the ring of corners that becomes the cut line of a panel, and the steps of its making.
 *
 * The order: outline without inner lines (cut_outline.c) -> ring with straight mouths (cut_line.c) -> hems turned up
 * (cut_hems.c) -> stands ended (cut_laps.c) -> mouths folded shut (cut_darts.c) -> moved out by the allowances
 * (polygon_offset.c).
 */
#ifndef MUS_PATTERN_CUT_RING_H
#define MUS_PATTERN_CUT_RING_H

#include "pattern/pattern_internal.h"

#define MUS__CUT_SAME 1e-9 /* [m] points this near are one; chosen: above rounding, far below 0.01 mm */

/* a corner of the ring, and the side from it to the next corner */
typedef struct mus__cut_corner {
    double xy[2];  /* [m] */
    double width;  /* allowance of the side [m] */
    int32_t dart;  /* the dart whose mouth the side closes, or MUS_NONE */
    bool hem;      /* the allowance is turned up along the side */
    bool laps;     /* the allowance goes on beyond a closure that buttons */
    bool given;    /* the side is part of the cut line itself; width is 0 */
} mus__cut_corner;

/* counter-clockwise */
typedef struct mus__cut_ring {
    mus_context *context;
    mus_status status; /* first failure; later calls do nothing */
    int32_t n, room;
    mus__cut_corner *list;
} mus__cut_ring;

void mus__cut_add(mus__cut_ring *ring, const mus__cut_corner *corner);

/* a dart whose mouth is in the ring */
typedef struct mus__cut_dart {
    double mouth[2][2]; /* ends of the mouth, in the order of the outline [m] */
    double point[2], peak[2]; /* where the legs meet; end of the fold on the capped edge [m] */
    int32_t first, last; /* positions of the outermost legs in the rim */
    bool onto_second;   /* folded onto the cloth beside the second leg; else onto that beside the first */
} mus__cut_dart;

/* give each hem the ends that lie on the cut lines of its neighbours when it is turned up */
void mus__cut_turn_hems(const mus__cut_ring *in, mus__cut_ring *out);
/* end each allowance that laps with an allowance as wide as that of the edge beside it */
void mus__cut_end_laps(const mus__cut_ring *in, mus__cut_ring *out);
/* replace the mouth of each dart by the edge that lies on it when the dart is folded; sets the peaks */
void mus__cut_fold_darts(const mus__cut_ring *in, mus__cut_dart *darts, mus__cut_ring *out);

#endif
