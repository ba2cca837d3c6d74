/*
 * pack.h: boxes on a strip, for the pieces of a sheet of paper and the panels of a texture.
 */
#ifndef MUS_FILE_PACK_H
#define MUS_FILE_PACK_H

#include <stdint.h>

/* pack `n` boxes (size, n x 2 [m]) on a strip of the given width, `gap` apart: at (n x 2) gets their low corners.
 * Returns the height used, or -1 when a box is too wide. Scratch: work (n), sky (2n + 2) x 3 */
double mus__pack(int32_t n, const double *size, double width, double gap, double *at, int32_t *work, double *sky);

#endif
