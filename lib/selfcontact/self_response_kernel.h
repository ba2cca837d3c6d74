/*
 * self_response_kernel.h: self_contact.h as a template on the floating type (MUS__REAL, MUS__NAME): the impulses of the
 * active pairs, and the calls.
 *
 * All loops over pairs are in the order of the list, on one thread: the next pair sees what a pair gave its nodes (a
 * Gauss-Seidel sweep a call), and the bytes do not depend on the number of threads.
 */

#define MUS__BOUND_SHARE 0.45 /* bound over the distance of an active pair; below a half, see self_contact.h */
/* bound over the distance beyond the thickness of other pairs, which therefore do not come to it unseen; below a
 * half */
#define MUS__BOUND_APPROACH 0.45
/* squared way of a node over its squared bound at which all bounds are computed again; chosen: below 1, so that few
 * nodes are held at their bound; a smaller value computes bounds more often */
#define MUS__BOUND_RENEW 0.64
/* time that drifting bounds are made for over the time that the last ones lasted; chosen: it doubles at most */
#define MUS__BOUND_LONGER 2.0
#define MUS__BOUND_STEPS_MIN 2.0   /* [steps] least time of drifting bounds; chosen: for less, drifts do not pay */
#define MUS__BOUND_DRIFT_SHARE 0.5 /* largest share of a pair's limit for drifts; chosen: the rest is left for motion */
/* [thicknesses] pairs nearer than this are active until bounds are computed again; chosen: more costs time, less makes
 * bounds smaller */
#define MUS__ACTIVE_DISTANCE 2.0
/* of the squared travel that leaves a pair apart; a pair whose nodes travelled less is not asked. Below 1 by more
 * than rounding */
#define MUS__IDLE_SHARE 0.99
/* [margins] with less left for a node the list is made anew; chosen: a larger value makes lists more often */
#define MUS__LIST_RENEW 0.3
/* of the thickness: cloth no further beyond it rests on cloth. Small, for beside an edge cloth is that far off at
 * an angle of the root of twice this (3.6 degrees) */
#define MUS__REST_BAND 0.002
/* share of an overlap that is moved apart in one call; chosen: more adds energy to springs, less leaves overlaps longer
 */
#define MUS__PUSH_SHARE 0.05
/* of the impulse of the last call that a pair gives at once (warm start, Catto 2006); chosen, below 1 so that a
 * load that has gone falls to a third in ten calls */
#define MUS__WARM_START 0.9
/* least weight of a node in a pair that it bears on; chosen: less carries no load that counts */
#define MUS__WEIGHT_BEARS 0.05
/* cosine of the angle between support and push, 60 degrees, up to which a node counts as supported; chosen: a larger
 * angle counts sideward pushes as support */
#define MUS__SUPPORT_FACING 0.5

#include "selfcontact/pair_distance_kernel.h"
#include "selfcontact/neighbour_list_kernel.h"
#include "selfcontact/active_pairs_kernel.h"
#include "selfcontact/displacement_bound_kernel.h"


/* ---- rank: what supports a node ---- */

/*
 * Shock propagation (Guendelman, Bridson, Fedkiw, Nonconvex rigid bodies with stacking, 2003). A layer that lies on the
 * body hands on what it gets from the layers on it: the body takes it before the next call. In a pair such a layer
 * counts as held, and the other one gets all of the impulse; else a pile would sink by half of the impulse in each
 * step. A layer is held when the body pushed its nodes in this step, or a layer that is held did in the last call,
 * against the direction in which this pair pushes them. The rank is the number of layers between a node and the body.
 */

/* rank of the nodes first .. last-1 of a pair that bear on it, which pushes them along `sign` times the normal: the
 * largest, or MUS__RANK_NONE when one is not supported against that push */
static inline int32_t MUS__NAME(self_rank_of)(const mus__self_contact *self, const int32_t *node,
                                              const MUS__REAL *weight, int32_t first, int32_t last, MUS__REAL sign,
                                              const MUS__REAL *normal)
{
    const int64_t n = self->n;
    const MUS__REAL *support = self->support;
    int32_t rank = 0;
    for (int32_t i = first; i < last; i++) {
        const int32_t k = node[i], now = self->last_rank[k] < self->rank[k] ? self->last_rank[k] : self->rank[k];
        if (weight[i] < (MUS__REAL)MUS__WEIGHT_BEARS && weight[i] > -(MUS__REAL)MUS__WEIGHT_BEARS) continue;
        if (now == MUS__RANK_NONE) return now;
        const MUS__REAL along = support[k] * normal[0] + support[n + k] * normal[1] + support[2 * n + k] * normal[2];
        if (!(sign * along < -(MUS__REAL)MUS__SUPPORT_FACING)) return MUS__RANK_NONE;
        rank = now > rank ? now : rank;
    }
    return rank;
}


