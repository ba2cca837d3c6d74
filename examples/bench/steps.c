/*
 * steps.c: times force evaluations and steps: a lattice of 10,000 nodes with all kinds of springs, with each left out,
 * and with other features added; the T-shirt; in float and double, with one thread and two.
 */
#include <math.h>
#include <stdlib.h>

#include "bench.h"

#define REPEATS 7
#define BUDGET 400000 /* node evaluations in one repeat: some milliseconds */
#define CELL 0.01
#define SIDE 100

/* features of a case beside the lattice with springs of every kind, bending and drag */
enum {
    BARE = 0,
    CONTACT = 1,
    DASHPOTS = 2,
    NO_SHEAR = 4,
    NO_BENDING = 8,
    NO_DRAG = 16,
    TSHIRT = 32,
    FORCE = 64,
    VERLET = 128,
    LARGE = 256
};

typedef struct speed_case {
    const char *name;
    int32_t has, precision, threads;
} speed_case;

static const speed_case cases[] = {
    {"lattice_force", FORCE, 32, 1},
    {"lattice_force", FORCE, 64, 1},
    {"lattice_rk4", BARE, 32, 1},
    {"lattice_rk4", BARE, 64, 1},
    {"lattice_rk4", BARE, 32, 2},
    {"lattice_rk4", BARE, 64, 2},
    {"lattice_verlet", VERLET, 32, 1},
    {"lattice_verlet", VERLET, 64, 1},
    {"lattice_rk4_no_shear", NO_SHEAR, 32, 1},
    {"lattice_rk4_no_bending", NO_BENDING, 32, 1},
    {"lattice_rk4_no_drag", NO_DRAG, 32, 1},
    {"lattice_rk4_minimal", NO_SHEAR | NO_BENDING | NO_DRAG, 32, 1},
    {"lattice_rk4_dashpots", DASHPOTS, 32, 1},
    {"lattice_rk4_contact", CONTACT, 32, 1},
    {"lattice_rk4_contact", CONTACT, 64, 1},
    {"tshirt_rk4", TSHIRT, 32, 1},
    {"tshirt_rk4", TSHIRT, 64, 1},
    {"tshirt_rk4", TSHIRT, 32, 2},
    {"tshirt_rk4_contact", TSHIRT | CONTACT, 32, 1},
    {"tshirt_verlet", TSHIRT | VERLET, 32, 1},
    {"lattice_rk4_million", LARGE, 32, 1},
    {"lattice_rk4_million", LARGE, 32, 2},
};


/* Along lines k = C11 - G, along diagonals G; for one rigidity B in every direction the stencils have 2/3 B / a^2 along
 * lines and B / (6 a^2) along diagonals. */
plain_lattice bench_lattice(const mus_fabric *fabric, int32_t side, double cell, double drag)
{
    const double k = fabric->stretch[0] - fabric->shear, bend = fabric->bend[0] / (cell * cell);
    return (plain_lattice){.rows = side,
                           .columns = side,
                           .cell = {cell, cell},
                           .k = {k, k},
                           .shear = fabric->shear,
                           .bend = {2.0 / 3.0 * bend, 2.0 / 3.0 * bend},
                           .cross = bend / 6.0,
                           .weight = fabric->weight,
                           .drag = drag};
}


/* the least CPU time [s] of `times` evaluations or steps, in one precision */
#define TIME_PLAIN(name, list, make, release, force, rk4, real)                                       \
    static double name(const plain_lattice *lattice, bool steps, int32_t times)                       \
    {                                                                                                 \
        list l;                                                                                       \
        double best = INFINITY;                                                                       \
        for (int32_t r = 0; make(lattice, &l) == 0 && r < REPEATS; r++, release(&l)) {                \
            const double start = bench_cpu();                                                         \
            for (int32_t i = 0; i < times; i++) {                                                     \
                if (steps) rk4(&l, (real)1e-5);                                                       \
                else force(&l, l.y);                                                                  \
            }                                                                                         \
            best = fmin(best, bench_cpu() - start);                                                   \
        }                                                                                             \
        release(&l);                                                                                  \
        return best;                                                                                  \
    }

TIME_PLAIN(time_plain32, plain32_list, plain32_make, plain32_free, plain32_force, plain32_rk4, float)
TIME_PLAIN(time_plain64, plain64_list, plain64_make, plain64_free, plain64_force, plain64_rk4, double)


double bench_plain(const plain_lattice *lattice, int32_t precision, bool steps)
{
    const int32_t nodes = lattice->rows * lattice->columns, times = BUDGET / nodes / (steps ? 4 : 1) + 1;
    const double all = precision == 64 ? time_plain64(lattice, steps, times) : time_plain32(lattice, steps, times);
    return all / ((double)nodes * times * (steps ? 4 : 1));
}


