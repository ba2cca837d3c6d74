/*
 * displacement_bound_kernel.h: how far each node may move until distances are measured again, a part of
 * self_response_kernel.h. Per-vertex displacement bounds; Chen and others, Offset Geometric Contact, 2025.
 *
 * The bound of a node is the least, over its pairs, of MUS__BOUND_SHARE of the distance (active pairs) or of
 * MUS__BOUND_APPROACH of what the pair is apart beyond the thickness (others), and what is left of its margin in the
 * neighbour list. self_contact.h has the proof that two things with such bounds never touch.
 */


/* ---- bounds from the list and from the pairs ---- */

/* distance of node i from its home in the list, which has drifted for `age` */
static inline MUS__REAL MUS__NAME(self_home_travel)(const mus__self_contact *self, const MUS__REAL *x, MUS__REAL age,
                                                    int64_t i)
{
    const MUS__REAL *home = self->list_home, *w = self->drift;
    const int64_t n = self->n;
    const MUS__REAL d0 = x[i] - (home[i] + age * w[i]), d1 = x[n + i] - (home[n + i] + age * w[n + i]);
    const MUS__REAL d2 = x[2 * n + i] - (home[2 * n + i] + age * w[2 * n + i]);
    return (MUS__REAL)MUS__NAME(sqrt)(d0 * d0 + d1 * d1 + d2 * d2);
}


/* bounds from what is left of the margin; nonzero when that is little for a node, or the list is old */
static int32_t MUS__NAME(self_bounds_from_list)(mus__self_contact *self, const MUS__REAL *x)
{
    const MUS__REAL margin = (MUS__REAL)self->margin, least = (MUS__REAL)MUS__LIST_RENEW * margin,
                    age = (MUS__REAL)self->list_age;
    MUS__REAL *bound = (MUS__REAL *)self->bound + 3 * (int64_t)self->n;
    int32_t stale = !(self->list_age <= (1.0 - MUS__LIST_RENEW) * self->list_span);
    for (int64_t i = 0; i < self->nodes; i++) {
        bound[i] = margin - MUS__NAME(self_home_travel)(self, x, age, i);
        stale |= !(bound[i] >= least);
    }
    return stale;
}


/* nonzero when both things of a pair have a node that is part of a crossing: they may pass through each other */
static inline int32_t MUS__NAME(self_pair_may_cross)(const mus__self_contact *self, const int32_t *node, int32_t split)
{
    const uint8_t *tangle = self->crossed;
    const int32_t second = tangle[node[1]] != 0;
    return (tangle[node[0]] || (split == 2 && second)) &&
           (tangle[node[2]] || tangle[node[3]] || (split == 1 && second));
}


/* shrinks the bounds of the nodes of pair k, which is `apart` [m] apart and approaches at up to 2 `closing` [m/s], and
 * makes it active when it is near. Returns how long the bounds hold [s], `most` or less */
static inline MUS__REAL MUS__NAME(self_bound_pair)(mus__self_contact *self, int32_t k, MUS__REAL apart,
                                                   MUS__REAL closing, MUS__REAL most)
{
    MUS__REAL *bound = (MUS__REAL *)self->bound + 3 * (int64_t)self->n;
    const mus__self_pair *pair = &self->pair[k];
    const int32_t *node = pair->node;
    const MUS__REAL t = (MUS__REAL)pair->thickness;
    MUS__REAL limit = (MUS__REAL)MUS__BOUND_SHARE * apart;
    MUS__REAL idle = (MUS__REAL)0.5 * (apart - (MUS__REAL)(1.0 + MUS__REST_BAND) * t);
    const int32_t near = apart < (MUS__REAL)MUS__ACTIVE_DISTANCE * t;
    if (!near) limit = (MUS__REAL)MUS__BOUND_APPROACH * (apart - t);
    if (self->drifts) {
        const MUS__REAL part = (MUS__REAL)MUS__BOUND_DRIFT_SHARE * limit;
        if (most * closing > part) most = part / closing;
        limit -= most * closing;
        idle -= most * closing;
    }
    for (int32_t i = 0; i < 4; i++) bound[node[i]] = limit < bound[node[i]] ? limit : bound[node[i]];
    if (near) MUS__NAME(self_active_add)(self, k, idle > 0 ? (float)((MUS__REAL)MUS__IDLE_SHARE * idle * idle) : 0);
    return most;
}


