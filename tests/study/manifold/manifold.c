/*
 * manifold.c: the bodies of all table sizes, of people of ANSUR II and in poses, as closed surfaces: `make manifold`.
 *
 * manifold TABLE FOLDER [--sizes N] [--each N] [--poses N] [--spacing MM] [--limit SECONDS] [--rows 0]. The file is
 * written to FOLDER and judged by programs that read the file alone (closed.h, and the ruler of `make outside`). A row
 * for each body: triangles, pieces, V - E + F, open edges, pinched vertices, crossings, least height and angle of a
 * triangle, vertices on a cut, volume against the body's own, the worst girth, CPU time. The volume is compared on a
 * body without fingers and toes, as mus_body_volume() counts it.
 *
 * --sizes N, --each N, --poses N: every Nth table size, person of the survey, and pose of a woman and a man; 0: none.
 * All people: --each 1; they are taken in an order that is spread over the table, and after --limit of CPU time the
 * study ends with those that it has. --rows 0: only the rows with a fault, then the table of all. Exit 1 when one is
 * not closed, is not a sphere or crosses itself, or a girth is off by more than 1 mm.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../people/ansur.h"
#include "muslin/pose.h"
#include "written.h"

typedef struct study {
    mus_context *context;
    mus_manifold_def def;
    char path[4096];
    bool rows; /* write those without a fault too */
    int bodies, faults, none, closed, pinched, flat, pieces, euler, crossed, girths; /* none: no body or no manifold */
    double girth, volume, angle, spent;
    char worst[64]; /* body and measure of the worst girth */
    long cuts;
} study;


static void row(study *of, const char *who, const mus_body *body, const mus_body *plain, bool rest)
{
    written w;
    mus_manifold *smooth = NULL;
    if (!written_manifold(of->context, body, &of->def, of->path, rest, &w)) {
        printf("%-24s %s\n", who, mus_context_error(of->context));
        of->faults++, of->none++;
        return;
    }
    double volume = NAN;
    if (plain != NULL && mus_manifold_create(plain, &of->def, &smooth) == MUS_OK) {
        volume = mus_manifold_volume(smooth) / mus_body_volume(plain) - 1.0;
        mus_manifold_destroy(smooth);
        of->volume = fabs(volume) > fabs(of->volume) ? volume : of->volume;
    }
    const closed_report *f = &w.file;
    if (rest && plain == NULL) volume = f->volume / mus_body_volume(body) - 1.0;
    const bool good = f->open == 0 && f->pinched == 0 && f->flat == 0 && f->crossings == 0 && f->pieces == 1 &&
                      f->euler == 2 && f->volume > 0.0 && !(fabs(w.girth) > 1e-3);
    if (of->rows || !good)
        printf("%-24s %7d %6d %6d %5d %6d %6d %9.4f %7.2f %5d %8.3f %7.2f %-10s %6.2f%s\n", who, w.triangles, f->pieces,
               f->euler, f->open, f->pinched, f->crossings, 1000.0 * f->height, f->angle, w.cuts, 100.0 * volume,
               1000.0 * w.girth, w.measure, w.spent, good ? "" : "  FAULT");
    fflush(stdout);
    of->bodies++, of->faults += !good, of->cuts += w.cuts;
    of->closed += f->open == 0, of->pinched += f->pinched > 0, of->flat += f->flat > 0;
    of->pieces += f->pieces == 1, of->euler += f->euler == 2, of->crossed += f->crossings > 0;
    of->girths += fabs(w.girth) > 1e-3;
    if (fabs(w.girth) > fabs(of->girth)) {
        of->girth = w.girth;
        snprintf(of->worst, sizeof of->worst, "%s %s", who, w.measure);
    }
    of->angle = fmin(of->angle, f->angle);
    of->spent += w.spent;
}


/* a body of a tape in the rest pose, and with its volume compared */
static void tape_row(study *of, const char *who, const mus_tape *tape, bool volume)
{
    mus_body *body = NULL, *plain = NULL;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    if (mus_body_create(of->context, tape, &def, &body) != MUS_OK) {
        printf("%-24s no body: %s\n", who, mus_context_error(of->context));
        of->none++;
        return;
    }
    def.plain = 1;
    if (volume) mus_body_create(of->context, tape, &def, &plain);
    row(of, who, body, plain, true);
    mus_body_destroy(plain);
    mus_body_destroy(body);
}


