/*
 * sweep_kernel.h: fast nodes, a part of contact_kernel.h.
 *
 * A node that travels farther in a step than a part of the thinnest limb is swept: its straight path from where it was
 * is walked in pieces that are shorter the nearer the skin is, the first place nearer than the clearance is found by
 * halving, the response is taken there, and the rest of the step goes on with what velocity is left. Parts that move
 * each in their own way are swept one by one, each from where it has carried the node; a plane's hit is a division.
 */

#define MUS__SWEEP_PIECES_MAX 4096 /* most pieces of one path */
#define MUS__SWEEP_SHORTEST 1e-3   /* of them, in parts of the safe length: what is cut off a flank is then nanometres \
                                    */
#define MUS__SWEEP_HALVINGS 50
#define MUS__SWEEP_BOX_BAND 1e-5 /* [m]: this near to a box is in it */


/* ---- fast nodes ---- */

/* a group of parts that moved as one, and a node's path relative to it */
typedef struct MUS__NAME(swept_path) {
    const mus__collider *collider;
    const mus__contact_rule *rule;
    const MUS__NAME(surfaces) * surfaces;
    uint64_t parts;
    MUS__REAL clearance, safe;
    int64_t *queries;
} MUS__NAME(swept_path);


/* how far p is nearer than the clearance, over the parts, and the normal (3) of the nearest; far below 0 and no normal
 * when none is within the safe length */
static MUS__REAL MUS__NAME(overlap_at)(const MUS__NAME(swept_path) * chase, const MUS__REAL *p, MUS__REAL *out)
{
    MUS__REAL overlap = -1;
    uint64_t parts = chase->parts;
    for (int32_t l = 0; parts != 0; l++, parts >>= 1) {
        if ((parts & 1) == 0 || !MUS__NAME(in_box)(chase->surfaces->box + 6 * l, p)) continue;
        MUS__REAL normal[3];
        int32_t near;
        const MUS__REAL depth =
            MUS__NAME(field_query)(&chase->collider->MUS__PART_FIELDS[l], p, chase->safe, normal, &near);
        (*chase->queries)++;
        if (!near || depth + chase->clearance <= overlap) continue;
        overlap = depth + chase->clearance;
        for (int32_t i = 0; i < 3; i++) out[i] = normal[i];
    }
    return overlap;
}


/* time until p + t w is in a box: 0 when it is in one, `left` when it comes to none before */
static MUS__REAL MUS__NAME(time_to_box)(const MUS__NAME(swept_path) * chase, const MUS__REAL *p, const MUS__REAL *w,
                                        MUS__REAL speed, MUS__REAL left)
{
    MUS__REAL first = left;
    uint64_t parts = chase->parts;
    for (int32_t l = 0; parts != 0; l++, parts >>= 1) {
        const MUS__REAL *box = chase->surfaces->box + 6 * l;
        MUS__REAL in = 0, out = left;
        if ((parts & 1) == 0) continue;
        for (int32_t i = 0; i < 3; i++) {
            if (w[i] == 0) {
                if (p[i] < box[i] || p[i] > box[i + 3]) out = -1;
                continue;
            }
            const MUS__REAL t0 = (box[i] - p[i]) / w[i], t1 = (box[i + 3] - p[i]) / w[i];
            const MUS__REAL low = t0 < t1 ? t0 : t1, high = t0 < t1 ? t1 : t0;
            if (low > in) in = low;
            if (high < out) out = high;
        }
        if (in <= out && in < first) first = in;
    }
    return first * speed <= (MUS__REAL)MUS__SWEEP_BOX_BAND && first < left ? 0 : first;
}


/* the first time in 0..piece at which p + t w is nearer than the clearance, where it is at `piece` and not at 0 */
static MUS__REAL MUS__NAME(impact_time)(const MUS__NAME(swept_path) * chase, const MUS__REAL *p, const MUS__REAL *w,
                                        MUS__REAL piece)
{
    MUS__REAL low = 0, high = piece, normal[3];
    for (int32_t k = 0; k < MUS__SWEEP_HALVINGS; k++) {
        const MUS__REAL t = low + (high - low) / 2;
        const MUS__REAL q[3] = {p[0] + t * w[0], p[1] + t * w[1], p[2] + t * w[2]};
        if (MUS__NAME(overlap_at)(chase, q, normal) > 0)
            high = t;
        else
            low = t;
    }
    return low;
}


