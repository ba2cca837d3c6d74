/*
 * scene_kernel.h: what a contact pass knows of the surfaces, as a template on the floating type (MUS_REAL, MUS_FIELD),
 * taken in by contact.h: boxes of parts, planes, and what each did in the last step.
 */

/* maps of mus__carry */
typedef struct MUS_FIELD(way) {
    MUS_REAL on[12], speed[12];
} MUS_FIELD(way);

typedef struct MUS_FIELD(flat) {
    MUS_REAL normal[3], point[3];
    MUS_REAL start;        /* of heights over it: those of the skin */
    MUS_REAL reach, thick; /* of a disc; without an end huge */
    MUS_REAL friction;
    int32_t moving;
    MUS_FIELD(way) way;
} MUS_FIELD(flat);

typedef struct MUS_FIELD(scene) {
    MUS_REAL box[6 * MUS_LIMBS_MOST]; /* widened by the margin */
    MUS_REAL margin;
    int32_t moving, nplane; /* moving: as the collider's */
    MUS_FIELD(way) way[MUS_LIMBS_MOST];
    MUS_FIELD(flat) flat[MUS_PLANES_MOST];
} MUS_FIELD(scene);


static inline void MUS_FIELD(fill_way)(const mus__carry *carry, MUS_FIELD(way) * way)
{
    for (int32_t k = 0; k < 12; k++) {
        way->on[k] = (MUS_REAL)carry->on[k];
        way->speed[k] = (MUS_REAL)carry->speed[k];
    }
}


static inline void MUS_FIELD(fill_flat)(const mus__collider *collider, const mus__contact_rule *rule, int32_t k,
                                        MUS_FIELD(flat) * flat)
{
    const mus__contact_plane *plane = &collider->plane[k];
    double start = collider->skin;
    for (int32_t d = 0; d < 3; d++) {
        const double point = plane->point[d] - collider->origin[d];
        flat->normal[d] = (MUS_REAL)plane->normal[d];
        flat->point[d] = (MUS_REAL)point;
        start += plane->normal[d] * point;
    }
    flat->start = (MUS_REAL)start;
    flat->reach = plane->reach > 0.0 ? (MUS_REAL)plane->reach : (MUS_REAL)MUS_PLANE_HUGE;
    flat->thick = plane->reach > 0.0 ? (MUS_REAL)(MUS_PLANE_THICK + collider->skin) : (MUS_REAL)MUS_PLANE_HUGE;
    flat->friction = (MUS_REAL)(plane->friction < 0.0 ? rule->friction : (1.0 - rule->slick) * plane->friction);
    flat->moving = plane->moving;
    if (plane->moving) MUS_FIELD(fill_way)(&plane->carry, &flat->way);
}


static inline void MUS_FIELD(fill_scene)(const mus__collider *collider, const mus__contact_rule *rule, MUS_REAL margin,
                                         MUS_FIELD(scene) * scene)
{
    const int32_t ways = collider->moving == MUS_TURNED ? collider->nlimb : collider->moving == MUS_GLIDED;
    scene->margin = margin;
    scene->moving = collider->moving;
    scene->nplane = collider->nplane;
    for (int32_t k = 0; k < 6 * collider->nlimb; k++)
        scene->box[k] = (MUS_REAL)collider->box[k] + (k % 6 < 3 ? -margin : margin);
    for (int32_t l = 0; l < ways; l++) MUS_FIELD(fill_way)(&collider->carry[l], &scene->way[l]);
    for (int32_t k = 0; k < collider->nplane; k++) MUS_FIELD(fill_flat)(collider, rule, k, &scene->flat[k]);
}


static inline MUS_REAL MUS_FIELD(map_row)(const MUS_REAL *map, int32_t d, const MUS_REAL *x)
{
    return map[3 * d] * x[0] + map[3 * d + 1] * x[1] + map[3 * d + 2] * x[2] + map[9 + d];
}


/* where a surface carried the node from, and its velocity where the node is now; `way` NULL: it is at rest */
static inline void MUS_FIELD(carry)(const MUS_FIELD(way) * way, const MUS_REAL *from, const MUS_REAL *x,
                                    MUS_REAL *carried, MUS_REAL *speed)
{
    for (int32_t d = 0; d < 3; d++) {
        carried[d] = way != NULL ? from[d] + MUS_FIELD(map_row)(way->on, d, from) : from[d];
        speed[d] = way != NULL ? MUS_FIELD(map_row)(way->speed, d, x) : 0;
    }
}


/* way of part l; NULL: at rest */
static inline const MUS_FIELD(way) * MUS_FIELD(way_of)(const MUS_FIELD(scene) * scene, int32_t l)
{
    return scene->moving == MUS_STOOD ? NULL : &scene->way[scene->moving == MUS_TURNED ? l : 0];
}


/* how far p is from the axis of a disc */
static inline MUS_REAL MUS_FIELD(flat_across)(const MUS_FIELD(flat) * flat, const MUS_REAL *p)
{
    const MUS_REAL r[3] = {p[0] - flat->point[0], p[1] - flat->point[1], p[2] - flat->point[2]};
    const MUS_REAL rise = MUS_FIELD(dot)(flat->normal, r), across2 = MUS_FIELD(dot)(r, r) - rise * rise;
    return (MUS_REAL)MUS_FIELD(sqrt)(across2 > 0 ? across2 : 0);
}


/* depth below a plane's skin, *near 1; with *near 0, beside a disc and far below it, minus a lower bound of the
 * distance */
static inline MUS_REAL MUS_FIELD(flat_depth)(const MUS_FIELD(flat) * flat, const MUS_REAL *p, MUS_REAL margin,
                                             int32_t *near)
{
    const MUS_REAL up = MUS_FIELD(dot)(flat->normal, p) - flat->start, under = -up - flat->thick;
    *near = up <= margin;
    if (!*near || flat->reach >= (MUS_REAL)MUS_PLANE_HUGE) return -up;
    const MUS_REAL beside = MUS_FIELD(flat_across)(flat, p) - flat->reach;
    *near = under <= 0 && beside <= 0;
    if (*near) return -up;
    return -(beside > under ? beside > up ? beside : up : under > up ? under : up);
}
