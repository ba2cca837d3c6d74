/*
 * board_sew.h: seams of sides; sides split and merged.
 */
#ifndef MUS_BOARD_SEW_H
#define MUS_BOARD_SEW_H

#include "board/board_chain.h"

/* join two sides; ease = length of b - length of a that is meant */
int32_t mus__board_seam_add(mus__board *board, int32_t a, int32_t b, int32_t direction, double ease);
/* a seam is laid, or closed, as another is */
void mus__board_seam_like(mus__board *board, int32_t seam, int32_t other);
/* open the seam of a side */
void mus__board_seam_drop(mus__board *board, int32_t side);
/**
 * Sew a run of sides to another, many to many: `a` (na) from its first to its last as walked, `b` (nb) likewise, right
 * sides out: the start of a[0] meets the end of b[nb - 1]. Both are split where the other has a joint, by relative
 * length along the whole run; the difference of the lengths becomes the ease of the parts in proportion. Joints nearer
 * than 1 mm to one another are taken as the same. Notches stay where they are.
 */
void mus__board_sew(mus__board *board, int32_t na, const int32_t *a, int32_t nb, const int32_t *b);
/**
 * Put a vertex into a side at arc length s: the side keeps its name and its first part, the new one is *name (NULL: the
 * name with "_2", or the next number that is free in the panel). If the side is sewn, its partner is split at the place
 * that is sewn to s, and the seam becomes two. Returns the new side. s within 1e-6 m of an end fails.
 */
int32_t mus__board_split(mus__board *board, int32_t side, double s, const char *name);
/* `side` and the next, unsewn or sewn to two that are one after the other, become one, with the name of `side` */
void mus__board_merge(mus__board *board, int32_t side);
/* would it do so? Asks only, and fails nothing */
bool mus__board_mergeable(const mus__board *board, int32_t side);

#endif
