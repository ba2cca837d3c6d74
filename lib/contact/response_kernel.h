/*
 * response_kernel.h: the response of one node to the surfaces that it touches, a part of contact_kernel.h.
 *
 * A node nearer than the clearance is put back along the outward normal, loses its velocity into the surface, and
 * friction takes of its sliding (friction_kernel.h). Several surfaces are solved together (contact_manifold_kernel.h).
 * All is relative to the surface: places to where it carried the node from, velocities to its own there.
 *
 * Pushing a node out of one surface may push it into another. Surfaces within the push distance are therefore solved in
 * the same manifold: between an arm and a side a tight cloth would otherwise be thrown from one to the other.
 */

#define MUS__CANDIDATES_MAX 16 /* surfaces near a node; of more, the furthest are left out */
#define MUS__SQUEEZE_MAX 5.0   /* [m/s] speed at which a closing wedge drives a node out; chosen */

/* how a node came to its place, relative to a surface */
typedef struct MUS__NAME(path) {
    const MUS__REAL *from; /* (3) where it was */
    MUS__REAL time;        /* how long it moved [s] */
    MUS__REAL slip;        /* the part of that for which it moved with the velocity before the impulse [s] */
} MUS__NAME(path);

/* what a node is to be asked of */
typedef struct MUS__NAME(query) {
    uint64_t parts;  /* parts, a bit each */
    uint64_t others; /* parts in whose boxes it is, but too far off to touch; they may stop it when it is pushed */
    uint32_t planes;
    MUS__REAL lift;                       /* how much farther than the clearance it stays off the parts [m] */
    int32_t still;                        /* nonzero: as if all surfaces were at rest */
    const MUS__NAME(query_batch) * batch; /* results that are known, from `head` on; may be NULL */
    int32_t head;
} MUS__NAME(query);

/* a surface near a node */
typedef struct MUS__NAME(candidate) {
    MUS__REAL overlap; /* how far the node is inside the clearance; negative: beyond [m] */
    MUS__REAL friction, normal[3];
    const MUS__NAME(motion) * motion; /* NULL: at rest */
} MUS__NAME(candidate);

typedef struct MUS__NAME(candidates) {
    int32_t count;
    MUS__NAME(candidate) list[MUS__CANDIDATES_MAX];
} MUS__NAME(candidates);

/* distances of a node beyond the clearance: the least of all surfaces; parts further than MUS__CACHE_GAP, and the least
 * of these */
typedef struct MUS__NAME(gaps) {
    MUS__REAL all, some;
    uint64_t far;
} MUS__NAME(gaps);


/* ---- one surface ---- */

/* what part of the rule a response to one surface needs: how far it may put back a node that was inside before [m], and
 * the times of the node's path [s] */
typedef struct MUS__NAME(response) {
    MUS__REAL push, time, slip;
} MUS__NAME(response);


/* one node and one surface that it touches: x, v (3) are changed in place. A node that its path brought in is put back
 * whole; else it was inside before, and comes out by `push` beyond what springs just pulled it in. No branch, for the
 * batch; `from` may be x */
static MUS_INLINE void MUS__NAME(respond_one)(MUS__REAL overlap, MUS__REAL friction, MUS__NAME(response) rule,
                                              const MUS__REAL *normal, const MUS__REAL *from, MUS__REAL *x,
                                              MUS__REAL *v)
{
    const MUS__REAL vn = MUS__NAME(dot)(v, normal), inward = vn < 0 ? -vn : 0;
    const MUS__REAL go = rule.time * (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(v, v));
    const MUS__REAL partly = rule.push + inward * rule.slip, whole = overlap <= rule.push + go ? overlap : partly;
    const MUS__REAL move = overlap < 0 ? 0 : whole;
    for (int32_t d = 0; d < 3; d++) x[d] += move * normal[d];

    MUS__NAME(sliding) sliding;
    MUS__NAME(friction)(friction, inward, rule.slip, normal, from, x, v, &sliding);
    const MUS__REAL off = sliding.along < 0 ? -sliding.along : sliding.along;
    const int32_t rubs = vn < 0, sticks = (sliding.take == 1) & (off <= (MUS__REAL)MUS__STICK_BAND);
    for (int32_t d = 0; d < 3; d++) {
        const MUS__REAL slid = sticks ? from[d] : x[d] - sliding.take * sliding.way[d];
        x[d] = rubs ? slid : x[d];
        v[d] = rubs ? sliding.keep * sliding.t[d] : v[d];
    }
}


