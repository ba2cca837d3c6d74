/*
 * self_off.c: three garments sewn and stepped without cloth on cloth: the hash of their states, and CPU time of steps.
 *
 * Linked twice by self_off.sh, to the library and to one whose steps know nothing of cloth on cloth. Prints a line:
 * the hashes, then CPU seconds of the steps of the last garment, the best of twenty parts.
 */
#include <stdio.h>
#include <time.h>

#include "muslin/muslin.h"

#define SPACING 0.03
#define STEPS 3000
#define PARTS 20


static int dress(mus_context *context, const char *name, uint64_t *hash, double *best)
{
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_pattern *pattern = NULL;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def cut;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = SPACING;
    mus_status status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    if (status == MUS_OK) status = mus_body_create(context, tape, NULL, &body);
    if (status == MUS_OK) status = mus_design_draft(context, mus_design_find(name), tape, NULL, &pattern);
    if (status == MUS_OK) status = mus_cloth_create(context, pattern, &cut, &cloth);
    if (status == MUS_OK) status = mus_drape_create(context, cloth, body, NULL, &drape);
    if (status == MUS_OK) status = mus_drape_place(drape);
    if (status == MUS_OK) status = mus_drape_sew(drape, NULL, NULL);
    const double h = 0.8 * mus_drape_step_bound(drape);
    *best = 1e9;
    for (int k = 0; k < PARTS && status == MUS_OK; k++) {
        const clock_t start = clock();
        status = mus_drape_step(drape, STEPS / PARTS, h);
        const double took = (double)(clock() - start) / CLOCKS_PER_SEC;
        if (took < *best) *best = took;
    }
    *hash = mus_drape_hash(drape);
    if (status != MUS_OK) fprintf(stderr, "self_off: %s: %s\n", name, mus_context_error(context));
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    return status == MUS_OK;
}


int main(void)
{
    static const char *const names[] = {"skirt_plain", "chinos", "tshirt"};
    mus_context *context;
    uint64_t hash;
    double best;
    if (mus_context_create(NULL, &context) != MUS_OK) return 1;
    int good = 1;
    for (int i = 0; i < 3 && good; i++) {
        good = dress(context, names[i], &hash, &best);
        if (good) printf("%016llx ", (unsigned long long)hash);
    }
    if (good) printf("%.6f\n", best);
    mus_context_destroy(context);
    return good ? 0 : 1;
}
