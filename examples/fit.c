/*
 * fit.c: how a garment fits: ease at each level of the body, strain of the cloth, pressure on the skin.
 *
 * A T-shirt is drafted for women's 40 and worn by women's 40 and 44.
 */
#include <stdio.h>
#include <stdlib.h>

#include "muslin/muslin.h"

static mus_context *context;


/* end with one sentence when a call failed */
static void must(mus_status status)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "fit: %s: %s\n", mus_status_name(status), mus_context_error(context));
    exit(1);
}


static mus_tape *tape_of(const char *size)
{
    mus_tape *tape;
    must(mus_tape_create(context, &tape));
    must(mus_tape_set_size(tape, size));
    return tape;
}


/* dress a body of the size and print how the garment fits it */
static void wear(const mus_pattern *pattern, const char *size)
{
    mus_tape *tape = tape_of(size);
    mus_body *body;
    mus_drape *drape;
    mus_dress_def def;
    mus_fit *fit;
    mus_fit_level level;
    mus_fit_spread spread;

    must(mus_body_create(context, tape, NULL, &body));
    mus_dress_def_init(&def, sizeof def);
    def.spacing = 0.03;
    must(mus_dress(context, pattern, body, &def, NULL, NULL, NULL, &drape));
    must(mus_fit_create(drape, body, &fit));

    printf("worn by %s\n", size);
    mus_fit_level_init(&level, sizeof level);
    for (int32_t i = 0; i < mus_fit_level_count(fit); i++) {
        must(mus_fit_level_get(fit, i, &level));
        printf("  %-7s %-5s body %5.1f cm, garment %5.1f cm, ease %5.1f cm\n", mus_hold_name(level.level),
               level.right == MUS_NONE ? "" : level.right ? "right" : "left", 100 * level.body, 100 * level.garment,
               100 * level.ease);
    }
    mus_fit_spread_init(&spread, sizeof spread);
    must(mus_fit_spread_get(fit, MUS_FIT_STRAIN, &spread));
    printf("  strain: at most %.1f %% on 95 %% of the cloth, %.1f %% on 99 %%\n", 100 * spread.p95, 100 * spread.p99);
    mus_fit_destroy(fit);
    mus_drape_destroy(drape);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
}


int main(void)
{
    mus_tape *tape;
    mus_pattern *pattern;

    must(mus_context_create(NULL, &context));
    tape = tape_of("W40");
    must(mus_design_draft(context, mus_design_find("tshirt"), tape, NULL, &pattern));
    wear(pattern, "W40");
    wear(pattern, "W44");
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    mus_context_destroy(context);
    return 0;
}
