/* bare.h: drapes of a few bare nodes, and grids, for the extreme cases. */
#ifndef MUS_TESTS_BARE_H
#define MUS_TESTS_BARE_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/drape.h"
#include "support.h"

/* a drape of `cloth`, which it keeps; no drag */
static inline mus_drape *extreme_drape(mus_context *context, mus_cloth *cloth, int32_t precision, const double *gravity)
{
    mus_drape *drape;
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.drag = 0.0;
    memcpy(def.gravity, gravity, sizeof def.gravity);
    ck_assert_msg(mus_drape_create(context, cloth, NULL, &def, &drape) == MUS_OK, "%s", mus_context_error(context));
    mus_cloth_destroy(cloth);
    return drape;
}


/* nodes along x at `place`, neighbours joined by springs of one length and stiffness, the first held if `pin` */
static inline mus_cloth *extreme_chain(mus_context *context, int32_t n, const double *place, const double *mass,
                                       double length, double stiffness, bool pin)
{
    double x[3 * 64] = {0}, rest[64], k[64];
    int32_t spring[2 * 64];
    const int32_t first = 0;
    ck_assert_int_le(n, 64);
    for (int32_t i = 0; i < n; i++) {
        x[3 * i] = place[i];
        rest[i] = length, k[i] = stiffness;
        spring[2 * i] = i, spring[2 * i + 1] = i + 1;
    }
    mus_bare bare;
    mus_cloth *cloth;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = n, bare.springs = n > 1 ? n - 1 : 0, bare.pins = pin;
    bare.place = x, bare.mass = mass, bare.spring = spring, bare.length = rest, bare.stiffness = k, bare.pin = &first;
    ck_assert_msg(mus_cloth_create_bare(context, &bare, &cloth) == MUS_OK, "%s", mus_context_error(context));
    return cloth;
}


/* rows x columns nodes of the fabric (NULL: the default one), `cell` apart both ways */
static inline mus_cloth *extreme_grid(mus_context *context, int32_t rows, int32_t columns, double cell,
                                      const mus_fabric *fabric)
{
    const double cells[2] = {cell, cell};
    mus_cloth *cloth;
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    def.fabric = fabric;
    ck_assert_msg(mus_cloth_create_grid(context, rows, columns, cells, &def, &cloth) == MUS_OK, "%s",
                  mus_context_error(context));
    return cloth;
}


static inline mus_drape_report extreme_report(const mus_drape *drape)
{
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    return report;
}


static inline void extreme_finite(const mus_drape *drape)
{
    const double *x = mus_drape_positions(drape), *v = mus_drape_velocities(drape);
    for (int32_t i = 0; i < 3 * mus_drape_node_count(drape); i++)
        ck_assert_msg(isfinite(x[i]) && isfinite(v[i]), "node %d: %g m, %g m/s", (int)(i / 3), x[i], v[i]);
}

#endif
