/*
 * catalogue.c: patterns kept in a file and found again by how they are sewn, whatever their size and their names.
 *
 * A catalogue gets every tenth named design in women's 40. It is then asked for a pattern drafted for another woman,
 * whose lengths are all others.
 */
#include <stdio.h>
#include <stdlib.h>

#include "muslin/catalogue.h"
#include "muslin/muslin.h"

#define FILE_NAME "example-catalogue.db"
#define NEAREST 3

static mus_context *context;


/* end with one sentence when a call failed */
static void must(mus_status status)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "catalogue: %s: %s\n", mus_status_name(status), mus_context_error(context));
    exit(1);
}


static mus_pattern *draft(int32_t design, const char *size)
{
    mus_tape *tape;
    mus_pattern *pattern;
    must(mus_tape_create(context, &tape));
    must(mus_tape_set_size(tape, size));
    must(mus_design_draft(context, design, tape, NULL, &pattern));
    mus_tape_destroy(tape);
    return pattern;
}


int main(void)
{
    mus_catalogue *catalogue;
    mus_pattern *pattern;
    int32_t id[NEAREST], exact[NEAREST], count;
    double distance[NEAREST];

    must(mus_context_create(NULL, &context));
    remove(FILE_NAME);
    must(mus_catalogue_open(context, FILE_NAME, MUS_CATALOGUE_WRITE, &catalogue));

    /* one transaction: all of them are kept, or none */
    must(mus_catalogue_begin(catalogue));
    for (int32_t design = 0; design < mus_design_count(); design += 10) {
        if (!(mus_design_groups(design) & MUS_GROUP_WOMEN)) continue;
        pattern = draft(design, "W40");
        must(mus_catalogue_add(catalogue, pattern, mus_design_name(design), NULL));
        mus_pattern_destroy(pattern);
    }
    must(mus_catalogue_commit(catalogue));
    printf("more than 50 patterns: %s\n", mus_catalogue_count(catalogue) > 50 ? "yes" : "no");

    pattern = draft(0, "W46");
    printf("like a %s of W46:\n", mus_design_name(0));
    must(mus_catalogue_nearest(catalogue, pattern, NEAREST, id, distance, exact, &count));
    for (int32_t i = 0; i < count; i++) {
        const char *name;
        must(mus_catalogue_name(catalogue, id[i], &name));
        printf("  %-24s distance %.2f%s\n", name, distance[i], exact[i] ? ", sewn the same" : "");
    }
    mus_pattern_destroy(pattern);
    mus_catalogue_destroy(catalogue);
    mus_context_destroy(context);
    remove(FILE_NAME);
    return 0;
}
