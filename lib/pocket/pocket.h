/*
 * pocket.h: the pockets of a garment by their word. A half garment is marked where they go; the whole garment gets the
 * panels of those that are draped, and lib/finish the pieces of the others.
 */
#ifndef MUS_POCKET_H
#define MUS_POCKET_H

#include "half/half_garment.h"

/* Marks the pockets on the half, after all its panels are drawn. */
void mus__pocket_attach(mus__half *half);
/* Adds the panels of patches to the whole garment, after mus__board_double(). */
void mus__pocket_finish(mus__half *half);

#endif
