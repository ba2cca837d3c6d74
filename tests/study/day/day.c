/*
 * day.c: a day of a program that dresses people, in an hour or less: `make day`, DAY=N for N cycles.
 *
 * A day has 17280 cycles, one each five seconds. A cycle makes a tape, a body, a design at random, its cloth and its
 * drape (of either precision, with one or two threads, every other one with self-contact), places it, takes twenty
 * steps and destroys all; each tenth is dressed to rest, written as glTF and PDF, and read back from its pattern file.
 * All of it in one context, which must hold nothing after each cycle. After each tenth of the day a line tells the
 * cycles, the CPU seconds, the memory that the system has given the process, and the allocations so far. Exit 1 when a
 * cycle leaves a byte or fails for another reason than the garment's, or when memory at the end is a tenth above that
 * after the first tenth of the day.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "muslin/print.h"

#define CYCLES 17280
#define STEPS 20
#define AT_REST 10 /* each so many cycles the garment is dressed to rest and written */
#define GROWN 1.1  /* memory at the end over that after a tenth: a leak of 200 bytes a cycle adds 3 MB to some 20 */

static const char *const designs[] = {"skirt", "tshirt", "jeans", "sleeveless", "shirt", "flare_ankle"};
static const char *const sizes[] = {"W34", "W40", "W46", "W52", "M50", "C116"};

#define PICK(list, number) ((list)[(number) % (sizeof(list) / sizeof *(list))])


static uint32_t drawn(uint64_t *state)
{
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407); /* Knuth, MMIX */
    return (uint32_t)(*state >> 33);
}


/* MiB that the process holds in memory; 0 where the system does not tell */
static double memory(void)
{
    long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file == NULL) return 0.0;
    if (fscanf(file, "%*d %ld", &pages) != 1) pages = 0;
    fclose(file);
    return (double)pages * (double)sysconf(_SC_PAGESIZE) / (1 << 20);
}


/* as paper, as a mesh and as a file that is read again */
static mus_status write_all(mus_context *context, const mus_pattern *pattern, const mus_cloth *cloth,
                            const mus_drape *drape)
{
    char *bytes = NULL;
    size_t size = 0;
    mus_sheet *sheet = NULL;
    mus_pattern *again = NULL;
    mus_mesh_view view;
    mus_mesh_view_init(&view, sizeof view);
    view.vertex_count = mus_cloth_node_count(cloth), view.triangle_count = mus_cloth_triangle_count(cloth);
    view.positions = mus_drape_positions(drape), view.triangles = mus_cloth_triangles(cloth);
    mus_status status = mus_mesh_write_glb_bytes(context, 1, &view, &bytes, &size);
    if (status == MUS_OK) mus_context_alloc(context, bytes, 0);
    if (status == MUS_OK) status = mus_sheet_create(context, pattern, NULL, &sheet);
    if (status == MUS_OK) status = mus_sheet_write_pdf_bytes(sheet, &bytes, &size);
    if (status == MUS_OK) mus_context_alloc(context, bytes, 0);
    if (status == MUS_OK) status = mus_pattern_write_bytes(pattern, &bytes, &size);
    if (status == MUS_OK) status = mus_pattern_read_from(context, bytes, size, "again", &again);
    if (status == MUS_OK) mus_context_alloc(context, bytes, 0);
    mus_pattern_destroy(again);
    mus_sheet_destroy(sheet);
    return status;
}


static mus_status cycle(mus_context *context, uint64_t *state, bool rest)
{
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_pattern *pattern = NULL;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def cut;
    mus_drape_def def;
    mus_dress_def all;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_drape_def_init(&def, sizeof def);
    mus_dress_def_init(&all, sizeof all);
    cut.spacing = all.spacing = 0.04 + 0.001 * (drawn(state) % 40);
    def.precision = drawn(state) % 2 ? 32 : 64;
    def.threads = all.threads = 1 + (int32_t)(drawn(state) % 2);
    def.self_contact = all.self_contact = drawn(state) % 2;
    all.retry = 0;
    const char *design = PICK(designs, drawn(state)), *size = PICK(sizes, drawn(state));
    mus_status status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, size);
    if (status == MUS_OK) status = mus_body_create(context, tape, NULL, &body);
    if (status == MUS_OK) status = mus_design_draft(context, mus_design_find(design), tape, NULL, &pattern);
    if (status == MUS_OK && rest) {
        status = mus_dress(context, pattern, body, &all, NULL, NULL, &cloth, &drape);
        if (drape != NULL && cloth != NULL)
            status = write_all(context, pattern, cloth, drape);
        else if (status != MUS_ERR_MEMORY && status != MUS_ERR_ARG)
            status = MUS_OK; /* it does not fit this person */
    } else {
        if (status == MUS_OK) status = mus_cloth_create(context, pattern, &cut, &cloth);
        if (status == MUS_OK) status = mus_drape_create(context, cloth, body, &def, &drape);
        if (status == MUS_OK) status = mus_drape_place(drape);
        if (status == MUS_OK) status = mus_drape_step(drape, STEPS, 0.9 * mus_drape_step_bound(drape));
    }
    if (status != MUS_OK) fprintf(stderr, "day: %s %s: %s\n", design, size, mus_context_error(context));
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    return status;
}


int main(int argc, char **argv)
{
    const int cycles = argc > 1 ? atoi(argv[1]) : CYCLES;
    mus_context *context;
    uint64_t state = 25;
    double first = 0.0, now = 0.0;
    int failed = 0, left = 0;
    if (cycles < 10 || mus_context_create(NULL, &context) != MUS_OK) return 2;
    printf("%8s %8s %12s %14s\n", "cycles", "CPU s", "memory MiB", "allocations");
    for (int i = 1; i <= cycles; i++) {
        failed += cycle(context, &state, i % AT_REST == 0) != MUS_OK;
        left += mus_context_bytes(context) != 0;
        if (i % (cycles / 10) != 0) continue;
        now = memory();
        if (first <= 0.0) first = now;
        printf("%8d %8.1f %12.1f %14lld\n", i, (double)clock() / CLOCKS_PER_SEC, now,
               (long long)mus_context_allocations(context));
        fflush(stdout);
    }
    mus_context_destroy(context);
    const bool grown = cycles >= 10000 && now > GROWN * first; /* the heap fills for some 300 cycles */
    printf("%d cycles, %d failed, %d left memory in the context; after a tenth %.1f MiB, at the end %.1f MiB%s\n",
           cycles, failed, left, first, now, grown ? ": it grew" : "");
    return failed > 0 || left > 0 || grown;
}
