/*
 * radius_field_kernel.h: the distance query of a radius field (radius_field.h), as a template on the floating type.
 *
 * Define MUS__REAL (float or double) and MUS__NAME(name), which makes names of that type, then include. The body asks
 * one point in double; contact asks one node, or many in a row, in the type of its state. All of them use the inline
 * functions here, so they give the same bits; these have no branch, so that a loop over nodes becomes vectors. Only
 * + - * / and sqrt.
 *
 *   F(s, a, b) = rho - R(s, q),   rho = |(a,b) - c(s)|,   q the diamond angle of (a,b) - c(s)
 *   dq = (ua db - ub da) / (|ua|+|ub|)^2              in every quadrant
 *   depth = -F / |grad F|,   normal = grad F / |grad F|
 *
 * In a cap the end contour R shrinks as a quarter of an ellipse of half axis L about s = m; there R(s) has no slope at
 * the pole, and the same surface is taken as a level set of a form that is smooth through the pole and beyond it:
 *
 *   F(s, a, b) = sqrt((1 - v^2) rho^2 / R(q)^2 + u^2) - 1,   u = (s - m)/L,  v = u at the end contour
 *
 * For a sphere that is the exact distance; outside a convex cap it is never more than the distance.
 */
#include "base/target_clones.h"

#define MUS__FIELD_TINY ((MUS__REAL)1e-15) /* [m] keeps divisions finite on the axis; far below every radius */

typedef struct MUS__NAME(field) {
    MUS__REAL origin[3], axis[3], side[3], front[3];
    MUS__REAL s0, ds_inverse, ring_last; /* ring_last = nring - 1 */
    MUS__REAL angle_scale;               /* nangle / 4 */
    int32_t nring, nangle;
    MUS__REAL pole[2];                              /* of the caps: s - s0 of the pole, */
    MUS__REAL middle[2], axis_inverse[2], share[2]; /* m - s0, 1/L, 1 - v^2 */
    const MUS__REAL *centre;                        /* (nring x 2) */
    const MUS__REAL *radius;                        /* (nring x nangle) */
    const MUS__REAL *largest;                       /* (nring) largest radius of ring k and k + 1 */
} MUS__NAME(field);

/* a point in the plane of a contour: between rings k and k + 1, or on ring k where a cap begins */
typedef struct MUS__NAME(field_place) {
    int32_t k;
    MUS__REAL t;          /* share of ring k + 1 */
    MUS__REAL ua, ub;     /* from the contour's centre */
    MUS__REAL dca, dcb;   /* from centre k to centre k + 1 */
    MUS__REAL rho2;       /* ua^2 + ub^2 */
    MUS__REAL reach;      /* a point further from the centre is further from the surface than the margin */
} MUS__NAME(field_place);


/* 1 - v^2 of a cap whose end contour lies s off the middle of its ellipse */
static inline MUS__REAL MUS__NAME(field_share)(MUS__REAL s, MUS__REAL axis_inverse)
{
    const MUS__REAL v = s * axis_inverse;
    return 1 - v * v;
}


/* out (3): s from the first ring along the axis, a and b in the contour's plane, of p (3) */
static MUS_INLINE void MUS__NAME(field_local)(const MUS__NAME(field) * f, const MUS__REAL *p, MUS__REAL *out)
{
    const MUS__REAL rx = p[0] - f->origin[0], ry = p[1] - f->origin[1], rz = p[2] - f->origin[2];
    out[0] = rx * f->axis[0] + ry * f->axis[1] + rz * f->axis[2] - f->s0;
    out[1] = rx * f->side[0] + ry * f->side[1] + rz * f->side[2];
    out[2] = rx * f->front[0] + ry * f->front[1] + rz * f->front[2];
}