/* the length of path to walk from a place `distance` off the clearance: half of what is surely free, as distances are
 * of first order; on the skin, where the pieces after take back what goes in, what no limb fits through */
static inline MUS__REAL MUS__NAME(piece_length)(MUS__REAL distance, MUS__REAL safe)
{
    const MUS__REAL free = distance / 2, shortest = (MUS__REAL)MUS__SWEEP_SHORTEST * safe;
    return distance <= (MUS__REAL)MUS__TOUCH_BAND || free > safe ? safe : free > shortest ? free : shortest;
}


/* touch() at the end of a piece: nonzero when place or velocity changed; a changed velocity is the way from here on */
static int32_t MUS__NAME(respond_piece)(const MUS__NAME(swept_path) * chase, const MUS__NAME(path) * path, MUS__REAL *p,
                                        MUS__REAL *w, MUS__REAL *way)
{
    const MUS__REAL x[3] = {p[0], p[1], p[2]}, v[3] = {w[0], w[1], w[2]};
    const uint64_t in = chase->parts & MUS__NAME(boxes_around)(chase->collider->nparts, chase->surfaces->box, p);
    MUS__NAME(gaps) gaps = {0, 0, 0};
    MUS__NAME(respond_node)
    (chase->collider, chase->rule, chase->surfaces, in, 0, 0, 1, NULL, 0, path, &gaps, p, w, chase->queries);
    if (v[0] != w[0] || v[1] != w[1] || v[2] != w[2]) {
        for (int32_t i = 0; i < 3; i++) way[i] = w[i];
        return 1;
    }
    return x[0] != p[0] || x[1] != p[1] || x[2] != p[2];
}


/* a node that came from p to q in a step, now with velocity w, all relative to the parts: q and w (3) as contact leaves
 * them. Nonzero when it touched; else both are as they were */