/* the nodes first .. last-1 are supported by a layer of `rank`, which pushes them along `sign` times the normal */
static inline void MUS__NAME(self_rank_set)(mus__self_contact *self, const int32_t *node, int32_t first, int32_t last,
                                            int32_t rank, MUS__REAL sign, const MUS__REAL *normal)
{
    const int64_t n = self->n;
    MUS__REAL *support = self->support;
    for (int32_t i = first; i < last && rank < MUS__RANK_MAX; i++) {
        const int32_t k = node[i];
        if (self->rank[k] <= rank + 1) continue;
        self->rank[k] = (uint8_t)(rank + 1);
        for (int32_t d = 0; d < 3; d++) support[d * n + k] = sign * normal[d];
    }
}


/* nodes of active pairs that the body pushed in this step (v differs from `before`) get rank 0 and the push's direction
 * as support; others lose their rank and keep the direction */
MUS_CLONES
static void MUS__NAME(self_rank_body)(int64_t n, int32_t count, const uint8_t *restrict near,
                                      const MUS__REAL *restrict v, const MUS__REAL *restrict before,
                                      uint8_t *restrict rank, MUS__REAL *restrict support)
{
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL push0 = v[i] - before[i], push1 = v[n + i] - before[n + i];
        const MUS__REAL push2 = v[2 * n + i] - before[2 * n + i];
        const MUS__REAL all = push0 * push0 + push1 * push1 + push2 * push2;
        const int32_t held = (near[i] != 0) & (all > 0);
        const MUS__REAL was0 = support[i], was1 = support[n + i], was2 = support[2 * n + i];
        const MUS__REAL length = (MUS__REAL)MUS__NAME(sqrt)(held ? all : 1);
        rank[i] = held ? 0 : MUS__RANK_NONE;
        support[i] = held ? push0 / length : was0;
        support[n + i] = held ? push1 / length : was1;
        support[2 * n + i] = held ? push2 / length : was2;
    }
}


static void MUS__NAME(self_rank_start)(mus__self_contact *self, const mus__self_rule *rule, const MUS__REAL *v)
{
    uint8_t *const was = self->last_rank;
    self->last_rank = self->rank;
    self->rank = was;
    if (rule->body) MUS__NAME(self_rank_body)
    (self->n, self->nodes, self->active_node, v, self->before_body, self->rank, self->support);
    else memset(self->rank, MUS__RANK_NONE, (size_t)self->nodes);
}


/* an active pair as it lies now: weights of its nodes, unit normal from its second thing to its first, overlap [m] */
typedef struct MUS__NAME(self_contact_pair) {
    const int32_t *node;
    int32_t split;              /* nodes of the first thing: 1 or 2 */
    int32_t still, still_after; /* nodes from `still` to still_after - 1 get impulses and no move; none where equal */
    MUS__REAL weight[4], normal[3], overlap;
} MUS__NAME(self_contact_pair);


/*
 * Of a pair of ranks one and two, the layer that lies on the body gets no move when nothing supports the other. What
 * an impulse moves it in the next step the body takes back, and no more than that: with a move besides, cloth under
 * other cloth that is drawn tight sinks into the body. Nor does it move back when some of the impulse is taken back:
 * given by the warm start and taken by the answer, step after step, that would carry it away. Where the other layer is
 * supported too, as between the legs, both move: a layer that is pressed into the body tells that there is no room, and
 * thickness yields.
 */
static inline void MUS__NAME(self_pair_still)(MUS__NAME(self_contact_pair) * pair, int32_t one, int32_t two)
{
    const int32_t first = one == 0 && two == MUS__RANK_NONE, second = two == 0 && one == MUS__RANK_NONE;
    pair->still = second ? pair->split : 0;
    pair->still_after = second ? 4 : first ? pair->split : 0;
}


