/*
 * designs.c: every named design drafted for every table size of its groups and for people of ANSUR II: `make designs`.
 *
 *     build/bin/designs TABLE [--each N] [--design NAME] [--family FAMILY] [--sizes] [--list]
 *
 * Each 15th person, or each N-th; --sizes: table sizes alone; --list: a line for each refusal, and for each design that
 * has any. Printed: drafts, refusals by reason with one of them in full, how far seams and legs of darts are off,
 * seams whose notches do not meet, outlines that meet themselves, CPU time of a draft. Exit 1 when a figure is
 * beyond its limit: under 1 % refused, seams within 0.5 mm of their ease, legs of darts equal to 0.1 mm, notches
 * that meet, simple outlines, median under 5 ms.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/people/ansur.h"
#include "try.h"

#define REASONS 200
#define REASON_BYTES 160

typedef struct options {
    const char *design, *family;
    int each;
    bool sizes, list;
} options;

typedef struct page {
    int drafts[2], refused[2]; /* of table sizes, of people */
    int reasons, count[REASONS];
    char reason[REASONS][REASON_BYTES], example[REASONS][TRY_TEXT];
    double seam, dart;
    int crossings, notches, unsound; /* designs of which a draft fails or does not hold */
    char seam_of[96], dart_of[96], notch_of[96], crossing_of[96], slowest_of[96];
    double *seconds; /* (drafts that went) */
    int timed, room;
} page;


static int by_size(const void *left, const void *right)
{
    const double x = *(const double *)left, y = *(const double *)right;
    return x < y ? -1 : x > y;
}


/* ---- the page ---- */

static void note_refusal(page *p, const char *who, const char *text)
{
    char key[REASON_BYTES];
    int r = 0;
    try_reason(text, key, sizeof key);
    while (r < p->reasons && strcmp(p->reason[r], key) != 0) r++;
    if (r == REASONS) return;
    if (r == p->reasons) {
        p->reasons++;
        snprintf(p->reason[r], sizeof p->reason[r], "%s", key);
        snprintf(p->example[r], sizeof p->example[r], "%s: %.300s", who, text);
    }
    p->count[r]++;
}


/* the larger stays, with its name */
static void note_most(double value, const char *who, double *most, char *name, size_t size)
{
    if (!(value > *most)) return;
    *most = value;
    snprintf(name, size, "%s", who);
}


static bool note(page *p, const options *o, const char *name, const char *whom, bool person, const design_try *one)
{
    char who[96];
    snprintf(who, sizeof who, "%s of %s", name, whom);
    p->drafts[person]++;
    if (one->status != MUS_OK) {
        p->refused[person]++;
        note_refusal(p, who, one->text);
        if (o->list) printf("  %s: %s\n", who, one->text);
        return false;
    }
    if (p->timed == p->room) {
        p->room = p->room == 0 ? 4096 : 2 * p->room;
        double *more = realloc(p->seconds, sizeof *more * (size_t)p->room);
        if (more == NULL) exit(1);
        p->seconds = more;
    }
    p->seconds[p->timed++] = one->seconds;
    note_most(one->seam, who, &p->seam, p->seam_of, sizeof p->seam_of);
    note_most(one->dart, who, &p->dart, p->dart_of, sizeof p->dart_of);
    if (one->crossings > 0 && p->crossings == 0) snprintf(p->crossing_of, sizeof p->crossing_of, "%s", who);
    p->crossings += one->crossings > 0;
    if (one->notches > 0 && p->notches == 0) snprintf(p->notch_of, sizeof p->notch_of, "%s", who);
    p->notches += one->notches > 0;
    if (o->list && one->notches > 0) printf("  %s: %d seams whose notches do not meet\n", who, one->notches);
    if (o->list && one->crossings > 0) printf("  %s: panel %s meets itself\n", who, one->crossing);
    return one->seam <= 5e-4 && one->dart <= 1e-4 && one->crossings == 0 && one->notches == 0;
}


