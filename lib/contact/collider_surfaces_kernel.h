/*
 * collider_surfaces_kernel.h: the surfaces of a collider in the precision of a contact pass, a template taken in by
 * contact_template.h: boxes of the parts, planes, and the motion of each in the last step. Filled once a pass.
 */

/* mus__surface_motion */
typedef struct MUS__NAME(motion) {
    MUS__REAL displacement[12], velocity[12];
} MUS__NAME(motion);

typedef struct MUS__NAME(plane) {
    MUS__REAL normal[3], point[3];
    MUS__REAL start;        /* n . x of the offset surface, from which heights are counted [m] */
    MUS__REAL reach, thick; /* of a disc; MUS__PLANE_ENDLESS without an edge [m] */
    MUS__REAL friction;
    int32_t moving;
    MUS__NAME(motion) motion;
} MUS__NAME(plane);

typedef struct MUS__NAME(surfaces) {
    MUS__REAL box[6 * MUS__PARTS_MAX]; /* of the parts, widened by the margin */
    MUS__REAL margin;
    int32_t moving, nplane; /* moving: the collider's */
    MUS__NAME(motion) motion[MUS__PARTS_MAX];
    MUS__NAME(plane) plane[MUS__PLANES_MAX];
} MUS__NAME(surfaces);


static inline void MUS__NAME(fill_motion)(const mus__surface_motion *from, MUS__NAME(motion) * to)
{
    for (int32_t k = 0; k < 12; k++) {
        to->displacement[k] = (MUS__REAL)from->displacement[k];
        to->velocity[k] = (MUS__REAL)from->velocity[k];
    }
}


static inline void MUS__NAME(fill_plane)(const mus__collider *collider, const mus__contact_rule *rule, int32_t k,
                                         MUS__NAME(plane) * to)
{
    const mus__collider_plane *from = &collider->plane[k];
    double start = collider->offset;
    for (int32_t d = 0; d < 3; d++) {
        const double point = from->point[d] - collider->origin[d];
        to->normal[d] = (MUS__REAL)from->normal[d];
        to->point[d] = (MUS__REAL)point;
        start += from->normal[d] * point;
    }
    to->start = (MUS__REAL)start;
    to->reach = from->reach > 0.0 ? (MUS__REAL)from->reach : (MUS__REAL)MUS__PLANE_ENDLESS;
    to->thick = from->reach > 0.0 ? (MUS__REAL)(MUS__DISC_THICKNESS + collider->offset) : (MUS__REAL)MUS__PLANE_ENDLESS;
    to->friction = (MUS__REAL)(from->friction < 0.0 ? rule->friction : (1.0 - rule->slick) * from->friction);
    to->moving = from->moving;
    if (from->moving) MUS__NAME(fill_motion)(&from->motion, &to->motion);
}


/* fills *to; boxes get `margin` [m], the distance within which nodes are queried */
static inline void MUS__NAME(fill_surfaces)(const mus__collider *collider, const mus__contact_rule *rule,
                                            MUS__REAL margin, MUS__NAME(surfaces) * to)
{
    const int32_t moved = collider->moving == MUS__TURNED ? collider->nparts : collider->moving == MUS__TRANSLATED;
    to->margin = margin;
    to->moving = collider->moving;
    to->nplane = collider->nplane;
    for (int32_t k = 0; k < 6 * collider->nparts; k++)
        to->box[k] = (MUS__REAL)collider->box[k] + (k % 6 < 3 ? -margin : margin);
    for (int32_t l = 0; l < moved; l++) MUS__NAME(fill_motion)(&collider->motion[l], &to->motion[l]);
    for (int32_t k = 0; k < collider->nplane; k++) MUS__NAME(fill_plane)(collider, rule, k, &to->plane[k]);
}


/* row d of an affine map at x */
static inline MUS__REAL MUS__NAME(map_row)(const MUS__REAL *map, int32_t d, const MUS__REAL *x)
{
    return map[3 * d] * x[0] + map[3 * d + 1] * x[1] + map[3 * d + 2] * x[2] + map[9 + d];
}


/* carried: where the surface took the node that was at `from` before the step; velocity: of the surface at x, where the
 * node is now. motion NULL: the surface is at rest */
static inline void MUS__NAME(carry_node)(const MUS__NAME(motion) * motion, const MUS__REAL *from, const MUS__REAL *x,
                                         MUS__REAL *carried, MUS__REAL *velocity)
{
    for (int32_t d = 0; d < 3; d++) {
        carried[d] = motion != NULL ? from[d] + MUS__NAME(map_row)(motion->displacement, d, from) : from[d];
        velocity[d] = motion != NULL ? MUS__NAME(map_row)(motion->velocity, d, x) : 0;
    }
}


/* motion of part l; NULL: at rest */
static inline const MUS__NAME(motion) * MUS__NAME(motion_of)(const MUS__NAME(surfaces) * surfaces, int32_t l)
{
    if (surfaces->moving == MUS__AT_REST) return NULL;
    return &surfaces->motion[surfaces->moving == MUS__TURNED ? l : 0];
}


/* distance of p from the axis of a disc */
static inline MUS__REAL MUS__NAME(plane_across)(const MUS__NAME(plane) * plane, const MUS__REAL *p)
{
    const MUS__REAL r[3] = {p[0] - plane->point[0], p[1] - plane->point[1], p[2] - plane->point[2]};
    const MUS__REAL rise = MUS__NAME(dot)(plane->normal, r), across2 = MUS__NAME(dot)(r, r) - rise * rise;
    return (MUS__REAL)MUS__NAME(sqrt)(across2 > 0 ? across2 : 0);
}


/* depth of p below a plane's offset surface, with *near 1; with *near 0 (beside a disc, far below it, or beyond the
 * margin) minus a lower bound of the distance */
static inline MUS__REAL MUS__NAME(plane_depth)(const MUS__NAME(plane) * plane, const MUS__REAL *p, MUS__REAL margin,
                                               int32_t *near)
{
    const MUS__REAL up = MUS__NAME(dot)(plane->normal, p) - plane->start, under = -up - plane->thick;
    *near = up <= margin;
    if (!*near || plane->reach >= (MUS__REAL)MUS__PLANE_ENDLESS) return -up;
    const MUS__REAL beside = MUS__NAME(plane_across)(plane, p) - plane->reach;
    *near = under <= 0 && beside <= 0;
    if (*near) return -up;
    return -(beside > under ? beside > up ? beside : up : under > up ? under : up);
}
