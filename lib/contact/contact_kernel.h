/*
 * contact_kernel.h: the contact pass, as a template on the floating type (MUS_REAL, MUS_FIELD, MUS_CONTACT, MUS_RUSH).
 *
 * The fields stand `skin` off the body already (contact.c), so depths are taken from there and are small where a node
 * rests: a depth of first order jumps a little from ring to ring, but not at zero. Planes are taken as much off.
 *
 * A node nearer than the clearance is put back along the outward normal, loses its velocity into the skin, and its
 * sliding velocity shrinks by the friction impulse mu |v_n|. The step that led here moved the node along the skin with
 * the velocity it had before the impulse; friction takes back `slip` mu |v_n| of that way too, and no more than all of
 * it, so that what sticks does not creep, and in float not even by rounding. All is relative to the surface: places to
 * where it has carried the node from, velocities to its own there. What touches several surfaces is in meet_kernel.h.
 *
 * Nodes are first held against the boxes of the parts, a block at a time and many nodes at once; only what is in a box
 * is asked of its part. An answer is a distance: until a node has gone an eighth of it, or the surfaces have, that
 * part need not be asked again. An eighth, since the distance is of first order: beside the caps of parts it was found
 * up to five times too far. What a node goes is measured.
 *
 * What a node is pushed out of may push it into what it did not touch before, so that counts as touched too: between an
 * arm and a side a tight cloth would else be thrown from one to the other.
 *
 * What is fast is swept (sweep_kernel.h). Whether paths are measured at all is decided by the speeds after the step
 * before (`swift`).
 */

/* [m] a node this near to the clearance is still on the skin: a float state rounds by as much */
#define TOUCH_BAND 2e-6

#define HELD_BAND (sizeof(MUS_REAL) == sizeof(float) ? 1e-7 : 1e-15) /* [m]: as far off the skin as before */

#define ASIDE_MARGIN 0.04 /* [m]: how far off the body a distance is still taken */
#define ASIDE_GAP 2e-3    /* [m]: a part this far beyond the clearance is not asked for a while */
#define ASIDE_SAFE 8      /* part of the distance that a node may go until then: one in so many */

/* [m]: a node that is pushed farther than this may come to a part that it is not asked of */
#define PUSH_FAR (ASIDE_GAP * (ASIDE_SAFE - 1) / ASIDE_SAFE)

#define SAFE_WAY 0.999 /* part of the safe length: for the rounding of ways */

#define SQUEEZE_MOST 5.0 /* [m/s] out of a wedge that closes */
#define MEET_MOST 8      /* surfaces that a node touches at once; more are left out */
#define MEET_NEAR 16     /* that it is near; of more, those that are farthest are left out */


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


/* one node against one surface that it touches: x, v (3) are corrected in place. If its path is what brought it in, it
 * is put back whole; else it was inside before, and comes out by `push` beyond what springs just pulled it in */
static inline void MUS_FIELD(respond)(MUS_REAL lift, MUS_REAL friction, const mus__contact_rule *rule,
                                      const MUS_FIELD(path) * path, const MUS_REAL *normal, MUS_REAL *x, MUS_REAL *v)
{
    const MUS_REAL vn = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
    const MUS_REAL push = (MUS_REAL)rule->push, inward = vn < 0 ? -vn : 0;
    const MUS_REAL go = path->time * (MUS_REAL)MUS_FIELD(sqrt)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const MUS_REAL move = lift < 0 ? 0 : lift <= push + go ? lift : push + inward * path->slip;
    for (int32_t i = 0; i < 3; i++) x[i] += move * normal[i];
    if (vn < 0) MUS_FIELD(rub)(friction, path, inward, normal, x, v);
}


/* friction of one of several surfaces: its part of the normal impulse, `inward`, takes of the velocity along it and of
 * the way along it. Nonzero when it took all of the way */