/* Returns the fabric of the hang scene (scenes.c), with bending in every direction. */
static mus_fabric fabric_of(const speed_case *c)
{
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.weight = 0.2;
    fabric.shear = c->has & NO_SHEAR ? 0.0 : 300.0;
    fabric.damping = c->has & DASHPOTS ? 0.02 : 0.0;
    for (int32_t d = 0; d < 2; d++) fabric.stretch[d] = 1000.0 + fabric.shear;
    for (int32_t d = 0; d < 3; d++) fabric.bend[d] = c->has & NO_BENDING ? 0.0 : 20.0 * CELL * CELL;
    return fabric;
}


/* Times several repeats of evaluations, or of steps near the bound; the row gets the fastest. */
static mus_status time_case(const speed_case *c, mus_drape *drape, bench_row *row)
{
    const int32_t each = c->has & (FORCE | VERLET) ? 1 : 4;
    const int32_t times = BUDGET / row->nodes / each + 1;
    double h = 0.9 * mus_drape_step_bound(drape);
    mus_status status = MUS_OK;
    row->cpu_s = INFINITY;
    row->evaluations = (int64_t)times * each;
    if (!(c->has & FORCE)) row->step = h;
    for (int32_t r = 0; r <= REPEATS && status == MUS_OK; r++) {
        /* the step bound of a sheet falls when a body pushes it */
        h = fmin(h, 0.9 * mus_drape_step_bound(drape));
        const double cpu = bench_cpu(), wall = bench_wall();
        status = c->has & FORCE ? mus_drape_evaluate(drape, times) : mus_drape_step(drape, times, h);
        const double took = bench_cpu() - cpu;
        if (r == 0 || took >= row->cpu_s) continue;
        row->cpu_s = took;
        row->wall_s = bench_wall() - wall;
    }
    return status;
}


/* Places a sheet upright before the body, from the knees up: it touches the foremost points of the body, and most of
 * its nodes are near enough to be queried. */
static mus_status lay_sheet(mus_drape *drape, int32_t nodes, const mus_body *body)
{
    const double *x = mus_drape_positions(drape), *skin = mus_body_vertices(body);
    const double low = 0.5, touch = 0.005;
    double front = 0.0;
    double *at = malloc(sizeof *at * 3 * (size_t)nodes);
    if (at == NULL) return MUS_ERR_MEMORY;
    for (int32_t i = 0; i < mus_body_vertex_count(body); i++)
        if (skin[3 * i + 1] > low + 0.2 && skin[3 * i + 1] < low + 0.9) front = fmax(front, skin[3 * i + 2]);
    for (int32_t i = 0; i < nodes; i++) {
        at[3 * i] = x[3 * i] - 0.5;
        at[3 * i + 1] = x[3 * i + 1] + low;
        at[3 * i + 2] = front - touch;
    }
    const mus_status status = mus_drape_set_state(drape, at, NULL);
    free(at);
    return status;
}


static mus_status run_case(bench *b, const speed_case *c, const mus_pattern *tshirt, const mus_body *body)
{
    const double cell[2] = {CELL, CELL};
    const int32_t side = c->has & LARGE ? 1000 : SIDE;
    bench_row row = bench_row_start(c->name, c->precision, c->threads);
    mus_cloth_def cut;
    mus_drape_def def;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = CELL;
    const mus_fabric fabric = fabric_of(c);
    cut.fabric = &fabric;
    mus_drape_def_init(&def, sizeof def);
    def.precision = c->precision;
    def.threads = c->threads;
    if (c->has & NO_DRAG) def.drag = 0.0;
    if (c->has & VERLET) def.integrator = MUS_METHOD_VERLET;

    mus_status status = c->has & TSHIRT ? mus_cloth_create(b->context, tshirt, &cut, &cloth)
                                        : mus_cloth_create_grid(b->context, side, side, cell, &cut, &cloth);
    if (status == MUS_OK) status = mus_drape_create(b->context, cloth, c->has & CONTACT ? body : NULL, &def, &drape);
    if (status == MUS_OK) status = mus_drape_place(drape);
    row.nodes = mus_cloth_node_count(cloth);
    row.springs = mus_cloth_spring_count(cloth);
    if (status == MUS_OK && (c->has & CONTACT) && !(c->has & TSHIRT)) status = lay_sheet(drape, row.nodes, body);
    if (status == MUS_OK) status = time_case(c, drape, &row);
    if (status == MUS_OK) {
        const plain_lattice plain = bench_lattice(&fabric, SIDE, CELL, def.drag);
        row.plain_s = bench_plain(&plain, c->precision, !(c->has & FORCE));
        bench_row_write(b, &row);
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    return status;
}


mus_status bench_speed(bench *b, bool everything)
{
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_pattern *tshirt = NULL;
    mus_status status = mus_tape_create(b->context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    if (status == MUS_OK) status = mus_body_create(b->context, tape, NULL, &body);
    if (status == MUS_OK) status = mus_design_draft(b->context, mus_design_find("tshirt"), tape, NULL, &tshirt);
    for (size_t c = 0; c < sizeof cases / sizeof cases[0] && status == MUS_OK; c++)
        if (everything || !(cases[c].has & LARGE)) status = run_case(b, &cases[c], tshirt, body);
    mus_pattern_destroy(tshirt);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    return status;
}
