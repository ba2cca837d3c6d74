/*
 * scenes.c: times whole scenes, in CPU seconds.
 *
 * Hang: a square of 1 m and 0.2 kg/m2, with springs of 1000 N/m along the lines, 300 N/m along the diagonals, and
 * stencils of 20 N/m along the lines, is let go horizontally with two corners fixed. One second of cloth time is timed
 * from the start. With --all the square is also brought to rest, for the strain and the reactions of the pins.
 *
 * Frame: a nightshirt M60 of 2 m2 and about 5,000 nodes (the T-shirt lengthened to the calves, with long sleeves) of
 * the same fabric round its body: 20 ms of cloth time, one contact pass a step. Layers: the same with self-contact.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"

#define FRAME 0.02 /* [s] */
#define FRAMES 10
#define FRAME_SPACING 0.0205 /* [m] spacing: about 5,000 nodes */
#define FRAME_LENGTH 0.832 /* [m] length below the waist: 2.0 m2 with the sleeves */
#define FRAME_SLEEVE 0.6
#define SAFETY 0.95
#define REST_DRAG 2.0 /* [1/s] drag of the hang scene; chosen: a light one, the square swings */


static mus_fabric hang_fabric(double cell)
{
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.weight = 0.2;
    fabric.stretch[0] = fabric.stretch[1] = 1300.0; /* k = C11 - G */
    fabric.shear = 300.0;
    fabric.damping = 0.0;
    fabric.bend[0] = fabric.bend[1] = 20.0 * cell * cell;
    fabric.bend[2] = 0.5 * fabric.bend[0]; /* no stencils along diagonals */
    return fabric;
}


/* Steps one second of cloth time, in steps near the bound; the fall is taken at half of it. */
static mus_status time_hang(mus_drape *drape, bench_row *row)
{
    mus_drape_report before, after;
    mus_drape_report_init(&before, sizeof before);
    mus_drape_report_init(&after, sizeof after);
    mus_status status = mus_drape_report_get(drape, &before);
    const int32_t half = (int32_t)ceil(0.5 / (SAFETY * mus_drape_step_bound(drape)));
    const int32_t n = mus_drape_node_count(drape);
    const double start = bench_cpu(), wall = bench_wall();
    row->step = 0.5 / half;
    if (status == MUS_OK) status = mus_drape_step(drape, half, row->step);
    double low = 0.0;
    for (int32_t i = 0; i < n; i++) low = fmin(low, mus_drape_positions(drape)[3 * (size_t)i + 1]);
    row->fall = -low;
    if (status == MUS_OK) status = mus_drape_step(drape, half, row->step);
    row->cpu_per_second = row->cpu_s = bench_cpu() - start;
    row->wall_s = bench_wall() - wall;
    if (status == MUS_OK) status = mus_drape_report_get(drape, &after);
    row->evaluations = (after.spring_evaluations - before.spring_evaluations) / row->springs;
    return status;
}


/* Brings the square to rest; writes its largest strain and the reactions of the pins to the row. */
static mus_status rest_hang(mus_drape *drape, double weight, const int32_t *pin, bench_row *row)
{
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    const size_t n = (size_t)mus_drape_node_count(drape);
    double *force = malloc(3 * n * sizeof *force);
    if (force == NULL) return MUS_ERR_MEMORY;
    mus_status status = mus_drape_settle(drape, NULL, NULL);
    if (status == MUS_OK) status = mus_drape_report_get(drape, &report);
    if (status == MUS_OK) status = mus_drape_forces(drape, force);
    row->strain = report.max_strain;
    row->reaction = -(force[3 * (size_t)pin[0] + 1] + force[3 * (size_t)pin[1] + 1]) / weight;
    free(force);
    return status;
}


static mus_status run_hang(bench *b, const char *name, int32_t side, int32_t integrator, bool rest)
{
    const double cell[2] = {1.0 / (side - 1), 1.0 / (side - 1)};
    const int32_t n = side * side, pin[2] = {0, side - 1};
    bench_row row = bench_row_start(name, 32, 1);
    mus_cloth_def cut;
    mus_drape_def def;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    double *place = malloc(3 * (size_t)n * sizeof *place);
    if (place == NULL) return MUS_ERR_MEMORY;
    for (int32_t i = 0; i < n; i++) {
        place[3 * i] = i % side * cell[0];
        place[3 * i + 1] = 0.0;
        place[3 * i + 2] = i / side * cell[1];
    }
    mus_cloth_def_init(&cut, sizeof cut);
    const mus_fabric fabric = hang_fabric(cell[0]);
    cut.fabric = &fabric;
    mus_drape_def_init(&def, sizeof def);
    def.integrator = integrator;
    def.drag = REST_DRAG;
    mus_status status = mus_cloth_create_grid(b->context, side, side, cell, &cut, &cloth);
    if (status == MUS_OK) status = mus_drape_create(b->context, cloth, NULL, &def, &drape);
    if (status == MUS_OK) status = mus_drape_set_state(drape, place, NULL);
    for (int32_t k = 0; k < 2 && status == MUS_OK; k++) status = mus_drape_pin(drape, pin[k], 1);
    row.nodes = n;
    row.springs = mus_cloth_spring_count(cloth);
    if (status == MUS_OK) status = time_hang(drape, &row);
    if (status == MUS_OK && rest) status = rest_hang(drape, 9.81 * mus_cloth_mass(cloth), pin, &row);
    if (status == MUS_OK || status == MUS_ERR_UNSETTLED) {
        const plain_lattice plain = bench_lattice(&fabric, side, cell[0], def.drag);
        row.plain_s = bench_plain(&plain, 32, true);
        bench_row_write(b, &row);
        status = MUS_OK;
    }
    free(place);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    return status;
}


