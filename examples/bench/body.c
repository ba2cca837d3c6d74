/*
 * body.c: times a change of the body, on one core: from a tape to the published surface with normals; and the same with
 * a T-shirt that is refitted: a new drape starts where the last one lies, and settles. Drawing is not timed. Rows also
 * have the numbers of vertices, triangles and nodes, which are the same on every machine.
 */
#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "muslin/muslin.h"

/* bodies made for one row, each with another waist girth; chosen: their sum takes some tenths of a second */
#define BENCH_BODIES 24

#define REFIT_CHANGES 6
#define REFIT_WAIST 0.002   /* [m] added to the waist at each change */
#define REFIT_SPACING 0.016 /* [m] spacing of the T-shirt: about 3,000 nodes */


/* Makes one body of a size, with `more` [m] added to the waist; *spent gets the CPU time [s]. */
static mus_status change_once(mus_context *context, const char *size, double more, mus_body **body, double *spent)
{
    mus_tape *tape = NULL;
    mus_status status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, size);
    if (status == MUS_OK)
        status =
            mus_tape_set(tape, MUS_MEASURE_WAIST, mus_tape_value(tape, MUS_MEASURE_WAIST) + more, MUS_SOURCE_GIVEN);
    const double start = bench_cpu();
    if (status == MUS_OK) status = mus_body_create(context, tape, NULL, body);
    *spent = bench_cpu() - start;
    mus_tape_destroy(tape);
    return status;
}


static int change_order(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}


/* Writes a row; spent: the CPU times [s] of BENCH_BODIES bodies, which are sorted. */
static void change_write(bench *b, const char *size, const mus_body *body, double *spent)
{
    double mean = 0.0;
    qsort(spent, BENCH_BODIES, sizeof *spent, change_order);
    for (int k = 0; k < BENCH_BODIES; k++) mean += spent[k] / BENCH_BODIES;
    const double best = spent[0], median = 0.5 * (spent[BENCH_BODIES / 2 - 1] + spent[BENCH_BODIES / 2]);

    if (b->as_json) {
        json_open(&b->j, NULL, '{');
        json_text(&b->j, "case", "body_change");
        json_text(&b->j, "size", size);
        json_int(&b->j, "vertices", mus_body_vertex_count(body));
        json_int(&b->j, "triangles", mus_body_triangle_count(body));
        json_number(&b->j, "cpu_s", mean);
        json_number(&b->j, "median_cpu_s", median);
        json_number(&b->j, "best_cpu_s", best);
        json_number(&b->j, "changes_per_cpu_s", 1.0 / mean);
        json_close(&b->j, '}');
    } else {
        printf("body_change %-10s %8d vertices %8d triangles, median %6.2f CPU ms a body, mean %.2f, at best %.2f\n",
               size, (int)mus_body_vertex_count(body), (int)mus_body_triangle_count(body), 1e3 * median, 1e3 * mean,
               1e3 * best);
    }
    fflush(stdout);
}


/* ---- with a T-shirt on ---- */

typedef struct refit {
    mus_cloth *cloth;
    mus_body *body;
    mus_drape *drape;
    int32_t settled;
    double body_s, fit_s; /* CPU time of all changes [s] */
} refit;


/* Dresses the first body in the T-shirt. */
static mus_status refit_open(mus_context *context, refit *r)
{
    mus_tape *tape = NULL;
    mus_pattern *pattern = NULL;
    mus_cloth_def cut;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = REFIT_SPACING;
    double spent;
    mus_status status = change_once(context, "W40", 0.0, &r->body, &spent);
    if (status == MUS_OK) status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    if (status == MUS_OK) status = mus_design_draft(context, mus_design_find("tshirt"), tape, NULL, &pattern);
    if (status == MUS_OK) status = mus_cloth_create(context, pattern, &cut, &r->cloth);
    if (status == MUS_OK) status = mus_drape_create(context, r->cloth, r->body, NULL, &r->drape);
    if (status == MUS_OK) status = mus_drape_place(r->drape);
    if (status == MUS_OK) status = mus_drape_sew(r->drape, NULL, NULL);
    if (status == MUS_OK) status = mus_drape_settle(r->drape, NULL, NULL);
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    return status;
}


/* Makes the next body and refits the T-shirt to it. A garment that does not come to rest is counted; it is no error. */
static mus_status refit_once(mus_context *context, refit *r, double more)
{
    mus_body *body = NULL;
    mus_drape *drape = NULL;
    double spent;
    mus_status status = change_once(context, "W40", more, &body, &spent);
    r->body_s += spent;
    const double start = bench_cpu();
    if (status == MUS_OK) status = mus_drape_create(context, r->cloth, body, NULL, &drape);
    if (status == MUS_OK) status = mus_drape_warm(drape, r->drape);
    if (status == MUS_OK) {
        status = mus_drape_settle(drape, NULL, NULL);
        r->settled += status == MUS_OK;
        if (status == MUS_ERR_UNSETTLED) status = MUS_OK;
    }
    r->fit_s += bench_cpu() - start;
    if (status != MUS_OK) {
        mus_drape_destroy(drape);
        mus_body_destroy(body);
        return status;
    }
    mus_drape_destroy(r->drape);
    mus_body_destroy(r->body);
    r->drape = drape, r->body = body;
    return MUS_OK;
}


static void refit_write(bench *b, const refit *r)
{
    const int32_t nodes = mus_cloth_node_count(r->cloth);
    const double body = r->body_s / REFIT_CHANGES, fit = r->fit_s / REFIT_CHANGES;
    if (b->as_json) {
        json_open(&b->j, NULL, '{');
        json_text(&b->j, "case", "body_refit");
        json_int(&b->j, "nodes", nodes);
        json_int(&b->j, "changes", REFIT_CHANGES);
        json_int(&b->j, "settled", r->settled);
        json_number(&b->j, "body_cpu_s", body);
        json_number(&b->j, "refit_cpu_s", fit);
        json_close(&b->j, '}');
    } else {
        printf("body_refit T-shirt %7d nodes, waist %g mm fuller each time, %d of %d at rest: body %6.2f and refit "
               "%6.1f CPU ms\n",
               (int)nodes, 1e3 * REFIT_WAIST, (int)r->settled, REFIT_CHANGES, 1e3 * body, 1e3 * fit);
    }
    fflush(stdout);
}


static mus_status bench_refit(bench *b)
{
    refit r = {0};
    mus_status status = refit_open(b->context, &r);
    for (int k = 1; k <= REFIT_CHANGES && status == MUS_OK; k++) status = refit_once(b->context, &r, REFIT_WAIST * k);
    if (status == MUS_OK) refit_write(b, &r);
    mus_drape_destroy(r.drape);
    mus_cloth_destroy(r.cloth);
    mus_body_destroy(r.body);
    return status;
}


mus_status bench_body(bench *b)
{
    static const char *const sizes[] = {"W40", "M50", "C116"};
    mus_status status = MUS_OK;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes && status == MUS_OK; i++) {
        double spent[BENCH_BODIES];
        mus_body *body = NULL;
        for (int k = 0; k < BENCH_BODIES && status == MUS_OK; k++) {
            mus_body_destroy(body);
            body = NULL;
            status = change_once(b->context, sizes[i], 1e-4 * k, &body, &spent[k]);
        }
        if (status == MUS_OK) change_write(b, sizes[i], body, spent);
        mus_body_destroy(body);
    }
    return status == MUS_OK ? bench_refit(b) : status;
}
