/*
 * slice.h: a made body cut by a level plane, from its triangles alone: a second way to its girths.
 *
 * The library measures the rings of its surface; here nothing is known of rings: every triangle of a limb that passes
 * the plane gives a chord, and the tape is the convex hull of all their ends.
 */
#ifndef MUS_TESTS_PEOPLE_SLICE_H
#define MUS_TESTS_PEOPLE_SLICE_H

#include <stdbool.h>

#include "muslin/body.h"

typedef struct slice {
    double girth, breadth, depth; /* of the hull [m]: along X, along Z */
    double area;                  /* within the hull [m2] */
} slice;

/* the limb (by index) at height y [m]; false where the plane passes it by */
bool slice_limb(const mus_body *body, int limb, double y, slice *out);
/* the hull of torso and legs, as the tape lies over the seat */
bool slice_trunk(const mus_body *body, double y, slice *out);

#endif
