/*
 * manifold_solid.h: the solids whose union is a body: radius fields of its parts, fingers and toes.
 */
#ifndef MUS_MANIFOLD_MANIFOLD_SOLID_H
#define MUS_MANIFOLD_MANIFOLD_SOLID_H

#include "body/body_make.h"
#include "limb/radius_field_double.h"

#define MUS__DIGITS_A_LIMB 5 /* fingers of a hand, toes of a foot */
#define MUS__DIGITS_MOST (4 * MUS__DIGITS_A_LIMB)
#define MUS__DIGIT_STATIONS (MUS__DIGIT_RINGS + 1) /* cross-sections of a digit: its rings and its tip */
#define MUS__SOLIDS_MOST (MUS__PARTS_MOST + MUS__DIGITS_MOST)

/* a cross-section of a digit: an ellipse in the plane of `side` and `front` */
typedef struct mus__station {
    double centre[3], along[3], side[3], front[3]; /* [m]; directions are unit vectors */
    double square, flat;                           /* squared half axis along `side` [m2]; ratio of front to side */
} mus__station;

/* a finger or toe: cross-sections from root to tip, above the floor */
typedef struct mus__digit {
    mus__station station[MUS__DIGIT_STATIONS];
    bool toe;
    double floor[4]; /* unit normal, and distance from the origin [m] */
    double reach;    /* a point farther than this from the centres of all cross-sections is outside [m] */
} mus__digit;

/* one of the solids whose union is the body: a radius field, of which the part above s = from is drawn at the part
 * `keep` of its length, or a digit */
typedef struct mus__solid {
    const mus__field *field; /* NULL: a digit */
    mus__body_field query;   /* of the field */
    const mus__digit *digit;
    double from, keep;
    double low[3], high[3]; /* box [m] */
} mus__solid;

typedef struct mus__solids {
    int32_t count;
    mus__solid solid[MUS__SOLIDS_MOST];
    mus__digit digit[MUS__DIGITS_MOST];
    double web; /* gaps between two digits up to half of it are filled [m] */
} mus__solids;

/* the solids of a body where it stands, with webs [m] between its digits */
void mus__solids_make(const mus_body *body, double web, mus__solids *out);
/* where a box lies to a solid */
enum {
    MUS__BOX_OUT,   /* outside, and too far off to change the union there */
    MUS__BOX_BESIDE, /* outside, but near enough to a digit for a web */
    MUS__BOX_MIXED, /* the solid's surface may pass through the box */
    MUS__BOX_IN     /* inside */
};
/* where the cube about `middle` (3) with edges of 2 half [m] lies to a solid: MUS__BOX_* */
int mus__solid_box(const mus__solids *solids, int32_t solid, const double *middle, double half);
/* depth (n) of the points x (n x 3) in the union of the solids in the list of length `count`, in ascending order;
 * positive inside; -1e30: far outside. Where one of them is deeper than `enough` [m], the others are not asked */
void mus__solids_depth(const mus__solids *solids, int32_t count, const int32_t *list, double enough, int32_t n,
                       const double *x, double *depth);

#endif
