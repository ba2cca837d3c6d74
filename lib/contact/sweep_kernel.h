/*
 * sweep_kernel.h: fast nodes, a part of contact_kernel.h.
 *
 * A node that travels farther in a step than a part of the thinnest limb is swept: its straight path from where it was
 * is walked in pieces that are shorter the nearer the skin is, the first place nearer than the clearance is found by
 * halving, the response is taken there, and the rest of the step goes on with what velocity is left. Parts that move
 * each in their own way are swept one by one, each from where it has carried the node; a plane's hit is a division.
 */

#define SWEEP_PIECES 4096   /* most pieces of one path */
#define SWEEP_SHORTEST 1e-3 /* of them, in parts of the safe length: what is cut off a flank is then nanometres */
#define SWEEP_HALVINGS 50
#define SWEEP_DOOR 1e-5 /* [m]: this near to a box is in it */


/* ---- fast nodes ---- */

/* a group of parts that moved as one, and a node's path relative to it */
typedef struct MUS_FIELD(chase) {
    const mus__collider *collider;
    const mus__contact_rule *rule;
    const MUS_FIELD(scene) * scene;
    uint64_t parts;
    MUS_REAL clearance, safe;
    int64_t *queries;
} MUS_FIELD(chase);


/* how far p is nearer than the clearance, over the parts, and the normal (3) of the nearest; far below 0 and no normal
 * when none is within the safe length */
static MUS_REAL MUS_FIELD(lift_at)(const MUS_FIELD(chase) * chase, const MUS_REAL *p, MUS_REAL *out)
{
    MUS_REAL lift = -1;
    uint64_t parts = chase->parts;
    for (int32_t l = 0; parts != 0; l++, parts >>= 1) {
        if ((parts & 1) == 0 || !MUS_FIELD(boxed)(chase->scene->box + 6 * l, p)) continue;
        MUS_REAL normal[3];
        int32_t near;
        const MUS_REAL depth = MUS_FIELD(query)(&chase->collider->MUS_FIELDS[l], p, chase->safe, normal, &near);
        (*chase->queries)++;
        if (!near || depth + chase->clearance <= lift) continue;
        lift = depth + chase->clearance;
        for (int32_t i = 0; i < 3; i++) out[i] = normal[i];
    }
    return lift;
}


/* time until p + t w is in a box: 0 when it is in one, `left` when it comes to none before */
static MUS_REAL MUS_FIELD(wait)(const MUS_FIELD(chase) * chase, const MUS_REAL *p, const MUS_REAL *w, MUS_REAL speed,
                                MUS_REAL left)
{
    MUS_REAL first = left;
    uint64_t parts = chase->parts;
    for (int32_t l = 0; parts != 0; l++, parts >>= 1) {
        const MUS_REAL *box = chase->scene->box + 6 * l;
        MUS_REAL in = 0, out = left;
        if ((parts & 1) == 0) continue;
        for (int32_t i = 0; i < 3; i++) {
            if (w[i] == 0) {
                if (p[i] < box[i] || p[i] > box[i + 3]) out = -1;
                continue;
            }
            const MUS_REAL t0 = (box[i] - p[i]) / w[i], t1 = (box[i + 3] - p[i]) / w[i];
            const MUS_REAL low = t0 < t1 ? t0 : t1, high = t0 < t1 ? t1 : t0;
            if (low > in) in = low;
            if (high < out) out = high;
        }
        if (in <= out && in < first) first = in;
    }
    return first * speed <= (MUS_REAL)SWEEP_DOOR && first < left ? 0 : first;
}


/* the first time in 0..piece at which p + t w is nearer than the clearance, where it is at `piece` and not at 0 */
static MUS_REAL MUS_FIELD(hit_time)(const MUS_FIELD(chase) * chase, const MUS_REAL *p, const MUS_REAL *w,
                                    MUS_REAL piece)
{
    MUS_REAL low = 0, high = piece, normal[3];
    for (int32_t k = 0; k < SWEEP_HALVINGS; k++) {
        const MUS_REAL t = low + (high - low) / 2;
        const MUS_REAL q[3] = {p[0] + t * w[0], p[1] + t * w[1], p[2] + t * w[2]};
        if (MUS_FIELD(lift_at)(chase, q, normal) > 0)
            high = t;
        else
            low = t;
    }
    return low;
}