static int32_t MUS_FIELD(rub_one)(const MUS_FIELD(meeting) * m, MUS_REAL inward, MUS_REAL slip, MUS_REAL *x,
                                  MUS_REAL *v)
{
    MUS_REAL t[3], way[3];
    for (int32_t d = 0; d < 3; d++) t[d] = v[d] - m->speed[d], way[d] = x[d] - m->from[d];
    const MUS_REAL out = MUS_FIELD(dot)(t, m->normal), along = MUS_FIELD(dot)(way, m->normal);
    for (int32_t d = 0; d < 3; d++) t[d] -= out * m->normal[d], way[d] -= along * m->normal[d];
    const MUS_REAL speed = (MUS_REAL)MUS_FIELD(sqrt)(MUS_FIELD(dot)(t, t));
    const MUS_REAL length = (MUS_REAL)MUS_FIELD(sqrt)(MUS_FIELD(dot)(way, way));
    const MUS_REAL loss = m->friction * inward, back = slip > 0 ? loss * slip : 0;
    const MUS_REAL keep = speed > loss ? (speed - loss) / speed : 0, part = length > back ? back / length : 1;
    for (int32_t d = 0; d < 3; d++) v[d] -= (1 - keep) * t[d], x[d] -= part * way[d];
    return part == 1;
}


#include "contact/pinch_kernel.h"


/* one node against the several surfaces that it touches, in place */
static void MUS_FIELD(respond_all)(const mus__contact_rule *rule, const MUS_FIELD(path) * path,
                                   const MUS_FIELD(meeting) * list, int32_t count, MUS_REAL *x, MUS_REAL *v)
{
    const MUS_REAL start[3] = {x[0], x[1], x[2]};
    MUS_REAL wish[MEET_MOST], share[MEET_MOST], move[3], way[3], fast2 = 0, off2 = 0;
    int32_t rubbed = 0, all = 0;
    const int32_t pinched = rule->pull > 0.0 && MUS_FIELD(pinched)(list, count, x);

    /* velocities, with no more than the node has; then friction, which takes of the way too */
    for (int32_t i = 0; i < count; i++) {
        MUS_REAL w[3];
        for (int32_t d = 0; d < 3; d++) w[d] = v[d] - list[i].speed[d];
        const MUS_REAL w2 = MUS_FIELD(dot)(w, w);
        wish[i] = -MUS_FIELD(dot)(w, list[i].normal);
        if (w2 > fast2) fast2 = w2;
    }
    const MUS_REAL fast = (MUS_REAL)MUS_FIELD(sqrt)(fast2);
    MUS_FIELD(out_of_all)(list, count, wish, (MUS_REAL)SQUEEZE_MOST, move, share);
    const MUS_REAL squeeze = (MUS_REAL)MUS_FIELD(sqrt)(MUS_FIELD(dot)(move, move));
    MUS_FIELD(out_of_all)(list, count, wish, fast, move, share);
    for (int32_t d = 0; d < 3; d++) v[d] += move[d];
    for (int32_t i = 0; i < count; i++) {
        if (!(share[i] > 0) || pinched) continue;
        rubbed++;
        all += MUS_FIELD(rub_one)(&list[i], share[i], path->slip, x, v);
    }

    /* places: out at once when the path of the step brought the node in, else by `push` beyond what springs did and
     * what a wedge that closes drives out */
    const MUS_REAL most = (MUS_REAL)rule->push + fast * path->slip + squeeze * path->time;
    for (int32_t d = 0; d < 3; d++) way[d] = x[d] - start[d];
    for (int32_t i = 0; i < count; i++) wish[i] = list[i].lift - MUS_FIELD(dot)(way, list[i].normal);
    MUS_FIELD(out_of_all)(list, count, wish, most, move, share);
    const MUS_REAL far = (MUS_REAL)MUS_FIELD(sqrt)(MUS_FIELD(dot)(move, move));
    const MUS_REAL scale = far <= (MUS_REAL)rule->push + path->time * fast ? 1 : most / far;
    const int32_t out = pinched && far > (MUS_REAL)PINCH_NEAR;
    if (out) MUS_FIELD(let_out)(rule, path->time, move, far, v);
    for (int32_t d = 0; d < 3 && !out; d++) x[d] += scale * move[d];

    /* one that sticks and is where it was is put back to the last bit */
    for (int32_t d = 0; d < 3; d++) off2 += (x[d] - list->from[d]) * (x[d] - list->from[d]);
    if (rubbed == 0 || all < rubbed || off2 > (MUS_REAL)(HELD_BAND * HELD_BAND)) return;
    for (int32_t d = 0; d < 3; d++) x[d] = list->from[d];
}


/* nonzero when p is in the box (6) */
static inline int32_t MUS_FIELD(boxed)(const MUS_REAL *box, const MUS_REAL *p)
{
    return !(p[0] < box[0] || p[0] > box[3] || p[1] < box[1] || p[1] > box[4] || p[2] < box[2] || p[2] > box[5]);
}


