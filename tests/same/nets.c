/*
 * nets.c: rows "nets/...": rectangles of one lattice and nets of bare nodes without a body, stepped by each integrator
 * in float and in double; and "integrate/...": the integrators on a chain of masses.
 */
#include "scene.h"

#include <stdlib.h>
#include <string.h>

/* ---- cloth without a body ---- */

static mus_drape *drape_of(same_run *run, const mus_cloth *cloth, int32_t flags)
{
    mus_drape_def def;
    mus_drape *drape = NULL;
    mus_drape_def_init(&def, sizeof def);
    def.precision = flags & SCENE_DOUBLE ? 64 : 32;
    def.integrator = flags & SCENE_VERLET ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    def.self_contact = (flags & SCENE_SELF) != 0;
    same_must(run, mus_drape_create(run->context, cloth, NULL, &def, &drape), "mus_drape_create");
    return drape;
}


/* steps of half the bound, a few dozen at once, then rest when it is asked */
static void let_go(same_run *run, const mus_cloth *cloth, int32_t flags, bool settle)
{
    mus_drape *drape = drape_of(run, cloth, flags);
    if (mus_cloth_panel_count(cloth) > 0) same_must(run, mus_drape_pin(drape, 0, 1), "mus_drape_pin");
    for (int i = 0; i < 6; i++) same_status(run, mus_drape_step(drape, 40, 0.5 * mus_drape_step_bound(drape)));
    same_drape(run, drape, cloth);
    if (settle) same_status(run, mus_drape_settle(drape, NULL, NULL));
    same_drape(run, drape, cloth);
}


static void make_grid(same_run *run, const void *what, int32_t flags)
{
    (void)what;
    const double cell[2] = {0.02, 0.025};
    mus_cloth_def cut;
    mus_cloth *cloth = NULL;
    mus_cloth_def_init(&cut, sizeof cut);
    if (flags & SCENE_PAPER) cut.bending = MUS_BEND_PAPER;
    same_must(run, mus_cloth_create_grid(run->context, 18, 14, cell, &cut, &cloth), "mus_cloth_create_grid");
    let_go(run, cloth, flags, true);
}


#define SIDE 8
#define NODES (SIDE * SIDE)

/* a square net: springs along both ways, some with dashpots, and bends along the rows; two corners held */
static void make_net(same_run *run, const void *what, int32_t flags)
{
    (void)what;
    double place[3 * NODES], mass[NODES], length[2 * NODES], stiffness[2 * NODES], dashpot[2 * NODES], bending[NODES];
    int32_t spring[4 * NODES], bend[3 * NODES], springs = 0, bends = 0;
    const int32_t pin[2] = {0, SIDE - 1};
    for (int32_t i = 0; i < NODES; i++) {
        const int32_t row = i / SIDE, column = i % SIDE, next[2] = {i + 1, i + SIDE};
        const double xyz[3] = {0.05 * column, -0.05 * row, 0.001 * (i % 3)};
        memcpy(place + 3 * (ptrdiff_t)i, xyz, sizeof xyz);
        mass[i] = 0.001 + 0.0001 * (i % 4);
        for (int way = 0; way < 2; way++) {
            if (way == 0 ? column == SIDE - 1 : row == SIDE - 1) continue;
            spring[2 * springs] = i, spring[2 * springs + 1] = next[way];
            length[springs] = 0.05, stiffness[springs] = 20.0 + i, dashpot[springs] = way == 0 ? 0.01 : 0.0;
            springs++;
        }
        if (column > SIDE - 3) continue;
        for (int32_t k = 0; k < 3; k++) bend[3 * bends + k] = i + k;
        bending[bends++] = 0.5;
    }
    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = NODES, bare.springs = springs, bare.bends = bends, bare.pins = 2;
    bare.place = place, bare.mass = mass, bare.spring = spring, bare.length = length, bare.stiffness = stiffness;
    bare.dashpot = dashpot, bare.bend = bend, bare.bend_stiffness = bending, bare.pin = pin;
    same_must(run, mus_cloth_create_bare(run->context, &bare, &cloth), "mus_cloth_create_bare");
    let_go(run, cloth, flags, true);
}


