/*
 * field_kernel.h: one query of a radius field (field.h), as a template on the floating type.
 *
 * Define MUS__REAL (float or double) and MUS__NAME(name), which makes names of that type, then include. The body asks
 * in double, contact in the type of its state; both read this one text. Only + - * / and sqrt.
 *
 *   F(s, a, b) = rho - R(s, q),   rho = |(a,b) - c(s)|,   q the diamond angle of (a,b) - c(s)
 *   dq = (ua db - ub da) / (|ua|+|ub|)^2              in every quadrant
 *   depth = -F / |grad F|,   normal = grad F / |grad F|
 *
 * In a cap the end contour R shrinks as a quarter of an ellipse of half axis L about s = m; there R(s) has no slope at
 * the pole, and the same surface is taken as the level of a form that is smooth through the pole and beyond it:
 *
 *   F(s, a, b) = sqrt((1 - v^2) rho^2 / R(q)^2 + u^2) - 1,   u = (s - m)/L,  v = u at the end contour
 *
 * For a sphere that is the exact distance; outside a convex cap it is never more than the distance.
 */

#define MUS__FIELD_TINY ((MUS__REAL)1e-15) /* keeps divisions finite on the axis */

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


/* 1 - v^2 of a cap whose end contour lies s off the middle of its ellipse */
static inline MUS__REAL MUS__NAME(field_share)(MUS__REAL s, MUS__REAL axis_inverse)
{
    const MUS__REAL v = s * axis_inverse;
    return 1 - v * v;
}


/* the diamond angle of (ua, ub) in steps of the table; inverse = 1 / (|ua| + |ub|). Ring entries j and j1, blend w */
static inline MUS__REAL MUS__NAME(field_angle)(const MUS__NAME(field) * f, MUS__REAL ua, MUS__REAL ub, MUS__REAL inverse,
                                       int32_t *j, int32_t *j1)
{
    const MUS__REAL absa = ua < 0 ? -ua : ua, absb = ub < 0 ? -ub : ub;
    MUS__REAL q;
    if (ub >= 0)
        q = ua >= 0 ? absb * inverse : 1 + absa * inverse;
    else
        q = ua < 0 ? 2 + absb * inverse : 3 + absa * inverse;
    const MUS__REAL w = q * f->angle_scale;
    int32_t i = (int32_t)w;
    if (i >= f->nangle) i = f->nangle - 1;
    *j = i;
    *j1 = i + 1 == f->nangle ? 0 : i + 1;
    return w - (MUS__REAL)i;
}


/* normal = the unit of (ga, gb, gs) in (side, front, axis); returns 1 / its length */
static inline MUS__REAL MUS__NAME(field_normal)(const MUS__NAME(field) * f, MUS__REAL ga, MUS__REAL gb, MUS__REAL gs,
                                       MUS__REAL *normal)
{
    const MUS__REAL g = 1 / (MUS__REAL)MUS__NAME(sqrt)(ga * ga + gb * gb + gs * gs + (MUS__REAL)1e-30);
    for (int32_t i = 0; i < 3; i++) normal[i] = g * (ga * f->side[i] + gb * f->front[i] + gs * f->axis[i]);
    return g;
}


/* the query in a cap: s from the first ring on, (a, b) in the contour's plane */
static inline MUS__REAL MUS__NAME(field_query_cap)(const MUS__NAME(field) * f, MUS__REAL s, MUS__REAL a, MUS__REAL b,
                                            MUS__REAL margin, MUS__REAL *normal, int32_t *near)
{
    const int32_t end = s > 0, last = end ? f->nring - 1 : 0;
    const MUS__REAL beyond = end ? s - f->pole[1] : f->pole[0] - s;
    *near = 0;
    if (!(beyond <= margin)) return 0;

    const MUS__REAL *c = f->centre + 2 * last, *r = f->radius + (int64_t)last * f->nangle;
    const MUS__REAL ua = a - c[0], ub = b - c[1], rho2 = ua * ua + ub * ub;
    const MUS__REAL inverse = 1 / ((ua < 0 ? -ua : ua) + (ub < 0 ? -ub : ub) + MUS__FIELD_TINY);
    const MUS__REAL reach = f->largest[last] + margin;
    if (!(rho2 <= reach * reach)) return 0;
    int32_t j, j1;
    const MUS__REAL w = MUS__NAME(field_angle)(f, ua, ub, inverse, &j, &j1);
    const MUS__REAL radius = r[j] + w * (r[j1] - r[j]), slope_q = (r[j1] - r[j]) * f->angle_scale;

    /* F + 1, and its gradient: rho^2 falls with R, R turns with q */
    const MUS__REAL u = (s - f->middle[end]) * f->axis_inverse[end], k = f->share[end] / (radius * radius);
    const MUS__REAL level = (MUS__REAL)MUS__NAME(sqrt)(k * rho2 + u * u) + MUS__FIELD_TINY, scale = k / level;
    const MUS__REAL turn = rho2 * slope_q * inverse * inverse / radius;
    const MUS__REAL ga = scale * (ua + turn * ub), gb = scale * (ub - turn * ua);
    const MUS__REAL gs = u * f->axis_inverse[end] / level;
    *near = 1;
    return (1 - level) * MUS__NAME(field_normal)(f, ga, gb, gs, normal);
}