/* the parts whose box p is in, a bit each */
static uint64_t MUS_FIELD(boxes_of)(int32_t nlimb, const MUS_REAL *box, const MUS_REAL *p)
{
    uint64_t in = 0;
    for (int32_t l = 0; l < nlimb; l++) in |= (uint64_t)MUS_FIELD(boxed)(box + 6 * l, p) << l;
    return in;
}


#include "contact/ask_kernel.h"


/* a surface that a node was asked of: `lift` above 0 where it is nearer than the clearance */
typedef struct MUS_FIELD(side) {
    MUS_REAL lift, friction, normal[3];
    const MUS_FIELD(way) * way;
} MUS_FIELD(side);


/* how far surfaces are beyond the clearance: the nearest of all, and of the parts that are farther than ASIDE_GAP
 * which they are and the nearest */
typedef struct MUS_FIELD(gaps) {
    MUS_REAL all, some;
    uint64_t far;
} MUS_FIELD(gaps);


static inline void MUS_FIELD(gap)(MUS_FIELD(gaps) * gaps, int32_t part, MUS_REAL gap)
{
    if (gap < gaps->all) gaps->all = gap;
    if (!(gap > (MUS_REAL)ASIDE_GAP)) return;
    gaps->far |= (uint64_t)1 << part;
    if (gap < gaps->some) gaps->some = gap;
}


/* room for one more side: on the list of MEET_NEAR, or where the farthest is, if that is beyond `lift`, or NULL */
static inline MUS_FIELD(side) * MUS_FIELD(new_side)(MUS_FIELD(side) * sides, int32_t *count, MUS_REAL lift)
{
    if (*count < MEET_NEAR) return &sides[(*count)++];
    int32_t least = 0;
    for (int32_t i = 1; i < MEET_NEAR; i++)
        if (sides[i].lift < sides[least].lift) least = i;
    return sides[least].lift < lift ? &sides[least] : NULL;
}


/* part l asked of a node, or the answer that it has: on the list of sides when it is near */
static inline void MUS_FIELD(ask_side)(const mus__collider *collider, const mus__contact_rule *rule,
                                       const MUS_FIELD(scene) * scene, int32_t l, const MUS_FIELD(way) * way,
                                       const MUS_FIELD(answer) * answer, const MUS_REAL *p, MUS_FIELD(gaps) * gaps,
                                       MUS_FIELD(side) * sides, int32_t *count, int64_t *queries)
{
    const MUS_REAL clearance = (MUS_REAL)(rule->clearance - collider->skin);
    int32_t near = 1;
    MUS_REAL depth, normal[3];
    if (answer != NULL) {
        depth = answer->depth;
    } else {
        depth = MUS_FIELD(query)(&collider->MUS_FIELDS[l], p, scene->margin, normal, &near);
        (*queries)++;
    }
    MUS_FIELD(gap)(gaps, l, (near != 0 ? -depth : scene->margin) - clearance);
    MUS_FIELD(side) *side = near != 0 ? MUS_FIELD(new_side)(sides, count, depth + clearance) : NULL;
    if (side == NULL) return;
    side->lift = depth + clearance;
    side->friction = (MUS_REAL)rule->friction;
    for (int32_t d = 0; d < 3; d++) side->normal[d] = answer != NULL ? answer->normal[d] : normal[d];
    side->way = way;
}


/* the planes `on` asked of a node, as parts are */
static inline void MUS_FIELD(ask_flats)(MUS_REAL clearance, const MUS_FIELD(scene) * scene, uint32_t on, int32_t still,
                                        const MUS_REAL *p, MUS_FIELD(gaps) * gaps, MUS_FIELD(side) * sides,
                                        int32_t *count, int64_t *queries)
{
    for (int32_t k = 0; on != 0; k++, on >>= 1) {
        if ((on & 1) == 0) continue;
        int32_t near;
        const MUS_FIELD(flat) *flat = &scene->flat[k];
        const MUS_REAL depth = MUS_FIELD(flat_depth)(flat, p, scene->margin, &near);
        (*queries)++;
        if (-depth - clearance < gaps->all) gaps->all = -depth - clearance;
        MUS_FIELD(side) *side = near ? MUS_FIELD(new_side)(sides, count, depth + clearance) : NULL;
        if (side == NULL) continue;
        side->lift = depth + clearance;
        side->friction = flat->friction;
        for (int32_t d = 0; d < 3; d++) side->normal[d] = flat->normal[d];
        side->way = still || !flat->moving ? NULL : &flat->way;
    }
}


