/* limbs.c: limbs and drapes for the cases of contact. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "limbs.h"


mus_limb limb_roller(double x, double y, double a, double b, double n, double *rows)
{
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    limb.origin[0] = x, limb.origin[1] = y;
    limb.axis[1] = 0.0, limb.axis[2] = 1.0;
    limb.pole[0] = -0.6, limb.pole[1] = 0.6;
    limb.contours = 2, limb.contour = rows;
    for (int i = 0; i < 2; i++) {
        const double row[6] = {i - 0.5, 0.0, 0.0, a, b, n};
        memcpy(rows + 6 * i, row, sizeof row);
    }
    return limb;
}


mus_status limb_make_roller(verify *v, double a, double b, double n, mus_body **out)
{
    double rows[12];
    const mus_limb limb = limb_roller(0.0, 0.0, a, b, n, rows);
    return mus_body_create_limbs(v->context, 1, &limb, NULL, out);
}


mus_status limb_make_sphere(verify *v, double r, int32_t n, mus_body **out)
{
    double rows[6 * MOST_CONTOURS];
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    for (int32_t i = 0; i < n; i++) {
        const double turn = PI * (i + 0.5) / n, row[6] = {-r * cos(turn), 0.0, 0.0, r * sin(turn), r * sin(turn), 2.0};
        memcpy(rows + 6 * i, row, sizeof row);
    }
    limb.contours = n, limb.contour = rows;
    limb.pole[0] = -r, limb.pole[1] = r;
    return mus_body_create_limbs(v->context, 1, &limb, NULL, out);
}


mus_status limb_meet(verify *v, mus_cloth *cloth, const mus_body *body, double friction, double clearance,
                     double gravity, mus_drape **out)
{
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    def.drag = 0.0;
    def.friction = friction;
    def.clearance = clearance;
    def.gravity[1] = -gravity;
    const mus_status status = cloth != NULL ? mus_drape_create(v->context, cloth, body, &def, out) : MUS_ERR_ARG;
    mus_cloth_destroy(cloth);
    return status;
}


mus_status limb_meet_point(verify *v, const mus_body *body, double friction, double gravity, const double *place,
                           const double *velocity, mus_drape **out)
{
    const double mass = 1.0;
    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 1, bare.place = place, bare.mass = &mass;
    mus_status status = mus_cloth_create_bare(v->context, &bare, &cloth);
    if (status == MUS_OK) status = limb_meet(v, cloth, body, friction, 0.0, gravity, out);
    return status == MUS_OK ? mus_drape_set_state(*out, place, velocity) : status;
}


mus_status limb_meet_sheet(verify *v, const mus_body *body, int32_t n, double cell, double height, double speed,
                           mus_drape **out)
{
    const double cells[2] = {cell, cell};
    mus_cloth_def def;
    mus_cloth *cloth = NULL;
    mus_cloth_def_init(&def, sizeof def);
    mus_status status = mus_cloth_create_grid(v->context, n, n, cells, &def, &cloth);
    if (status == MUS_OK) status = limb_meet(v, cloth, body, MU, 0.002, GRAVITY, out);
    if (status != MUS_OK) return status;
    double *state = calloc(6 * (size_t)n * (size_t)n, sizeof *state), *velocity = state + 3 * (ptrdiff_t)n * n;
    if (state == NULL) return MUS_ERR_MEMORY;
    for (int32_t i = 0; i < n * n; i++) {
        state[3 * i] = cell * (i % n - 0.5 * (n - 1));
        state[3 * i + 1] = height;
        state[3 * i + 2] = cell * (i / n - 0.5 * (n - 1));
        velocity[3 * i + 1] = speed;
    }
    status = mus_drape_set_state(*out, state, velocity);
    free(state);
    return status;
}


void limb_row(verify *v, mus_status status, const char *id, const char *text, double exact, double got,
              double tolerance)
{
    if (status == MUS_OK)
        verify_add(v, id, text, exact, got, tolerance);
    else
        verify_broken(v, id, text, status);
}


double limb_random(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}
