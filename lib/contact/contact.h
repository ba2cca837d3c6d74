/*
 * contact.h: cloth nodes against a body made of radius fields: arrays in, arrays out.
 *
 * For each node: the limbs whose box it is in; its axial coordinate; the in-between contour at that height; the line
 * from the centre to the node (Metaaphanon and Kanongchaiyos 2005, 4.1). Response: perfectly inelastic along the
 * normal, Coulomb friction along the surface, position put back to the clearance (4.2). The paper's eq. 12 adds a
 * force to a velocity; impulses are meant:  v_n+ = 0,  v_t+ = v_t max(0, 1 - mu |v_n| / |v_t|).
 * O(limbs) a node; no triangle is asked.
 */
#ifndef MUS_CONTACT_CONTACT_H
#define MUS_CONTACT_CONTACT_H

#include <math.h>

#include "base/base_internal.h"
#include "muslin/body.h"

#define MUS_REAL float
#define MUS_FIELD(name) mus__f32_##name
#define mus__f32_sqrt sqrtf
#include "body/field_kernel.h"
#undef MUS_REAL
#undef MUS_FIELD

#define MUS_REAL double
#define MUS_FIELD(name) mus__f64_##name
#define mus__f64_sqrt sqrt
#include "body/field_kernel.h"
#undef MUS_REAL
#undef MUS_FIELD

#define MUS_LIMBS_MOST 64

typedef struct mus__collider {
    mus_context *context;
    int32_t nlimb;
    double skin;             /* the fields are this much wider than the body [m] */
    double origin[3];        /* of the state's coordinates in the body frame */
    mus__f32_field *field32; /* (nlimb) */
    mus__f64_field *field64; /* (nlimb) */
    double *box;             /* (nlimb x 6) low x, y, z, high x, y, z, with the skin */
    double safe;             /* a node that moves no farther than this in a step goes through no limb [m] */
    double shift[3];         /* how far the body has glided from where it was made [m] */
    double drift[3];         /* and its velocity [m/s] */
    float *table32;          /* all rings of all limbs */
    double *table64;
} mus__collider;

/* fields and boxes are relative to `origin` (3), as the state is: float keeps its digits near it. The fields are those
 * of the surface `skin` [m] off the body, where cloth is to rest; depths that callers get are from the body itself. */
mus_status mus__collider_create(mus_context *context, const mus_body *body, const double *origin, double skin,
                                mus__collider **out);
void mus__collider_destroy(mus__collider *collider);

/* the body now stands `shift` (3) off where it was made and glides with velocity `drift` (3) */
void mus__collider_move(mus__collider *collider, const double *shift, const double *drift);

/* largest depth of a point of the world over the limbs, positive inside; -1e30 out of reach of all */
double mus__collider_depth(const mus__collider *collider, const double *point, double margin, double *normal);

/* outward normals of the limbs that are nearer to a point of the world than `reach`: out (most x 3), their
 * number */
#define MUS_TOUCH_MOST 4
int32_t mus__collider_touching(const mus__collider *collider, const double *point, double reach, double *normals);

typedef struct mus__contact_rule {
    double clearance; /* nodes are kept this far off [m] */
    double friction;
    double push;   /* a node that was inside before is put back by at most this in one call [m] */
    double travel; /* no node moves farther between two calls [m]; 0: not known, every node is asked every time */
    double slip;   /* [s] h for symplectic Euler, h/2 for RK4: how long the step moved with the old velocity */
    double step;   /* [s] since the last call */
    double ball;   /* of near.h: how far a node near the skin may go until it is asked again [m] */
} mus__contact_rule;

/* [m] round a limb of 5 cm a plane is 0.6 um off at the edge of a ball of this */
#define MUS_NEAR_BALL 2.5e-4

/* what calls add up */
typedef struct mus__contact_tally {
    int64_t queries;   /* node against limb */
    double impulse[3]; /* that the body gave [N s] */
    int32_t swift;     /* nonzero: a node is so fast that the next call should know where the nodes are now */
} mus__contact_tally;

/* the speed relative to the body from which on a node is swift [m/s]: a quarter of the way through the thinnest limb
 * in a step */
static inline double mus__contact_swift(const mus__collider *collider, const mus__contact_rule *rule)
{
    return rule->step > 0.0 ? 0.5 * collider->safe / rule->step : 1e15;
}

/* nonzero when a node of first .. last-1 is swift; v planes (3 x n) */
int32_t mus__contact_rush_f32(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                              int32_t last, const float *v);
int32_t mus__contact_rush_f64(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                              int32_t last, const double *v);

/* nodes first .. last-1 of n: x, v planes (3 x n); inverse (n) 1/mass, 0 for nodes that are held; before (3 x n) places
 * before the step; `sweeps` nonzero: fast nodes are swept */
void mus__contact_f32(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                      int32_t last, const float *inverse, const float *before, int32_t sweeps, uint8_t *rest, float *x,
                      float *v, mus__contact_tally *tally);
void mus__contact_f64(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                      int32_t last, const double *inverse, const double *before, int32_t sweeps, uint8_t *rest,
                      double *x, double *v, mus__contact_tally *tally);

#endif
