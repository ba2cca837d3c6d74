/*
 * bend_slider_kernel.h: the sliders of a sim, as a template on the floating type (included by sim_kernel.h).
 *
 * e - slip is measured along e, the normal of the bent cloth, so that turning a bent cloth as a whole moves no slider.
 * An element that is nearly flat has no such direction; its slider is measured as a vector.
 */

/* moves the sliders to the places y and writes the forces that they add until the next step */
static void MUS__NAME(slide)(mus__sim *sim)
{
    const mus__program *program = sim->program;
    const int64_t n = sim->n;
    const MUS__REAL *y = sim->y;
    MUS__REAL *f = sim->slide_force;
    memset(f, 0, 3 * (size_t)n * sizeof *f);
    for (int32_t s = 0; s < program->nslider; s++) {
        mus__slider *slider = &program->slider[s];
        const int32_t *node = slider->node;
        const double *c = slider->coef, most = slider->most;
        double e[3], size2 = 0.0, along = 0.0, far2 = 0.0;
        for (int32_t d = 0; d < 3; d++) {
            const MUS__REAL *p = y + d * n;
            e[d] = c[0] * (double)p[node[0]] + c[1] * (double)p[node[1]] + c[2] * (double)p[node[2]] +
                   c[3] * (double)p[node[3]];
            size2 += e[d] * e[d];
            along += e[d] * slider->slip[d];
            far2 += (e[d] - slider->slip[d]) * (e[d] - slider->slip[d]);
        }
        if (size2 > most * most) {
            const double size = sqrt(size2), slip = along / size;
            const double now = slip < size - most ? size - most : slip > size + most ? size + most : slip;
            for (int32_t d = 0; d < 3; d++) slider->slip[d] = now / size * e[d];
        } else if (far2 > most * most) {
            const double part = most / sqrt(far2);
            for (int32_t d = 0; d < 3; d++) slider->slip[d] = e[d] - part * (e[d] - slider->slip[d]);
        }
        for (int32_t d = 0; d < 3; d++)
            for (int32_t i = 0; i < 4; i++) f[d * n + node[i]] += (MUS__REAL)(slider->k * c[i] * slider->slip[d]);
    }
}


/* after a step: moves the sliders when MUS__SLIDE_STEPS have passed */
static void MUS__NAME(slide_step)(mus__sim *sim)
{
    if (++sim->slide_age < MUS__SLIDE_STEPS) return;
    sim->slide_age = 0;
    MUS__NAME(slide)(sim);
}


/* starts the sliders from the flat cloth, bent once to where it is now */
static void MUS__NAME(slide_start)(mus__sim *sim)
{
    mus__program *program = sim->program;
    for (int32_t s = 0; s < program->nslider; s++) memset(program->slider[s].slip, 0, sizeof program->slider[s].slip);
    sim->slide_age = 0;
    if (program->nslider > 0) MUS__NAME(slide)(sim);
}


/* adds the forces of the sliders to those of a chunk */
static void MUS__NAME(slide_add)(const mus__sim *sim, const mus__chunk *chunk, MUS__REAL *f)
{
    for (int64_t d = 0; d < 3; d++) {
        const MUS__REAL *from = (const MUS__REAL *)sim->slide_force + d * sim->n + chunk->first;
        for (int32_t i = 0; i < chunk->count; i++) f[d * MUS__SPAN + i] += from[i];
    }
}
