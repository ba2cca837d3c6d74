/*
 * response_kernel.h: one node against all surfaces that it touches, a part of contact_kernel.h.
 */

/* one node against one surface that it touches: x, v (3) are corrected in place. If its path is what brought it in, it
 * is put back whole; else it was inside before, and comes out by `push` beyond what springs just pulled it in */
static inline void MUS__NAME(respond_one)(MUS__REAL overlap, MUS__REAL friction, const mus__contact_rule *rule,
                                          const MUS__NAME(path) * path, const MUS__REAL *normal, MUS__REAL *x,
                                          MUS__REAL *v)
{
    const MUS__REAL vn = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
    const MUS__REAL push = (MUS__REAL)rule->push, inward = vn < 0 ? -vn : 0;
    const MUS__REAL go = path->time * (MUS__REAL)MUS__NAME(sqrt)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const MUS__REAL move = overlap < 0 ? 0 : overlap <= push + go ? overlap : push + inward * path->slip;
    for (int32_t i = 0; i < 3; i++) x[i] += move * normal[i];
    if (vn < 0) MUS__NAME(friction)(friction, path, inward, normal, x, v);
}

#include "contact/pinch_kernel.h"


/* one node against the several surfaces that it touches, in place */
static void MUS__NAME(respond_manifold)(const mus__contact_rule *rule, const MUS__NAME(path) * path,
                                        const MUS__NAME(contact) * list, int32_t count, MUS__REAL *x, MUS__REAL *v)
{
    const MUS__REAL start[3] = {x[0], x[1], x[2]};
    MUS__REAL target[MUS__MANIFOLD_MAX], multiplier[MUS__MANIFOLD_MAX], move[3], way[3], fast2 = 0, off2 = 0;
    int32_t rubbed = 0, all = 0;
    const int32_t pinched = rule->pull > 0.0 && MUS__NAME(pinched)(list, count, x);

    /* velocities, with no more than the node has; then friction, which takes of the way too */
    for (int32_t i = 0; i < count; i++) {
        MUS__REAL w[3];
        for (int32_t d = 0; d < 3; d++) w[d] = v[d] - list[i].speed[d];
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
        all += MUS__NAME(friction_of_one)(&list[i], multiplier[i], path->slip, x, v);
    }

    /* places: out at once when the path of the step brought the node in, else by `push` beyond what springs did and
     * what a wedge that closes drives out */
    const MUS__REAL most = (MUS__REAL)rule->push + fast * path->slip + squeeze * path->time;
    for (int32_t d = 0; d < 3; d++) way[d] = x[d] - start[d];
    for (int32_t i = 0; i < count; i++) target[i] = list[i].overlap - MUS__NAME(dot)(way, list[i].normal);
    MUS__NAME(manifold_solve)(list, count, target, most, move, multiplier);
    const MUS__REAL far = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(move, move));
    const MUS__REAL scale = far <= (MUS__REAL)rule->push + path->time * fast ? 1 : most / far;
    const int32_t out = pinched && far > (MUS__REAL)MUS__PINCH_NEAR;
    if (out) MUS__NAME(pinch_release)(rule, path->time, move, far, v);
    for (int32_t d = 0; d < 3 && !out; d++) x[d] += scale * move[d];

    /* one that sticks and is where it was is put back to the last bit */
    for (int32_t d = 0; d < 3; d++) off2 += (x[d] - list->from[d]) * (x[d] - list->from[d]);
    if (rubbed == 0 || all < rubbed || off2 > (MUS__REAL)(MUS__STICK_BAND * MUS__STICK_BAND)) return;
    for (int32_t d = 0; d < 3; d++) x[d] = list->from[d];
}

/* a surface that a node was asked of: `overlap` above 0 where it is nearer than the clearance */
typedef struct MUS__NAME(candidate) {
    MUS__REAL overlap, friction, normal[3];
    const MUS__NAME(motion) * motion;
} MUS__NAME(candidate);


/* how far surfaces are beyond the clearance: the nearest of all, and of the parts that are farther than MUS__CACHE_GAP
 * which they are and the nearest */
typedef struct MUS__NAME(gaps) {
    MUS__REAL all, some;
    uint64_t far;
} MUS__NAME(gaps);


