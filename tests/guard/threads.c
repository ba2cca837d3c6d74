/*
 * threads.c: the program of `make check-threads`: what several threads do at once, under the thread sanitizer.
 *
 * Two threads dress a body in a skirt, with self-contact, each in a context of its own and with a pool of threads of
 * its own. The states must be the same to the bit, and the sanitizer must see no race.
 */
#include <pthread.h>
#include <stdio.h>

#include "muslin/muslin.h"

typedef struct job {
    int32_t threads;
    mus_status status;
    uint64_t hash;
    char error[256];
} job;


static void *dress_one(void *user)
{
    job *j = user;
    mus_context *context = NULL;
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_pattern *pattern = NULL;
    mus_drape *drape = NULL;
    mus_dress_def def;
    mus_dress_def_init(&def, sizeof def);
    def.spacing = 0.08;
    def.self_contact = 1;
    def.threads = j->threads;
    j->status = mus_context_create(NULL, &context);
    if (j->status == MUS_OK) j->status = mus_tape_create(context, &tape);
    if (j->status == MUS_OK) j->status = mus_tape_set_size(tape, "W40");
    if (j->status == MUS_OK) j->status = mus_body_create(context, tape, NULL, &body);
    if (j->status == MUS_OK) j->status = mus_design_draft(context, mus_design_find("skirt"), tape, NULL, &pattern);
    if (j->status == MUS_OK) j->status = mus_dress(context, pattern, body, &def, NULL, NULL, NULL, &drape);
    snprintf(j->error, sizeof j->error, "%s", mus_context_error(context));
    j->hash = mus_drape_hash(drape);
    mus_drape_destroy(drape);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    mus_context_destroy(context);
    return NULL;
}


int main(void)
{
    job jobs[2] = {{.threads = 2}, {.threads = 3}};
    pthread_t thread[2];
    for (int i = 0; i < 2; i++)
        if (pthread_create(&thread[i], NULL, dress_one, &jobs[i]) != 0) return 1;
    for (int i = 0; i < 2; i++) pthread_join(thread[i], NULL);
    for (int i = 0; i < 2; i++)
        printf("%d threads: %s, state %016llx %s\n", (int)jobs[i].threads, mus_status_name(jobs[i].status),
               (unsigned long long)jobs[i].hash, jobs[i].status == MUS_OK ? "" : jobs[i].error);
    return jobs[0].status == MUS_OK && jobs[1].status == MUS_OK && jobs[0].hash == jobs[1].hash ? 0 : 1;
}
