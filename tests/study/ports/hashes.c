/*
 * hashes.c: prints the state hashes of garments that were sewn and settled, so that the same lines can be asked of
 * every C library, compiler, level and processor.
 *
 *     hashes [COUNT [FROM [STEP]]]
 *
 * COUNT garments (100, all) of garments.h, each without and with self-contact, on coarse cloth, every second one in
 * double. A line is `design size self status nodes hash`; one that is not at rest and worn (MUS_OK) fails the program.
 * Prints lines FROM, FROM + STEP, ... alone when these are given, so that several processes can share the work.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "garments.h"
#include "muslin/muslin.h"

#define SPACING 0.08 /* [m]; chosen: 200 garments take half a minute of a core, and minutes under an emulator */

typedef struct garment {
    const char *design, *size;
    int32_t bits;
} garment;

#define ROW(design, size, bits) {#design, #size, bits},
static const garment garments[] = {GARMENTS(ROW)};
#define COUNT ((int32_t)(sizeof garments / sizeof garments[0]))


static int dress(mus_context *context, const garment *g, int32_t self)
{
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_pattern *pattern = NULL;
    mus_drape *drape = NULL;
    mus_dress_def def;
    mus_dress_def_init(&def, sizeof def);
    def.spacing = SPACING;
    def.self_contact = self;
    def.precision = g->bits;
    def.retry = 0;
    mus_status status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, g->size);
    if (status == MUS_OK) status = mus_body_create(context, tape, NULL, &body);
    if (status == MUS_OK) status = mus_design_draft(context, mus_design_find(g->design), tape, NULL, &pattern);
    if (status == MUS_OK) status = mus_dress(context, pattern, body, &def, NULL, NULL, NULL, &drape);
    printf("%s %s %d %s %d %016" PRIx64 "\n", g->design, g->size, (int)self, mus_status_name(status),
           drape ? (int)mus_drape_node_count(drape) : 0, drape ? mus_drape_hash(drape) : 0);
    fflush(stdout);
    if (status != MUS_OK) fprintf(stderr, "hashes: %s: %s\n", g->design, mus_context_error(context));
    mus_drape_destroy(drape);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    return status != MUS_OK;
}


int main(int argc, char **argv)
{
    const int32_t count = argc > 1 ? atoi(argv[1]) : COUNT, from = argc > 2 ? atoi(argv[2]) : 0;
    const int32_t step = argc > 3 ? atoi(argv[3]) : 1;
    mus_context *context;
    if (count < 1 || count > COUNT || from < 0 || step < 1 || mus_context_create(NULL, &context) != MUS_OK) return 2;
    int failed = 0;
    for (int32_t i = from; i < 2 * count; i += step) failed |= dress(context, &garments[i / 2 * COUNT / count], i % 2);
    mus_context_destroy(context);
    return failed;
}
