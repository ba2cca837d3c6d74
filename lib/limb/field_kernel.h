/*
 * field_kernel.h: one query of a radius field (field.h), as a template on the floating type.
 *
 * Define MUS_REAL (float or double) and MUS_FIELD(name), which makes names of that type, then include. The body asks
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

#define MUS_FIELD_TINY ((MUS_REAL)1e-15) /* keeps divisions finite on the axis */

typedef struct MUS_FIELD(field) {
    MUS_REAL origin[3], axis[3], side[3], front[3];
    MUS_REAL s0, ds_inverse, ring_last; /* ring_last = nring - 1 */
    MUS_REAL angle_scale;               /* nangle / 4 */
    int32_t nring, nangle;
    MUS_REAL pole[2];                              /* of the caps: s - s0 of the pole, */
    MUS_REAL middle[2], axis_inverse[2], share[2]; /* m - s0, 1/L, 1 - v^2 */
    const MUS_REAL *centre;                        /* (nring x 2) */
    const MUS_REAL *radius;                        /* (nring x nangle) */
    const MUS_REAL *largest;                       /* (nring) largest radius of ring k and k + 1 */
} MUS_FIELD(field);


/* 1 - v^2 of a cap whose end contour lies s off the middle of its ellipse */
static inline MUS_REAL MUS_FIELD(share)(MUS_REAL s, MUS_REAL axis_inverse)
{
    const MUS_REAL v = s * axis_inverse;
    return 1 - v * v;
}


/* the diamond angle of (ua, ub) in steps of the table; inverse = 1 / (|ua| + |ub|). Ring entries j and j1, blend w */
static inline MUS_REAL MUS_FIELD(step)(const MUS_FIELD(field) * f, MUS_REAL ua, MUS_REAL ub, MUS_REAL inverse,
                                       int32_t *j, int32_t *j1)
{
    const MUS_REAL absa = ua < 0 ? -ua : ua, absb = ub < 0 ? -ub : ub;
    MUS_REAL q;
    if (ub >= 0)
        q = ua >= 0 ? absb * inverse : 1 + absa * inverse;
    else
        q = ua < 0 ? 2 + absb * inverse : 3 + absa * inverse;
    const MUS_REAL w = q * f->angle_scale;
    int32_t i = (int32_t)w;
    if (i >= f->nangle) i = f->nangle - 1;
    *j = i;
    *j1 = i + 1 == f->nangle ? 0 : i + 1;
    return w - (MUS_REAL)i;
}


/* normal = the unit of (ga, gb, gs) in (side, front, axis); returns 1 / its length */
static inline MUS_REAL MUS_FIELD(turn)(const MUS_FIELD(field) * f, MUS_REAL ga, MUS_REAL gb, MUS_REAL gs,
                                       MUS_REAL *normal)
{
    const MUS_REAL g = 1 / (MUS_REAL)MUS_FIELD(sqrt)(ga * ga + gb * gb + gs * gs + (MUS_REAL)1e-30);
    for (int32_t i = 0; i < 3; i++) normal[i] = g * (ga * f->side[i] + gb * f->front[i] + gs * f->axis[i]);
    return g;
}


/* the query in a cap: s from the first ring on, (a, b) in the contour's plane */
static inline MUS_REAL MUS_FIELD(query_cap)(const MUS_FIELD(field) * f, MUS_REAL s, MUS_REAL a, MUS_REAL b,
                                            MUS_REAL margin, MUS_REAL *normal, int32_t *near)
{
    const int32_t end = s > 0, last = end ? f->nring - 1 : 0;
    const MUS_REAL beyond = end ? s - f->pole[1] : f->pole[0] - s;
    *near = 0;
    if (!(beyond <= margin)) return 0;

    const MUS_REAL *c = f->centre + 2 * last, *r = f->radius + (int64_t)last * f->nangle;
    const MUS_REAL ua = a - c[0], ub = b - c[1], rho2 = ua * ua + ub * ub;
    const MUS_REAL inverse = 1 / ((ua < 0 ? -ua : ua) + (ub < 0 ? -ub : ub) + MUS_FIELD_TINY);
    const MUS_REAL reach = f->largest[last] + margin;
    if (!(rho2 <= reach * reach)) return 0;
    int32_t j, j1;
    const MUS_REAL w = MUS_FIELD(step)(f, ua, ub, inverse, &j, &j1);
    const MUS_REAL radius = r[j] + w * (r[j1] - r[j]), slope_q = (r[j1] - r[j]) * f->angle_scale;

    /* F + 1, and its gradient: rho^2 falls with R, R turns with q */
    const MUS_REAL u = (s - f->middle[end]) * f->axis_inverse[end], k = f->share[end] / (radius * radius);
    const MUS_REAL level = (MUS_REAL)MUS_FIELD(sqrt)(k * rho2 + u * u) + MUS_FIELD_TINY, scale = k / level;
    const MUS_REAL turn = rho2 * slope_q * inverse * inverse / radius;
    const MUS_REAL ga = scale * (ua + turn * ub), gb = scale * (ub - turn * ua);
    const MUS_REAL gs = u * f->axis_inverse[end] / level;
    *near = 1;
    return (1 - level) * MUS_FIELD(turn)(f, ga, gb, gs, normal);
}


