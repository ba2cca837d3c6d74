/*
 * ruler.h: measures a mesh from outside: an OBJ file, cut by planes. Nothing here knows of muslin.
 *
 * A plane cuts the triangles in closed loops; a tape is the convex hull of the loops that it goes round. Units: those
 * of the file [m].
 */
#ifndef MUS_TESTS_OUTSIDE_RULER_H
#define MUS_TESTS_OUTSIDE_RULER_H

#include <stdbool.h>
#include <stdint.h>

/* vertices (vertices x 3) and triangles (triangles x 3) of a file */
typedef struct ruler_mesh {
    int32_t vertices, triangles;
    double *x;
    int32_t *triangle;
} ruler_mesh;

/* a plane through `point`, with the unit directions u and v */
typedef struct ruler_plane {
    double point[3], u[3], v[3], normal[3];
} ruler_plane;

/* a closed loop of a cut: box in (u, v) from the plane's point, mean of its points; `taken`: the tape goes round it */
typedef struct ruler_loop {
    int32_t points;
    double low[2], high[2], middle[2];
    bool taken;
} ruler_loop;

/* points (points x 2) in (u, v), each with its loop; chord (chords x 2): the points that a triangle joins */
typedef struct ruler_cut {
    int32_t points, chords, loops;
    double *uv;
    int32_t *loop, *chord;
    ruler_loop *of;
} ruler_cut;

/* read the `v` and `f` lines of an OBJ file; polygons become fans. false: no file, or a line that is not understood */
bool ruler_read(const char *path, ruler_mesh *out);
void ruler_free(ruler_mesh *mesh);

/* the plane through a point with a normal, u as near to `u` as can be */
ruler_plane ruler_plane_at(const double *point, const double *normal, const double *u);
/* cut a mesh; false: no memory. Free it with ruler_cut_free() */
bool ruler_cut_at(const ruler_mesh *mesh, const ruler_plane *plane, ruler_cut *out);
void ruler_cut_free(ruler_cut *cut);

/* take the loops on both sides of u = 0, and with `inner` those whose middles lie between them (the legs at the hip) */
void ruler_take_trunk(ruler_cut *cut, bool inner);
/* take the loop whose middle is nearest to the plane's point */
void ruler_take_nearest(ruler_cut *cut);
/* perimeter of the convex hull of the taken loops; NaN: none is taken */
double ruler_tape(const ruler_cut *cut);

/* length of the hull of n points (n x 2) that lie to the right (side 1) or left (-1) of the way from the first to the
 * last one, without that chord. Reorders the points between them */
double ruler_string(int32_t n, double *uv, double side);
/* whether (u, v) lies within a loop of a cut: a ray meets its chords an odd number of times */
bool ruler_within(const ruler_cut *cut, int32_t loop, double u, double v);
/* distance of (u, v) to the chords of a loop of a cut */
double ruler_off(const ruler_cut *cut, int32_t loop, double u, double v);

#endif
