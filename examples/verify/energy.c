/*
 * energy.c: the energy of cloth in motion, by both steppers near their bounds (case I13).
 *
 * Without drag and damping the energy of a cloth that nothing pushes stays. Runge-Kutta loses energy near its bound.
 * Velocity Verlet keeps an energy of its own, which differs from the true one by sum h^2 |F|^2 / (8 m): the true one
 * swings, and a step beyond the resonance of motion feeds it without end.
 */
#include <math.h>
#include <stdio.h>

#include "command/args.h"
#include "verify.h"

#define GRAVITY 9.81


/* the scenes: which nodes of an n x n grid are fixed while it falls, swings and folds */
static const char *const energy_scenes[] = {"a corner", "two corners", "an edge", "its middle", "nothing"};

static bool energy_fixed(int32_t scene, int32_t n, int32_t node)
{
    switch (scene) {
    case 0: return node == 0;
    case 1: return node == 0 || node == n - 1;
    case 2: return node < n;
    case 3: return node == n / 2 * (n + 1);
    default: return false;
    }
}


/* a square grid of jersey without drag and damping, to be stepped by a method; *mass [kg] */
static mus_status undamped_grid(verify *v, int32_t integrator, int32_t n, double cell, double *mass,
                                mus_drape **out)
{
    const double cells[2] = {cell, cell};
    mus_fabric fabric;
    mus_cloth_def cut;
    mus_drape_def def;
    mus_cloth *cloth = NULL;
    mus_fabric_init(&fabric, sizeof fabric);
    mus_cloth_def_init(&cut, sizeof cut);
    mus_drape_def_init(&def, sizeof def);
    fabric.damping = 0.0;
    cut.fabric = &fabric;
    def.precision = 64, def.drag = 0.0, def.integrator = integrator;
    mus_status status = mus_cloth_create_grid(v->context, n, n, cells, &cut, &cloth);
    if (status == MUS_OK) status = mus_drape_create(v->context, cloth, NULL, &def, out);
    if (status == MUS_OK) *mass = mus_cloth_mass(cloth);
    mus_cloth_destroy(cloth);
    return status;
}


/* largest gain of energy in 10 s without drag and damping at 0.99 of the bound, as part of the weight times half the
 * width; of a cloth that nothing holds, which turns without gravity, as part of its energy */
static mus_status energy_gain(verify *v, int32_t integrator, int32_t scene, double *gain)
{
    enum { SIDE = 12, NODES = SIDE * SIDE };
    const double cell = 0.02, turn = 5.0, none[3] = {0};
    double x[3 * NODES], s[3 * NODES] = {0}, mass = 0.0;
    mus_drape *drape = NULL;
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    mus_status status = undamped_grid(v, integrator, SIDE, cell, &mass, &drape);
    if (status != MUS_OK) return status;
    for (int32_t i = 0; i < NODES; i++) {
        const double a = cell * (i % SIDE - 0.5 * (SIDE - 1)), b = cell * (i / SIDE - 0.5 * (SIDE - 1));
        x[3 * i] = a, x[3 * i + 1] = 1e-3 * sin(40.0 * a) * cos(31.0 * b), x[3 * i + 2] = b;
        if (scene == 4) s[3 * i] = turn * b, s[3 * i + 1] = 0.3 * sin(20.0 * a), s[3 * i + 2] = -turn * a;
    }
    status = mus_drape_set_state(drape, x, s);
    if (status == MUS_OK && scene == 4) status = mus_drape_set_gravity(drape, none);
    for (int32_t i = 0; i < NODES && status == MUS_OK; i++)
        if (energy_fixed(scene, SIDE, i)) status = mus_drape_pin(drape, i, 1);
    if (status == MUS_OK) status = mus_drape_report_get(drape, &report);
    const double start = report.energy;
    const double scale = scene == 4 ? start : mass * GRAVITY * 0.5 * cell * (SIDE - 1);
    for (*gain = 0.0; status == MUS_OK && mus_drape_time(drape) < 10.0;) {
        status = mus_drape_step(drape, 64, 0.99 * mus_drape_step_bound(drape));
        if (status == MUS_OK) status = mus_drape_report_get(drape, &report);
        if (status == MUS_OK) *gain = fmax(*gain, (report.energy - start) / scale);
    }
    mus_drape_destroy(drape);
    return status;
}


int verify_energy(verify *v)
{
    if (!verify_wants(v, "I13")) return EXIT_DONE;
    for (int32_t method = 0; method < 2; method++)
        for (int32_t scene = 0; scene < 5; scene++) {
            char text[96];
            double gain = NAN;
            const mus_status status = energy_gain(v, method ? MUS_METHOD_VERLET : MUS_METHOD_RK4, scene, &gain);
            snprintf(text, sizeof text, "cloth held by %s for 10 s at 0.99 of the bound, gain of energy, %s",
                     energy_scenes[scene], method ? "Verlet" : "RK4");
            if (status == MUS_OK)
                verify_add(v, "I13", text, 0.0, gain, 0.01);
            else
                verify_broken(v, "I13", text, status);
        }
    return EXIT_DONE;
}
