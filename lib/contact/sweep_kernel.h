/*
 * sweep_kernel.h: fast nodes, a part of contact_kernel.h.
 *
 * A node that travels further in a step than a part of the thinnest limb is swept by conservative advancement (Mirtich,
 * Impulse-based dynamic simulation of rigid body systems, 1996): its straight path is walked in pieces that are shorter
 * the nearer the surface is, the first place inside the clearance is found by halving, the response is taken there, and
 * the rest of the step goes on with the velocity that is left. Parts that move each in their own way are swept one by
 * one, each from where it has carried the node; a plane's time of impact is a division.
 */

#define MUS__SWEEP_PIECES_MAX 4096 /* pieces of a path; it ends where it got to after so many */
#define MUS__SWEEP_SHORTEST 1e-3   /* shortest piece, of the safe travel: what it cuts off a flank is nanometres */
#define MUS__SWEEP_HALVINGS 50     /* of a piece: to the last bit of a double */
#define MUS__SWEEP_BOX_BAND 1e-5   /* [m] a node this near to a box counts as in it: above rounding */

/* parts that moved as one, and what a node is swept by */
typedef struct MUS__NAME(swept) {
    const MUS__NAME(pass) * pass;
    uint64_t parts;
    MUS__REAL safe;
} MUS__NAME(swept);


/* overlap of p with the parts, and the normal (3) of the deepest; -1 and no normal when none is within the safe travel
 */
static MUS__REAL MUS__NAME(overlap_at)(const MUS__NAME(swept) * swept, const MUS__REAL *p, MUS__REAL *out)
{
    const MUS__NAME(pass) *pass = swept->pass;
    MUS__REAL overlap = -1;
    uint64_t parts = swept->parts;
    for (int32_t l = 0; parts != 0; l++, parts >>= 1) {
        if ((parts & 1) == 0 || !MUS__NAME(in_box)(pass->surfaces.box + 6 * l, p)) continue;
        MUS__REAL normal[3];
        int32_t near;
        const MUS__REAL depth = MUS__NAME(field_query)(&pass->field[l], p, swept->safe, normal, &near);
        pass->tally->queries++;
        if (!near || depth + pass->clearance <= overlap) continue;
        overlap = depth + pass->clearance;
        for (int32_t i = 0; i < 3; i++) out[i] = normal[i];
    }
    return overlap;
}