static inline void MUS__NAME(gaps_note)(MUS__NAME(gaps) * gaps, int32_t part, MUS__REAL gap)
{
    if (gap < gaps->all) gaps->all = gap;
    if (!(gap > (MUS__REAL)MUS__CACHE_GAP)) return;
    gaps->far |= (uint64_t)1 << part;
    if (gap < gaps->some) gaps->some = gap;
}


/* room for one more candidate: on the list of MUS__CANDIDATES_MAX, or where the farthest is, if that is beyond
 * `overlap`, or NULL */
static inline MUS__NAME(candidate) *
    MUS__NAME(candidate_add)(MUS__NAME(candidate) * candidates, int32_t *count, MUS__REAL overlap)
{
    if (*count < MUS__CANDIDATES_MAX) return &candidates[(*count)++];
    int32_t least = 0;
    for (int32_t i = 1; i < MUS__CANDIDATES_MAX; i++)
        if (candidates[i].overlap < candidates[least].overlap) least = i;
    return candidates[least].overlap < overlap ? &candidates[least] : NULL;
}


/* part l asked of a node, or the answer that it has: on the list of candidates when it is near */
static inline void MUS__NAME(query_part)(const mus__collider *collider, const mus__contact_rule *rule,
                                         const MUS__NAME(surfaces) * surfaces, int32_t l, const MUS__NAME(motion) * way,
                                         const MUS__NAME(query_result) * answer, const MUS__REAL *p,
                                         MUS__NAME(gaps) * gaps, MUS__NAME(candidate) * candidates, int32_t *count,
                                         int64_t *queries)
{
    const MUS__REAL clearance = (MUS__REAL)(rule->clearance - collider->offset);
    int32_t near = 1;
    MUS__REAL depth, normal[3];
    if (answer != NULL) {
        depth = answer->depth;
    } else {
        depth = MUS__NAME(field_query)(&collider->MUS__PART_FIELDS[l], p, surfaces->margin, normal, &near);
        (*queries)++;
    }
    MUS__NAME(gaps_note)(gaps, l, (near != 0 ? -depth : surfaces->margin) - clearance);
    MUS__NAME(candidate) *candidate = near != 0 ? MUS__NAME(candidate_add)(candidates, count, depth + clearance) : NULL;
    if (candidate == NULL) return;
    candidate->overlap = depth + clearance;
    candidate->friction = (MUS__REAL)rule->friction;
    for (int32_t d = 0; d < 3; d++) candidate->normal[d] = answer != NULL ? answer->normal[d] : normal[d];
    candidate->motion = way;
}


/* the planes `on` asked of a node, as parts are */
static inline void MUS__NAME(query_planes)(MUS__REAL clearance, const MUS__NAME(surfaces) * surfaces, uint32_t on,
                                           int32_t still, const MUS__REAL *p, MUS__NAME(gaps) * gaps,
                                           MUS__NAME(candidate) * candidates, int32_t *count, int64_t *queries)
{
    for (int32_t k = 0; on != 0; k++, on >>= 1) {
        if ((on & 1) == 0) continue;
        int32_t near;
        const MUS__NAME(plane) *plane = &surfaces->plane[k];
        const MUS__REAL depth = MUS__NAME(plane_depth)(plane, p, surfaces->margin, &near);
        (*queries)++;
        if (-depth - clearance < gaps->all) gaps->all = -depth - clearance;
        MUS__NAME(candidate) *candidate = near ? MUS__NAME(candidate_add)(candidates, count, depth + clearance) : NULL;
        if (candidate == NULL) continue;
        candidate->overlap = depth + clearance;
        candidate->friction = plane->friction;
        for (int32_t d = 0; d < 3; d++) candidate->normal[d] = plane->normal[d];
        candidate->motion = still || !plane->moving ? NULL : &plane->motion;
    }
}


/* how far respond() moves a node at most that goes with w (3) against the surface, which is to overlap it by `overlap`
 */
static inline MUS__REAL MUS__NAME(push_length)(const mus__contact_rule *rule, MUS__REAL overlap, const MUS__REAL *w)
{
    const MUS__REAL fast = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(w, w)), push = (MUS__REAL)rule->push;
    return overlap <= push + (MUS__REAL)rule->step * fast ? overlap : push + (MUS__REAL)rule->slip * fast;
}


