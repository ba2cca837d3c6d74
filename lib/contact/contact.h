/*
 * contact.h: cloth nodes against a body made of radius fields, and against planes: arrays in, arrays out.
 *
 * For each node: the parts whose box it is in; its axial coordinate; the in-between contour at that height; the line
 * from the centre to the node (Metaaphanon and Kanongchaiyos 2005, 4.1). Response: perfectly inelastic along the
 * normal, Coulomb friction along the surface, position put back to the clearance (4.2). The paper's eq. 12 adds a
 * force to a velocity; impulses are meant:  v_n+ = 0,  v_t+ = v_t max(0, 1 - mu |v_n| / |v_t|).
 * O(parts) a node; no triangle is asked.
 *
 * A part keeps the field that it was made with. Where it stands is in four vectors of the field, which a query reads
 * anyhow: a part that was moved costs what one at rest does. How it came there in the last step is two affine maps
 * (mus__carry); all response is relative to that motion at the node.
 */
#ifndef MUS_CONTACT_CONTACT_H
#define MUS_CONTACT_CONTACT_H

#include <math.h>

#include "base/base_internal.h"
#include "body/rig.h"
#include "muslin/body.h"

#define MUS_REAL float
#define MUS_FIELD(name) mus__f32_##name
#define mus__f32_sqrt sqrtf
#include "limb/field_kernel.h"
#include "contact/meet_kernel.h"
#undef MUS_REAL
#undef MUS_FIELD

#define MUS_REAL double
#define MUS_FIELD(name) mus__f64_##name
#define mus__f64_sqrt sqrt
#include "limb/field_kernel.h"
#include "contact/meet_kernel.h"
#undef MUS_REAL
#undef MUS_FIELD

#define MUS_LIMBS_MOST 64
#define MUS_PLANES_MOST 32
#define MUS_PLANE_THICK 0.01 /* [m]: a disc is as thick; what is farther below it is under the table */
#define MUS_PLANE_HUGE 1e15  /* [m]: without an end */
#define MUS_PLANE_SAFE 5e-3  /* [m]: so far may a node go in a step until it is swept against planes */

/* what a surface did in the last step, as maps of a place in the state's coordinates, rows of 3, then what is added:
 * how far it carried what was at x before the step, and the velocity of what is at x after it */
typedef struct mus__carry {
    double on[12], speed[12];
} mus__carry;

typedef struct mus__contact_plane {
    double point[3], normal[3]; /* in the body frame; unit */
    double friction;            /* below 0: the rule's */
    double reach;               /* of a disc; 0: no end [m] */
    int32_t moving;             /* nonzero: the carry of the last step is not nothing */
    mus__carry carry;
} mus__contact_plane;

/* where a part of the body was made, and its hull */
typedef struct mus__contact_home {
    double origin[3], axis[3], side[3], front[3]; /* in the state's coordinates */
    double end[2], reach;                         /* of the axis, across it */
    double safe;                                  /* as the collider's, through this part alone [m] */
    double haste;                                 /* of this part, likewise [m/s] */
} mus__contact_home;

typedef struct mus__collider {
    mus_context *context;
    int32_t nlimb;           /* parts of the body, each with a field */
    double skin;             /* the fields are this much wider than the body [m] */
    double origin[3];        /* of the state's coordinates in the body frame */
    mus__f32_field *field32; /* (nlimb) where the parts stand now */
    mus__f64_field *field64; /* (nlimb) */
    double *box;             /* (nlimb x 6) low x, y, z, high x, y, z, with the skin */
    mus__contact_home *home; /* (nlimb) */
    double safe;             /* a node that moves no farther than this in a step goes through no part [m] */
    double shift[3];         /* how far the body has glided from where it was made [m] */
    double drift[3];         /* and its velocity [m/s] */
    mus__frame *frame;       /* (nlimb) of the parts now, without the shift */
    int32_t turned;          /* nonzero: not all of them stand as made */
    int32_t moving;          /* what the body did in the last step: MUS_STOOD, MUS_GLIDED, MUS_TURNED */
    mus__carry *carry;       /* (nlimb) of MUS_TURNED; of MUS_GLIDED the first stands for all */
    double haste;            /* no surface moves faster against the drift [m/s] */
    double plane_haste;      /* no plane does [m/s] */
    int32_t nplane;
    mus__contact_plane *plane; /* (MUS_PLANES_MOST), NULL without planes */
    float *table32;            /* all rings of all parts */
    double *table64;
} mus__collider;

/* number of the lowest bit that is set, of a number that is not 0 */
static inline int32_t mus__lowest_bit(uint64_t bits)
{
#if defined(__GNUC__)
    return __builtin_ctzll(bits);
#else
    int32_t k = 0;
    for (; (bits & 1) == 0; bits >>= 1) k++;
    return k;
#endif
}

enum { MUS_STOOD, MUS_GLIDED, MUS_TURNED };

/* fields and boxes are relative to `origin` (3), as the state is: float keeps its digits near it. The fields are those
 * of the surface `skin` [m] off the body, where cloth is to rest; depths that callers get are from the body itself.
 * body NULL: planes alone */
mus_status mus__collider_create(mus_context *context, const mus_body *body, const double *origin, double skin,
                                mus__collider **out);
