/* cloth_f64.c: cloth against cloth in double. */
#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "contact/cloth_self.h"
#include "contact/contact.h"

#define MUS_REAL double
#define MUS_FIELD(name) mus__f64_##name
#define MUS_SELF mus__cloth_self_f64
#define MUS_SELF_LOOK mus__cloth_self_look_f64
#define MUS_SQRT sqrt
#include "contact/cloth_kernel.h"


int32_t mus__cloth_self_part(const mus__cloth_self *self, double least, const int32_t *held, double *x)
{
    const int32_t edges = self->pair_capacity - (self->npair - self->nnode_pair);
    int32_t moved = 0;
    for (int32_t k = 0; k < self->pair_capacity; k++) {
        if (k == self->nnode_pair) k = edges;
        if (k == self->pair_capacity) break;
        const int32_t *node = self->pair[k].node;
        double p[4][3], share[4], normal[3], give = 0.0;
        for (int32_t i = 0; i < 4; i++) memcpy(p[i], x + 3 * (int64_t)node[i], sizeof p[i]);
        const double d2 = mus__f64_self_measure(self, k, p, share);
        if (!(d2 < least * least) || !(d2 > 0.0)) continue;
        const double apart = sqrt(d2);
        for (int32_t d = 0; d < 3; d++)
            normal[d] = (share[0] * p[0][d] + share[1] * p[1][d] + share[2] * p[2][d] + share[3] * p[3][d]) / apart;
        for (int32_t i = 0; i < 4; i++) give += held[node[i]] ? 0.0 : share[i] * share[i];
        if (!(give > 0.0)) continue;
        for (int32_t i = 0; i < 4; i++)
            for (int32_t d = 0; d < 3 && !held[node[i]]; d++)
                x[3 * (int64_t)node[i] + d] += (least - apart) / give * share[i] * normal[d];
        moved++;
    }
    return moved;
}


/* for a build of all files in one */
#undef MUS_REAL
#undef MUS_FIELD
#undef MUS_SELF
#undef MUS_SELF_LOOK
#undef MUS_SQRT