/* the place u rings from the first one, at (a, b), between two rings: 0 <= u < nring - 1 */
static MUS_INLINE void MUS__NAME(field_between)(const MUS__NAME(field) * f, MUS__REAL u, MUS__REAL a, MUS__REAL b,
                                                MUS__REAL margin, MUS__NAME(field_place) * at)
{
    const int32_t k = (int32_t)u;
    const MUS__REAL c0 = f->centre[2 * k], c1 = f->centre[2 * k + 1]; /* by index: the compiler makes a gather of it */
    at->k = k;
    at->t = u - (MUS__REAL)k;
    at->dca = f->centre[2 * k + 2] - c0, at->dcb = f->centre[2 * k + 3] - c1;
    at->ua = a - (c0 + at->t * at->dca), at->ub = b - (c1 + at->t * at->dcb);
    at->rho2 = at->ua * at->ua + at->ub * at->ub;
    at->reach = f->largest[k] + 4 * margin; /* 4: a steep surface is near though its radius is far */
}


/* the place at (a, b) on the ring where a cap begins, the last one when `end` is 1, else the first */
static MUS_INLINE void MUS__NAME(field_at_cap)(const MUS__NAME(field) * f, int32_t end, MUS__REAL a, MUS__REAL b,
                                               MUS__REAL margin, MUS__NAME(field_place) * at)
{
    const int32_t k = end * (f->nring - 1);
    at->k = k;
    at->ua = a - f->centre[2 * k], at->ub = b - f->centre[2 * k + 1];
    at->rho2 = at->ua * at->ua + at->ub * at->ub;
    at->reach = f->largest[k] + margin;
}


/* the diamond angle of (ua, ub) in steps of the table: entries *j and *j1 of a ring; returns the share of the second.
 * inverse = 1 / (|ua| + |ub|) */
static MUS_INLINE MUS__REAL MUS__NAME(field_angle)(const MUS__NAME(field) * f, MUS__REAL ua, MUS__REAL ub,
                                                   MUS__REAL inverse, int32_t *j, int32_t *j1)
{
    const MUS__REAL absa = ua < 0 ? -ua : ua, absb = ub < 0 ? -ub : ub;
    const int32_t n = f->nangle, left = ua < 0, back = ub < 0, quarter = 3 * back + left - 2 * (back & left);
    const MUS__REAL part = left != back ? absa : absb, q = (MUS__REAL)quarter + part * inverse;
    const MUS__REAL step = q * f->angle_scale;
    const int32_t whole = (int32_t)step, low = whole >= n ? n - 1 : whole;
    *j = low;
    *j1 = low + 1 == n ? 0 : low + 1;
    return step - (MUS__REAL)low;
}


/* normal (3): the unit vector of (ga, gb, gs) in (side, front, axis); returns 1 / its length */
static MUS_INLINE MUS__REAL MUS__NAME(field_normal)(const MUS__NAME(field) * f, MUS__REAL ga, MUS__REAL gb,
                                                    MUS__REAL gs, MUS__REAL *normal)
{
    const MUS__REAL g = 1 / (MUS__REAL)MUS__NAME(sqrt)(ga * ga + gb * gb + gs * gs + (MUS__REAL)1e-30);
    for (int32_t i = 0; i < 3; i++) normal[i] = g * (ga * f->side[i] + gb * f->front[i] + gs * f->axis[i]);
    return g;
}


/* depth at a place between two rings, and normal (3). The square of the radius is bilinear in ring and angle: where a
 * limb ends roundly the square still has a slope */
static MUS_INLINE MUS__REAL MUS__NAME(field_depth_between)(const MUS__NAME(field) * f,
                                                           const MUS__NAME(field_place) * at, MUS__REAL *normal)
{
    const MUS__REAL ua = at->ua, ub = at->ub, t = at->t;
    const MUS__REAL inverse = 1 / ((ua < 0 ? -ua : ua) + (ub < 0 ? -ub : ub) + MUS__FIELD_TINY);
    int32_t j, j1;
    const MUS__REAL w = MUS__NAME(field_angle)(f, ua, ub, inverse, &j, &j1);
    const int32_t r0 = at->k * f->nangle, r1 = r0 + f->nangle;
    const MUS__REAL p00 = f->radius[r0 + j], p01 = f->radius[r0 + j1];
    const MUS__REAL p10 = f->radius[r1 + j], p11 = f->radius[r1 + j1];
    const MUS__REAL s00 = p00 * p00, s01 = p01 * p01, s10 = p10 * p10, s11 = p11 * p11;
    const MUS__REAL low = s00 + w * (s01 - s00), high = s10 + w * (s11 - s10);
    const MUS__REAL radius = (MUS__REAL)MUS__NAME(sqrt)(low + t * (high - low)), half = (MUS__REAL)0.5 / radius;
    const MUS__REAL slope_s = (high - low) * f->ds_inverse * half;
    const MUS__REAL slope_q = ((1 - t) * (s01 - s00) + t * (s11 - s10)) * f->angle_scale * half;

    /* gradient of F in (side, front, axis) */
    const MUS__REAL rho = (MUS__REAL)MUS__NAME(sqrt)(at->rho2) + MUS__FIELD_TINY;
    const MUS__REAL turn = slope_q * inverse * inverse, out = 1 / rho;
    const MUS__REAL ga = ua * out + turn * ub, gb = ub * out - turn * ua;
    const MUS__REAL gs = -slope_s - (ga * at->dca + gb * at->dcb) * f->ds_inverse;
    return (radius - rho) * MUS__NAME(field_normal)(f, ga, gb, gs, normal);
}


