/*
 * board_seam.h: seams of sides; sides split and merged.
 */
#ifndef MUS_BOARD_SEAM_H
#define MUS_BOARD_SEAM_H

#include "board/board_curve.h"

/* sew two sides; ease [m] is the length of b less that of a that the design intends. Returns the seam */
int32_t mus__board_seam_add(mus__board *board, int32_t a, int32_t b, int32_t direction, double ease);
/* copy the closure of seam `other`, and whether its layers are laid, to `seam` */
void mus__board_seam_like(mus__board *board, int32_t seam, int32_t other);
/* remove the seam of a side; the board fails when it has none */
void mus__board_seam_drop(mus__board *board, int32_t side);
#define MUS__SEWN_MOST 64 /* most sides sewn to one another at one place; chosen: a pleat has 4 */

/* a place that is sewn to a given place, directly or through other sides */
typedef struct mus__board_place {
    int32_t side;
    double t;           /* relative arc length from the start of the side */
    int32_t from, seam; /* the entry of the list and the seam that lead here; MUS_NONE: the given place */
    int32_t made;       /* while the sides are split: the new side; else MUS_NONE */
} mus__board_place;

/* list the places that are sewn to the place at relative arc length t of `side`, that place first; place
 * (MUS__SEWN_MOST). Returns their number, 0 when the board fails */
int32_t mus__board_sewn(mus__board *board, int32_t side, double t, mus__board_place *place);
/**
 * Sew a run of sides to another run, right sides out: the start of a[0] meets the end of b[nb - 1].
 *
 * `a` (na) and `b` (nb) list sides as walked. Each run is split where the other has a joint, at equal relative length
 * along the whole run. The difference of the lengths becomes ease, divided among the parts in proportion. Joints within
 * 1 mm of one another count as one. Notches stay where they are.
 */
void mus__board_sew(mus__board *board, int32_t na, const int32_t *a, int32_t nb, const int32_t *b);
/**
 * Split a side at arc length s [m]: it keeps its name and its first part, the second part is a new side.
 *
 * The new side is called `name`, or with NULL the old name with "_2" or the next number that is free in the panel. The
 * sides that it is sewn to are split at the place that is sewn to s, and each seam becomes two. s within 1e-6 m of an
 * end fails the board. Returns the new side.
 */
int32_t mus__board_split(mus__board *board, int32_t side, double s, const char *name);
/* merge `side` with the next side, under the name of `side`. Both are unsewn, or are sewn to two sides that follow each
 * other; otherwise the board fails */
void mus__board_merge(mus__board *board, int32_t side);
/* would mus__board_merge() succeed? The board does not fail */
bool mus__board_mergeable(const mus__board *board, int32_t side);

#endif