/* the length of path to walk from a place `distance` off the clearance: half of what is surely free, as distances are
 * of first order; on the skin, where the pieces after take back what goes in, what no limb fits through */
static inline MUS_REAL MUS_FIELD(piece)(MUS_REAL distance, MUS_REAL safe)
{
    const MUS_REAL free = distance / 2, shortest = (MUS_REAL)SWEEP_SHORTEST * safe;
    return distance <= (MUS_REAL)TOUCH_BAND || free > safe ? safe : free > shortest ? free : shortest;
}


/* touch() at the end of a piece: nonzero when place or velocity changed; a changed velocity is the way from here on */
static int32_t MUS_FIELD(meet)(const MUS_FIELD(chase) * chase, const MUS_FIELD(path) * path, MUS_REAL *p, MUS_REAL *w,
                               MUS_REAL *way)
{
    const MUS_REAL x[3] = {p[0], p[1], p[2]}, v[3] = {w[0], w[1], w[2]};
    const uint64_t in = chase->parts & MUS_FIELD(boxes_of)(chase->collider->nlimb, chase->scene->box, p);
    MUS_FIELD(gaps) gaps = {0, 0, 0};
    MUS_FIELD(touch)
    (chase->collider, chase->rule, chase->scene, in, 0, 0, 1, NULL, 0, path, &gaps, p, w, chase->queries);
    if (v[0] != w[0] || v[1] != w[1] || v[2] != w[2]) {
        for (int32_t i = 0; i < 3; i++) way[i] = w[i];
        return 1;
    }
    return x[0] != p[0] || x[1] != p[1] || x[2] != p[2];
}


/* a node that came from p to q in a step, now with velocity w, all relative to the parts: q and w (3) as contact leaves
 * them. Nonzero when it touched; else both are as they were */
