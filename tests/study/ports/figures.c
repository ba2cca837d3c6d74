/*
 * figures.c: prints figures of what the library makes, so that compare.py can hold two builds against each other:
 * builds by other compilers, at other levels of optimisation, for 32-bit and big-endian machines.
 *
 * A line is `kind name value`. An `exact` value must be the same text in both builds: these are counts, and states of a
 * step, which uses only + - * / and square roots. A `near` value must agree to 1e-12, since the sine of another C
 * library may differ in its last digit.
 */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "muslin/muslin.h"

#define MUST(call) must(context, (call), #call)


static void must(mus_context *context, mus_status status, const char *call)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "%s: %s: %s\n", call, mus_status_name(status), mus_context_error(context));
    exit(1);
}


/* how numbers of a list, weighted by place, add up: one figure for a whole array */
static double digest(const double *value, int64_t n)
{
    double sum = 0.0;
    for (int64_t i = 0; i < n; i++) sum += value[i] * (1.0 + (double)(i % 97) / 97.0);
    return sum;
}


static void print_tapes(mus_context *context)
{
    static const char *const sizes[] = {"W34", "W52", "M50", "C116"};
    for (int k = 0; k < 4; k++) {
        mus_tape *tape;
        MUST(mus_tape_create(context, &tape));
        MUST(mus_tape_set_size(tape, sizes[k]));
        MUST(mus_tape_complete(tape));
        for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++)
            printf("near tape.%s.%s %.17g\n", sizes[k], mus_measure_name(m), mus_tape_value(tape, m));
        mus_tape_destroy(tape);
    }
}


static void print_body(const mus_body *body)
{
    printf("exact body.vertices %d\n", (int)mus_body_vertex_count(body));
    printf("exact body.triangles %d\n", (int)mus_body_triangle_count(body));
    printf("near body.volume %.17g\n", mus_body_volume(body));
    printf("near body.surface %.17g\n", digest(mus_body_vertices(body), 3 * (int64_t)mus_body_vertex_count(body)));
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++)
        if (!isnan(mus_body_made(body, m))) printf("near body.%s %.17g\n", mus_measure_name(m), mus_body_made(body, m));
}


static mus_pattern *print_patterns(mus_context *context, const mus_tape *tape)
{
    mus_pattern *pattern = NULL;
    for (int32_t d = 0; d < mus_design_count(); d++) {
        mus_pattern_destroy(pattern);
        MUST(mus_design_draft(context, d, tape, NULL, &pattern));
        for (int32_t e = 0; e < mus_pattern_edge_count(pattern); e++)
            printf("near %s.edge%d %.17g\n", mus_design_name(d), (int)e, mus_pattern_edge_length(pattern, e));
        for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++)
            printf("near %s.area%d %.17g\n", mus_design_name(d), (int)p, mus_pattern_panel_area(pattern, p));
    }
    mus_pattern_destroy(pattern);
    MUST(mus_design_draft(context, mus_design_find("skirt"), tape, NULL, &pattern));
    return pattern;
}


static void print_drape(const char *name, const mus_drape *drape)
{
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    mus_drape_report_get(drape, &report);
    const int64_t n = 3 * (int64_t)mus_drape_node_count(drape);
    printf("exact %s.places %.17g\n", name, digest(mus_drape_positions(drape), n));
    printf("exact %s.speeds %.17g\n", name, digest(mus_drape_velocities(drape), n));
    printf("exact %s.energy %.17g\n", name, report.energy);
    printf("exact %s.bound %.17g\n", name, report.step_bound);
    printf("exact %s.hash %016" PRIx64 "\n", name, mus_drape_hash(drape));
}


/* a square of 16 x 16 nodes held by two corners, 1 s after it was let go: no function of the C library but sqrt */
static void print_hang(mus_context *context, int32_t precision)
{
    const double cell[2] = {1.0 / 15.0, 1.0 / 15.0};
    mus_cloth_def cut;
    mus_cloth *cloth;
    mus_drape_def def;
    mus_drape *drape;
    mus_cloth_def_init(&cut, sizeof cut);
    MUST(mus_cloth_create_grid(context, 16, 16, cell, &cut, &cloth));
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    MUST(mus_drape_create(context, cloth, NULL, &def, &drape));
    MUST(mus_drape_pin(drape, 15 * 16, 1));
    MUST(mus_drape_pin(drape, 16 * 16 - 1, 1));
    const int32_t steps = (int32_t)ceil(1.0 / (0.9 * mus_drape_step_bound(drape)));
    printf("exact hang%d.steps %d\n", (int)precision, (int)steps);
    MUST(mus_drape_step(drape, steps, 1.0 / steps));
    print_drape(precision == 64 ? "hang64" : "hang32", drape);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
}


/* a skirt cut, placed round the body and stepped before it touches anything else than the waist */
static void print_skirt(mus_context *context, const mus_pattern *pattern, const mus_body *body)
{
    mus_cloth_def cut;
    mus_cloth *cloth;
    mus_drape_def def;
    mus_drape *drape;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = 0.06;
    MUST(mus_cloth_create(context, pattern, &cut, &cloth));
    printf("exact skirt.nodes %d\n", (int)mus_cloth_node_count(cloth));
    printf("exact skirt.springs %d\n", (int)mus_cloth_spring_count(cloth));
    printf("exact skirt.pairs %d\n", (int)mus_cloth_pair_count(cloth));
    printf("near skirt.mass %.17g\n", mus_cloth_mass(cloth));
    printf("near skirt.rest %.17g\n", digest(mus_cloth_rest(cloth), 2 * (int64_t)mus_cloth_node_count(cloth)));
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    MUST(mus_drape_create(context, cloth, body, &def, &drape));
    MUST(mus_drape_place(drape));
    printf("near skirt.placed %.17g\n", digest(mus_drape_positions(drape), 3 * (int64_t)mus_drape_node_count(drape)));
    MUST(mus_drape_sew(drape, NULL, NULL));
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    MUST(mus_drape_report_get(drape, &report));
    printf("exact skirt.seams_closed %d\n", (int)report.seams_closed);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
}


int main(void)
{
    mus_context *context = NULL;
    mus_tape *tape;
    mus_body *body;
    must(NULL, mus_context_create(NULL, &context), "mus_context_create");
    print_tapes(context);
    MUST(mus_tape_create(context, &tape));
    MUST(mus_tape_set_size(tape, "W40"));
    MUST(mus_tape_complete(tape));
    MUST(mus_body_create(context, tape, NULL, &body));
    print_body(body);
    mus_pattern *pattern = print_patterns(context, tape);
    print_hang(context, 64);
    print_hang(context, 32);
    print_skirt(context, pattern, body);
    printf("exact bytes.left %d\n", (int)(mus_context_bytes(context) == 0));
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    printf("exact bytes.at_the_end %d\n", (int)mus_context_bytes(context));
    mus_context_destroy(context);
    return 0;
}