/* Times frames of a placed garment, as an editor shows them. */
static mus_status time_frames(mus_drape *drape, bench_row *row)
{
    mus_drape_report before, after;
    mus_drape_report_init(&before, sizeof before);
    mus_drape_report_init(&after, sizeof after);
    mus_status status = MUS_OK;
    row->cpu_s = INFINITY;
    for (int32_t f = 0; f < FRAMES && status == MUS_OK; f++) {
        /* the step bound depends on the pose */
        const int32_t steps = (int32_t)ceil(FRAME / (SAFETY * mus_drape_step_bound(drape)));
        status = mus_drape_report_get(drape, &before);
        const double cpu = bench_cpu(), wall = bench_wall();
        if (status == MUS_OK) status = mus_drape_step(drape, steps, FRAME / steps);
        const double took = bench_cpu() - cpu;
        if (status == MUS_OK) status = mus_drape_report_get(drape, &after);
        if (took >= row->cpu_s) continue;
        row->cpu_s = took;
        row->step = FRAME / steps;
        row->wall_s = bench_wall() - wall;
        row->evaluations = (after.spring_evaluations - before.spring_evaluations) / row->springs;
    }
    row->cpu_frame_ms = 1e3 * row->cpu_s;
    return status;
}


static mus_status run_frame(bench *b, const char *name, const mus_pattern *garment, const mus_body *body,
                            int32_t integrator, double ball, int32_t self_contact)
{
    bench_row row = bench_row_start(name, 32, 1);
    mus_cloth_def cut;
    mus_drape_def def;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = FRAME_SPACING;
    const mus_fabric fabric = hang_fabric(FRAME_SPACING);
    cut.fabric = &fabric;
    mus_drape_def_init(&def, sizeof def);
    def.integrator = integrator;
    def.contact_ball = ball;
    def.self_contact = self_contact;
    mus_status status = mus_cloth_create(b->context, garment, &cut, &cloth);
    if (status == MUS_OK) status = mus_drape_create(b->context, cloth, body, &def, &drape);
    if (status == MUS_OK) status = mus_drape_place(drape);
    if (status == MUS_OK) status = mus_drape_sew(drape, NULL, NULL);
    row.nodes = mus_cloth_node_count(cloth);
    row.springs = mus_cloth_spring_count(cloth);
    row.area = mus_cloth_mass(cloth) / fabric.weight;
    if (status == MUS_OK) status = time_frames(drape, &row);
    if (status == MUS_OK) bench_row_write(b, &row);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    return status;
}


static mus_status run_frames(bench *b)
{
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_pattern *garment = NULL;
    mus_draft_def draft;
    mus_draft_def_init(&draft, sizeof draft);
    draft.length = FRAME_LENGTH;
    draft.sleeve = FRAME_SLEEVE;
    mus_status status = mus_tape_create(b->context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "M60");
    if (status == MUS_OK) status = mus_body_create(b->context, tape, NULL, &body);
    if (status == MUS_OK) status = mus_design_draft(b->context, mus_design_find("tshirt"), tape, &draft, &garment);
    if (status == MUS_OK) status = run_frame(b, "frame_rk4", garment, body, MUS_METHOD_RK4, 0.0, 0);
    if (status == MUS_OK) status = run_frame(b, "frame_rk4_ball", garment, body, MUS_METHOD_RK4, 0.00025, 0);
    if (status == MUS_OK) status = run_frame(b, "frame_verlet", garment, body, MUS_METHOD_VERLET, 0.0, 0);
    if (status == MUS_OK) status = run_frame(b, "frame_verlet_ball", garment, body, MUS_METHOD_VERLET, 0.00025, 0);
    if (status == MUS_OK) status = run_frame(b, "frame_rk4_layers", garment, body, MUS_METHOD_RK4, 0.0, 1);
    if (status == MUS_OK) status = run_frame(b, "frame_verlet_layers", garment, body, MUS_METHOD_VERLET, 0.0, 1);
    mus_pattern_destroy(garment);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    return status;
}


mus_status bench_scenes(bench *b, bool everything)
{
    static const struct {
        const char *name;
        int32_t side, integrator;
        bool large;
    } hangs[] = {
        {"hang_32_rk4", 32, MUS_METHOD_RK4, false},   {"hang_32_verlet", 32, MUS_METHOD_VERLET, false},
        {"hang_64_rk4", 64, MUS_METHOD_RK4, false},   {"hang_64_verlet", 64, MUS_METHOD_VERLET, false},
        {"hang_128_rk4", 128, MUS_METHOD_RK4, true}, {"hang_128_verlet", 128, MUS_METHOD_VERLET, true},
    };
    mus_status status = run_frames(b);
    for (size_t h = 0; h < sizeof hangs / sizeof hangs[0] && status == MUS_OK; h++)
        if (everything || !hangs[h].large)
            status = run_hang(b, hangs[h].name, hangs[h].side, hangs[h].integrator, everything && !hangs[h].large);
    return status;
}
