/*
 * tacked.h: what the tests of tacks share: a tack that goes in, a run that goes well, two nodes, a sheet that swings.
 */
#ifndef MUS_TESTS_TACKED_H
#define MUS_TESTS_TACKED_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drape/drape_state.h"
#include "extreme/bare.h"
#include "scenes.h"

enum { SIDE = 24, NODES = SIDE * SIDE };


static inline int32_t tack(mus_drape *drape, int32_t a, int32_t b, double stiffness)
{
    int32_t index = MUS_NONE;
    const mus_status status = mus_drape_tack(drape, a, b, stiffness, &index);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(drape->context));
    return index;
}


static inline void run(mus_drape *drape, int32_t steps, double dt)
{
    ck_assert_msg(mus_drape_step(drape, steps, dt) == MUS_OK, "%s", mus_context_error(drape->context));
}


static inline double gap_of(const mus_drape *drape, int32_t a, int32_t b)
{
    const double *p = mus_drape_positions(drape) + 3 * a, *q = mus_drape_positions(drape) + 3 * b;
    return sqrt((q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]) + (q[2] - p[2]) * (q[2] - p[2]));
}


/* two nodes at (0, 0, 0) and (d, 0, 0), no spring between them, the first held if `pin` */
static inline mus_drape *two_nodes(mus_context *context, const double *mass, double d, int32_t pin, mus_drape_def *def)
{
    const double place[6] = {0, 0, 0, d, 0, 0};
    const int32_t first = 0;
    mus_bare bare;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 2, bare.pins = pin, bare.place = place, bare.mass = mass, bare.pin = &first;
    ck_assert_msg(mus_cloth_create_bare(context, &bare, &cloth) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, def, &drape), MUS_OK);
    mus_cloth_destroy(cloth);
    return drape;
}


/* a grid that has swung for a while, held at two corners */
static inline mus_drape *swung_grid(mus_context *context, int32_t precision, int32_t stepper, int32_t threads,
                                     double damping)
{
    mus_fabric fabric;
    mus_drape_def def;
    mus_drape *drape;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.damping = damping;
    mus_cloth *cloth = extreme_grid(context, SIDE, SIDE, 0.02, &fabric);
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision, def.integrator = stepper, def.threads = threads, def.drag = 0.0;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    mus_cloth_destroy(cloth);
    ck_assert_int_eq(mus_drape_pin(drape, NODES - SIDE, 1), MUS_OK);
    ck_assert_int_eq(mus_drape_pin(drape, NODES - 1, 1), MUS_OK);
    run(drape, 100, 0.5 * mus_drape_step_bound(drape));
    return drape;
}


/* forces of the kernels, of nodes (n x 3), to be freed */
static inline double *kernel_forces(mus_drape *drape)
{
    double *f = malloc(3 * (size_t)drape->n * sizeof *f);
    drape->sim.ops->force(&drape->sim);
    drape->sim.ops->get_force(&drape->sim, f);
    return f;
}

#endif
