/*
 * force.c: every force law alone is the gradient of its energy, and turns and moves nothing as a whole
 * (case I11).
 *
 * By mus_drape_forces() and the energy of mus_drape_report_get(), in a thousand random states a law, one in four folded
 * flat or crumpled to a fifth.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command/args.h"
#include "verify.h"

#define NODES 25
#define STATES 1000
#define SIZE 0.01 /* of a cell and of a spring [m] */


/* a random number in -1 .. 1, the same in every run */
static double noise(uint64_t *state)
{
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(*state >> 11) * 0x1p-52 - 1.0;
}


static mus_status weightless(verify *v, mus_cloth *cloth, mus_drape **out)
{
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    memset(def.gravity, 0, sizeof def.gravity);
    const mus_status status = mus_drape_create(v->context, cloth, NULL, &def, out);
    mus_cloth_destroy(cloth);
    return status;
}


/* bare nodes: springs of a rest length in a row, or bends over three in a row */
static mus_status bare_law(verify *v, double rest, bool bends, mus_drape **out)
{
    double place[3 * NODES] = {0}, mass[NODES], length[NODES], stiffness[NODES];
    int32_t spring[2 * NODES], bend[3 * NODES];
    for (int32_t i = 0; i < NODES; i++) {
        place[3 * i] = SIZE * i, mass[i] = 1e-5, length[i] = rest, stiffness[i] = 500.0;
        spring[2 * i] = i, spring[2 * i + 1] = i + 1;
        for (int32_t k = 0; k < 3; k++) bend[3 * i + k] = i + k;
    }
    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = NODES, bare.place = place, bare.mass = mass;
    bare.springs = bends ? 0 : NODES - 1, bare.spring = spring, bare.length = length, bare.stiffness = stiffness;
    bare.bends = bends ? NODES - 2 : 0, bare.bend = bend, bare.bend_stiffness = stiffness;
    const mus_status status = mus_cloth_create_bare(v->context, &bare, &cloth);
    return status == MUS_OK ? weightless(v, cloth, out) : status;
}


/* a 5 x 5 grid of threads, shear springs and bending, each left out or not */
static mus_status grid_law(verify *v, double stretch, double shear, double bend, int32_t bending, mus_drape **out)
{
    const double cell[2] = {SIZE, 1.2 * SIZE};
    mus_cloth_def def;
    mus_cloth *cloth = NULL;
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    def.bending = bending;
    fabric.stretch[0] = stretch, fabric.stretch[1] = 0.8 * stretch, fabric.shear = shear;
    for (int k = 0; k < 3; k++) fabric.bend[k] = bend;
    const mus_status status = mus_cloth_create_grid(v->context, 5, 5, cell, &def, &cloth);
    return status == MUS_OK ? weightless(v, cloth, out) : status;
}


/* places of one state: disturbed by half a cell; crumpled; or folded flat along a line */
static void random_state(uint64_t *random, int32_t number, const double *rest, double *x)
{
    for (int32_t i = 0; i < NODES; i++, x += 3, rest += 3)
        for (int d = 0; d < 3; d++) {
            const bool crumpled = number % 8 == 0, folded = number % 8 == 4;
            x[d] = (crumpled ? 0.2 : 1.0) * rest[d] + 0.5 * SIZE * noise(random);
            if (folded) x[d] = d == 0 ? fabs(rest[0] - 2.2 * SIZE) : rest[d] + 1e-3 * SIZE * noise(random);
        }
}


static mus_status energy_at(mus_drape *drape, const double *x, const double *way, double by, double *energy)
{
    double moved[3 * NODES];
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    for (int32_t i = 0; i < 3 * NODES; i++) moved[i] = x[i] + by * way[i];
    mus_status status = mus_drape_set_state(drape, moved, NULL);
    if (status == MUS_OK) status = mus_drape_report_get(drape, &report);
    *energy = report.energy;
    return status;
}


/* worst of one state: slope of the energy along a random way, by differences of order four, against -f; sums of f and
 * of x x f */
