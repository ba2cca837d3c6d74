/* solids.h: meshes with known answers, for the tests of scanning. The caller frees x and triangle. */
#ifndef MUS_TESTS_SCAN_SOLIDS_H
#define MUS_TESTS_SCAN_SOLIDS_H

#include <stdint.h>

typedef struct solid {
    int32_t vertices, triangles;
    double *x;         /* (vertices x 3) */
    int32_t *triangle; /* (triangles x 3) */
} solid;

/* radii of a surface of revolution squeezed to an ellipse: rings of n vertices between two points on the Y axis */
void solid_ellipsoid(int32_t n, double a, double b, double c, solid *out);
/* a cylinder of half breadths a (X) and c (Z), from y = 0 to `height`, with lids */
void solid_cylinder(int32_t n, double a, double c, double height, solid *out);
/* the surface of the body of a table size, in a named pose (NULL: as it is made) */
void solid_person(const char *size, const char *stance, solid *out);
void solid_free(solid *s);

/* x -> unit * turn * x + place, turn row by row; place may be NULL */
void solid_move(solid *s, double unit, const double *turn, const double *place);

#endif