/* depth of p (3) in the field, positive inside, with *near 1 and normal (3) the outward normal; or *near 0: p is more
 * than `margin` off the surface */
static inline MUS_REAL MUS_FIELD(query)(const MUS_FIELD(field) * f, const MUS_REAL *p, MUS_REAL margin,
                                        MUS_REAL *normal, int32_t *near)
{
    const MUS_REAL rx = p[0] - f->origin[0], ry = p[1] - f->origin[1], rz = p[2] - f->origin[2];
    const MUS_REAL s = rx * f->axis[0] + ry * f->axis[1] + rz * f->axis[2] - f->s0;
    const MUS_REAL a = rx * f->side[0] + ry * f->side[1] + rz * f->side[2];
    const MUS_REAL b = rx * f->front[0] + ry * f->front[1] + rz * f->front[2];

    /* ring */
    const MUS_REAL u = s * f->ds_inverse;
    if (!(u >= 0 && u < f->ring_last)) return MUS_FIELD(query_cap)(f, s, a, b, margin, normal, near);
    const int32_t k = (int32_t)u;
    const MUS_REAL t = u - (MUS_REAL)k;

    /* place in the contour's plane, about the in-between centre */
    const MUS_REAL *c = f->centre + 2 * k;
    const MUS_REAL dca = c[2] - c[0], dcb = c[3] - c[1];
    const MUS_REAL ua = a - (c[0] + t * dca), ub = b - (c[1] + t * dcb);
    const MUS_REAL rho2 = ua * ua + ub * ub;
    const MUS_REAL reach = f->largest[k] + 4 * margin; /* 4: a steep surface is near though its radius is far */
    *near = 0;
    if (!(rho2 <= reach * reach)) return 0;

    /* the radius and its slopes: its square bilinear, since where a limb ends roundly the square has a slope still */
    int32_t j, j1;
    const MUS_REAL inverse = 1 / ((ua < 0 ? -ua : ua) + (ub < 0 ? -ub : ub) + MUS_FIELD_TINY);
    const MUS_REAL w = MUS_FIELD(step)(f, ua, ub, inverse, &j, &j1);
    const MUS_REAL *r0 = f->radius + (int64_t)k * f->nangle, *r1 = r0 + f->nangle;
    const MUS_REAL s00 = r0[j] * r0[j], s01 = r0[j1] * r0[j1], s10 = r1[j] * r1[j], s11 = r1[j1] * r1[j1];
    const MUS_REAL low = s00 + w * (s01 - s00), high = s10 + w * (s11 - s10);
    const MUS_REAL radius = (MUS_REAL)MUS_FIELD(sqrt)(low + t * (high - low)), half = (MUS_REAL)0.5 / radius;
    const MUS_REAL slope_s = (high - low) * f->ds_inverse * half;
    const MUS_REAL slope_q = ((1 - t) * (s01 - s00) + t * (s11 - s10)) * f->angle_scale * half;

    /* gradient of F in (side, front, axis) */
    const MUS_REAL rho = (MUS_REAL)MUS_FIELD(sqrt)(rho2) + MUS_FIELD_TINY;
    const MUS_REAL turn = slope_q * inverse * inverse, out = 1 / rho;
    const MUS_REAL ga = ua * out + turn * ub, gb = ub * out - turn * ua;
    const MUS_REAL gs = -slope_s - (ga * dca + gb * dcb) * f->ds_inverse;
    *near = 1;
    return (radius - rho) * MUS_FIELD(turn)(f, ga, gb, gs, normal);
}

#undef MUS_FIELD_TINY