/* ---- a manifold ---- */

/* friction of one of several surfaces, under its part `impulse` of the normal impulse. Nonzero when all of the way
 * along it was taken back */
static int32_t MUS__NAME(friction_of_one)(const MUS__NAME(contact) * m, MUS__REAL impulse, MUS__REAL slip, MUS__REAL *x,
                                          MUS__REAL *v)
{
    MUS__REAL w[3];
    MUS__NAME(sliding) sliding;
    for (int32_t d = 0; d < 3; d++) w[d] = v[d] - m->velocity[d];
    MUS__NAME(friction)(m->friction, impulse, slip, m->normal, m->from, x, w, &sliding);
    for (int32_t d = 0; d < 3; d++) v[d] -= (1 - sliding.keep) * sliding.t[d], x[d] -= sliding.take * sliding.way[d];
    return sliding.take == 1;
}


#include "contact/pinch_kernel.h"


/* one node and the several surfaces that it touches, in place */
static void MUS__NAME(respond_manifold)(const mus__contact_rule *rule, const MUS__NAME(path) * path,
                                        const MUS__NAME(contact) * list, int32_t count, MUS__REAL *x, MUS__REAL *v)
{
    const MUS__REAL start[3] = {x[0], x[1], x[2]};
    MUS__REAL target[MUS__MANIFOLD_MAX], multiplier[MUS__MANIFOLD_MAX], move[3], way[3], fast2 = 0, off2 = 0;
    int32_t rubbed = 0, stuck = 0;
    const int32_t pinched = rule->pull > 0.0 && MUS__NAME(pinched)(list, count, x);

    /* velocities, with no more than the node has; then friction, which takes of the way too */
    for (int32_t i = 0; i < count; i++) {
        MUS__REAL w[3];
        for (int32_t d = 0; d < 3; d++) w[d] = v[d] - list[i].velocity[d];
        const MUS__REAL w2 = MUS__NAME(dot)(w, w);
        target[i] = -MUS__NAME(dot)(w, list[i].normal);
        if (w2 > fast2) fast2 = w2;
    }
    const MUS__REAL fast = (MUS__REAL)MUS__NAME(sqrt)(fast2);
    MUS__NAME(manifold_solve)(list, count, target, (MUS__REAL)MUS__SQUEEZE_MAX, move, multiplier);
    const MUS__REAL squeeze = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(move, move));
    MUS__NAME(manifold_solve)(list, count, target, fast, move, multiplier);
    for (int32_t d = 0; d < 3; d++) v[d] += move[d];
    for (int32_t i = 0; i < count; i++) {
        if (!(multiplier[i] > 0) || pinched) continue;
        rubbed++;
        stuck += MUS__NAME(friction_of_one)(&list[i], multiplier[i], path->slip, x, v);
    }

    /* places: out at once when the path of the step brought the node in, else by `push` beyond what springs did and
     * what a closing wedge drives out */
    const MUS__REAL most = (MUS__REAL)rule->push + fast * path->slip + squeeze * path->time;
    for (int32_t d = 0; d < 3; d++) way[d] = x[d] - start[d];
    for (int32_t i = 0; i < count; i++) target[i] = list[i].overlap - MUS__NAME(dot)(way, list[i].normal);
    MUS__NAME(manifold_solve)(list, count, target, most, move, multiplier);
    const MUS__REAL far = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(move, move));
    const MUS__REAL scale = far <= (MUS__REAL)rule->push + path->time * fast ? 1 : most / far;
    const int32_t out = pinched && far > (MUS__REAL)MUS__PINCH_NEAR;
    if (out) MUS__NAME(pinch_release)(rule, path->time, move, far, v);
    for (int32_t d = 0; d < 3 && !out; d++) x[d] += scale * move[d];

    /* a node that sticks and is where it was is put back to the last bit */
    for (int32_t d = 0; d < 3; d++) off2 += (x[d] - list->from[d]) * (x[d] - list->from[d]);
    if (rubbed == 0 || stuck < rubbed || off2 > (MUS__REAL)(MUS__STICK_BAND * MUS__STICK_BAND)) return;
    for (int32_t d = 0; d < 3; d++) x[d] = list->from[d];
}


/* ---- candidates ---- */

