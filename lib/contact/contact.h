/*
 * contact.h: the contact pass: nodes of a cloth against the surfaces of a collider, after each step. Arrays in and out.
 *
 * Response (Metaaphanon and Kanongchaiyos 2005, section 4.2): perfectly inelastic along the normal, Coulomb friction
 * along the surface, the node put back to the clearance. Equation 12 of the paper adds a force to a velocity; impulses
 * are meant:  v_n+ = 0,  v_t+ = v_t max(0, 1 - mu |v_n| / |v_t|).  All velocities are relative to the surface at the
 * node.
 */
#ifndef MUS_CONTACT_CONTACT_H
#define MUS_CONTACT_CONTACT_H

#include <math.h>

#include "contact/collider.h"

/* cosine of the normals of two surfaces that face each other, and pinch a node between them: 120 degrees; chosen */
#define MUS__PINCH_FACING -0.5

typedef struct mus__contact_rule {
    double clearance;    /* gap kept between node and skin [m] */
    double friction;     /* coefficient */
    double push;         /* a node that was inside before the step is put back by at most this in one call [m] */
    double deep;         /* plane cache alone: share of the depth beyond MUS__CACHE_DEEP put back in a second [1/s] */
    double travel;       /* bound of a node's travel between two calls [m]; 0: not known */
    double slip;         /* how long the step moved the node with its old velocity: h for symplectic Euler, h/2 for
                          * RK4 [s] */
    double step;         /* time since the last call [s] */
    double cache_radius; /* plane cache alone: travel of a node near a surface until it is queried again [m] */
    double slick;        /* share by which the friction of planes with their own coefficient is reduced */
    double pull;         /* a pinched node is drawn out with this acceleration [m/s2]; 0: it is put out by `push` */
} mus__contact_rule;

/* nodes first .. last-1 of a state in planes of n numbers, of the type that the pass is of. inverse (n): 1/mass, 0 for
 * nodes that are held; before (3 x n): places before the step; x, v (3 x n): changed in place; lift (n): how much
 * farther than the clearance a node stays off the parts of a body [m], NULL: no farther */
typedef struct mus__contact_nodes {
    int32_t n, first, last;
    const void *inverse, *before;
    void *x, *v;
    const float *lift;
} mus__contact_nodes;

/* the lift of node i */
static inline float mus__contact_lift(const mus__contact_nodes *nodes, int64_t i)
{
    return nodes->lift != NULL ? nodes->lift[i] : 0.0f;
}

/* distance cache of a node: surfaces that need no query until the node and the surfaces have travelled `slack` [m] */
typedef struct mus__distance_cache {
    float slack;
    uint32_t parts; /* a bit for each of the first MUS__CACHE_PARTS parts; or MUS__CACHE_ALL: no surface at all */
} mus__distance_cache;

#define MUS__CACHE_PARTS 31 /* bits of `parts` that name one part */
#define MUS__CACHE_ALL ((uint32_t)1 << MUS__CACHE_PARTS)

/* what calls add up */
typedef struct mus__contact_tally {
    int64_t queries;   /* node against part or plane */
    double impulse[3]; /* of the surfaces on the cloth [N s] */
    int32_t fast;      /* nonzero: a node was so fast that the next call needs places before the step, to sweep */
} mus__contact_tally;

/* speed relative to the body's drift from which on a node counts as fast [m/s]: in a step it covers a quarter of the
 * thinnest part's thickness, less what the surfaces move themselves */
static inline double mus__contact_fast_speed(const mus__collider *collider, const mus__contact_rule *rule)
{
    const double fast = rule->step > 0.0 ? 0.5 * collider->safe / rule->step - collider->speed_max : 1e15;
    return fast > 0.0 ? fast : 0.0;
}

/* bound of the travel since the last call of a surface with relative speed up to `speed` [m]; larger by more than what
 * rounding to float takes off */
static inline double mus__contact_surface_travel(const mus__collider *collider, const mus__contact_rule *rule,
                                                 double speed)
{
    const double *d = collider->drift, drift = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    return 1.001 * rule->step * (speed + drift) + 1e-9;
}

/* nonzero when one of the nodes is fast */
int32_t mus__contact_any_fast_f32(const mus__collider *collider, const mus__contact_rule *rule,
                                  const mus__contact_nodes *nodes);
int32_t mus__contact_any_fast_f64(const mus__collider *collider, const mus__contact_rule *rule,
                                  const mus__contact_nodes *nodes);

/* answers the contacts of `nodes`. `sweeps` nonzero: fast nodes are swept; cache (n) is all zeros at first, and again
 * when surfaces jump */
void mus__contact_pass_f32(const mus__collider *collider, const mus__contact_rule *rule,
                           const mus__contact_nodes *nodes, int32_t sweeps, mus__distance_cache *cache,
                           mus__contact_tally *tally);
void mus__contact_pass_f64(const mus__collider *collider, const mus__contact_rule *rule,
                           const mus__contact_nodes *nodes, int32_t sweeps, mus__distance_cache *cache,
                           mus__contact_tally *tally);

#endif