/* shrinks the bounds by all pairs, and lists the active ones. Returns how long the bounds hold [s], `most` or less:
 * until drifts that differ have used up their share of a pair's clearance */
static MUS__REAL MUS__NAME(self_bound_pairs)(mus__self_contact *self, const MUS__REAL *x, MUS__REAL most)
{
    const int32_t edges = self->pair_capacity - (self->npair - self->nnode_pair);
    const int32_t range[2][2] = {{0, self->nnode_pair}, {edges, self->pair_capacity}};
    self->measured += self->npair;
    self->nactive = self->nnode_active = 0;
    memset(self->active_node, 0, (size_t)self->nodes);
    MUS__NAME(self_packet) row;
    for (int32_t kind = 0; kind < 2; kind++)
        for (int32_t k = range[kind][0]; k < range[kind][1]; k += MUS__SELF_LANES) {
            const int32_t left = range[kind][1] - k, count = left < MUS__SELF_LANES ? left : MUS__SELF_LANES;
            MUS__NAME(self_packet_measure)(self, k, count, x, &row);
            for (int32_t i = 0; i < count; i++) {
                if (self->ncrossed > 0 && MUS__NAME(self_pair_may_cross)(self, self->pair[k + i].node, kind + 1))
                    continue;
                most = MUS__NAME(self_bound_pair)(self, k + i, row.apart[i], row.closing[i], most);
            }
        }
    return most;
}


/* makes bounds round the places x of the nodes, which drift with them; the next step is of h */
static void MUS__NAME(self_bounds_make)(mus__self_contact *self, const MUS__REAL *x, double h)
{
    const int64_t n = self->n;
    MUS__REAL *centre = self->bound, *bound = centre + 3 * n;
    for (int32_t k = 0; k < self->nactive; k++) {
        mus__self_pair *pair = &self->pair[self->active[k].pair];
        pair->impulse = self->active[k].impulse;
        memcpy(pair->tangential, self->active[k].tangential, sizeof pair->tangential);
    }
    if (self->invalid || MUS__NAME(self_bounds_from_list)(self, x)) {
        if (self->invalid || !MUS__NAME(self_list_renew)(self, x)) MUS__NAME(self_list_make)(self, x);
        MUS__NAME(self_bounds_from_list)(self, x);
    }
    self->invalid = 0;
    self->bounds_made++;
    self->bound_span = INFINITY;
    if (self->drifts) {
        const double left = self->list_span - self->list_age, most = MUS__BOUND_LONGER * fmax(self->bound_age, h);
        self->bound_span = (double)MUS__NAME(self_bound_pairs)(self, x, (MUS__REAL)(left < most ? left : most));
        if (self->bound_span < MUS__BOUND_STEPS_MIN * h) {
            MUS__NAME(self_drift_stop)(self);
            MUS__NAME(self_bounds_from_list)(self, x);
            self->bound_span = INFINITY;
        }
    }
    if (!self->drifts) MUS__NAME(self_bound_pairs)(self, x, 0);
    self->bound_age = 0.0;
    for (int64_t i = 0; i < self->nodes; i++) {
        const MUS__REAL far = x[i] * x[i] + x[n + i] * x[n + i] + x[2 * n + i] * x[2 * n + i];
        const MUS__REAL limit = bound[i] - (MUS__REAL)MUS__PLACE_ROUND * (MUS__REAL)MUS__NAME(sqrt)(far);
        bound[i] = limit > 0 && !self->full ? limit * limit : 0;
    }
    memcpy(centre, x, 3 * (size_t)n * sizeof *centre);
}


