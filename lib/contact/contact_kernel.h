/*
 * contact_kernel.h: the contact pass, as a template on the floating type (MUS_REAL, MUS_FIELD, MUS_CONTACT, MUS_RUSH).
 *
 * The fields stand `skin` off the body already (contact.c), so depths are taken from there and are small where a node
 * rests: a depth of first order jumps a little from ring to ring, but not at zero.
 *
 * A node nearer than the clearance is put back along the outward normal, loses its velocity into the skin, and its
 * sliding velocity shrinks by the friction impulse mu |v_n|. The step that led here moved the node along the skin with
 * the velocity it had before the impulse; friction takes back `slip` mu |v_n| of that way too, and no more than all of
 * it, so that what sticks does not creep, and in float not even by rounding. All is relative to the body: places to its
 * shift, velocities to its drift.
 *
 * Nodes are first held against the boxes of the limbs, a block at a time and many nodes at once; only what is in a box
 * is asked of its limb.
 *
 * A node that travels farther in a step than a part of the thinnest limb is swept: its straight path from where it was
 * is walked in pieces that are shorter the nearer the skin is, the first place nearer than the clearance is found by
 * halving, the response is taken there, and the rest of the step goes on with what velocity is left. Whether paths are
 * measured at all is decided by the speeds after the step before (`swift`).
 */

/* [m] a node this near to the clearance is still on the skin: a float state rounds by as much */
#define TOUCH_BAND 2e-6

#define HELD_BAND (sizeof(MUS_REAL) == sizeof(float) ? 1e-7 : 1e-15) /* [m]: as far off the skin as before */

#define SIT_OUT_MARGIN 0.04 /* [m]: how far off the body a distance is still taken */
#define SIT_OUT_MOST 100    /* calls */

#define LOOK_BLOCK 256      /* nodes */
#define SWEEP_PIECES 4096   /* most pieces of one path */
#define SWEEP_SHORTEST 1e-3 /* of them, in parts of the safe length: what is cut off a flank is then nanometres */
#define SWEEP_HALVINGS 50
#define SWEEP_DOOR 1e-5 /* [m]: this near to a box is in it */


/* how a node came here */
typedef struct MUS_FIELD(path) {
    const MUS_REAL *from; /* (3) where it was */
    MUS_REAL time;        /* how long it moved */
    MUS_REAL slip;        /* the part of that for which friction's impulse would have acted */
} MUS_FIELD(path);


/* friction: what a normal impulse `inward` takes of the velocity v, and of the way x - from along the skin; one that
 * sticks, as far off the skin as it was, is put back to the last bit */