/* how far respond() moves a node at most that goes with w (3) against the surface, which is to lift it by `lift` */
static inline MUS_REAL MUS_FIELD(push_far)(const mus__contact_rule *rule, MUS_REAL lift, const MUS_REAL *w)
{
    const MUS_REAL fast = (MUS_REAL)MUS_FIELD(sqrt)(MUS_FIELD(dot)(w, w)), push = (MUS_REAL)rule->push;
    return lift <= push + (MUS_REAL)rule->step * fast ? lift : push + (MUS_REAL)rule->slip * fast;
}


/* one node against the parts `in` and the planes `on`, in place; `still`: as if all were at rest. `rest`: parts whose
 * boxes it is in and that are too far off to touch it, but not too far to stop it when it is pushed. `asking` (may be
 * NULL) has answers for it from `head` on; gaps (which the caller starts) gets lower bounds of the node's distance to
 * them. Nonzero when it touched */
static inline int32_t MUS_FIELD(touch)(const mus__collider *collider, const mus__contact_rule *rule,
                                       const MUS_FIELD(scene) * scene, uint64_t in, uint64_t rest, uint32_t on,
                                       int32_t still, const MUS_FIELD(asking) * asking, int32_t head,
                                       const MUS_FIELD(path) * path, MUS_FIELD(gaps) * gaps, MUS_REAL *p, MUS_REAL *w,
                                       int64_t *queries)
{
    const MUS_REAL clearance = (MUS_REAL)(rule->clearance - collider->skin);
    MUS_FIELD(side) sides[MEET_NEAR];
    MUS_FIELD(gaps) none = {0, 0, 0};
    int32_t count = 0, first = 0, hits = 0;
    for (; in != 0; in &= in - 1) {
        const int32_t l = mus__lowest_bit(in);
        const MUS_FIELD(answer) *answer = head > 0 && asking->answer[head].part == l ? &asking->answer[head] : NULL;
        if (answer != NULL) head = answer->next;
        MUS_FIELD(ask_side)
        (collider, rule, scene, l, still ? NULL : MUS_FIELD(way_of)(scene, l), answer, p, gaps, sides, &count, queries);
    }
    MUS_FIELD(ask_flats)(clearance, scene, on, still, p, gaps, sides, &count, queries);
    for (int32_t i = 1; i < count; i++)
        if (sides[i].lift > sides[first].lift) first = i;
    if (count == 0 || !(sides[first].lift > -(MUS_REAL)TOUCH_BAND)) return 0;

    /* what it is pushed out of may push it into another surface: that one counts too */
    MUS_REAL from[3], speed[3];
    MUS_FIELD(carry)(sides[first].way, path->from, p, from, speed);
    for (int32_t d = 0; d < 3; d++) speed[d] = w[d] - speed[d];
    const MUS_REAL push = MUS_FIELD(push_far)(rule, sides[first].lift, speed);
    if (push > (MUS_REAL)PUSH_FAR)
        for (; rest != 0; rest &= rest - 1) {
            const int32_t l = mus__lowest_bit(rest);
            MUS_FIELD(ask_side)
            (collider, rule, scene, l, still ? NULL : MUS_FIELD(way_of)(scene, l), NULL, p, &none, sides, &count,
             queries);
        }
    MUS_FIELD(meeting) list[MEET_MOST];
    const MUS_FIELD(side) *only = NULL;
    for (int32_t i = 0; i < count; i++) {
        const MUS_FIELD(side) *side = &sides[i];
        const MUS_REAL into = push > 0 ? -push * MUS_FIELD(dot)(side->normal, sides[first].normal) : 0;
        const int32_t touches = side->lift > -(MUS_REAL)TOUCH_BAND || (i != first && side->lift + into > 0);
        if (!touches || hits == MEET_MOST) continue;
        MUS_FIELD(meeting) *m = &list[hits++];
        m->lift = side->lift, m->friction = side->friction;
        for (int32_t d = 0; d < 3; d++) m->normal[d] = side->normal[d];
        only = side;
        MUS_FIELD(carry)(side->way, path->from, p, m->from, m->speed);
    }
    if (hits > 1) {
        MUS_FIELD(respond_all)(rule, path, list, hits, p, w);
    } else if (only != NULL && only->way == NULL) {
        MUS_FIELD(respond)(only->lift, only->friction, rule, path, only->normal, p, w);
    } else if (only != NULL) {
        const MUS_FIELD(path) own = {list->from, path->time, path->slip};
        for (int32_t d = 0; d < 3; d++) w[d] -= list->speed[d];
        MUS_FIELD(respond)(only->lift, only->friction, rule, &own, only->normal, p, w);
        for (int32_t d = 0; d < 3; d++) w[d] += list->speed[d];
    }
    return 1;
}


