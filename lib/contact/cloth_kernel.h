/*
 * cloth_kernel.h: cloth_self.h as a template on the floating type (MUS_REAL, MUS_FIELD, MUS_SELF, MUS_SELF_LOOK,
 * MUS_SQRT).
 *
 * All loops over pairs are in the order of the list, on one thread: what a pair gives its nodes the next one sees, and
 * the bytes do not depend on how many threads there are.
 */

#define SELF_BALL 0.45     /* of the distance of a pair; below a half */
#define SELF_TURN 0.64     /* of the squared radius: from there on balls are taken anew */
#define SELF_ACTIVE 2.0    /* thicknesses: pairs that are nearer answer until balls are taken anew */
#define SELF_APPROACH 0.45 /* of what others are farther apart than the thickness: they do not come to it unseen */
#define SELF_BAND 0.002    /* of the thickness: cloth this little farther off still rests on cloth. Small, for
                            * beside an edge it is that far off at an angle of the root of twice this */
#define SELF_PUSH 0.05     /* of the overlap, in one call */
#define SELF_AGAIN 0.9     /* of what a pair gave in the last call it gives at once */
#define SELF_WORN 0.3      /* of the skin: with less left for a node the list is made anew */
#define SELF_WIDER 2.0     /* times as long as the last balls lasted they are to last */
#define SELF_LEAST_STEPS 2.0 /* that balls are to hold for, or nothing drifts */
#define SELF_PART 0.5      /* of its room a pair leaves to drifts that differ */
#define SELF_TURNED 1e-5   /* [m]: rounding may be off by so much in the way from one thing to another */
#define SELF_IDLE 0.99     /* of the squared way that leaves a pair apart: less than that is not asked */
#define SELF_BEARS 0.05    /* a node with less of a share in a pair does not bear on it */
#define SELF_AGAINST 0.5   /* cosine of what holds a node and what pushes it */

#include "contact/cloth_list_kernel.h"
#include "contact/cloth_room_kernel.h"


/* ---- ball: how far nodes may go ---- */

/* how far node i is from home, which has drifted for `age` */
static inline MUS_REAL MUS_FIELD(self_gone)(const mus__cloth_self *self, const MUS_REAL *x, MUS_REAL age, int64_t i)
{
    const MUS_REAL *home = self->home, *w = self->drift;
    const int64_t n = self->n;
    const MUS_REAL d0 = x[i] - (home[i] + age * w[i]), d1 = x[n + i] - (home[n + i] + age * w[n + i]);
    const MUS_REAL d2 = x[2 * n + i] - (home[2 * n + i] + age * w[2 * n + i]);
    return (MUS_REAL)MUS_SQRT(d0 * d0 + d1 * d1 + d2 * d2);
}


/* balls of what is left of the skin; nonzero when that is little for a node, or the list is old */
static int32_t MUS_FIELD(self_left)(mus__cloth_self *self, const MUS_REAL *x)
{
    const MUS_REAL skin = (MUS_REAL)self->skin, least = (MUS_REAL)SELF_WORN * skin, age = (MUS_REAL)self->age;
    MUS_REAL *ball = (MUS_REAL *)self->ball + 3 * (int64_t)self->n;
    int32_t worn = !(self->age <= (1.0 - SELF_WORN) * self->span);
    for (int64_t i = 0; i < self->nodes; i++) {
        ball[i] = skin - MUS_FIELD(self_gone)(self, x, age, i);
        worn |= !(ball[i] >= least);
    }
    return worn;
}


/* nonzero when both things of a pair have a node that is part of a crossing */
static inline int32_t MUS_FIELD(self_loose)(const mus__cloth_self *self, const int32_t *node, int32_t split)
{
    const uint8_t *tangle = self->tangle;
    const int32_t second = tangle[node[1]] != 0;
    return (tangle[node[0]] || (split == 2 && second)) &&
           (tangle[node[2]] || tangle[node[3]] || (split == 1 && second));
}


/* what pair k, apart by so much and closing by twice so much, leaves of the balls of its nodes, and whether it answers
 * from now on; the balls hold for `most` or less */
