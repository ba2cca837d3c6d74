/*
 * run_progress.c: what a run tells while it goes on and when it ends: progress, a stop, the reason of a failure.
 *
 * The same T-shirt is dressed three times: to the end; stopped by the caller while it settles; and with a seam turned
 * round, so that it cannot be sewn into a garment.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/muslin.h"

static mus_context *context;

/* what the progress function remembers */
typedef struct listener {
    char phases[64];     /* the phases told, in order */
    const char *stop_in; /* the phase to stop in, NULL: none */
} listener;


/* end with one sentence when a call failed */
static void must(mus_status status)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "run_progress: %s: %s\n", mus_status_name(status), mus_context_error(context));
    exit(1);
}


/* called a few times a second; a nonzero return stops the run */
static int32_t listen(void *user, const mus_progress *progress)
{
    listener *l = user;
    const char *phase = progress->phase;
    if (strstr(l->phases, phase) == NULL) {
        strcat(l->phases, l->phases[0] == 0 ? "" : " ");
        strcat(l->phases, phase);
    }
    return l->stop_in != NULL && strcmp(l->stop_in, phase) == 0;
}


static void run(const char *what, const mus_pattern *pattern, const mus_body *body, const char *stop_in)
{
    listener l = {.stop_in = stop_in};
    mus_dress_def def;
    mus_reason reason;
    mus_drape *drape;

    mus_dress_def_init(&def, sizeof def);
    def.spacing = 0.02;
    def.progress = listen;
    def.progress_user = &l;
    mus_reason_init(&reason, sizeof reason);
    const mus_status status = mus_dress(context, pattern, body, &def, NULL, &reason, NULL, &drape);
    printf("%s: %s, phases told: %s\n", what, mus_status_name(status), l.phases[0] ? l.phases : "none");
    printf("    reason: %s%s%s\n", mus_reason_name(reason.kind), reason.text[0] ? ": " : "", reason.text);
    mus_drape_destroy(drape);
}


int main(void)
{
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern;
    mus_seam_def seam;

    must(mus_context_create(NULL, &context));
    must(mus_tape_create(context, &tape));
    must(mus_tape_set_size(tape, "W40"));
    must(mus_body_create(context, tape, NULL, &body));
    must(mus_design_draft(context, mus_design_find("tshirt"), tape, NULL, &pattern));

    run("to the end", pattern, body, NULL);
    run("stopped", pattern, body, "settle");

    /* the first seam with its second edge turned round: start meets start */
    mus_seam_def_init(&seam, sizeof seam);
    must(mus_pattern_seam(pattern, 0, &seam));
    seam.direction = MUS_SEAM_DIRECT;
    must(mus_pattern_remove_seam(pattern, 0));
    must(mus_pattern_add_seam(pattern, &seam, NULL));
    run("twisted", pattern, body, NULL);

    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    mus_context_destroy(context);
    return 0;
}