static inline void MUS__NAME(gaps_note)(MUS__NAME(gaps) * gaps, int32_t part, MUS__REAL gap)
{
    if (gap < gaps->all) gaps->all = gap;
    if (!(gap > (MUS__REAL)MUS__CACHE_GAP)) return;
    gaps->far |= (uint64_t)1 << part;
    if (gap < gaps->some) gaps->some = gap;
}


/* place for one more candidate: at the end, or that of the furthest one if it is further than `overlap`; or NULL */
static inline MUS__NAME(candidate) * MUS__NAME(candidate_add)(MUS__NAME(candidates) * near, MUS__REAL overlap)
{
    if (near->count < MUS__CANDIDATES_MAX) return &near->list[near->count++];
    int32_t least = 0;
    for (int32_t i = 1; i < MUS__CANDIDATES_MAX; i++)
        if (near->list[i].overlap < near->list[least].overlap) least = i;
    return near->list[least].overlap < overlap ? &near->list[least] : NULL;
}


/* part l, with its motion, asked of a node at p, or its known result (may be NULL): a candidate when it is near */
static inline void MUS__NAME(query_part)(const MUS__NAME(pass) * pass, int32_t l, MUS__REAL lift,
                                         const MUS__NAME(motion) * motion, const MUS__NAME(query_result) * result,
                                         const MUS__REAL *p, MUS__NAME(gaps) * gaps, MUS__NAME(candidates) * list)
{
    const MUS__REAL clearance = pass->clearance, margin = pass->surfaces.margin;
    int32_t near = 1;
    MUS__REAL depth, normal[3];
    if (result != NULL) {
        depth = result->depth;
    } else {
        depth = MUS__NAME(field_query)(&pass->field[l], p, margin, normal, &near) + lift;
        pass->tally->queries++;
    }
    MUS__NAME(gaps_note)(gaps, l, (near != 0 ? -depth : margin - lift) - clearance);
    MUS__NAME(candidate) *candidate = near != 0 ? MUS__NAME(candidate_add)(list, depth + clearance) : NULL;
    if (candidate == NULL) return;
    candidate->overlap = depth + clearance;
    candidate->friction = (MUS__REAL)pass->rule->friction;
    for (int32_t d = 0; d < 3; d++) candidate->normal[d] = result != NULL ? result->normal[d] : normal[d];
    candidate->motion = motion;
}


/* the planes of a query, likewise */
static inline void MUS__NAME(query_planes)(const MUS__NAME(pass) * pass, const MUS__NAME(query) * query,
                                           const MUS__REAL *p, MUS__NAME(gaps) * gaps, MUS__NAME(candidates) * list)
{
    const MUS__REAL clearance = pass->clearance;
    uint32_t left = query->planes;
    for (int32_t k = 0; left != 0; k++, left >>= 1) {
        if ((left & 1) == 0) continue;
        int32_t near;
        const MUS__NAME(plane) *plane = &pass->surfaces.plane[k];
        const MUS__REAL depth = MUS__NAME(plane_depth)(plane, p, pass->surfaces.margin, &near);
        pass->tally->queries++;
        if (-depth - clearance < gaps->all) gaps->all = -depth - clearance;
        MUS__NAME(candidate) *candidate = near ? MUS__NAME(candidate_add)(list, depth + clearance) : NULL;
        if (candidate == NULL) continue;
        candidate->overlap = depth + clearance;
        candidate->friction = plane->friction;
        for (int32_t d = 0; d < 3; d++) candidate->normal[d] = plane->normal[d];
        candidate->motion = query->still || !plane->moving ? NULL : &plane->motion;
    }
}


/* bound of how far respond_one() moves a node with velocity w (3) against a surface that it overlaps by `overlap` */
static inline MUS__REAL MUS__NAME(push_length)(const mus__contact_rule *rule, MUS__REAL overlap, const MUS__REAL *w)
{
    const MUS__REAL fast = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(w, w)), push = (MUS__REAL)rule->push;
    return overlap <= push + (MUS__REAL)rule->step * fast ? overlap : push + (MUS__REAL)rule->slip * fast;
}


/* ---- a node ---- */

/* the candidates (the deepest is `first`) that a node touches, or would when it is pushed out by `push`: contacts
 * (MUS__MANIFOLD_MAX). *only: the last of them. Returns their number */