static inline MUS_REAL MUS_FIELD(self_room)(mus__cloth_self *self, int32_t k, MUS_REAL apart, MUS_REAL closing,
                                            MUS_REAL most)
{
    MUS_REAL *ball = (MUS_REAL *)self->ball + 3 * (int64_t)self->n;
    const int32_t *node = self->pair[k].node;
    const MUS_REAL t = (MUS_REAL)self->pair[k].thickness;
    MUS_REAL room = (MUS_REAL)SELF_BALL * apart;
    MUS_REAL idle = (MUS_REAL)0.5 * (apart - (MUS_REAL)(1.0 + SELF_BAND) * t);
    if (apart < (MUS_REAL)SELF_ACTIVE * t) {
        self->touch[self->ntouch++] = k;
        for (int32_t i = 0; i < 4; i++) self->near[node[i]] = 1;
    } else {
        room = (MUS_REAL)SELF_APPROACH * (apart - t);
    }
    if (self->drifts) {
        const MUS_REAL part = (MUS_REAL)SELF_PART * room;
        if (most * closing > part) most = part / closing;
        room -= most * closing;
        idle -= most * closing;
    }
    self->pair[k].room2 = idle > 0 ? (float)((MUS_REAL)SELF_IDLE * idle * idle) : 0;
    for (int32_t i = 0; i < 4; i++) ball[node[i]] = room < ball[node[i]] ? room : ball[node[i]];
    return most;
}


/* balls of the nodes by the distances of the pairs, and which pairs answer from now on. Returns how long the balls hold
 * [s], `most` or less: as long as drifts that differ take no more than a part of a pair's room */
static MUS_REAL MUS_FIELD(self_rooms)(mus__cloth_self *self, const MUS_REAL *x, MUS_REAL most)
{
    const int32_t edges = self->pair_capacity - (self->npair - self->nnode_pair);
    const int32_t range[2][2] = {{0, self->nnode_pair}, {edges, self->pair_capacity}};
    self->measured += self->npair;
    self->ntouch = 0;
    memset(self->near, 0, (size_t)self->nodes);
    MUS_FIELD(self_row) row;
    for (int32_t kind = 0; kind < 2; kind++)
        for (int32_t k = range[kind][0]; k < range[kind][1]; k += SELF_LANES) {
            const int32_t left = range[kind][1] - k, count = left < SELF_LANES ? left : SELF_LANES;
            MUS_FIELD(self_row_measure)(self, k, count, x, &row);
            for (int32_t i = 0; i < count; i++) {
                if (self->tangled > 0 && MUS_FIELD(self_loose)(self, self->pair[k + i].node, kind + 1)) continue;
                most = MUS_FIELD(self_room)(self, k + i, row.apart[i], row.closing[i], most);
            }
        }
    return most;
}


/* balls round where the nodes are now, which drift with them; the next step is of h */
static void MUS_FIELD(self_balls)(mus__cloth_self *self, const MUS_REAL *x, double h)
{
    const int64_t n = self->n;
    MUS_REAL *centre = self->ball, *ball = centre + 3 * n;
    if (self->stale || MUS_FIELD(self_left)(self, x)) {
        if (self->stale || !MUS_FIELD(self_renew)(self, x)) MUS_FIELD(self_list)(self, x);
        MUS_FIELD(self_left)(self, x);
    }
    self->stale = 0;
    self->balls++;
    self->holds = INFINITY;
    if (self->drifts) {
        const double left = self->span - self->age, most = SELF_WIDER * fmax(self->since, h);
        self->holds = (double)MUS_FIELD(self_rooms)(self, x, (MUS_REAL)(left < most ? left : most));
        if (self->holds < SELF_LEAST_STEPS * h) {
            MUS_FIELD(self_rest)(self);
            MUS_FIELD(self_left)(self, x);
            self->holds = INFINITY;
        }
    }
    if (!self->drifts) MUS_FIELD(self_rooms)(self, x, 0);
    self->since = 0.0;
    for (int64_t i = 0; i < self->nodes; i++) {
        const MUS_REAL far = x[i] * x[i] + x[n + i] * x[n + i] + x[2 * n + i] * x[2 * n + i];
        const MUS_REAL room = ball[i] - (MUS_REAL)SELF_ROUND * (MUS_REAL)MUS_SQRT(far);
        ball[i] = room > 0 && !self->full ? room * room : 0;
    }
    memcpy(centre, x, 3 * (size_t)n * sizeof *centre);
}