static int32_t MUS__NAME(sweep)(const MUS__NAME(swept_path) * chase, MUS__REAL *p, MUS__REAL *q, MUS__REAL *w)
{
    const MUS__REAL band = (MUS__REAL)MUS__TOUCH_BAND, safe = chase->safe;
    MUS__REAL left = (MUS__REAL)chase->rule->step;
    MUS__REAL way[3] = {(q[0] - p[0]) / left, (q[1] - p[1]) / left, (q[2] - p[2]) / left};
    int32_t touched = 0;
    for (int32_t k = 0; k < MUS__SWEEP_PIECES_MAX && left > 0; k++) {
        MUS__REAL speed = (MUS__REAL)MUS__NAME(sqrt)(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
        MUS__REAL time = MUS__NAME(time_to_box)(chase, p, way, speed, left), slip = 0, from[3];
        int32_t hit = 0;
        if (time == 0) {
            MUS__REAL normal[3];
            const MUS__REAL off = -MUS__NAME(overlap_at)(chase, p, normal);
            if (off <= band) {
                /* on the skin, or as good as: what goes in is taken off before the piece */
                const MUS__REAL in = -(way[0] * normal[0] + way[1] * normal[1] + way[2] * normal[2]);
                const MUS__REAL rest = in > 0 && off > 0 && off < left * in ? off / in : 0;
                for (int32_t i = 0; i < 3; i++) p[i] += rest * way[i];
                left -= rest;
                const MUS__NAME(path) none = {p, 0, 0};
                touched |= MUS__NAME(respond_piece)(chase, &none, p, w, way);
                speed = (MUS__REAL)MUS__NAME(sqrt)(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
            }
            const MUS__REAL length = MUS__NAME(piece_length)(off, safe);
            time = speed * left > length ? length / speed : left;
            const MUS__REAL r[3] = {p[0] + time * way[0], p[1] + time * way[1], p[2] + time * way[2]};
            hit = off <= band || MUS__NAME(overlap_at)(chase, r, normal) > 0;
            if (off <= band)
                slip = time;
            else if (hit)
                time = MUS__NAME(impact_time)(chase, p, way, time);
        }
        for (int32_t i = 0; i < 3; i++) from[i] = p[i], p[i] += time * way[i];
        left -= time;
        const MUS__NAME(path) piece = {from, time, slip};
        if (hit) touched |= MUS__NAME(respond_piece)(chase, &piece, p, w, way);
    }
    /* a path of too many pieces ends where it got to */
    if (left > 0) touched = 1;
    for (int32_t i = 0; touched && i < 3; i++) q[i] = p[i];
    return touched;
}


/* a node that went from one side of a plane to the other in the step: nonzero when it hit it, and then x and v (3) as
 * contact leaves them */
static int32_t MUS__NAME(sweep_plane)(const mus__contact_rule *rule, const MUS__NAME(surfaces) * surfaces, int32_t k,
                                      MUS__REAL clearance, const MUS__REAL *from, MUS__REAL *x, MUS__REAL *v)
{
    const MUS__NAME(plane) *plane = &surfaces->plane[k];
    MUS__REAL p[3], speed[3], hit[3];
    MUS__NAME(carry_node)(plane->moving ? &plane->motion : NULL, from, x, p, speed);
    const MUS__REAL start = plane->start + clearance;
    const MUS__REAL before = MUS__NAME(dot)(plane->normal, p) - start, after = MUS__NAME(dot)(plane->normal, x) - start;
    if (!(before > (MUS__REAL)MUS__TOUCH_BAND && after < 0)) return 0;
    const MUS__REAL part = before / (before - after);
    for (int32_t d = 0; d < 3; d++) hit[d] = p[d] + part * (x[d] - p[d]);
    if (plane->reach < (MUS__REAL)MUS__PLANE_ENDLESS && MUS__NAME(plane_across)(plane, hit) > plane->reach) return 0;

    /* the response where it hit, and on along the plane with what is left of its velocity */
    const MUS__REAL time = (MUS__REAL)rule->step * part, left = (MUS__REAL)rule->step - time;
    const MUS__NAME(path) path = {p, time, 0};
    for (int32_t d = 0; d < 3; d++) v[d] -= speed[d];
    MUS__NAME(respond_one)(0, plane->friction, rule, &path, plane->normal, hit, v);
    for (int32_t d = 0; d < 3; d++) x[d] = hit[d] + left * v[d], v[d] += speed[d];
    return 1;
}


/* a node from `from` to x with velocity v, swept against what it came to fast; that is taken out of the parts `in` and
 * the planes `on`. Nonzero when it touched */
static int32_t MUS__NAME(sweep_all)(const mus__collider *collider, const mus__contact_rule *rule,
                                    const MUS__NAME(surfaces) * surfaces, uint64_t *in, uint32_t *on,
                                    const MUS__REAL *from, MUS__REAL *x, MUS__REAL *v, int64_t *queries)
{
    const MUS__REAL clearance = (MUS__REAL)(rule->clearance - collider->offset);
    const int32_t n = collider->nparts, groups = n > 0 && surfaces->moving != MUS__TURNED ? 1 : n;
    const uint64_t every = n < 64 ? ((uint64_t)1 << n) - 1 : ~(uint64_t)0;
    int32_t touched = 0;
    for (int32_t g = 0; g < groups; g++) {
        const MUS__REAL safe = (MUS__REAL)(groups == 1 ? collider->safe : collider->part[g].safe);
        MUS__REAL p[3], speed[3], w[3], way2 = 0;
        MUS__NAME(carry_node)(MUS__NAME(motion_of)(surfaces, g), from, x, p, speed);
        for (int32_t d = 0; d < 3; d++) way2 += (x[d] - p[d]) * (x[d] - p[d]), w[d] = v[d] - speed[d];
        if (!(way2 > safe * safe)) continue;
        const MUS__NAME(swept_path)
            chase = {collider, rule, surfaces, groups == 1 ? every : (uint64_t)1 << g, clearance, safe, queries};
        *in &= ~chase.parts;
        if (!MUS__NAME(sweep)(&chase, p, x, w)) continue;
        touched = 1;
        for (int32_t d = 0; d < 3; d++) v[d] = w[d] + speed[d];
    }
    for (int32_t k = 0; k < surfaces->nplane; k++) {
        const MUS__REAL safe = (MUS__REAL)collider->safe;
        MUS__REAL p[3], speed[3], way2 = 0;
        MUS__NAME(carry_node)(surfaces->plane[k].moving ? &surfaces->plane[k].motion : NULL, from, x, p, speed);
        for (int32_t d = 0; d < 3; d++) way2 += (x[d] - p[d]) * (x[d] - p[d]);
        if (!(way2 > safe * safe) || !MUS__NAME(sweep_plane)(rule, surfaces, k, clearance, from, x, v)) continue;
        touched = 1;
        *on &= ~((uint32_t)1 << k);
    }
    return touched;
}