/* fills *pair from an active one; not where its things are out of reach and it gave no impulse. Nonzero when they are
 * nearer than the thickness, or within the rest band */
static inline int32_t MUS__NAME(self_pair_lies)(const mus__self_contact *self, const mus__self_active *active,
                                                const MUS__REAL *x, MUS__NAME(self_contact_pair) * pair)
{
    const MUS__REAL t = (MUS__REAL)active->thickness, reach = (MUS__REAL)(1.0 + MUS__REST_BAND) * t;
    const int32_t edges = active->pair >= self->nnode_pair;
    MUS__REAL p[4][3], *weight = pair->weight;
    pair->node = active->node;
    pair->split = 1 + edges;
    MUS__NAME(self_pair_places)(x, self->n, pair->node, p);
    const MUS__REAL d2 = MUS__NAME(self_pair_measure)(edges, p, weight);
    const int32_t lies = d2 > 0 && d2 < reach * reach;
    pair->overlap = t;
    if (!lies && !(d2 > 0 && active->impulse > 0)) return 0;
    const MUS__REAL apart = (MUS__REAL)MUS__NAME(sqrt)(d2);
    pair->overlap = t - apart;
    for (int32_t d = 0; d < 3; d++)
        pair->normal[d] =
            (weight[0] * p[0][d] + weight[1] * p[1][d] + weight[2] * p[2][d] + weight[3] * p[3][d]) / apart;
    return lies;
}


/* gives the nodes of a pair an impulse and, but those that stay, a move per inverse mass (3 each) */
static inline void MUS__NAME(self_pair_apply)(mus__self_contact *self, const MUS__NAME(self_contact_pair) * pair,
                                              const MUS__REAL *inverse, const MUS__REAL *impulse, const MUS__REAL *move,
                                              MUS__REAL *x, MUS__REAL *v)
{
    const int64_t n = self->n;
    MUS__REAL *force = self->force, *off = self->travel2;
    for (int32_t i = 0; i < 4; i++) {
        const MUS__REAL weight = pair->weight[i], moved = weight * inverse[pair->node[i]];
        const MUS__REAL goes = i >= pair->still && i < pair->still_after ? 0 : moved;
        for (int32_t d = 0; d < 3; d++) {
            const int64_t at = d * n + pair->node[i];
            v[at] += moved * impulse[d];
            x[at] += goes * move[d];
            force[at] += weight * impulse[d];
        }
        off[pair->node[i]] =
            MUS__NAME(self_travel2)(n, pair->node[i], (MUS__REAL)self->bound_age, self->bound, self->drift, x);
    }
}


/* warm start: gives a share of the impulse of the last call, along the normal of now, and across it all of its
 * friction, which the answer keeps within mu times the normal's. A share of it would let the rest slip in each call */
static void MUS__NAME(self_pair_warm_start)(mus__self_contact *self, const mus__self_rule *rule,
                                            const MUS__REAL *inverse, mus__self_active *active, MUS__REAL *x,
                                            MUS__REAL *v)
{
    MUS__NAME(self_contact_pair) pair;
    if (!MUS__NAME(self_pair_lies)(self, active, x, &pair)) return;
    active->impulse *= (float)MUS__WARM_START;
    MUS__REAL impulse[3], move[3], along = 0;
    for (int32_t d = 0; d < 3; d++) along += (MUS__REAL)active->tangential[d] * pair.normal[d];
    for (int32_t d = 0; d < 3; d++) {
        const MUS__REAL across = (MUS__REAL)active->tangential[d] - along * pair.normal[d];
        active->tangential[d] = (float)across;
        impulse[d] = (MUS__REAL)active->impulse * pair.normal[d] + across;
        move[d] = (MUS__REAL)rule->slip * (pair.overlap > 0 ? impulse[d] : across);
    }
    const int32_t one = MUS__NAME(self_rank_of)(self, pair.node, pair.weight, 0, pair.split, 1, pair.normal);
    const int32_t two = MUS__NAME(self_rank_of)(self, pair.node, pair.weight, pair.split, 4, -1, pair.normal);
    MUS__NAME(self_pair_still)(&pair, one, two);
    MUS__NAME(self_pair_apply)(self, &pair, inverse, impulse, move, x, v);
}