/* how many of the nodes are beyond `part` of their squared balls, which have drifted for `since` */
MUS_CLONES
static int32_t MUS_FIELD(self_beyond)(int64_t n, int32_t count, MUS_REAL part, MUS_REAL since,
                                      const MUS_REAL *restrict ball, const MUS_REAL *restrict w,
                                      const MUS_REAL *restrict x)
{
    int32_t beyond = 0;
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL d0 = x[i] - (ball[i] + since * w[i]), d1 = x[n + i] - (ball[n + i] + since * w[n + i]);
        const MUS_REAL d2 = x[2 * n + i] - (ball[2 * n + i] + since * w[2 * n + i]);
        beyond += d0 * d0 + d1 * d1 + d2 * d2 <= part * ball[3 * n + i] ? 0 : 1;
    }
    return beyond;
}


/* squared distance of node i from the middle of its ball, which has drifted for `since` */
static inline MUS_REAL MUS_FIELD(self_off2)(int64_t n, int64_t i, MUS_REAL since, const MUS_REAL *ball,
                                            const MUS_REAL *w, const MUS_REAL *x)
{
    const MUS_REAL d0 = x[i] - (ball[i] + since * w[i]), d1 = x[n + i] - (ball[n + i] + since * w[n + i]);
    const MUS_REAL d2 = x[2 * n + i] - (ball[2 * n + i] + since * w[2 * n + i]);
    return d0 * d0 + d1 * d1 + d2 * d2;
}


/* these of all nodes, and the largest of them */
MUS_CLONES
static MUS_REAL MUS_FIELD(self_farthest)(int64_t n, int32_t count, MUS_REAL since, const MUS_REAL *restrict ball,
                                         const MUS_REAL *restrict w, const MUS_REAL *restrict x,
                                         MUS_REAL *restrict off2)
{
    MUS_REAL most[16] = {0}, all = 0;
    int32_t i = 0;
    for (; i + 16 <= count; i += 16)
        for (int32_t k = 0; k < 16; k++) {
            off2[i + k] = MUS_FIELD(self_off2)(n, i + k, since, ball, w, x);
            most[k] = off2[i + k] > most[k] ? off2[i + k] : most[k];
        }
    for (; i < count; i++) {
        off2[i] = MUS_FIELD(self_off2)(n, i, since, ball, w, x);
        all = off2[i] > all ? off2[i] : all;
    }
    for (int32_t k = 0; k < 16; k++) all = most[k] > all ? most[k] : all;
    return all;
}


/*
 * Nodes that left their balls back to them, to where they came out, and as much slower as they went less far in this
 * step of h: with their old speed they would gain what the force does over the way back. Nonzero when any is near the
 * end of its ball.
 */
static int32_t MUS_FIELD(self_hold)(mus__cloth_self *self, MUS_REAL h, MUS_REAL *x, MUS_REAL *v)
{
    const int64_t n = self->n;
    const MUS_REAL *ball = self->ball, *w = self->drift, since = (MUS_REAL)self->since;
    if (MUS_FIELD(self_beyond)(n, self->nodes, (MUS_REAL)SELF_TURN, since, ball, w, x) == 0) return 0;
    for (int64_t i = 0; i < self->nodes; i++) {
        MUS_REAL way[3], middle[3], d2 = 0, out = 0;
        for (int64_t d = 0; d < 3; d++) {
            middle[d] = ball[d * n + i] + since * w[d * n + i];
            way[d] = x[d * n + i] - middle[d];
            d2 += way[d] * way[d];
            out += way[d] * (v[d * n + i] - w[d * n + i]);
        }
        if (d2 <= ball[3 * n + i]) continue;
        const MUS_REAL part = (MUS_REAL)0.999 * (MUS_REAL)MUS_SQRT(ball[3 * n + i] / d2);
        const MUS_REAL lost = (1 - part) / h, most = out > 0 ? out / d2 : 0, slower = lost < most ? lost : most;
        for (int64_t d = 0; d < 3; d++) {
            x[d * n + i] = part > 0 ? middle[d] + part * way[d] : middle[d];
            v[d * n + i] -= slower * way[d];
        }
        self->held++;
    }
    return 1;
}


/* ---- touch: what near pairs answer ---- */

/*
 * A layer that lies on the body hands on what it gets from the layers on it: the body takes it before the next call. In
 * a pair such a layer is as good as held, and the other gets all of the answer; else a pile would sink by half of the
 * answer in each step. It is held when the body pushed its nodes in this step, or a layer that is held did in the last
 * call, against the way in which this pair pushes them.
 */

