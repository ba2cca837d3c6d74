/*
 * field_kernel.h: one query of a radius field (field.h), as a template on the floating type.
 *
 * Define MUS_REAL (float or double) and MUS_FIELD(name), which makes names of that type, then include. The body asks
 * in double, contact in the type of its state; both read this one text. Only + - * / and sqrt.
 *
 *   F(s, a, b) = rho - R(s, q),   rho = |(a,b) - c(s)|,   q the diamond angle of (a,b) - c(s)
 *   dq = (ua db - ub da) / (|ua|+|ub|)^2              in every quadrant
 *   depth = -F / |grad F|,   normal = grad F / |grad F|
 */

typedef struct MUS_FIELD(field) {
    MUS_REAL origin[3], axis[3], side[3], front[3];
    MUS_REAL s0, ds_inverse, ring_last; /* ring_last = nring - 1 */
    MUS_REAL angle_scale;               /* nangle / 4 */
    int32_t nring, nangle;
    const MUS_REAL *centre;  /* (nring x 2) */
    const MUS_REAL *radius;  /* (nring x nangle) */
    const MUS_REAL *largest; /* (nring) largest radius of ring k and k + 1 */
} MUS_FIELD(field);


/* depth of p (3) in the field, positive inside, with *near 1 and normal (3) the outward normal; or *near 0: p is more
 * than `margin` off the surface; or *near -1: p is beyond an end of the limb, how far is not known */
static inline MUS_REAL MUS_FIELD(query)(const MUS_FIELD(field) *f, const MUS_REAL *p, MUS_REAL margin,
                                        MUS_REAL *normal, int32_t *near)
{
    const MUS_REAL rx = p[0] - f->origin[0], ry = p[1] - f->origin[1], rz = p[2] - f->origin[2];
    *near = -1;

    /* ring */
    MUS_REAL u = (rx * f->axis[0] + ry * f->axis[1] + rz * f->axis[2] - f->s0) * f->ds_inverse;
    if (!(u >= 0 && u < f->ring_last)) return 0;
    const int32_t k = (int32_t)u;
    const MUS_REAL t = u - (MUS_REAL)k;

    /* place in the contour's plane, about the in-between centre */
    const MUS_REAL a = rx * f->side[0] + ry * f->side[1] + rz * f->side[2];
    const MUS_REAL b = rx * f->front[0] + ry * f->front[1] + rz * f->front[2];
    const MUS_REAL *c = f->centre + 2 * k;
    const MUS_REAL dca = c[2] - c[0], dcb = c[3] - c[1];
    const MUS_REAL ua = a - (c[0] + t * dca), ub = b - (c[1] + t * dcb);
    const MUS_REAL rho2 = ua * ua + ub * ub;
    const MUS_REAL reach = f->largest[k] + 4 * margin; /* 4: a steep surface is near though its radius is far */
    *near = 0;
    if (rho2 > reach * reach) return 0;

    /* diamond angle */
    const MUS_REAL absa = ua < 0 ? -ua : ua, absb = ub < 0 ? -ub : ub;
    const MUS_REAL sum = absa + absb + (MUS_REAL)1e-9;
    MUS_REAL q;
    if (ub >= 0) q = ua >= 0 ? absb / sum : 1 + absa / sum;
    else q = ua < 0 ? 2 + absb / sum : 3 + absa / sum;
    MUS_REAL w = q * f->angle_scale;
    int32_t j = (int32_t)w;
    if (j >= f->nangle) j = f->nangle - 1;
    w -= (MUS_REAL)j;
    const int32_t j1 = j + 1 == f->nangle ? 0 : j + 1;

    /* radius and its slopes, bilinear */
    const MUS_REAL *r0 = f->radius + (int64_t)k * f->nangle, *r1 = r0 + f->nangle;
    const MUS_REAL low = r0[j] + w * (r0[j1] - r0[j]), high = r1[j] + w * (r1[j1] - r1[j]);
    const MUS_REAL radius = low + t * (high - low);
    const MUS_REAL slope_s = (high - low) * f->ds_inverse;
    const MUS_REAL slope_q = ((1 - t) * (r0[j1] - r0[j]) + t * (r1[j1] - r1[j])) * f->angle_scale;

    /* gradient of F in (side, front, axis) */
    const MUS_REAL rho = (MUS_REAL)MUS_FIELD(sqrt)(rho2) + (MUS_REAL)1e-9;
    const MUS_REAL turn = slope_q / (sum * sum);
    const MUS_REAL ga = ua / rho + turn * ub, gb = ub / rho - turn * ua;
    const MUS_REAL gs = -slope_s - (ga * dca + gb * dcb) * f->ds_inverse;
    const MUS_REAL g = 1 / (MUS_REAL)MUS_FIELD(sqrt)(ga * ga + gb * gb + gs * gs + (MUS_REAL)1e-30);
    for (int32_t i = 0; i < 3; i++) normal[i] = g * (ga * f->side[i] + gb * f->front[i] + gs * f->axis[i]);
    *near = 1;
    return (radius - rho) * g;
}
