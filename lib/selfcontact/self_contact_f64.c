/* self_contact_f64.c: cloth against cloth in double. */
#include <math.h>
#include <string.h>

#include "base/target_clones.h"
#include "selfcontact/self_contact.h"
#include "contact/contact_template.h"

#define MUS__REAL double
#define MUS__NAME(name) mus__##name##_f64
#include "selfcontact/self_response_kernel.h"


int32_t mus__self_contact_separate(const mus__self_contact *self, double least, const int32_t *held, double *x)
{
    const int32_t edges = self->pair_capacity - (self->npair - self->nnode_pair);
    int32_t moved = 0;
    for (int32_t k = 0; k < self->pair_capacity; k++) {
        if (k == self->nnode_pair) k = edges;
        if (k == self->pair_capacity) break;
        const int32_t *node = self->pair[k].node;
        double p[4][3], weight[4], normal[3], give = 0.0;
        for (int32_t i = 0; i < 4; i++) memcpy(p[i], x + 3 * (int64_t)node[i], sizeof p[i]);
        const double d2 = mus__self_pair_measure_f64(k >= self->nnode_pair, p, weight);
        if (!(d2 < least * least) || !(d2 > 0.0)) continue;
        const double apart = sqrt(d2);
        for (int32_t d = 0; d < 3; d++)
            normal[d] = (weight[0] * p[0][d] + weight[1] * p[1][d] + weight[2] * p[2][d] + weight[3] * p[3][d]) / apart;
        for (int32_t i = 0; i < 4; i++) give += held[node[i]] ? 0.0 : weight[i] * weight[i];
        if (!(give > 0.0)) continue;
        for (int32_t i = 0; i < 4; i++)
            for (int32_t d = 0; d < 3 && !held[node[i]]; d++)
                x[3 * (int64_t)node[i] + d] += (least - apart) / give * weight[i] * normal[d];
        moved++;
    }
    return moved;
}


/* for a build of all files in one */
#undef MUS__REAL
#undef MUS__NAME