/* the level of the nodes first .. last-1 that bear on the pair, which pushes them along `sign` times the normal */
static inline int32_t MUS_FIELD(self_level)(const mus__cloth_self *self, const int32_t *node, const MUS_REAL *share,
                                            int32_t first, int32_t last, MUS_REAL sign, const MUS_REAL *normal)
{
    const int64_t n = self->n;
    const MUS_REAL *ground = self->ground;
    int32_t level = 0;
    for (int32_t i = first; i < last; i++) {
        const int32_t k = node[i], now = self->last[k] < self->level[k] ? self->last[k] : self->level[k];
        if (share[i] < (MUS_REAL)SELF_BEARS && share[i] > -(MUS_REAL)SELF_BEARS) continue;
        if (now == MUS_SELF_LOOSE) return now;
        const MUS_REAL along = ground[k] * normal[0] + ground[n + k] * normal[1] + ground[2 * n + k] * normal[2];
        if (!(sign * along < -(MUS_REAL)SELF_AGAINST)) return MUS_SELF_LOOSE;
        level = now > level ? now : level;
    }
    return level;
}


/* the nodes first .. last-1 are pushed along `sign` times the normal by something of `level` */
static inline void MUS_FIELD(self_stand)(mus__cloth_self *self, const int32_t *node, int32_t first, int32_t last,
                                         int32_t level, MUS_REAL sign, const MUS_REAL *normal)
{
    const int64_t n = self->n;
    MUS_REAL *ground = self->ground;
    for (int32_t i = first; i < last && level < MUS_SELF_LEVELS; i++) {
        const int32_t k = node[i];
        if (self->level[k] <= level + 1) continue;
        self->level[k] = (uint8_t)(level + 1);
        for (int32_t d = 0; d < 3; d++) ground[d * n + k] = sign * normal[d];
    }
}


/* which nodes of pairs that may touch the body pushed in this step, and whither; others keep what they had */
MUS_CLONES
static void MUS_FIELD(self_pushed)(int64_t n, int32_t count, const uint8_t *restrict near, const MUS_REAL *restrict v,
                                   const MUS_REAL *restrict before, uint8_t *restrict level,
                                   MUS_REAL *restrict ground)
{
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL push0 = v[i] - before[i], push1 = v[n + i] - before[n + i];
        const MUS_REAL push2 = v[2 * n + i] - before[2 * n + i];
        const MUS_REAL all = push0 * push0 + push1 * push1 + push2 * push2;
        const int32_t held = near[i] != 0 && all > 0;
        const MUS_REAL length = (MUS_REAL)MUS_SQRT(held ? all : 1);
        level[i] = held ? 0 : MUS_SELF_LOOSE;
        ground[i] = held ? push0 / length : ground[i];
        ground[n + i] = held ? push1 / length : ground[n + i];
        ground[2 * n + i] = held ? push2 / length : ground[2 * n + i];
    }
}


static void MUS_FIELD(self_grounds)(mus__cloth_self *self, const mus__cloth_rule *rule, const MUS_REAL *v)
{
    uint8_t *const was = self->last;
    self->last = self->level;
    self->level = was;
    if (rule->body)
        MUS_FIELD(self_pushed)(self->n, self->nodes, self->near, v, self->before, self->level, self->ground);
    else
        memset(self->level, MUS_SELF_LOOSE, (size_t)self->nodes);
}


/* a pair that answers: shares of its nodes, unit normal from its second thing to its first, how much too near they
 * are */
typedef struct MUS_FIELD(self_pair) {
    const int32_t *node;
    int32_t split; /* nodes of the first thing */
    MUS_REAL share[4], normal[3], lift;
} MUS_FIELD(self_pair);


/* pair number k as it lies now, left out where it does not and gave nothing; nonzero when its things are nearer than
 * the thickness, or hardly more */
static inline int32_t MUS_FIELD(self_lies)(const mus__cloth_self *self, int32_t k, const MUS_REAL *x,
                                           MUS_FIELD(self_pair) * pair)
{
    const MUS_REAL t = (MUS_REAL)self->pair[k].thickness, reach = (MUS_REAL)(1.0 + SELF_BAND) * t;
    MUS_REAL p[4][3], *share = pair->share;
    pair->node = self->pair[k].node;
    pair->split = k < self->nnode_pair ? 1 : 2;
    MUS_FIELD(self_take)(x, self->n, pair->node, p);
    const MUS_REAL d2 = MUS_FIELD(self_measure)(self, k, p, share);
    const int32_t lies = d2 > 0 && d2 < reach * reach;
    pair->lift = t;
    if (!lies && !(d2 > 0 && self->pair[k].impulse > 0)) return 0;
    const MUS_REAL apart = (MUS_REAL)MUS_SQRT(d2);
    pair->lift = t - apart;
    for (int32_t d = 0; d < 3; d++)
        pair->normal[d] =
            (share[0] * p[0][d] + share[1] * p[1][d] + share[2] * p[2][d] + share[3] * p[3][d]) / apart;
    return lies;
}


