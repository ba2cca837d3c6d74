/*
 * hashes.c: prints the state hashes of garments that were sewn and settled, so that the same lines can be asked of
 * every C library, compiler, level and processor.
 *
 *     hashes [COUNT [FROM [STEP]]]
 *
 * COUNT designs (100) evenly from the named ones, each without and with self-contact, on the sizes of its groups in
 * turn; coarse cloth, every second one in double. A line is `design size self status nodes hash`. Prints lines FROM,
 * FROM + STEP, ... alone when these are given, so that several processes can share the work.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "muslin/muslin.h"

#define SPACING 0.08 /* [m]; chosen: 200 garments take a minute of a core, and minutes under an emulator */


static int fail(mus_context *context, const char *name)
{
    fprintf(stderr, "hashes: %s: %s\n", name, mus_context_error(context));
    return 1;
}


static const char *size_of(int32_t design, int32_t turn)
{
    static const char *const women[] = {"W40", "W34", "W50"}, *const men[] = {"M50", "M46", "M58"};
    const int32_t groups = mus_design_groups(design);
    if ((groups & MUS_GROUP_CHILDREN) && (turn % 4 == 3 || groups == MUS_GROUP_CHILDREN)) return "C116";
    if ((groups & MUS_GROUP_MEN) && (turn % 2 == 1 || !(groups & MUS_GROUP_WOMEN))) return men[turn % 3];
    return women[turn % 3];
}


static int dress(mus_context *context, int32_t design, int32_t turn, int32_t self)
{
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_pattern *pattern = NULL;
    mus_drape *drape = NULL;
    mus_dress_def def;
    mus_dress_def_init(&def, sizeof def);
    def.spacing = SPACING;
    def.self_contact = self;
    def.precision = turn % 2 ? 64 : 32;
    def.retry = 0;
    const char *name = mus_design_name(design), *size = size_of(design, turn);
    mus_status status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, size);
    if (status == MUS_OK) status = mus_body_create(context, tape, NULL, &body);
    if (status == MUS_OK) status = mus_design_draft(context, design, tape, NULL, &pattern);
    if (status == MUS_OK) {
        status = mus_dress(context, pattern, body, &def, NULL, NULL, NULL, &drape);
        printf("%s %s %d %s %d %016" PRIx64 "\n", name, size, (int)self, mus_status_name(status),
               drape ? (int)mus_drape_node_count(drape) : 0, drape ? mus_drape_hash(drape) : 0);
        fflush(stdout);
        status = MUS_OK; /* a garment that finds no rest has a hash, too */
    }
    mus_drape_destroy(drape);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    return status == MUS_OK ? 0 : fail(context, name);
}


int main(int argc, char **argv)
{
    const int32_t count = argc > 1 ? atoi(argv[1]) : 100, from = argc > 2 ? atoi(argv[2]) : 0;
    const int32_t step = argc > 3 ? atoi(argv[3]) : 1;
    mus_context *context;
    if (count < 1 || step < 1 || mus_context_create(NULL, &context) != MUS_OK) return 2;
    int failed = 0;
    for (int32_t i = from; i < 2 * count; i += step) {
        const int32_t turn = i / 2;
        failed |= dress(context, (int32_t)((int64_t)turn * mus_design_count() / count), turn, i % 2);
    }
    mus_context_destroy(context);
    return failed;
}
