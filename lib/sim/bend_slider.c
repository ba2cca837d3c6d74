/*
 * bend_slider.c: the sliders of a force program (bend_slider.h).
 */
#include <string.h>

#include "cloth/fabric.h"
#include "sim/bend_slider.h"

/* of hinges over the curvature of stencils: on a cylinder in any direction, hinges of equilateral triangles that slip
 * give sum B cos^2 = 3/2 B, the stencils' directions give 4/3 B (fabric.c) */
#define SLIDE_HINGE (8.0 / 9.0)
#define SLIDERS_MAX (1 << 27) /* sliders of a drape; keeps their count within 32 bits */


mus_status mus__sliders_create(mus_context *context, const mus_cloth *cloth, mus__program *program)
{
    int64_t count = program->hinge_capacity;
    program->nslider = program->slider_capacity = 0;
    if (!(cloth->bend_slide > 0.0)) return MUS_OK;
    for (int32_t r = 0; r < cloth->nbend; r++) count += cloth->bend[r].count;
    if (count > SLIDERS_MAX) return mus__fail(context, MUS_ERR_LIMIT, "drape: %lld sliders", (long long)count);
    program->slider = mus__new(context, count, sizeof *program->slider);
    if (program->slider == NULL) return mus__fail_memory(context, "the friction of bending");
    program->slider_capacity = (int32_t)count;
    return MUS_OK;
}


/* appends the sliders of a run of stencils */
static void add_stencils(const mus_cloth *cloth, const mus__bend_run *bend, mus__program *program)
{
    const double *p = cloth->rest + 2 * (int64_t)bend->a, *q = cloth->rest + 2 * (int64_t)bend->b;
    const double side2 = (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]);
    for (int32_t i = 0; i < bend->count; i++)
        program->slider[program->nslider++] =
            (mus__slider){.node = {bend->b + i, bend->b + i, bend->a + i, bend->c + i},
                          .coef = {-1.0, -1.0, 1.0, 1.0},
                          .k = cloth->bend_slide * bend->k,
                          .most = MUS__SLIDE_CURVATURE * side2};
}


void mus__sliders_fill(const mus_cloth *cloth, mus__program *program)
{
    if (program->slider_capacity == 0) return;
    program->nslider = 0;
    for (int32_t r = 0; r < cloth->nbend; r++) add_stencils(cloth, &cloth->bend[r], program);
    for (int32_t h = 0; h < program->nhinge; h++) {
        const mus__hinge *hinge = &program->hinge[h];
        mus__slider *slider = &program->slider[program->nslider++];
        *slider = (mus__slider){.k = cloth->bend_slide * hinge->k,
                                .most = SLIDE_HINGE * MUS__SLIDE_CURVATURE * hinge->area};
        memcpy(slider->node, hinge->node, sizeof slider->node);
        memcpy(slider->coef, hinge->coef, sizeof slider->coef);
    }
}


double mus__sliders_force(const mus__program *program, const double *x, double *f)
{
    double energy = 0.0;
    for (int32_t s = 0; s < program->nslider; s++) {
        const mus__slider *slider = &program->slider[s];
        for (int32_t d = 0; d < 3; d++) {
            double e = 0.0;
            for (int32_t c = 0; c < 4; c++) e += slider->coef[c] * x[3 * (int64_t)slider->node[c] + d];
            if (f != NULL)
                for (int32_t c = 0; c < 4; c++)
                    f[3 * (int64_t)slider->node[c] + d] += slider->k * slider->coef[c] * slider->slip[d];
            energy += slider->k * slider->slip[d] * (0.5 * slider->slip[d] - e);
        }
    }
    return energy;
}