/*
 * Solves for the change of the pair's impulses: along the normal the total stays >= 0, and across it friction, which
 * ends the sliding, is at most mu times that. The total of friction stands from call to call too: with friction from
 * the sliding of each call alone, what a call leaves of it in a heap of pairs is never made up for, and folds that
 * friction holds creep by some mm/s.
 *
 * No impact is followed by a bounce. The impulse so far may have been too much: because a layer was taken for held that
 * was not, or because the warm start gave a load that had gone. If that drove the two out of reach they would keep up
 * to 1.9 times their speed before, and sheets between sheets, or a corner hooked in a fold, would never rest. So a pair
 * that came apart since takes back what drives the two from each other, up to what it gave. Taking back counts the
 * masses of both sides, for both move.
 */
static void MUS__NAME(self_pair_respond)(mus__self_contact *self, const mus__self_rule *rule, const MUS__REAL *inverse,
                                         mus__self_active *active, MUS__REAL *x, MUS__REAL *v)
{
    const int64_t n = self->n;
    MUS__NAME(self_contact_pair) pair;
    MUS__REAL w[3] = {0, 0, 0}, give = 0, both = 0, hold[3], hold2 = 0, across[3], impulse[3], move[3];
    const int32_t lies = MUS__NAME(self_pair_lies)(self, active, x, &pair);
    if (!lies) memset(active->tangential, 0, sizeof active->tangential);
    if (!lies && (!(active->impulse > 0) || pair.overlap > 0)) {
        active->impulse = 0;
        return;
    }
    self->close += lies;
    const int32_t *node = pair.node, split = pair.split;
    const int32_t one = MUS__NAME(self_rank_of)(self, node, pair.weight, 0, split, 1, pair.normal);
    const int32_t two = MUS__NAME(self_rank_of)(self, node, pair.weight, split, 4, -1, pair.normal);
    MUS__NAME(self_pair_still)(&pair, one, two);
    for (int32_t i = 0; i < 4; i++) {
        for (int32_t d = 0; d < 3; d++) w[d] += pair.weight[i] * v[d * n + node[i]];
        const MUS__REAL own = pair.weight[i] * pair.weight[i] * inverse[node[i]];
        both += own;
        if (i < split ? one >= two || one == MUS__RANK_NONE : two >= one || two == MUS__RANK_NONE) give += own;
    }

    /* the approach ends, or the excess is taken back; friction against the sliding */
    const MUS__REAL out = MUS__NAME(dot)(w, pair.normal), last = (MUS__REAL)active->impulse;
    if (out > 0) give = both;
    if (!(give > 0)) return;
    const MUS__REAL enough = last - out / give > 0 ? last - out / give : 0;
    const MUS__REAL all = lies || enough < last ? enough : last, more = all - last;
    for (int32_t d = 0; d < 3; d++) {
        hold[d] = (MUS__REAL)active->tangential[d] - (w[d] - out * pair.normal[d]) / give;
        hold2 += hold[d] * hold[d];
    }
    const MUS__REAL grip = (MUS__REAL)self->friction * all;
    const MUS__REAL part = hold2 > grip * grip ? grip / (MUS__REAL)MUS__NAME(sqrt)(hold2) : 1;
    for (int32_t d = 0; d < 3; d++) {
        hold[d] = all > 0 ? part * hold[d] : 0;
        across[d] = hold[d] - (MUS__REAL)active->tangential[d];
        active->tangential[d] = lies ? (float)hold[d] : 0;
    }
    if (all > 0 && one < two) MUS__NAME(self_rank_set)(self, node, split, 4, one, -1, pair.normal);
    if (all > 0 && two < one) MUS__NAME(self_rank_set)(self, node, 0, split, two, 1, pair.normal);
    active->impulse = lies ? (float)all : 0;

    /* take back the way made with the old velocity; in the rest band the pair sinks on, so that it rests below its edge
     */
    const MUS__REAL slip = (MUS__REAL)rule->slip, sink = pair.overlap > 0 ? slip : 0, most = (MUS__REAL)rule->push;
    MUS__REAL push = (MUS__REAL)MUS__PUSH_SHARE * (pair.overlap - sink * more * give);
    push = (push > most ? most : push > 0 ? push : 0) / give;
    for (int32_t d = 0; d < 3; d++) {
        impulse[d] = more * pair.normal[d] + across[d];
        move[d] = (sink * more + push) * pair.normal[d] + slip * across[d];
    }
    MUS__NAME(self_pair_apply)(self, &pair, inverse, impulse, move, x, v);
}


