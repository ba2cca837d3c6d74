/*
 * bench_body.c: a bodily change: from a tape to the picture-ready surface, skin and all, on one core. Drawing is not in
 * it. Vertices, triangles and fields are counted beside the seconds: they are the same on every machine.
 */
#include <math.h>
#include <stdio.h>

#include "bench.h"
#include "muslin/body.h"
#include "muslin/tape.h"

/* bodies a row; each has a waist of its own */
#define BENCH_BODIES 24


/* CPU seconds of one body of a size whose waist is `more` fuller */
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


static void change_write(bench *b, const char *size, const mus_body *body, double mean, double best)
{
    if (b->as_json) {
        json_open(&b->j, NULL, '{');
        json_text(&b->j, "case", "body_change");
        json_text(&b->j, "size", size);
        json_int(&b->j, "vertices", mus_body_vertex_count(body));
        json_int(&b->j, "triangles", mus_body_triangle_count(body));
        json_number(&b->j, "cpu_s", mean);
        json_number(&b->j, "best_cpu_s", best);
        json_number(&b->j, "changes_per_cpu_s", 1.0 / mean);
        json_close(&b->j, '}');
    } else {
        printf("body_change %-10s %8d vertices %8d triangles %6.2f CPU ms a body, at best %.2f: %.0f a CPU second\n",
               size, (int)mus_body_vertex_count(body), (int)mus_body_triangle_count(body), 1e3 * mean, 1e3 * best,
               1.0 / mean);
    }
    fflush(stdout);
}


mus_status bench_body(bench *b)
{
    static const char *const sizes[] = {"W40", "M50", "C116"};
    mus_status status = MUS_OK;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes && status == MUS_OK; i++) {
        double sum = 0.0, best = INFINITY, spent;
        mus_body *body = NULL;
        for (int k = 0; k < BENCH_BODIES && status == MUS_OK; k++) {
            mus_body_destroy(body);
            body = NULL;
            status = change_once(b->context, sizes[i], 1e-4 * k, &body, &spent);
            sum += spent;
            best = fmin(best, spent);
        }
        if (status == MUS_OK) change_write(b, sizes[i], body, sum / BENCH_BODIES, best);
        mus_body_destroy(body);
    }
    return status;
}
