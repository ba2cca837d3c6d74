/*
 * active_pairs_kernel.h: which active pairs are asked in a call, a part of self_response_kernel.h.
 *
 * Most active pairs are idle: they gave no impulse in the last call, and none of their nodes has travelled as far since
 * the bounds were made as it must for the two things to touch. That is all that is asked of them, of 32 at a time.
 */

/* makes a pair active: k its number, idle2 the squared way of a node until which its things do not touch */
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


/* of 32 pairs, with their four nodes in planes, those that may touch: a node has travelled far enough */
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


/* of the 32 active pairs of a block those that are asked as the cloth lies now */
static inline uint32_t MUS__NAME(self_asked)(const mus__self_contact *self, int32_t block)
{
    const int32_t left = self->nactive - 32 * block;
    const uint32_t held = left >= 32 ? ~(uint32_t)0 : ((uint32_t)1 << left) - 1;
    return held & (self->pressed[block] |
                   MUS__NAME(self_may_touch)(self->idle_node + 128 * (int64_t)block, self->idle2 + 32 * (int64_t)block,
                                             (const MUS__REAL *)self->travel2));
}