/* an impulse and a move per mass (3 each) to the nodes of a pair */
static inline void MUS_FIELD(self_give)(mus__cloth_self *self, const MUS_FIELD(self_pair) * pair,
                                        const MUS_REAL *inverse, const MUS_REAL *impulse, const MUS_REAL *move,
                                        MUS_REAL *x, MUS_REAL *v)
{
    const int64_t n = self->n;
    MUS_REAL *force = self->force, *off = self->off;
    for (int32_t i = 0; i < 4; i++) {
        const MUS_REAL share = pair->share[i], moved = share * inverse[pair->node[i]];
        for (int32_t d = 0; d < 3; d++) {
            const int64_t at = d * n + pair->node[i];
            v[at] += moved * impulse[d];
            x[at] += moved * move[d];
            force[at] += share * impulse[d];
        }
        const MUS_REAL off2 =
            MUS_FIELD(self_off2)(n, pair->node[i], (MUS_REAL)self->since, self->ball, self->drift, x);
        off[pair->node[i]] = off2;
        if (off2 > (MUS_REAL)self->far2) self->far2 = (double)off2;
    }
}


/* what a pair gave in the last call, along its normal of now */
static void MUS_FIELD(self_again)(mus__cloth_self *self, const mus__cloth_rule *rule, const MUS_REAL *inverse,
                                  int32_t k, MUS_REAL *x, MUS_REAL *v)
{
    MUS_FIELD(self_pair) pair;
    if (!MUS_FIELD(self_lies)(self, k, x, &pair)) return;
    self->pair[k].impulse *= (float)SELF_AGAIN;
    MUS_REAL impulse[3], move[3];
    for (int32_t d = 0; d < 3; d++) {
        impulse[d] = (MUS_REAL)self->pair[k].impulse * pair.normal[d];
        move[d] = pair.lift > 0 ? (MUS_REAL)rule->slip * impulse[d] : 0;
    }
    MUS_FIELD(self_give)(self, &pair, inverse, impulse, move, x, v);
}


/*
 * What it gives beside that, or less, and friction of what it gives in all.
 *
 * No blow is followed by a bounce. What the pair gave may have been too much: by taking a layer for held that was not,
 * or by giving again what had done its work. If that brought the two out of reach they would keep it, 1.9 times their
 * speed before, and sheets between sheets, or a corner hooked in a fold, would never rest. So a pair that came apart
 * since it gave takes back what drives the two from each other, up to what it gave; and taking back counts both sides,
 * for both move.
 */