/* squared distance of node i from the middle of its bound, which has drifted for `since` */
static inline MUS__REAL MUS__NAME(self_travel2)(int64_t n, int64_t i, MUS__REAL since, const MUS__REAL *bound,
                                                const MUS__REAL *w, const MUS__REAL *x)
{
    const MUS__REAL d0 = x[i] - (bound[i] + since * w[i]), d1 = x[n + i] - (bound[n + i] + since * w[n + i]);
    const MUS__REAL d2 = x[2 * n + i] - (bound[2 * n + i] + since * w[2 * n + i]);
    return d0 * d0 + d1 * d1 + d2 * d2;
}


/* the same of all nodes, into travel2 (count) */
MUS_CLONES
static void MUS__NAME(self_travel2_all)(int64_t n, int32_t count, MUS__REAL since, const MUS__REAL *restrict bound,
                                        const MUS__REAL *restrict w, const MUS__REAL *restrict x,
                                        MUS__REAL *restrict travel2)
{
    for (int32_t i = 0; i < count; i++) travel2[i] = MUS__NAME(self_travel2)(n, i, since, bound, w, x);
}


/* number of nodes whose squared travel is above `part` of the squared bound */
MUS_CLONES
static int32_t MUS__NAME(self_bounds_beyond)(int32_t count, MUS__REAL part, const MUS__REAL *restrict bound2,
                                             const MUS__REAL *restrict travel2)
{
    int32_t beyond = 0;
    for (int32_t i = 0; i < count; i++) beyond += travel2[i] <= part * bound2[i] ? 0 : 1;
    return beyond;
}


/*
 * Puts nodes that left their bounds back to where they came out, and slows them by as much as they went less far in
 * this step of h: with the old speed they would gain the work of the forces over the way back. That is an impulse of
 * other cloth too. Nonzero when any node is near the end of its bound. travel2 is that of the places x, before and
 * after.
 */
static int32_t MUS__NAME(self_bounds_enforce)(mus__self_contact *self, MUS__REAL h, const MUS__REAL *inverse,
                                              MUS__REAL *x, MUS__REAL *v)
{
    const int64_t n = self->n;
    const MUS__REAL *bound = self->bound, *w = self->drift, since = (MUS__REAL)self->bound_age;
    MUS__REAL *force = self->force, *off = self->travel2;
    if (MUS__NAME(self_bounds_beyond)(self->nodes, (MUS__REAL)MUS__BOUND_RENEW, bound + 3 * n, off) == 0) return 0;
    for (int64_t i = 0; i < self->nodes; i++) {
        MUS__REAL way[3], middle[3], d2 = 0, out = 0;
        for (int64_t d = 0; d < 3; d++) {
            middle[d] = bound[d * n + i] + since * w[d * n + i];
            way[d] = x[d * n + i] - middle[d];
            d2 += way[d] * way[d];
            out += way[d] * (v[d * n + i] - w[d * n + i]);
        }
        if (d2 <= bound[3 * n + i]) continue;
        const MUS__REAL part = (MUS__REAL)0.999 * (MUS__REAL)MUS__NAME(sqrt)(bound[3 * n + i] / d2);
        const MUS__REAL lost = (1 - part) / h, most = out > 0 ? out / d2 : 0, slower = lost < most ? lost : most;
        for (int64_t d = 0; d < 3; d++) {
            x[d * n + i] = part > 0 ? middle[d] + part * way[d] : middle[d];
            v[d * n + i] -= slower * way[d];
            force[d * n + i] -= inverse[i] > 0 ? slower * way[d] / inverse[i] : 0;
        }
        off[i] = MUS__NAME(self_travel2)(n, i, since, bound, w, x);
        self->held++;
    }
    return 1;
}