static void poses(study *of, int each)
{
    static const char *const sizes[] = {"W40", "M50"};
    for (int k = 0; k < 2 && each > 0; k++) {
        mus_tape *tape = NULL;
        mus_body *body = NULL;
        if (mus_tape_create(of->context, &tape) != MUS_OK || mus_tape_set_size(tape, sizes[k]) != MUS_OK ||
            mus_body_create(of->context, tape, NULL, &body) != MUS_OK)
            of->faults++;
        for (int32_t i = 0; i < mus_pose_count() && body != NULL; i += each) {
            mus_pose pose;
            mus_body *posed = NULL;
            char who[64];
            snprintf(who, sizeof who, "%s %s", sizes[k], mus_pose_name(i));
            if (mus_pose_named(of->context, mus_pose_name(i), &pose) != MUS_OK ||
                mus_body_pose(body, &pose, &posed) != MUS_OK)
                of->faults++;
            else
                row(of, who, posed, NULL, false);
            mus_body_destroy(posed);
        }
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
}


/* every `each`th person, until the CPU time is at `limit` [s]: in steps of the golden section of their number, so that
 * those that are left out lie all over the table */
static void people(study *of, const ansur *table, int each, double limit)
{
    const int count = each > 0 ? (table->rows + each - 1) / each : 0;
    int step = (int)(0.618 * count) | 1, done = 0;
    for (int d = 2; d <= step; d++)
        while (step > d && step % d == 0 && count % d == 0) step += 2, d = 2;
    for (int i = 0; done < count && (double)clock() / CLOCKS_PER_SEC < limit; i = (i + step) % count, done++) {
        mus_tape *tape = ansur_tape(of->context, table, i * each);
        if (tape != NULL) tape_row(of, ansur_name(table, i * each), tape, false);
        mus_tape_destroy(tape);
    }
    if (done < count) printf("%d of %d people: the limit of %.0f s of CPU\n", done, count, limit);
}


/* the table of all bodies */
static void summary(const study *of)
{
    printf("\n%d bodies, %d without a body or a manifold, %d faults\n", of->bodies, of->none, of->faults);
    printf("one piece                        %6d\n", of->pieces);
    printf("Euler characteristic 2           %6d\n", of->euler);
    printf("no open edge                     %6d\n", of->closed);
    printf("with a pinched vertex            %6d\n", of->pinched);
    printf("with a triangle of no area       %6d\n", of->flat);
    printf("with a crossing (exact)          %6d\n", of->crossed);
    printf("with a girth more than 1 mm off  %6d\n", of->girths);
    printf("worst girth %.2f mm (%s), volume of plain bodies %.3f %%, least angle %.2f degrees, %ld vertices on cuts\n",
           1000.0 * of->girth, of->worst, 100.0 * of->volume, of->angle, of->cuts);
    printf("CPU a body: manifold %.2f s; with its file, the check and girths %.2f s\n", of->spent / of->bodies,
           (double)clock() / CLOCKS_PER_SEC / of->bodies);
}


int main(int argc, char **argv)
{
    ansur table;
    study of = {.angle = INFINITY, .rows = true};
    int each = 100, pose = 1, sizes = 1;
    double limit = INFINITY;
    mus_manifold_def_init(&of.def, sizeof of.def);
    if (argc < 3 || !ansur_open(&table, argv[1]) || mus_context_create(NULL, &of.context) != MUS_OK) {
        fprintf(stderr, "manifold: expected a table of people and a folder\n");
        return 2;
    }
    for (int i = 3; i + 1 < argc; i += 2) {
        if (strcmp(argv[i], "--each") == 0) each = atoi(argv[i + 1]);
        if (strcmp(argv[i], "--poses") == 0) pose = atoi(argv[i + 1]);
        if (strcmp(argv[i], "--sizes") == 0) sizes = atoi(argv[i + 1]);
        if (strcmp(argv[i], "--limit") == 0) limit = atof(argv[i + 1]);
        if (strcmp(argv[i], "--rows") == 0) of.rows = atoi(argv[i + 1]) != 0;
        if (strcmp(argv[i], "--spacing") == 0) of.def.spacing = 1e-3 * atof(argv[i + 1]);
    }
    snprintf(of.path, sizeof of.path, "%s/manifold.obj", argv[2]);
    printf("%-24s %7s %6s %6s %5s %6s %6s %9s %7s %5s %8s %7s %-10s %6s\n", "body", "faces", "pieces", "V-E+F", "open",
           "pinch", "cross", "height mm", "angle", "cuts", "volume %", "mm", "girth", "CPU s");
    for (int32_t i = 0; i < mus_tape_size_count() && sizes > 0; i += sizes) {
        mus_tape *tape = NULL;
        if (mus_tape_create(of.context, &tape) == MUS_OK &&
            mus_tape_set_size(tape, mus_tape_size_name(i)) == MUS_OK)
            tape_row(&of, mus_tape_size_name(i), tape, true);
        mus_tape_destroy(tape);
    }
    people(&of, &table, each, limit);
    poses(&of, pose);
    remove(of.path);
    summary(&of);
    mus_context_destroy(of.context);
    ansur_close(&table);
    return of.faults == 0 ? 0 : 1;
}
