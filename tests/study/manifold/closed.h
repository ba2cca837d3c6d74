/*
 * closed.h: whether the triangles of a mesh are one closed surface without self-crossings. It knows nothing of muslin.
 *
 * Coordinates are rounded to 1e-12 m, which keeps nine decimals of a file, and all signs are exact: a double decides
 * where its error bound allows, else integers of 128 bits.
 */
#ifndef MUS_TESTS_MANIFOLD_CLOSED_H
#define MUS_TESTS_MANIFOLD_CLOSED_H

#include "study/outside/ruler.h"

typedef struct closed_report {
    int32_t open;      /* directed edges without an opposite one, or that two triangles have */
    int32_t pinched;   /* vertices whose triangles are not one fan, and vertices without triangles */
    int32_t flat;      /* triangles of no area */
    int32_t crossings; /* pairs of triangles that cross, touch or fold onto each other */
    int32_t pieces;    /* connected pieces */
    int32_t euler;     /* V - E + F */
    double volume;     /* [m3] */
    double height;     /* least height of a triangle [m] */
    double angle;      /* least angle [degrees] */
} closed_report;

/* false: no memory */
bool closed_check(const ruler_mesh *mesh, closed_report *out);

#endif