/* answers the pairs that are asked (count, all of one kind), one after the other; those that gave no impulse in the
 * last call are measured as a packet first, and most are out of reach */
static void MUS__NAME(self_respond_packet)(mus__self_contact *self, const mus__self_rule *rule,
                                           const MUS__REAL *inverse, mus__self_active *const *asked, int32_t count,
                                           MUS__REAL *x, MUS__REAL *v)
{
    enum { N = MUS__SELF_LANES };
    MUS__REAL p[12 * N], weight[4 * N], apart[N];
    for (int32_t i = 0; i < N; i++) MUS__NAME(self_packet_places)(x, self->n, asked[i < count ? i : 0]->node, i, p);
    if (asked[0]->pair < self->nnode_pair)
        MUS__NAME(self_packet_point_triangle)(p, weight, apart);
    else
        MUS__NAME(self_packet_edge_edge)(p, weight, apart);
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL reach = (MUS__REAL)(1.0 + MUS__REST_BAND) * (MUS__REAL)asked[i]->thickness;
        if (!(asked[i]->impulse > 0 || apart[i] < reach)) continue;
        MUS__NAME(self_pair_respond)(self, rule, inverse, asked[i], x, v);
        MUS__NAME(self_active_press)(self, asked[i]);
    }
    self->responses += count;
}


static void MUS__NAME(self_respond_pairs)(mus__self_contact *self, const mus__self_rule *rule, const MUS__REAL *inverse,
                                          MUS__REAL *x, MUS__REAL *v)
{
    self->close = 0;
    for (int32_t block = 0; 32 * block < self->nactive; block++)
        for (uint32_t left = self->pressed[block]; left != 0; left &= left - 1) {
            mus__self_active *active = &self->active[32 * block + mus__box_tree_lowest(left)];
            MUS__NAME(self_pair_warm_start)(self, rule, inverse, active, x, v);
        }

    /* in the order of the list, pairs of a node and a triangle first; an answer may wake later pairs */
    mus__self_active *asked[MUS__SELF_LANES];
    int32_t count = 0;
    for (int32_t block = 0; 32 * block < self->nactive; block++) {
        uint32_t left = MUS__NAME(self_asked)(self, block);
        while (left != 0) {
            const int32_t k = mus__box_tree_lowest(left), at = 32 * block + k;
            const bool other = count > 0 && at >= self->nnode_active && asked[0] < self->active + self->nnode_active;
            if (other || count == MUS__SELF_LANES) {
                MUS__NAME(self_respond_packet)(self, rule, inverse, asked, count, x, v);
                left = MUS__NAME(self_asked)(self, block);
                count = 0;
            }
            asked[count++] = &self->active[at];
            left &= ~(uint32_t)1 << k;
        }
    }
    if (count > 0) MUS__NAME(self_respond_packet)(self, rule, inverse, asked, count, x, v);
}


/* ---- the calls ---- */

void MUS__NAME(self_contact_prepare)(mus__self_contact *self, const MUS__REAL *x)
{
    if (self->invalid) MUS__NAME(self_bounds_make)(self, x, 0.0);
}


void MUS__NAME(self_contact_pass)(mus__self_contact *self, const mus__self_rule *rule, const MUS__REAL *inverse,
                                  MUS__REAL *x, MUS__REAL *v)
{
    self->bound_age += rule->step;
    self->list_age += rule->step;
    MUS__NAME(self_travel2_all)
    (self->n, self->nodes, (MUS__REAL)self->bound_age, self->bound, self->drift, x, self->travel2);
    int32_t turn = MUS__NAME(self_bounds_enforce)(self, (MUS__REAL)rule->step, inverse, x, v);
    turn |= self->bound_age + rule->step > self->bound_span;
    if (self->nactive > 0) {
        MUS__NAME(self_rank_start)(self, rule, v);
        MUS__NAME(self_respond_pairs)(self, rule, inverse, x, v);
        turn |= MUS__NAME(self_bounds_enforce)(self, (MUS__REAL)rule->step, inverse, x, v);
    }
    if (turn) MUS__NAME(self_bounds_make)(self, x, rule->step);
}