static void MUS_FIELD(self_answer)(mus__cloth_self *self, const mus__cloth_rule *rule, const MUS_REAL *inverse,
                                   int32_t k, MUS_REAL *x, MUS_REAL *v)
{
    const int64_t n = self->n;
    MUS_FIELD(self_pair) pair;
    MUS_REAL w[3] = {0, 0, 0}, give = 0, both = 0, speed2 = 0, rub = 0, slide[3], impulse[3], move[3];
    const int32_t lies = MUS_FIELD(self_lies)(self, k, x, &pair);
    if (!lies && (!(self->pair[k].impulse > 0) || pair.lift > 0)) {
        self->pair[k].impulse = 0;
        return;
    }
    self->close += lies;
    const int32_t *node = pair.node, split = pair.split;
    const int32_t one = MUS_FIELD(self_level)(self, node, pair.share, 0, split, 1, pair.normal);
    const int32_t two = MUS_FIELD(self_level)(self, node, pair.share, split, 4, -1, pair.normal);
    for (int32_t i = 0; i < 4; i++) {
        for (int32_t d = 0; d < 3; d++) w[d] += pair.share[i] * v[d * n + node[i]];
        const MUS_REAL own = pair.share[i] * pair.share[i] * inverse[node[i]];
        both += own;
        if (i < split ? one >= two || one == MUS_SELF_LOOSE : two >= one || two == MUS_SELF_LOOSE) give += own;
    }

    /* the approach ends, or what was given too much is taken back; friction against the sliding */
    const MUS_REAL out = MUS_FIELD(dot)(w, pair.normal), last = (MUS_REAL)self->pair[k].impulse;
    if (out > 0) give = both;
    if (!(give > 0)) return;
    const MUS_REAL enough = last - out / give > 0 ? last - out / give : 0;
    const MUS_REAL all = lies || enough < last ? enough : last, more = all - last;
    for (int32_t d = 0; d < 3; d++) slide[d] = w[d] - out * pair.normal[d], speed2 += slide[d] * slide[d];
    if (all > 0 && speed2 > 0) {
        const MUS_REAL speed = (MUS_REAL)MUS_SQRT(speed2), grip = (MUS_REAL)self->friction * all * give;
        rub = (grip < speed ? grip / speed : 1) / give;
    }
    if (all > 0 && one < two) MUS_FIELD(self_stand)(self, node, split, 4, one, -1, pair.normal);
    if (all > 0 && two < one) MUS_FIELD(self_stand)(self, node, 0, split, two, 1, pair.normal);
    self->pair[k].impulse = lies ? (float)all : 0;

    /* what moved with the old velocity moves back; but in the band it sinks on, so that it rests below its edge */
    const MUS_REAL slip = (MUS_REAL)rule->slip, sink = pair.lift > 0 ? slip : 0, most = (MUS_REAL)rule->push;
    MUS_REAL push = (MUS_REAL)SELF_PUSH * (pair.lift - sink * more * give);
    push = (push > most ? most : push > 0 ? push : 0) / give;
    for (int32_t d = 0; d < 3; d++) {
        impulse[d] = more * pair.normal[d] - rub * slide[d];
        move[d] = (sink * more + push) * pair.normal[d] - slip * rub * slide[d];
    }
    MUS_FIELD(self_give)(self, &pair, inverse, impulse, move, x, v);
}


/* nonzero when any node of a pair has gone as far as its things may unseen */
static inline int32_t MUS_FIELD(self_nears)(const mus__cloth_self *self, const mus__cloth_near *pair)
{
    const MUS_REAL *off = self->off, room2 = (MUS_REAL)pair->room2;
    const int32_t *node = pair->node;
    if ((MUS_REAL)self->far2 < room2) return 0;
    return !((off[node[0]] < room2) & (off[node[1]] < room2) & (off[node[2]] < room2) & (off[node[3]] < room2));
}


static void MUS_FIELD(self_touch)(mus__cloth_self *self, const mus__cloth_rule *rule, const MUS_REAL *inverse,
                                  MUS_REAL *x, MUS_REAL *v)
{
    self->close = 0;
    self->far2 = (double)MUS_FIELD(self_farthest)(self->n, self->nodes, (MUS_REAL)self->since, self->ball, self->drift,
                                                  x, self->off);
    for (int32_t k = 0; k < self->ntouch; k++)
        if (self->pair[self->touch[k]].impulse > 0) MUS_FIELD(self_again)(self, rule, inverse, self->touch[k], x, v);

    /* what gave nothing in the last call and cannot touch in this one is not asked */
    for (int32_t k = 0; k < self->ntouch; k++) {
        const mus__cloth_near *pair = &self->pair[self->touch[k]];
        if (!(pair->impulse > 0) && !MUS_FIELD(self_nears)(self, pair)) continue;
        MUS_FIELD(self_answer)(self, rule, inverse, self->touch[k], x, v);
        self->answers++;
    }
}


/* ---- the calls ---- */

void MUS_SELF_LOOK(mus__cloth_self *self, const MUS_REAL *x)
{
    if (self->stale) MUS_FIELD(self_balls)(self, x, 0.0);
}


void MUS_SELF(mus__cloth_self *self, const mus__cloth_rule *rule, const MUS_REAL *inverse, MUS_REAL *x, MUS_REAL *v)
{
    self->since += rule->step;
    self->age += rule->step;
    int32_t turn = MUS_FIELD(self_hold)(self, (MUS_REAL)rule->step, x, v);
    turn |= self->since + rule->step > self->holds;
    if (self->ntouch > 0) {
        MUS_FIELD(self_grounds)(self, rule, v);
        MUS_FIELD(self_touch)(self, rule, inverse, x, v);
        turn |= MUS_FIELD(self_hold)(self, (MUS_REAL)rule->step, x, v);
    }
    if (turn) MUS_FIELD(self_balls)(self, x, rule->step);
}