static mus_status check_state(mus_drape *drape, uint64_t *random, const double *x, double *worst)
{
    static const double weight[4] = {1.0 / 12.0, -8.0 / 12.0, 8.0 / 12.0, -1.0 / 12.0}, at[4] = {-2, -1, 1, 2};
    const double step = 1e-5 * SIZE;
    double f[3 * NODES], way[3 * NODES], slope = 0.0, work = 0.0, size = 0.0, sum[3] = {0}, turn[3] = {0}, lever = 0.0;
    mus_status status = mus_drape_set_state(drape, x, NULL);
    if (status == MUS_OK) status = mus_drape_forces(drape, f);
    for (int32_t i = 0; i < 3 * NODES; i++) way[i] = noise(random);
    for (int k = 0; k < 4 && status == MUS_OK; k++) {
        double energy = 0.0;
        status = energy_at(drape, x, way, at[k] * step, &energy);
        slope += weight[k] * energy / step;
    }
    for (int32_t i = 0; i < 3 * NODES && status == MUS_OK; i++) {
        const int32_t d = i % 3, e = (d + 1) % 3, g = (d + 2) % 3, node = i - d;
        work += f[i] * way[i];
        size += fabs(f[i]);
        sum[d] += f[i];
        turn[d] += x[node + e] * f[node + g] - x[node + g] * f[node + e];
        lever = fmax(lever, fabs(x[i]));
    }
    worst[0] = fmax(worst[0], fabs(slope + work) / size);
    for (int d = 0; d < 3; d++) {
        worst[1] = fmax(worst[1], fabs(sum[d]) / size);
        worst[2] = fmax(worst[2], fabs(turn[d]) / (size * lever));
    }
    return status;
}


static void check_law(verify *v, const char *law, mus_status status, mus_drape *drape)
{
    static const char *const names[3] = {"f + grad E", "sum of f", "sum of x x f"};
    static const double tolerance[3] = {1e-7, 1e-14, 1e-14};
    double rest[3 * NODES], x[3 * NODES], worst[3] = {0};
    uint64_t random = 5;
    if (status == MUS_OK) memcpy(rest, mus_drape_positions(drape), sizeof rest);
    for (int32_t s = 0; s < STATES && status == MUS_OK; s++) {
        random_state(&random, s, rest, x);
        status = check_state(drape, &random, x, worst);
    }
    if (status != MUS_OK) verify_broken(v, "I11", law, status);
    for (int k = 0; k < 3 && status == MUS_OK; k++) {
        char text[80];
        snprintf(text, sizeof text, "%s, %d states: %s / sum |f|", law, STATES, names[k]);
        verify_add(v, "I11", text, 0.0, worst[k], tolerance[k]);
    }
    mus_drape_destroy(drape);
}


int verify_force(verify *v)
{
    if (!verify_wants(v, "I11")) return EXIT_DONE;
    mus_drape *drape = NULL;
    mus_status status = bare_law(v, SIZE, false, &drape);
    check_law(v, "springs", status, drape);
    status = bare_law(v, 0.0, false, &drape);
    check_law(v, "springs of no length", status, drape);
    status = bare_law(v, 0.0, true, &drape);
    check_law(v, "second differences", status, drape);
    status = grid_law(v, 1000.0, 0.0, 0.0, MUS_BEND_PLATE, &drape);
    check_law(v, "threads of a grid", status, drape);
    status = grid_law(v, 1000.0, 300.0, 0.0, MUS_BEND_PLATE, &drape);
    check_law(v, "threads and shear", status, drape);
    status = grid_law(v, 1000.0, 300.0, 1e-3, MUS_BEND_PLATE, &drape);
    check_law(v, "threads, shear, bending", status, drape);
    status = grid_law(v, 1000.0, 300.0, 1e-6, MUS_BEND_PAPER, &drape);
    check_law(v, "threads, shear, skip-one springs", status, drape);
    return EXIT_DONE;
}