static bool print_page(page *p)
{
    const int drafts = p->drafts[0] + p->drafts[1], refused = p->refused[0] + p->refused[1];
    if (p->timed == 0) return false;
    qsort(p->seconds, (size_t)p->timed, sizeof *p->seconds, by_size);
    const double median = p->seconds[p->timed / 2];
    printf("table sizes %8d drafts, %6d refused, %6.3f %%\n", p->drafts[0], p->refused[0],
           100.0 * p->refused[0] / fmax(1, p->drafts[0]));
    printf("people      %8d drafts, %6d refused, %6.3f %%\n", p->drafts[1], p->refused[1],
           100.0 * p->refused[1] / fmax(1, p->drafts[1]));
    for (int r = 0; r < p->reasons; r++) printf("  %6d  %s\n          %s\n", p->count[r], p->reason[r], p->example[r]);
    printf("seams       off by %.4f mm at most (%s)\n", 1e3 * p->seam, p->seam_of);
    printf("darts       legs off by %.4f mm at most (%s)\n", 1e3 * p->dart, p->dart_of);
    printf("notches     %d drafts with a seam where they do not meet (%s)\n", p->notches, p->notch_of);
    printf("outlines    %d drafts with one that meets itself (%s)\n", p->crossings, p->crossing_of);
    printf("a draft     median %.2f ms, 99 in 100 below %.2f ms, slowest %.2f ms\n", 1e3 * median,
           1e3 * p->seconds[p->timed * 99 / 100], 1e3 * p->seconds[p->timed - 1]);
    return 100 * refused < drafts && p->refused[0] == 0 && p->seam <= 5e-4 && p->dart <= 1e-4 && p->crossings == 0 &&
           p->notches == 0 && median < 5e-3;
}


/* ---- the run ---- */

/* completed tapes of every table size, then of the people */
static int make_tapes(mus_context *context, const ansur *table, const options *o, mus_tape **tapes, int room)
{
    int n = 0;
    for (int i = 0; i < mus_tape_size_count() && n < room; i++) {
        if (mus_tape_create(context, &tapes[n]) != MUS_OK ||
            mus_tape_set_size(tapes[n], mus_tape_size_name(i)) != MUS_OK || mus_tape_complete(tapes[n]) != MUS_OK)
            exit(1);
        n++;
    }
    for (int row = 0; table != NULL && !o->sizes && row < table->rows && n < room; row += o->each) {
        mus_tape *tape = ansur_tape(context, table, row);
        if (tape == NULL || mus_tape_complete(tape) != MUS_OK) {
            printf("no tape of %s: %s\n", ansur_name(table, row), mus_context_error(context));
            mus_tape_destroy(tape);
            continue;
        }
        mus_tape_set_name(tape, ansur_name(table, row));
        tapes[n++] = tape;
    }
    return n;
}


static bool run(mus_context *context, const ansur *table, const options *o)
{
    static mus_tape *tapes[4096];
    static page p;
    int unsound = 0, designs = 0;
    const int n = make_tapes(context, table, o, tapes, 4096);
    for (int d = 0; d < mus_design_count(); d++) {
        if (o->design != NULL && strcmp(o->design, mus_design_name(d)) != 0) continue;
        if (o->family != NULL && strcmp(o->family, mus_design_family(d)) != 0) continue;
        int bad = 0, all = 0;
        for (int i = 0; i < n; i++) {
            const bool person = i >= mus_tape_size_count();
            const char *whom = person ? mus_tape_name(tapes[i]) : mus_tape_size_name(i);
            design_try one;
            if ((try_group(tapes[i]) & mus_design_groups(d)) == 0) continue;
            try_draft(context, d, tapes[i], &one, NULL);
            bad += !note(&p, o, mus_design_name(d), whom, person, &one);
            all++;
        }
        designs++;
        unsound += bad > 0;
        if (o->list && bad > 0) printf("%s: %d of %d do not hold\n", mus_design_name(d), bad, all);
    }
    printf("designs     %8d, of %d each draft holds; %d tapes\n", designs, designs - unsound, n);
    const bool good = print_page(&p);
    free(p.seconds);
    for (int i = 0; i < n; i++) mus_tape_destroy(tapes[i]);
    return good;
}


int main(int argc, char **argv)
{
    ansur table;
    mus_context *context = NULL;
    options o = {.each = 15};
    for (int i = 2; i < argc; i++) {
        const bool value = i + 1 < argc;
        if (strcmp(argv[i], "--sizes") == 0) o.sizes = true;
        else if (strcmp(argv[i], "--list") == 0) o.list = true;
        else if (strcmp(argv[i], "--each") == 0 && value) o.each = atoi(argv[++i]);
        else if (strcmp(argv[i], "--design") == 0 && value) o.design = argv[++i];
        else if (strcmp(argv[i], "--family") == 0 && value) o.family = argv[++i];
        else return fprintf(stderr, "designs: %s: unknown\n", argv[i]), 2;
    }
    if (o.each < 1) o.each = 1;
    const bool people = argc > 1 && ansur_open(&table, argv[1]);
    if (!people) printf("skipped: people: no table %s\n", argc > 1 ? argv[1] : "(none given)");
    const bool good = mus_context_create(NULL, &context) == MUS_OK && run(context, people ? &table : NULL, &o);
    printf("%s\n", good ? "all figures hold" : "a figure does not hold");
    mus_context_destroy(context);
    if (people) ansur_close(&table);
    return good ? 0 : 1;
}
