/*
 * bend_clamp.c: finds the bending elements at clamps (bend_clamp.h).
 */
#include <string.h>

#include "base/sort.h"
#include "sim/bend_clamp.h"


/* whether the elements over the edge node[0] node[1] are at a clamp; *free_wing is then 2 or 3, the node that moves */
static bool at_clamp(const int32_t *node, const int32_t *fixed, int32_t bit, int32_t *free_wing)
{
    const int32_t far = (fixed[node[2]] & bit) != 0, other = (fixed[node[3]] & bit) != 0;
    *free_wing = far ? 3 : 2;
    return (fixed[node[0]] & bit) != 0 && (fixed[node[1]] & bit) != 0 && far != other;
}


/* appends the clamp of an element, the free node first; out NULL counts alone */
static void add_clamp(const mus__hinge *hinge, const int32_t *fixed, int32_t bit, mus__hinge *out, int32_t *count)
{
    int32_t wing;
    if (!at_clamp(hinge->node, fixed, bit, &wing)) return;
    if (out != NULL) {
        mus__hinge *clamp = &out[*count];
        *clamp = *hinge;
        clamp->node[0] = hinge->node[wing], clamp->coef[0] = hinge->coef[wing];
        clamp->node[wing] = hinge->node[0], clamp->coef[wing] = hinge->coef[0];
    }
    ++*count;
}


/* counts the stencils at clamps (out NULL) or writes their clamps */
static int32_t clamp_stencils(const mus_cloth *cloth, const int32_t *fixed, int32_t bit, mus__hinge *out)
{
    int32_t count = 0;
    for (int32_t r = 0; r < cloth->nbend; r++) {
        const mus__bend_run *bend = &cloth->bend[r];
        for (int32_t i = 0; i < bend->count; i++) {
            const mus__hinge stencil = {.node = {bend->b + i, bend->b + i, bend->a + i, bend->c + i},
                                        .coef = {-1.0, -1.0, 1.0, 1.0},
                                        .k = bend->k};
            add_clamp(&stencil, fixed, bit, out, &count);
        }
    }
    return count;
}


static int clamp_by_node(const void *a, const void *b)
{
    const mus__hinge *p = a, *q = b;
    for (int32_t i = 0; i < 4; i++)
        if (p->node[i] != q->node[i]) return p->node[i] < q->node[i] ? -1 : 1;
    return 0;
}


mus_status mus__clamps_room(mus_context *context, const mus_cloth *cloth, const int32_t *fixed, int32_t bit,
                            mus__program *program)
{
    int64_t need = program->hinge_capacity;
    if (cloth->place != NULL) return MUS_OK;
    for (int32_t r = 0; r < cloth->nbend && fixed == NULL; r++) need += cloth->bend[r].count;
    if (fixed != NULL) need += clamp_stencils(cloth, fixed, bit, NULL);
    if (need <= program->clamp_capacity) return MUS_OK;
    mus__hinge *clamp = mus__new(context, need + need / 4, sizeof *clamp);
    if (clamp == NULL) return mus__fail_memory(context, "the clamps of a drape");
    if (program->nclamp > 0) memcpy(clamp, program->clamp, (size_t)program->nclamp * sizeof *clamp);
    mus__free(context, program->clamp);
    program->clamp = clamp;
    program->clamp_capacity = need + need / 4;
    return MUS_OK;
}


void mus__clamps_update(const mus_cloth *cloth, const int32_t *fixed, int32_t bit, mus__program *program)
{
    if (program->clamp_capacity == 0) return;
    int32_t count = clamp_stencils(cloth, fixed, bit, program->clamp);
    for (int32_t h = 0; h < program->nhinge; h++) add_clamp(&program->hinge[h], fixed, bit, program->clamp, &count);
    program->nclamp = count;
    mus__sort(program->clamp, (size_t)count, sizeof *program->clamp, clamp_by_node);
    for (int32_t c = 0, k = 0; c < program->nchunk; c++) {
        mus__chunk *chunk = &program->chunk[c];
        chunk->clamp = k;
        while (k < count && program->clamp[k].node[0] < chunk->first + chunk->count) k++;
        chunk->nclamp = k - chunk->clamp;
    }
    for (int32_t s = 0; s < program->nslider; s++) {
        mus__slider *slider = &program->slider[s];
        int32_t wing;
        const int32_t now = at_clamp(slider->node, fixed, bit, &wing);
        if (now != slider->clamped) slider->k *= now ? 2.0 : 0.5;
        slider->clamped = now;
    }
}


double mus__clamps_force(const mus__program *program, const double *x, double *f)
{
    double energy = 0.0;
    for (int32_t k = 0; k < program->nclamp; k++) {
        const mus__hinge *clamp = &program->clamp[k];
        for (int32_t d = 0; d < 3; d++) {
            double e = 0.0;
            for (int32_t c = 0; c < 4; c++) e += clamp->coef[c] * x[3 * (int64_t)clamp->node[c] + d];
            if (f != NULL) f[3 * (int64_t)clamp->node[0] + d] -= clamp->k * clamp->coef[0] * e;
            energy += 0.5 * clamp->k * e * e;
        }
    }
    return energy;
}