static int32_t MUS_FIELD(sweep)(const MUS_FIELD(chase) * chase, MUS_REAL *p, MUS_REAL *q, MUS_REAL *w)
{
    const MUS_REAL band = (MUS_REAL)TOUCH_BAND, safe = chase->safe;
    MUS_REAL left = (MUS_REAL)chase->rule->step;
    MUS_REAL way[3] = {(q[0] - p[0]) / left, (q[1] - p[1]) / left, (q[2] - p[2]) / left};
    int32_t touched = 0;
    for (int32_t k = 0; k < SWEEP_PIECES && left > 0; k++) {
        MUS_REAL speed = (MUS_REAL)MUS_FIELD(sqrt)(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
        MUS_REAL time = MUS_FIELD(wait)(chase, p, way, speed, left), slip = 0, from[3];
        int32_t hit = 0;
        if (time == 0) {
            MUS_REAL normal[3];
            const MUS_REAL off = -MUS_FIELD(lift_at)(chase, p, normal);
            if (off <= band) {
                /* on the skin, or as good as: what goes in is taken off before the piece */
                const MUS_REAL in = -(way[0] * normal[0] + way[1] * normal[1] + way[2] * normal[2]);
                const MUS_REAL rest = in > 0 && off > 0 && off < left * in ? off / in : 0;
                for (int32_t i = 0; i < 3; i++) p[i] += rest * way[i];
                left -= rest;
                const MUS_FIELD(path) none = {p, 0, 0};
                touched |= MUS_FIELD(meet)(chase, &none, p, w, way);
                speed = (MUS_REAL)MUS_FIELD(sqrt)(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
            }
            const MUS_REAL length = MUS_FIELD(piece)(off, safe);
            time = speed * left > length ? length / speed : left;
            const MUS_REAL r[3] = {p[0] + time * way[0], p[1] + time * way[1], p[2] + time * way[2]};
            hit = off <= band || MUS_FIELD(lift_at)(chase, r, normal) > 0;
            if (off <= band)
                slip = time;
            else if (hit)
                time = MUS_FIELD(hit_time)(chase, p, way, time);
        }
        for (int32_t i = 0; i < 3; i++) from[i] = p[i], p[i] += time * way[i];
        left -= time;
        const MUS_FIELD(path) piece = {from, time, slip};
        if (hit) touched |= MUS_FIELD(meet)(chase, &piece, p, w, way);
    }
    /* a path of too many pieces ends where it got to */
    if (left > 0) touched = 1;
    for (int32_t i = 0; touched && i < 3; i++) q[i] = p[i];
    return touched;
}


/* a node that went from one side of a plane to the other in the step: nonzero when it hit it, and then x and v (3) as
 * contact leaves them */
static int32_t MUS_FIELD(land)(const mus__contact_rule *rule, const MUS_FIELD(scene) * scene, int32_t k,
                               MUS_REAL clearance, const MUS_REAL *from, MUS_REAL *x, MUS_REAL *v)
{
    const MUS_FIELD(flat) *flat = &scene->flat[k];
    MUS_REAL p[3], speed[3], hit[3];
    MUS_FIELD(carry)(flat->moving ? &flat->way : NULL, from, x, p, speed);
    const MUS_REAL start = flat->start + clearance;
    const MUS_REAL before = MUS_FIELD(dot)(flat->normal, p) - start, after = MUS_FIELD(dot)(flat->normal, x) - start;
    if (!(before > (MUS_REAL)TOUCH_BAND && after < 0)) return 0;
    const MUS_REAL part = before / (before - after);
    for (int32_t d = 0; d < 3; d++) hit[d] = p[d] + part * (x[d] - p[d]);
    if (flat->reach < (MUS_REAL)MUS_PLANE_HUGE && MUS_FIELD(flat_across)(flat, hit) > flat->reach) return 0;

    /* the response where it hit, and on along the plane with what is left of its velocity */
    const MUS_REAL time = (MUS_REAL)rule->step * part, left = (MUS_REAL)rule->step - time;
    const MUS_FIELD(path) path = {p, time, 0};
    for (int32_t d = 0; d < 3; d++) v[d] -= speed[d];
    MUS_FIELD(respond)(0, flat->friction, rule, &path, flat->normal, hit, v);
    for (int32_t d = 0; d < 3; d++) x[d] = hit[d] + left * v[d], v[d] += speed[d];
    return 1;
}


/* a node from `from` to x with velocity v, swept against what it came to fast; that is taken out of the parts `in` and
 * the planes `on`. Nonzero when it touched */
static int32_t MUS_FIELD(sweep_all)(const mus__collider *collider, const mus__contact_rule *rule,
                                    const MUS_FIELD(scene) * scene, uint64_t *in, uint32_t *on, const MUS_REAL *from,
                                    MUS_REAL *x, MUS_REAL *v, int64_t *queries)
{
    const MUS_REAL clearance = (MUS_REAL)(rule->clearance - collider->skin);
    const int32_t n = collider->nlimb, groups = n > 0 && scene->moving != MUS_TURNED ? 1 : n;
    const uint64_t every = n < 64 ? ((uint64_t)1 << n) - 1 : ~(uint64_t)0;
    int32_t touched = 0;
    for (int32_t g = 0; g < groups; g++) {
        const MUS_REAL safe = (MUS_REAL)(groups == 1 ? collider->safe : collider->home[g].safe);
        MUS_REAL p[3], speed[3], w[3], way2 = 0;
        MUS_FIELD(carry)(MUS_FIELD(way_of)(scene, g), from, x, p, speed);
        for (int32_t d = 0; d < 3; d++) way2 += (x[d] - p[d]) * (x[d] - p[d]), w[d] = v[d] - speed[d];
        if (!(way2 > safe * safe)) continue;
        const MUS_FIELD(chase)
            chase = {collider, rule, scene, groups == 1 ? every : (uint64_t)1 << g, clearance, safe, queries};
        *in &= ~chase.parts;
        if (!MUS_FIELD(sweep)(&chase, p, x, w)) continue;
        touched = 1;
        for (int32_t d = 0; d < 3; d++) v[d] = w[d] + speed[d];
    }
    for (int32_t k = 0; k < scene->nplane; k++) {
        const MUS_REAL safe = (MUS_REAL)collider->safe;
        MUS_REAL p[3], speed[3], way2 = 0;
        MUS_FIELD(carry)(scene->flat[k].moving ? &scene->flat[k].way : NULL, from, x, p, speed);
        for (int32_t d = 0; d < 3; d++) way2 += (x[d] - p[d]) * (x[d] - p[d]);
        if (!(way2 > safe * safe) || !MUS_FIELD(land)(rule, scene, k, clearance, from, x, v)) continue;
        touched = 1;
        *on &= ~((uint32_t)1 << k);
    }
    return touched;
}