/* one node against the parts `in` and the planes `on`, in place; `still`: as if all were at rest. `rest`: parts whose
 * boxes it is in and that are too far off to touch it, but not too far to stop it when it is pushed. `batch` (may be
 * NULL) has answers for it from `head` on; gaps (which the caller starts) gets lower bounds of the node's distance to
 * them. Nonzero when it touched */
static inline int32_t MUS__NAME(respond_node)(const mus__collider *collider, const mus__contact_rule *rule,
                                              const MUS__NAME(surfaces) * surfaces, uint64_t in, uint64_t rest,
                                              uint32_t on, int32_t still, const MUS__NAME(query_batch) * batch,
                                              int32_t head, const MUS__NAME(path) * path, MUS__NAME(gaps) * gaps,
                                              MUS__REAL *p, MUS__REAL *w, int64_t *queries)
{
    const MUS__REAL clearance = (MUS__REAL)(rule->clearance - collider->offset);
    MUS__NAME(candidate) candidates[MUS__CANDIDATES_MAX];
    MUS__NAME(gaps) none = {0, 0, 0};
    int32_t count = 0, first = 0, hits = 0;
    for (; in != 0; in &= in - 1) {
        const int32_t l = mus__lowest_bit(in);
        const MUS__NAME(query_result) *answer = head > 0 && batch->answer[head].part == l ? &batch->answer[head] : NULL;
        if (answer != NULL) head = answer->next;
        MUS__NAME(query_part)
        (collider, rule, surfaces, l, still ? NULL : MUS__NAME(motion_of)(surfaces, l), answer, p, gaps, candidates,
         &count, queries);
    }
    MUS__NAME(query_planes)(clearance, surfaces, on, still, p, gaps, candidates, &count, queries);
    for (int32_t i = 1; i < count; i++)
        if (candidates[i].overlap > candidates[first].overlap) first = i;
    if (count == 0 || !(candidates[first].overlap > -(MUS__REAL)MUS__TOUCH_BAND)) return 0;

    /* what it is pushed out of may push it into another surface: that one counts too */
    MUS__REAL from[3], speed[3];
    MUS__NAME(carry_node)(candidates[first].motion, path->from, p, from, speed);
    for (int32_t d = 0; d < 3; d++) speed[d] = w[d] - speed[d];
    const MUS__REAL push = MUS__NAME(push_length)(rule, candidates[first].overlap, speed);
    if (push > (MUS__REAL)MUS__PUSH_FAR)
        for (; rest != 0; rest &= rest - 1) {
            const int32_t l = mus__lowest_bit(rest);
            MUS__NAME(query_part)
            (collider, rule, surfaces, l, still ? NULL : MUS__NAME(motion_of)(surfaces, l), NULL, p, &none, candidates,
             &count, queries);
        }
    MUS__NAME(contact) list[MUS__MANIFOLD_MAX];
    const MUS__NAME(candidate) *only = NULL;
    for (int32_t i = 0; i < count; i++) {
        const MUS__NAME(candidate) *candidate = &candidates[i];
        const MUS__REAL into = push > 0 ? -push * MUS__NAME(dot)(candidate->normal, candidates[first].normal) : 0;
        const int32_t touches =
            candidate->overlap > -(MUS__REAL)MUS__TOUCH_BAND || (i != first && candidate->overlap + into > 0);
        if (!touches || hits == MUS__MANIFOLD_MAX) continue;
        MUS__NAME(contact) *m = &list[hits++];
        m->overlap = candidate->overlap, m->friction = candidate->friction;
        for (int32_t d = 0; d < 3; d++) m->normal[d] = candidate->normal[d];
        only = candidate;
        MUS__NAME(carry_node)(candidate->motion, path->from, p, m->from, m->speed);
    }
    if (hits > 1) {
        MUS__NAME(respond_manifold)(rule, path, list, hits, p, w);
    } else if (only != NULL && only->motion == NULL) {
        MUS__NAME(respond_one)(only->overlap, only->friction, rule, path, only->normal, p, w);
    } else if (only != NULL) {
        const MUS__NAME(path) own = {list->from, path->time, path->slip};
        for (int32_t d = 0; d < 3; d++) w[d] -= list->speed[d];
        MUS__NAME(respond_one)(only->overlap, only->friction, rule, &own, only->normal, p, w);
        for (int32_t d = 0; d < 3; d++) w[d] += list->speed[d];
    }
    return 1;
}