void mus__collider_destroy(mus__collider *collider);

/* ---- where surfaces stand (stand.c) ---- */

/* the parts of the body now stand as `frame` (nlimb) says, NULL: as made, and all `shift` (3) off that, where they came
 * from where they stood in a step of `h`, the shift with velocity `drift` (3); h 0: they are at rest there */
void mus__collider_move(mus__collider *collider, const mus__frame *frame, const double *shift, const double *drift,
                        double h);

/* one more plane, at rest: MUS_ERR_LIMIT, MUS_ERR_MEMORY */
mus_status mus__collider_add_plane(mus__collider *collider, const double *point, const double *normal, double friction,
                                   double reach);
/* plane k now lies at `point` (3), where it came with `velocity` (3), turning about its normal, in a step of `h`; h 0:
 * it is at rest there */
void mus__collider_move_plane(mus__collider *collider, int32_t k, const double *point, const double *velocity,
                              double spin, double h);
/* the fastest of all surfaces, once all were moved */
void mus__collider_haste(mus__collider *collider);

/* ---- questions ---- */

/* largest depth of a point of the world over all surfaces, positive inside; -1e30 out of reach of all */
double mus__collider_depth(const mus__collider *collider, const double *point, double margin, double *normal);

/* outward normals of the surfaces that are nearer to a point of the world than `reach`: normals (most x 3), with the
 * friction that is each one's own (most), below 0 where it has none; their number */
#define MUS_TOUCH_MOST 4
int32_t mus__collider_touching(const mus__collider *collider, const double *point, double reach, double *normals,
                               double *friction);

typedef struct mus__contact_rule {
    double clearance; /* nodes are kept this far off [m] */
    double friction;
    double push;   /* a node that was inside before is put back by at most this in one call [m] */
    double deep;   /* [1/s] near alone: of what is deeper than MUS_NEAR_DEEP, as much more in a second */
    double travel; /* no node moves farther between two calls [m]; 0: not known */
    double slip;   /* [s] h for symplectic Euler, h/2 for RK4: how long the step moved with the old velocity */
    double step;   /* [s] since the last call */
    double ball;   /* of near.h: how far a node near the skin may go until it is asked again [m] */
    double slick;  /* part of the friction that planes of their own have less */
    double pull;   /* [m/s2] what is pinched is drawn out so; 0: it is put out, by `push` */
} mus__contact_rule;

/* [m] round a limb of 5 cm a plane is 0.6 um off at the edge of a ball of this */
#define MUS_NEAR_BALL 2.5e-4
#define MUS_NEAR_DEEP 1e-3 /* [m] below the clearance, where cloth is to rest */

/* what a node need not be asked for a while: until it or the surfaces have gone `slack` [m], the parts whose bits are
 * set, or all surfaces */
typedef struct mus__aside {
    float slack;
    uint32_t parts; /* of the first ASIDE_PARTS, or ASIDE_ALL */
} mus__aside;

#define ASIDE_PARTS 31
#define ASIDE_ALL ((uint32_t)1 << ASIDE_PARTS)

/* what calls add up */
typedef struct mus__contact_tally {
    int64_t queries;   /* node against part or plane */
    double impulse[3]; /* that the body gave [N s] */
    int32_t swift;     /* nonzero: a node is so fast that the next call should know where the nodes are now */
} mus__contact_tally;

/* the speed relative to the drift of the body from which on a node is swift [m/s]: a quarter of the way through the
 * thinnest part in a step, less what the surfaces move themselves */
static inline double mus__contact_swift(const mus__collider *collider, const mus__contact_rule *rule)
{
    const double swift = rule->step > 0.0 ? 0.5 * collider->safe / rule->step - collider->haste : 1e15;
    return swift > 0.0 ? swift : 0.0;
}

/* how far a surface of that haste may have gone since the last call [m]; a float of it is not below */
static inline double mus__contact_carried(const mus__collider *collider, const mus__contact_rule *rule, double haste)
{
    const double *d = collider->drift, drift = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    return 1.001 * rule->step * (haste + drift) + 1e-9;
}

/* nonzero when a node of first .. last-1 is swift; v planes (3 x n) */
int32_t mus__contact_rush_f32(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                              int32_t last, const float *v);
int32_t mus__contact_rush_f64(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                              int32_t last, const double *v);

/* nodes first .. last-1 of n: x, v planes (3 x n); inverse (n) 1/mass, 0 for nodes that are held; before (3 x n) places
 * before the step; `sweeps` nonzero: fast nodes are swept; aside (n) starts as zeros, and when surfaces jump */
void mus__contact_f32(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                      int32_t last, const float *inverse, const float *before, int32_t sweeps, mus__aside *aside,
                      float *x, float *v, mus__contact_tally *tally);
void mus__contact_f64(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                      int32_t last, const double *inverse, const double *before, int32_t sweeps, mus__aside *aside,
                      double *x, double *v, mus__contact_tally *tally);

#define MUS_REAL float
#define MUS_FIELD(name) mus__f32_##name
#include "contact/scene_kernel.h"
#undef MUS_REAL
#undef MUS_FIELD

#define MUS_REAL double
#define MUS_FIELD(name) mus__f64_##name
#include "contact/scene_kernel.h"
#undef MUS_REAL
#undef MUS_FIELD

#endif