/* Hashes a cloth: nodes, masses, triangles, pairs, borders. */
static void make_cloth(same_run *run, const void *what, int32_t index)
{
    static const double spacings[] = {0.01, 0.02, 0.035};
    const same_scene scene = {NULL, what, "W40", 1000.0 * spacings[index], 0, NULL};
    const mus_cloth *cloth = same_place(run, &scene).cloth;
    const int64_t nodes = mus_cloth_node_count(cloth), pairs = mus_cloth_pair_count(cloth);
    same_reals(run, mus_cloth_rest(cloth), 2 * nodes);
    same_reals(run, mus_cloth_masses(cloth), nodes);
    same_ints(run, mus_cloth_node_panels(cloth), nodes);
    same_ints(run, mus_cloth_triangles(cloth), 3 * (int64_t)mus_cloth_triangle_count(cloth));
    same_ints(run, mus_cloth_pairs(cloth), 2 * pairs);
    same_ints(run, mus_cloth_pair_seams(cloth), pairs);
    same_int(run, mus_cloth_spring_count(cloth));
    same_real(run, mus_cloth_mass(cloth));
    for (int32_t p = 0; p < mus_cloth_panel_count(cloth); p++) {
        const int32_t *border = NULL;
        int32_t n = 0, range[4];
        same_must(run, mus_cloth_panel_border(cloth, p, &n, &border), "mus_cloth_panel_border");
        same_ints(run, border, n);
        same_must(run, mus_cloth_panel_range(cloth, p, range), "mus_cloth_panel_range");
        same_ints(run, range, 4);
    }
}


/* ---- the integrators ---- */

#define MASSES 20

/* a chain of masses on springs between two walls, a little damped: y = [x | v] */
static void chain(void *user, double t, const double *y, double *dy)
{
    (void)user, (void)t;
    for (int i = 0; i < MASSES; i++) {
        const double left = i > 0 ? y[i - 1] : 0.0, right = i < MASSES - 1 ? y[i + 1] : 0.0;
        dy[i] = y[MASSES + i];
        dy[MASSES + i] = 100.0 * (left - 2.0 * y[i] + right) - 0.1 * y[MASSES + i];
    }
}


static void chain32(void *user, double t, const float *y, float *dy)
{
    (void)user, (void)t;
    for (int i = 0; i < MASSES; i++) {
        const float left = i > 0 ? y[i - 1] : 0.0F, right = i < MASSES - 1 ? y[i + 1] : 0.0F;
        dy[i] = y[MASSES + i];
        dy[MASSES + i] = 100.0F * (left - 2.0F * y[i] + right) - 0.1F * y[MASSES + i];
    }
}


/* 500 steps that are stable, then some that are not and end in a last good state */
static void make_integrate(same_run *run, const void *what, int32_t method)
{
    const bool single = what != NULL;
    double y[2 * MASSES] = {0}, work[16 * 2 * MASSES];
    float y32[2 * MASSES] = {0}, work32[16 * 2 * MASSES];
    mus_integrate_def def;
    mus_integrate_def_init(&def, sizeof def);
    def.method = method, def.rate = chain, def.rate32 = chain32;
    y[3] = 0.1, y[MASSES + 9] = 1.0, y32[3] = 0.1F, y32[MASSES + 9] = 1.0F;
    same_int(run, mus_integrate_work(method, 2 * MASSES));
    for (int turn = 0; turn < 2; turn++) {
        int64_t done = -1;
        def.step = turn == 0 ? 0.01 : 0.5;
        same_status(run, single ? mus_integrate_f32(run->context, &def, 2 * MASSES, y32, 500, work32, &done)
                                : mus_integrate(run->context, &def, 2 * MASSES, y, 500, work, &done));
        for (int i = 0; i < 2 * MASSES && single; i++) y[i] = (double)y32[i];
        same_int(run, done);
        same_reals(run, y, 2 * MASSES);
    }
}


void same_nets(same_list *list)
{
    static const struct {
        const char *name;
        int32_t flags;
    } kinds[] = {{"rk4-float", 0},
                 {"rk4-double", SCENE_DOUBLE},
                 {"verlet-float", SCENE_VERLET},
                 {"verlet-double", SCENE_VERLET | SCENE_DOUBLE}};
    static const char *const methods[] = {"rk4", "verlet", "euler"}, *const cut[] = {"tshirt", "kilt", "wrap_dress"};
    for (int i = 0; i < 4; i++) {
        same_add(list, make_grid, "nets/grid-%s", kinds[i].name)->index = kinds[i].flags;
        same_add(list, make_net, "nets/bare-%s", kinds[i].name)->index = kinds[i].flags;
    }
    same_add(list, make_grid, "nets/grid-self")->index = SCENE_SELF;
    same_add(list, make_grid, "nets/grid-paper")->index = SCENE_PAPER;
    for (int i = 0; i < 3; i++) {
        same_row *row = same_add(list, make_cloth, "nets/cloth-%s", cut[i]);
        row->what = cut[i], row->index = i;
        same_add(list, make_integrate, "integrate/%s-double", methods[i])->index = i;
        row = same_add(list, make_integrate, "integrate/%s-float", methods[i]);
        row->what = "float", row->index = i;
    }
}
