/*
 * threads.c: a batch of garments on several threads, one context a thread.
 *
 * A context, and everything made from it, belongs to one thread at a time; two contexts know nothing of each other.
 * The threads take the next garment from a shared counter. The state that a garment comes to rest in does not depend
 * on the thread that dressed it, nor on the number of threads.
 */
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "muslin/muslin.h"

#define THREADS 3

typedef struct job {
    const char *design, *size;
    mus_status status;
    char error[256];
    int nodes;
    double seam_gap; /* [m] */
} job;

static job jobs[] = {{.design = "skirt", .size = "W36"},  {.design = "tshirt", .size = "W40"},
                     {.design = "tshirt", .size = "M50"}, {.design = "skirt", .size = "W44"},
                     {.design = "tank", .size = "C128"},  {.design = "no such design", .size = "W40"}};
#define JOBS ((int)(sizeof jobs / sizeof *jobs))

static int next_job;
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;


/* one garment: stops at the first call that fails, and frees what was made */
static mus_status dress(mus_context *context, job *j)
{
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_pattern *pattern = NULL;
    mus_drape *drape = NULL;
    mus_dress_def def;
    mus_drape_report report;
    mus_status status;

    mus_dress_def_init(&def, sizeof def);
    def.spacing = 0.03;
    mus_drape_report_init(&report, sizeof report);
    status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, j->size);
    if (status == MUS_OK) status = mus_body_create(context, tape, NULL, &body);
    if (status == MUS_OK) status = mus_design_draft(context, mus_design_find(j->design), tape, NULL, &pattern);
    if (status == MUS_OK) status = mus_dress(context, pattern, body, &def, NULL, NULL, NULL, &drape);
    if (status == MUS_OK) status = mus_drape_report_get(drape, &report);
    j->nodes = (int)report.nodes;
    j->seam_gap = report.max_seam_gap;
    mus_drape_destroy(drape);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    return status;
}


static void *work(void *unused)
{
    mus_context *context;
    if (mus_context_create(NULL, &context) != MUS_OK) return NULL;
    for (;;) {
        pthread_mutex_lock(&lock);
        job *j = next_job < JOBS ? &jobs[next_job++] : NULL;
        pthread_mutex_unlock(&lock);
        if (j == NULL) break;
        j->status = dress(context, j);
        if (j->status != MUS_OK) strncpy(j->error, mus_context_error(context), sizeof j->error - 1);
    }
    mus_context_destroy(context);
    return unused;
}


int main(void)
{
    pthread_t thread[THREADS];
    int started = 0;
    while (started < THREADS && pthread_create(&thread[started], NULL, work, NULL) == 0) started++;
    if (started == 0) work(NULL);
    for (int i = 0; i < started; i++) pthread_join(thread[i], NULL);
    for (int i = 0; i < JOBS; i++) {
        if (jobs[i].status == MUS_OK)
            printf("%s %s: at rest, %d nodes, widest seam %.2f mm\n", jobs[i].design, jobs[i].size, jobs[i].nodes,
                   1e3 * jobs[i].seam_gap);
        else printf("%s %s: %s\n", jobs[i].design, jobs[i].size, mus_status_name(jobs[i].status));
    }
    return 0;
}