#include "contact/sweep_kernel.h"


/* ---- the pass ---- */

/* parts first .. last-1, at most 32: a bit in in (count) for each whose box a node is in; far (count) gets the largest
 * of carried (last) of those, if it is larger */
MUS_CLONES
static void MUS_FIELD(look)(const MUS_FIELD(scene) * scene, int32_t first, int32_t last, const MUS_REAL *carried,
                            int64_t n, int32_t count, const MUS_REAL *restrict x, uint32_t *restrict in,
                            MUS_REAL *restrict far)
{
    for (int32_t i = 0; i < count; i++) in[i] = 0;
    for (int32_t l = first; l < last; l++) {
        const MUS_REAL *b = scene->box + 6 * l, b0 = b[0], b1 = b[1], b2 = b[2], b3 = b[3], b4 = b[4], b5 = b[5];
        const uint32_t bit = (uint32_t)1 << (l - first);
        const MUS_REAL own = carried[l];
        MUS_IVDEP
        for (int32_t i = 0; i < count; i++) {
            const MUS_REAL p0 = x[i], p1 = x[n + i], p2 = x[2 * n + i];
            const uint32_t inside = (p0 >= b0) & (p0 <= b3) & (p1 >= b1) & (p1 <= b4) & (p2 >= b2) & (p2 <= b5);
            const MUS_REAL most = own > far[i] ? own : far[i];
            in[i] |= inside * bit;
            far[i] = inside != 0 ? most : far[i];
        }
    }
}


