/*
 * active_pairs_kernel.h: which active pairs are asked in a call, a part of self_response_kernel.h.
 *
 * Most active pairs are idle: they gave no impulse in the last call, and since the bounds were made none of their nodes
 * has moved far enough for the two things to touch. An idle pair costs that one comparison, and 32 pairs are compared
 * at a time. For its sake their nodes are kept in planes too, beside each other.
 */

/* makes pair k active. Its things do not touch while no node of it has moved further than the root of idle2 [m2] */
static inline void MUS__NAME(self_active_add)(mus__self_contact *self, int32_t k, float idle2)
{
    const mus__self_pair *pair = &self->pair[k];
    const int32_t at = self->nactive++;
    int32_t *plane = self->idle_node + 128 * (int64_t)(at / 32) + at % 32;
    mus__self_active *active = &self->active[at];
    const uint32_t bit = (uint32_t)1 << at % 32;
    for (int32_t i = 0; i < 4; i++) self->active_node[pair->node[i]] = 1, plane[32 * i] = pair->node[i];
    self->idle2[at] = idle2;
    self->nnode_active += k < self->nnode_pair;
    memcpy(active->node, pair->node, sizeof active->node);
    memcpy(active->tangential, pair->tangential, sizeof active->tangential);
    active->pair = k, active->thickness = pair->thickness, active->impulse = pair->impulse;
    self->pressed[at / 32] = (at % 32 == 0 ? 0 : self->pressed[at / 32]) | (pair->impulse > 0 ? bit : 0);
}


/* notes whether an active pair gave an impulse in this call */
static inline void MUS__NAME(self_active_press)(mus__self_contact *self, const mus__self_active *active)
{
    const int64_t at = active - self->active;
    const uint32_t bit = (uint32_t)1 << at % 32;
    self->pressed[at / 32] = (self->pressed[at / 32] & ~bit) | (active->impulse > 0 ? bit : 0);
}


/* the pairs, of 32 with their four nodes in planes, that may touch because a node has moved far enough: one bit each */
MUS_CLONES
static uint32_t MUS__NAME(self_may_touch)(const int32_t *restrict node, const float *restrict idle2,
                                          const MUS__REAL *restrict travel2)
{
    uint32_t may = 0;
    for (int32_t k = 0; k < 32; k++) {
        const MUS__REAL least = (MUS__REAL)idle2[k];
        may |= (uint32_t) !((travel2[node[k]] < least) & (travel2[node[32 + k]] < least) &
                            (travel2[node[64 + k]] < least) & (travel2[node[96 + k]] < least))
               << k;
    }
    return may;
}


/* the active pairs of a block of 32 that are asked, with the nodes where they are now: one bit each */
static inline uint32_t MUS__NAME(self_asked)(const mus__self_contact *self, int32_t block)
{
    const int32_t left = self->nactive - 32 * block;
    const uint32_t held = left >= 32 ? ~(uint32_t)0 : ((uint32_t)1 << left) - 1;
    return held & (self->pressed[block] |
                   MUS__NAME(self_may_touch)(self->idle_node + 128 * (int64_t)block, self->idle2 + 32 * (int64_t)block,
                                             (const MUS__REAL *)self->travel2));
}