/* depth at a place in a cap, s along the axis, and normal (3) */
static MUS_INLINE MUS__REAL MUS__NAME(field_depth_in_cap)(const MUS__NAME(field) * f,
                                                          const MUS__NAME(field_place) * at, int32_t end, MUS__REAL s,
                                                          MUS__REAL *normal)
{
    const MUS__REAL middle = end ? f->middle[1] : f->middle[0], share = end ? f->share[1] : f->share[0];
    const MUS__REAL axis_inverse = end ? f->axis_inverse[1] : f->axis_inverse[0], ua = at->ua, ub = at->ub;
    const MUS__REAL inverse = 1 / ((ua < 0 ? -ua : ua) + (ub < 0 ? -ub : ub) + MUS__FIELD_TINY);
    int32_t j, j1;
    const MUS__REAL w = MUS__NAME(field_angle)(f, ua, ub, inverse, &j, &j1);
    const MUS__REAL r0 = f->radius[at->k * f->nangle + j], r1 = f->radius[at->k * f->nangle + j1];
    const MUS__REAL radius = r0 + w * (r1 - r0), slope_q = (r1 - r0) * f->angle_scale;

    /* F + 1, and its gradient: rho^2 falls with R, R turns with q */
    const MUS__REAL u = (s - middle) * axis_inverse, k = share / (radius * radius);
    const MUS__REAL level = (MUS__REAL)MUS__NAME(sqrt)(k * at->rho2 + u * u) + MUS__FIELD_TINY, scale = k / level;
    const MUS__REAL turn = at->rho2 * slope_q * inverse * inverse / radius;
    const MUS__REAL ga = scale * (ua + turn * ub), gb = scale * (ub - turn * ua);
    const MUS__REAL gs = u * axis_inverse / level;
    return (1 - level) * MUS__NAME(field_normal)(f, ga, gb, gs, normal);
}


/* depth of p (3) in the field, positive inside, with *near 1 and normal (3) the outward normal; or *near 0: p is more
 * than `margin` off the surface */
static inline MUS__REAL MUS__NAME(field_query)(const MUS__NAME(field) * f, const MUS__REAL *p, MUS__REAL margin,
                                               MUS__REAL *normal, int32_t *near)
{
    MUS__REAL local[3];
    MUS__NAME(field_place) at;
    MUS__NAME(field_local)(f, p, local);
    const MUS__REAL s = local[0], u = s * f->ds_inverse;
    *near = 0;
    if (u >= 0 && u < f->ring_last) {
        MUS__NAME(field_between)(f, u, local[1], local[2], margin, &at);
        if (!(at.rho2 <= at.reach * at.reach)) return 0;
        *near = 1;
        return MUS__NAME(field_depth_between)(f, &at, normal);
    }
    const int32_t end = s > 0;
    const MUS__REAL beyond = end ? s - f->pole[1] : f->pole[0] - s;
    if (!(beyond <= margin)) return 0;
    MUS__NAME(field_at_cap)(f, end, local[1], local[2], margin, &at);
    if (!(at.rho2 <= at.reach * at.reach)) return 0;
    *near = 1;
    return MUS__NAME(field_depth_in_cap)(f, &at, end, s, normal);
}

#undef MUS__FIELD_TINY