/* planes: a bit in on (count) for each that a node is not farther above than the margin */
MUS_CLONES
static void MUS_FIELD(look_down)(const MUS_FIELD(scene) * scene, int64_t n, int32_t count, const MUS_REAL *restrict x,
                                 uint32_t *restrict on)
{
    for (int32_t i = 0; i < count; i++) on[i] = 0;
    for (int32_t k = 0; k < scene->nplane; k++) {
        const MUS_REAL *normal = scene->flat[k].normal, a = normal[0], b = normal[1], c = normal[2];
        const MUS_REAL top = scene->flat[k].start + scene->margin;
        const uint32_t bit = (uint32_t)1 << k;
        MUS_IVDEP
        for (int32_t i = 0; i < count; i++) {
            const uint32_t below = a * x[i] + b * x[n + i] + c * x[2 * n + i] <= top;
            on[i] |= below * bit;
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


/* how far surfaces may have gone since the last call: all of them, and of a body that turns each part beyond that. Of
 * parts a node counts those in whose boxes it is: others are farther off than what it may go until it is asked again */
typedef struct MUS_FIELD(carries) {
    MUS_REAL rest, part[MUS_LIMBS_MOST], most;
} MUS_FIELD(carries);


static void MUS_FIELD(fill_carries)(const mus__collider *collider, const mus__contact_rule *rule,
                                    MUS_FIELD(carries) * carries)
{
    const double rest = mus__contact_carried(collider, rule, collider->plane_haste);
    carries->rest = (MUS_REAL)rest;
    carries->most = 0;
    for (int32_t l = 0; l < collider->nlimb; l++) {
        carries->part[l] = (MUS_REAL)fmax(mus__contact_carried(collider, rule, collider->home[l].haste) - rest, 0.0);
        if (carries->part[l] > carries->most) carries->most = carries->part[l];
    }
}


/* to gone (count), which has how far the part went that did farthest beyond the rest, how far the node and the rest
 * have gone since the last call */
MUS_CLONES
static void MUS_FIELD(wander)(MUS_REAL carried, int64_t n, int32_t count, const MUS_REAL *restrict before,
                              const MUS_REAL *restrict x, MUS_REAL *restrict gone)
{
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL d0 = x[i] - before[i], d1 = x[n + i] - before[n + i], d2 = x[2 * n + i] - before[2 * n + i];
        gone[i] = gone[i] + carried + (MUS_REAL)MUS_FIELD(sqrt)(d0 * d0 + d1 * d1 + d2 * d2);
    }
}


#include "contact/lone_kernel.h"


/* node i, which is in the boxes `boxes`, of which `in` are to be asked, and near the planes `on`, or may have to be
 * swept; `asking` and `head` as of touch */
static void MUS_FIELD(meet_node)(const mus__collider *collider, const mus__contact_rule *rule,
                                 const MUS_FIELD(scene) * scene, int32_t n, int32_t i, uint64_t boxes, uint64_t in,
                                 uint32_t on, int32_t sweeps, const MUS_FIELD(asking) * asking, int32_t head,
                                 const MUS_REAL *inverse, const MUS_REAL *before, mus__aside *aside, MUS_REAL *x,
                                 MUS_REAL *v, mus__contact_tally *tally)
{
    const int64_t at[3] = {i, n + i, 2 * (int64_t)n + i};
    const MUS_REAL gap = scene->margin - (MUS_REAL)(rule->clearance - collider->skin);
    MUS_REAL p[3], w[3], from[3], moved = 0;
    int32_t touched = 0;
    for (int32_t d = 0; d < 3; d++) p[d] = x[at[d]], w[d] = v[at[d]], from[d] = before[at[d]];
    const uint64_t parts = in;
    const uint32_t planes = on;
    if (sweeps) touched = MUS_FIELD(sweep_all)(collider, rule, scene, &in, &on, from, p, w, &tally->queries);
    const int32_t swept = in != parts || on != planes;

    /* parts that were asked already and are not near are as far as a distance is taken */
    MUS_FIELD(gaps) gaps = {gap, gap, boxes & ~in & (((uint64_t)1 << ASIDE_PARTS) - 1)};

    /* what a sweep took out of one part may be in another */
    if (swept && touched) in = MUS_FIELD(boxes_of)(collider->nlimb, scene->box, p);
    if (in != 0 || on != 0) {
        const MUS_FIELD(path) path = {from, (MUS_REAL)rule->step, (MUS_REAL)(swept ? 0.0 : rule->slip)};
        touched |=
            MUS_FIELD(touch)(collider, rule, scene, in, swept ? 0 : boxes & ~in, on, 0, asking, head, &path, &gaps,
                             p, w, &tally->queries);
    }
    for (int32_t d = 0; touched && d < 3; d++) moved += (p[d] - x[at[d]]) * (p[d] - x[at[d]]);
    if (aside->slack <= 0 && !swept) MUS_FIELD(set_aside)(&gaps, moved, aside);
    if (!touched) return;
    const double mass = 1.0 / (double)inverse[i];
    for (int32_t d = 0; d < 3; d++) {
        tally->impulse[d] += ((double)w[d] - (double)v[at[d]]) * mass;
        x[at[d]] = p[d];
        v[at[d]] = w[d];
    }
}


/* a block of nodes that are not swept: boxes (count) and in (count) a bit for each part whose box a node is in, and
 * that is to be asked; on (count) of the planes */
static void MUS_FIELD(meet_block)(const mus__collider *collider, const mus__contact_rule *rule,
                                  const MUS_FIELD(scene) * scene, int32_t n, int32_t start, int32_t count,
                                  const uint64_t *boxes, uint64_t *in, const uint32_t *on, const uint8_t *skip,
                                  const MUS_REAL *inverse, const MUS_REAL *before, mus__aside *aside, MUS_REAL *x,
                                  MUS_REAL *v, mus__contact_tally *tally)
{
    const MUS_REAL clearance = (MUS_REAL)(rule->clearance - collider->skin);
    MUS_FIELD(asking) asking;
    MUS_FIELD(lone) lone;
    MUS_FIELD(ask_block)(collider, scene->margin, n, count, x + start, in, &asking, &tally->queries);
    lone.count = 0;
    for (int32_t i = 0; i < count; i++) {
        mus__aside *own = &aside[start + i];
        lone.kind[i] = LONE_NOTHING;
        if (skip[i] || (on[i] == 0 && (boxes[i] == 0 || (in[i] == 0 && own->slack > 0)))) continue;
        lone.kind[i] = on[i] != 0 ? LONE_ODD
                                  : (uint8_t)MUS_FIELD(sort_node)(rule, scene, clearance, n, start, i, boxes[i], in[i],
                                                                  &asking, before, x, v, own, &lone);
    }
    MUS_FIELD(respond_many)
    ((MUS_REAL)rule->friction, (MUS_REAL)rule->push, (MUS_REAL)rule->step, (MUS_REAL)rule->slip, lone.count, lone.lift,
     lone.normal, lone.from, lone.x, lone.v, lone.moved);
    for (int32_t i = 0, m = 0; i < count; i++) {
        mus__aside *own = &aside[start + i];
        if (lone.kind[i] == LONE_ONE)
            MUS_FIELD(put_lone)(&lone, m++, scene->moving, n, start + i, inverse[start + i], own, x, v, tally);
        if (lone.kind[i] == LONE_ODD)
            MUS_FIELD(meet_node)
            (collider, rule, scene, n, start + i, boxes[i], in[i], on[i], 0, &asking, asking.head[i], inverse, before,
             own, x, v, tally);
    }
}


void MUS_CONTACT(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first, int32_t last,
                 const MUS_REAL *inverse, const MUS_REAL *before, int32_t sweeps, mus__aside *aside, MUS_REAL *x,
                 MUS_REAL *v, mus__contact_tally *tally)
{
    MUS_FIELD(scene) scene;
    const int32_t nlimb = collider->nlimb;
    const MUS_REAL margin =
        (MUS_REAL)(rule->clearance - collider->skin) + (MUS_REAL)TOUCH_BAND + (MUS_REAL)ASIDE_MARGIN;
    MUS_FIELD(fill_scene)(collider, rule, margin, &scene);

    if (MUS_RUSH(collider, rule, n, first, last, v)) tally->swift = 1;
    MUS_FIELD(carries) carries;
    MUS_FIELD(fill_carries)(collider, rule, &carries);
    uint32_t low[ASK_BLOCK], high[ASK_BLOCK] = {0}, on[ASK_BLOCK] = {0};
    uint64_t boxes[ASK_BLOCK], in[ASK_BLOCK];
    MUS_REAL gone[ASK_BLOCK];
    uint8_t skip[ASK_BLOCK];
    for (int32_t start = first; start < last; start += ASK_BLOCK) {
        const int32_t count = last - start < ASK_BLOCK ? last - start : ASK_BLOCK;
        uint64_t any = 0;
        MUS_REAL way = 0;
        for (int32_t i = 0; i < count; i++) gone[i] = 0;
        MUS_FIELD(look)(&scene, 0, nlimb < 32 ? nlimb : 32, carries.part, n, count, x + start, low, gone);
        if (nlimb > 32) MUS_FIELD(look)(&scene, 32, nlimb, carries.part, n, count, x + start, high, gone);
        if (scene.nplane > 0) MUS_FIELD(look_down)(&scene, n, count, x + start, on);
        MUS_FIELD(wander)(carries.rest, n, count, before + start, x + start, gone);
        for (int32_t i = 0; i < count; i++) {
            mus__aside *own = &aside[start + i];
            boxes[i] = in[i] = low[i] | (uint64_t)high[i] << 32;
            own->slack -= (float)gone[i];
            if (!(gone[i] <= way)) way = gone[i];
            skip[i] = inverse[start + i] == 0;

            /* what it is too far from to have come to is not asked */
            if (own->slack > 0 && own->parts == ASIDE_ALL) skip[i] = 1;
            else if (own->slack > 0) in[i] &= ~(uint64_t)own->parts;
            if (skip[i]) in[i] = 0;
            any |= in[i] | (skip[i] ? 0 : on[i]);
        }

        /* a block of which no node went so far against any surface is not swept */
        const int32_t swept = sweeps != 0 && !(way + carries.most <= (MUS_REAL)(SAFE_WAY * collider->safe));
        if (any == 0 && !swept) continue;
        if (!swept) {
            MUS_FIELD(meet_block)
            (collider, rule, &scene, n, start, count, boxes, in, on, skip, inverse, before, aside, x, v, tally);
            continue;
        }
        for (int32_t i = 0; i < count; i++)
            if (!skip[i])
                MUS_FIELD(meet_node)
                (collider, rule, &scene, n, start + i, boxes[i], in[i], on[i], sweeps, NULL, 0, inverse, before,
                 &aside[start + i], x, v, tally);
    }
}