static inline int32_t MUS__NAME(touching)(const MUS__NAME(candidates) * near, int32_t first, MUS__REAL push,
                                          const MUS__NAME(path) * path, const MUS__REAL *p,
                                          MUS__NAME(contact) * contacts, const MUS__NAME(candidate) * *only)
{
    int32_t hits = 0;
    *only = NULL;
    for (int32_t i = 0; i < near->count; i++) {
        const MUS__NAME(candidate) *candidate = &near->list[i];
        const MUS__REAL into = push > 0 ? -push * MUS__NAME(dot)(candidate->normal, near->list[first].normal) : 0;
        const int32_t touches =
            candidate->overlap > -(MUS__REAL)MUS__TOUCH_BAND || (i != first && candidate->overlap + into > 0);
        if (!touches || hits == MUS__MANIFOLD_MAX) continue;
        MUS__NAME(contact) *m = &contacts[hits++];
        m->overlap = candidate->overlap, m->friction = candidate->friction;
        for (int32_t d = 0; d < 3; d++) m->normal[d] = candidate->normal[d];
        MUS__NAME(carry_node)(candidate->motion, path->from, p, m->from, m->velocity);
        *only = candidate;
    }
    return hits;
}


/* the surfaces of a query answered for a node with place p and velocity w (3), in place. gaps, which the caller starts,
 * gets lower bounds of its distances. Nonzero when it touched */
static inline int32_t MUS__NAME(respond_node)(const MUS__NAME(pass) * pass, const MUS__NAME(query) * query,
                                              const MUS__NAME(path) * path, MUS__NAME(gaps) * gaps, MUS__REAL *p,
                                              MUS__REAL *w)
{
    const MUS__NAME(surfaces) *surfaces = &pass->surfaces;
    MUS__NAME(candidates) near;
    MUS__NAME(gaps) none = {0, 0, 0};
    int32_t first = 0, head = query->head;
    near.count = 0;
    for (uint64_t left = query->parts; left != 0; left &= left - 1) {
        const int32_t l = mus__lowest_bit(left);
        const MUS__NAME(motion) *motion = query->still ? NULL : MUS__NAME(motion_of)(surfaces, l);
        const MUS__NAME(query_result) *result = head > 0 ? &query->batch->result[head] : NULL;
        if (result != NULL && result->part != l) result = NULL;
        if (result != NULL) head = result->next;
        MUS__NAME(query_part)(pass, l, query->lift, motion, result, p, gaps, &near);
    }
    MUS__NAME(query_planes)(pass, query, p, gaps, &near);
    for (int32_t i = 1; i < near.count; i++)
        if (near.list[i].overlap > near.list[first].overlap) first = i;
    if (near.count == 0 || !(near.list[first].overlap > -(MUS__REAL)MUS__TOUCH_BAND)) return 0;

    /* a far push may bring it to parts that its cache left out */
    MUS__REAL from[3], speed[3];
    MUS__NAME(carry_node)(near.list[first].motion, path->from, p, from, speed);
    for (int32_t d = 0; d < 3; d++) speed[d] = w[d] - speed[d];
    const MUS__REAL push = MUS__NAME(push_length)(pass->rule, near.list[first].overlap, speed);
    for (uint64_t left = push > (MUS__REAL)MUS__PUSH_FAR ? query->others : 0; left != 0; left &= left - 1) {
        const int32_t l = mus__lowest_bit(left);
        const MUS__NAME(motion) *motion = query->still ? NULL : MUS__NAME(motion_of)(surfaces, l);
        MUS__NAME(query_part)(pass, l, query->lift, motion, NULL, p, &none, &near);
    }

    MUS__NAME(contact) list[MUS__MANIFOLD_MAX];
    const MUS__NAME(candidate) * only;
    const int32_t hits = MUS__NAME(touching)(&near, first, push, path, p, list, &only);
    const MUS__NAME(response) response = {(MUS__REAL)pass->rule->push, path->time, path->slip};
    if (hits > 1) {
        MUS__NAME(respond_manifold)(pass->rule, path, list, hits, p, w);
    } else if (only != NULL && only->motion == NULL) {
        MUS__NAME(respond_one)(only->overlap, only->friction, response, only->normal, path->from, p, w);
    } else if (only != NULL) {
        for (int32_t d = 0; d < 3; d++) w[d] -= list->velocity[d];
        MUS__NAME(respond_one)(only->overlap, only->friction, response, only->normal, list->from, p, w);
        for (int32_t d = 0; d < 3; d++) w[d] += list->velocity[d];
    }
    return 1;
}