static inline void MUS_FIELD(rub)(MUS_REAL friction, const MUS_FIELD(path) * path, MUS_REAL inward,
                                  const MUS_REAL *normal, MUS_REAL *x, MUS_REAL *v)
{
    MUS_REAL t[3], way[3], along = 0;
    for (int32_t i = 0; i < 3; i++) {
        t[i] = v[i] + inward * normal[i];
        way[i] = x[i] - path->from[i];
        along += way[i] * normal[i];
    }
    for (int32_t i = 0; i < 3; i++) way[i] -= along * normal[i];
    const MUS_REAL speed = (MUS_REAL)MUS_FIELD(sqrt)(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    const MUS_REAL length = (MUS_REAL)MUS_FIELD(sqrt)(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    const MUS_REAL loss = friction * inward, back = path->slip > 0 ? loss * path->slip : 0;
    const MUS_REAL keep = speed > loss ? (speed - loss) / speed : 0, part = length > back ? back / length : 1;
    const MUS_REAL off = along < 0 ? -along : along;
    const int32_t held = part == 1 && off <= (MUS_REAL)HELD_BAND;
    for (int32_t i = 0; i < 3; i++) {
        v[i] = keep * t[i];
        x[i] = held ? path->from[i] : x[i] - part * way[i];
    }
}


/* one node against one limb that it touches: x, v (3) are corrected in place. If its path is what brought it in, it is
 * put back whole; else it was inside before, and comes out by `push` beyond what springs just pulled it in */
static inline void MUS_FIELD(respond)(MUS_REAL lift, const mus__contact_rule *rule, const MUS_FIELD(path) * path,
                                      const MUS_REAL *normal, MUS_REAL *x, MUS_REAL *v)
{
    const MUS_REAL vn = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
    const MUS_REAL push = (MUS_REAL)rule->push, inward = vn < 0 ? -vn : 0;
    const MUS_REAL go = path->time * (MUS_REAL)MUS_FIELD(sqrt)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const MUS_REAL move = lift < 0 ? 0 : lift <= push + go ? lift : push + inward * path->slip;
    for (int32_t i = 0; i < 3; i++) x[i] += move * normal[i];
    if (vn < 0) MUS_FIELD(rub)((MUS_REAL)rule->friction, path, inward, normal, x, v);
}


/* nonzero when p is in the box (6) */
static inline int32_t MUS_FIELD(boxed)(const MUS_REAL *box, const MUS_REAL *p)
{
    return !(p[0] < box[0] || p[0] > box[3] || p[1] < box[1] || p[1] > box[4] || p[2] < box[2] || p[2] > box[5]);
}


/* the limbs whose box p is in, a bit each */
static uint64_t MUS_FIELD(boxes_of)(int32_t nlimb, const MUS_REAL *box, const MUS_REAL *p)
{
    uint64_t in = 0;
    for (int32_t l = 0; l < nlimb; l++) in |= (uint64_t)MUS_FIELD(boxed)(box + 6 * l, p) << l;
    return in;
}


/* one node against the limbs `in`, in place. Returns a lower bound of the node's distance to the body, at most
 * `margin`; below clearance + TOUCH_BAND when it touched */
static inline MUS_REAL MUS_FIELD(touch)(const mus__collider *collider, const mus__contact_rule *rule, uint64_t in,
                                        MUS_REAL margin, const MUS_FIELD(path) * path, MUS_REAL *p, MUS_REAL *w,
                                        int64_t *queries)
{
    const MUS_REAL clearance = (MUS_REAL)(rule->clearance - collider->skin), band = clearance + (MUS_REAL)TOUCH_BAND;
    MUS_REAL distance = margin;
    for (int32_t l = 0; in != 0; l++, in >>= 1) {
        if ((in & 1) == 0) continue;
        MUS_REAL normal[3];
        int32_t near;
        const MUS_REAL depth = MUS_FIELD(query)(&collider->MUS_FIELDS[l], p, margin, normal, &near);
        (*queries)++;
        if (near == 0) continue;
        if (-depth < distance) distance = -depth;
        if (depth > -band) MUS_FIELD(respond)(depth + clearance, rule, path, normal, p, w);
    }
    return distance;
}


/* ---- fast nodes ---- */

/* how far p is nearer than the clearance, over all limbs, and the normal (3) of the nearest; far below 0 and no normal
 * when none is near */
static MUS_REAL MUS_FIELD(lift_at)(const mus__collider *collider, const MUS_REAL *box, MUS_REAL margin,
                                   MUS_REAL clearance, const MUS_REAL *p, MUS_REAL *out, int64_t *queries)
{
    MUS_REAL lift = -1;
    for (int32_t l = 0; l < collider->nlimb; l++, box += 6) {
        if (!MUS_FIELD(boxed)(box, p)) continue;
        MUS_REAL normal[3];
        int32_t near;
        const MUS_REAL depth = MUS_FIELD(query)(&collider->MUS_FIELDS[l], p, margin, normal, &near);
        (*queries)++;
        if (!near || depth + clearance <= lift) continue;
        lift = depth + clearance;
        for (int32_t i = 0; i < 3; i++) out[i] = normal[i];
    }
    return lift;
}


/* time until p + t w is in a box: 0 when it is in one, `left` when it comes to none before */
static MUS_REAL MUS_FIELD(wait)(int32_t nlimb, const MUS_REAL *box, const MUS_REAL *p, const MUS_REAL *w,
                                MUS_REAL speed, MUS_REAL left)
{
    MUS_REAL first = left;
    for (int32_t l = 0; l < nlimb; l++, box += 6) {
        MUS_REAL in = 0, out = left;
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
static MUS_REAL MUS_FIELD(hit_time)(const mus__collider *collider, const MUS_REAL *box, MUS_REAL margin,
                                    MUS_REAL clearance, const MUS_REAL *p, const MUS_REAL *w, MUS_REAL piece,
                                    int64_t *queries)
{
    MUS_REAL low = 0, high = piece, normal[3];
    for (int32_t k = 0; k < SWEEP_HALVINGS; k++) {
        const MUS_REAL t = low + (high - low) / 2;
        const MUS_REAL q[3] = {p[0] + t * w[0], p[1] + t * w[1], p[2] + t * w[2]};
        if (MUS_FIELD(lift_at)(collider, box, margin, clearance, q, normal, queries) > 0)
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
static int32_t MUS_FIELD(meet)(const mus__collider *collider, const mus__contact_rule *rule, const MUS_REAL *box,
                               MUS_REAL margin, const MUS_FIELD(path) * path, MUS_REAL *p, MUS_REAL *w, MUS_REAL *way,
                               int64_t *queries)
{
    const MUS_REAL x[3] = {p[0], p[1], p[2]}, v[3] = {w[0], w[1], w[2]};
    MUS_FIELD(touch)(collider, rule, MUS_FIELD(boxes_of)(collider->nlimb, box, p), margin, path, p, w, queries);
    if (v[0] != w[0] || v[1] != w[1] || v[2] != w[2]) {
        for (int32_t i = 0; i < 3; i++) way[i] = w[i];
        return 1;
    }
    return x[0] != p[0] || x[1] != p[1] || x[2] != p[2];
}


/* a node that came from p to q in a step, now with velocity w: q and w (3) as contact leaves them. Nonzero when it
 * touched; else both are as they were */
static int32_t MUS_FIELD(sweep)(const mus__collider *collider, const mus__contact_rule *rule, const MUS_REAL *box,
                                MUS_REAL margin, MUS_REAL *p, MUS_REAL *q, MUS_REAL *w, int64_t *queries)
{
    const MUS_REAL clearance = (MUS_REAL)(rule->clearance - collider->skin), band = (MUS_REAL)TOUCH_BAND;
    const MUS_REAL safe = (MUS_REAL)collider->safe;
    MUS_REAL left = (MUS_REAL)rule->step;
    MUS_REAL way[3] = {(q[0] - p[0]) / left, (q[1] - p[1]) / left, (q[2] - p[2]) / left};
    int32_t touched = 0;
    for (int32_t k = 0; k < SWEEP_PIECES && left > 0; k++) {
        MUS_REAL speed = (MUS_REAL)MUS_FIELD(sqrt)(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
        MUS_REAL time = MUS_FIELD(wait)(collider->nlimb, box, p, way, speed, left), slip = 0, from[3];
        int32_t hit = 0;
        if (time == 0) {
            MUS_REAL normal[3];
            const MUS_REAL off = -MUS_FIELD(lift_at)(collider, box, safe, clearance, p, normal, queries);
            if (off <= band) {
                /* on the skin, or as good as: what goes in is taken off before the piece */
                const MUS_REAL in = -(way[0] * normal[0] + way[1] * normal[1] + way[2] * normal[2]);
                const MUS_REAL rest = in > 0 && off > 0 && off < left * in ? off / in : 0;
                for (int32_t i = 0; i < 3; i++) p[i] += rest * way[i];
                left -= rest;
                const MUS_FIELD(path) none = {p, 0, 0};
                touched |= MUS_FIELD(meet)(collider, rule, box, margin, &none, p, w, way, queries);
                speed = (MUS_REAL)MUS_FIELD(sqrt)(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
            }
            const MUS_REAL length = MUS_FIELD(piece)(off, safe);
            time = speed * left > length ? length / speed : left;
            const MUS_REAL r[3] = {p[0] + time * way[0], p[1] + time * way[1], p[2] + time * way[2]};
            hit = off <= band || MUS_FIELD(lift_at)(collider, box, safe, clearance, r, normal, queries) > 0;
            if (off <= band)
                slip = time;
            else if (hit)
                time = MUS_FIELD(hit_time)(collider, box, safe, clearance, p, way, time, queries);
        }
        for (int32_t i = 0; i < 3; i++) from[i] = p[i], p[i] += time * way[i];
        left -= time;
        const MUS_FIELD(path) piece = {from, time, slip};
        if (hit) touched |= MUS_FIELD(meet)(collider, rule, box, margin, &piece, p, w, way, queries);
    }
    /* a path of too many pieces ends where it got to */
    if (left > 0) touched = 1;
    for (int32_t i = 0; touched && i < 3; i++) q[i] = p[i];
    return touched;
}


/* ---- the pass ---- */

/* what a pass knows of the body */
typedef struct MUS_FIELD(scene) {
    MUS_REAL box[6 * MUS_LIMBS_MOST]; /* widened by the margin */
    MUS_REAL shift[3], drift[3];      /* of the body now */
    MUS_REAL back[3];                 /* its shift before the step */
    MUS_REAL margin;
} MUS_FIELD(scene);


/* limbs first .. last-1, at most 32: a bit in in (count) for each whose box a node is in */
MUS_CLONES
static void MUS_FIELD(look)(const MUS_FIELD(scene) * scene, int32_t first, int32_t last, int64_t n, int32_t count,
                            const MUS_REAL *restrict x, uint32_t *restrict in)
{
    const MUS_REAL s0 = scene->shift[0], s1 = scene->shift[1], s2 = scene->shift[2];
    for (int32_t i = 0; i < count; i++) in[i] = 0;
    for (int32_t l = first; l < last; l++) {
        const MUS_REAL *b = scene->box + 6 * l, b0 = b[0], b1 = b[1], b2 = b[2], b3 = b[3], b4 = b[4], b5 = b[5];
        const uint32_t bit = (uint32_t)1 << (l - first);
        MUS_IVDEP
        for (int32_t i = 0; i < count; i++) {
            const MUS_REAL p0 = x[i] - s0, p1 = x[n + i] - s1, p2 = x[2 * n + i] - s2;
            const uint32_t inside = (p0 >= b0) & (p0 <= b3) & (p1 >= b1) & (p1 <= b4) & (p2 >= b2) & (p2 <= b5);
            in[i] |= inside * bit;
        }
    }
}


/* nonzero when a speed relative to drift (3) is above the root of swift2 */
MUS_CLONES
static uint32_t MUS_FIELD(faster)(const MUS_REAL *drift, MUS_REAL swift2, int64_t n, int32_t count,
                                  const MUS_REAL *restrict v)
{
    const MUS_REAL d0 = drift[0], d1 = drift[1], d2 = drift[2];
    uint32_t found = 0;
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL w0 = v[i] - d0, w1 = v[n + i] - d1, w2 = v[2 * n + i] - d2;
        found |= w0 * w0 + w1 * w1 + w2 * w2 > swift2;
    }
    return found;
}


int32_t MUS_RUSH(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first, int32_t last,
                 const MUS_REAL *v)
{
    const MUS_REAL swift = (MUS_REAL)mus__contact_swift(collider, rule);
    MUS_REAL drift[3];
    for (int32_t d = 0; d < 3; d++) drift[d] = (MUS_REAL)collider->drift[d];
    return MUS_FIELD(faster)(drift, swift * swift, n, last - first, v + first) != 0;
}


/* node i, which is in the boxes `in` or may have to be swept */
static void MUS_FIELD(meet_node)(const mus__collider *collider, const mus__contact_rule *rule,
                                 const MUS_FIELD(scene) * scene, int32_t n, int32_t i, uint64_t in, int32_t sweeps,
                                 const MUS_REAL *inverse, const MUS_REAL *before, uint8_t *rest, MUS_REAL *x,
                                 MUS_REAL *v, mus__contact_tally *tally)
{
    /* place, velocity, and where it was, relative to the body */
    const int64_t at[3] = {i, n + i, 2 * (int64_t)n + i};
    MUS_REAL p[3], w[3], from[3], way2 = 0;
    for (int32_t d = 0; d < 3; d++) {
        p[d] = x[at[d]] - scene->shift[d];
        w[d] = v[at[d]] - scene->drift[d];
        from[d] = before[at[d]] - scene->back[d];
        way2 += (p[d] - from[d]) * (p[d] - from[d]);
    }
    const MUS_REAL clearance = (MUS_REAL)(rule->clearance - collider->skin), safe = (MUS_REAL)collider->safe;
    if (sweeps && way2 > safe * safe) {
        if (!MUS_FIELD(sweep)(collider, rule, scene->box, scene->margin, from, p, w, &tally->queries)) return;
    } else {
        const MUS_FIELD(path) path = {from, (MUS_REAL)rule->step, (MUS_REAL)rule->slip};
        const MUS_REAL distance = MUS_FIELD(touch)(collider, rule, in, scene->margin, &path, p, w, &tally->queries);

        /* it sits out as many calls as half its distance allows; the half is for the error of a first-order distance */
        const MUS_REAL off = rule->travel > 0.0 ? (distance - clearance) / 2 / (MUS_REAL)rule->travel : 0;
        rest[i] = off >= SIT_OUT_MOST ? SIT_OUT_MOST : off > 0 ? (uint8_t)off : 0;
        if (distance >= clearance + (MUS_REAL)TOUCH_BAND) return;
    }
    const double mass = 1.0 / (double)inverse[i];
    for (int32_t d = 0; d < 3; d++) {
        const MUS_REAL after = w[d] + scene->drift[d];
        tally->impulse[d] += ((double)after - (double)v[at[d]]) * mass;
        x[at[d]] = p[d] + scene->shift[d];
        v[at[d]] = after;
    }
}


void MUS_CONTACT(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first, int32_t last,
                 const MUS_REAL *inverse, const MUS_REAL *before, int32_t sweeps, uint8_t *rest, MUS_REAL *x,
                 MUS_REAL *v, mus__contact_tally *tally)
{
    MUS_FIELD(scene) scene;
    const int32_t nlimb = collider->nlimb;
    scene.margin = (MUS_REAL)(rule->clearance - collider->skin) + (MUS_REAL)TOUCH_BAND;
    if (rule->travel > 0.0) scene.margin += (MUS_REAL)SIT_OUT_MARGIN;
    for (int32_t k = 0; k < 6 * nlimb; k++)
        scene.box[k] = (MUS_REAL)collider->box[k] + (k % 6 < 3 ? -scene.margin : scene.margin);
    for (int32_t d = 0; d < 3; d++) {
        scene.shift[d] = (MUS_REAL)collider->shift[d];
        scene.drift[d] = (MUS_REAL)collider->drift[d];
        scene.back[d] = (MUS_REAL)(collider->shift[d] - rule->step * collider->drift[d]);
    }

    if (MUS_RUSH(collider, rule, n, first, last, v)) tally->swift = 1;
    uint32_t low[LOOK_BLOCK], high[LOOK_BLOCK] = {0};
    for (int32_t start = first; start < last; start += LOOK_BLOCK) {
        const int32_t count = last - start < LOOK_BLOCK ? last - start : LOOK_BLOCK;
        MUS_FIELD(look)(&scene, 0, nlimb < 32 ? nlimb : 32, n, count, x + start, low);
        if (nlimb > 32) MUS_FIELD(look)(&scene, 32, nlimb, n, count, x + start, high);
        for (int32_t i = start; i < start + count; i++) {
            const uint64_t in = low[i - start] | (uint64_t)high[i - start] << 32;
            if (in == 0 && !sweeps) continue;
            if (rest[i] > 0)
                rest[i]--;
            else if (inverse[i] != 0)
                MUS_FIELD(meet_node)(collider, rule, &scene, n, i, in, sweeps, inverse, before, rest, x, v, tally);
        }
    }
}
