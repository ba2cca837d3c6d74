/*
 * refit.c: a garment follows a measure that moves, as under a slider: the waist grows by 5 mm at a time.
 *
 * Each time the body is made anew, the pattern is drafted anew, and the new cloth starts where the old one lies. So
 * nothing is sewn again, and settling has little to do.
 */
#include <stdio.h>
#include <stdlib.h>

#include "muslin/muslin.h"

static mus_context *context;


/* end with one sentence when a call failed */
static void must(mus_status status)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "refit: %s: %s\n", mus_status_name(status), mus_context_error(context));
    exit(1);
}


/* a skirt for the tape on its body, at rest: sewn when `before` is NULL, else from where that one lies */
static mus_drape *fitted(const mus_tape *tape, const mus_drape *before)
{
    mus_body *body;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_cloth_def cut;
    mus_drape *drape;

    must(mus_body_create(context, tape, NULL, &body));
    must(mus_design_draft(context, mus_design_find("skirt"), tape, NULL, &pattern));
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = 0.02;
    must(mus_cloth_create(context, pattern, &cut, &cloth));
    must(mus_drape_create(context, cloth, body, NULL, &drape));
    if (before == NULL) {
        must(mus_drape_place(drape));
        must(mus_drape_sew(drape, NULL, NULL));
    } else {
        must(mus_drape_warm(drape, before));
    }
    must(mus_drape_settle(drape, NULL, NULL));

    /* the drape has copied what it needs */
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    return drape;
}


int main(void)
{
    mus_tape *tape;
    mus_drape *drape = NULL;
    mus_drape_report report;
    int64_t first = 0;

    must(mus_context_create(NULL, &context));
    must(mus_tape_create(context, &tape));
    must(mus_tape_set_size(tape, "W40"));
    const double waist = mus_tape_value(tape, MUS_MEASURE_WAIST);
    mus_drape_report_init(&report, sizeof report);
    for (int step = 0; step <= 4; step++) {
        must(mus_tape_set(tape, MUS_MEASURE_WAIST, waist + 0.005 * step, MUS_SOURCE_GIVEN));
        mus_drape *next = fitted(tape, drape);
        mus_drape_destroy(drape);
        drape = next;
        must(mus_drape_report_get(drape, &report));
        if (step == 0) first = report.spring_evaluations;
        printf("waist %.1f cm: %s, %d of %d seams closed, %s\n", 100 * mus_tape_value(tape, MUS_MEASURE_WAIST),
               report.settled ? "at rest" : "not at rest", (int)report.seams_closed, (int)report.seams,
               step == 0                                   ? "sewn"
               : report.spring_evaluations < first * 2 / 3 ? "less than two thirds of the first run's work"
                                                           : "two thirds of the first run's work or more");
    }
    mus_drape_destroy(drape);
    mus_tape_destroy(tape);
    mus_context_destroy(context);
    return 0;
}