/* time until p + t w is in a box: 0 when it is in one, `left` when it comes to none before; speed: |w| */
static MUS__REAL MUS__NAME(time_to_box)(const MUS__NAME(swept) * swept, const MUS__REAL *p, const MUS__REAL *w,
                                        MUS__REAL speed, MUS__REAL left)
{
    MUS__REAL first = left;
    uint64_t parts = swept->parts;
    for (int32_t l = 0; parts != 0; l++, parts >>= 1) {
        const MUS__REAL *box = swept->pass->surfaces.box + 6 * l;
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


/* the first time in 0..piece at which p + t w overlaps, where it does at `piece` and not at 0 */
static MUS__REAL MUS__NAME(impact_time)(const MUS__NAME(swept) * swept, const MUS__REAL *p, const MUS__REAL *w,
                                        MUS__REAL piece)
{
    MUS__REAL low = 0, high = piece, normal[3];
    for (int32_t k = 0; k < MUS__SWEEP_HALVINGS; k++) {
        const MUS__REAL t = low + (high - low) / 2;
        const MUS__REAL q[3] = {p[0] + t * w[0], p[1] + t * w[1], p[2] + t * w[2]};
        if (MUS__NAME(overlap_at)(swept, q, normal) > 0)
            high = t;
        else
            low = t;
    }
    return low;
}


/* length of the piece to walk from a place `distance` beyond the clearance: half of what is surely free, as distances
 * are of first order; on the surface, where the response after each piece takes back what goes in, the safe travel */
static inline MUS__REAL MUS__NAME(piece_length)(MUS__REAL distance, MUS__REAL safe)
{
    const MUS__REAL free = distance / 2, shortest = (MUS__REAL)MUS__SWEEP_SHORTEST * safe;
    return distance <= (MUS__REAL)MUS__TOUCH_BAND || free > safe ? safe : free > shortest ? free : shortest;
}


/* respond_node() at the end of a piece: nonzero when place p or velocity w changed; a changed velocity becomes `way`,
 * that of the rest of the path */
static int32_t MUS__NAME(respond_piece)(const MUS__NAME(swept) * swept, const MUS__NAME(path) * path, MUS__REAL *p,
                                        MUS__REAL *w, MUS__REAL *way)
{
    const MUS__REAL x[3] = {p[0], p[1], p[2]}, v[3] = {w[0], w[1], w[2]};
    const MUS__NAME(query) query = {swept->parts & MUS__NAME(boxes_around)(swept->pass, p), 0, 0, 0, 1, NULL, 0};
    MUS__NAME(gaps) gaps = {0, 0, 0};
    MUS__NAME(respond_node)(swept->pass, &query, path, &gaps, p, w);
    if (v[0] != w[0] || v[1] != w[1] || v[2] != w[2]) {
        for (int32_t i = 0; i < 3; i++) way[i] = w[i];
        return 1;
    }
    return x[0] != p[0] || x[1] != p[1] || x[2] != p[2];
}


/* a node that came from p to q in a step, now with velocity w, all relative to the parts: q and w (3) after contact.
 * Nonzero when it touched; else both are as they were */
static int32_t MUS__NAME(sweep)(const MUS__NAME(swept) * swept, MUS__REAL *p, MUS__REAL *q, MUS__REAL *w)
{
    const MUS__REAL band = (MUS__REAL)MUS__TOUCH_BAND, safe = swept->safe;
    MUS__REAL left = (MUS__REAL)swept->pass->rule->step;
    MUS__REAL way[3] = {(q[0] - p[0]) / left, (q[1] - p[1]) / left, (q[2] - p[2]) / left};
    int32_t touched = 0;
    for (int32_t k = 0; k < MUS__SWEEP_PIECES_MAX && left > 0; k++) {
        MUS__REAL speed = (MUS__REAL)MUS__NAME(sqrt)(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
        MUS__REAL time = MUS__NAME(time_to_box)(swept, p, way, speed, left), slip = 0, from[3];
        int32_t hit = 0;
        if (time == 0) {
            MUS__REAL normal[3];
            const MUS__REAL off = -MUS__NAME(overlap_at)(swept, p, normal);
            if (off <= band) {
                /* on the surface: the velocity into it is taken off before the piece */
                const MUS__REAL in = -(way[0] * normal[0] + way[1] * normal[1] + way[2] * normal[2]);
                const MUS__REAL rest = in > 0 && off > 0 && off < left * in ? off / in : 0;
                for (int32_t i = 0; i < 3; i++) p[i] += rest * way[i];
                left -= rest;
                const MUS__NAME(path) none = {p, 0, 0};
                touched |= MUS__NAME(respond_piece)(swept, &none, p, w, way);
                speed = (MUS__REAL)MUS__NAME(sqrt)(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
            }
            const MUS__REAL length = MUS__NAME(piece_length)(off, safe);
            time = speed * left > length ? length / speed : left;
            const MUS__REAL r[3] = {p[0] + time * way[0], p[1] + time * way[1], p[2] + time * way[2]};
            hit = off <= band || MUS__NAME(overlap_at)(swept, r, normal) > 0;
            if (off <= band)
                slip = time;
            else if (hit)
                time = MUS__NAME(impact_time)(swept, p, way, time);
        }
        for (int32_t i = 0; i < 3; i++) from[i] = p[i], p[i] += time * way[i];
        left -= time;
        const MUS__NAME(path) piece = {from, time, slip};
        if (hit) touched |= MUS__NAME(respond_piece)(swept, &piece, p, w, way);
    }
    /* a path of too many pieces ends where it got to */
    if (left > 0) touched = 1;
    for (int32_t i = 0; touched && i < 3; i++) q[i] = p[i];
    return touched;
}


/* a node that went from one side of plane k to the other in the step: nonzero when it hit the plane, and then x and v
 * (3) after contact */
static int32_t MUS__NAME(sweep_plane)(const MUS__NAME(pass) * pass, int32_t k, const MUS__REAL *from, MUS__REAL *x,
                                      MUS__REAL *v)
{
    const MUS__NAME(plane) *plane = &pass->surfaces.plane[k];
    const MUS__REAL step = (MUS__REAL)pass->rule->step;
    MUS__REAL p[3], velocity[3], hit[3];
    MUS__NAME(carry_node)(plane->moving ? &plane->motion : NULL, from, x, p, velocity);
    const MUS__REAL start = plane->start + pass->clearance;
    const MUS__REAL before = MUS__NAME(dot)(plane->normal, p) - start, after = MUS__NAME(dot)(plane->normal, x) - start;
    if (!(before > (MUS__REAL)MUS__TOUCH_BAND && after < 0)) return 0;
    const MUS__REAL part = before / (before - after);
    for (int32_t d = 0; d < 3; d++) hit[d] = p[d] + part * (x[d] - p[d]);
    if (plane->reach < (MUS__REAL)MUS__PLANE_ENDLESS && MUS__NAME(plane_across)(plane, hit) > plane->reach) return 0;

    /* the response where it hit, and on along the plane with what is left of its velocity */
    const MUS__REAL time = step * part, left = step - time;
    const MUS__NAME(response) response = {(MUS__REAL)pass->rule->push, time, 0};
    for (int32_t d = 0; d < 3; d++) v[d] -= velocity[d];
    MUS__NAME(respond_one)(0, plane->friction, response, plane->normal, p, hit, v);
    for (int32_t d = 0; d < 3; d++) x[d] = hit[d] + left * v[d], v[d] += velocity[d];
    return 1;
}


/* a node that went from `from` to x in the step, with velocity v, swept against the surfaces that it passes fast; these
 * are taken out of `parts` and `planes`. Nonzero when it touched */
static int32_t MUS__NAME(sweep_all)(const MUS__NAME(pass) * pass, uint64_t *parts, uint32_t *planes,
                                    const MUS__REAL *from, MUS__REAL *x, MUS__REAL *v)
{
    const MUS__NAME(surfaces) *surfaces = &pass->surfaces;
    const int32_t n = pass->collider->nparts, groups = n > 0 && surfaces->moving != MUS__TURNED ? 1 : n;
    const uint64_t every = n < 64 ? ((uint64_t)1 << n) - 1 : ~(uint64_t)0;
    int32_t touched = 0;
    for (int32_t g = 0; g < groups; g++) {
        const MUS__REAL safe = (MUS__REAL)(groups == 1 ? pass->collider->safe : pass->collider->part[g].safe);
        MUS__REAL p[3], velocity[3], w[3], way2 = 0;
        MUS__NAME(carry_node)(MUS__NAME(motion_of)(surfaces, g), from, x, p, velocity);
        for (int32_t d = 0; d < 3; d++) way2 += (x[d] - p[d]) * (x[d] - p[d]), w[d] = v[d] - velocity[d];
        if (!(way2 > safe * safe)) continue;
        const MUS__NAME(swept) swept = {pass, groups == 1 ? every : (uint64_t)1 << g, safe};
        *parts &= ~swept.parts;
        if (!MUS__NAME(sweep)(&swept, p, x, w)) continue;
        touched = 1;
        for (int32_t d = 0; d < 3; d++) v[d] = w[d] + velocity[d];
    }
    for (int32_t k = 0; k < surfaces->nplane; k++) {
        const MUS__NAME(plane) *plane = &surfaces->plane[k];
        const MUS__REAL safe = (MUS__REAL)pass->collider->safe;
        MUS__REAL p[3], velocity[3], way2 = 0;
        MUS__NAME(carry_node)(plane->moving ? &plane->motion : NULL, from, x, p, velocity);
        for (int32_t d = 0; d < 3; d++) way2 += (x[d] - p[d]) * (x[d] - p[d]);
        if (!(way2 > safe * safe) || !MUS__NAME(sweep_plane)(pass, k, from, x, v)) continue;
        touched = 1;
        *planes &= ~((uint32_t)1 << k);
    }
    return touched;
}