/* depth of p (3) in the field, positive inside, with *near 1 and normal (3) the outward normal; or *near 0: p is more
 * than `margin` off the surface */
static inline MUS__REAL MUS__NAME(field_query)(const MUS__NAME(field) * f, const MUS__REAL *p, MUS__REAL margin,
                                        MUS__REAL *normal, int32_t *near)
{
    const MUS__REAL rx = p[0] - f->origin[0], ry = p[1] - f->origin[1], rz = p[2] - f->origin[2];
    const MUS__REAL s = rx * f->axis[0] + ry * f->axis[1] + rz * f->axis[2] - f->s0;
    const MUS__REAL a = rx * f->side[0] + ry * f->side[1] + rz * f->side[2];
    const MUS__REAL b = rx * f->front[0] + ry * f->front[1] + rz * f->front[2];

    /* ring */
    const MUS__REAL u = s * f->ds_inverse;
    if (!(u >= 0 && u < f->ring_last)) return MUS__NAME(field_query_cap)(f, s, a, b, margin, normal, near);
    const int32_t k = (int32_t)u;
    const MUS__REAL t = u - (MUS__REAL)k;

    /* place in the contour's plane, about the in-between centre */
    const MUS__REAL *c = f->centre + 2 * k;
    const MUS__REAL dca = c[2] - c[0], dcb = c[3] - c[1];
    const MUS__REAL ua = a - (c[0] + t * dca), ub = b - (c[1] + t * dcb);
    const MUS__REAL rho2 = ua * ua + ub * ub;
    const MUS__REAL reach = f->largest[k] + 4 * margin; /* 4: a steep surface is near though its radius is far */
    *near = 0;
    if (!(rho2 <= reach * reach)) return 0;

    /* the radius and its slopes: its square bilinear, since where a limb ends roundly the square has a slope still */
    int32_t j, j1;
    const MUS__REAL inverse = 1 / ((ua < 0 ? -ua : ua) + (ub < 0 ? -ub : ub) + MUS__FIELD_TINY);
    const MUS__REAL w = MUS__NAME(field_angle)(f, ua, ub, inverse, &j, &j1);
    const MUS__REAL *r0 = f->radius + (int64_t)k * f->nangle, *r1 = r0 + f->nangle;
    const MUS__REAL s00 = r0[j] * r0[j], s01 = r0[j1] * r0[j1], s10 = r1[j] * r1[j], s11 = r1[j1] * r1[j1];
    const MUS__REAL low = s00 + w * (s01 - s00), high = s10 + w * (s11 - s10);
    const MUS__REAL radius = (MUS__REAL)MUS__NAME(sqrt)(low + t * (high - low)), half = (MUS__REAL)0.5 / radius;
    const MUS__REAL slope_s = (high - low) * f->ds_inverse * half;
    const MUS__REAL slope_q = ((1 - t) * (s01 - s00) + t * (s11 - s10)) * f->angle_scale * half;

    /* gradient of F in (side, front, axis) */
    const MUS__REAL rho = (MUS__REAL)MUS__NAME(sqrt)(rho2) + MUS__FIELD_TINY;
    const MUS__REAL turn = slope_q * inverse * inverse, out = 1 / rho;
    const MUS__REAL ga = ua * out + turn * ub, gb = ub * out - turn * ua;
    const MUS__REAL gs = -slope_s - (ga * dca + gb * dcb) * f->ds_inverse;
    *near = 1;
    return (radius - rho) * MUS__NAME(field_normal)(f, ga, gb, gs, normal);
}

#undef MUS__FIELD_TINY
